"""A scene with several rods: three rings of different stock that only cables hold apart."""

import tencer

rings = tencer.curves_of_family("borromean-ellipses", vertices=30, long_axis=26, short_axis=20)
stocks = [{"radius": 0.15}, {"radius": 0.15}, {"shape": "tube", "outer_radius": 0.2, "inner_radius": 0.1}]
rods = [
    {"curve": ring, "section": stock, "material": material}
    for ring, stock, material in zip(rings, stocks, ["glass fibre", "carbon", "carbon"])
]
design = tencer.design(rod=rods, max_error=5, build={"length_error": 0.05}, time=1)  # cm, s
print(design.report())
for rod, marks in zip("ABC", design.marks):
    print(f"rod {rod}: mark at", ", ".join(f"{s:.1f} (cable {cable + 1})" for s, cable in marks))
design.plot().figure.savefig("rings.png")

"""A knot in ten lines: which cables hold a trefoil of spring steel, and how long they are cut."""

import tencer

(knot,) = tencer.curves_of_family("trefoil-2-3", length=150, vertices=40)  # cm
design = tencer.design(knot, material="spring steel", max_error=3, effort=1)
print(design)
for number, cable in enumerate(design.cables, 1):
    print(f"cable {number}: {cable['length']:.1f} cm from {cable['s_a']:.1f} to {cable['s_b']:.1f} cm")
design.export("knot.json")
design.plot().figure.savefig("knot.png")

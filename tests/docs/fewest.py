"""fewest.py FOLDER PAGE TENCER WORK: that knots are told apart by examples/fewest, and that the designs
there are what its table says: so many cables, that knot, strands as far apart.
"""

import csv
import json
import pathlib
import subprocess
import sys

folder, page, tencer, work = sys.argv[1:]
sys.path.insert(0, folder)
sys.dont_write_bytecode = True
import fewest  # noqa: E402

# The Alexander polynomials at -1, 2 and 3, up to signs and powers of these.
KINDS = {"3_1": (3, 3, 7), "4_1": (5, 1, 1), "5_1": (5, 11, 61), "5_2": (7, 1, 11)}

work = pathlib.Path(work)
work.mkdir(parents=True, exist_ok=True)


def curve(*family):
    subprocess.run([tencer, "target", *family, "-o", work / "curve.obj"], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return fewest.read_curve(work / "curve.obj")


assert fewest.invariant(curve("circle")) == (1, 1, 1)
for name, kind in KINDS.items():
    # The values at t = 1 are no matter; those of a unit are 1.
    found = fewest.invariant(curve(f"knot-{name}", "--vertices", "80"))
    assert found == kind, (name, found)

text = pathlib.Path(page).read_text(encoding="utf-8")
with open(pathlib.Path(folder) / "fewest.csv", encoding="utf-8") as table:
    for row in csv.DictReader(table):
        design = json.loads((pathlib.Path(folder) / f"{row['knot']}.json").read_text())
        gap = fewest.roomy(design, KINDS[row["knot"]], 2.0)
        assert gap is not None, f"{row['knot']} does not count"
        assert f"{gap:.2f}" == row["gap_percent"], (row, gap)
        assert len(design["cables"]) == int(row["cables"]), row
        assert f"| {row['knot']} | {row['cables']} |" in text, f"the page lacks {row}"

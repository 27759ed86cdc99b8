"""How many cables does a knot need, its shape being free? Looks for few by trying.

    fewest.py TENCER -o FOLDER [--knots 3_1 4_1] [--tries 8] [--clearance 2] [--seed 1]

A try stretches and shears a shape of the knot at random and runs `tencer design --trade-off` on it, which
ends with as few cables as it can, however far from that shape. A design counts when it stands and settles,
keeps strands `clearance` percent of the rod's length apart, and is still that knot (its Alexander
polynomial is, at three places). The first shape is the roomy one of `tencer target`; later ones are poses of
the best design so far: the fewest cables, then the widest gap. That is kept as FOLDER/KNOT.json, and
FOLDER/fewest.csv has a row a knot. It is a search: fewer may do.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

PRIME = (1 << 61) - 1
PLACES = (-1, 2, 3)


def subtract(a, b):
    return [p - q for p, q in zip(a, b)]


def crossings(points):
    """[(position of the strand under, of the one over, sign)] of a closed polygon seen along z."""
    n = len(points)
    found = []
    for i in range(n):
        p, u = points[i], subtract(points[(i + 1) % n], points[i])
        for j in range(i + 2, n):
            if i == 0 and j == n - 1:
                continue
            q, v = points[j], subtract(points[(j + 1) % n], points[j])
            turn = u[0] * v[1] - u[1] * v[0]
            if turn == 0:
                continue
            w = subtract(q, p)
            s = (w[0] * v[1] - w[1] * v[0]) / turn
            t = (w[0] * u[1] - w[1] * u[0]) / turn
            if not (0 <= s < 1 and 0 <= t < 1):
                continue
            if p[2] + s * u[2] < q[2] + t * v[2]:
                found.append((i + s, j + t, -1 if turn > 0 else 1))
            else:
                found.append((j + t, i + s, 1 if turn > 0 else -1))
    return sorted(found)


def determinant(rows):
    """Modulo PRIME."""
    rows = [row[:] for row in rows]
    result = 1
    for c in range(len(rows)):
        pivot = next((r for r in range(c, len(rows)) if rows[r][c]), None)
        if pivot is None:
            return 0
        if pivot != c:
            rows[c], rows[pivot] = rows[pivot], rows[c]
            result = -result
        result = result * rows[c][c] % PRIME
        inverse = pow(rows[c][c], PRIME - 2, PRIME)
        for r in range(c + 1, len(rows)):
            factor = rows[r][c] * inverse % PRIME
            if factor:
                rows[r] = [(a - factor * b) % PRIME for a, b in zip(rows[r], rows[c])]
    return result % PRIME


def invariant(points):
    """Values of the Alexander polynomial at PLACES, each up to a sign and powers of the place."""
    found = crossings(points)
    n = len(found)
    if n < 3:
        return (1,) * len(PLACES)
    starts = [under for under, _, _ in found]

    def arc(position):  # arcs go from one crossing below to the next
        return sum(start < position for start in starts) % n

    values = []
    for t in PLACES:
        rows = []
        for k, (_, over, sign) in enumerate(found):
            row = [0] * n
            before, after = k, (k + 1) % n
            if sign < 0:
                before, after = after, before
            row[arc(over)] += 1 - t
            row[before] += t
            row[after] -= 1
            rows.append([entry % PRIME for entry in row])
        value = determinant([row[:-1] for row in rows[:-1]])
        alike = [sign * value * pow(t, power, PRIME) % PRIME
                 for power in range(-n, n + 1) for sign in (1, -1)]
        values.append(min(alike))
    return tuple(values)


def smallest_gap(points, apart):
    """The least distance of vertices that are at least `apart` vertices from each other."""
    n = len(points)
    return min(math.dist(points[i], points[j]) for i in range(n) for j in range(i + apart, n)
               if j - i <= n - apart)


def run(command):
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          check=False).returncode


def write_curve(path, points):
    lines = [f"v {x:.17g} {y:.17g} {z:.17g}" for x, y, z in points]
    order = " ".join(str(i + 1) for i in range(len(points)))
    path.write_text("\n".join(lines) + f"\nl {order} 1\n", encoding="utf-8")


def read_curve(path):
    rows = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    return [[float(entry) for entry in row[1:4]] for row in rows if row and row[0] == "v"]


def deformed(points, size, draw):
    """The shape after a random linear map near the identity."""
    matrix = [[float(i == j) + draw.gauss(0, size) for j in range(3)] for i in range(3)]
    return [[sum(m * x for m, x in zip(row, point)) for row in matrix] for point in points]


def designs(folder):
    """The designs of a trade-off, the fewest cables first."""
    found = [json.loads(path.read_text()) for path in folder.glob("cables-*/design.json")]
    return sorted(found, key=lambda design: len(design["cables"]))


def roomy(design, kind, clearance):
    """The gap of a design that counts, in percent of its length; None: it does not."""
    certificate = design.get("certificate", {})
    if not (certificate.get("stable") and certificate.get("settles_from_target")):
        return None
    rod = design["rods"][0]
    apart = max(3, len(rod["pose"]) // 8)
    gap = 100 * smallest_gap(rod["pose"], apart) / sum(rod["rest_lengths"])
    return gap if gap >= clearance and invariant(rod["pose"]) == kind else None


def fewest(name, options, draw, work):
    """(cables, gap in percent of the length, design) of the best, or None; how many of the tries."""
    start = work / "start.obj"
    run([options.tencer, "target", f"knot-{name}", "--vertices", str(options.vertices), "-o", start])
    shape = read_curve(start)
    kind = invariant(shape)
    best, helped = None, 0
    for number in range(options.tries):
        target, folder = work / f"{number}.obj", work / str(number)
        write_curve(target, deformed(shape, options.spread if number else 0, draw))
        run([options.tencer, "design", target, "-o", folder, "--trade-off", "--effort", "1", "--quiet",
             "--method", ("force-balance", "dense-springs")[number % 2]])
        for design in designs(folder):
            gap = roomy(design, kind, options.clearance)
            if gap is None:
                continue
            score = (len(design["cables"]), -gap)
            if best is None or score < (best[0], -best[1]):
                best, helped = (score[0], gap, design), helped + 1
                shape = design["rods"][0]["pose"]
            break
    return best, helped


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tencer")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--knots", nargs="+", default=["3_1", "4_1", "5_1", "5_2"])
    parser.add_argument("--tries", type=int, default=8)
    parser.add_argument("--clearance", type=float, default=2.0, help="percent of the rod's length")
    parser.add_argument("--spread", type=float, default=0.15, help="of the maps' entries")
    parser.add_argument("--vertices", type=int, default=80)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    with open(options.output / "fewest.csv", "w", encoding="utf-8") as table:
        print("knot,cables,gap_percent,tries,helped", file=table)
        for name in options.knots:
            with tempfile.TemporaryDirectory() as work:
                best, helped = fewest(name, options, random.Random(f"{options.seed} {name}"),
                                      pathlib.Path(work))
            if best is None:
                print(f"{name},,,{options.tries},0", file=table, flush=True)
                continue
            count, gap, design = best
            design["name"] = f"knot-{name}"
            (options.output / f"{name}.json").write_text(json.dumps(design), encoding="utf-8")
            print(f"{name},{count},{gap:.2f},{options.tries},{helped}", file=table, flush=True)


if __name__ == "__main__":
    sys.exit(main())

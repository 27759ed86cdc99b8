#!/usr/bin/env bash
# Makes the data of docs/figures.md anew and draws it; some minutes.
#   docs/figures/make.sh [BIN]        BIN: folder of the built programs [build/release/bin]
#   docs/figures/make.sh draw         only the drawing, from the data that is there
# With gnuplot (Debian: gnuplot-nox).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
if [[ ${1:-} != draw ]]; then
  bin=$(cd "${1:-build/release/bin}" && pwd)
  new=$(mktemp -d)
  trap 'rm -rf "$new"' EXIT
  echo "ring"
  "$bin/bench_figures" ring >"$new/ring.csv"
  echo "pruning"
  "$bin/bench_figures" pruning examples/paper/torus-knot-5-3.toml >"$new/pruning.csv"
  echo "weights"
  status=0
  "$bin/tencer" design docs/figures/weights.toml -o "$new/weights" --quiet || status=$?
  [[ $status == 0 || $status == 3 ]]  # 3: not complete; its trace is all that counts here
  {
    echo "weight,springs,max_percent"
    # The first descent; there is another when its network does not settle.
    sed '/^slide/q' "$new/weights/trace.csv" |
      sed -n 's/^sparsify,[^,]*,\([^,]*\),\([^,]*\),.*internal weight \([^,;"]*\).*/\3,\1,\2/p'
  } >"$new/weights.csv"
  echo "random closed rods"
  "$bin/bench_figures" knots >"$new/knots.csv"
  echo "how few"
  {
    echo "knot,cables,max_percent,at_least"
    for knot in 3_1 4_1; do
      scene=examples/knots/$knot.toml
      "$bin/tencer" design "$scene" --trade-off --effort 1 -o "$new/$knot" --quiet >"$new/said"
      tail -n +2 "$new/$knot/trade-off.csv" | while IFS=, read -r cables percent _; do
        at_least=$("$bin/tencer" feasible "$scene" --max-error "$percent" --json 2>"$new/said" |
          python3 -c 'import json, sys; print(json.load(sys.stdin)["at_least"]["cables"])')
        echo "$knot,$cables,$percent,$at_least"
      done
    done
  } >"$new/how-few.csv"
  mv "$new"/*.csv docs/figures/
fi
cd docs/figures
for figure in greedy weights ring pruning knots how-few; do
  gnuplot common.gp "$figure.gp"
done
# Those of docs/study.md: tencer study writes the scripts and their data.
for figure in study-torus-knot-5-3 study-resolutions closed-forms; do
  gnuplot "$figure.gp"
done

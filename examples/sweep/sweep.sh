#!/bin/sh
# sweep.sh FOLDER KNOTS [OPTION...]
#
# What a max error costs: random knots (closed rods at rest under 4 to 12 random springs), designed for
# in one study. Each knot is asked for within one of four max errors, in turn, by a quick search, so
# that a run is a knot. Options go to `tencer study`: without any it is made here and now; with
# --submit parallel or --submit slurm, by a script that it writes. cost.py tells what came out.
set -e
folder=${1:?name a folder} knots=${2:?say how many knots}
shift 2
mkdir -p "$folder/knots"
for seed in $(seq "$knots"); do
  name=knot-$(printf %04d "$seed")
  [ -e "$folder/knots/$name.obj" ] ||
    tencer target random-knot --cables $((4 + 2 * (seed % 5))) --vertices 60 --seed "$seed" \
      -o "$folder/knots/$name.obj"
  case $((seed % 4)) in 0) error=0.5 ;; 1) error=1 ;; 2) error=2 ;; *) error=4 ;; esac
  printf '[[rod]]\ncurve = "%s.obj"\n\n[design]\nmax_error = %s\neffort = 1\n' "$name" $error \
    >"$folder/knots/$name.toml"
done
exec tencer study "$folder"/knots/*.toml -o "$folder/study" --methods force-balance --threads 1 "$@"

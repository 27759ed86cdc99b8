#!/bin/sh
# sweep.sh FOLDER KNOTS [OPTION...]
#
# What a max error costs: random knots (closed rods at rest under 4 to 12 random springs), each
# designed for within four max errors, one study. Options go to `tencer study`: without any it is
# made here and now; with --submit parallel or --submit slurm, by a script that it writes.
set -e
folder=${1:?name a folder} knots=${2:?say how many knots}
shift 2
mkdir -p "$folder/knots"
for seed in $(seq "$knots"); do
  knot=$folder/knots/knot-$(printf %04d "$seed").obj
  [ -e "$knot" ] ||
    tencer target random-knot --cables $((4 + 2 * (seed % 5))) --vertices 60 --seed "$seed" -o "$knot"
done
exec tencer study "$folder"/knots/*.obj -o "$folder/study" --methods force-balance \
  --max-errors 0.5,1,2,4 --threads 1 "$@"

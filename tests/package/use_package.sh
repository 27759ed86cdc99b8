#!/bin/bash
# What a user does with an installed tencer; try_package.sh runs it in a fresh Debian. Says what
# fails, and ends there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
trap 'echo "failed: line $LINENO: $BASH_COMMAND" >&2' ERR
examples=/usr/share/doc/tencer/examples

step() { echo "--- $*"; }

step "the program"
tencer --version
tencer design $examples/trefoil.obj -o knot
grep -q '<svg' knot/picture.svg
tencer check knot/design.json >check.txt
tencer fabricate knot/design.json
printf '[[step]]\n1 = "by -2 %%"\n' >pull.toml
tencer actuate knot/design.json pull.toml -o moves
test -s moves/view.html
tencer study $examples/trefoil.obj -o study --methods force-balance --quiet
grep -q '<svg' study/trefoil.svg # drawn by gnuplot

step "Python"
python3 - <<'PYTHON'
import importlib.metadata
import matplotlib
import tencer

matplotlib.use("Agg")
(knot,) = tencer.curves_of_family("trefoil-2-3", length=150)
design = tencer.design(knot, max_error=2, effort=1)
print(design)
assert design.complete and len(design.tensions) == len(design.cables)
design.plot().figure.savefig("knot.png")
assert design.actuate({1: "by -2 %"}).finished
assert "<html" in design._repr_html_() or "<iframe" in design._repr_html_()
print("tencer", importlib.metadata.version("tencer"), "from", tencer.__file__)
PYTHON
test -s knot.png
test -e /usr/lib/python3/dist-packages/tencer/__pycache__

step "the library, by CMake"
cat >CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(tencer 0.1 REQUIRED COMPONENTS pipeline)
add_executable(consumer pipeline.cpp)
target_link_libraries(consumer PRIVATE tencer::pipeline)
CMAKE
cmake -S . -B build -G Ninja >cmake.log
cmake --build build >>cmake.log
build/consumer $examples/trefoil.obj >by-cmake.txt

step "the library, by pkg-config"
g++ -std=c++20 pipeline.cpp $(pkg-config --cflags --libs tencer) -o consumer
./consumer $examples/trefoil.obj >by-pkg-config.txt
# The cables of both.
diff <(grep " cm$" by-cmake.txt) <(grep " cm$" by-pkg-config.txt)
tail -n 1 by-cmake.txt

step "manual, completions, pages"
man -w tencer
MANWIDTH=80 man tencer | grep -q 'design'
bash -c '
  . /usr/share/bash-completion/bash_completion
  _completion_loader tencer || [[ $? == 124 ]]
  read -r _ _ function _ <<<"$(complete -p tencer | sed "s/.*-F \([^ ]*\).*/x x \1 x/")"
  COMP_WORDS=(tencer des) COMP_CWORD=1 COMP_LINE="tencer des" COMP_POINT=10
  "$function" tencer des tencer
  echo "bash completes \"tencer des\" with: ${COMPREPLY[*]}"
  [[ ${COMPREPLY[0]% } == design ]]'
zsh -f -c 'autoload -U compinit && compinit -u -d .zcompdump && [[ $_comps[tencer] == _tencer ]]'
test -e /usr/share/fish/vendor_completions.d/tencer.fish
zcat /usr/share/doc/tencer/changelog.gz | grep -q '^# '
for page in README.md docs/python.md docs/install.md copyright; do
  test -e /usr/share/doc/tencer/$page
done

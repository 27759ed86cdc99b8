"""site.py FOLDER: puts the pages into an empty folder as mkdocs takes them (mkdocs.yml).

They keep the places that they have in the sources, so that their links hold. Diagrams, for which a
browser would need a script from elsewhere, become pictures, drawn by dot (Debian: graphviz).
"""

import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[2]
# Names are not broken in two, and long lines of what the program says are.
CSS = """.md-typeset table code { word-break: normal; overflow-wrap: break-word }
.md-typeset pre > code { white-space: pre-wrap }
"""
STYLE = 'rankdir=TB; node [shape=box, style=rounded, fontname="sans-serif", fontsize=11];'


def draw(diagram, picture):
    """Draws a mermaid flowchart of nothing but arrows."""
    arrows = diagram.replace("flowchart TB", "").replace("-->", "->")
    graph = f"digraph {{ {STYLE} {arrows} }}"
    subprocess.run(["dot", "-Tsvg", "-o", picture], input=graph, text=True, check=True)


def main():
    folder = pathlib.Path(sys.argv[1])
    shutil.rmtree(folder, ignore_errors=True)
    for name in "docs", "examples":
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("make", "*.yml"))
    for name in "README.md", "CHANGELOG.md", "LICENSE", "fuzz/README.md":
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    page = folder / "docs" / "architecture.md"
    before, diagram, after = re.split(r"^```mermaid\n(.*?)^```", page.read_text(), flags=re.M | re.S)
    draw(diagram, page.with_name("images") / "modules.svg")
    page.write_text(f"{before}![The modules, and which may use which](images/modules.svg){after}")
    (folder / "docs" / "site.css").write_text(CSS)


main()

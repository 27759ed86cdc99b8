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
STYLE = 'rankdir=TB; node [shape=box, style=rounded, fontname="sans-serif", fontsize=11];'


def drawn(diagram):
    """An SVG of a mermaid flowchart of nothing but arrows."""
    arrows = diagram.replace("flowchart TB", "").replace("-->", "->")
    graph = f"digraph {{ {STYLE} {arrows} }}"
    done = subprocess.run(["dot", "-Tsvg"], input=graph, capture_output=True, text=True, check=True)
    return re.sub(r"^.*?(?=<svg)", "", done.stdout, flags=re.S)


def main():
    folder = pathlib.Path(sys.argv[1])
    shutil.rmtree(folder, ignore_errors=True)
    for name in "docs", "examples":
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("make", "*.yml"))
    for name in "README.md", "LICENSE", "fuzz/README.md":
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    for page in folder.glob("docs/*.md"):
        text = page.read_text()
        page.write_text(re.sub(r"^```mermaid\n(.*?)^```", lambda found: drawn(found[1]), text,
                               flags=re.M | re.S))


main()

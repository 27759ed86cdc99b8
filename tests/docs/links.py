"""links.py ROOT PAGE...

Links and pictures of the pages are there, and so are the headings that links name; every page is in
the site (docs/mkdocs.yml). ROOT is the folder of the sources; pages are given from there.
"""

import pathlib
import re
import sys


def without_code(text):
    return re.sub(r"`[^`\n]+`", "", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S))


def headings(path):
    """The names of a page's headings in links."""
    text = re.sub(r"^```.*?^```", "", path.read_text(), flags=re.M | re.S)
    titles = re.findall(r"^#+ +(.+)$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", title.lower()).strip().replace(" ", "-") for title in titles}


def targets(path):
    text = path.read_text()
    yield from re.findall(r"\]\(([^)\s]+)\)", without_code(text))
    yield from re.findall(r'<img src="([^"]+)"', text)


def main():
    root, pages = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    faults, links = [], 0
    for page in map(root.joinpath, pages):
        for target in targets(page):
            if target.startswith(("https://", "http://")):
                continue
            links += 1
            file, _, heading = target.partition("#")
            to = page.parent / file if file else page
            if not to.resolve().is_relative_to(root) or not to.exists():
                faults.append(f"{page.relative_to(root)}: {target} is not there")
            elif heading and heading not in headings(to):
                faults.append(f"{page.relative_to(root)}: {target}: no such heading")
    site = (root / "docs" / "mkdocs.yml").read_text()
    faults += [f"docs/mkdocs.yml has no {page}" for page in pages if f": {page}\n" not in site]
    if links < 50:
        faults.append(f"only {links} links were found")
    sys.exit("\n".join(faults) or 0)


main()

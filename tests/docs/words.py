"""words.py PAGE...

Pages for builders have one word for each thing, those of docs/glossary.md.
"""

import pathlib
import re
import sys

# What is not said, and what is.
INSTEAD = {
    r"bounding-box diagonal": "size",
    r"largest error\b(?! of)": "max error",
    r"built form": "with inextensible cables",
    r"attachments?\b|attach(es|ed)?\b": "mark, tied",
    r"goe?s? before": "override",
    r"tendons?|strings?|wires?(?! rope)|tethers?": "cable",
    r"nodes?\b": "vertex",
    r"cross-sections?": "section",
    r"snap-through|buckles": "fall",
    r"floppy|mechanisms?\b": "moves at no cost",
    r"ground structure": "candidates",
}


def prose(text):
    """A page without code, links and pictures."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    return re.sub(r"`[^`]*`|\]\([^)]*\)|^ {4}.*$|<[^>]*>", "", text, flags=re.M)


def main():
    faults = []
    for page in map(pathlib.Path, sys.argv[1:]):
        for line in prose(page.read_text()).splitlines():
            for wrong, right in INSTEAD.items():
                for found in re.finditer(rf"\b({wrong})", line, re.I):
                    faults.append(f"{page}: '{found[0]}' in '{line.strip()[:60]}': say {right}")
    sys.exit("\n".join(faults) or 0)


main()

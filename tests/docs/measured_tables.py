"""measured_tables.py PAGE...

Tables of measured numbers that are too large to be made anew by a test name the commit that made
them: in their section, or at the top of their page. (Of the page of stability a test runs the program.)
"""

import pathlib
import re
import sys

COMMIT = re.compile(r"commit `[0-9a-f]{7}`", re.I)


def measured(table):
    """Whether most cells of a table, but for its first column, begin with a number."""
    rows = [row.strip().strip("|").split("|")[1:] for row in table.splitlines()[2:]]
    cells = [cell.strip() for row in rows for cell in row if cell.strip()]
    numbers = [cell for cell in cells if re.match(r"[-(<]*\d", cell)]
    return len(rows) >= 4 and 2 * len(numbers) > len(cells)


def main():
    faults, found = [], 0
    for page in map(pathlib.Path, sys.argv[1:]):
        top, *sections = re.split(r"^(?=##+ )", page.read_text(), flags=re.M)
        for section in sections:
            for table in re.findall(r"^\|.*\n\|[-|]+\n(?:\|.*\n)+", section, re.M):
                if not measured(table):
                    continue
                found += 1
                if not COMMIT.search(section) and not COMMIT.search(top):
                    faults.append(f"{page}: a table under '{section.splitlines()[0]}' names no commit")
    if found < 10:
        faults.append(f"only {found} tables were found")
    sys.exit("\n".join(faults) or 0)


main()

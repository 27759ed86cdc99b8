"""modules.py [--check]: writes docs/modules/NAME.md, a page a module, from the table of
docs/architecture.md, the openings of the module's public headers and its program in
tests/consumers/examples. With --check it writes nothing and fails where a page is another.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parents[2]
FOLDER = ROOT / "docs" / "modules"
EXAMPLES = ROOT / "tests" / "consumers" / "examples"


def modules():
    """{name: (rule, modules it may use, packages)} in layer order."""
    table = (ROOT / "docs" / "architecture.md").read_text()
    rows = re.findall(r"^\| `(\w+)` \| (.+?) \| (.*?) \| ?(.*?) ?\|$", table, re.M)
    return {name: (rule, used.split(", ") if used else [], packages)
            for name, rule, used, packages in rows}


def opening(header):
    """What a header says that it is for."""
    lines = []
    for line in header.read_text().splitlines():
        if not line.startswith("//"):
            break
        lines.append(line[2:].strip())
    return " ".join(lines).replace("|", "\\|")


def links(names):
    return ", ".join(f"[{name}]({name}.md)" for name in names) or "none"


def page(name, known):
    rule, used, packages = known[name]
    users = [other for other, (_, uses, _) in known.items() if name in uses]
    headers = sorted((ROOT / "modules" / name / "include").rglob("*.hpp"))
    rows = "".join(f"| `{header.relative_to(ROOT / 'modules' / name / 'include')}` | "
                   f"{opening(header)} |\n" for header in headers)
    linked = re.search(rf"^set\({name}_uses (.+)\)", (EXAMPLES / "CMakeLists.txt").read_text(), re.M)
    targets = " ".join(f"tencer::{one}" for one in [name, *(linked[1].split() if linked else [])])
    return f"""# {name}

{rule}

- May use: {links(used)}.
- Is used by: {links(users)}.
- Packages, besides Eigen: {packages or "none"}.

## A program

`./dev test` builds it against an installed tencer and runs it (tests/consumers/examples). It needs
[no more of CMake](../embedding.md#from-an-installed-tencer) than `find_package(tencer)` and

    target_link_libraries(consumer PRIVATE {targets})

```cpp
{(EXAMPLES / f"{name}.cpp").read_text()}```

## Headers

| header | what it is for |
|---|---|
{rows}"""


def main():
    known = modules()
    made = {FOLDER / f"{name}.md": page(name, known) for name in known}
    if "--check" not in sys.argv:
        FOLDER.mkdir(exist_ok=True)
        for path, text in made.items():
            path.write_text(text)
        return
    old = [path for path, text in made.items() if not path.exists() or path.read_text() != text]
    old += set(FOLDER.glob("*.md")) - set(made)
    if old or len(made) < 20:
        sys.exit(f"of {len(made)} pages, old: {', '.join(path.name for path in old)}; to write them: "
                 "python3 docs/make/modules.py")


main()

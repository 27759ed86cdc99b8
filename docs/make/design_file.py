"""Prints docs/design-file.md, made from docs/design.schema.json:

    python3 docs/make/design_file.py >docs/design-file.md
"""

import json
import pathlib
import textwrap

INTRODUCTION = """# The design file

`tencer design` writes a design as `design.json`, and `tencer check`, `tencer simulate` and
`tencer fabricate` read it. This page is made from its JSON Schema,
[design.schema.json](design.schema.json), by `docs/make/design_file.py`. A test validates by the schema
what the program writes.

Your editor completes and checks the file by the schema when you tell it where that is. So do
programs: `python3 -m jsonschema -i knot/design.json docs/design.schema.json`.

Keys marked *optional* are left out where they have nothing to say. A file that tencer reads may also
lack `name`, `status`, `anchors`, `pinned`, `planar` and `trace`, and may have keys of other programs.
When a key is wrong, the message names it.

A short file that tencer reads, an arch of one rod whose ends one cable holds together:

```json
{"schema": "tencer-design/2", "length_unit": "cm", "force_unit": "N",
 "rods": [{"closed": false, "EA": 1e4, "EI": [50, 50], "GJ": 40, "rest_lengths": [10, 10],
           "target": [[0, 0, 0], [8, 6, 0], [16, 0, 0]], "pose": [[0, 0, 0], [8, 6, 0], [16, 0, 0]]}],
 "cables": [{"a": {"rod": 0, "s": 0}, "b": {"rod": 0, "s": 20}, "length": 16, "tension": 3}]}
```
"""

PLAIN = {"string": "text", "number": "number", "integer": "whole number", "boolean": "`true`, `false`",
         "null": "`null`"}
# Definitions that are told by a kind, without a section of their own.
KINDS = {"point": "`[x, y, z]`", "points": "`[[x, y, z], ...]`", "index": "whole number",
         "index_or_none": "whole number, `null`", "not_negative": "number >= 0",
         "positive": "number > 0"}


def name_of(part):
    return part["$ref"].rpartition("/")[2]


def kind(part, definitions):
    """The kind of a value in words, with links to sections."""
    if "$ref" in part:
        name = name_of(part)
        if name in KINDS:
            return KINDS[name]
        if "oneOf" in definitions[name]:
            return kind(definitions[name], definitions)
        return f"[{name}](#{name})"
    if "oneOf" in part:
        return " or ".join(kind(choice, definitions) for choice in part["oneOf"])
    if "const" in part:
        return f"`{json.dumps(part['const'])}`"
    if "enum" in part:
        return ", ".join(f"`{json.dumps(value)}`" for value in part["enum"])
    if part.get("type") == "array":
        items = kind(part["items"], definitions)
        if part.get("minItems") == part.get("maxItems", 0):
            return f"array of {part['minItems']}: {items}"
        return f"array of {items}"
    kinds = part["type"] if isinstance(part["type"], list) else [part["type"]]
    words = ", ".join(PLAIN[one] for one in kinds)
    examples = ", ".join(f"`{json.dumps(value)}`" for value in part.get("examples", ()))
    return f"{words}: {examples}" if examples else words


def described(part, definitions):
    if "description" in part:
        return part["description"]
    return definitions[name_of(part)]["description"]


def table(part, definitions):
    rows = ["| key | kind | meaning |", "|---|---|---|"]
    for key, value in part["properties"].items():
        optional = "" if key in part.get("required", ()) else "*optional* "
        rows.append(f"| `{key}` | {optional}{kind(value, definitions)} | "
                    f"{described(value, definitions)} |")
    return "\n".join(rows)


def section(title, part, definitions):
    description = textwrap.fill(part["description"], 100)
    return f"## {title}\n\n{description}\n\n{table(part, definitions)}\n"


def main():
    path = pathlib.Path(__file__).parent.parent / "design.schema.json"
    schema = json.loads(path.read_text())
    definitions = schema["$defs"]
    parts = [INTRODUCTION, section("The whole file", schema, definitions)]
    parts += [section(name, part, definitions)
              for name, part in definitions.items() if "properties" in part]
    print("\n".join(parts), end="")


main()

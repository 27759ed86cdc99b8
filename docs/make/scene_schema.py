"""scene_schema.py: prints docs/scene.schema.json, by which editors check and complete scenes:

    python3 docs/make/scene_schema.py >docs/scene.schema.json

Keys, defaults and meanings are those of the tables in docs/scene.md; the kinds of values are here. A
key that only one of the two has is an error.
"""

import json
import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).parents[1] / "scene.md"

TEXT = {"type": "string"}
NUMBER = {"type": "number"}
POSITIVE = {"type": "number", "exclusiveMinimum": 0}
NOT_NEGATIVE = {"type": "number", "minimum": 0}
BOOLEAN = {"type": "boolean"}
INDEX = {"type": "integer", "minimum": 0}
COUNT = {"type": "integer", "minimum": 1}
VERTICES = {"type": "integer", "minimum": 3, "maximum": 20000}


def one_of(*names):
    return {"enum": list(names)}


def array(items, least=0, most=None):
    limits = {"minItems": least} if most is None else {"minItems": least, "maxItems": most}
    return {"type": "array", "items": items, **limits}


def table(properties, required=()):
    return {"type": "object", "properties": properties, "required": list(required),
            "additionalProperties": False}


POINT = array(NUMBER, 3, 3)
POINTS = array(POINT)
NAMES = array(INDEX)

# What a table of the page says of materials and families.
def names_in(page, heading):
    section = re.search(rf"^\| {heading}.*\n\|[-|]+\n((?:\|.*\n)+)", page, re.M)[1]
    names = []
    for row in section.splitlines():
        cell = row.split("|")[1]
        first, last = cell.find("knot-3_1"), cell.find("7_7")
        if first >= 0 and last >= 0:
            names += [f"knot-{crossings}_{i}" for crossings, count in
                      ((3, 1), (4, 1), (5, 2), (6, 3), (7, 7)) for i in range(1, count + 1)]
        else:
            names += re.findall(r"`([^`]+)`", cell)
    return names


MATTER = {"youngs_modulus": POSITIVE, "poisson": NUMBER, "density": NOT_NEGATIVE}
SECTION = {"anyOf": [
    table({"shape": one_of("circle"), "radius": POSITIVE, **MATTER}),
    table({"shape": one_of("tube"), "outer_radius": POSITIVE, "inner_radius": NOT_NEGATIVE, **MATTER},
          ["shape", "outer_radius", "inner_radius"]),
    table({"shape": one_of("rectangle"), "width": POSITIVE, "height": POSITIVE, **MATTER},
          ["shape", "width", "height"]),
    table({"EA": POSITIVE, "EI": {"anyOf": [POSITIVE, array(POSITIVE, 2, 2)]}, "GJ": POSITIVE,
           "mass_per_length": NOT_NEGATIVE}, ["EA", "EI", "GJ"])]}
ARC = {"rod": INDEX, "from": NOT_NEGATIVE, "to": NOT_NEGATIVE}
SYMMETRY = {"anyOf": [one_of("none", "offer", "detect"), array({"anyOf": [
    table({"fold": {"type": "integer", "minimum": 2}, "axis": POINT, "point": POINT},
          ["fold", "axis"]),
    table({"normal": POINT, "point": POINT}, ["normal"])]})]}


def kinds(page):
    """The kinds of values: {heading of the page: {key: kind}}."""
    parameters = {"type": "object", "additionalProperties": NUMBER}
    family = one_of(*names_in(page, "family"))
    curve = {"curve": TEXT, "index": INDEX, "family": family, "spline": POINTS,
             "parameters": parameters, "vertices": VERTICES, "smooth": POSITIVE}
    return {
        "Top level": {
            "name": TEXT, "length_unit": one_of("mm", "cm", "m"),
            "force_unit": one_of("mN", "N", "kN"), "planar": BOOLEAN, "anchors": POINTS,
            "frame": table({"shape": one_of("cube", "tetrahedron"), "margin": POSITIVE}, ["shape"]),
            "pinned": array(table({"rod": INDEX, "vertex": INDEX,
                                   "axes": {"type": "string", "pattern": "^[xyz]+$"}},
                                  ["rod", "vertex"])),
            "gravity": POINT,
            "loads": array(table({"rod": INDEX, "s": NOT_NEGATIVE, "force": POINT},
                                 ["rod", "s", "force"])),
            "rod": None, "design": None, "build": None, "edit": None},
        "`[[rod]]`": {
            **curve, "closed": BOOLEAN, "section": SECTION,
            "material": one_of(*names_in(page, "material")), "director": POINT,
            "rest": {"anyOf": [table({"curvature": NUMBER}, ["curvature"]),
                               table({**curve, "director": POINT})]},
            "closing_turns": NUMBER},
        "`[design]`": {
            "method": one_of("force-balance", "dense-springs"), "max_error": POSITIVE,
            "cables": COUNT, "objective": one_of("max", "rms"), "symmetry": SYMMETRY,
            "rod_pairs": array(array(INDEX, 2, 2)), "external": BOOLEAN, "hand_over": BOOLEAN,
            "longest_cable": POSITIVE, "threads": COUNT, "time": POSITIVE,
            "effort": {"type": "integer", "minimum": 1, "maximum": 3},
            "view": {"anyOf": [POINT, array(POINT, 1),
                               array(table({"direction": POINT, "weight": POSITIVE},
                                           ["direction"]), 1)]},
            "weights": array(table({**ARC, "weight": NOT_NEGATIVE}, ["rod", "weight"])),
            "forbidden_arcs": array(table(ARC, ARC)),
            "forbidden_vertices": array(table({"rod": INDEX, "vertices": NAMES},
                                              ["rod", "vertices"])),
            "optimizer": one_of("gauss-newton", "ipopt", "mma", "ccsaq"),
            "hessian": one_of("gauss-newton", "exact", "limited-memory"),
            "sparsity_weights": array(NOT_NEGATIVE, 1), "spring_stiffness": POSITIVE,
            "greedy_threshold": POSITIVE},
        "`[build]`": {
            "length_error": NOT_NEGATIVE, "attachment_error": NOT_NEGATIVE,
            "max_deviation": {"anyOf": [POSITIVE, TEXT]}, "clearance": NOT_NEGATIVE,
            "mark_distance": NOT_NEGATIVE, "layers": BOOLEAN,
            "min_tension_ratio": {"type": "number", "minimum": 0, "exclusiveMaximum": 1},
            "min_tension": NOT_NEGATIVE},
        "`[edit]`": {
            "from": TEXT, "keep": array(COUNT), "forbid": array(COUNT), "add": COUNT,
            "remove": COUNT},
    }


def plain(cell):
    """A cell's text without marks of the page."""
    cell = re.sub(r"\[([^\]]+)\]\([^)]+\)", r"\1", cell)
    return cell.replace("`", "").strip()


def documented(page, heading):
    """The rows of the first table under a heading: {key: description}."""
    section = page.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    rows = {}
    for row in re.search(r"^\| key .*\n\|[-|]+\n((?:\|.*\n)+)", section, re.M)[1].splitlines():
        key, standard, meaning = row.strip().strip("|").split("|")
        key = re.sub(r"[`\[\] ]", "", key)
        sentences = [plain(meaning), f"Default: {plain(standard)}" if plain(standard) else ""]
        rows[key] = " ".join(f"{words[0].upper()}{words[1:]}." for words in sentences if words)
    return rows


def described(page, heading, values):
    rows = documented(page, heading)
    if set(rows) != set(values):
        sys.exit(f"{PAGE}, {heading}: only one of page and script has {set(rows) ^ set(values)}")
    return {key: {"description": rows[key], **values[key]} if rows[key] else values[key]
            for key in rows if values[key] is not None}


def main():
    page = PAGE.read_text()
    parts = {heading: described(page, heading, values) for heading, values in kinds(page).items()}
    top = documented(page, "Top level")
    tables = {"rod": {**array(table(parts["`[[rod]]`"]), 1), "description": top["rod"]}}
    for name in "design", "build":
        tables[name] = {**table(parts[f"`[{name}]`"]), "description": top[name]}
    tables["edit"] = {**table(parts["`[edit]`"], ["from"]), "description": top["edit"]}
    schema = {"$schema": "https://json-schema.org/draft/2020-12/schema",
              "title": "A scene of tencer",
              "description": "Which curves rods are to take, what they are made of, what holds "
                             "them, and how to look for cables (docs/scene.md).",
              **table({**parts["Top level"], **tables}, ["rod"])}
    print(json.dumps(schema, indent=1, ensure_ascii=False))


main()

"""scene_schema.py SCHEMA EXAMPLES TENCER WORK

The scenes of examples/ are valid by docs/scene.schema.json, and what the schema refuses the program
refuses too, at the same key: in every table an unknown key, every key with a value of another kind, and
words that are none of those that a key can have, which both know alike.
"""

import copy
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

from jsonschema import Draft202012Validator

BASE = {"rod": [{"family": "ellipse"}], "anchors": [[0, 0, 9]]}


def toml(value):
    """A value as TOML, on one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {toml(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def places(schema):
    """(path to a table in a scene, its part of the schema)."""
    yield (), schema
    yield ("rod", 0), schema["properties"]["rod"]["items"]
    for name in "design", "build", "edit":
        yield (name,), schema["properties"][name]


def with_key(path, key, value):
    scene = copy.deepcopy(BASE)
    table = scene
    for step in path:
        table = table.setdefault(step, {}) if isinstance(step, str) else table[step]
    if path == ("edit",):
        table["from"] = "design.json"
    if path == ("rod", 0) and key in ("curve", "spline"):
        del table["family"]
    table[key] = value
    return scene


class Program:
    def __init__(self, tencer, work):
        self.tencer, self.work = tencer.resolve(), work

    def refusal(self, scene):
        """What it says of the scene; empty: it takes it."""
        lines = [f"{key} = {toml(value)}" for key, value in scene.items()]
        (self.work / "scene.toml").write_text("\n".join(lines) + "\n")
        done = subprocess.run([self.tencer, "feasible", "scene.toml"], cwd=self.work,
                              capture_output=True, text=True)
        return done.stderr if done.returncode == 2 else ""


def main():
    schema_path, examples, tencer, work = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    schema = json.loads(schema_path.read_text())
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    faults, tried = [], 0
    scenes = sorted(examples.glob("*/*.toml"))
    for path in scenes:
        content = tomllib.loads(path.read_text())
        if "step" in content:  # the schedule of an actuation
            continue
        faults += [f"{path}: {error.message}" for error in validator.iter_errors(content)]
    program = Program(tencer, work)
    page = schema_path.with_name("design-file.md").read_text()
    (work / "design.json").write_text(page.split("```json\n")[1].split("```")[0])
    for path, part in places(schema):
        wrong = [("surprise", 1)]
        for key, value in part["properties"].items():
            wrong.append((key, "nonsense" if "enum" in value else {"of": "another kind"}))
        for key, value in wrong:
            scene = with_key(path, key, value)
            said = program.refusal(scene)
            tried += 1
            where = ".".join(map(str, [*path, key]))
            if validator.is_valid(scene):
                faults.append(f"the schema takes {where} = {toml(value)}")
            if key not in said:
                faults.append(f"the program says of {where} = {toml(value)}: {said or 'nothing'}")
            words = part["properties"].get(key, {}).get("enum")
            known = re.search(r"expected one of (.*), found", said)
            if words and (not known or sorted(known[1].split(", ")) != sorted(words)):
                faults.append(f"the schema has {where} = {', '.join(words)}; the program: {said}")
    if len(scenes) < 30 or tried < 60:
        faults.append(f"only {len(scenes)} scenes and {tried} wrong ones were tried")
    sys.exit("\n".join(faults) or 0)


main()

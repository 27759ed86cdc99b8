"""design_schema.py SCHEMA TENCER TEST_IO EXAMPLES WORK

Every design.json that the program and the tests of its writer write is valid by
docs/design.schema.json; every key of the schema is in one of them; and the schema refuses a file
with a key too many, a key too few or a value of another kind. The example on the page made from it
stands.
"""

import copy
import json
import os
import pathlib
import shutil
import subprocess
import sys

from jsonschema import Draft202012Validator


def written_samples(test_io, folder):
    folder.mkdir(parents=True)
    environment = {**os.environ, "TENCER_SAMPLES": str(folder)}
    subprocess.run([test_io, "[.samples]"], env=environment, check=True, stdout=subprocess.DEVNULL)


def run(tencer, work, *arguments):
    """What it prints."""
    command = [tencer, *map(str, arguments)]
    done = subprocess.run(command, cwd=work, capture_output=True, text=True)
    if done.returncode not in (0, 3):  # complete, or not
        sys.exit(f"{' '.join(map(str, command))}: {done.stderr}")
    return done.stdout


def written_designs(tencer, examples, work):
    """Designs of the program: a checked one, and one with loads, pins and anchors."""
    run(tencer, work, "target", "ellipse", "--vertices", 30, "-o", "ring.obj")
    run(tencer, work, "design", "ring.obj", "-o", "ring", "--quiet", "--view", "0,0,1")
    check = run(tencer, work, "check", "ring/design.json", "--json", "-o", "checked")
    (work / "check.json").write_text(check)
    run(tencer, work, "simulate", "checked/design.json", "-o", "settled")
    lamp = (examples / "physics" / "lamp.toml").read_text()
    (work / "lamp.toml").write_text(lamp.replace("vertices = 61", "vertices = 16"))
    run(tencer, work, "design", "lamp.toml", "-o", "lamp", "--quiet", "--max-error", 5)


class Schema:
    def __init__(self, content):
        self.content = content
        self.validator = Draft202012Validator(content)
        self.definitions = {}

    def definition(self, name):
        """A part of the schema as one of its own."""
        if name not in self.definitions:
            part = {"$ref": f"#/$defs/{name}", "$defs": self.content["$defs"]}
            self.definitions[name] = Schema(part)
        return self.definitions[name]

    def problems(self, value):
        return [f"{error.json_path}: {error.message}" for error in self.validator.iter_errors(value)]

    def resolved(self, part):
        while "$ref" in part:
            part = self.content["$defs"][part["$ref"].rpartition("/")[2]]
        return part

    def keys(self):
        """All keys of all objects that the schema describes: (definition, key)."""
        parts = {"": self.content, **self.content["$defs"]}
        return {(name, key) for name, part in parts.items() for key in part.get("properties", ())}

    def keys_in(self, value, part=None, name=""):
        """Those of them that a valid value has."""
        if part is None:
            part = self.content
        if "$ref" in part:
            name = part["$ref"].rpartition("/")[2]
            part = self.resolved(part)
        for choice in part.get("oneOf", ()):
            name_of_choice = choice["$ref"].rpartition("/")[2]
            if not self.definition(name_of_choice).problems(value):
                yield from self.keys_in(value, choice)
        if isinstance(value, dict):
            for key, item in value.items():
                if key in part.get("properties", ()):
                    yield name, key
                    yield from self.keys_in(item, part["properties"][key])
        if isinstance(value, list):
            for item in value:
                yield from self.keys_in(item, part.get("items", {}))


def changed(value):
    """Copies of a value that are wrong: (what was done, copy)."""

    def places(item, path):
        if isinstance(item, dict):
            yield path
            for key, member in item.items():
                yield from places(member, [*path, key])
        elif isinstance(item, list) and item:
            yield from places(item[0], [*path, 0])

    def at(root, path):
        for step in path:
            root = root[step]
        return root

    for path in places(value, []):
        where = "/".join(map(str, path))
        copied = copy.deepcopy(value)
        at(copied, path)["surprise"] = 1
        yield f"{where} has a key too many", copied
        for key in at(value, path):
            copied = copy.deepcopy(value)
            at(copied, path)[key] = {"of": "another kind"}
            yield f"{where}/{key} is of another kind", copied


def main():
    schema_path, tencer, test_io, examples, work = map(pathlib.Path, sys.argv[1:])
    schema = Schema(json.loads(schema_path.read_text()))
    Draft202012Validator.check_schema(schema.content)
    shutil.rmtree(work, ignore_errors=True)
    written_samples(test_io, work / "samples")
    written_designs(tencer, examples, work)
    faults, found = [], set()
    paths = sorted([*work.glob("samples/*.json"), *work.glob("*/design.json")])
    for path in paths:
        value = json.loads(path.read_text())
        faults += [f"{path}: {problem}" for problem in schema.problems(value)]
        found |= set(schema.keys_in(value))
    check = json.loads((work / "check.json").read_text())
    faults += [f"check --json: {problem}" for problem in schema.definition("check").problems(check)]
    faults += [f"no file has the key '{key}' of '{of}'" for of, key in sorted(schema.keys() - found)]
    sample = json.loads((work / "samples" / "built.json").read_text())
    wrong = list(changed(sample))
    faults += [f"accepted: {what}" for what, value in wrong if schema.validator.is_valid(value)]
    page = schema_path.with_name("design-file.md").read_text()
    (work / "example.json").write_text(page.split("```json\n")[1].split("```")[0])
    said = run(tencer, work, "simulate", "example.json")
    if "converged to a stable equilibrium" not in said:
        faults.append(f"the example of the page does not stand: {said}")
    for key in schema.content["required"]:
        without = {other: item for other, item in sample.items() if other != key}
        if schema.validator.is_valid(without):
            faults.append(f"accepted: without {key}")
    if len(paths) < 7 or len(wrong) < 100:
        faults.append(f"only {len(paths)} files and {len(wrong)} wrong ones were tried")
    sys.exit("\n".join(faults) or 0)


main()

"""The stubs of tencer._core name what it has, and it has what they name."""

import ast
from pathlib import Path

import tencer
from tencer import _core


def test_stubs_are_of_this_module():
    tree = ast.parse((Path(tencer.__file__).parent / "_core.pyi").read_text())
    said = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            said[node.name] = {
                part.name if isinstance(part, ast.FunctionDef) else part.target.id
                for part in node.body
                if isinstance(part, (ast.FunctionDef, ast.AnnAssign))
            }
        elif isinstance(node, ast.FunctionDef):
            said[node.name] = None
    there = {name for name in vars(_core) if not name.startswith("_")}
    assert there | {"page"} == set(said)  # a build without the program has no page
    for name, parts in said.items():
        if parts is None or name == "Error":
            continue
        own = {part for part in vars(getattr(_core, name)) if not part.startswith("_")}
        assert own == {part for part in parts if not part.startswith("_")}, name


def test_everything_has_words():
    for name in tencer.__all__:
        assert getattr(tencer, name).__doc__, name

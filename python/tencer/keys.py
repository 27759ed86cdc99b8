"""Keyword arguments as the keys of a scene file: names, defaults, units and messages are its own."""

import json
import math
import os

import numpy as np

from . import _core


class Keys:
    """The keys as TOML text, with the curves and designs that it names by number."""

    def __init__(self, given):
        self.curves = []
        self.designs = []
        given = {key: value for key, value in given.items() if value is not None}
        if isinstance(given.get("rod"), dict):
            given["rod"] = [given["rod"]]
        for rod in given.get("rod", []):
            _place(rod, "rod")
        self.text = "".join(f"{_key(key)} = {self._value(value, key)}\n" for key, value in given.items())

    def _value(self, value, key):
        if isinstance(value, dict):
            parts = (
                f"{_key(name)} = {self._value(part, name)}"
                for name, part in value.items()
                if part is not None
            )
            return "{" + ", ".join(parts) + "}"
        if key == "curve":
            return self._curve(value)
        if key == "from":
            return self._design(value)
        return _plain(value, key, self._value)

    def _curve(self, value):
        if _is_path(value):
            return json.dumps(os.path.abspath(value))
        self.curves.append(as_curve(value, "curve"))
        return str(len(self.curves) - 1)

    def _design(self, value):
        if _is_path(value):
            return json.dumps(os.path.abspath(value))
        if not isinstance(value, _core.Design):
            raise TypeError(f"edit.from: expected a path or a Design, found {type(value).__name__}")
        self.designs.append(value)
        return str(len(self.designs) - 1)


def as_curve(value, name):
    """A Curve of an array (n, 3) or of a Curve."""
    return value if isinstance(value, _core.Curve) else _core.Curve(value, None, name)


def _is_path(value):
    return isinstance(value, (str, os.PathLike))


def _key(name):
    return json.dumps(str(name))


def _place(value, name):
    if not isinstance(value, dict):
        raise TypeError(f"{name}: expected a dict, or a list of them, found {type(value).__name__}")


def _plain(value, key, inner):
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else str(value)
    if _is_path(value):
        return json.dumps(os.fspath(value))
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(inner(part, key) for part in value) + "]"
    raise TypeError(f"{key}: a scene has no value of type {type(value).__name__}")

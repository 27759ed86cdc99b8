"""installed.py PREFIX VERSION

The Python module that was installed in the prefix is found there, and designs.
"""

import importlib.metadata
import sys
from pathlib import Path

import numpy as np
import tencer

prefix, version = sys.argv[1:]
assert Path(tencer.__file__).is_relative_to(prefix), tencer.__file__
assert tencer.__version__ == importlib.metadata.version("tencer") == version
t = np.linspace(0, 2 * np.pi, 24, endpoint=False)
ring = np.stack([30 * np.cos(t), 20 * np.sin(t), 0 * t], axis=1)
design = tencer.design(ring, closed=True, max_error=5, effort=1)
assert design.complete, design.shortfalls
assert "<iframe" in design._repr_html_()

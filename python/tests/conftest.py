"""Curves that several tests design for."""

import numpy as np
import pytest

import tencer


# What is found soon: a search that knows of no errors is shorter.
QUICK = {"max_error": 5, "effort": 1, "build": {"length_error": 0, "attachment_error": 0}}


def trefoil_points(count=40):
    """(count, 3), in cm."""
    t = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return 6 * np.stack(
        [np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], axis=1
    )


@pytest.fixture(scope="session")
def trefoil():
    return tencer.Curve(trefoil_points(), closed=True)


@pytest.fixture(scope="session")
def design(trefoil):
    return tencer.design(trefoil, **QUICK)

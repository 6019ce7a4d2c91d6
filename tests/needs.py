"""Optional tools: a test that needs one is skipped where it is absent, and says which it is."""

from __future__ import annotations

import shutil
from importlib.util import find_spec
from types import ModuleType
from typing import Any

import pytest

#: Extras of the package, and the module by which each is known to be installed.
EXTRAS = {
    "taylor": "heyoka",
    "cluster": "distributed",
    "gpu": "cuda.core",
    "film": "av",
    "lab": "uvicorn",
}


def is_installed(tool: str) -> bool:
    """Whether a Python module can be imported, or a program is found."""
    try:
        return find_spec(tool) is not None or shutil.which(tool) is not None
    except ModuleNotFoundError:
        # the package of a submodule is absent
        return False


def needs(*tools: str) -> pytest.MarkDecorator:
    """Mark of a test, or of a file as ``pytestmark``, that needs modules or programs."""
    absent = [tool for tool in tools if not is_installed(tool)]
    return pytest.mark.skipif(bool(absent), reason=f"{', '.join(absent)}: not installed")


def optional(name: str) -> Any:
    """A module that is optional; without it the test, or the whole file, is skipped."""
    found: ModuleType = pytest.importorskip(name, reason=f"{name}: not installed")
    return found

"""The cache on disk: one folder, and entries named after everything that they depend on.

Whatever changes a result changes the name of its entry, so that nothing stale is ever read: what
the result is computed from, the program text, the versions of Python and of the libraries.  Files
are read and written by :mod:`flowlanes.files.private_files` alone.
"""

from __future__ import annotations

import hashlib
import os
import platform
from functools import cache
from importlib.metadata import version
from pathlib import Path

import platformdirs

from .source_digest import computation_digest

#: Libraries that take part in a proof or in the generation of machine code.
LIBRARIES = (
    "llvmlite",
    "mpmath",
    "numpy",
    "python-flint",
    "scipy",
    "sympy",
)


def folder() -> Path:
    """The folder of the cache; the variable FLOWLANES_CACHE replaces the user's own one."""
    chosen = os.environ.get("FLOWLANES_CACHE")
    return Path(chosen) if chosen else Path(platformdirs.user_cache_dir("flowlanes"))


@cache
def _versions() -> tuple[str, ...]:
    """The versions of Python and of the libraries."""
    return platform.python_version(), *(f"{name} {version(name)}" for name in LIBRARIES)


def entry_name(*parts: str) -> str:
    """The name of an entry that depends on texts, on the program and on the libraries.

    Parameters
    ----------
    *parts : str
        All that the entry is computed from; machine code needs the processor among them.
    """
    texts = (*parts, computation_digest(), *_versions())
    # lengths keep texts apart whatever characters they have
    encoded = (text.encode() for text in texts)
    return hashlib.sha256(b"".join(b"%d:%b" % (len(e), e) for e in encoded)).hexdigest()

"""Cache on disk: one folder, with entries named after all data on which they depend.

The name of an entry depends on all input of the computation, the program text, and the versions of
Python and of the libraries.  A change of any of them gives another name, so outdated entries are
never read.  Files are read and written only by :mod:`flowlanes.files.private_files`.
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

#: Libraries that affect proofs or the generated machine code.
LIBRARIES = (
    "llvmlite",
    "mpmath",
    "numpy",
    "python-flint",
    "scipy",
    "sympy",
)


def folder() -> Path:
    """Folder of the cache: FLOWLANES_CACHE, or otherwise a folder of the user."""
    chosen = os.environ.get("FLOWLANES_CACHE")
    return Path(chosen) if chosen else Path(platformdirs.user_cache_dir("flowlanes"))


@cache
def _versions() -> tuple[str, ...]:
    """Versions of Python and of the libraries."""
    return platform.python_version(), *(f"{name} {version(name)}" for name in LIBRARIES)


def entry_name(*parts: str) -> str:
    """Name of an entry that depends on texts, on the program and on the libraries.

    Parameters
    ----------
    *parts : str
        All input of the computation; for machine code this must include the processor.
    """
    texts = (*parts, computation_digest(), *_versions())
    # with the lengths, different lists of texts have different names
    encoded = (text.encode() for text in texts)
    return hashlib.sha256(b"".join(b"%d:%b" % (len(e), e) for e in encoded)).hexdigest()

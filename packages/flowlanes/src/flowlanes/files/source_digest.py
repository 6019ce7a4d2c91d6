"""Digests of the program text, on which every stored result depends.

Verdicts, machine code and blocks of a long computation are stored with a digest of the whole
program text, so that a corrected mistake, wherever it was, invalidates all results that it may
have affected.  Reading and digesting all of it takes some ten milliseconds, less than to follow
the imports of each result.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from functools import cache
from pathlib import Path

PRESENTATION = ("__main__.py", "borisov_mamaev", "cli", "experiment", "geometry", "lab", "report")
"""Commands, claims of the paper, reports, pages: no module that computes imports any of them."""


def module_digests(home: Path) -> dict[str, str]:
    """Digests of all modules of a package, by path below it."""
    return {
        path.relative_to(home).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(home.rglob("*.py"))
        # editors leave links to nowhere beside a file that is being changed
        if path.is_file()
    }


def text_digest(modules: Mapping[str, str], omitted_folders: tuple[str, ...] = ()) -> str:
    """A digest of the modules of a package, by name and content.

    Parameters
    ----------
    modules : mapping of str to str
        Their digests by path; see :func:`module_digests`.
    omitted_folders : tuple of str
        Folders that are left out.
    """
    lines = (f"{n} {d}\n" for n, d in modules.items() if n.split("/")[0] not in omitted_folders)
    return hashlib.sha256("".join(lines).encode()).hexdigest()


# computed on import, together with the modules themselves: by the first use the files might hold
# another text than the one that runs
_MODULES = module_digests(Path(__file__).parents[1])


@cache
def computation_digest() -> str:
    """A digest of all modules that compute."""
    return text_digest(_MODULES, PRESENTATION)


@cache
def package_digest() -> str:
    """A digest of all modules of the package."""
    return text_digest(_MODULES)

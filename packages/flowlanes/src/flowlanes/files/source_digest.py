"""Digests of the program text, which are part of the names of all stored results.

Machine code, verdicts and blocks of a long computation are stored with a digest of the whole
program text.  So a correction anywhere in the program invalidates all results that it may affect.
To read and digest the whole text takes about ten milliseconds, less than to find the imports of
each result.

A package whose results are stored together with those of this package declares this in its
metadata: an entry point of the group ``flowlanes.programs`` with the name of the package (twice).
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from functools import cache
from importlib.metadata import entry_points
from importlib.util import find_spec
from pathlib import Path

GROUP = "flowlanes.programs"
"""Entry points of the packages whose modules compute."""


def module_digests(home: Path) -> dict[str, str]:
    """Digests of all modules of a package, by path relative to the folder that contains it."""
    return {
        path.relative_to(home.parent).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(home.rglob("*.py"))
        # editors leave dangling links beside a file that is being edited
        if path.is_file()
    }


def text_digest(modules: Mapping[str, str]) -> str:
    """Digest of modules, by name and content.

    Parameters
    ----------
    modules : mapping of str to str
        Digests by path; see :func:`module_digests`.
    """
    return hashlib.sha256("".join(f"{n} {d}\n" for n, d in modules.items()).encode()).hexdigest()


def package_home(name: str) -> Path | None:
    """Folder of a package that need not be imported; None if it is not installed."""
    spec = find_spec(name)
    return None if spec is None or spec.origin is None else Path(spec.origin).parent


def programs() -> tuple[Path, ...]:
    """Folders of the packages that take part in computations, in the order of their names."""
    own = Path(__file__).parents[1]
    names = {entry.value for entry in entry_points(group=GROUP)} - {own.name}
    homes = {own, *(home for name in names if (home := package_home(name)) is not None)}
    return tuple(sorted(homes, key=lambda home: home.name))


# computed on import, when the files have the same text as the imported modules; later they might
# have been edited
_MODULES = {name: digest for home in programs() for name, digest in module_digests(home).items()}


@cache
def computation_digest() -> str:
    """Digest of all modules that take part in computations."""
    return text_digest(_MODULES)


@cache
def package_digest(name: str) -> str:
    """Digest of all modules of an installed package."""
    home = package_home(name)
    return text_digest({} if home is None else module_digests(home))

"""Digests of the program text, on which every stored result depends.

Machine code, verdicts and blocks of a long computation are stored with a digest of the whole
program text, so that a corrected mistake, wherever it was, invalidates all results that it may
have affected.  Reading and digesting all of it takes some ten milliseconds, less than to follow
the imports of each result.

A package whose results are stored beside those of this one names itself in its metadata, as an
entry point of the group ``flowlanes.programs`` (the name of the package, twice).
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
    """Digests of all modules of a package, by path below the folder that holds it."""
    return {
        path.relative_to(home.parent).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(home.rglob("*.py"))
        # editors leave links to nowhere beside a file that is being changed
        if path.is_file()
    }


def text_digest(modules: Mapping[str, str]) -> str:
    """A digest of modules, by name and content.

    Parameters
    ----------
    modules : mapping of str to str
        Their digests by path; see :func:`module_digests`.
    """
    return hashlib.sha256("".join(f"{n} {d}\n" for n, d in modules.items()).encode()).hexdigest()


def package_home(name: str) -> Path | None:
    """The folder of a package, which is not imported; None where it is not installed."""
    spec = find_spec(name)
    return None if spec is None or spec.origin is None else Path(spec.origin).parent


def programs() -> tuple[Path, ...]:
    """The folders of the packages whose modules compute, in the order of their names."""
    own = Path(__file__).parents[1]
    names = {entry.value for entry in entry_points(group=GROUP)} - {own.name}
    homes = {own, *(home for name in names if (home := package_home(name)) is not None)}
    return tuple(sorted(homes, key=lambda home: home.name))


# computed on import, together with the modules themselves: by the first use the files might hold
# another text than the one that runs
_MODULES = {name: digest for home in programs() for name, digest in module_digests(home).items()}


@cache
def computation_digest() -> str:
    """A digest of all modules that compute."""
    return text_digest(_MODULES)


@cache
def package_digest(name: str) -> str:
    """A digest of all modules of an installed package."""
    home = package_home(name)
    return text_digest({} if home is None else module_digests(home))

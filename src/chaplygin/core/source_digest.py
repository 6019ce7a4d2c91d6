"""The program text on which everything kept on disk depends.

What is kept (verdicts, machine code, blocks of a long computation) goes by a name that holds a
digest of this text, so that a mended mistake, wherever it was, leaves nothing standing that it led
to.  To read and digest all of it takes some ten milliseconds, less than to follow the imports.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from functools import cache
from pathlib import Path

__all__ = ["APART", "core", "module_digests", "text_digest", "whole"]

APART = ("__main__.py", "borisov_mamaev", "cli", "experiment", "report")
"""What the rest never imports: what commands say, claims of the paper, reports."""


def module_digests(home: Path) -> dict[str, str]:
    """Digests of all modules of a package, by their place in it."""
    return {
        path.relative_to(home).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(home.rglob("*.py"))
        # editors leave links to nowhere beside a file that is being changed
        if path.is_file()
    }


def text_digest(modules: Mapping[str, str], apart: tuple[str, ...] = ()) -> str:
    """A digest of the modules of a package, by name and content.

    Parameters
    ----------
    modules : mapping of str to str
        Their digests by place; see :func:`module_digests`.
    apart : tuple of str
        Folders that are left out.
    """
    lines = (f"{n} {d}\n" for n, d in modules.items() if n.split("/")[0] not in apart)
    return hashlib.sha256("".join(lines).encode()).hexdigest()


# taken when this is imported, that is together with what computes, and not when first asked for:
# by then another text might have come into the files
_MODULES = module_digests(Path(__file__).parents[1])


@cache
def core() -> str:
    """A digest of all that computes."""
    return text_digest(_MODULES, APART)


@cache
def whole() -> str:
    """A digest of the whole package."""
    return text_digest(_MODULES)

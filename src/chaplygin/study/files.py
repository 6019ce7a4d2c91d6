"""Files that appear complete or not at all, and never replace another unasked."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..errors import InputError

__all__ = ["check_target", "completed"]


def check_target(target: Path, force: bool = False) -> None:
    """Raise InputError unless a file may be written to `target`."""
    try:
        target.exists()
    except OSError as problem:
        raise InputError(f"{target} cannot be written: {problem.strerror}") from problem
    if target.is_dir():
        raise InputError(f"{target} is a folder: the name of a file is needed")
    if target.exists() and not force:
        raise InputError(
            f"{target} exists already: choose another name, or have it "
            "replaced (--force, in Python force=True)"
        )
    if not target.parent.is_dir():
        raise InputError(f"{target} cannot be written: there is no folder {target.parent}")
    if not os.access(target.parent, os.W_OK):
        raise InputError(f"{target} cannot be written: the folder {target.parent} is protected")


@contextmanager
def completed(target: Path) -> Iterator[Path]:
    """A temporary file that becomes `target` when the block ends well, and else disappears.

    Raises
    ------
    InputError
        If it cannot be written (a protected folder, a full disk).
    """
    temporary = None
    try:
        handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
        os.close(handle)
        temporary = Path(name)
        yield temporary
        temporary.chmod(0o666 & ~_umask())
        temporary.replace(target)
    except OSError as problem:
        raise InputError(f"{target} cannot be written: {problem.strerror or problem}") from problem
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)


def _umask() -> int:
    """The permissions that new files are to lack."""
    current = os.umask(0)
    os.umask(current)
    return current

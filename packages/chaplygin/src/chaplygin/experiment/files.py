"""Write files atomically, without replacing others unasked."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from flowlanes.errors import InputError
from flowlanes.files.partial_files import partial_file, require_file_name, umask

#: Kinds of files other than regular files, with their tests.
_OTHERS = (
    (stat.S_ISDIR, "a folder"),
    (stat.S_ISCHR, "a device"),
    (stat.S_ISBLK, "a device"),
    (stat.S_ISFIFO, "a pipe"),
    (stat.S_ISSOCK, "a socket"),
)


def check_target(target: Path, force: bool = False) -> None:
    """Raise InputError unless a file may be written to `target`."""
    require_file_name(target)
    status = status_of_target(target)
    if status is not None:
        _check_replaced(target, status, force)


def status_of_target(target: Path) -> os.stat_result | None:
    """The status of a path, following links; None if it does not exist.

    Raises
    ------
    InputError
        If nothing can be written there: a link that leads nowhere, a folder that is missing or
        protected.
    """
    try:
        status: os.stat_result | None = target.stat()
    except FileNotFoundError:
        status = None
    except OSError as problem:
        raise InputError(f"{target} cannot be written: {problem.strerror}") from problem
    if status is None and target.is_symlink():
        raise InputError(f"{target} is a link to a file that is not there: choose another name")
    folder = target.resolve().parent
    if not folder.is_dir():
        raise InputError(f"{target} cannot be written: there is no folder {target.parent}")
    if not os.access(folder, os.W_OK):
        raise InputError(f"{target} cannot be written: the folder {folder} is protected")
    return status


def _check_replaced(target: Path, status: os.stat_result, force: bool) -> None:
    """Raise InputError unless an existing file may be replaced."""
    for holds, what in _OTHERS:
        if holds(status.st_mode):
            raise InputError(f"{target} is {what}: the name of a regular file is needed")
    if not force:
        raise InputError(
            f"{target} exists already: choose another name, or have it "
            "replaced (--force, in Python force=True)"
        )
    _check_writable(target, status)


def check_replaced_store(store: Path) -> None:
    """Raise InputError unless a Zarr store, which is a folder, may be replaced by another."""
    if store.is_symlink():
        raise InputError(f"{store} is a link: give the name of the store itself")
    _check_writable(store, store.stat())


def _check_writable(target: Path, status: os.stat_result) -> None:
    """Raise InputError if a file or folder is marked read-only."""
    # The superuser could write to it nevertheless.
    if not (status.st_mode & 0o222 and os.access(target, os.W_OK)):
        raise InputError(
            f"{target} is read-only and is not replaced: choose another name, or make it writable"
        )


@contextmanager
def atomic_file(target: Path) -> Iterator[Path]:
    """A temporary file that becomes `target` only if the block ends without an error.

    If `target` is a link, the file it points to is replaced; the permissions of a replaced file are
    kept.

    Raises
    ------
    InputError
        If it cannot be written (a protected folder, a full disk, no regular file).
    """
    try:
        place = target.resolve()
        with partial_file(place.parent) as temporary:
            yield temporary
            if place.exists():
                _check_replaced(target, place.stat(), force=True)
                temporary.chmod(stat.S_IMODE(place.stat().st_mode))
            else:
                temporary.chmod(0o666 & ~umask())
            temporary.replace(place)
    except OSError as problem:
        raise InputError(f"{target} cannot be written: {problem.strerror or problem}") from problem

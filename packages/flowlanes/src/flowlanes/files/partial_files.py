"""Partially written files and folders, and locks; those of killed processes are removed.

The name of a partial file contains the process and the machine that write it.  The next process
that writes to the same folder removes the partial files of processes that no longer run, and locks
that are not held.
"""

from __future__ import annotations

import hashlib
import logging
import os
import platform
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path

from ..errors import InputError

_LOG = logging.getLogger(__name__)

#: Suffix of a lock file.
_LOCK = ".flowlanes.lock"

#: Seconds to wait for a lock: another process may hold it for a moment to test it.
_PATIENCE = 0.5

#: Seconds after which an unmodified partial file counts as abandoned, even from another machine.
_OLD = 7 * 86_400.0

_NAME = re.compile(r"\.(?P<machine>[0-9a-f]{8})-(?P<process>\d+)-\w+\.partial")


#: Partial files of this process, and its locks.
_OWN: set[Path] = set()


@contextmanager
def _own(path: Path) -> Iterator[None]:
    _OWN.add(path)
    try:
        yield
    finally:
        _OWN.discard(path)


def remove_own() -> None:
    """Remove the partial files of this process before it ends."""
    for path in list(_OWN):
        with suppress(OSError):
            _remove(path)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


@cache
def _machine() -> str:
    """Machine and container; process ids are unique within both."""
    space = ""
    with suppress(OSError):
        space = os.readlink("/proc/self/ns/pid")  # noqa: PTH115
    return hashlib.sha256(f"{platform.node()} {space}".encode()).hexdigest()[:8]


def _beginning() -> str:
    return f".{_machine()}-{os.getpid()}-"


@contextmanager
def partial_file(folder: Path) -> Iterator[Path]:
    """New file in a folder, removed at the end of the block unless it was renamed."""
    remove_leftovers(folder)
    handle, name = tempfile.mkstemp(dir=folder, prefix=_beginning(), suffix=".partial")
    os.close(handle)
    temporary = Path(name)
    with _own(temporary):
        try:
            yield temporary
        finally:
            temporary.unlink(missing_ok=True)


@contextmanager
def partial_folder(folder: Path) -> Iterator[Path]:
    """New folder in another folder, removed at the end of the block unless it was renamed."""
    remove_leftovers(folder)
    temporary = Path(tempfile.mkdtemp(dir=folder, prefix=_beginning(), suffix=".partial"))
    with _own(temporary):
        try:
            temporary.chmod(0o777 & ~umask())
            yield temporary
        finally:
            shutil.rmtree(temporary, ignore_errors=True)


def umask() -> int:
    """Permission bits that are removed from new files."""
    current = os.umask(0)
    os.umask(current)
    return current


@contextmanager
def write_lock(target: Path, inside: bool = False) -> Iterator[None]:
    """Context in which no other process writes to a folder; the lock ends with the process.

    The lock is a file, which is deleted while it is still locked: a process that waits for a
    deleted file starts over with a new one.

    Parameters
    ----------
    target : Path
        Folder that is written.
    inside : bool
        True for a lock in the folder, which must exist; False for a lock beside it.

    Raises
    ------
    InputError
        If another process has the lock.
    """
    import filelock

    place = target.resolve()
    place = place / _LOCK if inside else place.with_name(f".{place.name}{_LOCK}")
    remove_leftovers(place.parent)
    # filelock would wait if the folder is not writable; this raises the error at once.
    place.touch()
    try:
        with filelock.FileLock(place, timeout=_PATIENCE), _own(place):
            try:
                yield
            finally:
                # Windows cannot delete an open file.
                with suppress(OSError):
                    place.unlink()
    except filelock.Timeout as problem:
        raise InputError(
            f"{target} is being written by another process: wait for it, or choose another name"
        ) from problem


def remove_leftovers(folder: Path) -> None:
    """Remove partial files of killed processes from a folder, and log it."""
    found = []
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith(".") and _is_abandoned(entry):
                _remove(Path(entry.path))
                found.append(entry.name)
    if found:
        _LOG.info("removed from %s what a killed process had left: %s", folder, ", ".join(found))


def _is_abandoned(entry: os.DirEntry[str]) -> bool:
    """True if a partial file is from this program and its process no longer runs."""
    if entry.name.endswith(_LOCK):
        return _is_free(Path(entry.path))
    name = _NAME.fullmatch(entry.name)
    if name is None:
        return False
    written = entry.stat(follow_symlinks=False).st_mtime
    if name["machine"] != _machine():
        return time.time() - written > _OLD
    import psutil

    try:
        # The id may belong to a new process by now.
        return psutil.Process(int(name["process"])).create_time() > written + 1.0
    except psutil.NoSuchProcess:
        return True
    except psutil.Error:
        return False


def _is_free(lock: Path) -> bool:
    """True if a lock is not held by another process; it is then removed while it is held here."""
    import filelock

    try:
        with filelock.FileLock(lock, timeout=0):
            lock.unlink()
    except (filelock.Timeout, OSError):
        return False
    return True


#: True if the operating system reserves file names for devices, and these names.
WINDOWS = sys.platform == "win32"
_DEVICES = {"CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"} | {
    f"{port}{i}" for port in ("COM", "LPT") for i in "123456789¹²³"
}


def require_file_name(path: Path) -> None:
    """Raise InputError if a file name is that of a device, with or without a suffix."""
    if WINDOWS and path.name.partition(".")[0].rstrip().upper() in _DEVICES:
        raise InputError(f"{path} is the name of a device on Windows: choose another name")

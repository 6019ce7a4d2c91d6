"""Files and folders that are being written, and locks; those of a process that was killed go.

What is being written has a name that says which process of which machine writes it.  The next
process that writes into the same folder removes what belongs to none that runs, and locks that
nobody holds.
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

#: The end of the name of a lock.
_LOCK = ".chaplygin.lock"

#: Seconds for which a lock is waited for: another process may be looking whether anybody holds it.
_PATIENCE = 0.5

#: Seconds after which what is no longer written has been left, also by another machine.
_OLD = 7 * 86_400.0

_NAME = re.compile(r"\.(?P<machine>[0-9a-f]{8})-(?P<process>\d+)-\w+\.partial")


#: What this process is writing, and its locks.
_OWN: set[Path] = set()


@contextmanager
def _own(path: Path) -> Iterator[None]:
    _OWN.add(path)
    try:
        yield
    finally:
        _OWN.discard(path)


def remove_own() -> None:
    """Remove what this process is writing, which is about to end in the middle of it."""
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
    """The machine, and the container, within which numbers of processes have a meaning."""
    space = ""
    with suppress(OSError):
        space = os.readlink("/proc/self/ns/pid")  # noqa: PTH115
    return hashlib.sha256(f"{platform.node()} {space}".encode()).hexdigest()[:8]


def _beginning() -> str:
    return f".{_machine()}-{os.getpid()}-"


@contextmanager
def partial_file(folder: Path) -> Iterator[Path]:
    """A new file in a folder, removed at the end of the block unless it was renamed."""
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
    """A new folder in another, removed at the end of the block unless it was renamed."""
    remove_leftovers(folder)
    temporary = Path(tempfile.mkdtemp(dir=folder, prefix=_beginning(), suffix=".partial"))
    with _own(temporary):
        try:
            temporary.chmod(0o777 & ~umask())
            yield temporary
        finally:
            shutil.rmtree(temporary, ignore_errors=True)


def umask() -> int:
    """The permissions that new files are to lack."""
    current = os.umask(0)
    os.umask(current)
    return current


@contextmanager
def write_lock(target: Path, inside: bool = False) -> Iterator[None]:
    """A block in which no other process writes to a folder; the lock ends with the process.

    The lock is a file, which is deleted while it is still locked: who waits for a deleted file
    starts over with a new one.

    Parameters
    ----------
    target : Path
        The folder that is written.
    inside : bool
        Whether the lock is in the folder, which then must be there, and not beside it.

    Raises
    ------
    InputError
        If another process has the lock.
    """
    import filelock

    place = target.resolve()
    place = place / _LOCK if inside else place.with_name(f".{place.name}{_LOCK}")
    remove_leftovers(place.parent)
    # filelock waits where nothing can be written; this says why not
    place.touch()
    try:
        with filelock.FileLock(place, timeout=_PATIENCE), _own(place):
            try:
                yield
            finally:
                # Windows does not delete a file that is open
                with suppress(OSError):
                    place.unlink()
    except filelock.Timeout as problem:
        raise InputError(
            f"{target} is being written by another process: wait for it, or choose another name"
        ) from problem


def remove_leftovers(folder: Path) -> None:
    """Remove what processes that were killed have left in a folder, and say so."""
    found = []
    with suppress(OSError):
        for entry in os.scandir(folder):
            if entry.name.startswith(".") and _is_left(entry):
                _remove(Path(entry.path))
                found.append(entry.name)
    if found:
        _LOG.info("removed from %s what a killed process had left: %s", folder, ", ".join(found))


def _is_left(entry: os.DirEntry[str]) -> bool:
    """Whether something is ours and nobody's who runs."""
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
        # the number of a process that has ended may be that of another one
        return psutil.Process(int(name["process"])).create_time() > written + 1.0
    except psutil.NoSuchProcess:
        return True
    except psutil.Error:
        return False


def _is_free(lock: Path) -> bool:
    """Whether nobody holds a lock; it is removed while it is held here."""
    import filelock

    try:
        with filelock.FileLock(lock, timeout=0):
            lock.unlink()
    except (filelock.Timeout, OSError):
        return False
    return True


#: Whether the system keeps names of files for devices, and the names that it keeps.
WINDOWS = sys.platform == "win32"
_DEVICES = {"CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"} | {
    f"{port}{i}" for port in ("COM", "LPT") for i in "123456789¹²³"
}


def require_file_name(path: Path) -> None:
    """Raise InputError if the name of a file is that of a device, with or without an ending."""
    if WINDOWS and path.name.partition(".")[0].rstrip().upper() in _DEVICES:
        raise InputError(f"{path} is the name of a device on Windows: choose another name")

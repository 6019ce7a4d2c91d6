"""Files kept between processes, believed only where nobody but this user can write.

Machine code and proofs are kept here, so a file counts only if

- every folder on the way to it, links followed, belongs to this user or to root, and nobody else
  can write to it (save in folders such as ``/tmp``, where the sticky bit keeps others from
  removing or renaming what is not theirs);
- the folder it is in and the file itself belong to this user, and nobody else can write to them;
- its first line is the digest of its name and of the rest, so that what was cut, changed or
  renamed by accident is not there at all.

The digest is no signature: whoever can write as this user, or as root, can make one, and can
change the program as well.  A file that does not count is no error: what it held is made again.
"""

from __future__ import annotations

import contextlib
import hashlib
import logging
import os
import stat
import tempfile
from functools import cache
from pathlib import Path

import platformdirs

__all__ = ["home", "read_private", "write_private"]

_OTHERS = stat.S_IWGRP | stat.S_IWOTH
#: A link is not followed, and a pipe is not waited for.
_PLAINLY = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC


def home() -> Path:
    """Where everything is kept; the variable CHAPLYGIN_CACHE overrides the user's own place."""
    chosen = os.environ.get("CHAPLYGIN_CACHE")
    return Path(chosen) if chosen else Path(platformdirs.user_cache_dir("chaplygin"))


def _distrust(place: Path) -> str:
    """Why files in a folder do not count, as the end of a sentence; empty where they do."""
    us = os.geteuid()
    for part in (place, *place.parents):
        status = part.lstat()
        if status.st_uid != us and (part == place or status.st_uid != 0):
            return f"{part} belongs to another user"
        sticky = part != place and status.st_mode & stat.S_ISVTX
        if status.st_mode & _OTHERS and not sticky:
            return f"others can write to {part} (chmod go-w mends it)"
    return ""


def read_private(path: Path) -> bytes | None:
    """What was written to a file, or None where there is none that counts."""
    try:
        place = _usable(path.parent)
        if place is None:
            return None
        handle = os.open(place / path.name, _PLAINLY)
        with os.fdopen(handle, "rb") as stream:
            status = os.fstat(handle)
            plain = stat.S_ISREG(status.st_mode) and not status.st_mode & _OTHERS
            if not plain or status.st_uid != os.geteuid():
                return None
            seal, _, content = stream.read().partition(b"\n")
    except (OSError, ValueError):
        return None
    return content if seal == _seal(path, content) else None


def write_private(path: Path, content: bytes) -> bool:
    """Keep a file, which appears complete or not at all; whether that was possible."""
    temporary = None
    try:
        _make(path.parent)
        place = _usable(path.parent)
        if place is None:
            return False
        with tempfile.NamedTemporaryFile(dir=place, delete=False) as stream:
            temporary = Path(stream.name)
            stream.write(_seal(path, content) + b"\n" + content)
        temporary.replace(place / path.name)
    except (OSError, ValueError):
        if temporary is not None:
            with contextlib.suppress(OSError):
                temporary.unlink(missing_ok=True)
        return False
    return True


def _make(folder: Path) -> None:
    """A folder and those above it, for this user alone whatever the usual permissions are."""
    if not folder.is_dir():
        _make(folder.parent)
        folder.mkdir(mode=0o700, exist_ok=True)


def _seal(path: Path, content: bytes) -> bytes:
    return hashlib.sha256(path.name.encode() + b"\0" + content).hexdigest().encode()


def _usable(folder: Path) -> Path | None:
    """A folder, links followed, if files in it count; where they do not, that is said once."""
    # followed once, so that nobody can turn a link round after the look at where it leads
    place = folder.resolve(strict=True)
    why = _distrust(place)
    if why:
        _say(f"nothing is kept in {folder}, and nothing there is used: {why}")
    return None if why else place


@cache
def _say(sentence: str) -> None:
    logging.getLogger(__name__).warning(sentence)

"""Files that are kept between processes, and are read only if no other user can have written them.

They hold machine code and verdicts, so a file is read only if

- every folder in its path, after links are resolved, belongs to this user or to root, and no
  other user can write to it (except in folders such as ``/tmp``, where because of the sticky bit
  other users cannot remove or rename files of this user);
- its folder and the file itself belong to this user, and no other user can write to them; on
  Windows, where modes contain no information on write access, the folder is inside the home of
  this user instead, to which other users have no access;
- its first line is the digest of its name and content, so that a file that was truncated, changed
  or renamed by accident is not read.

The digest is not a signature: a process of this user, or of root, can compute one, and can also
change the program.  An untrusted file is not an error: its content is computed again.
"""

from __future__ import annotations

import hashlib
import logging
import os
import stat
import sys
from functools import cache
from pathlib import Path

from .partial_files import partial_file

_OTHERS = stat.S_IWGRP | stat.S_IWOTH
#: Flags for opening a file without following a link or waiting for a pipe.
if sys.platform == "win32":
    _OPEN_FLAGS = os.O_RDONLY | os.O_BINARY | os.O_NOINHERIT
else:
    _OPEN_FLAGS = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC


def _distrust(folder: Path) -> str:
    """Reason why files in a folder are not read, to end a sentence; empty if they are read."""
    if sys.platform == "win32":
        home = Path.home().resolve()
        return "" if folder.is_relative_to(home) else f"{folder} is not inside {home}"
    else:
        us = os.geteuid()
        for ancestor in (folder, *folder.parents):
            status = ancestor.lstat()
            if status.st_uid != us and (ancestor == folder or status.st_uid != 0):
                return f"{ancestor} belongs to another user"
            sticky = ancestor != folder and status.st_mode & stat.S_ISVTX
            if status.st_mode & _OTHERS and not sticky:
                return f"others can write to {ancestor} (chmod go-w mends it)"
        return ""


def _is_ours(status: os.stat_result) -> bool:
    """True for a regular file of this user to which no other user can write."""
    regular = stat.S_ISREG(status.st_mode)
    if sys.platform == "win32":
        return regular
    else:
        return regular and status.st_uid == os.geteuid() and not status.st_mode & _OTHERS


def read_private(path: Path) -> bytes | None:
    """Content of a file, or None if there is no trusted file."""
    try:
        folder = _trusted_folder(path.parent)
        if folder is None:
            return None
        handle = os.open(folder / path.name, _OPEN_FLAGS)
        with os.fdopen(handle, "rb") as stream:
            status = os.fstat(handle)
            if not _is_ours(status):
                return None
            seal, _, content = stream.read().partition(b"\n")
    except (OSError, ValueError):
        return None
    return content if seal == _seal(path, content) else None


def write_private(path: Path, content: bytes) -> bool:
    """Write a file as a whole; True if this was possible."""
    try:
        _create(path.parent)
        folder = _trusted_folder(path.parent)
        if folder is None:
            return False
        with partial_file(folder) as temporary:
            temporary.write_bytes(_seal(path, content) + b"\n" + content)
            temporary.replace(folder / path.name)
    except (OSError, ValueError):
        return False
    return True


def _create(folder: Path) -> None:
    """Create a folder and those above it, accessible only to this user for any umask."""
    if not folder.is_dir():
        _create(folder.parent)
        folder.mkdir(mode=0o700, exist_ok=True)


def _seal(path: Path, content: bytes) -> bytes:
    return hashlib.sha256(path.name.encode() + b"\0" + content).hexdigest().encode()


def _trusted_folder(folder: Path) -> Path | None:
    """Folder with links resolved if it can be trusted; otherwise None, with one warning."""
    # resolved first, so that a link cannot be changed after its target has been checked
    resolved = folder.resolve(strict=True)
    why = _distrust(resolved)
    if why:
        _warn_once(f"nothing is kept in {folder}, and nothing there is used: {why}")
    return None if why else resolved


@cache
def _warn_once(sentence: str) -> None:
    logging.getLogger(__name__).warning(sentence)

"""Compiled code stored on disk between processes.

An entry is native code, so it is read only through :mod:`flowlanes.files.private_files`.  Its name
is a digest of everything on which it depends (formulas, tolerance, versions, processor).  A cache
that cannot be read or written is not an error: the code is compiled again.
"""

from __future__ import annotations

import contextlib
import logging
import pickle
import platform
import time
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import TypeVar, cast

from ...files import private_files
from ...files.cache import entry_name, folder

Entry = TypeVar("Entry")

_LOG = logging.getLogger(__name__)

#: Maximum number of entries on disk, and in the memory of this process.
_STORED, _IN_MEMORY = 200, 32


@lru_cache
def _machine() -> str:
    """Operating system and processor, with its instruction sets."""
    info = Path("/proc/cpuinfo")
    if info.exists():
        lines = info.read_text().splitlines()
        processor = {x for x in lines if x.startswith(("flags", "Features", "model"))}
        return "\n".join((platform.platform(), *sorted(processor)))
    return f"{platform.platform()}\n{platform.processor()}"


def code_name(*parts: str) -> str:
    """Name of code determined by `parts`, for this machine and these versions."""
    return entry_name(*parts, _machine())


def _read(path: Path) -> object:
    content = private_files.read_private(path)
    if content is None:
        return None
    with contextlib.suppress(OSError):
        path.touch()
    try:
        return pickle.loads(content)
    except Exception:
        # Incompatible library versions may raise any exception while unpickling.
        return None


def _write(path: Path, entry: object) -> None:
    if not private_files.write_private(path, pickle.dumps(entry)):
        return
    with contextlib.suppress(OSError):
        entries = sorted(path.parent.glob("*.code"), key=lambda p: p.stat().st_mtime)
        for old in entries[:-_STORED]:
            old.unlink(missing_ok=True)


def _file_version(path: Path) -> tuple[int, int] | None:
    """Modification time and size of a file; None if it does not exist."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size


#: Entries in memory, with the version of the file that they were read from or written to.
_in_memory: dict[Path, tuple[object, tuple[int, int] | None]] = {}


def cached_entry(name: str, compute: Callable[[], Entry]) -> tuple[Entry, bool]:
    """Entry called `name`, computed if it does not exist, and whether it existed."""
    path = folder() / f"{name}.code"
    if path in _in_memory and _in_memory[path][1] == _file_version(path):
        return cast("Entry", _in_memory[path][0]), True
    entry = cast("Entry | None", _read(path))
    stored = entry is not None
    if entry is None:
        began = time.perf_counter()
        entry = compute()
        _LOG.debug("machine code compiled in %.2f s", time.perf_counter() - began)
        _write(path, entry)
    else:
        _LOG.debug("machine code read from %s", path)
    if len(_in_memory) >= _IN_MEMORY:
        del _in_memory[next(iter(_in_memory))]
    _in_memory[path] = entry, _file_version(path)
    return entry, stored

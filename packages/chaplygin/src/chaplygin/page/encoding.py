"""Numbers as text, bit for bit: base64 of little-endian doubles, floats or integers."""

from __future__ import annotations

from base64 import b64encode
from zlib import compress

import numpy as np
import numpy.typing as npt


def doubles(numbers: npt.ArrayLike) -> str:
    """Doubles, row by row."""
    return _text(numbers, "<f8")


def floats(numbers: npt.ArrayLike) -> str:
    """Numbers for graphics, as 32-bit floats."""
    return _text(numbers, "<f4")


def integers(numbers: npt.ArrayLike) -> str:
    """Vertex indices, as 32-bit integers."""
    return _text(numbers, "<u4")


def deflate(code: bytes) -> str:
    """Base64 of deflated bytes (zlib)."""
    return b64encode(compress(code, 9)).decode()


def _text(numbers: npt.ArrayLike, kind: str) -> str:
    return b64encode(np.ascontiguousarray(numbers, dtype=kind).tobytes()).decode()

"""Functions of one number and more, in vector instructions: no branches, no tables, no calls.

Every function is written once over an arithmetic, so that doubles and pairs of doubles share it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .simd import Arithmetic, Value, Writer

__all__ = ["FUNCTIONS"]


def _negative(writer: Writer, a: str) -> str:
    """Where the sign bit is set."""
    whole = writer.emit(f"bitcast {writer.type} {a} to {writer.whole}")
    return writer.emit(f"icmp slt {writer.whole} {whole}, zeroinitializer")


def absolute(arithmetic: Arithmetic, x: Value) -> Value:
    """Magnitude."""
    negative = _negative(arithmetic.writer, arithmetic.leading(x))
    return arithmetic.choose(negative, arithmetic.neg(x), x)


FUNCTIONS: Mapping[str, Callable[..., Value]] = {"abs": absolute}

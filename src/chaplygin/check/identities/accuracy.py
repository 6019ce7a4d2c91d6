"""Numbers as balls: whether they are equal, at a precision that suffices."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

from flint import arb, ctx

from ..claim.errors import CheckError

DIGITS = 60
PRECISIONS = (640, 2560, 10240)


class InaccurateError(Exception):
    """Balls are too wide to compare anything."""


T = TypeVar("T")


def _accurate(value: arb) -> bool:
    bound = arb(10) ** -DIGITS
    return bool(value.is_finite() and value.rad() <= bound * max(arb(1), abs(value).lower()))


def agree(first: Sequence[arb], second: Sequence[arb]) -> bool:
    """Whether numbers are equal, as far as their balls show.

    Raises
    ------
    InaccurateError
        If the balls are too wide to decide it.
    """
    if not all(a.overlaps(b) for a, b in zip(first, second, strict=True)):
        return False
    if not all(map(_accurate, [*first, *second])):
        raise InaccurateError
    return True


def with_precision(task: Callable[[], T]) -> T:
    """Do a task with balls that are narrow enough."""
    for precision in PRECISIONS:
        try:
            with ctx.workprec(precision):
                return task()
        except InaccurateError:
            continue
    raise CheckError("the formulas cannot be evaluated accurately enough")

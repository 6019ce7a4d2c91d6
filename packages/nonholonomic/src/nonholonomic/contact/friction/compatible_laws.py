"""Reject combinations of friction laws that exclude each other."""

from __future__ import annotations

from collections.abc import Sequence

from flowlanes.errors import InputError

from .friction_law import FrictionLaw


def require_compatible(laws: Sequence[FrictionLaw]) -> None:
    """Reject friction laws that contradict each other.

    Raises
    ------
    InputError
        If a law is given twice, if one excludes another, such as Contensou's law dry friction at a
        point, or if two laws hold the same: slip, spin or rolling.
    """
    names = [law.name for law in laws]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"friction: the law {name!r} is given twice")
    for law in laws:
        for other, reason in law.excludes.items():
            if other in names:
                raise InputError(f"friction: {reason}")
    for laws_that, hold in (
        ([law for law in laws if law.static_mu is not None], "slip"),
        ([law for law in laws if law.spin_arm], "spin"),
        ([law for law in laws if law.holds_rolling], "rolling"),
    ):
        if len(laws_that) > 1:
            first, second, *_ = (repr(law.name) for law in laws_that)
            raise InputError(
                f"friction: the laws {first} and {second} both hold a contact without {hold}; give "
                "one of them"
            )

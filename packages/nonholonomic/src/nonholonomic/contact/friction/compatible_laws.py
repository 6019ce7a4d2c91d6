"""Which laws of friction exclude each other."""

from __future__ import annotations

from collections.abc import Sequence

from flowlanes.errors import InputError

from .friction_law import FrictionLaw


def require_compatible(laws: Sequence[FrictionLaw]) -> None:
    """Refuse laws that say two things of one motion.

    Raises
    ------
    InputError
        If a law is given twice, if Contensou's law stands beside dry friction at a point or a spin
        couple of its own, or if two laws hold the same: slip, spin or rolling.
    """
    names = [law.name for law in laws]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"friction: the law {name!r} is given twice")
    for other in ("coulomb", "spin"):
        if "contensou" in names and other in names:
            raise InputError(
                "friction: a patch of contact has its own law of sliding and spinning; "
                f"it excludes the law {other!r}"
            )
    for laws_that, hold in (
        ([law for law in laws if law.static_mu is not None], "slip"),
        ([law for law in laws if law.spin_arm], "spin"),
    ):
        if len(laws_that) > 1:
            first, second, *_ = (repr(law.name) for law in laws_that)
            raise InputError(
                f"friction: the laws {first} and {second} both hold a contact without {hold}; give "
                "one of them"
            )
    if "slip" in names and "power" in names:
        raise InputError("friction: two laws in proportion to the normal force and a power of slip")
    if "rolling" in names and "contour" in names:
        raise InputError("friction: resistance to rolling excludes resistance along the contour")

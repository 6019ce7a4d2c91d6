"""Number types of a working precision: doubles, or numbers with 34 digits."""

from __future__ import annotations

from typing import Any, Literal, TypeAlias

import numpy.typing as npt

from ...errors import InputError
from ...system.tolerance import Precision

Direction = Literal["forward", "backward"]

#: A number of the working precision: a double, or a 34-digit number of heyoka; and arrays.
WorkingNumber: TypeAlias = Any
WorkingArray: TypeAlias = npt.NDArray[Any]


class PrecisionError(InputError):
    """Raised if the number type of a precision is not available."""


def number_type(precision: Precision) -> type[WorkingNumber]:
    """Number type of a precision: float, or 34 digits.

    Raises
    ------
    PrecisionError
        If heyoka is not installed, or has no 34-digit numbers on this machine.
    """
    if precision == "double":
        return float
    try:
        import heyoka as hy
    except ImportError:
        raise PrecisionError(
            "precision 'quad' with method 'taylor' needs heyoka, which is not installed: install "
            "flowlanes[taylor], or use method 'gauss', which has 30 digits"
        ) from None
    wide: type[WorkingNumber] | None = getattr(hy, "real128", None)
    if wide is None:
        raise PrecisionError("precision 'quad' is not available on this machine; use 'double'")
    return wide

"""The digits needed for a state far away in time, and times as balls."""

from __future__ import annotations

import math

from flint import arb, fmpq

from flowlanes.arguments import NumberOrText
from flowlanes.errors import InputError
from flowlanes.formulas.balls import exact

#: Maximum number of digits carried.
MOST = 100


def exact_time(time: NumberOrText) -> arb:
    """A time as a ball."""
    if isinstance(time, arb):
        return time
    value = exact(time)
    return arb(fmpq(value.numerator, value.denominator))


def working_digits(time: NumberOrText, digits: int, powers: int, phase_rate: float) -> int:
    """Working digits for which `digits` remain when errors grow like a power of the time.

    Parameters
    ----------
    time : number
    digits, powers : int
    phase_rate : float
        The rate of the fastest phase of the motion.

    Raises
    ------
    InputError
        If more are needed than are carried.
    """
    large = abs(float(exact_time(time).mid()))
    grown = digits + powers * max(0, math.ceil(math.log10(large * phase_rate + 1))) + 5
    wanted = 10 * -(-grown // 10)
    if wanted > MOST:
        raise InputError(
            f"{digits} digits at time {large:g} need {wanted} digits of the start: at most {MOST} "
            "are carried"
        )
    return wanted

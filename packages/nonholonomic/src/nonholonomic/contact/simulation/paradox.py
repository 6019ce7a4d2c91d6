"""Describe Painlevé's paradox: time, position, and the determinant that is not positive."""

from __future__ import annotations

import numpy as np

from flowlanes.system.arrays import FloatArray

from .compiled import ATTITUDE, POSITION, ContactNumbers

#: Coordinates of the contact below this fraction of the body size count as rounding.
_ROUNDING = 1e-12


def paradox_words(
    time: float,
    numbers: ContactNumbers,
    state: FloatArray,
    response: float,
    is_jam: bool,
) -> str:
    """Explain in one sentence why no motion in contact is possible.

    Parameters
    ----------
    time : float
    numbers : ContactNumbers
        At `state`.
    state : array (size,)
    response : float
        B, the normal acceleration of the contact for each unit of normal force (1/kg): the
        determinant of the one condition on the normal force.
    is_jam : bool
        Whether B has fallen to zero along the motion, rather than being negative at once.
    """
    from scipy.spatial.transform import Rotation

    turn = Rotation.from_quat(state[ATTITUDE], scalar_first=True)
    place = state[POSITION] + turn.apply(numbers.r)
    place = np.where(np.abs(place) < _ROUNDING * np.linalg.norm(numbers.r), 0.0, place)
    where = ", ".join(f"{x:.6g}" for x in place)
    fate = (
        "has fallen to zero, so that the normal force grows beyond all bounds"
        if is_jam
        else "is not positive, so that the friction of any normal force presses the body into "
        "the support"
    )
    return (
        f"no motion in contact is possible at t = {time:.9g} s with the contact at ({where}) m "
        f"(Painlevé's paradox: the normal acceleration of the contact for each unit of normal "
        f"force, B = {response:.6g} /kg, {fate})"
    )

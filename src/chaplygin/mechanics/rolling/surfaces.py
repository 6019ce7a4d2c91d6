"""Surfaces on which a body rolls."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ...arguments import arguments_checked
from ...errors import InputError

__all__ = ["Plane", "Sphere", "Surface"]


@dataclass(frozen=True)
class Plane:
    """The horizontal plane z = 0, with the body above it.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.Body(1.0, (0.4, 0.5, 0.6), ch.Ball(1.0))
    >>> ch.roll(ball, ch.Plane(), field=ch.Forces(gravity=9.81)).state  # gamma is the vertical
    (M, gamma)
    """

    words = "a horizontal plane"


@arguments_checked
@dataclass(frozen=True)
class Sphere:
    """A fixed sphere about the origin of space.

    Parameters
    ----------
    radius : float
        Signed radius a (m): positive when the body rolls on its outside (a dome), negative when it
        rolls on its inside (a bowl).

    Raises
    ------
    InputError
        If the radius is zero or not finite.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.Body(1.0, (0.4, 0.5, 0.6), ch.Ball(1.0))
    >>> bowl = ch.Sphere(-3.0)
    >>> ch.roll(ball, bowl, field=ch.Forces(gravity=9.81)).state  # zeta: the vertical, body axes
    (M, gamma, zeta)
    """

    radius: float

    def __post_init__(self) -> None:
        if not math.isfinite(self.radius) or self.radius == 0:
            raise InputError(
                f"radius {self.radius} of the supporting sphere: it must be a finite number, "
                "positive for rolling outside, negative for rolling inside"
            )

    @property
    def words(self) -> str:
        """The surface as a sentence names it."""
        return f"the {'outside' if self.radius > 0 else 'inside'} of a fixed sphere"


Surface = Plane | Sphere

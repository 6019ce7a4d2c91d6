"""Surfaces on which a body rolls."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from ...arguments import arguments_checked
from ...errors import InputError


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
        Positive (m).
    side : ``"outside"`` or ``"inside"``
        Whether the body rolls on the outside (a dome) or on the inside (a bowl).

    Raises
    ------
    InputError
        If the radius is not a positive finite number.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.Body(1.0, (0.4, 0.5, 0.6), ch.Ball(1.0))
    >>> bowl = ch.Sphere(3.0, side="inside")
    >>> ch.roll(ball, bowl, field=ch.Forces(gravity=9.81)).state  # zeta: the vertical, body axes
    (M, gamma, zeta)
    """

    radius: float
    side: Literal["outside", "inside"] = "outside"

    def __post_init__(self) -> None:
        if self.side not in ("outside", "inside"):
            raise InputError(f"side {self.side!r}: it must be 'outside' or 'inside'")
        if not (math.isfinite(self.radius) and self.radius > 0):
            instead = ""
            if math.isfinite(self.radius) and self.radius < 0:
                instead = f'; for the inside write Sphere({-self.radius!r}, side="inside")'
            raise InputError(
                f"radius {self.radius} of the supporting sphere: it must be a positive finite "
                f"number{instead}"
            )

    @classmethod
    def of_signed_radius(cls, a: float) -> Sphere:
        """The sphere with the radius a of the equations, which is negative inside."""
        return cls(abs(a), "inside" if a < 0 else "outside")

    @property
    def signed_radius(self) -> float:
        """The radius a of the equations, negative inside."""
        return self.radius if self.side == "outside" else -self.radius

    @property
    def words(self) -> str:
        """The surface as a sentence names it."""
        return f"the {self.side} of a fixed sphere"


Surface = Plane | Sphere

"""Surfaces on which a body rolls."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError


@arguments_checked
@dataclass(frozen=True)
class Plane:
    """The horizontal plane z = 0, with the body above it.

    Parameters
    ----------
    turntable : float
        Angular velocity with which it turns about the z axis (rad/s); only a contact with
        friction can be on a turning support.

    Raises
    ------
    InputError
        If the angular velocity is not finite.

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    >>> nonholonomic.roll(
    ...     ball, nonholonomic.Plane(), field=nonholonomic.Forces(gravity=9.81)
    ... ).state  # gamma is the vertical
    (M, gamma)
    """

    turntable: float = 0.0
    words = "a horizontal plane"

    def __post_init__(self) -> None:
        _require_turn(self.turntable)


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
    turntable : float
        Angular velocity with which it turns about the z axis (rad/s), as for :class:`Plane`.

    Raises
    ------
    InputError
        If the radius is not a positive finite number, or the angular velocity not finite.

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    >>> bowl = nonholonomic.Sphere(3.0, side="inside")
    >>> nonholonomic.roll(
    ...     ball, bowl, field=nonholonomic.Forces(gravity=9.81)
    ... ).state  # zeta: the vertical, body axes
    (M, gamma, zeta)
    """

    radius: float
    side: Literal["outside", "inside"] = "outside"
    turntable: float = 0.0

    def __post_init__(self) -> None:
        _require_turn(self.turntable)
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
    @arguments_checked
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


def _require_turn(turntable: float) -> None:
    if not math.isfinite(turntable):
        raise InputError(f"turntable {turntable}: it must be a finite angular velocity")


Surface = Plane | Sphere

"""A ball on a plane, driven from inside by rotors, a pendulum or a moving mass."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.parsing import parse
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.vectors import real_symbol

from ..mechanics.rolling.body import check_mass
from ..mechanics.rolling.inertia import check_inertia
from ..mechanics.shapes.shape_base import check_centre, require_positive

Contact = Literal["marble", "rubber"]


@arguments_checked
@dataclass(frozen=True)
class Rotor:
    """A symmetric rotor with its axis fixed anywhere in the ball.

    Parameters
    ----------
    axis : 3 floats
        Direction of the axis, body axes; it need not be a unit vector.
    inertia : float
        Moment of inertia i > 0 about the axis (kg m²).  At the speed u relative to the ball the
        rotor adds i u e to the angular momentum, e the unit vector of the axis.

    Raises
    ------
    InputError
        If the axis is zero, or the moment of inertia is not positive.

    Examples
    --------
    >>> from nonholonomic.control import Rotor
    >>> Rotor((0, 0, 2), 0.01).momentum
    (0, 0, 1/100)
    """

    axis: tuple[float, float, float]
    inertia: float

    def __post_init__(self) -> None:
        axis = tuple(self.axis)
        if len(axis) != 3 or not all(map(math.isfinite, axis)) or not any(axis):
            raise InputError(
                f"rotor axis {axis}: it must be three finite numbers that are not all zero"
            )
        require_positive("rotor", **{"moment of inertia": self.inertia})
        object.__setattr__(self, "axis", axis)

    @property
    def momentum(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """i e, the angular momentum at unit speed, body axes."""
        entries = [exact_number(x) for x in self.axis]
        length = sp.sqrt(sp.Add(*(x**2 for x in entries)))
        x, y, z = (exact_number(self.inertia) * entry / length for entry in entries)
        return x, y, z


@arguments_checked
@dataclass(frozen=True)
class MovingMass:
    """A point mass moved inside the ball by joints.

    Parameters
    ----------
    mass : float
        In kg, > 0; not part of the mass of the ball.
    place : 3 formulas in text
        Its position from the geometric centre (m), body axes, in the coordinates of the joints.
    joints : tuple of str
        Names of the coordinates; their speeds are controls.
    start : tuple of float
        Initial values of the joints for a planner.

    Raises
    ------
    InputError
        If the mass is not positive, a formula cannot be read, or the joints do not move the mass
        in as many directions as there are joints.

    Examples
    --------
    >>> from nonholonomic.control import MovingMass
    >>> MovingMass(0.5, ("s", "0", "-1/10"), ("s",), (0.0,)).formulas
    (s, 0, -1/10)
    """

    mass: float
    place: tuple[str, str, str]
    joints: tuple[str, ...]
    start: tuple[float, ...]

    def __post_init__(self) -> None:
        check_mass(self.mass)
        for name in ("place", "joints", "start"):
            object.__setattr__(self, name, tuple(getattr(self, name)))
        if len(self.place) != 3 or not self.joints or len(self.start) != len(self.joints):
            raise InputError(
                f"moving mass: it needs three formulas for its place, at least one joint and a "
                f"start for each joint; there are {len(self.place)}, {len(self.joints)} and "
                f"{len(self.start)}"
            )
        if len(set(self.joints)) < len(self.joints):
            raise InputError(f"moving mass: the joints {', '.join(self.joints)} need unlike names")
        if sp.Matrix(self.formulas).jacobian(self.symbols).rank() < len(self.joints):
            raise InputError(
                f"moving mass: the joints {', '.join(self.joints)} do not move it in "
                f"{len(self.joints)} independent directions"
            )

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The coordinates of the joints."""
        return tuple(real_symbol(name) for name in self.joints)

    @property
    def formulas(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """The position from the geometric centre, body axes."""
        names = {str(s): s for s in self.symbols}
        x, y, z = (parse(text, names, "place of the moving mass") for text in self.place)
        return x, y, z


@arguments_checked
def pendulum(mass: float, length: float) -> MovingMass:
    """A pendulum on an axle through the centre, driven about the axle and perpendicular to it.

    Parameters
    ----------
    mass : float
        Mass of the bob (kg).
    length : float
        Distance from the centre to the bob (m).

    Returns
    -------
    MovingMass
        The joints are ``theta``, the angle about the axle along body axis 2, and ``phi``, the
        inclination towards an end of the axle; at (0, 0) the pendulum points along −e₃.

    Raises
    ------
    InputError
        If mass or length are not positive.

    Examples
    --------
    >>> from nonholonomic.control import pendulum
    >>> pendulum(1.0, 0.5).formulas
    (-sin(theta)*cos(phi)/2, sin(phi)/2, -cos(phi)*cos(theta)/2)
    """
    require_positive("pendulum", length=length)
    ell = exact_number(length)
    return MovingMass(
        mass,
        (
            f"-({ell})*cos(phi)*sin(theta)",
            f"({ell})*sin(phi)",
            f"-({ell})*cos(phi)*cos(theta)",
        ),
        ("theta", "phi"),
        (0.0, 0.0),
    )


@arguments_checked
@dataclass(frozen=True)
class SphericalRobot:
    """A ball on a plane with rotors and possibly a moving mass inside.

    Parameters
    ----------
    mass : float
        Mass of the ball with its rotors, without the moving mass (kg).
    inertia : 3 floats or 3×3 floats
        Inertia of the same about its centre of mass, body axes (kg m²), with the rotors fixed.
    radius : float
        In m.
    rotors : tuple of Rotor
    contact : ``"marble"`` or ``"rubber"``
        Rolling without slip, or also without spin about the vertical.
    moving_mass : MovingMass, optional
    centre : 3 floats
        Geometric centre minus centre of mass, body axes (m); zero for a balanced ball.
    gravity : float
        In m/s²; without influence on a balanced ball without moving mass.

    Raises
    ------
    InputError
        If nothing moves inside, the axes of the rotors are dependent, or a number is out of range.

    Examples
    --------
    >>> from nonholonomic.control import Rotor, SphericalRobot
    >>> axes = ((1, 0, 0), (0, 1, 0))
    >>> robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, tuple(Rotor(e, 0.1) for e in axes))
    >>> robot.is_balanced
    True
    """

    mass: float
    inertia: tuple[float, float, float] | tuple[tuple[float, ...], ...]
    radius: float
    rotors: tuple[Rotor, ...] = ()
    contact: Contact = "marble"
    moving_mass: MovingMass | None = None
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0)
    gravity: float = 0.0

    def __post_init__(self) -> None:
        check_mass(self.mass)
        check_inertia(self.inertia)
        require_positive("ball", radius=self.radius)
        check_centre(self.centre)
        object.__setattr__(self, "rotors", tuple(self.rotors))
        if not math.isfinite(self.gravity):
            raise InputError(f"gravity {self.gravity}: it must be a finite number")
        if not self.rotors and self.moving_mass is None:
            raise InputError(
                "spherical robot: it has no rotor and no moving mass; give one of them"
            )
        if self.gyration.rank() < len(self.rotors):
            axes = ", ".join(str(rotor.axis) for rotor in self.rotors)
            raise InputError(
                f"spherical robot: the axes {axes} of the rotors are linearly dependent; rotors "
                "about dependent axes act as fewer ones"
            )

    @property
    def tensor(self) -> np.ndarray:
        """The inertia tensor about the centre of mass, 3×3, body axes."""
        array = np.asarray(self.inertia, dtype=float)
        return np.diag(array) if array.ndim == 1 else array

    @property
    def gyration(self) -> sp.Matrix:
        """K of k = K u, whose columns are i_a e_a."""
        return sp.Matrix(3, len(self.rotors), lambda i, a: self.rotors[a].momentum[i])

    @property
    def is_balanced(self) -> bool:
        """Whether the centre of mass is the geometric centre for all values of the controls."""
        return self.moving_mass is None and not any(self.centre)

"""Decide whether a robot whose motion has a drift is accessible.

The rates are not affine in the speeds of rotors and joints (ω depends on them, and Ṁ on products of
ω with them), but the speeds themselves can be taken as states, and their rates as the controls v:

    ẋ = f(x, u),   u̇ = v.

If f and the fields ∂/∂u, together with all their commutators, span the state space, the states
reachable from a generic one contain an open set (Sussmann and Jurdjevic).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.vectors import real_symbol

from ..mechanics.constraints.distribution import Distribution
from ..mechanics.constraints.growth import generic
from .equations import controlled_system
from .robot import SphericalRobot


@dataclass(frozen=True)
class Accessibility:
    """The dimensions spanned by drift and controls of a robot.

    Attributes
    ----------
    growth : tuple of int
        Dimensions spanned at a generic state by the drift and the controls, with the commutators of
        two, of three, …, up to the step at which they stop growing.
    dimension : int
        Dimension of the state space: attitude, position, M, joints, and the speeds of rotors and
        joints.
    exact : bool
        Whether the growth was computed with rational numbers at a point; otherwise modulo a prime,
        which gives lower bounds.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.control import SphericalRobot, accessibility, pendulum
    >>> robot = SphericalRobot(
    ...     1.0, (0.4, 0.4, 0.4), 1.0, moving_mass=pendulum(1.0, 0.5), gravity=9.81
    ... )
    >>> verdict = accessibility(robot)
    >>> isinstance(verdict, nonholonomic.control.Accessibility), verdict.growth
    (True, (3, 5, 9, 12))
    """

    growth: tuple[int, ...]
    dimension: int
    exact: bool

    @property
    def accessible(self) -> bool:
        """Whether the state space is spanned; proven, as computed dimensions are lower bounds."""
        return self.growth[-1] == self.dimension

    def __str__(self) -> str:
        spans = f"drift and controls span {', '.join(map(str, self.growth))} of {self.dimension}"
        if self.accessible:
            return f"{spans} dimensions: accessible from generic states, proven"
        return f"{spans} dimensions: not all of the state space"


@arguments_checked
def accessibility(robot: SphericalRobot) -> Accessibility:
    """The growth of drift and controls of a robot, with any momentum.

    Accessibility is weaker than controllability: whether one given state can be reached from
    another is not decided.

    Parameters
    ----------
    robot : SphericalRobot

    Returns
    -------
    Accessibility
        For a balanced ball the momentum is constant, so that the state space is not spanned; see
        :func:`~nonholonomic.control.controllable.controllability` for motions from rest.

    Raises
    ------
    InputError
        If a joint has the name of another variable.

    Examples
    --------
    >>> from nonholonomic.control import SphericalRobot, accessibility, pendulum
    >>> robot = SphericalRobot(
    ...     1.0, (0.4, 0.4, 0.4), 1.0, moving_mass=pendulum(1.0, 0.5), gravity=9.81
    ... )
    >>> accessibility(robot).growth
    (3, 5, 9, 12)
    """
    system = controlled_system(robot)
    rates = dict(flat_pairs(system.field))
    fields = (
        {name: rate for name, rate in rates.items() if rate != 0},
        *({u: sp.S.One} for u in system.inputs),
    )
    parameters = tuple((p.symbol, p.default) for p in system.parameters)
    found = generic(
        Distribution(
            "drift and controls",
            (*system.state, *system.inputs),
            system.relations,
            tuple(real_symbol(f"c_{i}") for i, _ in enumerate(fields)),
            fields,
            steps=flat_pairs(system.definitions),
            constants=parameters,
        )
    )
    return Accessibility(found.growth, found.dimension, found.exact)

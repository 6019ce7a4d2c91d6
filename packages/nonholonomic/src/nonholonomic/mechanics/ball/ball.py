"""A homogeneous ball with its surface, its forces and their numerical values."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.arguments import FormulaParameters, arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.named_formulas import by_name, scalars
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import constant, norm_squared, real_symbol, vectors

from ..formula_parameters import formula_parameters
from ..rolling.body import check_mass
from ..rolling.inertia import check_inertia
from .equations import (
    Carrier,
    Contact,
    Kinematics,
    ball_equations,
    ball_parameters,
    centre_surface,
    supporting_surface,
)
from .surface import SmoothSurface

R, x, omega, v = vectors("R x omega v")
m, mu, b, g, ell, Delta = (real_symbol(name) for name in ("m", "mu", "b", "g", "ell", "Delta"))
down = tuple(real_symbol(f"e_{i}") for i in (1, 2, 3))


@arguments_checked
@dataclass(frozen=True, kw_only=True)
class RollingBall:
    """A homogeneous ball on a surface.

    Parameters
    ----------
    mass, inertia, radius : float
        m (kg), the moment of inertia μ about any axis through the centre (kg m²), and b (m).
    surface : SmoothSurface
    carrier : ``"support"`` or ``"centre"``
        Whether `surface` carries the ball, or is the one on which its centre moves.
    contact : ``"marble"`` or ``"rubber"``
        No slip; or no slip and no spin about the normal.
    gravity : float
        Acceleration g (m/s²).
    direction : 3 floats
        Direction of gravity in space axes; it need not be a unit vector.
    potential : sympy.Expr
        U in ``R_1``, ``R_2``, ``R_3``, the place of the centre; it may use m and `parameters`.
    parameters : mapping of str or Symbol to float, or sequence of Parameter
        Further symbols in `potential`, with their values.

    Raises
    ------
    InputError
        If a number is not admissible, or the ball is too large for the inside of the surface.

    Examples
    --------
    >>> import lawproof
    >>> import nonholonomic
    >>> from nonholonomic.mechanics.ball.surface import CircularCylinder
    >>> pipe = CircularCylinder(3.0, side="inside")
    >>> ball = nonholonomic.RollingBall(
    ...     mass=1.0, inertia=0.4, radius=1.0, surface=pipe, gravity=9.81
    ... )
    >>> [(verdict.law, verdict.decision) for verdict in lawproof.prove_all(ball.system())]
    [('energy', 'proven'), ('volume', 'proven')]
    """

    mass: float
    inertia: float
    radius: float
    surface: SmoothSurface
    carrier: Carrier = "support"
    contact: Contact = "marble"
    gravity: float = 0.0
    direction: tuple[float, float, float] = (0.0, 0.0, -1.0)
    potential: sp.Expr = sp.S.Zero
    parameters: FormulaParameters = ()

    def __post_init__(self) -> None:
        declared = formula_parameters(self.parameters, "number in the potential")
        object.__setattr__(self, "parameters", declared)
        check_mass(self.mass)
        check_inertia((self.inertia,) * 3)
        if not (math.isfinite(self.radius) and self.radius > 0):
            raise InputError(f"radius {self.radius}: it must be a positive finite number")
        if not (math.isfinite(self.gravity) and self.gravity >= 0):
            raise InputError(f"gravity {self.gravity}: it must be finite and not negative")
        if not (all(map(math.isfinite, self.direction)) and any(self.direction)):
            raise InputError(
                f"direction {self.direction}: it must be three finite numbers, not all zero"
            )
        known = (*R.symbols, m, *(p.symbol for p in self.parameters))
        object.__setattr__(self, "potential", by_name(self.potential, known))
        limit = self.surface.widest
        if self.carrier == "support" and limit is not None and self.radius >= limit:
            raise InputError(
                f"radius: {self.radius:.15g} is too large for a ball inside this surface; it must "
                f"be smaller than {limit:.15g}"
            )

    @property
    def has_forces(self) -> bool:
        """Whether any force acts besides the contact."""
        return bool(self.gravity) or self.potential != 0

    @cached_property
    def kinematics(self) -> Kinematics:
        """The surface in the state variables: R if the centre's surface has an equation, else x."""
        offset = b if self.carrier == "support" else sp.S.Zero
        equation = self.surface.equation(R.symbols, offset)
        if equation is not None:
            return centre_surface(equation)
        return supporting_surface(self.carrying)

    @cached_property
    def carrying(self) -> sp.Expr:
        """The equation in x of the given surface, the supporting one or that of the centre."""
        equation = self.surface.equation(x.symbols)
        if equation is None:
            raise InputError(f"{type(self.surface).__name__} has no equation")
        return equation

    @property
    def all_parameters(self) -> tuple[Parameter, ...]:
        """The parameters of ball, surface, potential and gravity."""
        parameters = [
            *ball_parameters(self.mass, self.inertia, self.radius),
            *self.surface.parameters,
            *self.parameters,
        ]
        if self.gravity:
            parameters.append(
                Parameter(g, "acceleration of gravity", self.gravity, "m/s^2", (g >= 0,))
            )
            if not self._along_axis:
                parameters += [
                    Parameter(s, f"direction of gravity, axis {axis}", value)
                    for s, value, axis in zip(down, self._unit, "xyz", strict=True)
                    if value
                ]
        return tuple(parameters)

    @property
    def _unit(self) -> tuple[float, ...]:
        length = math.hypot(*self.direction)
        return tuple(value / length for value in self.direction)

    @property
    def _along_axis(self) -> bool:
        return sum(map(bool, self.direction)) == 1

    @property
    def _gravity_direction(self) -> MatrixExpr:
        """The direction of gravity: numbers if it is along an axis, parameters otherwise."""
        if self._along_axis:
            return constant([int(value) for value in self._unit])
        pairs = zip(down, self._unit, strict=True)
        return constant([symbol if value else 0 for symbol, value in pairs])

    @cached_property
    def height(self) -> sp.Expr:
        """The potential energy at the centre R."""
        if not self.gravity:
            return self.potential
        fallen = sp.Add(
            *(d * s for d, s in zip(scalars(self._gravity_direction), R.symbols, strict=True))
        )
        return self.potential - m * g * fallen

    @property
    def force(self) -> MatrixExpr:
        """The force at the centre, space axes."""
        weight = m * g * self._gravity_direction if self.gravity else constant([0, 0, 0])
        return weight - gradient(self.potential, R) if self.potential != 0 else weight

    @arguments_checked
    def system(
        self, name: str = "ball-on-surface", title: str = "Homogeneous ball on a surface"
    ) -> System:
        """The equations of motion, with the energy and the invariant measure.

        Without forces besides the contact the surface holds the ball on both sides, and the sign
        of the normal force is not watched.
        """
        kinematics = self.kinematics
        system = ball_equations(
            self.contact, kinematics, self.force, self.all_parameters, name, title
        )
        watched = tuple(item for item in system.guards if self.has_forces or not item.lift_off)
        surface, symbols = kinematics.surface, kinematics.surface.free_symbols
        on_surface = Integral("surface", surface, "the ball stays on its surface", source="(2.7)")
        # proofs reduce modulo polynomial relations; any other f is stated as an integral instead
        polynomial = surface.is_rational_function(*symbols)
        return replace(
            system,
            relations=(surface, *system.relations) if polynomial else system.relations,
            guards=watched + self.surface.domain(kinematics.place.symbols),
            laws=self._laws() if polynomial else (*self._laws(), on_surface),
        )

    def _laws(self) -> tuple[Law, ...]:
        half = sp.Rational(1, 2)
        energy = half * m * norm_squared(v) + half * mu * norm_squared(omega) + self.height
        # the area of f = 0 is |df| δ(f) dx with |df| = ell; for rubber the plane (ω, df) = 0 of ω
        # gives a second factor ell
        density: dict[sp.Symbol, int] = {ell: 1 if self.contact == "marble" else 2}
        if self.kinematics.fit is not None:
            density[Delta] = 1
        return (
            Integral("energy", energy, "energy", source="Theorem 1", unit="J"),
            Measure("volume", density, "area of the surface times volume of ω", source="§2.3"),
        )

"""The formulas of a rubber body of revolution on a plane, evaluated in balls (§5).

With u = γ₃ = cos θ and the height p(u) of the centre of mass above the plane,

    B = I₁ + m(p² + (1 − u²)p′²),   A² = I₁u² + I₃(1 − u²) + mp²,   U = mgp + V(u),
    u̇² = (2(h − U)(1 − u²) − K²)/B,   K = Aω₃.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import sympy as sp
from flint import acb, arb, ctx, fmpq

from flowlanes.arguments import NumberOrText
from flowlanes.errors import InputError
from flowlanes.formulas.balls import exact
from flowlanes.formulas.relative_zero import vanishes
from flowlanes.system.vectors import real_symbol, vectors

from ...mechanics.rolling.equations import RollingBody
from ...mechanics.shapes.surfaces import Plane
from ..one_degree.divided_differences import Argument, value
from ..one_degree.formula import program
from ..one_degree.uniformisation import Equation

#: Precision in bits of constants of the motion and turning points.
BITS = 700

gamma, c = vectors("gamma c")
m, g, R, rho = (real_symbol(s) for s in ("m", "g", "R", "rho"))
I_1, I_2, I_3, b_1, b_2, b_3 = (real_symbol(s) for s in ("I_1", "I_2", "I_3", "b_1", "b_2", "b_3"))
u = gamma.symbols[2]
c_3 = c.symbols[2]


@dataclass(frozen=True)
class AxisymmetricBody:
    """A body of revolution with rubber contact on a plane.

    Attributes
    ----------
    support : sympy.Expr
        Distance of the tangent plane from the geometric centre, in ``gamma_3``.
    potential : sympy.Expr
        V, in ``gamma_3``.
    values : mapping of Symbol to flint.arb
        Every parameter.
    flat : bool
        Whether the body has a flat face, on which the equations end.
    """

    support: sp.Expr
    potential: sp.Expr
    values: Mapping[sp.Symbol, arb]
    flat: bool

    @cached_property
    def height(self) -> sp.Expr:
        """The formula p, in ``gamma_3``."""
        return self.support - (c_3 * u if c_3 in self.values else 0)

    @cached_property
    def energy(self) -> sp.Expr:
        """The formula U, in ``gamma_3``."""
        return (m * g * self.height if g in self.values else sp.S.Zero) + self.potential

    @cached_property
    def principal(self) -> sp.Expr:
        """The formula B."""
        p = self.height
        return I_1 + m * (p**2 + (1 - u**2) * p.diff(u) ** 2)

    @cached_property
    def square(self) -> sp.Expr:
        """The formula A²."""
        return I_1 * u**2 + I_3 * (1 - u**2) + m * self.height**2

    def value(self, formula: sp.Expr, x: Argument) -> Argument:
        """The value of one of these formulas at u = x."""
        result: Argument = program(formula)({**self.values, u: x})
        return result

    def p(self, x: acb) -> acb:
        """The height at a point."""
        return value(partial(self.value, self.height), x)

    def A(self, x: acb) -> acb:
        """A at a point."""
        return value(partial(self.value, self.square), x).sqrt(analytic=True)

    def require_convex(self, low: arb, high: arb) -> None:
        """Raise an error if the contact leaves the convex part of the body during a motion.

        Raises
        ------
        InputError
            With the γ₃ at which it does.
        """
        parallel = self.support - u * self.support.diff(u)
        meridian = parallel + (1 - u**2) * self.support.diff(u, 2)
        if self.flat or not meridian.has(u):
            return
        waiting = [(low.lower(), high.upper())]
        while waiting:
            left, right = waiting.pop()
            ball = left.union(right)
            if all(self.value(radius, ball) > 0 for radius in (parallel, meridian)):
                continue
            middle = ((left + right) / 2).mid()
            if (
                any(not self.value(r, middle) > 0 for r in (parallel, meridian))
                or right - left < 1e-9
            ):
                raise InputError(
                    f"the contact leaves the convex part of the body at gamma_3 = "
                    f"{float(middle):.6g}: the closed form needs positive radii of curvature all "
                    "along the motion"
                )
            waiting += [(left, middle), (middle, right)]


@dataclass(frozen=True)
class Level:
    """Values of the integrals.

    Attributes
    ----------
    body : AxisymmetricBody
    h, K : flint.arb
        Energy, and K = Aω₃; K is exactly zero if it is zero to the digits of the start.
    """

    body: AxisymmetricBody
    h: arb
    K: arb

    @cached_property
    def equation(self) -> Equation:
        """The equation of u = γ₃."""
        body, h, K = self.body, self.h, self.K

        def inner(x: Argument) -> Argument:
            return 2 * (h - body.value(body.energy, x))

        def numerator(x: Argument) -> Argument:
            return inner(x) * (1 - x * x) - K * K

        def denominator(x: Argument) -> Argument:
            return body.value(body.principal, x)

        # For K = 0 the factor 1 − u² of N is split off: the axis passes through the vertical at u =
        # ±1, which is no turning point of the motion in space.
        if K != 0 or body.flat:
            return Equation(numerator, denominator, arb(-1), arb(1))
        return Equation(numerator, denominator, arb(-1), arb(1), inner, (True, True))


def body_of(
    rolling: RollingBody, parameters: Mapping[sp.Symbol, NumberOrText]
) -> AxisymmetricBody | None:
    """The rubber body of revolution on a plane, or None for any other body.

    Parameters
    ----------
    rolling : RollingBody
        Kind of shape, surface, contact and field; its numbers are not used.
    parameters : mapping of Symbol to number
        A value for every parameter.
    """
    numbers = {symbol: exact(number) for symbol, number in parameters.items()}
    field = rolling.field.potential
    if (
        rolling.contact != "rubber"
        or rolling.surface != Plane()
        or any(rolling.body.gyrostat)
        or not rolling.body.principal
        or numbers[I_1] != numbers[I_2]
        or any(numbers.get(symbol, 0) for symbol in c.symbols[:2])
        or field.free_symbols & set(gamma.symbols[:2])
    ):
        return None
    shape = rolling.body.shape
    symmetry = shape.axial_symmetry
    if symmetry is None or shape.hollow:
        return None
    if any(condition.xreplace(numbers) != 0 for condition in symmetry.conditions):
        return None
    with ctx.workprec(BITS):
        values = {s: arb(fmpq(x.numerator, x.denominator)) for s, x in numbers.items()}
    return AxisymmetricBody(symmetry.support, field, values, shape.has_flat_face)


def level_of(body: AxisymmetricBody, omega: Sequence[arb], normal: Sequence[arb]) -> Level:
    """The integrals at a state on the phase space (three balls each)."""
    x, sine_square = normal[2], normal[0] * normal[0] + normal[1] * normal[1]
    spin, turn = omega[2], normal[1] * omega[0] - normal[0] * omega[1]
    size = sum((abs(w) for w in omega), arb(0))
    if vanishes(spin, size) or size == 0:
        spin = arb(0)
    K = body.value(body.square, x).sqrt() * spin
    # ω = θ̇ n + φ̇ (e₃ − γ₃γ) and θ̇ sin θ = turn; at a pole ω is horizontal
    inertia = body.value(body.principal, x)
    energy = body.value(body.energy, x)
    if sine_square > 0:
        return Level(body, (inertia * turn * turn + K * K) / (2 * sine_square) + energy, K)
    return Level(body, inertia * (omega[0] * omega[0] + omega[1] * omega[1]) / 2 + energy, K)

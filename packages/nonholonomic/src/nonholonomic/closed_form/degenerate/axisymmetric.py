"""Bodies with two equal moments: a single equation for u = (γ, e), e the axis of symmetry.

Both systems have two vectors fixed in space, and e is known in the frame k spanned by them:

    Veselova, I = (A, A, C), G = C + (A − C)u², L = Iω×γ, ω₃√G = c:
        A u̇² = 2h(1 − u²) − c²,
        k₃ = γ, k₁ ∥ L,      e = (−A u̇, c√G, u√F)/√F,      ω = (γ×L − (C − A)ω₃(e − uγ))/A.

    Chaplygin ball, J = I + D = (a, a, b), ε = 1/b − 1/a, W = 1 − D/a − Dεu², g = (M, γ), f = M²:
        M₃ = K√W − Dgu/(a − D),      a²u̇² = f(1 − u²) − g² + 2guM₃ − M₃²,
        k₃ = γ, k₁ ∥ M − gγ, m² = f − g²,      e = ((M₃ − gu)/m, a u̇/m, u),
        ω = (M + Dsγ)/a + ε(M₃ + Dsu)e,      s = (ω, γ) = (g/a + εM₃u)/W.

c and K are constants of the motion that exist only for these bodies.  Their constancy, and the
equations of u, are proven in ``packages/chaplygin/tests/closed_form/degenerate``.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp
from flint import arb

from flowlanes.system.tuple_vectors import cross, dot

from ..one_degree.divided_differences import Argument, analytic_root
from ..one_degree.functions import Functions, N
from ..one_degree.uniformisation import Equation

Vector: TypeAlias = Sequence[arb]


@dataclass(frozen=True)
class Axial(ABC):
    """A motion of a body with the axis e.

    Components refer to the frame k, which is fixed in space.
    """

    @property
    @abstractmethod
    def equation(self) -> Equation:
        """The equation of u."""

    @abstractmethod
    def axis(self, F: Functions[N], u: N, rate: N) -> list[N]:
        """e at given u, u̇."""

    @abstractmethod
    def omega(self, F: Functions[N], u: N, rate: N) -> list[N]:
        """ω."""

    @abstractmethod
    def vectors(self, F: Functions[N], u: N, rate: N) -> list[list[N]]:
        """The vectors of the reduced state."""

    @abstractmethod
    def velocity(self, F: Functions[N], u: N, rate: N) -> list[N] | None:
        """The rate of the position, three components; None for a body with a fixed point."""

    @property
    @abstractmethod
    def length(self) -> arb:
        """A length of the body as scale for paths; 1 for a body with a fixed point."""

    @property
    @abstractmethod
    def equations(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """The differential equations, for printing."""

    @property
    @abstractmethod
    def constants(self) -> tuple[tuple[str, arb, str], ...]:
        """Symbol, value and meaning of the constants in the equations."""

    @property
    @abstractmethod
    def start_rate(self) -> arb:
        """u̇ at the start."""

    @abstractmethod
    def frame(self) -> list[list[arb]]:
        """k₁, k₂, k₃ at the start, body axes with e last."""


@dataclass(frozen=True)
class VeselovaAxial(Axial):
    """The Veselova system with A = I₁ = I₂, C = I₃.

    Attributes
    ----------
    A, C : arb
    spin : arb
        c.
    energy : arb
        2h.
    momentum : arb
        F.
    start : (omega, gamma)
        Body axes, e last.
    """

    A: arb
    C: arb
    spin: arb
    energy: arb
    momentum: arb
    start: tuple[Vector, Vector]

    @classmethod
    def from_start(cls, A: arb, C: arb, omega: Vector, gamma: Vector) -> VeselovaAxial:
        """The motion through a state on the phase space."""
        Iomega = [A * omega[0], A * omega[1], C * omega[2]]
        L = cross(Iomega, gamma)
        G = C + (A - C) * gamma[2] * gamma[2]
        return cls(A, C, omega[2] * G.sqrt(), dot(Iomega, omega), dot(L, L), (omega, gamma))

    @property
    def equation(self) -> Equation:
        """The equation of u."""

        def numerator(u: Argument) -> Argument:
            return self.energy * (1 - u * u) - self.spin * self.spin

        def denominator(u: Argument) -> Argument:
            return 0 * u + self.A

        # Beyond ±1 the square is negative: the edges are not roots.
        return Equation(numerator, denominator, arb(-1.5), arb(1.5))

    @property
    def equations(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """A u̇² = 2h(1 − u²) − c²."""
        A, h, c, u, udot = sp.symbols("A h c u udot")
        return ((A * udot**2, 2 * h * (1 - u**2) - c**2),)

    @property
    def constants(self) -> tuple[tuple[str, arb, str], ...]:
        """A, h and c."""
        return (
            ("A", self.A, "moment across the axis"),
            ("h", self.energy / 2, "energy"),
            ("c", self.spin, "constant of the body of revolution"),
        )

    def axis(self, F: Functions[N], u: N, rate: N) -> list[N]:
        """e at u, u̇."""
        size = F.number(self.momentum.sqrt())
        return [-F.number(self.A) / size * rate, F.number(self.spin) * self._G(F, u) / size, u]

    def _G(self, F: Functions[N], u: N) -> N:
        """√G."""
        return F.sqrt(F.number(self.C) + F.number(self.A - self.C) * u * u)

    def omega(self, F: Functions[N], u: N, rate: N) -> list[N]:
        """ω at u, u̇."""
        e, size = self.axis(F, u, rate), F.number(self.momentum.sqrt())
        own = F.number((self.C - self.A) * self.spin) / self._G(F, u)
        A = F.number(self.A)
        return [-own * e[0] / A, (size - own * e[1]) / A, 0 * u]

    def vectors(self, F: Functions[N], u: N, rate: N) -> list[list[N]]:
        """The vectors of the reduced state."""
        return [self.omega(F, u, rate), [0 * u, 0 * u, 0 * u + 1]]

    def velocity(self, F: Functions[N], u: N, rate: N) -> list[N] | None:
        """The velocity of the position."""
        return None

    @property
    def length(self) -> arb:
        """1, since a body with a fixed point has no path."""
        return arb(1)

    @property
    def start_rate(self) -> arb:
        """u̇ at the start."""
        omega, gamma = self.start
        return gamma[0] * omega[1] - gamma[1] * omega[0]

    def frame(self) -> list[list[arb]]:
        """k₁, k₂, k₃ at the start, body axes with e last."""
        omega, gamma = self.start
        L = cross([self.A * omega[0], self.A * omega[1], self.C * omega[2]], gamma)
        first = [x / self.momentum.sqrt() for x in L]
        return [first, cross(gamma, first), list(gamma)]


@dataclass(frozen=True)
class ChaplyginAxial(Axial):
    """The Chaplygin ball with a = I₁ + D = I₂ + D, b = I₃ + D.

    Attributes
    ----------
    a, b, D, R : arb
        R is the radius.
    K : arb
        The constant of the body of revolution.
    area, square : arb
        g and f.
    start : (M, gamma)
        Body axes, e last.
    """

    a: arb
    b: arb
    D: arb
    R: arb
    K: arb
    area: arb
    square: arb
    start: tuple[Vector, Vector]

    @classmethod
    def from_start(cls, a: arb, b: arb, D: arb, R: arb, M: Vector, gamma: Vector) -> ChaplyginAxial:
        """The motion through a state on the phase space."""
        g = dot(M, gamma)
        level = cls(a, b, D, R, arb(0), g, dot(M, M), (M, gamma))
        own = (M[2] - level._lean * gamma[2]) / level._W(gamma[2]).sqrt()
        return cls(a, b, D, R, own, g, dot(M, M), (M, gamma))

    @property
    def _epsilon(self) -> arb:
        return 1 / self.b - 1 / self.a

    @property
    def _lean(self) -> arb:
        """−Dg/(a − D)."""
        return -self.D * self.area / (self.a - self.D)

    @property
    def across(self) -> arb:
        """m."""
        return (self.square - self.area * self.area).sqrt()

    def _W(self, u: Argument) -> Argument:
        return 1 - self.D / self.a - self.D * self._epsilon * u * u

    @property
    def equation(self) -> Equation:
        """The equation of u."""
        g, f = self.area, self.square

        def numerator(u: Argument) -> Argument:
            M = self.K * analytic_root(self._W(u)) + self._lean * u
            return f * (1 - u * u) - g * g + 2 * g * u * M - M * M

        def denominator(u: Argument) -> Argument:
            return 0 * u + self.a**2

        high = arb(1.5)
        if self._epsilon > 0:
            # between 1 and the zero of W
            end = ((1 - self.D / self.a) / (self.D * self._epsilon)).sqrt()
            high = high.min((1 + end) / 2)
        return Equation(numerator, denominator, -high, high)

    @property
    def equations(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """a²u̇² and M₃ in u."""
        a, b, D, K, f, g, u, udot, M = sp.symbols("a b D K f g u udot M_3")
        W = 1 - D / a - D * (1 / b - 1 / a) * u**2
        return (
            (a**2 * udot**2, f * (1 - u**2) - g**2 + 2 * g * u * M - M**2),
            (M, K * sp.sqrt(W) - D * g * u / (a - D)),
        )

    @property
    def constants(self) -> tuple[tuple[str, arb, str], ...]:
        """a, b, D, f, g and K."""
        return (
            ("a", self.a, "moment about the contact, across the axis"),
            ("b", self.b, "moment about the contact, along the axis"),
            ("D", self.D, "mR²"),
            ("f", self.square, "square of the momentum"),
            ("g", self.area, "area integral"),
            ("K", self.K, "constant of the ball of revolution"),
        )

    def _M(self, F: Functions[N], u: N) -> tuple[N, N, N]:
        """W, M₃ and s."""
        D, epsilon = F.number(self.D), F.number(self._epsilon)
        W = F.number(1 - self.D / self.a) - D * epsilon * u * u
        M = F.number(self.K) * F.sqrt(W) + F.number(self._lean) * u
        return W, M, (F.number(self.area / self.a) + epsilon * M * u) / W

    def axis(self, F: Functions[N], u: N, rate: N) -> list[N]:
        """e at u, u̇."""
        _, M, _ = self._M(F, u)
        m = F.number(self.across)
        return [(M - F.number(self.area) * u) / m, F.number(self.a) * rate / m, u]

    def omega(self, F: Functions[N], u: N, rate: N) -> list[N]:
        """ω at u, u̇."""
        _, M, s = self._M(F, u)
        e = self.axis(F, u, rate)
        a, D = F.number(self.a), F.number(self.D)
        own = F.number(self._epsilon) * (M + D * s * u)
        return [
            F.number(self.across) / a + own * e[0],
            own * e[1],
            (F.number(self.area) + D * s) / a + own * e[2],
        ]

    def vectors(self, F: Functions[N], u: N, rate: N) -> list[list[N]]:
        """The vectors of the reduced state."""
        zero = 0 * u
        M = [zero + F.number(self.across), zero, zero + F.number(self.area)]
        return [M, [zero, zero, zero + 1]]

    def velocity(self, F: Functions[N], u: N, rate: N) -> list[N] | None:
        """The velocity of the position."""
        omega, R = self.omega(F, u, rate), F.number(self.R)
        return [R * omega[1], -R * omega[0], 0 * u]

    @property
    def length(self) -> arb:
        """The radius."""
        return self.R

    @property
    def start_rate(self) -> arb:
        """u̇ at the start."""
        M, gamma = self.start
        return (gamma[0] * M[1] - gamma[1] * M[0]) / self.a

    def frame(self) -> list[list[arb]]:
        """k₁, k₂, k₃ at the start, body axes with e last."""
        M, gamma = self.start
        first = [(x - self.area * n) / self.across for x, n in zip(M, gamma, strict=True)]
        return [first, cross(gamma, first), list(gamma)]

"""The fluid of a cavity as a gyrostat with an equation of its own.

With the momentum N = ∂T/∂ξ = K(ξ + Cω), which is conjugate to the motion ξ of the fluid relative to
the body, the momentum of body and fluid is Iω + CN, where I is the inertia of the equivalent rigid
body, and

    T = ½(ω, Iω) + ½(N, WN),      Ṅ = ξ×N,      ξ = WN − Cω,      W = K⁻¹.

The components of N along the axes of the cavity are the circulations along the three principal
sections of its wall times m/(5π): Ṅ = ξ×N is Helmholtz's theorem, and N² = const. is Kelvin's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Integral
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Observable, Parameter
from flowlanes.system.vectors import Diagonal, Symmetric, Vector, cross, dot, norm_squared

from .cavity import Cavity

omega = Vector("omega")
HALF = sp.Rational(1, 2)


@dataclass(frozen=True)
class Fluid:
    """The fluid of a cavity, as formulas in ω and N.

    Attributes
    ----------
    cavity : Cavity
    number : str
        Number of the cavity; empty if there is only one.
    """

    cavity: Cavity
    number: str = ""

    @property
    def N(self) -> Vector:
        """Circulation vector N, a state variable."""
        return Vector(f"N{self.number}")

    @property
    def xi(self) -> Vector:
        """Motion ξ of the fluid relative to the body."""
        return Vector(f"xi{self.number}")

    @property
    def start(self) -> Vector:
        """Name of ξ in initial states and datasets."""
        return Vector(f"fluid{self.number}")

    @property
    def C(self) -> Diagonal | Symmetric:
        """The tensor that couples ω and N."""
        return self._tensor("C")

    @property
    def W(self) -> Diagonal | Symmetric:
        """K⁻¹, the inverse of the inertia tensor that the fluid would have if it were solid."""
        return self._tensor("W")

    def _tensor(self, name: str) -> Diagonal | Symmetric:
        kind = Diagonal if self.cavity.solid_inertia.is_diagonal() else Symmetric
        return kind(f"{name}{self.number}")

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The entries of W = K⁻¹ and C; proofs are shorter in terms of K⁻¹ than of K."""
        where = f"cavity {self.number}" if self.number else "the cavity"
        solid = f"inverse of the inertia that the fluid in {where} would have as a solid"
        described = (
            (self.W, self.cavity.solid_inertia.inv(), solid, "1/(kg m^2)"),
            (self.C, self.cavity.coupling, f"coupling of the body to the fluid in {where}", "1"),
        )
        return tuple(
            Parameter(
                s,
                f"{meaning}, entry {str(s).rpartition('_')[2]}",
                float(value),
                unit,
                (s > 0,) if s in tensor.entries.diagonal() else (),
            )
            for tensor, matrix, meaning, unit in described
            for s, value in zip(tensor.symbols, tensor.independent(matrix), strict=True)
        )

    @property
    def motion(self) -> Pairs:
        """The definition of ξ in terms of ω and N."""
        return ((self.xi, self.W * self.N - self.C * omega),)

    @property
    def rate(self) -> MatrixExpr:
        """Ṅ = ξ×N, Helmholtz's theorem."""
        return cross(self.xi, self.N)

    @property
    def momentum(self) -> MatrixExpr:
        """The contribution of the fluid to the momentum, besides Iω of the equivalent body."""
        return self.C * self.N

    @property
    def energy(self) -> sp.Expr:
        """½(N, WN), the energy of the fluid beyond that of the equivalent body."""
        return HALF * dot(self.N, self.W * self.N)

    @property
    def solid_inertia(self) -> Pairs:
        """The definition of K = W⁻¹, for the kinetic energy in velocities."""
        return ((self._tensor("K"), self.W**-1),)

    @property
    def kinetic_energy(self) -> sp.Expr:
        """`energy` in the velocities ω and ξ."""
        turning = self.xi + self.C * omega
        return HALF * dot(turning, self._tensor("K") * turning)

    @property
    def initial(self) -> MatrixExpr:
        """N = K(ξ + Cω) for initial values of ω and ξ."""
        return self.W**-1 * (self.start + self.C * omega)

    @property
    def circulation(self) -> Integral:
        """The first integral N² = const., Kelvin's theorem."""
        return Integral(
            f"circulation{self.number}",
            norm_squared(self.N),
            f"square of the circulation vector{self._which}",
            source="Kelvin's theorem",
            unit="kg^2 m^4/s^2",
        )

    @property
    def observable(self) -> Observable:
        """The observable that records ξ."""
        meaning = f"motion of the fluid{self._which} relative to the body"
        return Observable(str(self.start), self.xi, meaning, "rad/s", "body")

    @property
    def _which(self) -> str:
        return f" in cavity {self.number}" if self.number else ""


def fluids_of_cavities(cavities: Sequence[Cavity]) -> tuple[Fluid, ...]:
    """The fluids in the cavities that are not empty, numbered if there are several cavities."""
    several = len(cavities) > 1
    return tuple(
        Fluid(cavity, str(i) if several else "")
        for i, cavity in enumerate(cavities, 1)
        if cavity.mass
    )

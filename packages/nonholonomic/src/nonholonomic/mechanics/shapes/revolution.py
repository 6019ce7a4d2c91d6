"""Bodies of revolution, given by their support function or their profile."""

from __future__ import annotations

import math
from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import FormulaParameters, arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.named_formulas import by_name
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import dot, real_symbol

from ..formula_parameters import formula_parameters
from .gauss_map import GaussMap
from .kinematics import gamma
from .shape_base import (
    AxialSymmetry,
    SupportShape,
    check_centre,
    convexity,
    require_symbols,
)

_MEANING = "parameter of the profile"


@arguments_checked
@dataclass(frozen=True)
class ShapeOfRevolution(SupportShape):
    """A convex body of revolution about body axis 3.

    Parameters
    ----------
    support : sympy.Expr
        Height p(γ₃) of the geometric centre above the plane (m), in the symbol ``gamma_3``.
    parameters : mapping of str or Symbol to float, or sequence of Parameter
        Further symbols in `support`, with their values.
    centre : 3 floats
        Geometric centre relative to the centre of mass (m, body axes).

    Raises
    ------
    InputError
        If `support` uses an unknown symbol, or is not positive for an upright axis.

    See Also
    --------
    ShapeOfRevolution.from_profile : the same from the functions χ₁, χ₂ of §5.

    Examples
    --------
    >>> import lawproof
    >>> import nonholonomic
    >>> import sympy as sp
    >>> u, a, b = sp.symbols("gamma_3 a b")
    >>> egg = nonholonomic.ShapeOfRevolution(
    ...     sp.sqrt(a**2 * (1 - u**2) + b**2 * u**2), {a: 0.02, b: 0.03}
    ... )
    >>> system = nonholonomic.rolling_system(
    ...     nonholonomic.Body(0.05, (8e-6, 8e-6, 6e-6), egg), contact="rubber"
    ... )
    >>> lawproof.prove(system, "energy").decision
    'proven'
    """

    support: sp.Expr
    parameters: FormulaParameters = ()

    kind = "revolution"

    def __post_init__(self) -> None:
        declared = formula_parameters(self.parameters, _MEANING)
        object.__setattr__(self, "parameters", declared)
        known = (gamma.symbols[2], *self._values)
        object.__setattr__(self, "support", by_name(self.support, known))
        check_centre(self.centre)
        require_symbols(
            f"support function {self.support}",
            self.support.free_symbols,
            set(known),
            "gamma_3",
        )
        for cosine in (-1.0, -0.5, 0.0, 0.5, 1.0):
            value = self._value(self.support, cosine)
            if not (math.isfinite(value) and value > 0):
                raise InputError(
                    f"support function {self.support} is {value:g} at gamma_3 = {cosine:g}: it "
                    "must be positive, the distance of the tangent plane from the centre"
                )

    @classmethod
    @arguments_checked
    def from_profile(
        cls,
        chi_1: sp.Expr,
        chi_2: sp.Expr,
        parameters: FormulaParameters = (),
        centre: tuple[float, float, float] = (0.0, 0.0, 0.0),
    ) -> ShapeOfRevolution:
        """The body with r − c = (χ₁γ₁, χ₁γ₂, χ₂), χ₁ and χ₂ in ``gamma_3`` (§5).

        Raises
        ------
        InputError
            If an unknown symbol occurs, or χ₁ and χ₂ do not belong to one surface with normal
            −γ, that is, if −γ₃χ₁ + (1 − γ₃²)χ₁′ + γ₃χ₂′ is not zero.
        """
        u = gamma.symbols[2]
        declared = formula_parameters(parameters, _MEANING)
        table = {p.symbol: p.default for p in declared}
        chi_1, chi_2 = (by_name(chi, (u, *table)) for chi in (chi_1, chi_2))
        require_symbols(
            f"profile chi_1 = {chi_1}, chi_2 = {chi_2}",
            chi_1.free_symbols | chi_2.free_symbols,
            {u, *table},
            "gamma_3",
        )
        defect = -u * chi_1 + (1 - u**2) * chi_1.diff(u) + u * chi_2.diff(u)
        for cosine in (sp.Rational(n, 17) for n in (-16, -9, -2, 5, 12)):
            here = {**table, u: cosine}
            number = sp.N(defect.subs(here))
            if abs(number) > 1e-9 * (1 + abs(sp.N(chi_1.subs(here)))):
                raise InputError(
                    f"profile chi_1 = {chi_1}, chi_2 = {chi_2}: the surface has no normal -gamma, "
                    f"since -gamma_3 chi_1 + (1 - gamma_3^2) chi_1' + gamma_3 chi_2' is {number} "
                    f"at gamma_3 = {cosine} and must be zero"
                )
        return cls(-(chi_1 * (1 - u**2) + chi_2 * u), declared, centre=centre)

    @property
    def _values(self) -> dict[sp.Symbol, float]:
        return {p.symbol: p.default for p in self.parameters}

    @property
    def title(self) -> str:
        """Name of the shape for titles."""
        return "Body of revolution"

    @property
    def axial_symmetry(self) -> AxialSymmetry:
        """Symmetry without conditions."""
        return AxialSymmetry((), self.support)

    def _value(self, expression: sp.Expr, cosine: float) -> float:
        number = expression.subs({**self._values, gamma.symbols[2]: cosine})
        return float(sp.N(number)) if number.is_real is not False else math.nan

    def gauss(self) -> GaussMap:
        """The map r = c − pγ − p′(e₃ − γ₃γ), with radii p − γ₃p′ and p − γ₃p′ + (1 − γ₃²)p″."""
        u = gamma.symbols[2]
        p, first, second = real_symbol("p"), real_symbol("pprime"), real_symbol("pprime2")
        slope = unit_vector(3) - u * gamma
        parallel = p - u * first
        meridian = parallel + (1 - u**2) * second
        return GaussMap(
            parameters=self.parameters,
            definitions=(
                (p, self.support),
                (first, self.support.diff(u)),
                (second, self.support.diff(u, 2)),
            ),
            reach=-p * gamma - first * slope,
            spread=lambda w: parallel * w + (second * dot(slope, w)) * slope,
            trace=parallel + meridian,
            determinant=parallel * meridian,
            support=p,
            guards=convexity(parallel * meridian, parallel + meridian),
        )

"""The special operators of inertia, with which the n-dimensional systems are integrable.

With positive numbers a_i, A = diag(a_1, …, a_n):

* Veselova system, I_ij = a_i a_j (Fedorov and Jovanović 2004): with W = (Aγ, γ),

      u = (A⁻¹p − (A⁻¹p, γ) γ) / W,    H = (A⁻¹p, p) / 2W,    ṗ = (u, p) γ,    γ̇ = −u.

* Rubber ball, I_ij = a_i a_j − m R² (Jovanović 2010): the same equations.

* Marble ball, I_ij = D a_i a_j / (D − a_i a_j) with D = m R² > a_i a_j, on the invariant level
  k = p ∧ γ of momenta in planes through γ alone (Jovanović 2010): with W = (A⁻¹γ, γ),

      D W ω = p ∧ A⁻¹γ − (Ap ∧ γ)/D,    ṗ = −ωp,    γ̇ = −ωγ,
      H = (p² − (Ap, p)/(D W)) / 2D.

In all of them the time τ with dτ = W^(−1/2) dt makes the motion Hamiltonian on the cotangent bundle
of the sphere.  The quadratic integrals F_i and p² are constant; n − 1 of them are independent.
For n = 3 every inertia is a product a_i a_j; for n ≥ 4 such operators belong to no rigid body in
general.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, PoissonStructure
from flowlanes.system.matrices import Column
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Vector, dot, norm_squared, real_symbol

from ...mechanics.conventions import BodyConventions
from ..catalogue_entry import Numbers, Values
from ..so_n.entry_of_dimension import (
    SOURCE,
    SQUARE,
    D,
    Family,
    R,
    WithoutTwist,
    across,
    cycle,
    direction,
    momentum_and_direction,
    numbers_of,
)
from ..so_n.inertia import Inertia, ProductMoments, progression
from ..so_n.motion_in_space import (
    angular_velocity,
    gamma_of,
    motion_in_space,
    omega_of,
    unit_length,
)

HALF = sp.Rational(1, 2)
W = real_symbol("W")


class RubberMoments(ProductMoments):
    """The moments I_ij = a_i a_j − m R²."""

    law = "a_i a_j − m R²"

    def value(self, product: sp.Expr) -> sp.Expr:
        """I_ij from the product a_i a_j."""
        return product - D


class MarbleMoments(ProductMoments):
    """The moments I_ij = D a_i a_j / (D − a_i a_j), D = m R²."""

    law = "D a_i a_j / (D − a_i a_j), D = m R²"

    def value(self, product: sp.Expr) -> sp.Expr:
        """I_ij from the product a_i a_j."""
        return D * product / (D - product)


def canonical_structure(p: Vector, gamma: Vector, weights: Sequence[sp.Expr]) -> sp.Matrix:
    """The canonical bracket of the sphere for q = −W^(−1/2) p, in p and γ.

    With W = Σ weightsᵢ γᵢ² and sᵢ = weightsᵢ γᵢ: {γᵢ, pⱼ} = −√W (δᵢⱼ − γᵢγⱼ) and
    {pᵢ, pⱼ} = −W^(−1/2) (pᵢ sⱼ − pⱼ sᵢ); it belongs to {γᵢ, qⱼ} = δᵢⱼ − γᵢγⱼ and
    {qᵢ, qⱼ} = qᵢγⱼ − qⱼγᵢ.
    """
    n = len(weights)
    root = sp.sqrt(W)
    x, y = sp.Matrix(p.symbols), sp.Matrix(gamma.symbols)
    s = sp.Matrix([weight * c for weight, c in zip(weights, y, strict=True)])
    corner = -root * (sp.eye(n) - y * y.T)
    top = (-(x * s.T - s * x.T) / root).row_join(-corner.T)
    return sp.ImmutableDenseMatrix(top.col_join(corner.row_join(sp.zeros(n))))


@dataclass(frozen=True, kw_only=True)
class Special(Family):
    """A system with a special operator of inertia, in p and γ."""

    def start(self, dimension: int) -> Values:
        """A generic momentum across a generic direction."""
        gamma = direction(dimension)
        return {"p": across(cycle((0.5, 0.35, 0.1, 0.2), dimension), gamma), "gamma": gamma}

    def variables(self) -> Mapping[str, tuple[str, str]]:
        """Meaning and unit of the variables of the state."""
        return momentum_and_direction(self.rolls)

    @property
    def settings(self) -> tuple[str, ...]:
        """The settings besides those of a ball."""
        return ("dimension", "factors")

    @property
    @abstractmethod
    def kind(self) -> type[ProductMoments]:
        """The operators of inertia."""

    @abstractmethod
    def example(self, dimension: int) -> tuple[float, ...]:
        """Factors of an instructive example."""

    def check(self, numbers: Numbers) -> None:
        """Raise InputError unless all moments are positive."""

    def _inertia(self, settings: dict[str, object]) -> tuple[Inertia, dict[str, float]]:
        factors = settings.pop("factors", None)
        n = self._dimension(settings.pop("dimension", None), factors=factors)
        values = list(self.example(n)) if factors is None else numbers_of("factors", factors)
        if len(values) != n:
            raise InputError(
                f"factors: {n} numbers are needed in {n} dimensions, not {len(values)}"
            )
        numbers = {f"a_{i}": value for i, value in enumerate(values, 1)}
        for name in [name for name in settings if name in numbers]:
            numbers[name] = numbers_of(name, [settings.pop(name)])[0]
        if min(numbers.values()) <= 0 or len(set(numbers.values())) < n:
            raise InputError("factors: must be positive and different from each other")
        return self.kind(n, numbers), numbers

    def _on_cotangent_bundle(
        self,
        inertia: Inertia,
        parameters: tuple[Parameter, ...],
        definitions: Pairs,
        field: Mapping[Column, sp.Expr],
        laws: tuple[Law, ...],
    ) -> System:
        n = inertia.dimension
        return System(
            name=self.name,
            title=self.title,
            summary=f"{self.summary} {inertia.words}",
            source=SOURCE,
            parameters=(*inertia.parameters, *parameters),
            definitions=definitions,
            field=dict(field),
            relations=cotangent(Column("p", n), gamma_of(n)),
            laws=laws,
            observables=(angular_velocity(n),),
            reconstruction=motion_in_space(n, R if self.rolls else None),
        )

    def _system(self, inertia: Inertia, values: Numbers) -> System:
        self.check(values)
        return super()._system(inertia, values)


def check_largest(numbers: Numbers, above: bool) -> None:
    """Raise InputError unless all products a_i a_j lie above, or all below, m R²."""
    factors = sorted(value for name, value in numbers.items() if name.startswith("a_"))
    limit = numbers["m"] * numbers["R"] ** 2
    extreme = factors[0] * factors[1] if above else factors[-1] * factors[-2]
    if not (extreme > limit if above else extreme < limit):
        raise InputError(
            f"factors: every product a_i a_j must be {'greater' if above else 'less'} than "
            f"m R^2 = {limit:g}, and one is {extreme:g}"
        )


def quadratic_integrals(
    p: Vector, gamma: Vector, factors: Sequence[sp.Symbol], last: Vector, below: sp.Expr
) -> tuple[Integral, ...]:
    """Quadratic integrals F_i, one for each axis, for a body of special inertia.

    Notes
    -----
    F_i = (Σ (p_i γ_j − p_j γ_i)²/(a_i − a_j) − c_i²/a_i)/b with the sum over j ≠ i, where a_i are
    the `factors`, c is `last`, and b is `below`.
    """
    x, y, c = p.symbols, gamma.symbols, last.symbols
    n = len(factors)
    found = []
    for i in range(n):
        turns = (
            (x[i] * y[j] - x[j] * y[i]) ** 2 / (factors[i] - factors[j]) for j in range(n) if j != i
        )
        value = (sp.Add(*turns) - c[i] ** 2 / factors[i]) / below
        found.append(
            Integral(
                f"quadratic{i + 1}", value, f"quadratic integral of axis {i + 1}", source=SOURCE
            )
        )
    return tuple(found)


@dataclass(frozen=True, kw_only=True)
class SpecialVeselova(WithoutTwist, Special):
    """The Veselova system, or the rubber ball where it rolls, with moments of products."""

    @property
    def kind(self) -> type[ProductMoments]:
        """The operators of inertia."""
        return RubberMoments if self.rolls else ProductMoments

    def example(self, dimension: int) -> tuple[float, ...]:
        """Factors of an instructive example; their products exceed m R² = 1 for the ball."""
        return progression(1.1 if self.rolls else 0.8, 0.3, dimension)

    def check(self, numbers: Numbers) -> None:
        """Raise InputError unless all moments are positive."""
        if self.rolls:
            check_largest(numbers, above=True)

    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The equations, u in closed form."""
        if not isinstance(inertia, ProductMoments):
            raise TypeError(type(inertia).__name__)
        n, a = inertia.dimension, inertia.factors
        p, u, gamma, omega = Column("p", n), Column("u", n), gamma_of(n), omega_of(n)
        b = Column("b", n)
        inverse = sp.ImmutableDenseMatrix(sp.diag(*(1 / s for s in a)))
        weight = sp.Add(*(s * c**2 for s, c in zip(a, gamma, strict=True)))
        definitions: Pairs = (
            (b, inverse * p),
            (W, weight),
            (u, (b - dot(b, gamma) * gamma) / W),
            (omega, u * gamma.T - gamma * u.T),
        )
        energy = HALF * dot(b, p) / W
        laws: tuple[Law, ...] = (
            *_energy_and_momentum(energy, p),
            *quadratic_integrals(p, gamma, a, p, dot(b, p)),
            *_hamiltonian(p, gamma, a, energy),
        )
        field = {p: dot(u, p) * gamma, gamma: -u}
        system = self._on_cotangent_bundle(inertia, parameters, definitions, field, laws)
        # a_i a_j ω_ij γ_j, with m R² in a_i a_j
        direct = sp.ImmutableDenseMatrix(sp.diag(*a))
        return replace(
            system, conventions=BodyConventions({p: direct * (omega * (direct * gamma))})
        )


@dataclass(frozen=True, kw_only=True)
class SpecialBall(Special):
    """The marble ball without turning momentum about γ, with the special operator."""

    @property
    def kind(self) -> type[ProductMoments]:
        """The operators of inertia."""
        return MarbleMoments

    def example(self, dimension: int) -> tuple[float, ...]:
        """Factors of an instructive example; their products are less than m R² = 1."""
        return progression(0.3, round(0.6 / dimension, 3), dimension)

    def check(self, numbers: Numbers) -> None:
        """Raise InputError unless all moments are positive."""
        check_largest(numbers, above=False)

    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The equations on the level k = p ∧ γ."""
        if not isinstance(inertia, ProductMoments):
            raise TypeError(type(inertia).__name__)
        n, a = inertia.dimension, inertia.factors
        p, gamma, omega = Column("p", n), gamma_of(n), omega_of(n)
        b, c = Column("b", n), Column("c", n)
        inverse = sp.ImmutableDenseMatrix(sp.diag(*(1 / s for s in a)))
        direct = sp.ImmutableDenseMatrix(sp.diag(*a))
        weight = sp.Add(*(y**2 / s for s, y in zip(a, gamma, strict=True)))
        definitions: Pairs = (
            (b, inverse * gamma),
            (c, direct * p / D),
            (W, weight),
            (omega, (p * b.T - b * p.T - c * gamma.T + gamma * c.T) / (D * W)),
        )
        energy = HALF * (norm_squared(p) - dot(c, p) / W) / D
        laws: tuple[Law, ...] = (
            *_energy_and_momentum(energy, p),
            *_ball_integrals(p, gamma, a),
            *_hamiltonian(p, gamma, [1 / s for s in a], energy),
        )
        field = {p: -omega * p, gamma: -omega * gamma}
        return self._on_cotangent_bundle(inertia, parameters, definitions, field, laws)


def _energy_and_momentum(energy: sp.Expr, p: Vector) -> tuple[Integral, Integral]:
    words = "square of the momentum"
    return (
        Integral("energy", energy, "energy", source=SOURCE, unit="J"),
        Integral("momentum", norm_squared(p), words, source=SOURCE, unit=SQUARE),
    )


def _ball_integrals(p: Vector, gamma: Vector, factors: Sequence[sp.Symbol]) -> tuple[Integral, ...]:
    """F_i = (Σ (p_i γ_j − p_j γ_i)²/(a_i − a_j) − p² γ_i²/a_i)/W over j ≠ i."""
    x, y = p.symbols, gamma.symbols
    found = []
    for i, own in enumerate(factors):
        turns = (
            (x[i] * y[j] - x[j] * y[i]) ** 2 / (own - other)
            for j, other in enumerate(factors)
            if j != i
        )
        value = (sp.Add(*turns) - norm_squared(p) * y[i] ** 2 / own) / W
        found.append(
            Integral(
                f"quadratic{i + 1}", value, f"quadratic integral of axis {i + 1}", source=SOURCE
            )
        )
    return tuple(found)


def cotangent(p: Vector, gamma: Vector) -> tuple[sp.Expr, ...]:
    """Vanish on the cotangent bundle of the sphere."""
    return unit_length(gamma), sp.Add(*(a * b for a, b in zip(p, gamma, strict=True)))


def _hamiltonian(
    p: Vector, gamma: Vector, weights: Sequence[sp.Expr], energy: sp.Expr
) -> tuple[Law, ...]:
    """The measure, and the Hamiltonian form after the change of time dτ = W^(−1/2) dt."""
    n = len(weights)
    relations = cotangent(p, gamma)
    structure = PoissonStructure(
        "bracket",
        canonical_structure(p, gamma, weights),
        casimirs=(norm_squared(gamma), relations[1]),
        rank=2 * n - 2,
        meaning="canonical bracket of the sphere for −W^(−1/2) p and γ",
        source=SOURCE,
    )
    return (
        Measure("measure", {W: -sp.Rational(n - 2, 2)}, "invariant measure", source=SOURCE),
        structure,
        ConformallyHamiltonian(
            "hamiltonian",
            1 / sp.sqrt(W),
            structure,
            energy,
            "conformally Hamiltonian form, Chaplygin's multiplier W^(−1/2)",
            source=SOURCE,
        ),
    )


VESELOVA = SpecialVeselova(name="special-veselova-nd")
RUBBER_BALL = SpecialVeselova(name="special-rubber-ball-nd", rolls=True)
BALL = SpecialBall(name="special-chaplygin-ball-nd", rolls=True)

ENTRIES = (
    VESELOVA.entry(),
    RUBBER_BALL.entry(),
    BALL.entry(),
)

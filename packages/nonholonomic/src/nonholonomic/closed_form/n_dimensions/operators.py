"""Recognise the special n-dimensional operators of inertia among given moments.

In terms of products K_ij = a_i a_j (i ≠ j) the inertia is

* K_ij for the Veselova system, K_ij − m R² for the rubber ball;
* D K_ij/(D − K_ij), D = m R², for the marble ball without momentum in planes across γ.

So K_ij is I_ij, I_ij + m R² or I_ij D/(I_ij + D), and numbers K_ij > 0 are products of factors
exactly when K_ij K_kl = K_ik K_jl for all different i, j, k, l.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from itertools import combinations, permutations

from flint import arb

from flowlanes.formulas.balls import ball, exact
from flowlanes.formulas.relative_zero import ROUNDING
from flowlanes.system.matrices import Column, Skew

from ...catalogue import entry
from ..base.exact_start import on_phase_space
from ..base.problem import Problem


class Kind(Enum):
    """How the momentum of a motion depends on its angular velocity."""

    VESELOVA = "Veselova system or rubber ball"
    BALL = "marble ball on the level k = p∧γ"
    SURROUNDING = "rubber ball on a sphere"


@dataclass(frozen=True)
class InertiaByProducts:
    """An operator of inertia by its K_ij; a special one if these are products.

    Attributes
    ----------
    products : mapping of (i, j) to Fraction
        K_ij for i ≠ j.
    D : Fraction
        m R²; 0 for a body about a fixed point.
    epsilon : Fraction
        γ̇ = −ε ω γ: 1, and a/(R + a) on a sphere.
    """

    kind: Kind
    dimension: int
    products: Mapping[tuple[int, int], Fraction]
    D: Fraction
    epsilon: Fraction = Fraction(1)

    @property
    def factors(self) -> tuple[arb, ...]:
        """a_1, …, a_n at the working precision."""
        K = self.products
        first = (ball(K[0, 1]) * ball(K[0, 2]) / ball(K[1, 2])).sqrt()
        return (first, *(ball(K[0, j]) / first for j in range(1, self.dimension)))

    @property
    def special(self) -> bool:
        """Whether the motion separates: K_ij are products a_i a_j, on a sphere ε = −1."""
        if self.kind is Kind.SURROUNDING and self.epsilon != -1:
            return False
        return _are_products(self.dimension, self.products)

    def equal(self, i: int, j: int) -> bool:
        """Whether a_i = a_j."""
        other = next(k for k in range(self.dimension) if k not in (i, j))
        return self.products[i, other] == self.products[j, other]


#: Systems by name: the kind, and whether the ball's m R² is added to its moments.
_KINDS: Mapping[str, Kind] = {
    "veselova-nd": Kind.VESELOVA,
    "special-veselova-nd": Kind.VESELOVA,
    "rubber-chaplygin-ball-nd": Kind.VESELOVA,
    "special-rubber-ball-nd": Kind.VESELOVA,
    "chaplygin-ball-nd": Kind.BALL,
    "chaplygin-ball-on-level-nd": Kind.BALL,
    "special-chaplygin-ball-nd": Kind.BALL,
    "rubber-ball-on-sphere-nd": Kind.SURROUNDING,
    "special-rubber-ball-on-sphere-nd": Kind.SURROUNDING,
}


def operator_of(problem: Problem) -> InertiaByProducts | None:
    """The moments K_ij of a problem, products or not; None for any other system."""
    system = problem.system
    if system.name not in _KINDS:
        return None
    numbers = problem.numbers
    n = next(int(x.shape[0]) for x in system.state if isinstance(x, Column))
    try:
        settings = {name: float(x) for name, x in numbers.items()}
        own = entry(system.name).system({"dimension": n, **settings})
    except (KeyError, ValueError):
        return None
    if (own.field, own.definitions) != (system.field, system.definitions):
        return None
    kind = _KINDS[system.name]
    D = numbers["m"] * numbers["R"] ** 2 if "m" in numbers else Fraction(0)
    epsilon = Fraction(1)
    if kind is Kind.SURROUNDING:
        epsilon = numbers["a"] / (numbers["R"] + numbers["a"])
    products = _products(n, numbers, kind, D)
    if products is None:
        return None
    return InertiaByProducts(kind, n, products, D, epsilon)


def _products(
    n: int, numbers: Mapping[str, Fraction], kind: Kind, D: Fraction
) -> dict[tuple[int, int], Fraction] | None:
    """K_ij; None for a mass tensor that is not diagonal."""
    found = {}
    for i, j in combinations(range(n), 2):
        if "a_1" in numbers:
            product = numbers[f"a_{i + 1}"] * numbers[f"a_{j + 1}"]
        else:
            if "J_11" in numbers:
                if numbers[f"J_{i + 1}{j + 1}"] != 0:
                    return None
                moment = numbers[f"J_{i + 1}{i + 1}"] + numbers[f"J_{j + 1}{j + 1}"]
            else:
                moment = numbers[f"I_{i + 1}{j + 1}"]
            product = moment * D / (moment + D) if kind is Kind.BALL else moment + D
        found[i, j] = found[j, i] = product
    return found


def _are_products(n: int, K: Mapping[tuple[int, int], Fraction]) -> bool:
    return all(K[i, j] * K[k, m] == K[i, k] * K[j, m] for i, j, k, m in permutations(range(n), 4))


def momentum_and_vector(problem: Problem) -> tuple[list[arb], list[arb]] | None:
    """p and γ at the start, on the phase space; None if k is not p∧γ."""
    system = problem.system
    size = len(system.symbols)
    values = {s: ball(exact(x)) for s, x in problem.parameters.items()}
    state = on_phase_space(system, (), problem.start[:size], values)
    places = {str(name): slice(place.start, place.stop) for name, place in system.slices}
    gamma = list(state[places["gamma"]])
    if "p" in places:
        return list(state[places["p"]]), gamma
    k = next(name for name in system.state if isinstance(name, Skew))
    entries = iter(state[places[str(k)]])
    n = len(gamma)
    matrix = [[arb(0)] * n for _ in range(n)]
    for i, j in combinations(range(n), 2):
        matrix[i][j] = next(entries)
        matrix[j][i] = -matrix[i][j]
    p = [sum((x * y for x, y in zip(row, gamma, strict=True)), arb(0)) for row in matrix]
    size_of_k = max(abs(x) for row in matrix for x in row)
    for i, j in combinations(range(n), 2):
        across = matrix[i][j] - (p[i] * gamma[j] - p[j] * gamma[i])
        if abs(across) > size_of_k * arb(ROUNDING):
            return None
    return [x.mid() for x in p], gamma

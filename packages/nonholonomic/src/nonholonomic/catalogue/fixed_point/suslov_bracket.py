"""A solvable five-dimensional bracket whose Casimir functions are not all global (§3.4, (3.8)).

The only brackets that are not zero are those with γ₃, which turns the planes (p₁, γ₁) and
(p₂, γ₂) at the rates 1 and d:

    {γ₁, γ₃} = p₁,   {γ₂, γ₃} = d p₂,   {p₁, γ₃} = −γ₁,   {p₂, γ₃} = −d γ₂.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Integral, Measure, PoissonStructure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Components, Vector, constant, norm_squared

from ..catalogue_entry import Entry, Numbers, Start

gamma = Vector("gamma")
p_1, p_2, d = sp.symbols("p_1 p_2 d", real=True)
gamma_1, gamma_2, gamma_3 = gamma.symbols
#: Flat order of the state.
ORDER = (p_1, p_2, gamma_1, gamma_2, gamma_3)

TITLE = "Five-dimensional bracket of Suslov's problem"
SUMMARY = (
    "A Hamiltonian system on the dual of a solvable Lie algebra of dimension five, to which "
    "Suslov's problem in a quadratic potential is equivalent; for irrational d its symplectic "
    "leaves are dense on cylinders over tori."
)
SOURCE = "§3.4, (3.8)"


def skew(brackets: dict[tuple[sp.Symbol, sp.Symbol], sp.Expr]) -> Components:
    """The matrix of a bracket from its entries {x, y} that are not zero."""
    matrix = sp.zeros(5, 5)
    for (x, y), value in brackets.items():
        i, j = ORDER.index(x), ORDER.index(y)
        matrix[i, j], matrix[j, i] = value, -value
    return Components(matrix)


def bracket() -> PoissonStructure:
    """(3.8), with {γ₁, γ₃} = p₁ where the paper prints {γ₁, γ₂} = p₁."""
    common = {
        (gamma_2, gamma_3): d * p_2,
        (p_1, gamma_3): -gamma_1,
        (p_2, gamma_3): -d * gamma_2,
    }
    casimirs = (p_1**2 + gamma_1**2, p_2**2 + gamma_2**2)
    meaning = "Lie–Poisson bracket of a solvable algebra"
    printed = PoissonStructure(
        "bracket",
        skew({(gamma_1, gamma_2): p_1, **common}),
        casimirs=casimirs,
        rank=2,
        meaning=meaning,
        source="(3.8)",
    )
    return PoissonStructure(
        "bracket",
        skew({(gamma_1, gamma_3): p_1, **common}),
        casimirs=casimirs,
        rank=2,
        meaning=meaning,
        source="(3.8)",
        as_printed=printed,
        misprint="{γ₁, γ₂} = p₁ in place of {γ₁, γ₃} = p₁",
    )


def third_casimir() -> sp.Expr:
    """Argument of the complex function Φ₃ of Remark 10; its modulus is Φ₁^(d/2) Φ₂^(−1/2).

    It is many-valued: for irrational d its values at a point are dense.
    """
    return d * sp.atan2(gamma_1, p_1) - sp.atan2(gamma_2, p_2)


def build(numbers: Numbers) -> System:
    """ẋ = {x, H} with H = ½γ²."""
    structure = bracket()
    first, second = structure.casimirs
    return System(
        name="suslov-bracket",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=(
            Parameter(d, "ratio of the rates of the two rotations", numbers["d"], "1", (d > 0,)),
        ),
        field={
            p_1: -gamma_1 * gamma_3,
            p_2: -d * gamma_2 * gamma_3,
            gamma: constant([p_1 * gamma_3, d * p_2 * gamma_3, -p_1 * gamma_1 - d * p_2 * gamma_2]),
        },
        laws=(
            Integral("hamiltonian", norm_squared(gamma) / 2, "Hamiltonian function", source=SOURCE),
            Integral("first", first, "first Casimir function", source="§3.4, after (3.8)"),
            Integral("second", second, "second Casimir function", source="§3.4, after (3.8)"),
            structure,
            PoissonStructure(
                "third_casimir",
                structure.matrix,
                casimirs=(third_casimir(),),
                rank=2,
                meaning="third Casimir function, many-valued",
                source="Remark 10",
            ),
            ConformallyHamiltonian(
                "form",
                sp.S.One,
                structure,
                norm_squared(gamma) / 2,
                "Hamiltonian form",
                source=SOURCE,
            ),
            Measure("volume", {sp.S.One: sp.S.One}, "volume of p₁, p₂ and γ", source="§3.3"),
        ),
    )


def general() -> System:
    """The system with any d."""
    return build(DEFAULTS)


DEFAULTS = {"d": 1.4142135623730951}

ENTRIES = (
    Entry(
        name="suslov-bracket",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=DEFAULTS,
        build=build,
        start=Start(state={"p_1": 0.5, "p_2": 0.9, "gamma": (2 / 7, -3 / 7, 6 / 7)}, until=60.0),
    ),
)

"""The search finds the laws of the paper from the fields alone, and nothing that does not hold."""

from __future__ import annotations

import re
import sys
from dataclasses import replace
from typing import Any

import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Measure, Symmetry
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from lawproof.search import SearchResult, integrals, measures, search_space, symmetries
from lawproof.search.phase_space import restricted_system
from nonholonomic.catalogue import from_catalogue

M, omega, gamma, c = vectors("M omega gamma c")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
k, m, R, K = real_symbol("k"), real_symbol("m"), real_symbol("R"), real_symbol("K")


def bare(name: str) -> System:
    """A system of the catalogue without anything that is known of it."""
    return replace(from_catalogue(name), laws=())


def found_in(system: System, **options: Any) -> list[SearchResult]:
    """Integrals that the search comes upon, all of them proven."""
    found = list(integrals(search_space(system, **options)))
    assert all(finding.proven for finding in found), found
    return found


def points(system: System, count: int) -> list[dict[sp.Symbol, sp.Rational]]:
    """Rational points with γ² = 1, and (ω, γ) = 0 where ω belongs to the state."""
    found = []
    for i in range(count):
        a, b = sp.Rational(2 + i, 7), sp.Rational(5 - 3 * i, 4)
        length = 1 + a**2 + b**2
        n = sp.Matrix([2 * a, 2 * b, 2 - length]) / length
        u = sp.Matrix([i - 3, sp.Rational(7, 2 + i), 1 + i**2])
        first = system.state[0]
        u = n.cross(u) if first == omega else u
        found.append(dict(zip((*first.symbols, *gamma.symbols), (*u, *n), strict=True)))
    return found


def values(system: System, conditions: list[sp.Expr], formulas: list[sp.Expr]) -> sp.Matrix:
    """Exact values of formulas, points by formulas, for one choice of the parameters."""
    made = restricted_system(system, conditions)
    numbers = {s: sp.Rational(5 + 3 * i, 3 + i) for i, s in enumerate(made.free)}
    numbers |= {s: value.xreplace(numbers) for s, value in made.substitutions}
    rows = []
    for state in points(system, 3 + len(formulas)):
        known = {**numbers, **state}
        for symbol, value in system.required_definitions(formulas):
            known[symbol] = value.xreplace(known)
        rows.append([to_components(f).xreplace(known) for f in formulas])
    return sp.Matrix(rows)


def expresses(
    system: System, conditions: list[sp.Expr], found: list[SearchResult], expected: sp.Expr
) -> bool:
    """Whether a function is a polynomial of degree two in the integrals found."""
    simple = [finding.formula for finding in found]
    products = [a * b for i, a in enumerate(simple) for b in simple[i:]]
    table = values(system, conditions, [sp.S.One, *simple, *products, expected])
    return table.rank() == table[:, :-1].rank()


T = sp.Add(*I.symbols) + m * R**2
RIGHT = constant(sp.diag(*(T / 2 - moment for moment in I.symbols)))
PRINTED = constant(sp.diag(*(sp.Add(*I.symbols) / 2 - moment for moment in I.symbols)))
J_1, J_2, J_3 = J.symbols
RATIO = (
    norm_squared(J * omega) + J_1 * J_2 * J_3 * dot(omega, J * omega) * norm_squared(A * gamma)
) / dot(gamma, A * gamma)

PAPER = {
    "(7.2)": ("chaplygin-ball", {}, (dot(M, gamma), dot(M, omega) / 2)),
    "(7.4)": ("chaplygin-ball", {}, (norm_squared(M),)),
    "(8.2)": ("ball-on-sphere", {}, (norm_squared(M), dot(M, omega) / 2)),
    "(8.3)": ("ball-around-sphere", {"at": ["k = -1"]}, (dot(RIGHT * M, gamma),)),
    "(9.4)": (
        "rubber-ball-around-sphere",
        {"at": ["k = -1"], "divisors": ["(γ, A γ)"]},
        (dot(omega, J * omega) / 2, RATIO),
    ),
    "(6.4)": ("veselova", {}, (norm_squared(cross(I * omega, gamma)),)),
    "Remark 15": (
        "veselova-bruns",
        {},
        (norm_squared(cross(I * omega, gamma)) - K * sp.Mul(*I.symbols) * dot(gamma, A * gamma),),
    ),
    "(10.3)": (
        "unbalanced-ball",
        {},
        (norm_squared(M) - m * norm_squared(c - R * gamma) * dot(M, omega),),
    ),
    "(10.5)": (
        "unbalanced-rubber-ball",
        {},
        (norm_squared(cross(M, gamma)) + 2 * m * R * dot(gamma, c) * dot(M, omega),),
    ),
}
SLOW = {"(10.3)", "(10.5)"}


@pytest.mark.parametrize(
    "source", [pytest.param(s, marks=pytest.mark.slow) if s in SLOW else s for s in PAPER]
)
def test_integrals_of_the_paper_from_the_field_alone(source: str) -> None:
    name, options, expected = PAPER[source]
    system = bare(name)
    found = found_in(system, **options)
    conditions = [k + 1] if "at" in options else []
    for law in expected:
        assert expresses(system, conditions, found, law)


def test_the_matrix_of_the_linear_integral() -> None:
    system = bare("ball-around-sphere")
    found = found_in(system, at=["k=-1"], degree=1, gamma_degree=1)
    assert len(found) == 1
    (law,) = found
    ratio = values(system, [k + 1], [law.formula, dot(RIGHT * M, gamma)])
    assert len({row[0] / row[1] for row in ratio.tolist()}) == 1
    assert not expresses(system, [k + 1], found, dot(PRINTED * M, gamma))


@pytest.mark.parametrize("name", ["ball-on-sphere", "ball-around-sphere"])
def test_no_linear_integral_for_other_ratios(name: str) -> None:
    assert found_in(bare(name), degree=1) == []
    assert found_in(bare(name), degree=1, at=["k = -2"] if "around" in name else ["k = 2/3"]) == []


@pytest.mark.slow
def test_no_further_integral_of_the_chaplygin_ball() -> None:
    found = found_in(bare("chaplygin-ball"), degree=4, gamma_degree=3, divisors=[])
    assert len(found) == 3


def resting(count: int) -> System:
    """Variables that do not change: all are integrals, and so are their products."""
    names = [real_symbol(f"x_{i}") for i in range(count)]
    still = {name: sp.S.Zero for name in names}
    return System(name="resting", title="Rest", field=still)


def test_many_integrals_and_all_their_products() -> None:
    assert len(found_in(resting(5), degree=3)) == 5


def test_more_products_than_points_are_owned_up_to(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys.modules[integrals.__module__], "_RESERVE", 8)
    found = list(integrals(search_space(resting(4), degree=3)))
    assert found[-1].law is None
    assert "too many to tell" in found[-1].remark


@pytest.mark.slow
def test_what_is_known_is_named() -> None:
    found = found_in(from_catalogue("chaplygin-ball"))
    assert {finding.catalogue_law.partition(",")[0] for finding in found} == {
        "area",
        "momentum",
        "energy",
    }
    assert [finding.catalogue_law for finding in found_in(bare("chaplygin-ball"))] == ["", "", ""]


@pytest.mark.slow
def test_energy_over_a_denominator() -> None:
    """In M alone the energy is a fraction; ω does not occur in the ansatz."""
    system = replace(
        bare("chaplygin-ball"),
        definitions=tuple(
            (name, value)
            for name, value in bare("chaplygin-ball").definitions
            if getattr(name, "name", "") not in ("X", "omegadot", "N")
        ),
        observables=(),
        guards=(),
        reconstruction=None,
    )
    found = found_in(system, momenta="M", divisors=["1 - m*R**2*(γ, A γ)"])
    assert expresses(system, [], found, dot(M, omega))


@pytest.mark.slow
def test_the_square_of_an_integral_with_a_root() -> None:
    """K² of (5.1), K = ω₃ √(I₁γ₃² + I₃(1 − γ₃²) + m(r, γ)²), for a heavy rubber disk."""
    system = bare("rubber-disk")
    (found,) = found_in(
        system,
        at=["I_1 = I_2", "c_1 = 0", "c_2 = 0"],
        momenta="omega",
        coordinates="gamma_3, s",
        divisors=[],
    )
    r = vectors("r")[0]
    I_1, _, I_3 = I.symbols
    z = gamma.symbols[2]
    square = omega.symbols[2] ** 2 * (I_1 * z**2 + I_3 * (1 - z**2) + m * dot(r, gamma) ** 2)
    conditions = [I_1 - I.symbols[1], c.symbols[0], c.symbols[1]]
    table = values(system, conditions, [found.formula, square])
    assert len({sp.simplify(a / b) for a, b in table.tolist()}) == 1


def test_numbers_too_large_for_one_prime() -> None:
    """Two frequencies whose squares are ratios of large numbers."""
    x, y, p, q = (real_symbol(n) for n in ("x", "y", "p", "q"))
    square, other = sp.Rational(104_729, 7_919), sp.Rational(611_953, 99_991)
    system = System(
        name="oscillator",
        title="Oscillator",
        field={x: p, y: q, p: -square * x - y, q: -other * y - x},
    )
    found = found_in(system, momenta="p,q", coordinates="x,y")
    energy = p**2 + q**2 + square * x**2 + other * y**2 + 2 * x * y
    assert len(found) == 2
    scales = {sp.cancel(sp.Poly(f.formula, p, q, x, y).coeff_monomial(p * q)) for f in found}
    assert 0 in scales
    simple = [sp.Poly(f.formula, p, q, x, y) for f in found]
    rows = [
        [poly.coeff_monomial(m) for m in (p**2, q**2, p * q, x**2, y**2, x * y)]
        for poly in (*simple, sp.Poly(energy, p, q, x, y))
    ]
    assert sp.Matrix(rows).rank() == 2


def test_components_where_there_are_no_vectors() -> None:
    """A planar oscillator: two energies, and one more for two frequencies in ratio."""
    x, y, p, q, stiffness, mass = (
        real_symbol(n) for n in ("x", "y", "p", "q", "stiffness", "mass")
    )
    system = System(
        name="oscillator",
        title="Oscillator",
        field={x: p / mass, y: q / mass, p: -stiffness * x, q: -4 * stiffness * y},
        parameters=(Parameter(stiffness, "stiffness", 1.0), Parameter(mass, "mass", 1.0)),
    )
    assert len(found_in(system, momenta="p,q", coordinates="x,y")) == 2
    found = found_in(system, momenta="p,q", coordinates="x,y", gamma_degree=3)
    formulas = {sp.expand(finding.formula) for finding in found}
    assert {sp.expand(p**2 + stiffness * mass * x**2)} <= formulas
    assert {sp.expand(q**2 + 4 * stiffness * mass * y**2)} <= formulas
    # of the resonance 2 : 1
    third = x * p * q - y * p**2 + stiffness * mass * x**2 * y
    assert {sp.expand(third), sp.expand(-third)} & formulas
    assert len(found) == 3
    # a fourth polynomial is a function of these three
    assert len(found_in(system, momenta="p,q", coordinates="x,y", degree=3, gamma_degree=3)) == 3


MEASURES = {
    "(6.3)": ("veselova", dot(gamma, A * gamma), sp.Rational(1, 2)),
    "(7.3)": ("chaplygin-ball", 1 - m * R**2 * dot(gamma, A * gamma), -sp.Rational(1, 2)),
    "(9.3)": ("rubber-ball-on-sphere", dot(gamma, A * gamma), 1 / (2 * k)),
}


@pytest.mark.parametrize("source", MEASURES)
def test_measures_of_the_paper_from_the_field_alone(source: str) -> None:
    name, base, exponent = MEASURES[source]
    (found,) = measures(search_space(bare(name)))
    assert found.proven
    assert isinstance(found.law, Measure)
    ((found_base, found_exponent),) = found.law.density
    assert sp.expand(found_exponent - exponent) == 0
    assert sp.expand(to_components(found_base - base)) == 0


@pytest.mark.slow
def test_measures_that_are_singular_or_have_several_factors() -> None:
    (sleigh,) = measures(search_space(bare("chaplygin-sleigh")))
    assert sleigh.proven
    assert sleigh.formula == 1 / real_symbol("Omega")
    symmetric = ["I_1 = I_2", "c_1 = 0", "c_2 = 0"]
    found = list(measures(search_space(bare("rubber-routh-sphere"), at=symmetric)))
    assert found
    assert all(finding.proven for finding in found)


def test_a_given_base_and_none_that_fits() -> None:
    system = bare("veselova")
    (found,) = measures(search_space(system, bases=["(γ, A γ)"]))
    assert found.proven
    assert list(measures(search_space(system, bases=["(γ, I γ)"]))) == []
    assert list(measures(search_space(bare("unbalanced-ball")))) == []


def test_the_measure_of_a_divergence_free_field_is_the_volume() -> None:
    (found,) = measures(search_space(bare("lagrange-top")))
    assert found.proven
    assert found.formula == 1


def test_the_measure_of_a_phase_space_that_a_field_approaches() -> None:
    """ẋ = −x on x = 0 beside ẏ = y/2, ż = −z/2: the volume there is dy dz, and it is kept."""
    x, y, z = (real_symbol(n) for n in "xyz")
    system = System(
        name="saddle",
        title="Saddle",
        field={x: -x, y: y / 2, z: -z / 2},
        relations=(x,),
    )
    (found,) = measures(search_space(system, bases=[]))
    assert found.proven
    assert found.formula == 1


def test_rotations_of_a_symmetric_body() -> None:
    (found,) = symmetries(
        search_space(bare("veselova"), at=["I_1 = I_2"], degree=1, gamma_degree=1)
    )
    assert found.proven
    assert isinstance(found.law, Symmetry)
    field = {name: sp.Matrix(value) for name, value in found.law.field}
    turn = sp.Matrix([[0, -1, 0], [1, 0, 0], [0, 0, 0]])
    (sign,) = {field[gamma][1] / gamma.symbols[0]}
    assert field[omega] == sign * turn * sp.Matrix(omega.symbols)
    assert field[gamma] == sign * turn * sp.Matrix(gamma.symbols)
    assert list(symmetries(search_space(bare("veselova"), degree=1, gamma_degree=1))) == []


def test_powers_of_an_integral_of_the_coordinates_are_not_repeated() -> None:
    x, y, p = (real_symbol(n) for n in ("x", "y", "p"))
    system = System(name="wheel", title="Wheel", field={x: y * p, y: -x * p, p: sp.S.Zero})
    found = found_in(system, momenta="p", coordinates="x,y", degree=2, gamma_degree=4)
    assert p in [finding.formula for finding in found]
    assert len(found) == 2


def test_neither_the_field_nor_its_multiples_count_as_symmetries() -> None:
    x, y = real_symbol("x"), real_symbol("y")
    circle = System(name="circle", title="Circle", field={x: y, y: -x})
    for degree in (1, 3):
        (found,) = symmetries(search_space(circle, degree=degree))
        assert found.proven
        assert isinstance(found.law, Symmetry)
        assert found.law.field in (((x, x), (y, y)), ((x, -x), (y, -y)))


def test_divisors_depend_on_coordinates_alone() -> None:
    x, p = real_symbol("x"), real_symbol("p")
    system = System(
        name="line", title="Line", field={x: p / (1 + p**2) / (2 + x**2), p: x / (3 + x)}
    )
    question = search_space(system, momenta="p", coordinates="x")
    assert set(question.divisors) == {2 + x**2, 3 + x}
    assert {1 + p**2, x, p} <= set(question.bases)


@pytest.mark.slow
def test_the_energy_of_a_rattleback() -> None:
    """Its shape is a tensor with entries that are zero, its contact point no polynomial."""
    system = bare("rattleback")
    (found,) = found_in(system, divisors=[])
    (r,) = vectors("r")
    energy = dot(M, omega) / 2 - m * real_symbol("g") * dot(r, gamma)
    made = restricted_system(system).sample(20, 3, common=True)
    assert not made.along(made(energy)).any()
    ratio = made(found.formula / energy)
    assert len(set(ratio.value.tolist())) == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"degree": 40, "gamma_degree": 12}, "GB"),
        ({"degree": -1}, "must not be negative"),
        ({"effort": 0}, "must be a positive number of term operations"),
        ({"at": ["q = 1"]}, "unknown name 'q'"),
        ({"at": ["gamma_1 = 1"]}, "unknown name 'gamma_1'"),
        ({"at": ["1 = 2"]}, "mentions no parameter"),
        ({"at": ["R = 0"]}, "R > 0 is required"),
        ({"at": ["m**2 + m = 5"]}, "linear in one of"),
        ({"at": ["m = 1", "m = 2"]}, "cannot be solved"),
        ({"level": ["M·beta"]}, "no vector or tensor 'beta'"),
        ({"level": ["(γ M, γ)"]}, "only tensors multiply"),
        ({"level": ["(γ, J)"]}, "is a tensor"),
        ({"level": ["M² + 1"]}, "is empty"),
        ({"level": ["γ² = 2"]}, "is empty"),
        ({"level": ["M_1"]}, "is not invariant"),
        ({"level": ["M·γ +"]}, "level"),
        ({"momenta": "beta"}, "unknown variable 'beta'"),
        ({"momenta": "M", "coordinates": "M_1, gamma"}, "both a momentum and a coordinate"),
        ({"divisors": ["beta"]}, "unknown name 'beta'"),
    ],
)
def test_mistakes_are_told_in_a_sentence(options: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=re.escape(words)):
        search_space(bare("chaplygin-ball"), **options)


def test_symmetries_need_more_room_than_integrals() -> None:
    question = search_space(bare("chaplygin-ball"), degree=4, gamma_degree=4, divisors=[])
    with pytest.raises(InputError, match="60,060 coefficients"):
        next(symmetries(replace(question, ansatz=replace(question.ansatz, gamma_degree=10))))


def test_a_field_with_an_arc_tangent_is_refused() -> None:
    x, y = real_symbol("x"), real_symbol("y")
    system = System(name="odd", title="Odd", field={x: sp.atan(y), y: x})
    with pytest.raises(InputError, match="atan"):
        list(integrals(search_space(system)))


@pytest.mark.slow
def test_an_integral_on_a_level() -> None:
    """On (M, γ) = 0 the area is no integral worth mentioning."""
    found = found_in(bare("chaplygin-ball"), level=["M·γ = 0"])
    assert len(found) == 2
    assert all(finding.law is not None and finding.law.level for finding in found)


def test_progress_runs_from_nothing_to_all() -> None:
    seen: list[float] = []
    question = search_space(bare("veselova"), divisors=[])
    list(integrals(question, lambda fraction, _: seen.append(fraction)))
    assert seen[0] == 0.0
    assert seen[-1] == 1.0
    assert seen == sorted(seen)

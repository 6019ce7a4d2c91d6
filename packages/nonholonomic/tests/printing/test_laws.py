"""Laws of every kind as they stand on a page."""

from __future__ import annotations

import pytest
import sympy as sp

from flowlanes.printing.formula import text
from flowlanes.printing.laws import caption, condition_text, equation_sides
from flowlanes.printing.notation import LATEX, UNICODE, Notation
from flowlanes.printing.system import claims_html, law_html, law_latex, system_html, system_text
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Separation,
    Symmetry,
)
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import hat, unit_vector
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from nonholonomic.catalogue import from_catalogue

M, gamma = vectors("M gamma")
A = Diagonal("A")
k, s, tau, q, theta, p = (real_symbol(name) for name in ("k", "s", "tau", "q", "theta", "p"))
half = sp.Rational(1, 2)
spin, up = hat(M), hat(gamma)
LIE = spin.row_join(up).col_join(up.row_join(sp.zeros(3, 3)))
BRACKET = PoissonStructure(
    "lie", -LIE, casimirs=(norm_squared(gamma), dot(M, gamma)), rank=4, meaning="algebra e(3)"
)


def body(*laws: Law) -> System:
    """A free top, of which anything may be claimed."""
    return System(
        name="top",
        title="Top",
        parameters=tuple(Parameter(symbol, "", 1.0) for symbol in (*A.symbols, k)),
        field={M: cross(M, A * M), gamma: cross(gamma, A * M)},
        relations=(norm_squared(gamma) - 1,),
        laws=laws,
    )


def lines(law: Law, system: System | None = None) -> list[str]:
    """What a law says, in one line of text for each equation."""
    found = equation_sides(law, system or body(law), UNICODE)
    shown = [(left, right if isinstance(right, str) else text(right)) for left, right in found]
    return [f"{left} = {right}" if left else right for left, right in shown]


def shared(entries: sp.MatrixBase) -> PoissonStructure:
    """A bracket of γ with M whose entries have no pattern."""
    return PoissonStructure("own", sp.zeros(3, 3).row_join(entries).col_join(sp.zeros(3, 6)))


PAGES: list[tuple[Law, str, list[str]]] = [
    (Measure("m", {dot(gamma, A * gamma): half}), "Invariant measure", ["ρ = √(γ, A γ)"]),
    (
        Measure("m", {s: -1, k: 1 / (2 * k)}),
        "Invariant measure",
        ["ρ = k^(1 / (2 k)) / s"],
    ),
    (
        Symmetry("u", {M: cross(M, unit_vector(3)), gamma: cross(gamma, unit_vector(3))}),
        "Symmetry field",
        ["u = (M × e₃, ∂/∂M)", "+ (γ × e₃, ∂/∂γ)"],
    ),
    (
        BRACKET,
        "Poisson bracket",
        [
            "{Mᵢ, Mⱼ} = εᵢⱼₖ Mₖ",
            "{Mᵢ, γⱼ} = εᵢⱼₖ γₖ",
            "Casimir functions γ², (M, γ); rank 4",
        ],
    ),
    (
        PoissonStructure("own", (LIE - sp.diag(k * up, sp.zeros(3, 3))) / s),
        "Poisson bracket",
        ["{Mᵢ, Mⱼ} = 1 / s εᵢⱼₖ (k γₖ − Mₖ)", "{Mᵢ, γⱼ} = −1 / s εᵢⱼₖ γₖ"],
    ),
    (
        PoissonStructure("own", sp.diag(hat(to_components(A * M)), sp.zeros(3, 3))),
        "Poisson bracket",
        ["{Mᵢ, Mⱼ} = εᵢⱼₖ wₖ", "w = (−A₁ M₁, −A₂ M₂, −A₃ M₃)"],
    ),
    (shared(k * sp.eye(3)), "Poisson bracket", ["{Mᵢ, γⱼ} = δᵢⱼ k"]),
    (shared(sp.eye(3)), "Poisson bracket", ["{Mᵢ, γⱼ} = δᵢⱼ"]),
    (
        shared(s * sp.diag(1, 2, 3)),
        "Poisson bracket",
        ["{Mᵢ, γⱼ} = s Bᵢⱼ", "B = diag(1, 2, 3)"],
    ),
    (
        ConformallyHamiltonian("h", 1 / s, BRACKET, half * dot(M, A * M)),
        "Conformally Hamiltonian form",
        [
            "ẋ = N {x, H}",
            "N = 1 / s",
            "H = ½ (M, A M)",
            "{Mᵢ, Mⱼ} = εᵢⱼₖ Mₖ",
            "{Mᵢ, γⱼ} = εᵢⱼₖ γₖ",
            "Casimir functions γ², (M, γ); rank 4",
        ],
    ),
    (
        ConformallyHamiltonian("h", sp.S.One, BRACKET, half * dot(M, A * M)),
        "Hamiltonian form",
        ["ẋ = {x, H}", "H = ½ (M, A M)"],
    ),
    (
        Reduction("r", {q: gamma.symbols[2]}, (Rate(q) ** 2 - k * q, q - Rate(Rate(q)), q**2 - 1)),
        "Reduction",
        ["q = γ₃", "q̇² = k q", "q̈ = q", "q² = 1"],
    ),
    (Separation("r", {q: k}, (Rate(q),)), "Separation of variables", ["q = k", "q̇ = 0"]),
    (Identity("i", (dot(M, gamma), Rate(k * q))), "Identity", ["0 = (M, γ)", "0 = d (k q)/dt"]),
    (Identity("i", cross(M, gamma)), "Identity", ["0 = M × γ"]),
]


@pytest.mark.parametrize(("law", "kind", "expected"), PAGES)
def test_laws_as_on_paper(law: Law, kind: str, expected: list[str]) -> None:
    assert law.heading == kind
    known = (law, BRACKET) if kind == "Hamiltonian form" else (law,)
    assert lines(law, body(*known)) == expected


def test_variables_and_constants_of_another_system_are_primed_where_they_clash() -> None:
    law = Isomorphism(
        "i", body(), {M: k * M, gamma: gamma}, 1 / k, {A.symbols[0]: A.symbols[1], k: sp.S.One}
    )
    assert law.heading == "The same motion as: Top"
    expected = ["M′ = k M", "γ′ = γ", "A′₁ = A₂", "k′ = 1", "dτ/dt = 1 / k"]
    assert lines(law) == expected
    plane = System(name="line", title="Line", field={theta: p, p: sp.S.Zero})
    free = Isomorphism("i", plane, {theta: M.symbols[0], p: sp.S.Zero})
    assert lines(free) == ["θ = M₁", "p = 0"]


@pytest.mark.parametrize(
    ("on", "expected"),
    [
        ((), ""),
        ((k + 1,), "for k = −1"),
        ((1 - k,), "for k = 1"),
        ((dot(M, gamma),), "on (M, γ) = 0"),
        ((A.symbols[0] - A.symbols[1],), "for A₁ = A₂"),
        ((k * k - k - 1,), "for k² − k = 1"),
        ((dot(M, gamma) - 2, k), "for k = 0 on (M, γ) = 2"),
    ],
)
def test_levels(on: tuple[sp.Expr, ...], expected: str) -> None:
    assert condition_text(Integral("f", k, level=on), body(), text) == expected


def test_captions() -> None:
    law = Integral("f", k, "spin", level=(k + 1,), source="(1.2)", misprint="the sign of k")
    assert caption(law, body(), text) == (
        "spin, for k = −1; (1.2) (misprinted there: the sign of k)"
    )
    named = Measure("m", {k: 1}, "invariant measure", source="(7.3)")
    assert caption(named, body(), text) == "(7.3)"
    assert caption(Identity("i", k), body(), text) == ""


def test_every_formula_of_a_law_counts() -> None:
    """What a law shows is defined on the page."""
    lever = real_symbol("lever")
    for law in (
        Symmetry("u", {M: lever * M}),
        PoissonStructure("p", lever * LIE),
        PoissonStructure("p", LIE, casimirs=(lever,)),
        ConformallyHamiltonian("h", lever, BRACKET, k),
        ConformallyHamiltonian("h", k, BRACKET, lever),
        Isomorphism("i", body(), {M: lever * M, gamma: gamma}),
        Isomorphism("i", body(), {M: M, gamma: gamma}, lever),
        Isomorphism("i", body(), {M: M, gamma: gamma}, constants={k: lever}),
        Reduction("r", {q: lever}, (Rate(q),)),
        Reduction("r", {q: k}, (Rate(q) - lever,)),
        Identity("i", (k, lever)),
        Measure("m", {k: lever}),
        Measure("m", {k: 1}, level=(lever,)),
    ):
        assert any(lever in to_components(formula).free_symbols for formula in law.formulas)


def _defined(law: Law) -> System:
    system = body()
    return System(
        name="top",
        title="Top",
        parameters=system.parameters,
        field=system.field,
        definitions={s: dot(gamma, A * gamma)},
        laws=(law,),
    )


def test_definitions_that_laws_need_are_on_the_page() -> None:
    page = system_text(_defined(Measure("m", {s: half})))
    assert page.endswith("ρ = √s\n\nIn the laws\n    s = (γ, A γ)")
    assert "In the laws" in claims_html(_defined(Measure("m", {s: half})))
    assert claims_html(body()) == ""


@pytest.mark.parametrize("law", [law for law, *_ in PAGES])
def test_laws_in_html_and_latex(law: Law) -> None:
    system = body(law)
    page = law_html(law, system)
    assert law.heading in page
    assert page.count("<math") >= 1
    assert page in system_html(system)
    written = law_latex(law, system)
    assert written.count("{") == written.count("}")
    assert all(left in written for left, _ in equation_sides(law, system, LATEX))


def test_the_level_is_typeset_in_captions() -> None:
    page = law_html(Measure("m", {k: 1}, "named", level=(k + 1,)), body())
    assert "named, for <math" in page
    assert page.partition("caption")[2].count("<math") == 1


@pytest.mark.parametrize(
    ("system", "law", "rows"),
    [("neumann", "hamiltonian", 1), ("rubber-ball-on-sphere", "ratio", 2)],
)
@pytest.mark.parametrize("notation", [UNICODE, LATEX])
def test_no_name_is_said_to_be_itself(system: str, law: str, rows: int, notation: Notation) -> None:
    """It was printed H = H, and J₁ = J₁."""
    known = from_catalogue(system)
    (stated,) = (item for item in known.laws if item.name == law)
    assert len(equation_sides(stated, known, notation)) == rows

"""Formulas read as on paper: golden lines, and pages of every system there is."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from typing import Any

import pytest
import sympy as sp

from catalogue import built
from every_system import CASES, bare, laden
from flowlanes.printing.formula import latex, rate, text, width
from flowlanes.printing.mathml import mathml
from flowlanes.printing.notation import LATEX, UNICODE
from flowlanes.printing.system import (
    WIDTH,
    motion_html,
    motion_text,
    system_html,
    system_latex,
    system_text,
)
from flowlanes.system.laws import Integral, Rate
from flowlanes.system.system import Parameter, Reconstruction, System
from flowlanes.system.vector_operators import gradient, outer, unit_vector
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    constant,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    vectors,
    zero,
)
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import rolling_system
from nonholonomic.mechanics.shapes.shapes import Ball

M, omega, gamma, r, rdot = vectors("M omega gamma r rdot")
A, I = Diagonal("A"), Diagonal("I")
a, b, m, g, R, s, x, y = (real_symbol(name) for name in ("a", "b", "m", "g", "R", "s", "x", "y"))
half = sp.Rational(1, 2)
U = sp.Function("U", real=True)

GOLDEN = [
    # names
    (real_symbol("I_1"), "I₁", r"I_{1}"),
    (real_symbol("gamma_3"), "γ₃", r"\gamma_{3}"),
    (real_symbol("slip_rate"), "slip_rate", r"\text{slip rate}"),
    (m * real_symbol("slip_rate") * R, "m R slip_rate", r"m R \, \text{slip rate}"),
    (real_symbol("spin_sign"), "σₙ", r"\sigma_{n}"),
    (real_symbol("lambda_0"), "λ₀", r"\lambda_{0}"),
    (real_symbol("pprime"), "p′", r"p^{\prime}"),
    (real_symbol("pprime2"), "p″", r"p^{\prime\prime}"),
    (real_symbol("ell"), "ℓ", r"\ell"),
    (real_symbol("A_a"), "Aₐ", r"A_{a}"),
    (real_symbol("F_23"), "F₂₃", r"F_{23}"),
    (real_symbol("I_Q"), "I_Q", r"I_{Q}"),
    (real_symbol("e_z"), "e_z", r"e_{z}"),
    (real_symbol("omegadot_2"), "ω̇₂", r"\dot{\omega}_{2}"),
    (rdot, "ṙ", r"\dot{\mathbf{r}}"),
    (Vector("gammadot"), "γ̇", r"\dot{\boldsymbol{\gamma}}"),
    (Vector("Itilde"), "Ĩ", r"\tilde{\mathbf{I}}"),
    (real_symbol("attitude_w"), "q_w", "q_{w}"),
    # rates and functions left open
    (Rate(x), "ẋ", r"\dot{x}"),
    (Rate(Rate(x)) / a, "ẍ / a", r"\frac{\ddot{x}}{a}"),
    (Rate(real_symbol("gamma_3")) ** 2, "γ̇₃²", r"\dot{\gamma}_{3}^{2}"),
    (Rate(a * x), "d (a x)/dt", r"\frac{d \left(a x\right)}{dt}"),
    (Rate(Rate(a * x)), "d² (a x)/dt²", None),
    (U(*gamma.symbols), "U(γ)", r"U\left(\boldsymbol{\gamma}\right)"),
    (U(x, *gamma.symbols) ** 2, "U(x, γ)²", None),
    (sp.diff(U(x), x), "U′(x)", r"U^{\prime}\left(x\right)"),
    (sp.diff(U(x), x, 2), "U″(x)", r"U^{\prime\prime}\left(x\right)"),
    (
        a * sp.diff(U(*gamma.symbols), gamma.symbols[0]),
        "a ∂U/∂γ₁",
        r"a \frac{\partial U}{\partial \gamma_{1}}",
    ),
    (
        sp.diff(U(x, y), x, y, y),
        "∂³U/(∂x ∂y²)",
        r"\frac{\partial^{3} U}{\partial x \partial y^{2}}",
    ),
    (sp.cot(x), "cot(x)", r"\cot\left(x\right)"),
    # numbers
    (sp.Rational(-3, 7), "−3 / 7", r"-\frac{3}{7}"),
    (half * x, "½ x", r"\frac{1}{2} x"),
    (sp.Rational(3, 7) * x, "3 x / 7", r"\frac{3}{7} x"),
    (sp.Float(0.1) * x, "0.1 x", "0.1 x"),
    (sp.Float(-2.5e-9), "−2.5e-09", r"-2.5 \cdot 10^{-9}"),
    (sp.pi * x / 2, "½ π x", r"\frac{1}{2} \pi x"),
    # scalars
    (m * g * R, "m g R", "m g R"),
    (x**2 - y**2, "x² − y²", "x^{2} - y^{2}"),
    (x**10 / (a * b), "x¹⁰ / (a b)", r"\frac{x^{10}}{a b}"),
    ((x + y) / (1 - x), "(x + y) / (1 − x)", r"\frac{x + y}{1 - x}"),
    (1 / x, "1 / x", r"\frac{1}{x}"),
    (-(x + y) / s**3, "−(x + y) / s³", r"-\frac{x + y}{s^{3}}"),
    (x * (a - b), "x (a − b)", r"x \left(a - b\right)"),
    (x - 1, "x − 1", "x - 1"),
    (-x - y, "−x − y", "-x - y"),
    ((x + y) ** 2, "(x + y)²", r"\left(x + y\right)^{2}"),
    (x ** sp.Rational(3, 2), "x^(3/2)", "x^{3/2}"),
    (sp.sqrt(1 + x**2), "√(1 + x²)", r"\sqrt{1 + x^{2}}"),
    (real_symbol("pprime") ** 2, "p′²", r"\left(p^{\prime}\right)^{2}"),
    (sp.sin(x) ** 2 * b**2, "b² sin²(x)", r"b^{2} \sin^{2}\left(x\right)"),
    (sp.atan2(y, x), "atan2(y, x)", r"\operatorname{atan2}\left(y, x\right)"),
    (sp.acos(x), "arccos(x)", r"\arccos\left(x\right)"),
    (sp.Abs(x - y), "|x − y|", r"\left|x - y\right|"),
    (half * (x + y - a), "½ (x + y − a)", r"\frac{1}{2} \left(x + y - a\right)"),
    (x >= 0, "x ≥ 0", r"x \geq 0"),
    (sp.Ne(a, 0), "a ≠ 0", r"a \neq 0"),
    # scalar products
    (dot(M, gamma), "(M, γ)", r"\left(\mathbf{M}, \boldsymbol{\gamma}\right)"),
    (norm_squared(M), "M²", r"\mathbf{M}^{2}"),
    (norm_squared(gamma) ** 2, "γ⁴", r"\boldsymbol{\gamma}^{4}"),
    (norm_squared(A * gamma), "(A γ)²", r"\left(\mathbf{A} \boldsymbol{\gamma}\right)^{2}"),
    (sp.sqrt(norm_squared(r)), "|r|", r"\left|\mathbf{r}\right|"),
    (1 / sp.sqrt(norm_squared(r)) ** 3, "1 / |r|³", r"\frac{1}{\left|\mathbf{r}\right|^{3}}"),
    (dot(M, gamma) ** 2, "(M, γ)²", r"\left(\mathbf{M}, \boldsymbol{\gamma}\right)^{2}"),
    (
        sp.sqrt(dot(gamma, A * gamma)),
        "√(γ, A γ)",
        r"\sqrt{\left(\boldsymbol{\gamma}, \mathbf{A} \boldsymbol{\gamma}\right)}",
    ),
    (
        half * dot(M, omega) + m * g * R,
        "½ (M, ω) + m g R",
        r"\frac{1}{2} \left(\mathbf{M}, \boldsymbol{\omega}\right) + m g R",
    ),
    # vectors
    (zero, "0", "0"),
    (unit_vector(3), "e₃", r"\mathbf{e}_{3}"),
    (gamma - x * unit_vector(3), "γ − x e₃", r"\boldsymbol{\gamma} - x \mathbf{e}_{3}"),
    (x * unit_vector(2), "x e₂", r"x \mathbf{e}_{2}"),
    ((x + y) * unit_vector(1), "(x + y) e₁", None),
    (constant([x, -y, 0]), "(x, −y, 0)", r"\left(x,\, -y,\, 0\right)"),
    (cross(M, omega), "M × ω", r"\mathbf{M} \times \boldsymbol{\omega}"),
    (
        m * cross(rdot, cross(omega, r)),
        "m ṙ × (ω × r)",
        r"m \dot{\mathbf{r}} \times \left(\boldsymbol{\omega} \times \mathbf{r}\right)",
    ),
    (cross(I * omega, omega), "I ω × ω", None),
    (A * cross(gamma, omega), "A (γ × ω)", None),
    (-R * gamma, "−R γ", r"-R \boldsymbol{\gamma}"),
    (Vector("c") - R * gamma, "c − R γ", r"\mathbf{c} - R \boldsymbol{\gamma}"),
    (A * (r - R * gamma), "A (r − R γ)", None),
    (-A * gamma / s, "−A γ / s", r"-\frac{1}{s} \mathbf{A} \boldsymbol{\gamma}"),
    (
        dot(A * r, M) / (1 - m * dot(r, A * r)) * m * (A * r),
        "m (A r, M) A r / (1 − m (r, A r))",
        r"\frac{m \left(\mathbf{A} \mathbf{r}, \mathbf{M}\right)}"
        r"{1 - m \left(\mathbf{r}, \mathbf{A} \mathbf{r}\right)} \mathbf{A} \mathbf{r}",
    ),
    (
        cross(gamma, gradient(gamma.symbols[0] ** 2, gamma)),
        "γ × ∂U/∂γ",
        r"\boldsymbol{\gamma} \times \frac{\partial U}{\partial \boldsymbol{\gamma}}",
    ),
    # tensors
    (I + m * norm_squared(r) * identity, "I + m r² E", r"\mathbf{I} + m \mathbf{r}^{2} \mathbf{E}"),
    (
        I + m * norm_squared(r) * identity - m * outer(r, r),
        "I + m r² E − m r ⊗ r",
        r"\mathbf{I} + m \mathbf{r}^{2} \mathbf{E} - m \mathbf{r} \otimes \mathbf{r}",
    ),
    (outer(A * r, gamma) * M, "(A r ⊗ γ) M", None),
    (Symmetric("J") ** -1, "J⁻¹", r"\mathbf{J}^{-1}"),
    (constant(sp.diag(a, b, 0)), "diag(a, b, 0)", r"\operatorname{diag}\left(a, b, 0\right)"),
    (
        constant([[a, b], [0, 1]]),
        "[a, b; 0, 1]",
        r"\begin{pmatrix} a & b \\ 0 & 1 \end{pmatrix}",
    ),
]


@pytest.mark.parametrize(("formula", "plain", "tex"), GOLDEN, ids=[row[1] for row in GOLDEN])
def test_golden(formula: Any, plain: str, tex: str | None) -> None:
    assert text(formula) == plain
    assert tex is None or latex(formula) == tex
    ET.fromstring(mathml(latex(formula)))


def test_rates_get_a_dot() -> None:
    assert rate(M, UNICODE) == "Ṁ"
    assert rate(real_symbol("theta"), UNICODE) == "θ̇"
    assert rate(real_symbol("thetadot"), UNICODE) == "θ̈"
    assert rate(Vector("attitude", 4), UNICODE) == "q̇"
    assert rate(gamma, LATEX) == r"\dot{\boldsymbol{\gamma}}"
    assert rate(Vector("attitude", 4), LATEX) == r"\dot{\mathbf{q}}"


def test_accents_take_no_column() -> None:
    assert width("γ̇ = γ × ω") == 9


BALL = """\
Chaplygin ball
A rigid body rolls without slipping (marble contact) on a horizontal plane.

Equations of motion
    Ṁ = M × ω
    γ̇ = γ × ω
where
    I = diag(I₁, I₂, I₃)
    J = I + m R² E
    A = J⁻¹
    ω = A M + m R² (A γ, M) A γ / (1 − m R² (γ, A γ))
on the phase space
    γ² = 1

Parameters
    m   1    kg     mass
    I₁  1    kg m²  moment of inertia about body axis 1
    I₂  1.5  kg m²  moment of inertia about body axis 2
    I₃  2.1  kg m²  moment of inertia about body axis 3
    R   1    m      radius of the ball

Constant along the motion
    energy  ½ (M, ω)
            energy; (3.3), Theorem 1

Source: (1.17), (10.1)"""


def test_page_of_the_chaplygin_ball() -> None:
    body = Body(1.0, (1.0, 1.5, 2.1), Ball(1.0))
    system = rolling_system(body, name="chaplygin-ball", title="Chaplygin ball")
    assert system_text(system) == BALL
    assert str(system) == BALL


def small(**more: Any) -> System:
    q, v, k = real_symbol("q"), real_symbol("v"), real_symbol("k")
    values: dict[str, Any] = {
        "field": {q: v, v: -k * q},
        "parameters": (Parameter(k, "stiffness", -0.5, "1/s^2"),),
    }
    return System("spring", "A <spring>", **{**values, **more})


def test_page_of_a_system_with_little_to_say() -> None:
    assert system_text(small(parameters=(), field={real_symbol("q"): sp.S.One})) == (
        "A <spring>\n\nEquations of motion\n    q̇ = 1"
    )


def test_conditions_and_numbers_on_the_page() -> None:
    k, q, v = real_symbol("k"), real_symbol("q"), real_symbol("v")
    law = Integral("energy", v**2 + k * q**2, "twice the energy", level=(k + 1,), source="(2)")
    lines = system_text(small(laws=(law,))).splitlines()
    assert "    k  −0.5  1/s²  stiffness" in lines
    assert "    energy  v² + k q²" in lines
    assert "            twice the energy, for k = −1; (2)" in lines
    fragment = system_html(small(laws=(law,)))
    assert "twice the energy, for <math" in fragment
    assert "<h3>A &lt;spring&gt;</h3>" in fragment


def test_definitions_of_laws_alone_stand_with_the_laws() -> None:
    q, v, w = real_symbol("q"), real_symbol("v"), real_symbol("w")
    law = Integral("energy", w, "energy")
    page = system_text(small(definitions={w: v**2 / 2}, laws=(law,)))
    equations, laws = page.split("Constant along the motion")
    assert "w = " not in equations
    assert "In the laws\n    w = ½ v²" in laws
    assert str(q) in equations


def test_a_rate_that_is_only_a_name_is_spelt_out() -> None:
    page = system_text(bare("ellipsoid", "sphere", "marble"))
    assert "γ̇ = γ̇" not in page
    assert sum(line.startswith("    γ̇ = ") for line in page.splitlines()) == 1


def test_a_rate_that_is_a_name_of_the_state_says_nothing() -> None:
    q, qdot = real_symbol("q"), real_symbol("qdot")
    page = system_text(small(parameters=(), field={q: qdot, qdot: -q}))
    assert page == "A <spring>\n\nEquations of motion\n    q̈ = −q"


def test_the_lift_has_a_page_of_its_own() -> None:
    x, w, v, ydot, y = (real_symbol(name) for name in ("x", "w", "v", "ydot", "y"))
    lifted = small(
        definitions={w: 2 * v, ydot: 3 * v}, reconstruction=Reconstruction({x: w, y: ydot}, (), ())
    )
    assert motion_text(lifted) == ["    ẋ = w", "    ẏ = 3 v", "    w = 2 v"]
    assert "ẋ" not in system_text(lifted)
    assert motion_html(lifted).count('class="left"') == 3
    assert motion_text(small()) == []
    assert motion_html(small()) == ""


def test_long_formulas_are_broken_before_an_operator() -> None:
    x, y = real_symbol("x"), real_symbol("y")
    long = sp.Add(*(x**i * y ** (20 - i) for i in range(20)))
    lines = system_text(
        small(definitions={real_symbol("w"): long}, field={x: y, y: real_symbol("w")})
    )
    wrapped = [line for line in lines.splitlines() if line.startswith(" " * 8)]
    assert wrapped
    assert all(re.match(r" {8}[+−] ", line) for line in wrapped)


# What would betray SymPy's own way of writing, or a name as spelt in code.
RAW = re.compile(
    r"(?<!T)\*|Dot\(|Cross\(|MatMul|MatAdd|Transpose|Gradient|Matrix|Identity\(|_\d"
    r"|gamma|omega|lambda|kappa|sigma|zeta|delta|rho|tau|prime|dot\b|sqrt|  −  "
)


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES, ids="-".join)
def test_every_page_is_plain_and_fits(case: tuple[str, str, str]) -> None:
    for system in (bare(*case), laden(*case), laden(*case).lifted()):
        page = system_text(system)
        assert RAW.findall(page) == []
        assert max(map(width, page.splitlines())) <= WIDTH
        assert page.count("(") == page.count(")")
        assert not re.search(r"[ ]$", page, re.MULTILINE)


def test_every_page_of_the_catalogue_is_plain_and_fits() -> None:
    pages = {name: system_text(built.system(name)) for name in CATALOGUE}
    assert {name: raw for name, page in pages.items() if (raw := RAW.findall(page))} == {}
    wide = [
        (name, line)
        for name, page in pages.items()
        for line in page.splitlines()
        if width(line) > WIDTH
    ]
    assert wide == []


def well_formed(fragment: str) -> ET.Element:
    """The element tree, after a look at what the converter leaves when it does not understand."""
    assert "\\" not in fragment
    assert "mathvariant" not in fragment
    return ET.fromstring(fragment)


@pytest.mark.slow
def test_a_factor_before_a_function_is_set_off() -> None:
    """It read usin(φ) for u sin(φ)."""
    space = '<mspace width="0.17em"/>'
    written = mathml(r"u \sin(\varphi) - 2 \cos x \sin x + \sin(x)")
    assert written.count(space) == 3
    assert f"<mi>u</mi>{space}<mi>sin</mi>" in written
    assert f"<mn>2</mn>{space}<mi>cos</mi>" in written


@pytest.mark.parametrize("case", CASES, ids="-".join)
def test_latex_becomes_mathml(case: tuple[str, str, str]) -> None:
    system = laden(*case)
    written = system_latex(system)
    assert written.startswith("\\begin{aligned}\n")
    assert r"\text{where}" in written
    tree = well_formed(mathml(written, "block"))
    rows = tree.findall(".//{*}mtable")[0].findall("{*}mtr")
    assert len(rows) == written.count("\\\\\n") + 1
    assert all(len(row) == 2 for row in rows)
    for _, formula in (*system.field, *system.definitions):
        well_formed(mathml(latex(formula)))


def test_html_fragment_is_well_formed() -> None:
    fragment = system_html(laden("rattleback", "sphere", "rubber"))
    assert fragment.startswith('<section class="chaplygin-system">')
    tree = ET.fromstring(fragment)
    headings = ["".join(h.itertext()) for h in tree.iter("h4")]
    assert headings == ["Equations of motion", "Parameters", "Constant along the motion"]
    rows = tree.findall("table")[0].findall("tr")
    assert len(rows) == 1 + len(laden("rattleback", "sphere", "rubber").parameters)


def test_mathml_is_what_browsers_show() -> None:
    written = mathml(latex(cross(Vector("gammadot"), omega)))
    assert 'display="inline"' in written
    assert '<mover accent="true">' in written
    letters = [element.text for element in ET.fromstring(written).iter() if element.text]
    assert letters == ["𝜸", "˙", "×", "𝝎"]
    assert 'display="block"' in mathml("x", "block")

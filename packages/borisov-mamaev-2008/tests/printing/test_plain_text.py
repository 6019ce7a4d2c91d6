"""LaTeX as one line of Unicode."""

from __future__ import annotations

import re

import pytest

from borisov_mamaev_2008 import claims, remarks
from flowlanes.printing.plain_text import plain, plain_words


@pytest.mark.parametrize(
    ("formula", "line"),
    [
        (r"\frac{K}{2}(\gamma, I^{-1}\gamma)", "(K/2)(γ, I⁻¹γ)"),
        (r"F - 2\det I (\gamma, I^{-1}\gamma)", "F − 2 det I(γ, I⁻¹γ)"),
        (r"\frac12\mathbf M^2", "½M²"),
        (r"\dot{\mathbf M} = -\mathbf M\times\boldsymbol\omega", "Ṁ = −M×ω"),
        (r"\frac{a}{b + c}", "a/(b + c)"),
        (r"\frac{a + b}{2}", "(a + b)/2"),
        (r"x\frac{a}{b}y", "x(a/b)y"),
        (r"\frac{\partial U}{\partial\boldsymbol\gamma}\times\gamma", "∂U/∂γ×γ"),
        (r"\frac{1}{\rho}\frac{\partial\rho}{\partial q_1} - A_2", "(1/ρ) ∂ρ/∂q₁ − A₂"),
        (r"\frac{(\mathbf n, a)}{(b, c)(d, e)}", "(n, a)/((b, c)(d, e))"),
        (r"\rho_\mu\mathbf M", "ρ_μ M"),
        (r"\sum_{i=1}^3 c_i m_i^2", "Σᵢ₌₁³cᵢmᵢ²"),
        (r"\sin^2\theta\cos\varphi", "sin² θ cos φ"),
        (r"\tilde{\mathcal H} = \overline{S}", "ℋ̃ = S̄"),
        (r"e^{im\theta_1}", "e^(imθ₁)"),
        (r"\left(\mathbf E + \frac1a\mathbf W\right)^{-1}", "(E + (1/a)W)⁻¹"),
        (r"\{x, p\} = \pm 1 \ne 0", "{x, p} = ±1 ≠ 0"),
        (r"\text{const}", "const"),
        (r"\|a\|", "‖a‖"),
        (r"a/b", "a/b"),
        (r"\mathbb{R}^3", "ℝ³"),
        (r"\unheardof x", "unheardofx"),
        ("", ""),
        ("x^", "x"),
    ],
)
def test_a_formula_reads_as_on_paper(formula, line):
    assert plain(formula) == line


def test_words_keep_their_formulas_apart():
    words = (
        r"the integral is $F - 2\det I (\gamma, I^{-1}\gamma)$; with $U = \frac{K}{2}$ *so*, L_k"
    )
    assert plain_words(words) == "the integral is F − 2 det I(γ, I⁻¹γ); with U = K/2 so, Lₖ"
    assert plain_words(r"$\mathcal H$ and 𝓗") == "ℋ and ℋ"


def test_nothing_of_latex_is_left_in_the_texts_of_the_paper():
    texts = [
        text
        for _, claim in claims()
        for text in (claim.source, claim.statement, claim.correction, claim.note)
    ]
    texts += [text for remark in remarks() for text in (remark.statement, remark.reason)]
    for text in texts:
        line = plain_words(text)
        assert not re.search(r"[\\$]|frac\b|mathbf|boldsymbol", line), line
        for formula in re.findall(r"\$(.+?)\$", text):
            shown = plain(formula)
            assert shown.count("(") == shown.count(")"), shown
        assert "  " not in line and "( " not in line and " )" not in line, line

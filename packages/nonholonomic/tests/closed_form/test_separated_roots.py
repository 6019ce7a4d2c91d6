"""z₁ and z₂ are the coordinates that they are said to be: roots of Σ cᵢγᵢ²/(Iᵢ − z) = 0."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from flowlanes.system.vectors import Diagonal, real_symbol, vectors
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two.separation_laws import separation_laws
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball
from nonholonomic.closed_form.separations.fedorov import fedorov
from nonholonomic.closed_form.separations.veselova import veselova

(gamma,) = vectors("gamma")
I = Diagonal("I").symbols
S, P = real_symbol("separation_S"), real_symbol("separation_P")


def roots_law(separable, masses):
    """∑ cᵢγᵢ²(Iⱼ − z)(Iₖ − z) is a multiple of z² − Sz + P; the separation's own S and P."""
    (law,) = (law for law in separation_laws(separable) if law.name == "separation")
    terms = [c * s**2 for c, s in zip(masses, gamma.symbols, strict=True)]
    total, rest = sp.Add(*I), sp.Mul(*I)
    middle = sp.Add(*(t * (total - e) for t, e in zip(terms, I, strict=True)))
    last = sp.Add(*(t * rest / e for t, e in zip(terms, I, strict=True)))
    whole = sp.Add(*terms)
    return replace(law, name="roots", value=(S * whole - middle, P * whole - last))


CASES = {
    "veselova": (veselova(), (1, 1, 1)),
    "chaplygin-ball": (chaplygin_ball(), I),
    "chaplygin-ball-fedorov": (fedorov(), I),
}


@pytest.mark.parametrize("name", CASES)
def test_roots(name):
    separable, masses = CASES[name]
    assert prove(separable.system, roots_law(separable, masses)).decision == "proven"


@pytest.mark.parametrize("name", CASES)
def test_roots_with_other_masses_are_others(name):
    separable, masses = CASES[name]
    wrong = roots_law(separable, (2 * masses[0], *masses[1:]))
    assert prove(separable.system, wrong).decision == "refuted"

"""Measures of mechanisms in plain coordinates: sleighs, signs of densities, exceptional values."""

from __future__ import annotations

import math
import random

import pytest
import sympy as sp

from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove
from nonholonomic.invariant_measures.existence import invariant_measure
from nonholonomic.invariant_measures.positivity import Signs, definite, positive
from nonholonomic.mechanics.lagrangian.mechanism import Mechanism, coordinates

x, y, phi, theta = (real_symbol(name) for name in ("x", "y", "phi", "theta"))
m, I, a, b = (real_symbol(name) for name in ("m", "I", "a", "b"))
HALF = sp.Rational(1, 2)
FRAME = coordinates(x, y, phi)
xdot, ydot, phidot = FRAME.w
sine, cosine = sp.sin(phi), sp.cos(phi)
BLADE = ydot * cosine - xdot * sine
REST = HALF * (m * (xdot**2 + ydot**2) + I * phidot**2)


def sleigh(constraint, energy=REST, ahead=0.3, signed=True):
    numbers = ((m, 1.0), (I, 0.5), (a, ahead))
    used = [
        Parameter(s, str(s), value, admissible=(s > 0,) if signed and s is not a else ())
        for s, value in numbers
        if s in energy.free_symbols | constraint.free_symbols
    ]
    return Mechanism("sleigh", FRAME, energy, (constraint,), parameters=tuple(used))


def off_centre(ahead=a):
    """The centre of mass lies ahead of the blade."""
    along, across = xdot - ahead * sine * phidot, ydot + ahead * cosine * phidot
    return HALF * (m * (along**2 + across**2) + I * phidot**2)


@pytest.mark.parametrize(
    "blade", [BLADE, -BLADE, BLADE.xreplace({phi: -phi}), xdot * cosine + ydot * sine]
)
@pytest.mark.parametrize("signed", [True, False])
def test_centre_of_mass_at_the_blade(blade, signed):
    found = invariant_measure(sleigh(blade, signed=signed))
    assert found.decision == "exists"
    assert found.density.density == ()
    assert found.domain == ()
    assert prove(found.system, found.density)


@pytest.mark.slow
@pytest.mark.parametrize("signed", [True, False])
@pytest.mark.parametrize("ahead", [0.3, 0.0])
@pytest.mark.parametrize(
    ("energy", "blade"), [(off_centre(), BLADE), (off_centre(), -BLADE), (REST, BLADE - a * phidot)]
)
def test_centre_of_mass_ahead(energy, blade, ahead, signed):
    found = invariant_measure(sleigh(blade, energy, ahead, signed))
    assert found.decision == "conditional"
    assert found.conditions == ((a,),)
    assert found.complete
    assert bool(found) == (ahead == 0)
    assert found.density.density == ()


@pytest.mark.slow
@pytest.mark.parametrize("ahead", [sp.Rational(3, 10), sp.Integer(1), sp.Rational(-2, 7)])
@pytest.mark.parametrize("written", ["energy", "constraint"])
def test_a_number_in_place_of_the_parameter(ahead, written):
    given = (BLADE, off_centre(ahead)) if written == "energy" else (BLADE - ahead * phidot, REST)
    found = invariant_measure(sleigh(*given))
    assert found.decision == "none"
    assert found.complete
    assert "none for any values of the parameters" in found.reason


@pytest.mark.slow
def test_values_that_were_not_decided_are_told():
    """At a = b = 0 the constraint is none at all."""
    parameters = tuple(Parameter(s, str(s), 1.0) for s in (a, b))
    energy = HALF * (xdot**2 + ydot**2 + phidot**2)
    rolling = Mechanism(
        "odd",
        FRAME,
        energy,
        (a * xdot * x + b * phidot * cosine + y * ydot * a,),
        parameters=parameters,
    )
    found = invariant_measure(rolling)
    assert not found.complete


def test_a_density_with_zeros_says_where_it_is_positive():
    """The pole of polar coordinates, where these are none."""
    r = real_symbol("r")
    frame = coordinates(r, theta)
    rdot, thetadot = frame.w
    energy = HALF * (rdot**2 + sp.sin(r) ** 2 * thetadot**2)
    found = invariant_measure(Mechanism("point", frame, energy))
    assert found.decision == "exists"
    assert found.density.density == ((sp.sin(r), 2),)
    assert found.domain == (sp.Ne(sp.sin(r), 0),)
    assert "positive and smooth where sin(r) ≠ 0" in str(found)


class TestPositive:
    S = Signs(frozenset({m}), (x**2 + y**2 - 1,), (), ((m, 2), (a, 3)))
    FACTORS = (
        sine,
        1 + cosine,
        cosine - 1,
        cosine,
        -m - x**2,
        a**2 * x**2 + m,
        x**2 + 3 * m * y**2,
        y - 2,
    )

    def test_imaginary_factors_cancel(self):
        powers = ((cosine + 1, -HALF), (cosine - 1, -HALF), (sine, sp.S.One))
        assert positive(powers, self.S) == ((), ())

    @pytest.mark.slow
    @pytest.mark.parametrize("seed", range(12))
    def test_the_density_is_real_and_the_same_up_to_a_constant(self, seed):
        rng = random.Random(seed)
        chosen = rng.sample(self.FACTORS, 4)
        powers = tuple((f, sp.Rational(rng.randint(-5, 5), rng.choice([1, 2, 3]))) for f in chosen)
        made, domain = positive(powers, self.S)
        ratios = []
        for _ in range(60):
            turn = rng.uniform(-3, 3)
            place = {x: math.cos(turn), y: math.sin(turn), phi: rng.uniform(-3, 3), m: 2, a: 3}
            if not all(condition.subs(place) for condition in domain):
                continue
            new = sp.prod([sp.N(f.subs(place)) ** e for f, e in made])
            assert sp.N(new).is_real
            assert new > 0
            old = sp.prod([abs(sp.N(f.subs(place))) ** e for f, e in powers])
            ratios.append(float(new / old))
        assert ratios
        assert max(ratios) / min(ratios) == pytest.approx(1, rel=1e-6)

    def test_what_is_shown_to_be_positive(self):
        powers = ((x**2 + 3 * m * y**2, HALF), (-m - x**2, HALF), (y - 2, HALF))
        made, domain = positive(powers, self.S)
        assert made[:2] == ((x**2 + 3 * m * y**2, HALF), (m + x**2, HALF))
        # 2 − y > 0 on the circle, which nobody has shown
        assert domain == (2 - y > 0,)

    def test_the_kinetic_form_is_positive(self):
        product = Signs(frozenset({m}), positive_products=((a * x + 5) * m,))
        assert positive(((a * x + 5, HALF),), product)[1] == ()
        two = Signs(frozenset({m}), positive_products=((a * x + 5) * (b - x),))
        assert positive(((a * x + 5, HALF),), two)[1] == (a * x + 5 > 0,)

    def test_definite(self):
        assert definite(a**2 + m, {m})
        assert not definite(a**2 + m, set())
        assert not definite(a**2 * x**2, set())
        assert not definite(m - a**2, {m})

"""What is planted is what it says: points are on their level, and show what they are said to."""

from __future__ import annotations

import random

import pytest
import sympy as sp
from sympy.core.function import AppliedUndef

from fuzz.mechanical import MECHANISMS
from fuzz.planter import FAMILIES, SETTINGS, planted, planted_case

DRAWS = 8


def value(formula, point):
    """A formula at a point, to 100 digits; None where it is not a finite real number there."""
    found = sp.sympify(formula).subs(point, simultaneous=True)
    if found.has(sp.nan, sp.zoo, sp.oo, sp.I):
        return None
    if found.free_symbols or found.atoms(AppliedUndef):
        raise LookupError
    number = sp.N(found, 100, chop=True)
    return number if number.is_real and number.is_finite else None


def known(formula, point):
    return not (formula.atoms(AppliedUndef) or formula.free_symbols - set(point))


@pytest.mark.slow
@pytest.mark.parametrize("name", SETTINGS)
def test_points_are_on_the_level_and_show_what_fails(name):
    for draw in range(DRAWS):
        setting = SETTINGS[name](random.Random(f"{name} {draw}"))
        points = [c.fails_at for c in setting.claims if c.fails_at is not None]
        for point in points:
            assert all(sp.sympify(v).is_real for v in point.values())
            for condition in setting.conditions:
                if known(condition, point):
                    assert abs(value(condition, point)) < 1e-40, (condition, point)
            for guard in setting.guards:
                assert value(guard, point) > 0, (guard, point)
            for item in setting.parameters:
                for asked in item.admissible:
                    assert asked.subs(point) == sp.true, (asked, point)
        for claim in setting.claims:
            if claim.fails_at is not None:
                shown = value(claim.formula, claim.fails_at)
                assert shown is not None and abs(shown) > 1e-90, claim
            for point in points if claim.holds else ():
                if known(claim.formula, point):
                    found = value(claim.formula, point)
                    assert found is None or abs(found) < 1e-40, (claim, point)


@pytest.mark.parametrize("name", SETTINGS)
def test_settings_have_both_truths_and_admissible_defaults(name):
    truths = set()
    for draw in range(DRAWS):
        setting = SETTINGS[name](random.Random(f"{name} {draw}"))
        truths |= {c.holds for c in setting.claims}
        defaults = {p.symbol: p.default for p in setting.parameters}
        for item in setting.parameters:
            assert all(asked.subs(defaults) == sp.true for asked in item.admissible)
    assert truths == {True, False}


@pytest.mark.parametrize("name", MECHANISMS)
def test_integrals_of_mechanisms_are_integrals(name):
    """By SymPy: the rate vanishes modulo the relations and the level."""
    mechanism = MECHANISMS[name]
    level = (*mechanism.relations, *mechanism.on)
    for i, formula in enumerate(mechanism.integrals):
        needed = level if formula is mechanism.integrals[-1] else mechanism.relations
        rate = sp.numer(sp.together(sp.expand(mechanism.rate(formula).doit())))
        rest = sp.expand(sp.simplify(rate)) if rate else rate
        if rest and needed:
            names = sorted(set().union(*(n.free_symbols for n in needed)), key=str)
            rest = sp.reduced(rest, list(sp.groebner(needed, *names, order="grevlex")), *names)[1]
        assert sp.simplify(rest) == 0, (i, rest)


@pytest.mark.parametrize("name", MECHANISMS)
def test_mechanisms_keep_their_relations(name):
    mechanism = MECHANISMS[name]
    level = (*mechanism.relations, *mechanism.on)
    generator = random.Random(name)
    for _ in range(5):
        point = mechanism.point(generator)
        for condition in level:
            assert value(condition, point) == 0
            assert value(mechanism.rate(condition), point) == 0


@pytest.mark.slow
def test_the_same_seed_plants_the_same():
    first = [(c.family, c.truth, c.why) for c in planted(3, 120)]
    assert first == [(c.family, c.truth, c.why) for c in planted(3, 120)]
    assert first != [(c.family, c.truth, c.why) for c in planted(4, 120)]


@pytest.mark.slow
def test_as_much_is_true_as_false_and_every_family_takes_part():
    count = 2 * len(FAMILIES) + 200
    cases = [planted_case(5, number) for number in range(count)]
    assert {c.family for c in cases} == set(FAMILIES)
    true = sum(c.truth == "true" for c in cases)
    assert 0.4 < true / count < 0.6

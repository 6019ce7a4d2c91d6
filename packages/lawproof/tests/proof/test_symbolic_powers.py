"""Powers with symbolic exponents: (b²)^a is b^(2a) where b is positive, and not elsewhere."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
import sympy as sp

from flowlanes import Identity, Integral, Measure, Parameter, System
from flowlanes.system import real_symbol
from flowlanes.system.laws import Law
from flowlanes.system.system import Guard
from lawproof import prove
from lawproof.proof import prove_with_certificate

x, y, a = (real_symbol(name) for name in ["x", "y", "a"])
HALF = sp.Rational(1, 2)
SQUARE = sp.expand((x - 1) ** 2)

FALSE = {
    "a square": SQUARE**a - (x - 1) ** (2 * a),
    "the root of a square": sp.sqrt(x**2) ** (2 * a) - x ** (2 * a),
    "a fourth power": sp.expand((x - 1) ** 4) ** a - (x - 1) ** (4 * a),
    "half the exponent": SQUARE ** (a / 2) - (x - 1) ** a,
    "half more": SQUARE ** (a + HALF) - SQUARE**a * (x - 1),
    "a square in a product": sp.expand(y**2 * (x - 1) ** 2) ** a - (y * (x - 1)) ** (2 * a),
    "a root with an even denominator": SQUARE ** sp.Rational(3, 2) - (x - 1) ** 3,
}

#: Identities with the conditions under which they hold.
CONDITIONAL = {
    "a product": (sp.expand(x * y) ** a - x**a * y**a, {"x > 0", "y > 0"}),
    "a quotient": ((x / y) ** a - x**a / y**a, {"x > 0", "y > 0"}),
    "a negative base": ((-x * y) ** a - (-x) ** a * y**a, {"-x > 0", "y > 0"}),
}

ALWAYS = {
    "a sum of squares": (x**2 + 1) ** a * (x**2 + 1) - (x**2 + 1) ** (a + 1),
    "the square of a square": sp.expand((x - 1) ** 4) ** a - SQUARE ** (2 * a),
    "absolute values": SQUARE**a - sp.Abs(x - 1) ** (2 * a),
    "a root": sp.expand((x - 1) ** 6) ** sp.Rational(1, 4) - sp.sqrt(sp.Abs(x - 1) ** 3),
    "hundredths of an exponent": SQUARE ** (a / 100) - sp.Abs(x - 1) ** (a / 50),
    "real where the base is positive": SQUARE ** sp.Rational(3, 4) - (x - 1) ** sp.Rational(3, 2),
}


def moving(*guards: sp.Expr, default: float = 1.5) -> System:
    """ẋ = ẏ = 1, with an exponent a > 0."""
    return System(
        "moving",
        "Moving",
        {x: sp.S.One, y: sp.S.One},
        parameters=(Parameter(a, "exponent", default, admissible=(a > 0,)),),
        guards=tuple(Guard(f"guard{i}", g, "outside") for i, g in enumerate(guards)),
    )


@pytest.mark.parametrize("default", [0.7, 1.5, 2.0])
@pytest.mark.parametrize("name", FALSE)
def test_false_ones_are_refuted(name: str, default: float) -> None:
    verdict = prove_with_certificate(moving(default=default), Identity("law", FALSE[name]))
    assert verdict.decision == "refuted"
    assert verdict.certificate is not None


def test_a_large_symbol_in_an_exponent() -> None:
    scaled = a / 10**6
    true = Identity("law", SQUARE**scaled - sp.Abs(x - 1) ** (2 * scaled))
    verdict = prove_with_certificate(moving(default=1.3e6), true)
    assert verdict.decision == "proven"
    assert verdict.certificate is not None, verdict.no_certificate


@pytest.mark.parametrize("power", [5, 6, -5, -6, -11])
def test_false_ones_are_refuted_in_any_unit(power: int) -> None:
    scaled = a / sp.Integer(10) ** power
    law = Identity("law", SQUARE**scaled - (x - 1) ** (2 * scaled))
    verdict = prove_with_certificate(moving(default=1.3 * 10.0**power), law)
    assert verdict.decision == "refuted"
    assert verdict.certificate is not None


def test_a_base_that_is_negative_everywhere() -> None:
    """Only whole exponents have points at which the law is defined."""
    law = Identity("law", sp.expand((x - 2) ** 2) ** a - (x - 2) ** (2 * a))
    assert prove(moving(1 - x**2 - y**2, default=1.3), law).decision == "refuted"


@pytest.mark.parametrize("name", FALSE)
def test_they_hold_where_guards_say_the_sign(name: str) -> None:
    verdict = prove_with_certificate(moving(x - 1, x, y), Identity("law", FALSE[name]))
    assert verdict.decision == "proven"
    assert verdict.certificate is not None, verdict.no_certificate


@pytest.mark.parametrize("name", CONDITIONAL)
def test_signs_of_bases_are_conditions(name: str) -> None:
    formula, conditions = CONDITIONAL[name]
    verdict = prove_with_certificate(moving(), Identity("law", formula))
    assert (verdict.decision, set(verdict.conditions)) == ("proven where", conditions)
    assert verdict.certificate is not None, verdict.no_certificate


@pytest.mark.parametrize("name", ALWAYS)
def test_what_needs_no_sign_is_proven(name: str) -> None:
    verdict = prove_with_certificate(moving(), Identity("law", ALWAYS[name]))
    assert verdict.decision == "proven"
    assert verdict.certificate is not None, verdict.no_certificate


@pytest.mark.parametrize(
    "law", [Integral("law", (x / y) ** a), Integral("law", x**a * y ** (-a))], ids=str
)
def test_an_integral_with_symbolic_exponents(law: Law) -> None:
    rates = {x: x, y: y}
    parameters = (Parameter(a, "exponent", 1.5),)
    verdict = prove_with_certificate(System("s", "S", rates, parameters=parameters), law)
    assert verdict.decision == "proven where"
    assert set(verdict.conditions) == {"x > 0", "y > 0"}
    assert verdict.certificate is not None


def test_a_density_needs_no_sign() -> None:
    """div(ρv)/ρ has no power: the density is told to be real where x > 0."""
    system = System("s", "S", {x: x, y: -a * y}, parameters=(Parameter(a, "exponent", 1.5),))
    verdict = prove(system, Measure("law", {x: a - 1}))
    assert verdict.decision == "proven"


def value(formula: sp.Expr, point: dict[sp.Symbol, Fraction]) -> Fraction | float | None:
    """A value as the documentation defines it; None where there is none."""
    if formula.is_Symbol:
        return point[formula]
    if formula.is_Rational:
        return Fraction(int(formula.p), int(formula.q))
    parts = [value(part, point) for part in formula.args]
    if any(part is None for part in parts):
        return None
    if formula.is_Add:
        return sum(parts, Fraction(0))
    if formula.is_Mul:
        result: Fraction | float = Fraction(1)
        for part in parts:
            result = result * part
        return result
    if formula.is_Pow:
        base, exponent = parts
        if exponent.denominator == 1:
            return base ** int(exponent) if base else None
        return float(base) ** float(exponent) if base > 0 else None
    (inner,) = parts
    if inner == 0:
        return None
    sign = 1 if inner > 0 else -1
    return abs(inner) if isinstance(formula, sp.Abs) else Fraction(sign)


def random_identity(rng: random.Random) -> sp.Expr:
    """An identity of powers, absolute values and signs that holds for some signs, or for all."""
    bases = (x, y, x - 1, y + 2, -x, 1 - x, x * y, x**2, x**2 + 1, x - y)
    exponents = (a, 2 * a, a / 2, a + 1, a + HALF, HALF, sp.Rational(1, 4), -a, 1 - a)
    f, g = rng.choice(bases), rng.choice(bases)
    p, q = rng.choice(exponents), rng.choice(exponents)
    forms = (
        sp.expand(f * g) ** p - f**p * g**p,
        sp.expand(f**2) ** p - f ** (2 * p),
        sp.expand(f) ** p * f**q - sp.expand(f) ** (p + q),
        sp.expand(f**4) ** p - sp.expand(f**2) ** (2 * p),
        sp.Abs(sp.expand(f * g)) - sp.Abs(f) * sp.Abs(g),
        sp.Abs(f) * sp.sign(f) - rng.choice([f, sp.Abs(f)]),
        sp.sqrt(sp.expand(f**2 * (x + 3))) - rng.choice([f, -f, sp.Abs(f)]) * sp.sqrt(x + 3),
        sp.Abs(sp.Abs(f) - 1) - rng.choice([sp.Abs(f) - 1, sp.sqrt((f * sp.sign(f) - 1) ** 2)]),
    )
    return rng.choice(forms)


def holds_at_random_points(formula: sp.Expr, conditions: tuple[str, ...], seed: int) -> bool:
    """Whether a formula vanishes where it is defined and conditions hold."""
    rng = random.Random(seed)
    stated = [sp.sympify(c, locals={"x": x, "y": y, "a": a}) for c in conditions]
    terms = sp.Add.make_args(formula)
    for _ in range(80):
        numbers = [Fraction(rng.randint(-40, 40), rng.choice([1, 2, 7])) for _ in "xy"]
        exponent = Fraction(rng.randint(1, 6), rng.choice([1, 2, 3]))
        point = {x: numbers[0], y: numbers[1], a: exponent}
        at = {s: sp.Rational(v.numerator, v.denominator) for s, v in point.items()}
        if not all(condition.subs(at) == sp.true for condition in stated):
            continue
        total = value(formula, point)
        size = [value(term, point) for term in terms]
        if total is not None and abs(total) > 1e-9 * sum(abs(s) for s in size if s is not None):
            return False
    return True


@pytest.mark.parametrize("seed", range(60))
def test_verdicts_agree_with_numbers(seed: int) -> None:
    formula = random_identity(random.Random(seed))
    if not formula.free_symbols:
        return
    verdict = prove_with_certificate(moving(), Identity("law", formula))
    if verdict:
        assert holds_at_random_points(formula, (), seed)
    elif verdict.decision == "proven where":
        assert holds_at_random_points(formula, verdict.conditions, seed)
    else:
        assert verdict.decision != "refuted" or verdict.certificate is not None

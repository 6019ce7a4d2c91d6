"""Laws that rest on known signs or on identities of elementary functions, and false siblings."""

from __future__ import annotations

import copy

import pytest
import sympy as sp

from certificate_checker import CheckError, check
from flowlanes.system.laws import Identity, Integral
from flowlanes.system.system import Guard, Parameter, System
from flowlanes.system.vectors import real_symbol
from lawproof.proof import prove_with_certificate
from lawproof.proof.prover import prove

x, y, z, a, b = (real_symbol(name) for name in ("x", "y", "z", "a", "b"))
NUMBER_E = sp.exp(1)
SPHERE = x**2 + y**2 + z**2 - 1
BALL = 1 - x**2 - y**2
QUARTIC = x**4 - 2 * x**2 + 2


def still(*admissible, guards=(), relations=(), state=(x, y, z), default=0.5) -> System:
    """Nothing moves: identities on a phase space with some parameters, guards and relations."""
    return System(
        "still",
        "Still",
        {s: sp.S.Zero for s in state},
        parameters=tuple(
            Parameter(s, f"the number {s}", default, admissible=tuple(admissible) if s == a else ())
            for s in (a, b)
        ),
        guards=tuple(Guard(f"guard {i}", value, "outside") for i, value in enumerate(guards)),
        relations=relations,
    )


def of_square(base):
    """√(base²) less the base, which SymPy does not see as an absolute value."""
    return sp.sqrt(sp.expand(base**2)) - base


TRUE = {
    # signs
    "a guard": (still(a**2 < 1), of_square(1 - a), ()),
    "a factor of a guard": (still(a**2 > 1, default=2.0), x, ((a**2 - 1) * x,)),
    "a ball": (still(guards=(BALL,)), of_square(2 - x), ()),
    "a plane beside a ball": (still(guards=(BALL,)), of_square(2 - x - y), ()),
    "a plane beside a sphere": (still(relations=(SPHERE,)), z, ((2 - x - y) * z,)),
    "a cubic above a ball": (still(guards=(BALL,)), of_square(x**3 - 3 * x + 5), ()),
    "a bounded function": (still(), of_square(2 + sp.sin(x)), ()),
    "functions together": (still(), y, ((sp.exp(x) + 1 + sp.sin(z)) * y,)),
    "a hyperbolic tangent": (still(), y, ((2 + sp.tanh(x)) * y,)),
    "a quartic": (still(), y, ((x**4 - 2 * x**2 + 2) * y,)),
    "a quartic without symmetry": (still(), y, ((x**4 - x + 1) * y,)),
    "a quartic under a root": (still(), of_square(x**4 - 2 * x**2 + 2), ()),
    "an interval": (still(a > 0, a < 1), of_square(a**3 - 2 * a + 2), ()),
    "a weak sign": (still(a >= 0), of_square(1 + a), ()),
    "an absolute value and a parameter": (still(a**2 < 1), sp.sqrt((1 - a) ** 2) - 1 + a, ()),
    "an absolute value in a ball": (still(guards=(BALL,)), sp.Abs(2 - x) - 2 + x, ()),
    "an absolute value of a sine": (still(), sp.Abs(2 + sp.sin(x)) - 2 - sp.sin(x), ()),
    "an absolute value of a quartic": (still(), sp.Abs(QUARTIC) - QUARTIC, ()),
    "a sign in a ball": (still(guards=(BALL,)), sp.sign(x - 2) + 1, ()),
    "a power in a ball": (
        still(a > 0, guards=(BALL,)),
        sp.expand((x - 2) ** 2) ** a - (2 - x) ** (2 * a),
        (),
    ),
    "a logarithm that is real where a base is positive": (
        still(a > 0),
        sp.log(x - 1) * (sp.expand((x - 1) ** 2) ** a - (x - 1) ** (2 * a)),
        (),
    ),
    # functions
    "a half sphere": (still(guards=(z,), relations=(SPHERE,)), z - sp.sqrt(BALL), ()),
    "a root of two": (still(a > 0), a - sp.sqrt(2), (a**2 - 2,)),
    "half an angle": (still(), sp.tan(x / 2) - (1 - sp.cos(x)) / sp.sin(x), ()),
    "two frequencies": (
        still(),
        2 * sp.sin(a * x) * sp.sin(b * x) - sp.cos((a - b) * x) + sp.cos((a + b) * x),
        (),
    ),
    "arcs": (still(), sp.asin(x) + sp.acos(x) - sp.pi / 2, ()),
    "a logarithm of a square": (still(guards=(x,)), sp.log(x**2) - 2 * sp.log(x), ()),
    "logarithms": (
        still(),
        sp.log(6 * sp.exp(x) * sp.sqrt(1 + y**2) / z)
        - (x + sp.log(2) + sp.log(3) + sp.log(1 + y**2) / 2 - sp.log(z)),
        (),
    ),
    "equal exponentials": (still(), x - y, (sp.exp(x) - sp.exp(y),)),
    "an exponential of one": (still(), x, (sp.exp(x) - 1,)),
    "equal hyperbolic sines": (still(), x - y, (sp.sinh(x) - sp.sinh(y),)),
    "equal arcs": (still(), x - y - z, (sp.atan(x) - sp.atan(y + z),)),
    "equal exponentials or zero": (still(), (x - y) * z, ((sp.exp(x) - sp.exp(y)) * z,)),
}

FALSE = {
    "a guard that is too weak": (still(a**2 < 2), of_square(1 - a), ()),
    "a factor that a guard allows": (still(a**2 > 1, default=3.0), x, ((a**2 - 4) * x,)),
    "a plane across a ball": (still(guards=(BALL,)), of_square(1 - x - y), ()),
    "a plane across a sphere": (still(relations=(SPHERE,)), z, ((1 - x - y) * z,)),
    "a cubic across a ball": (still(guards=(BALL,)), of_square(x**3 - 3 * x + 1), ()),
    "a function across zero": (still(), of_square(1 + 2 * sp.sin(x)), ()),
    "a quartic with roots": (still(), y, ((x**4 - 2 * x**2 + sp.Rational(1, 2)) * y,)),
    "an interval with a root": (still(a > 0, a < 1), x, ((3 * a - 1) * x,)),
    "the other half": (still(guards=(z,), relations=(SPHERE,)), z + sp.sqrt(BALL), ()),
    "both halves": (still(relations=(SPHERE,)), z - sp.sqrt(BALL), ()),
    "the other root of two": (still(a > 0), a + sp.sqrt(2), (a**2 - 2,)),
    "either root of two": (still(), a - sp.sqrt(2), (a**2 - 2,)),
    "half another angle": (still(), sp.tan(x / 2) - (1 + sp.cos(x)) / sp.sin(x), ()),
    "arcs with a sign": (still(), sp.asin(x) - sp.acos(x) - sp.pi / 2, ()),
    "a logarithm of another square": (still(), sp.log(x**2) - 2 * sp.log(1 + x), ()),
    "a logarithm on the other side": (
        still(guards=(-x,)),
        sp.log(x**2) - 2 * sp.log(-2 * x),
        (),
    ),
    "opposite exponents": (still(), x + y, (sp.exp(x) - sp.exp(y),)),
    "equal exponentials, or zero": (still(), x - y, ((sp.exp(x) - sp.exp(y)) * z,)),
    "a level at half a turn": (still(), sp.cos(x) - 1, (sp.sin(x),)),
    "a sine of one half": (
        still(),
        sp.cos(x) - sp.sqrt(3) / 2,
        (sp.sin(x) - sp.Rational(1, 2),),
    ),
}


@pytest.mark.parametrize("case", TRUE.values(), ids=TRUE)
def test_true_laws_are_proven_with_a_certificate(case):
    system, value, on = case
    verdict = prove_with_certificate(system, Identity("law", value, level=on))
    assert verdict.decision == "proven", verdict.reason
    assert verdict.conditions == ()
    assert verdict.certificate is not None, verdict.no_certificate


@pytest.mark.parametrize("case", FALSE.values(), ids=FALSE)
def test_false_siblings_are_refuted(case):
    system, value, on = case
    assert prove(system, Identity("law", value, level=on)).decision == "refuted"


@pytest.mark.parametrize(
    "on", [(sp.sin(x) - sp.sin(y),), (sp.cosh(x) - sp.cosh(y),), (x**2 - y**2,)]
)
def test_functions_with_a_value_twice_are_not_one_to_one(on):
    assert prove(still(), Identity("law", x - y, level=on)).decision != "proven"


def test_equal_exponentials_that_move():
    law = Integral("difference", x - y, level=(sp.exp(x) - sp.exp(y),))
    together = System("t", "T", {x: y, y: x})
    apart = System("t", "T", {x: y, y: 2 * x})
    assert prove_with_certificate(together, law).certificate is not None
    assert prove(apart, law).decision == "refuted"


def test_a_variable_beside_the_number_of_its_name():
    energy = real_symbol("E")
    system = System("s", "S", {x: energy, energy: -x})
    true = prove_with_certificate(system, Integral("law", energy**2 + x**2 + NUMBER_E))
    assert true.decision == "proven"
    assert true.certificate is not None
    assert prove(still(state=(energy,)), Identity("law", energy - NUMBER_E)).decision == "refuted"


def test_a_point_is_given_in_the_variables_of_the_system():
    verdict = prove(still(), Identity("law", sp.cos(x) - 1, level=(sp.sin(x),)))
    assert "1 + cos(x) = 0" in verdict.finding
    assert verdict.witness["point"]["x"].startswith("[3.14159265358979")
    assert verdict.witness["place"]["x"] == {"formula": "pi"}


def test_conditions_are_given_in_the_formulas_of_the_system():
    # which is so for every value of the unspecified f, of which nothing is known
    f = sp.Function("f")(y)
    law = Identity("law", z, level=(sp.sin(x) - 1, (f + sp.sin(x)) * z))
    verdict = prove(still(), law)
    assert verdict.decision != "proven"
    assert "sin_x" not in f"{verdict.conditions}{verdict.reason}{verdict.finding}"


@pytest.mark.parametrize("name", ["a ball", "an interval", "a plane beside a sphere"])
def test_no_sign_is_accepted_without_its_reason(name):
    system, value, on = TRUE[name]
    certificate = prove_with_certificate(system, Identity("law", value, level=on)).certificate
    check(certificate)
    (proof,) = certificate["proofs"]
    assert any(item["from"] in ("sum", "one variable") for item in proof["positive"])
    for number, item in enumerate(proof["positive"]):
        if item["from"] not in ("sum", "one variable"):
            continue
        changed = copy.deepcopy(certificate)
        del changed["proofs"][0]["positive"][number]
        with pytest.raises(CheckError):
            check(changed)


def test_a_root_is_narrowed_in_finitely_many_steps():
    # at this point Newton's method in the check once went on for ever
    base = 2 * x**2 - 2 * x * y + x - 3 * y + 2
    system = still(guards=(x * y,), relations=(x**2 + 2 * y**2 - 1,))
    assert prove(system, Identity("law", of_square(base))).decision == "refuted"

"""Angles in the conditions of a phase space."""

from __future__ import annotations

import pytest
import sympy as sp

from certificate_checker import check
from flowlanes.errors import InputError
from flowlanes.formulas.errors import OutOfReachError
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Measure,
    PoissonStructure,
    Rate,
    Symmetry,
)
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol
from lawproof import prove
from lawproof.proof.certificates.certificate import prove_with_certificate
from lawproof.proof.level.trigonometric import circles

phi, u, v, w, a = (real_symbol(n) for n in ("phi", "u", "v", "w", "a"))
s, c = sp.sin(phi), sp.cos(phi)


def blade(rate: sp.Expr = w) -> System:
    """A point that keeps to its blade, −u sin φ + v cos φ = 0, and turns at a constant rate."""
    ahead = u * c + v * s
    return System(
        "blade",
        "Blade",
        field={phi: rate, u: -ahead * rate * s, v: ahead * rate * c, w: sp.S.Zero},
        relations=(-u * s + v * c,),
    )


def test_speed_along_the_blade_is_kept() -> None:
    system = blade()
    assert prove(system, Integral("square", u**2 + v**2)).decision == "proven"
    assert prove(system, Integral("speed", u * c + v * s)).decision == "proven"
    wrong = prove(system, Integral("wrong", u * c))
    assert wrong.decision == "refuted"
    assert "phi" in wrong.witness["point"]


def test_double_and_shifted_angles() -> None:
    system = blade()
    law = Identity("double", Rate(sp.sin(2 * phi)) - 2 * w * (1 - 2 * s**2))
    assert prove(system, law).decision == "proven"
    shifted = System(
        "shifted",
        "Shifted blade",
        field={phi: w, u: -v * w, v: u * w, w: sp.S.Zero},
        relations=(u * sp.sin(phi + a) - v * sp.cos(phi + a),),
        parameters=(Parameter(a, "angle", 0.4),),
    )
    assert prove(shifted, Integral("square", u**2 + v**2)).decision == "proven"


def test_half_angles_have_a_circle_of_their_own() -> None:
    system = System(
        "half",
        "Half",
        field={phi: w, u: w * u * sp.cos(phi / 2) / sp.sin(phi / 2) / 2, w: sp.S.Zero},
        relations=(u - sp.sin(phi / 2),),
    )
    assert prove(system, Identity("whole", s - 2 * u * sp.cos(phi / 2))).decision == "proven"


def test_a_frequency_times_the_time() -> None:
    t, nu = real_symbol("t"), real_symbol("nu")
    swing = nu * sp.cos(nu * t)
    system = System(
        "driven",
        "Driven",
        field={t: sp.S.One, u: v, v: -(nu**2) * u},
        relations=(u - sp.sin(nu * t), v - swing),
        parameters=(Parameter(nu, "frequency", 3.0),),
    )
    law = Identity("double", Rate(u * v) - nu**2 * sp.cos(2 * nu * t))
    assert prove(system, law).decision == "proven"
    assert prove(system, Integral("circle", u**2 + v**2)).decision == "refuted"


def test_measure_and_symmetry_and_bracket() -> None:
    system = blade()
    assert prove(system, Measure("volume", {sp.Integer(2): 1})).decision == "proven"
    turn = Symmetry("turn", {phi: sp.S.One, u: -v, v: u})
    assert prove(system, turn).decision == "proven"
    assert prove(system, Symmetry("wrong", {phi: sp.S.One, u: -v})).decision == "refuted"
    circle = System("circle", "Circle", field={phi: w, w: -s}, relations=(s**2 + c**2 - 1,))
    bracket = PoissonStructure("canonical", sp.Matrix([[0, 1], [-1, 0]]), rank=2)
    form = ConformallyHamiltonian("pendulum", sp.S.One, bracket, w**2 / 2 - c)
    assert prove(circle, bracket).decision == "proven"
    assert prove(circle, form).decision == "proven"
    false = ConformallyHamiltonian("pendulum", sp.S.One, bracket, w**2 / 2 + c)
    assert prove(circle, false).decision == "refuted"


def test_isomorphism_from_angles() -> None:
    plain = System("turn", "Turn", field={u: -v * w, v: u * w, w: sp.S.Zero})
    law = Isomorphism("velocity", plain, {u: u, v: v, w: w})
    assert prove(blade(), law).decision == "proven"


def test_certificate_of_a_proof_with_angles() -> None:
    verdict = prove_with_certificate(blade(), Integral("square", u**2 + v**2))
    assert verdict.decision == "proven"
    check(verdict.certificate)


def test_an_angle_by_itself_belongs_to_no_circle() -> None:
    with pytest.raises(OutOfReachError, match="occurs elsewhere by itself"):
        circles(blade(phi))
    # the condition is linear in v, which then leaves the state
    assert prove(blade(phi), Integral("square", u**2 + v**2)).decision == "proven"


def test_systems_without_angles_stay_as_they_are() -> None:
    plain = System("plain", "Plain", field={u: v, v: -u}, relations=(u**2 + v**2 - 1,))
    assert circles(plain) is None


def test_an_empty_level_of_a_parameter_s_angle_proves_nothing() -> None:
    """Only exact contradictions make a level empty; what is near to one is tried."""
    beta = real_symbol("beta")
    field = {u: sp.S.Zero, v: sp.S.Zero}
    slope = u * sp.sin(beta) - v * sp.cos(beta)
    system = System("still", "Still", field, (Parameter(beta, "angle", 0.5),), relations=(slope,))
    sine, cosine = sp.sin(beta), sp.cos(beta)
    there = (sine - sp.Rational(3, 5), cosine - sp.Rational(4, 5))
    assert prove(system, Identity("x", u, level=there)).decision == "refuted"
    assert prove(system, Identity("y", v - u * sp.Rational(3, 4), level=there)).decision == "proven"
    for on in ((there[0], cosine - sp.Rational(3, 5)), (sine - 2,)):
        with pytest.raises(InputError, match="is empty"):
            prove(system, Identity("x", u, level=on))

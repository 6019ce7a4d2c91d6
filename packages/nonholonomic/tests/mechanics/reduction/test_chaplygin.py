"""The reducing multiplier from a Lagrangian alone, against what is known of each system."""

import math
from dataclasses import replace
from functools import cache

import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Measure
from flowlanes.system.vectors import dot, real_symbol, to_components
from lawproof.proof.prover import prove
from mechanics.reducible import (
    ROTORS,
    I,
    R,
    a,
    ball,
    ball_in_coordinates,
    gamma,
    hollow_ball,
    m,
    omega,
    on_sphere,
    ratio,
    rotors,
    sleigh,
    veselova,
    x,
    y,
)
from nonholonomic.mechanics.lagrangian.mechanism import TIME, Mechanism, coordinates
from nonholonomic.mechanics.reduction.base_coordinates import base
from nonholonomic.mechanics.reduction.chaplygin import chaplygin_form
from nonholonomic.mechanics.reduction.horizontal_lift import lift
from nonholonomic.mechanics.reduction.integrals import Linear
from nonholonomic.mechanics.reduction.momenta import motion
from nonholonomic.mechanics.reduction.numerical import gyroscopic_integral, log_multiplier
from nonholonomic.mechanics.reduction.quadratic_integral import energy_like_integral
from nonholonomic.mechanics.reduction.reduced_form import ChaplyginForm
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import RollingBody
from nonholonomic.mechanics.rolling.mechanism import rolling_mechanism
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Sphere

z = real_symbol("z")
SPACE = coordinates(x, y, z)
DX, DY, DZ = SPACE.w
FREE = (DX**2 + DY**2 + DZ**2) / 2
J = [i + m * R**2 for i in I.symbols]
U = sp.Function("U")(*gamma.symbols)
THETA, PHI = real_symbol("theta"), real_symbol("phi")
ANGLES = dict(
    zip(
        gamma.symbols,
        (sp.sin(THETA) * sp.sin(PHI), sp.sin(THETA) * sp.cos(PHI), sp.cos(THETA)),
        strict=True,
    )
)


def proven(form: ChaplyginForm, where: tuple[str, ...] = ()) -> list[str]:
    """Names of all claims, each proven, the new time where it runs forward."""
    names = []
    for system, law in form.claims():
        verdict = prove(system, law)
        allowed = where if law.name == "canonical" else ()
        message = f"{system.name}: {law.name} {verdict.decision}: {verdict.reason}"
        assert verdict.decision.startswith("proven"), message
        assert verdict.conditions == allowed, message
        names.append(law.name)
    return names


def same_up_to_constant(first: sp.Expr, second: sp.Expr, form: ChaplyginForm) -> None:
    """The quotient has one value at several places."""
    quotient = (first / second).xreplace(ANGLES).subs(form.system.defaults)
    places = [(0.4, 0.3), (1.1, 2.0), (2.3, -0.7), (1.7, 4.1)]
    values = [complex(quotient.evalf(30, subs={THETA: t, PHI: p})) for t, p in places]
    for value in values[1:]:
        assert abs(value / values[0] - 1) < 1e-12


@cache
def of_ball() -> ChaplyginForm:
    return chaplygin_form(ball())


def squares(weights: list[sp.Expr]) -> sp.Expr:
    return sp.Add(*(w * s**2 for w, s in zip(weights, gamma.symbols, strict=True)))


# --- rediscovered -----------------------------------------------------------------------------


@pytest.mark.slow
def test_sleigh_has_no_multiplier_unless_its_centre_is_beside_the_blade() -> None:
    form = chaplygin_form(sleigh())
    assert form.multiplier is None
    assert form.obstruction is not None
    assert form.obstruction.curl != 0
    assert form.obstruction.vanishing == (a,)
    assert proven(form) == ["energy", "energy", "motion"]


@pytest.mark.slow
def test_sleigh_with_its_centre_beside_the_blade() -> None:
    form = chaplygin_form(sleigh(sp.S.Zero))
    assert form.multiplier is not None
    assert form.multiplier.powers == ((sp.cos(PHI), sp.S.One),)
    assert form.gyroscopic == 0
    # N = cos φ: the blade must not have turned by a right angle
    names = proven(form, where=("dτ/dt > 0",))
    assert {"measure", "bracket", "form", "motion", "canonical", "hamiltonian"} <= set(names)


@pytest.mark.slow
@pytest.mark.parametrize("potential", [sp.S.Zero, U], ids=["free", "potential"])
def test_veselova(potential: sp.Expr) -> None:
    form = chaplygin_form(veselova(potential))
    assert form.multiplier is not None
    same_up_to_constant(
        form.multiplier.value, squares([1 / i for i in I.symbols]) ** sp.Rational(-1, 2), form
    )
    assert form.flux is not None
    assert form.flux.value == 0
    assert "hamiltonian" in proven(form)


@pytest.mark.slow
def test_chaplygin_ball_with_its_monopole() -> None:
    form = of_ball()
    assert form.multiplier is not None
    D = m * R**2
    density = (1 - D * squares([1 / j for j in J])) ** sp.Rational(-1, 2)
    same_up_to_constant(form.multiplier.value, density, form)
    ((c, integral),) = form.integrals
    momentum = [sp.diff(integral.value, s) for s in omega.symbols]
    on_unit = dict(
        zip(gamma.symbols, (sp.Rational(2, 7), sp.Rational(3, 7), sp.Rational(6, 7)), strict=True)
    )
    lever = [i * s for i, s in zip(I.symbols, gamma.symbols, strict=True)]
    assert [sp.expand((p - q).xreplace(on_unit)) for p, q in zip(momentum, lever, strict=True)] == [
        0,
        0,
        0,
    ]
    assert form.flux is not None
    assert form.flux.value == -4 * sp.pi * c / sp.sqrt(sp.Mul(*I.symbols))
    assert form.hamiltonian is None
    assert {"linear_1", "measure", "form", "motion", "gyroscopic_form"} <= set(proven(form))


@pytest.mark.slow
def test_the_monopole_agrees_with_quadrature() -> None:
    form = chaplygin_form(ball(gyrostat=True))
    value, error = gyroscopic_integral(form)
    assert form.flux is not None
    exact = float(form.flux.value.subs(form.system.defaults))
    assert error < 1e-12
    assert abs(value - exact) < 1e-12
    assert abs(exact + 4 * math.pi * 0.8 / math.sqrt(1.0 * 1.5 * 2.1)) < 1e-14


@pytest.mark.slow
def test_ball_with_rotors_in_any_potential() -> None:
    form = chaplygin_form(ball(gyrostat=True, potential=U))
    assert form.multiplier is not None
    assert form.multiplier == of_ball().multiplier
    assert {"measure", "form", "motion"} <= set(proven(form))


@pytest.mark.slow
def test_veselova_with_rotors() -> None:
    plain = veselova()
    turning = Mechanism(
        "veselova-gyrostat",
        plain.frame,
        plain.L + to_components(dot(rotors, omega)),
        plain.constraints,
        parameters=(*plain.parameters, *ROTORS),
    )
    form = chaplygin_form(turning)
    assert form.multiplier == chaplygin_form(plain).multiplier
    assert form.multiplier is not None
    carried = to_components(dot(rotors, gamma))
    assert form.gyroscopic is not None
    assert sp.simplify(form.gyroscopic / form.multiplier.value - sp.sin(THETA) * carried) == 0
    assert form.flux is not None
    assert form.flux.value == 0
    assert form.hamiltonian is None
    assert abs(gyroscopic_integral(form)[0]) < 1e-13
    assert {"measure", "form", "motion"} <= set(proven(form))


@pytest.mark.slow
def test_ball_in_coordinates_has_the_same_multiplier() -> None:
    form = chaplygin_form(ball_in_coordinates())
    assert form.multiplier is not None
    other = of_ball().multiplier
    assert other is not None
    same_up_to_constant(form.multiplier.value, other.value, form)
    assert form.lifted is not None
    assert "motion" in proven(form)


@pytest.mark.slow
def test_rubber_ball_on_a_sphere_for_every_ratio() -> None:
    form = chaplygin_form(on_sphere(ratio, rubber=True))
    assert form.multiplier is not None
    ((base, exponent),) = form.multiplier.powers
    assert sp.simplify(exponent - (1 / (2 * ratio) - 1)) == 0
    same_up_to_constant(base, squares([1 / j for j in J]), form)
    assert {"measure", "form", "motion", "canonical", "hamiltonian"} <= set(proven(form))


@pytest.mark.slow
def test_rubber_ball_on_a_sphere_as_it_rolls() -> None:
    """The same from body, surface and contact: 1/(2k) − 1 for k = a/(a + R)."""
    body = Body(1.0, (1.0, 1.5, 2.1), Ball(1.0))
    form = chaplygin_form(rolling_mechanism(RollingBody(body, Sphere(2.0), "rubber")))
    assert form.multiplier is not None
    ((base, exponent),) = form.multiplier.powers
    assert sp.simplify(exponent - (R / a - 1) / 2) == 0
    same_up_to_constant(base, squares([1 / j for j in J]), form)
    assert {"measure", "form", "motion", "canonical", "hamiltonian"} <= set(proven(form))


def drawn(moments: tuple[sp.Expr, ...]) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """(n, Bn), (An, Bn) and det I_Q of the hollow ball with d = 1."""
    tensor = [i + 1 for i in moments]
    lever = [(sum(moments) + 1) / 2 - i for i in moments]
    mean = squares(lever)
    form = squares([j * l for j, l in zip(tensor, lever, strict=True)]) - mean
    weighted = squares([j * l**2 for j, l in zip(tensor, lever, strict=True)]) - mean**2
    return form, weighted, 1 - squares([1 / j for j in tensor])


MOMENTS = (sp.S(1), sp.Rational(3, 2), sp.S(2))


@pytest.mark.slow
def test_hollow_ball_on_the_zero_level() -> None:
    form = chaplygin_form(hollow_ball(MOMENTS), [0])
    above, below, det = drawn(MOMENTS)
    assert form.multiplier is not None
    same_up_to_constant(form.multiplier.value, above / below / sp.sqrt(det), form)
    assert form.gyroscopic == 0
    assert form.role == "the energy"
    assert {"motion", "canonical", "hamiltonian"} <= set(proven(form, where=("dτ/dt > 0",)))


@pytest.mark.slow
def test_hollow_ball_on_any_level() -> None:
    """Remark 22: (4.4) with a gyroscopic force, though not with the energy as E₂ + E₀."""
    form = chaplygin_form(hollow_ball(MOMENTS))
    above, _, det = drawn(MOMENTS)
    assert form.role != "the energy"
    c = form.integrals[0][0]
    assert form.gyroscopic is not None
    expected = c * sp.sin(THETA) * squares(list(MOMENTS)) / above**2 / sp.sqrt(det)
    same_up_to_constant(form.gyroscopic, expected, form)
    # the other integral is indefinite: the multiplier is singular where it degenerates
    assert len(form.singular) == 1
    assert form.flux is not None
    value, _ = gyroscopic_integral(form)
    assert abs(value / float(form.flux.value.subs(form.system.defaults)) - 1) < 1e-12
    assert {"measure", "bracket", "form", "motion", "gyroscopic_form"} <= set(proven(form))


@pytest.mark.slow
def test_hollow_ball_near_a_thin_shell_has_a_smooth_multiplier() -> None:
    shell = chaplygin_form(hollow_ball((sp.Rational(2, 3), sp.Rational(7, 10), sp.Rational(3, 4))))
    assert shell.multiplier is not None
    assert shell.singular == ()
    assert shell.role != "the energy"


# --- what is claimed can be wrong -------------------------------------------------------------


def test_another_exponent_is_refuted() -> None:
    form = chaplygin_form(veselova())
    assert form.multiplier is not None
    ((base, exponent),) = form.multiplier.powers
    wrong = Measure("measure", {base: -exponent})
    assert prove(form.system, wrong).decision == "refuted"


@pytest.mark.slow
def test_another_gyroscopic_force_is_no_motion_of_the_ball() -> None:
    form = of_ball()
    S = real_symbol("S")
    bent = replace(
        form.system,
        definitions=tuple((n, 2 * f if n == S else f) for n, f in form.system.definitions),
    )
    assert prove(bent, "motion").decision == "refuted"


def test_logarithm_by_quadrature() -> None:
    form = of_ball()
    value, error = log_multiplier(form, (0.5, 0.2), (1.7, 1.1))
    assert form.multiplier is not None
    N = form.multiplier.value.xreplace(ANGLES).subs(form.system.defaults)
    exact = sp.log(N.subs({THETA: 1.7, PHI: 1.1}) / N.subs({THETA: 0.5, PHI: 0.2}))
    assert error < 1e-12
    assert abs(value - float(exact)) < 1e-12


def test_a_multiplier_that_is_no_product() -> None:
    """d ln N = −y dy/(1 + y + y²), with an arc tangent in its integral."""
    mechanism = Mechanism("hanging", SPACE, (DX**2 + DY**2 + DZ**2 / (1 + y)) / 2, (DZ - y * DX,))
    form = chaplygin_form(mechanism)
    assert form.multiplier is None
    assert form.obstruction is None
    assert form.closed_form
    assert "by quadrature" in str(form)
    value, error = log_multiplier(form, (0.3, 0.0), (-0.2, 1.5))
    turn = math.atan(4 / math.sqrt(3)) - math.atan(1 / math.sqrt(3))
    exact = -math.log(1 + 1.5 + 1.5**2) / 2 + turn / math.sqrt(3)
    assert error < 1e-12
    assert abs(value - exact) < 1e-12
    assert proven(form)[-1] == "motion"


@pytest.mark.slow
def test_the_page_tells_all() -> None:
    page = str(of_ball())
    assert "N = 1 / √(" in page
    assert "∫S̄ = −4 π c" in page
    assert max(map(len, page.splitlines())) <= 100
    refused = str(chaplygin_form(sleigh()))
    assert "it vanishes where a = 0" in refused


# --- refused ----------------------------------------------------------------------------------


def refused(mechanism: Mechanism) -> str:
    with pytest.raises(InputError) as mistake:
        chaplygin_form(mechanism)
    return str(mistake.value)


def test_affine_constraint() -> None:
    assert "affine" in refused(Mechanism("turntable", SPACE, FREE, (DZ - y * DX - 1,)))


def test_nonlinear_constraint() -> None:
    assert "not linear" in refused(Mechanism("appell", SPACE, FREE, (DZ**2 - DX**2 - DY**2,)))


def test_lagrangian_of_degree_four() -> None:
    assert "not quadratic" in refused(Mechanism("quartic", SPACE, FREE + DX**4, (DZ - y * DX,)))


def test_time() -> None:
    assert "time" in refused(Mechanism("driven", SPACE, FREE - TIME * x, (DZ - y * DX,)))


def test_friction() -> None:
    mechanism = Mechanism("rubbed", SPACE, FREE, (DZ - y * DX,), forces={DX: -DX})
    assert "no potential" in refused(mechanism)


def test_three_coordinates() -> None:
    mechanism = Mechanism("bound", SPACE, FREE - x * y * z, (DZ - y * DX,))
    assert "need x, y, z" in refused(mechanism)


@pytest.mark.slow
def test_no_linear_integral() -> None:
    assert "no integral linear in the momenta" in refused(on_sphere(sp.Rational(1, 3), False))


@pytest.mark.slow
def test_a_level_on_which_no_integral_serves() -> None:
    mechanism = ball()
    moved = motion(mechanism)
    here = base(mechanism, moved)
    # no integral: the energy keeps a part linear in the rates of the angles
    crooked = Linear(omega.symbols[2], omega.symbols[2])
    up = lift(here, [crooked], [real_symbol("c")])
    with pytest.raises(InputError, match="part linear in the velocities"):
        energy_like_integral(mechanism, moved, up)


def test_a_root_in_the_metric() -> None:
    mechanism = Mechanism("root", SPACE, FREE * sp.sqrt(1 + x**2), (DZ - y * DX,))
    assert "rational" in refused(mechanism)


def test_levels_of_other_number() -> None:
    with pytest.raises(InputError, match="1 levels are given"):
        chaplygin_form(veselova(), [0])

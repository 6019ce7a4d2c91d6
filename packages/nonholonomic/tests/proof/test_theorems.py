"""Energy by Theorem 1: proven from the equations that accelerations solve, and only where it holds.

One mechanism written in several ways has the same verdicts.
"""

from __future__ import annotations

import tomllib
from dataclasses import replace
from typing import Any

import pytest
import sympy as sp

import flowlanes
import lawproof
import nonholonomic
from certificate_checker import check
from flowlanes.system import real_symbol
from lawproof.proof.certificates.certificate import prove_with_certificate
from lawproof.proof.power_theorem import PowerTheorem
from lawproof.proof.theorems import identities_of, theorem_of
from nonholonomic.system_files.described import MechanismFile
from nonholonomic.system_files.mechanisms import mechanism_of

x, y, phi, xdot, ydot, phidot = map(real_symbol, ["x", "y", "phi", "xdot", "ydot", "phidot"])
m, J, k = map(real_symbol, ["m", "J", "k"])
PARAMETERS = (
    flowlanes.Parameter(m, "mass", 1.0, admissible=(m > 0,)),
    flowlanes.Parameter(J, "moment of inertia", 0.4, admissible=(J > 0,)),
    flowlanes.Parameter(k, "stiffness", 2.0),
)
BLADE = ydot * sp.cos(phi) - xdot * sp.sin(phi)
LAGRANGIAN = m * (xdot**2 + ydot**2) / 2 + J * phidot**2 / 2 - k * (x**2 + phi**2) / 2
PLANE = nonholonomic.coordinates(x, y, phi)


def skate(**changed: Any) -> nonholonomic.Mechanism:
    """A skate on a spring: its constraint is solved for no velocity."""
    told: dict[str, Any] = {
        "name": "skate", "frame": PLANE, "lagrangian": LAGRANGIAN, "constraints": (BLADE,),
        "parameters": PARAMETERS,
    }  # fmt: skip
    return nonholonomic.Mechanism(**{**told, **changed})


ENERGY = m * (xdot**2 + ydot**2) / 2 + J * phidot**2 / 2 + k * (x**2 + phi**2) / 2

STREET = """
title = "Disc with a load on a wavy street"
[parameters]
m = 1.0
mo = 0.3
r = 0.5
e = 0.3
A = 0.2
k = 1.0
g = 9.81
[frame]
coordinates = ["s", "theta"]
[definitions]
h = "A*sin(k*s)"
h1 = "A*k*cos(k*s)"
h2 = "-A*k**2*sin(k*s)"
w = "sqrt(1 + h1**2)"
xc = "s - r*h1/w"
yc = "h + r/w"
xcd = "sdot*(1 - r*h2/w**3)"
ycd = "sdot*(h1 - r*h1*h2/w**3)"
[lagrangian]
kinetic = "m*(xcd**2 + ycd**2)/2 + m*r**2*thetadot**2/4 + mo*((xcd - e*sin(theta)*thetadot)**2 + (ycd + e*cos(theta)*thetadot)**2)/2"
potential = "m*g*yc + mo*g*(yc + e*sin(theta))"
[constraints]
velocity = ["r*thetadot + w*sdot*(1 - r*h2/w**3)"]
"""  # noqa: E501

BOARD = """
title = "Skateboard"
[parameters]
m = 1.0
J = 0.3
I = 0.05
K = 0.2
L = 0.7
[frame]
coordinates = ["x", "y", "phi", "psi"]
[definitions]
{definitions}
[lagrangian]
kinetic = "m*(xdot**2 + ydot**2)/2 + J*phidot**2/2 + I*psidot**2/2"
potential = "{potential}"
[constraints]
velocity = [{constraints}]
"""
ACROSS = "-xdot*sin(phi) + ydot*cos(phi)"
TURN = "phidot*L - (xdot*cos(phi) + ydot*sin(phi))*tan(psi)"
WAYS = {
    "written out": ("", f'"{ACROSS}", "{TURN}"'),
    "named": (f'across = "{ACROSS}"\nturn = "{TURN}"', '"across", "turn"'),
    "in another order": (f'turn = "{TURN}"\nacross = "{ACROSS}"', '"turn", "across"'),
    "a part named": (
        'along = "xdot*cos(phi) + ydot*sin(phi)"', f'"{ACROSS}", "phidot*L - along*tan(psi)"',
    ),
    "a name in a name": (
        f'side = "{ACROSS}"\nacross = "2*side"\nturn = "{TURN}"', '"turn", "across"',
    ),
}  # fmt: skip


def of_file(text: str) -> flowlanes.System:
    return nonholonomic.equations_of_motion(
        mechanism_of(MechanismFile.model_validate(tomllib.loads(text)))
    )


def by_theorem(verdict: lawproof.Verdict) -> bool:
    return verdict.decision == "proven" and verdict.finding.startswith("Theorem 1")


def test_energy_on_a_wavy_street_is_proven_at_little_cost() -> None:
    verdict = lawproof.prove(of_file(STREET), "energy", effort=20_000_000)
    assert by_theorem(verdict)
    assert verdict.effort < 5_000_000


@pytest.mark.slow
def test_energy_on_a_wavy_street_has_a_certificate() -> None:
    system = of_file(STREET)
    verdict = prove_with_certificate(system, system.laws[0])
    assert verdict.certificate is not None and "rates" in verdict.certificate
    check(verdict.certificate)


@pytest.mark.parametrize(
    ("way", "potential"),
    [
        ("written out", "0"),
        ("a name in a name", "K*psi**2/2"),
        *(pytest.param(way, "K*psi**2/2", marks=pytest.mark.slow) for way in list(WAYS)[:-1]),
        *(pytest.param(way, "0", marks=pytest.mark.slow) for way in list(WAYS)[1:]),
    ],
)
def test_one_mechanism_written_in_several_ways_has_the_same_verdicts(
    way: str, potential: str
) -> None:
    definitions, constraints = WAYS[way]
    system = of_file(
        BOARD.format(definitions=definitions, constraints=constraints, potential=potential)
    )
    energy, speed = system.laws[0], real_symbol("xdot")
    assert by_theorem(lawproof.prove(system, energy))
    wrong = flowlanes.Integral("wrong", energy.value + speed**2)
    assert lawproof.prove(system, wrong).decision == "refuted"
    assert lawproof.prove(system, flowlanes.Measure("volume", {})).decision == "refuted"
    tangent = flowlanes.Identity("tangent", flowlanes.Rate(sp.sympify(system.relations[0])))
    assert lawproof.prove(system, tangent).decision == "proven"


def test_the_energy_of_the_user_s_own_words_is_proven_alike() -> None:
    system = nonholonomic.equations_of_motion(skate(laws=(flowlanes.Integral("mine", ENERGY + 3),)))
    assert [by_theorem(lawproof.prove(system, name)) for name in ("energy", "mine")] == [True, True]


def test_the_theorem_of_jacobi_s_integral() -> None:
    """A bead on a hoop that turns: T2 − T0 + V is constant, T2 + T0 + V is not."""
    theta, speed, Omega = map(real_symbol, ["theta", "thetadot", "Omega"])
    spun, height = Omega**2 * sp.sin(theta) ** 2 / 2, -sp.cos(theta)
    bead = nonholonomic.Mechanism(
        "bead", nonholonomic.coordinates(theta), speed**2 / 2 + Omega * speed + spun - height,
        parameters=(flowlanes.Parameter(Omega, "angular velocity", 2.0),),
        laws=(
            flowlanes.Integral("jacobi", speed**2 / 2 - spun + height),
            flowlanes.Integral("energy_in_space", speed**2 / 2 + spun + height),
        ),
    )  # fmt: skip
    system = nonholonomic.equations_of_motion(bead)
    assert by_theorem(lawproof.prove(system, "energy")) and by_theorem(
        lawproof.prove(system, "jacobi")
    )
    assert lawproof.prove(system, "energy_in_space").decision == "refuted"


t = real_symbol("t")
NOT_IDEAL: dict[str, dict[str, Any]] = {
    "friction": {"forces": {xdot: -k * xdot}},
    "time in the potential": {"lagrangian": LAGRANGIAN - x * sp.sin(t)},
    "time in the constraint": {"constraints": (BLADE - sp.sin(t) * phidot - sp.cos(t),)},
    "an affine constraint": {"constraints": (BLADE - k,)},
    "a moving constraint": {"constraints": (BLADE - k * sp.cos(phi),)},
}


@pytest.mark.parametrize("case", NOT_IDEAL)
def test_without_its_hypotheses_the_theorem_does_not_apply(case: str) -> None:
    claim = flowlanes.Integral("claimed", ENERGY)
    system = nonholonomic.equations_of_motion(skate(laws=(claim,), **NOT_IDEAL[case]))
    assert not system.theorems
    assert lawproof.prove(system, claim).decision == "refuted"


def test_forces_that_do_no_work_leave_the_theorem() -> None:
    magnetic = {xdot: k * ydot, ydot: -k * xdot}
    assert by_theorem(
        lawproof.prove(nonholonomic.equations_of_motion(skate(forces=magnetic)), "energy")
    )


def test_the_theorem_does_not_outlive_its_equations() -> None:
    """Equations that were changed under it solve no linear equations: the identities fail."""
    system = nonholonomic.equations_of_motion(skate())
    rates = dict(zip(system.symbols, system.rates, strict=True))
    field = {**rates, phidot: rates[phidot] - k * phidot}
    changed = replace(system, field=field)
    (theorem,) = changed.theorems
    assert isinstance(theorem, PowerTheorem)
    energy = changed.laws[0]
    verdicts = [
        v for whole in identities_of(theorem, changed, energy) for v in lawproof.prove_all(whole)
    ]
    assert [v.decision for v in verdicts] == ["proven", "refuted"]
    assert lawproof.prove(changed, energy).decision == "refuted"


def test_the_theorem_is_silent_on_other_laws_and_levels() -> None:
    system = nonholonomic.equations_of_motion(skate())
    (theorem,) = system.theorems
    assert theorem_of(system, flowlanes.Measure("volume", {})) is None
    energy = system.laws[0]
    assert identities_of(theorem, system, replace(energy, level=(x,))) == ()
    more = replace(system, relations=(*system.relations, x - phi))
    assert identities_of(theorem, more, energy) == ()
    # a formula that is constant where the relation holds, but is not the energy, goes another way
    inverse = flowlanes.Integral("inverse", 1 / energy.value)
    assert identities_of(theorem, system, inverse)
    verdict = lawproof.prove(system, inverse)
    assert verdict.decision == "proven" and not by_theorem(verdict)


def test_the_theorem_is_silent_where_a_multiplier_may_be_infinite() -> None:
    """Where x = 0 the constraint restricts nothing, and the equations are defined nevertheless."""
    z, zdot = real_symbol("z"), real_symbol("zdot")
    slack = nonholonomic.Mechanism(
        "slack",
        nonholonomic.coordinates(x, z),
        (xdot**2 + 2 * zdot**2 - x**2 - z**2) / 2,
        constraints=(x * (zdot - x**2 * xdot),),
    )
    system = nonholonomic.equations_of_motion(slack)
    (theorem,) = system.theorems
    energy = system.laws[0]
    assert identities_of(theorem, system, energy) == ()
    assert lawproof.prove(system, energy).decision != "proven"

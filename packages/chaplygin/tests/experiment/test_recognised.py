"""A body that is not named gets the laws that hold for it, and no others."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from chaplygin.report.summary import drift
from evaluation import numeric
from flowlanes.flow.integrator import integrate
from lawproof.proof.prover import prove
from nonholonomic.catalogue import CATALOGUE

BODY = """
[body]
mass = 1.3
inertia = {inertia}
gyrostat = {gyrostat}

[body.shape]
{shape}
centre = {centre}

[surface]
{surface}

[contact]
model = "{contact}"

[field]
gravity = {gravity}
potential = "{potential}"

[start]
gamma = [0.36, -0.48, 0.8]
omega = {omega}
"""

PLAIN = {
    "inertia": [1.0, 1.5, 2.1],
    "gyrostat": [0.0, 0.0, 0.0],
    "shape": 'kind = "ball"\nradius = 0.9',
    "centre": [0.0, 0.0, 0.0],
    "surface": 'kind = "plane"',
    "contact": "marble",
    "gravity": 0.0,
    "potential": "",
    "omega": [0.7, 0.4, 1.1],
}
NO_SPIN = [0.8, -0.4, -0.6]
RUBBER = {"contact": "rubber", "omega": NO_SPIN}
SPHERE = 'kind = "sphere"\nradius = {}'
HOLLOW = {
    "shape": 'kind = "ball"\nhollow = true\nradius = 1.8',
    "surface": SPHERE.format(0.9),
}
BRUNS = "0.35*(I_1*gamma_1**2 + I_2*gamma_2**2 + I_3*gamma_3**2)"
ELLIPSOID = 'kind = "ellipsoid"\naxes = [1.0, 1.0, 1.2]'
ROUND = {"inertia": [1.0, 1.0, 1.7]}


def study(**changes: object) -> Study:
    return Study.from_experiment(parse_experiment(BODY.format(**{**PLAIN, **changes})))


def names(made: Study) -> set[str]:
    return {law.name for law in made.system.integrals}


@dataclass(frozen=True)
class Case:
    changes: dict[str, object]
    laws: set[str]


CASES = {
    "Chaplygin ball": Case({}, {"area", "momentum"}),
    "heavy Chaplygin ball": Case({"gravity": 9.81}, {"area", "momentum"}),
    "Chaplygin ball, full tensor": Case(
        {"inertia": [[1.0, 0.1, 0.0], [0.1, 1.5, 0.05], [0.0, 0.05, 2.1]]}, {"area", "momentum"}
    ),
    "Chaplygin ball with rotors": Case({"gyrostat": [0.1, 0.2, -0.3]}, {"area", "momentum"}),
    "Chaplygin ball, Bruns": Case({"potential": BRUNS}, {"area", "momentum"}),
    "Chaplygin ball, not quite Bruns": Case({"potential": f"{BRUNS} + gamma_1"}, {"area"}),
    "Chaplygin ball with rotors, Bruns": Case(
        {"potential": BRUNS, "gyrostat": [0.1, 0.2, -0.3]}, {"area"}
    ),
    "rubber Chaplygin ball": Case(RUBBER, {"momentum"}),
    "rubber Chaplygin ball with rotors": Case(
        {**RUBBER, "gyrostat": [0.1, 0.2, -0.3]}, {"momentum"}
    ),
    "rubber Chaplygin ball, Bruns": Case({**RUBBER, "potential": BRUNS}, {"momentum"}),
    "rubber Chaplygin ball, not quite Bruns": Case(
        {**RUBBER, "potential": f"{BRUNS} + gamma_1"}, set()
    ),
    "unbalanced ball": Case({"centre": [0.1, 0.05, 0.2]}, {"quadratic"}),
    "heavy unbalanced ball": Case({"centre": [0.1, 0.05, 0.2], "gravity": 9.81}, set()),
    "unbalanced ball with rotors": Case(
        {"centre": [0.1, 0.05, 0.2], "gyrostat": [0.1, 0.2, -0.3]}, set()
    ),
    "unbalanced rubber ball": Case({**RUBBER, "centre": [0.1, 0.05, 0.2]}, {"quadratic"}),
    "heavy unbalanced rubber ball": Case(
        {**RUBBER, "centre": [0.1, 0.05, 0.2], "gravity": 9.81}, set()
    ),
    "heavy round rubber ball": Case(
        {**RUBBER, **ROUND, "centre": [0.0, 0.0, 0.2], "gravity": 9.81}, {"spin"}
    ),
    "round rubber ball": Case(
        {**RUBBER, **ROUND, "centre": [0.0, 0.0, 0.2]}, {"quadratic", "spin"}
    ),
    "heavy round rubber ellipsoid": Case(
        {**RUBBER, **ROUND, "shape": ELLIPSOID, "gravity": 9.81}, {"spin"}
    ),
    "round rubber ellipsoid, potential of the axis": Case(
        {**RUBBER, **ROUND, "shape": ELLIPSOID, "potential": "gamma_3**3"}, {"spin"}
    ),
    "round rubber ellipsoid, potential not of the axis": Case(
        {**RUBBER, **ROUND, "shape": ELLIPSOID, "potential": "gamma_1"}, set()
    ),
    "rubber ellipsoid, unequal moments": Case({**RUBBER, "shape": ELLIPSOID}, set()),
    "rubber ellipsoid, centre off the axis": Case(
        {**RUBBER, **ROUND, "shape": ELLIPSOID, "centre": [0.1, 0.0, 0.0]}, set()
    ),
    "marble ellipsoid": Case({**ROUND, "shape": ELLIPSOID}, set()),
    "ball on a sphere": Case({"surface": SPHERE.format(2.0)}, {"momentum"}),
    "ball in a bowl": Case({"surface": SPHERE.format(2.5) + '\nside = "inside"'}, {"momentum"}),
    "ball on a sphere with rotors": Case(
        {"surface": SPHERE.format(2.0), "gyrostat": [0.1, 0.2, -0.3]}, {"momentum"}
    ),
    "heavy ball on a sphere": Case({"surface": SPHERE.format(2.0), "gravity": 9.81}, set()),
    "unbalanced ball on a sphere": Case(
        {"surface": SPHERE.format(2.0), "centre": [0.1, 0.05, 0.2]}, {"quadratic"}
    ),
    "ball on a sphere in a potential": Case(
        {"surface": SPHERE.format(2.0), "potential": "gamma_1"}, set()
    ),
    "rubber ball on a sphere": Case({**RUBBER, "surface": SPHERE.format(2.0)}, set()),
    "hollow ball, k = -1": Case(HOLLOW, {"momentum", "linear"}),
    "hollow ball with rotors, k = -1": Case({**HOLLOW, "gyrostat": [0.1, 0.2, -0.3]}, {"momentum"}),
    "hollow ball, k = -2": Case({**HOLLOW, "surface": SPHERE.format(1.2)}, {"momentum"}),
    "hollow rubber ball, k = -1": Case({**HOLLOW, **RUBBER}, {"quadratic"}),
    "hollow rubber ball, k = -2": Case({**HOLLOW, **RUBBER, "surface": SPHERE.format(1.2)}, set()),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_laws_of_an_experiment(name):
    case = CASES[name]
    made = study(**case.changes)
    assert names(made) == {"energy", *case.laws}
    times = np.linspace(0.0, 20.0, 41)
    motion = integrate(made.system, made.start, times, on_liftoff="warn")
    assert motion.times[-1] == 20.0
    for law in made.system.integrals:
        assert drift(motion.records[f"law_{law.name}"]) < 1e-13, law.name


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_all_that_is_said_of_an_experiment_is_proven(name):
    system = study(**CASES[name].changes).system
    decisions = {law.name: prove(system, law).decision for law in system.laws}
    assert decisions == dict.fromkeys(decisions, "proven")


@dataclass(frozen=True)
class Elsewhere:
    """A law of the catalogue, and a body for which it must not be claimed."""

    home: str
    law: str
    changes: dict[str, object]


ELSEWHERE = (
    Elsewhere("unbalanced-ball", "quadratic", CASES["heavy unbalanced ball"].changes),
    Elsewhere("unbalanced-ball", "quadratic", CASES["unbalanced ball with rotors"].changes),
    Elsewhere("unbalanced-rubber-ball", "quadratic", CASES["heavy unbalanced rubber ball"].changes),
    Elsewhere("chaplygin-ball", "area", CASES["heavy unbalanced ball"].changes),
    Elsewhere("chaplygin-ball", "momentum", CASES["heavy unbalanced ball"].changes),
    Elsewhere("chaplygin-ball", "momentum", CASES["unbalanced ball"].changes),
    Elsewhere("chaplygin-ball", "momentum", CASES["Chaplygin ball, not quite Bruns"].changes),
    Elsewhere("chaplygin-ball", "area", CASES["ball on a sphere"].changes),
    Elsewhere("chaplygin-ball", "momentum", CASES["rubber Chaplygin ball"].changes),
    Elsewhere(
        "rubber-chaplygin-ball", "momentum", CASES["rubber Chaplygin ball, not quite Bruns"].changes
    ),
    Elsewhere("ball-on-sphere", "momentum", CASES["heavy ball on a sphere"].changes),
    Elsewhere("ball-on-sphere", "momentum", CASES["unbalanced ball on a sphere"].changes),
    Elsewhere("ball-on-sphere", "momentum", CASES["ball on a sphere in a potential"].changes),
    Elsewhere("ball-around-sphere", "linear", CASES["hollow ball, k = -2"].changes),
    Elsewhere("ball-around-sphere", "linear", CASES["ball on a sphere"].changes),
    Elsewhere(
        "rubber-ball-around-sphere", "quadratic", CASES["hollow rubber ball, k = -2"].changes
    ),
    Elsewhere("rubber-ball-around-sphere", "quadratic", CASES["rubber ball on a sphere"].changes),
    Elsewhere(
        "rubber-body-of-revolution",
        "spin",
        CASES["round rubber ellipsoid, potential not of the axis"].changes,
    ),
    Elsewhere(
        "rubber-body-of-revolution", "spin", CASES["rubber ellipsoid, centre off the axis"].changes
    ),
    Elsewhere("rubber-body-of-revolution", "spin", CASES["marble ellipsoid"].changes),
)


@pytest.mark.slow
@pytest.mark.parametrize("case", ELSEWHERE, ids=lambda c: f"{c.home} {c.law}")
def test_a_law_is_not_claimed_where_it_fails(case):
    """The law, written for the other body, is not constant there: it is left out with reason."""
    made = study(**case.changes)
    (law,) = (law for law in CATALOGUE[case.home].system().integrals if law.name == case.law)
    assert law.value not in [other.value for other in made.system.integrals]
    motion = integrate(made.system, made.start, np.linspace(0.0, 20.0, 41), on_liftoff="warn")
    found = numeric(motion.system, [law.value])(motion.states.T)[0]
    assert np.abs(found - found[0]).max() > 1e-3 * (1 + np.abs(found).max())

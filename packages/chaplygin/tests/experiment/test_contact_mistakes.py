"""Mistakes in experiment files with friction: one sentence each, with the place."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import chaplygin as ch
from flowlanes.errors import InterruptionError

BALL = """\
[body]
mass = 1.0
inertia = [0.4, 0.5, 0.6]
[body.shape]
kind = "ball"
radius = 1.0
"""
FRICTION = '[contact]\nmodel = "friction"\n'
CONTACT = "[start]\ngamma = [0, 0, 1]\nomega = [1, 2, 3]\n"
SPACE = """\
[start]
position = [0, 0, 2]
attitude = [1, 0, 0, 0]
velocity = [0, 0, 0]
omega = [1, 2, 3]
"""
PLAIN = BALL + FRICTION + CONTACT
ROLLING = BALL + CONTACT

#: Text and sentence, by the kind of mistake.
MISTAKES: dict[str, tuple[str, str]] = {
    "below the ground": (
        BALL + FRICTION + SPACE.replace("[0, 0, 2]", "[0, 0, 0.75]"),
        "line 10, start.position: the body lies 0.25 m inside the support; move it outwards by at "
        "least that much",
    ),
    "inside a dome": (
        BALL + FRICTION + SPACE + '[surface]\nkind = "sphere"\nradius = 1.5\n',
        "line 10, start.position: the body lies 0.5 m inside the support; move it outwards by at "
        "least that much",
    ),
    "outside a bowl": (
        BALL + FRICTION + SPACE + '[surface]\nkind = "sphere"\nradius = 2.5\nside = "inside"\n',
        "line 10, start.position: the body lies 0.5 m inside the support; move it outwards by at "
        "least that much",
    ),
    "patch and spin_arm": (
        BALL + FRICTION + "mu = 0.3\npatch = 0.1\nspin_arm = 0.1\n" + CONTACT,
        "line 7, contact: spin_arm and patch exclude each other: over a patch slip and spin share "
        "the friction of mu; leave out one of them",
    ),
    "patch without mu": (
        BALL + FRICTION + "patch = 0.1\n" + CONTACT,
        "line 7, contact: patch needs mu, the coefficient of friction on the patch",
    ),
    "patch with unlimited mu": (
        BALL + FRICTION + "patch = 0.1\nmu = inf\n" + CONTACT,
        "line 7, contact: mu must be positive and finite with patch, not inf; leave out patch for "
        "a contact at a point",
    ),
    "patch larger than the ball": (
        BALL + FRICTION + "mu = 0.3\npatch = 1.5\n" + CONTACT,
        "line 10, contact.patch: patch = 1.5 m: a patch of contact lies within the body, so that "
        "its radius is at most 1 m, half the largest breadth of the body",
    ),
    "two resistances": (
        BALL + FRICTION + "rolling = 0.1\ncontour = 0.1\n" + CONTACT,
        "line 7, contact: rolling and contour exclude each other, as both resist rolling; leave "
        "out one of them",
    ),
    "negative mu": (
        BALL + FRICTION + "mu = -0.1\n" + CONTACT,
        "line 9, contact.mu: must be a number not below zero, or inf, not -0.1",
    ),
    "mu not a number": (
        BALL + FRICTION + "mu = nan\n" + CONTACT,
        "line 9, contact.mu: must be a number not below zero, or inf, not nan",
    ),
    "mu in words": (
        BALL + FRICTION + 'mu = "large"\n' + CONTACT,
        'line 9, contact.mu: must be a number not below zero, or inf, not the text "large"',
    ),
    "negative arm": (
        BALL + FRICTION + "spin_arm = -0.1\n" + CONTACT,
        "line 9, contact.spin_arm: must be a finite number not below zero, not -0.1",
    ),
    "unlimited viscosity": (
        BALL + FRICTION + "viscous = inf\n" + CONTACT,
        "line 9, contact.viscous: must be a finite number not below zero, not inf",
    ),
    "slip not tangential": (
        PLAIN + "slip = [1, 0, 0.5]\n",
        "line 12, start.slip: (slip, gamma) = 0.5, and a body in contact slips along the support "
        "alone; the nearest admissible slip is [1.0, 0.0, 0.0]",
    ),
    "slip with unlimited mu": (
        BALL + FRICTION + "mu = inf\n" + CONTACT + "slip = [1, 0, 0]\n",
        "line 13, start.slip: with mu = inf the contact cannot slip; it must be zero",
    ),
    "velocity with unlimited mu": (
        BALL + FRICTION + "mu = inf\n" + SPACE.replace("[0, 0, 2]", "[0, 0, 1]"),
        "line 13, start.velocity: the contact would slip with 2.23607 m/s, and with mu = inf it "
        "cannot",
    ),
    "unknown key": (
        BALL + FRICTION + "nu = 0.1\n" + CONTACT,
        "line 9, contact.nu: unknown key; allowed: model, mu, spin_arm, patch, "
        "viscous, spin_viscous, slip, slip_order, force, couple, mu_static, values, rolling, "
        "rolling_viscous, contour, air, laws, restitution, impact_law, on_paradox",
    ),
    "unknown reaction": (
        PLAIN + '[run]\non_liftoff = "jump"\n',
        'line 13, run.on_liftoff: must be "fly" or "stop", not the text "jump"',
    ),
    "warning alone": (
        PLAIN + '[run]\non_liftoff = "warn"\n',
        'line 13, run.on_liftoff: must be "fly" or "stop" with friction: "warn" follows a body '
        "that its support pulls, and where it pulls there is no friction",
    ),
    "flight of a rolling body": (
        ROLLING + '[run]\non_liftoff = "fly"\n',
        'line 11, run.on_liftoff: must be "stop" or "warn"; a body that rolls by a constraint '
        'cannot leave the surface ("fly" needs contact.model = "friction")',
    ),
    "restitution above one": (
        BALL + FRICTION + "restitution = 1.5\n" + CONTACT,
        "line 9, contact.restitution: must be a number from 0 to 1, not 1.5",
    ),
    "impact law misspelt": (
        BALL + FRICTION + 'impact_law = "strong"\n' + CONTACT,
        'line 9, contact.impact_law: must be "stronge", "poisson" or "newton", not the text '
        '"strong"',
    ),
    "model misspelt": (
        BALL + '[contact]\nmodel = "frictoin"\n' + CONTACT,
        'line 8, contact.model: must be "marble", "rubber" or "friction", not the text "frictoin"',
    ),
    "model misspelt, with mu": (
        BALL + '[contact]\nmodel = "frictoin"\nmu = 0.3\n' + CONTACT,
        'line 8, contact.model: must be "marble", "rubber" or "friction", not the text "frictoin"',
    ),
    "model misspelt, with slip": (
        BALL + '[contact]\nmodel = "frictoin"\nmu = 0.3\n' + CONTACT + "slip = [1, 0, 0]\n",
        'line 8, contact.model: must be "marble", "rubber" or "friction", not the text "frictoin"',
    ),
    "model misspelt, with a start in space": (
        BALL + '[contact]\nmodel = "coulomb"\n' + SPACE,
        'line 8, contact.model: must be "marble", "rubber" or "friction", not the text "coulomb"',
    ),
    "model misspelt, with a body that may fly": (
        BALL + '[contact]\nmodel = "frictoin"\n' + CONTACT + '[run]\non_liftoff = "fly"\n',
        'line 8, contact.model: must be "marble", "rubber" or "friction", not the text "frictoin"',
    ),
    "marble misspelt": (
        BALL + '[contact]\nmodel = "marbel"\n' + CONTACT + '[run]\non_liftoff = "warn"\n',
        'line 8, contact.model: must be "marble", "rubber" or "friction", not the text "marbel"',
    ),
    "marble with mu": (
        BALL + '[contact]\nmodel = "marble"\nmu = 0.3\n' + CONTACT,
        'line 7, contact: mu is for a contact with friction: write model = "friction" with it, or '
        "leave it out",
    ),
    "mu without model": (
        BALL + "[contact]\nmu = 0.3\n" + CONTACT,
        'line 7, contact: mu is for a contact with friction: write model = "friction" with it, or '
        "leave it out",
    ),
    "mu without model, with slip": (
        BALL + "[contact]\nmu = 0.3\n" + CONTACT + "slip = [1, 0, 0]\n",
        'line 7, contact: mu is for a contact with friction: write model = "friction" with it, or '
        "leave it out",
    ),
    "mu without model, with a start in space": (
        BALL + "[contact]\nmu = 0.3\n" + SPACE,
        'line 7, contact: mu is for a contact with friction: write model = "friction" with it, or '
        "leave it out",
    ),
    "mu without model, with a body that may fly": (
        BALL + "[contact]\nmu = 0.3\n" + CONTACT + '[run]\non_liftoff = "fly"\n',
        'line 7, contact: mu is for a contact with friction: write model = "friction" with it, or '
        "leave it out",
    ),
    "mu without model, on a turntable": (
        BALL + "[contact]\nmu = 0.3\n" + CONTACT + "[surface]\nturntable = 2.0\n",
        'line 7, contact: mu is for a contact with friction: write model = "friction" with it, or '
        "leave it out",
    ),
    "marble on a turntable": (
        ROLLING + "[surface]\nturntable = 2.0\n",
        "line 10, surface: turntable is for a contact with friction; a body rolls without slipping "
        'on a surface at rest alone (contact.model = "friction" has both)',
    ),
    "turntable at infinite speed": (
        PLAIN + "[surface]\nturntable = inf\n",
        "line 13, surface.turntable: must be a finite angular velocity (rad/s), not inf",
    ),
    "attitude without length": (
        BALL + FRICTION + SPACE.replace("[1, 0, 0, 0]", "[0, 0, 0, 0]"),
        "line 11, start.attitude: must not be zero, as only its direction counts",
    ),
    "attitude of three numbers": (
        BALL + FRICTION + SPACE.replace("[1, 0, 0, 0]", "[1, 0, 0]"),
        "line 11, start.attitude: must be 4 finite numbers w, x, y, z with at least one not zero, "
        "not [1, 0, 0]",
    ),
    "two kinds of start": (
        PLAIN + "position = [0, 0, 1]\n",
        "line 9, start: position and gamma are given together; a start has either gamma, omega and "
        "slip (a body in contact), or position, attitude, velocity and omega",
    ),
    "half a start": (
        BALL + FRICTION + "[start]\nposition = [0, 0, 1]\nomega = [0, 0, 0]\n",
        "line 9, start: attitude and velocity missing; a start has either gamma, omega and slip (a "
        "body in contact), or position, attitude, velocity and omega",
    ),
    "no start": (
        BALL + FRICTION,
        "start: missing; it must be a table [start]; a start has either gamma, omega and slip (a "
        "body in contact), or position, attitude, velocity and omega",
    ),
    "place of a rolling ball": (
        BALL + FRICTION + "[start]\ncentre = [0, 0, 1]\nomega = [0, 0, 1]\n",
        "line 10, start.centre: unknown key; allowed: gamma, omega, slip, heading, normal, "
        "position, attitude, velocity",
    ),
    "normal on a plane": (
        PLAIN + "normal = [1, 0, 0]\n",
        "line 9, start: normal is for a sphere alone; on a plane it is always [0, 0, 1]",
    ),
    "surface of a ball": (
        PLAIN + '[surface]\nkind = "cylinder"\nradius = 3\n',
        'line 13, surface.kind: unknown kind "cylinder"; allowed: plane, sphere',
    ),
    "potential on a sphere": (
        PLAIN + '[surface]\nkind = "sphere"\nradius = 3\n[field]\npotential = "gamma_1"\n',
        "line 15, field: a potential U(gamma) with friction is for a plane alone; leave it out",
    ),
    "backward": (
        PLAIN + '[run]\ndirection = "backward"\n',
        'line 13, run.direction: must be "forward" with friction, whose motions do not determine '
        'their past, not the text "backward"',
    ),
    "many digits": (
        PLAIN + '[run]\nprecision = "quad"\n',
        'line 13, run.precision: must be "double" with friction, not the text "quad"',
    ),
    "a limit of time": (
        PLAIN + "[run]\ntime_limit = 3.0\n",
        "line 13, run.time_limit: must be left out with friction, not 3.0",
    ),
    "a coin on its face": (
        BALL.replace('"ball"', '"disk"') + FRICTION + CONTACT,
        "line 10, start.gamma: no single point of the body touches a support with this normal",
    ),
    "an unknown name in a formula": (
        BALL + FRICTION + 'force = "0.3*slipspeed"\n' + CONTACT,
        "line 9, contact.force: unknown name 'slipspeed', did you mean 'slip_speed'? allowed: "
        "slip_speed, spin, normal_force, abs, acos, asin, atan, atan2, cos, cosh, exp, log, max, "
        "min, pi, sign, sin, sinh, sqrt, tan, tanh\n    0.3*slipspeed\n        ^",
    ),
    "an empty formula": (
        BALL + FRICTION + 'force = "0.3"\ncouple = " "\n' + CONTACT,
        "line 10, contact.couple: the formula is empty\n     \n    ^",
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_is_one_sentence_with_its_place(name: str) -> None:
    text, sentence = MISTAKES[name]
    with pytest.raises(ch.InputError) as error:
        _ = ch.Study.from_experiment(ch.parse_experiment(text, "f.toml")).start
    assert str(error.value) == f"f.toml, {sentence}"


#: Numbers of usual kind and absurd size, and what is said of them.
EXTREMES = {
    "a spin": (
        PLAIN.replace("[1, 2, 3]", "[1e200, 2, 3]"),
        "line 9, start: state: v_2 = -1e+200, omega_1 = 1e+200 are too far from 1 to compute with",
    ),
    "a spin whose powers are too large": (
        PLAIN.replace("[1, 2, 3]", "[1e30, 2, 3]"),
        "line 9, start: there is no motion from here: the motion comes to a singular end: its "
        "state stops being a number; omega_1 = 1e+30 is too far from 1 to compute with",
    ),
    "a slip": (
        BALL + FRICTION + "mu = 0.3\n" + CONTACT + "slip = [1e200, 0, 0]\n",
        "line 10, start: state: v_1 = 1e+200 is too far from 1 to compute with",
    ),
    "a mass": (
        PLAIN.replace("mass = 1.0", "mass = 1e300"),
        "line 9, start: state: m = 1e+300 is too far from 1 to compute with",
    ),
    "a law": (
        BALL + FRICTION + "viscous = 1e300\n" + CONTACT,
        "line 10, start: there is no motion from here: the motion comes to a singular end: its "
        "state stops being a number; c_v = 1e+300 is too far from 1 to compute with",
    ),
    "a height": (
        BALL + FRICTION + SPACE.replace("[0, 0, 2]", "[0, 0, 1e200]"),
        "line 9, start: state: position_3 = 1e+200 is too far from 1 to compute with",
    ),
}


@pytest.mark.parametrize("name", EXTREMES)
def test_a_number_too_far_from_one_is_named(name: str) -> None:
    """They were tracebacks, or energies that are no numbers."""
    text, sentence = EXTREMES[name]
    with pytest.raises(ch.InputError) as error:
        ch.Study.from_experiment(ch.parse_experiment(text, "f.toml")).trajectory()
    assert str(error.value) == f"f.toml, {sentence}: choose other units or numbers"


BILLIARD = Path(__file__).parents[4] / "examples" / "billiard_ball.toml"


def test_of_a_motion_that_ends_at_once_the_number_farthest_from_one_is_named() -> None:
    """The state stopped being a number after 7e-11 s, and nobody knew why."""
    study = ch.Study.from_experiment(ch.load_experiment(BILLIARD, ["contact.mu=1e9"]))
    with pytest.raises(ch.RunError, match=r"number; of the numbers given, mu = 1e\+09 is the fart"):
        study.trajectory()


def test_a_time_without_end_is_refused() -> None:
    """It ran for ever, and no Ctrl-C came through."""
    study = ch.Study.from_experiment(
        ch.parse_experiment(PLAIN + "[run]\nuntil = 1e300\n", "f.toml")
    )
    with pytest.raises(ch.InputError, match=r"^f.toml, line 13, run.until: to follow a motion for"):
        study.trajectory()


def test_an_interrupted_motion_is_kept() -> None:
    study = ch.Study.from_experiment(
        ch.parse_experiment(PLAIN + "[run]\nuntil = 3000\nsamples = 301\n", "f.toml")
    )
    whole, done = study.trajectory(), []

    def interrupt(fraction: float) -> None:
        done.append(fraction)
        if len(done) == 3:
            raise KeyboardInterrupt

    with pytest.raises(InterruptionError) as stop:
        study.trajectory(interrupt)
    part = stop.value.partial
    assert 0 < done[0] < done[1] < done[2] < 1
    assert 10 < len(part.times) < 300
    assert stop.value.time == part.times[-1]
    assert np.array_equal(part.states, whole.states[: len(part.times)])
    assert np.array_equal(part.records["energy"], whole.records["energy"][: len(part.times)])


def test_a_body_that_touches_with_its_centre_of_mass() -> None:
    """Its typical length was the distance from the contact, and zero a divisor."""
    text = PLAIN.replace("radius = 1.0", "radius = 1.0\ncentre = [0, 0, 1]")
    study = ch.Study.from_experiment(
        ch.parse_experiment(text.replace('"friction"', '"friction"\nmu = 0.3'), "f.toml")
    )
    assert study.trajectory().drift < 1e-14


def test_a_body_that_touches_where_it_is_flat() -> None:
    """NumPy warned, and the state was said to stop being a number."""
    shape = 'kind = "implicit"\nsurface = "x**4 + y**4 + z**4 - 1"'
    text = PLAIN.replace('kind = "ball"\nradius = 1.0', shape)
    with pytest.raises(ch.InputError, match="strictly convex where it touches, and its formulas"):
        ch.Study.from_experiment(
            ch.parse_experiment(text.replace('"friction"', '"friction"\nmu = 0.3'))
        ).trajectory()

"""Files with a Lagrangian or equations: what they mean, and what is said of mistakes in them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

from chaplygin.experiment.models.described_models import EquationsExperiment, MechanismExperiment
from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from flowlanes.system.laws import Integral, Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import (
    Diagonal,
    Vector,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
)
from lawproof.proof.prover import prove
from nonholonomic.mechanics.lagrangian.mechanism import Frame, Mechanism, rotations
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.system_files.mechanisms import mechanism_of

EXAMPLES = Path(__file__).parents[5] / "examples"
SLEIGH, SUSLOV, VOLTERRA, TURNTABLE = (
    (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
    for name in ("sleigh", "suslov_problem", "volterra", "turntable")
)

PENDULUM = """\
[frame]
coordinates = ["R[3]"]
[parameters]
g = 9.81
[lagrangian]
kinetic = "dot(Rdot, Rdot)/2"
potential = "g*R_3"
[constraints]
position = ["dot(R, R) - 1"]
[start]
R = [0.6, 0.0, -0.8]
Rdot = [0.0, 1.0, 0.0]
"""


def study(text: str, *overrides: str) -> Study:
    return Study.from_experiment(parse_experiment(text, "own.toml", overrides))


def refused(text: str, *overrides: str) -> str:
    with pytest.raises(InputError) as caught:
        _ = study(text, *overrides).start
    return str(caught.value)


def changed(text: str, old: str, new: str) -> str:
    assert old in text
    return text.replace(old, new)


def same_field(found: System, expected: System) -> bool:
    """Whether two systems have the same rates, definitions put in."""

    def rates(system: System) -> dict[str, sp.Expr]:
        table: dict[sp.Symbol, sp.Expr] = {}
        for symbol, value in system.scalar_definitions:
            table[symbol] = value.xreplace(table)
        pairs = zip(system.symbols, system.rates, strict=True)
        return {str(s): value.xreplace(table) for s, value in pairs}

    one, other = rates(found), rates(expected)
    return one.keys() == other.keys() and all(sp.simplify(one[s] - other[s]) == 0 for s in one)


# --- what files mean -------------------------------------------------------------------------


def test_a_file_says_what_python_says() -> None:
    experiment = parse_experiment(SUSLOV)
    assert isinstance(experiment, MechanismExperiment)
    gamma, omega, e, weight = map(Vector, ("gamma", "omega", "e", "P"))
    inertia = Diagonal("I")
    found = mechanism_of(experiment)
    expected = Mechanism(
        name="heavy-suslov-body",
        frame=Frame(
            {gamma: cross(gamma, omega)}, (omega,), (norm_squared(gamma) - 1,), rotations(omega)
        ),
        lagrangian=dot(omega, inertia * omega) / 2 - dot(weight, gamma),
        constraints=(dot(e, omega),),
        definitions={e: sp.ImmutableDenseMatrix([sp.Rational(3, 5), 0, sp.Rational(4, 5)])},
        parameters=found.parameters,
    )
    assert found.frame == expected.frame
    assert to_components(found.L - expected.L).expand() == 0
    assert (found.f, found.steps) == (expected.f, expected.steps)
    assert [str(p.symbol) for p in found.parameters] == ["I_1", "I_2", "I_3", "P_1", "P_2", "P_3"]
    assert found.parameters[1].default == 1.6
    assert found.parameters[1].unit == "kg m^2"
    assert same_field(equations_of_motion(found), equations_of_motion(expected))


def test_coordinates_alone_are_a_frame() -> None:
    made = study(PENDULUM)
    assert isinstance(made.subject.model, Mechanism)
    assert [str(v) for v in made.subject.model.frame.velocities] == ["Rdot"]
    assert made.system.title == "Untitled system"
    assert [float(x) for x in made.start] == [0.6, 0.0, -0.8, 0.0, 1.0, 0.0]


def test_the_lagrangian_by_parts_or_whole() -> None:
    whole = changed(
        PENDULUM,
        'kinetic = "dot(Rdot, Rdot)/2"\npotential = "g*R_3"',
        'L = "dot(Rdot, Rdot)/2 - g*R_3"',
    )
    assert same_field(study(whole).system, study(PENDULUM).system)


def test_commutators_by_themselves() -> None:
    words = '[frame.commutators]\n"omega_1, omega_2" = "omega_3"\n"omega_2, omega_3" = "omega_1"\n'
    words += '"omega_3, omega_1" = "omega_2"\n'
    by_hand = changed(SUSLOV, 'structure = "rotations(omega)"\n', words)
    assert same_field(study(by_hand).system, study(SUSLOV).system)


def test_forces_act_along_velocities() -> None:
    damped = study(SLEIGH + '[forces]\nomega = "-c*omega"\n[parameters.c]\nvalue = 0.5\n')
    free = study(SLEIGH)
    omega, c = real_symbol("omega"), real_symbol("c")
    index = damped.system.symbols.index(omega)
    mass = real_symbol("I") + real_symbol("m") * real_symbol("a") ** 2
    difference = damped.system.rates[index] - free.system.rates[index]
    assert sp.simplify(difference + c * omega / mass) == 0
    assert "energy" not in {law.name for law in damped.system.laws}
    assert "energy" in {item.name for item in damped.system.observables}


def test_an_affine_constraint_breaks_the_energy() -> None:
    made = study(TURNTABLE)
    assert {law.name for law in made.system.laws} == {"momentum_omega_3", "centre_x", "centre_y"}
    assert all(prove(made.system, law) for law in made.system.laws)
    claim = '"m*(v_x**2 + v_y**2)/2 + J*dot(omega, omega)/2"'
    made = study(TURNTABLE + f"[laws.integrals.total]\nvalue = {claim}\n")
    law = next(law for law in made.system.laws if law.name == "total")
    assert prove(made.system, law).decision == "refuted"


def test_the_time_starts_at_zero_unless_told() -> None:
    timed = changed(PENDULUM, '"g*R_3"', '"g*R_3*cos(t)"')
    assert float(study(timed).start[-1]) == 0.0
    assert float(study(timed, "start.t=2").start[-1]) == 2.0


def test_laws_of_a_file_are_claims() -> None:
    made = study(VOLTERRA + '[laws.symmetries.turning]\nx = "y"\n')
    verdicts = {law.name: prove(made.system, law).decision for law in made.system.laws}
    assert verdicts == {
        "total": "proven",
        "product": "proven",
        "measure": "proven",
        "turning": "refuted",
    }
    assert [type(law) for law in made.system.laws[:3]] == [Integral, Integral, Measure]
    assert isinstance(made.experiment, EquationsExperiment)


def test_laws_may_hold_on_a_level() -> None:
    level = '[laws.integrals.flat]\nvalue = "x + y"\nlevel = ["z"]\n'
    law = next(law for law in study(VOLTERRA + level).system.laws if law.name == "flat")
    assert law.level == (real_symbol("z"),)


@pytest.mark.parametrize("text", [SLEIGH, SUSLOV, VOLTERRA, TURNTABLE, PENDULUM])
def test_the_complete_file_starts_the_same_motion(text: str) -> None:
    made = study(text)
    again = study(made.complete_toml())
    assert again.start == made.start
    assert again.experiment == parse_experiment(made.complete_toml())
    assert same_field(again.system, made.system)


def test_parameters_by_the_command_line() -> None:
    made = study(SLEIGH, "parameters.m.value=2.5", "parameters.a=0.1")
    assert made.system.parameters[2].meaning.startswith("distance")
    assert made.system.defaults[real_symbol("m")] == 2.5
    assert made.system.defaults[real_symbol("a")] == 0.1


# --- starts ----------------------------------------------------------------------------------


def test_velocities_that_follow_may_be_given_and_are_checked() -> None:
    assert [float(x) for x in study(TURNTABLE, "start.v_x=0.1", "start.v_y=0.6").start][:2] == [
        0.3,
        0.0,
    ]
    assert refused(TURNTABLE, "start.v_x=0.2") == (
        "--set start.v_x: follows from the others and is 0.1, not 0.2; it may be left out"
    )


def test_a_vector_of_which_a_part_follows_may_be_given_whole() -> None:
    plain = changed(SUSLOV, '["dot(e, omega)"]', '["omega_3"]')
    made = study(changed(plain, "omega = [0.4, 0.1, -0.3]", "omega = [0.4, 0.1, 0.0]"))
    assert [float(x) for x in made.start][3:] == [0.4, 0.1]
    assert "omega_3: follows from the others and is 0, not -0.3" in refused(plain)


def test_what_moves_along_starts_at_zero() -> None:
    assert [float(x) for x in study(SLEIGH).start] == [-1.0, 0.05, 0.0, 0.0, 0.4]


# --- mistakes --------------------------------------------------------------------------------

MISTAKES = [
    (SLEIGH, '["v"]', '["v", "2*v"]', "line 21, constraints.velocity: the constraint 2, 2*v = 0, "
     "follows from the constraints before it"),
    (SLEIGH, '["v"]', '["v", "v - 1"]', "line 21, constraints.velocity: the constraint 2, v - 1 = "
     "0, contradicts the constraints before it"),
    (SLEIGH, '["v"]', '["x"]', "constraint 1, x = 0, does not restrict the velocities"),
    (SLEIGH, "(v + a*omega)**2)/2 + I*omega**2/2", "v**2)/2", "line 17, lagrangian: the mass "
     "matrix is singular: the Lagrangian gives no inertia to omega"),
    (SLEIGH, '"u*cos(phi) - v*sin(phi)", y = "u*sin(phi) + v*cos(phi)"', '"u*cos(phi)", y = "u"',
     "line 12, frame: the frame does not span: its 3 fields have rank 2 only"),
    (SLEIGH, '"omega" }', '"omega**2" }', "line 15, frame.rates.phi: the rate of phi, omega**2, "
     "must be linear and homogeneous in the velocities u, v, omega"),
    (SLEIGH, '["v"]', '["v - z"]', "line 21, constraints.velocity: unknown name 'z'; allowed: t, "),
    (SLEIGH, '"m*(u**2', '"mm*(u**2', "line 18, lagrangian.kinetic: unknown name 'mm', did you"),
    (SLEIGH, "kinetic", "kinetik", "lagrangian.kinetik: unknown key, did you mean 'kinetic'?"),
    (SLEIGH, "kinetic = ", "potential = ", "lagrangian: must have either kinetic"),
    (SLEIGH, '["v"]', "[3]", "constraints.velocity: must be formulas in quotes, in brackets, not"),
    (SLEIGH, '["v"]', '"v"', "constraints.velocity: must be formulas in quotes, in brackets, not"),
    (SLEIGH, '{ value = 1.0, unit = "kg"', '{ value = "1", unit = "kg"', "line 8, "
     "parameters.m.value: must be a finite number, or finite numbers in brackets, not the text"),
    (SLEIGH, '{ value = 1.0, unit = "kg"', '{ unit = "kg"', "parameters.m: must have either a "
     "value or a diagonal"),
    (SLEIGH, '"x", "y", "phi"]', '"x", "y", "m"]', "'m' stands for two things; rename one"),
    (SLEIGH, '"x", "y", "phi"]', '"x", "y", "sin"]', "the name 'sin' has a meaning already"),
    (SLEIGH, '"x", "y", "phi"]', '"x", "y", "t"]', "the name 't' has a meaning already"),
    (SLEIGH, '"x", "y", "phi"]', '"x", "y", "phi[5]"]', "'phi[5]' is no name"),
    (SLEIGH, ', phi = "omega" }', " }", "frame.rates: the rate of phi is missing"),
    (SLEIGH, ', phi = "omega" }', ', phi = "omega", z = "u" }', "frame.rates.z: unknown variable"),
    (SLEIGH, 'velocities = ["u", "v", "omega"]\n', "", "rates need velocities to be written in"),
    (SLEIGH, 'straight = "1/omega"', 'straight = "1/w"', "laws.measures.straight: unknown name"),
    (SLEIGH, "[variables]\nx =", "[variables]\nz =", "variables.z: unknown variable; allowed: u, "),
    (SLEIGH, 'velocity = ["v"]', 'velocity = ["v"]\nposition = ["u"]', "constraints.position: 'u' "
     "contains the velocity u; it belongs to constraints.velocity"),
    (SLEIGH, "[start]\n", '[forces]\nw = "1"\n[start]\n', "forces.w: unknown name 'w'; allowed: u"),
    (SLEIGH, "[start]\n", '[observables]\nu = "2*u"\n[start]\n', "observables.u: something else "
     "is recorded as 'u'; choose another"),
    (SLEIGH, "[start]\n", '[laws.integrals]\nenergy = "u"\n[start]\n', "laws.integrals.energy: "
     "another law has the name 'energy'; choose another"),
    (SLEIGH, "[start]\n", '[laws.symmetries.s]\nv = "1"\n[start]\n', "laws.symmetries.s.v: unknown "
     "name 'v'; allowed: u, omega"),
    (SLEIGH, "u = -1.0", "uu = -1.0", "line 40, start.uu: unknown variable, did you mean 'u'?"),
    (SLEIGH, "u = -1.0\n", "", "line 38, start: u missing; the state of chaplygin-sleigh-from-its-"
     "lagrangian is u, omega"),
    (SLEIGH, "[start]\n", "[body]\nmass = 1\n[start]\n", "body: must be absent, as [lagrangian] "),
    (SLEIGH, "[start]\n", '[system]\nname = "euler"\n[start]\n', "system: must be absent, as [lag"),
    (SUSLOV, '"cross(gamma, omega)"', '"dot(gamma, omega)"', "line 14, frame.rates.gamma: must be "
     "a vector of 3, as gamma is"),
    (SUSLOV, '"cross(gamma, omega)"', '"cross(gamma, omega) + omega"', "frame.structure: "
     "the commutator of omega_1 and omega_2"),
    (SUSLOV, '"rotations(omega)"', '"rotation(omega)"', 'frame.structure: must be "rotations('),
    (SUSLOV, '"rotations(omega)"', '"rotations(gamma)"', "frame.structure: unknown name 'gamma'"),
    (SUSLOV, 'structure = "rotations(omega)"', "", "line 11, frame: the frame does not span"),
    (SUSLOV, '["dot(e, omega)"]', '["dot(e, omega"]', "this parenthesis is never closed"),
    (SUSLOV, "omega = [0.4, 0.1, -0.3]", "omega = [0.4, 0.1, 0.3]", "line 34, start: the relation "
     "e₁ ω₁ + e₂ ω₂ + e₃ ω₃ = 0 is missed by 0.48; the nearest admissible state is gamma = [0.0, "),
    (SUSLOV, "diagonal = [1.0, 1.6, 2.2]", "diagonal = [1.0, 1.6]", "must be 3 finite "
     "numbers, not [1.0, 1.6]"),
    (VOLTERRA, 'y = "y*(z - x)", ', "", "line 7, equations.rates: the rate of y is missing"),
    (VOLTERRA, '"y*(z - x)"', '"y*(z - w)"', "line 7, equations.rates.y: unknown name 'w'"),
    (VOLTERRA, 'state = ["x", "y", "z"]', "state = []", "equations.state: must be names in quotes"),
    (VOLTERRA, '"1/(x*y*z)"', '"0"', "laws.measures.measure: the density of a measure must not be"),
    (VOLTERRA, "[laws.measures]", "[lagrangian]\n[laws.measures]", "equations: must be absent"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "old", "new", "said"), MISTAKES)
def test_mistakes_get_one_sentence_with_their_place(
    text: str, old: str, new: str, said: str
) -> None:
    message = refused(changed(text, old, new))
    assert said in message
    assert message.startswith("own.toml, ")
    sentence, *excerpt = message.split("\n")
    assert not excerpt or re.fullmatch(r" *\^", excerpt[-1])
    assert len(sentence) < 400


def test_starts_where_a_formula_has_no_real_value() -> None:
    rooted = changed(VOLTERRA, "[laws.integrals]", "[laws.integrals]\nodd = 'sqrt(x)'")
    rooted = changed(rooted, 'state = ["x", "y", "z"]', 'state = ["x", "y", "z"]\nrelations = '
                     '["sqrt(x - 1) - y"]')  # fmt: skip
    assert "the equations have no real value at this state" in refused(rooted)


WORDS = ["", "x", "omega", "(", "]", '"', "3", "**", "sqrt", "[3]", "= {}", "\n", "v", "1e99", "t"]
PIECES = re.compile(r"[\w.]+|[^\s\w]")


@pytest.mark.slow
@settings(max_examples=120)
@given(
    st.sampled_from([SLEIGH, SUSLOV, VOLTERRA, TURNTABLE, PENDULUM]),
    st.lists(st.tuples(st.integers(0, 500), st.sampled_from(WORDS)), min_size=1, max_size=2),
)
def test_mutilated_files_are_refused_politely(text: str, cuts: list[tuple[int, str]]) -> None:
    for place, word in cuts:
        pieces = list(PIECES.finditer(text))
        piece = pieces[place % len(pieces)]
        text = text[: piece.start()] + word + text[piece.end() :]
    try:
        _ = study(text).start
    except InputError as error:
        assert str(error).startswith("own.toml")


def test_missing_tables_are_named() -> None:
    start = SLEIGH.index("[frame]"), SLEIGH.index("[lagrangian]"), SLEIGH.index("[constraints]")
    assert "frame: missing; it must be a table [frame]" in refused(
        SLEIGH[: start[0]] + SLEIGH[start[1] :]
    )
    assert "lagrangian: missing; it must be a table [lagrangian]" in refused(
        SLEIGH[: start[1]] + SLEIGH[start[2] :]
    )
    assert "start: u, omega missing" in refused(SLEIGH[: SLEIGH.index("[start]")])


TURNING_CONE = """
title = "Point on a turning cone"
[parameters]
a = 2.0
beta = 0.3
[frame]
coordinates = ["s", "phi"]
[lagrangian]
kinetic = "(sdot**2 + s**2*phidot**2)/2"
[constraints]
velocity = ["s*phidot*cos(beta) - a*sin(beta)"]
[start]
s = 1.0
sdot = 0.1
phidot = 0.7
"""


def test_a_wrong_velocity_is_answered_with_another_velocity_alone() -> None:
    message = refused(TURNING_CONE)
    assert (
        "the nearest admissible state is s = 1.0, sdot = 0.1, phidot = 0.61867249921924" in message
    )
    # s = 0 admits no velocity: only then does a place move
    message = refused(changed(TURNING_CONE, "s = 1.0", "s = 0.0"))
    assert "nearest" not in message or "s = 0.0" not in message


def test_a_wrong_place_moves_places_first_and_the_time_not_at_all() -> None:
    moving = """
title = "Bead on a moving circle"
[frame]
coordinates = ["x", "y"]
[lagrangian]
kinetic = "(xdot**2 + ydot**2)/2"
potential = "y"
[constraints]
position = ["(x - sin(t))**2 + y**2 - 1"]
[start]
x = 1.1
y = 0.0
xdot = 1.0
ydot = 0.5
"""
    message = refused(moving)
    nearest = message.partition("the nearest admissible state is ")[2].split("\\n")[0]
    values = dict(part.split(" = ") for part in nearest.split(", "))
    assert {name: float(value) for name, value in values.items()} == pytest.approx(
        {"x": 1.0, "y": 0.0, "xdot": 1.0, "ydot": 0.5, "t": 0.0}, abs=1e-12
    )

"""Laws of every kind in a file: read, and mistakes in them told with line and key."""

from __future__ import annotations

import pytest

from chaplygin import prove
from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from flowlanes.parsing import formula_text
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Measure,
    PoissonStructure,
    Reduction,
    Separation,
    Symmetry,
)

FILE = """title = "Plane oscillator"
source = "a textbook"
conditions = ["k <= 4*m"]

[parameters]
k = { value = 4.0, unit = "N/m", meaning = "stiffness", where = ["k > 0"] }
m = { value = 1.0, where = ["m > 0 and m < 100"] }

[definitions]
w = "k/m"

[equations]
state = ["x", "y", "u", "v"]
rates = { x = "u", y = "v", u = "-w*x", v = "-w*y" }

[laws.integrals.area]
value = "x*v - y*u"
meaning = "areal velocity"
source = "Kepler"

[laws.measures.volume]
density = { "1 + (x*v - y*u)**2" = "1/2" }

[laws.symmetries]
turn = { x = "-y", y = "x", u = "-v", v = "u" }

[laws.brackets.canonical]
brackets = { "x, u" = "1/m", "y, v" = "1/m" }
rank = 4

[laws.hamiltonian.form]
hamiltonian = "m*(u**2 + v**2)/2 + k*(x**2 + y**2)/2"
bracket = "canonical"
misprint = "the mass is lost"
as_printed = { hamiltonian = "(u**2 + v**2)/2 + k*(x**2 + y**2)/2" }

[laws.reductions.radius]
quantities = { s = "x**2 + y**2", p = "x*u + y*v", e = "u**2 + v**2" }
equations = ["Rate(s) - 2*p", "Rate(p) - e + w*s", "Rate(e) + 2*w*p"]

[laws.separations.axes]
quantities = { h = "u**2 + w*x**2", f = "v**2 + w*y**2" }
equations = ["Rate(x)**2 - h + w*x**2", "Rate(y)**2 - f + w*y**2", "Rate(h)", "Rate(f)"]

[laws.identities.newton]
value = ["Rate(Rate(x)) + w*x", "Rate(Rate(y)) + w*y"]

[laws.integrals.soft]
value = "x*v - y*u"
where = ["k < 1"]

[laws.isomorphisms.unit]
map = { x = "x", y = "y", u = "u/sqrt(w)", v = "v/sqrt(w)" }
time = "sqrt(w)"

[laws.isomorphisms.unit.system]
title = "Unit oscillator"

[laws.isomorphisms.unit.system.equations]
state = ["x", "y", "u", "v"]
rates = { x = "u", y = "v", u = "-x", v = "-y" }

[start]
x = 1.0
y = 0.0
u = 0.0
v = 0.5
"""

KINDS = [
    *(Integral, Measure, Symmetry, PoissonStructure, ConformallyHamiltonian),
    *(Reduction, Separation, Identity, Isomorphism),
]


def test_every_kind_of_law_is_read_in_the_order_of_the_file() -> None:
    system = Study.from_experiment(parse_experiment(FILE)).system
    assert [type(law) for law in system.laws] == KINDS
    assert (system.source, system.laws[0].source) == ("a textbook", "Kepler")


def test_they_are_proven_and_what_is_misprinted_is_refuted() -> None:
    system = Study.from_experiment(parse_experiment(FILE)).system
    assert {law.name: prove(system, law).decision for law in system.laws} == dict.fromkeys(
        (law.name for law in system.laws), "proven"
    )
    form = next(law for law in system.laws if law.name == "form")
    assert form.as_printed is not None
    # with m = 1 the printed form is right as well, and the prover takes every m
    assert prove(system, form.as_printed).decision == "refuted"


def test_conditions_decide_which_laws_are_claimed() -> None:
    soft = Study.from_experiment(parse_experiment(FILE, overrides=["parameters.k=0.5"])).system
    assert "soft" in {law.name for law in soft.laws}


def test_a_toml_text_reads_back_to_the_same_laws() -> None:
    experiment = parse_experiment(FILE)
    again = parse_experiment(experiment.toml())
    assert again == experiment
    assert Study.from_experiment(again).system == Study.from_experiment(experiment).system


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            'bracket = "canonical"',
            'bracket = "canonicl"',
            "line 31, laws.hamiltonian.form: no bracket 'canonicl' among the laws; there are "
            "canonical",
        ),
        (
            '"x, u" = "1/m"',
            '"x u" = "1/m"',
            'line 28, laws.brackets.canonical.brackets."x u": a bracket has two variables, as in '
            '"x, p"',
        ),
        (
            '"y, v" = "1/m"',
            '"u, x" = "1/m"',
            'line 28, laws.brackets.canonical.brackets."u, x": each pair of two variables stands '
            "once",
        ),
        (
            'where = ["k > 0"]',
            'where = ["k"]',
            "line 6, parameters.k.where: 'k' is no condition; it must have one of",
        ),
        (
            'conditions = ["k <= 4*m"]',
            'conditions = ["k > 4*m"]',
            "k = 4.0, m = 1.0: k > 4*m must hold",
        ),
        ('u = "-w*x"', 'u = "Rate(v)"', "Rate(...) stands in laws alone; write the rate itself"),
        (
            "as_printed = { hamiltonian",
            "as_printed = { hamiltonan",
            "line 31, laws.hamiltonian.form: as_printed: hamiltonan: unknown key, did you mean "
            "'hamiltonian'?",
        ),
        (
            "rank = 4",
            'rank = 4\non = ["x"]',
            "laws.brackets.canonical.on: unknown key; it is called level",
        ),
        (
            "rank = 4",
            'rank = 4\nlevel = ["q"]',
            "laws.brackets.canonical.level: unknown name 'q'",
        ),
        (
            'map = { x = "x",',
            'map = { z = "x",',
            "line 53, laws.isomorphisms.unit.map.z: unknown name 'z'; allowed: x, y, u, v",
        ),
        (
            'density = { "1 + (x*v - y*u)**2" = "1/2" }',
            'density = { "1 + (x*v - y*u)**2" = "x" }',
            "an exponent must not depend on the state",
        ),
        (
            "[laws.isomorphisms.unit]\n",
            '[laws.isomorphisms.unit]\ntarget = "veselova"\n',
            "must have either target, a name of the catalogue, or a system",
        ),
        ("rank = 4", "rank = 3", "its rank is 3; a skew 4×4 matrix has an even rank from 0 to 4"),
        (
            '[definitions]\nw = "k/m"',
            '[components]\nI = "diagonal"\n[definitions]\nw = "k/m"',
            "components.I: its component I_1 is no parameter, variable or definition",
        ),
    ],
)
def test_mistakes_are_told_with_their_place(old: str, new: str, said: str) -> None:
    assert FILE.count(old) == 1
    with pytest.raises(InputError) as caught:
        Study.from_experiment(parse_experiment(FILE.replace(old, new), "file.toml"))
    assert said in str(caught.value)
    assert str(caught.value).startswith("file.toml")


def test_a_target_may_be_a_system_of_the_catalogue() -> None:
    text = """title = "Bracket again"
[parameters]
d = 1.4142135623730951
[equations]
state = ["p_1", "p_2", "gamma[3]"]
[equations.rates]
p_1 = "-gamma_1*gamma_3"
p_2 = "-d*gamma_2*gamma_3"
gamma = "[p_1*gamma_3, d*p_2*gamma_3, -p_1*gamma_1 - d*p_2*gamma_2]"
[laws.isomorphisms.same]
target = "suslov-bracket"
map = { p_1 = "p_1", p_2 = "p_2", gamma = "gamma" }
"""
    (law,) = Study.from_experiment(parse_experiment(text)).system.laws
    assert isinstance(law, Isomorphism)
    assert law.target.name == "suslov-bracket"
    with pytest.raises(InputError, match="no system 'suslov-braket' in the catalogue"):
        Study.from_experiment(parse_experiment(text.replace("suslov-bracket", "suslov-braket")))


def test_tensors_gradients_and_shorthand() -> None:
    text = """title = "Kirchhoff"
[parameters]
I_1 = 1.0
I_2 = 1.5
I_3 = 2.0
[components]
I = "diagonal"
[definitions]
A = "(I + 2*identity() + outer(gamma, gamma) - outer(gamma, gamma))**-1"
H = { value = "dot(M, A*M)/2 + gamma_3", shorthand = true }
[equations]
state = ["M[3]", "gamma[3]"]
[equations.rates]
M = "cross(M, gradient(H, M)) + cross(gamma, gradient(H, gamma))"
gamma = "cross(gamma, gradient(H, M))"
[laws.integrals]
energy = "H"
[start]
M = [1.0, 0.0, 0.5]
gamma = [0.0, 0.6, 0.8]
"""
    system = Study.from_experiment(parse_experiment(text)).system
    assert [str(name) for name, _ in system.definitions] == ["A"]
    assert formula_text(system.laws[0].value) == "gamma_3 + dot(M, A*M)/2"
    assert prove(system, "energy").decision == "proven"

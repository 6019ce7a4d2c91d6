"""Python files that define a mechanism, a system or a study."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp

from chaplygin.experiment.models.described_models import EquationsExperiment
from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.python_file import load_python
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from flowlanes.system.laws import Integral, Measure, PoissonStructure, Symmetry
from flowlanes.system.system import Guard, Observable, Parameter, System
from flowlanes.system.vectors import Vector, cross, norm_squared, real_symbol
from lawproof.proof.prover import prove
from nonholonomic.catalogue import from_catalogue
from nonholonomic.system_files.write import tables_of

CART = """\
import sympy as sp

from nonholonomic.mechanics.lagrangian.mechanism import Frame, Mechanism
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol

x, y, phi, u, v, omega, m, J = map(real_symbol, "x y phi u v omega m J".split())
along, across = u * sp.cos(phi) - v * sp.sin(phi), u * sp.sin(phi) + v * sp.cos(phi)
frame = Frame({x: along, y: across, phi: omega}, (u, v, omega))
mechanism = Mechanism(
    name="cart",
    title="Cart",
    frame=frame,
    lagrangian=m * (u**2 + v**2) / 2 + J * omega**2 / 2,
    constraints=(v,),
    parameters=(Parameter(m, "mass", 1.0, "kg"), Parameter(J, "moment of inertia", 0.5)),
)
start = {u: sp.Rational(3, 2), omega: 0.3}
run = {"until": 4.0, "samples": 5}
"""


@pytest.fixture
def cart(tmp_path: Path) -> Path:
    path = tmp_path / "cart.py"
    path.write_text(CART, encoding="utf-8")
    return path


def refused(path: Path, *overrides: str) -> str:
    with pytest.raises(InputError) as caught:
        _ = load_python(path, overrides).start
    return str(caught.value)


def test_a_mechanism_with_its_start(cart: Path) -> None:
    made = load_python(cart)
    assert made.subject.model is not None
    assert made.system.title == "Cart"
    assert [float(x) for x in made.start] == [1.5, 0.3, 0.0, 0.0, 0.0]
    assert made.times.tolist() == [0.0, 1.0, 2.0, 3.0, 4.0]


def test_the_complete_file_needs_no_python(cart: Path) -> None:
    made = load_python(cart, ["start.phi=0.5", "parameters.m=2"])
    again = Study.from_experiment(parse_experiment(made.complete_toml()))
    assert again.start == tuple(made.start)
    assert again.system.lifted().rates == made.system.lifted().rates
    assert again.system.defaults == made.system.defaults
    assert all(prove(again.system, law) for law in again.system.laws)


def test_keys_that_may_be_overridden(cart: Path) -> None:
    made = load_python(cart, ["run.until=2", "title=Wagon", "start.omega=1", "parameters.J=3"])
    assert (made.until, made.system.title) == (2.0, "Wagon")
    assert float(made.start[1]) == 1.0
    assert made.system.defaults[real_symbol("J")] == 3.0


@pytest.mark.parametrize(
    ("override", "said"),
    [
        ("frame=2", "--set frame: a Python file decides this itself; allowed: parameters, run, "),
        ("parameters.k=2", "--set parameters.k: unknown parameter; allowed: m, J"),
        ("parameters.m=[3, 2, 1]", "--set parameters.m: must be a finite number, not [3.0, 2.0"),
        ("parameters=3", "--set parameters: must be a table, not 3"),
        ("run.until=x", '--set run.until: must be a positive finite time, not the text "x"'),
        ("start.w=1", "--set start.w: unknown variable; allowed: u, omega, x, y, phi"),
        ("start.v=1", "--set start.v: follows from the others and is 0, not 1"),
    ],
)
def test_wrong_overrides(cart: Path, override: str, said: str) -> None:
    assert refused(cart, override).startswith(said)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("constraints=(v,)", "constraints=(v, 2 * v)", ": cart: the constraint 2, 2*v = 0, foll"),
        ("phi: omega}", "phi: omega**2}", ", line 9: frame: the rate of phi, omega**2, must be"),
        ("start = {u:", "start = {1 / 0:", ", line 18: ZeroDivisionError: division by zero"),
        ("run = {", "run = [", ", line 19: not valid Python: "),
        ("start = {u: sp.Rational(3, 2), omega: 0.3}", "start = 3", ": start must be a mapping"),
        ("frame = Frame(", "raise SystemExit\nframe = Frame(", ", line 9: the file ends the"),
        ("mechanism = Mechanism(", "made = Mechanism(", ": it must define mechanism, system or st"),
        ("mechanism = ", "mechanism = system = 3 or ", ": mechanism must be a Mechanism, not int"),
        ("x, y, phi", "import nowhere_at_all\nx, y, phi", ", line 7: ModuleNotFoundError: No mod"),
    ],
)
def test_mistakes_get_one_sentence_with_their_place(
    cart: Path, old: str, new: str, said: str
) -> None:
    assert old in CART
    cart.write_text(CART.replace(old, new), encoding="utf-8")
    assert refused(cart).startswith(f"{cart}{said}")


def test_missing_files(tmp_path: Path) -> None:
    assert refused(tmp_path / "none.py").endswith("none.py: there is no such file")


def test_a_system_and_neighbours(tmp_path: Path) -> None:
    (tmp_path / "neighbour_of_mine.py").write_text("RATE = 3\n")
    path = tmp_path / "decay.py"
    path.write_text(
        "from neighbour_of_mine import RATE\nfrom flowlanes.system.system import System\n"
        "from flowlanes.system.vectors import real_symbol\nx = real_symbol('x')\n"
        "system = System('decay', 'Decay', {x: -RATE * x})\nstart = {'x': 1}\n"
        "if __name__ == '__main__':\n    raise SystemExit\n"
    )
    made = load_python(path)
    assert made.system.rates == (-3 * real_symbol("x"),)
    assert made.until == 10.0


def test_a_study_is_taken_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "mine.py"
    path.write_text(
        "from chaplygin.experiment.models.experiment import catalogue_experiment\n"
        "from chaplygin.experiment.study import Study\n"
        "study = Study.from_experiment(catalogue_experiment('chaplygin-ball'))\n"
    )
    assert load_python(path).system.name == "chaplygin-ball"
    assert "a study made in Python cannot be changed by --set" in refused(path, "run.until=2")


# --- equations as text -----------------------------------------------------------------------


def spinning() -> System:
    """A system with everything that a file can say, and something that it cannot."""
    M, omega = Vector("M"), Vector("omega")
    k, angle = real_symbol("k"), real_symbol("theta")
    return System(
        name="spinning",
        title="Spinning",
        field={M: cross(M, omega), angle: sp.sqrt(1 + real_symbol("M_1") ** 2) * 0.1},
        definitions={omega: k * M + cross(M, M)},
        parameters=(Parameter(k, "inverse moment", 2.0),),
        relations=(norm_squared(M) - 1,),
        laws=(
            Integral("length", norm_squared(M), "length", level=(k - 1,)),
            Measure("volume", {norm_squared(M): sp.Rational(-1, 2)}),
            Symmetry("turn", {angle: sp.S.One}),
            PoissonStructure("none", sp.zeros(4)),
        ),
        observables=(Observable("spin", omega, "angular velocity"),),
        guards=(Guard("early", 4 - angle, "the angle is too large"),),
    )


def test_systems_as_tables_read_back() -> None:
    experiment = EquationsExperiment.model_validate(tables_of(spinning()))
    again = Study.from_experiment(parse_experiment(experiment.toml())).system
    assert again.symbols == spinning().symbols
    assert again.rates == (*spinning().rates[:3], sp.sqrt(1 + real_symbol("M_1") ** 2) / 10)
    assert [type(law) for law in again.laws] == [Integral, Measure, Symmetry, PoissonStructure]
    assert again.integrals[0].level == (real_symbol("k") - 1,)
    assert [guard.message for guard in again.guards] == ["the angle is too large"]
    assert [item.name for item in again.observables] == ["spin"]


def test_what_no_file_can_say_is_refused() -> None:
    x = real_symbol("x")
    with pytest.raises(InputError, match="the function erf has no form in a file"):
        tables_of(System("odd", "Odd", {x: sp.erf(x)}))


def test_absolute_values_read_back() -> None:
    x, y = real_symbol("x"), real_symbol("y")
    rates = {x: sp.Abs(x) * sp.sign(y), y: sp.Max(x, y) - sp.Min(x, 2)}
    tables = tables_of(System("odd", "Odd", rates))
    again = Study.from_experiment(
        parse_experiment(EquationsExperiment.model_validate(tables).toml())
    ).system
    assert again.rates == tuple(rates.values())


def test_rolling_bodies_can_be_written_too() -> None:
    ball = from_catalogue("chaplygin-ball")
    tables = tables_of(ball)
    assert tables["equations"]["state"][:2] == ["M[3]", "gamma[3]"]
    again = Study.from_experiment(
        parse_experiment(EquationsExperiment.model_validate(tables).toml())
    ).system
    assert (again.field, again.definitions) == (ball.field, ball.definitions)
    assert again.lifted().rates == ball.lifted().rates
    assert again.conventions == ball.conventions

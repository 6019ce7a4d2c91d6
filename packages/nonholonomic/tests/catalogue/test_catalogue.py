"""What the catalogue says of itself, and how it answers mistakes."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
import sympy as sp

from catalogue import built
from flowlanes.errors import InputError
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE, entry, from_catalogue
from nonholonomic.mechanics.rolling.equations import RollingBody


def whole(system: System) -> System:
    """The system with its motion in space, if it has one."""
    return system.lifted() if system.reconstruction else system


def silences(name: str) -> list[str]:
    """What an entry does not say of itself."""
    item, system = CATALOGUE[name], built.system(name)
    said = {
        "name": item.name == name == system.name,
        "title": item.title and system.title == item.title,
        "summary": item.summary.endswith(".") and system.summary == item.summary,
        "source": "§" in item.source and system.source == item.source,
    }
    said |= {f"parameter {p.symbol}": p.meaning and p.unit for p in system.parameters}
    said |= {f"law {law.name}": law.meaning and law.source for law in system.laws}
    said |= {f"observable {o.name}": o.meaning for o in whole(system).observables}
    return [what for what, is_said in said.items() if not is_said]


def test_entries_describe_themselves() -> None:
    assert {name: wrong for name in CATALOGUE if (wrong := silences(name))} == {}


def repeated_names(name: str) -> list[str]:
    """Names that two things of an entry have."""
    system = whole(built.system(name))
    # guards of one name are the parts of one condition
    groups = (
        [law.name for law in system.laws],
        [observable.name for observable in system.observables],
        [guard for guard, _ in {(g.name, g.message) for g in system.guards}],
        [message for _, message in {(g.name, g.message) for g in system.guards}],
        [str(symbol) for symbol in system.symbols],
    )
    return [one for group in groups for one, times in Counter(group).items() if times > 1]


def test_names_are_unique() -> None:
    assert {name: twice for name in CATALOGUE if (twice := repeated_names(name))} == {}


def wrong_defaults(name: str) -> list[str]:
    """Conditions that the defaults violate, and defaults that the system has otherwise."""
    item, system = CATALOGUE[name], built.system(name)
    conditions = [c for parameter in system.parameters for c in parameter.admissible]
    violated = [str(c) for c in conditions if c.subs(system.defaults) != sp.true]
    numbers = {str(symbol): value for symbol, value in system.defaults.items()}
    return violated + [symbol for symbol, v in item.defaults.items() if numbers[symbol] != v]


def test_defaults_are_admissible() -> None:
    assert {name: wrong for name in CATALOGUE if (wrong := wrong_defaults(name))} == {}


def test_bodies_on_a_surface_are_listed() -> None:
    found = {name for name in CATALOGUE if isinstance(built.made(name), RollingBody)}
    assert found == set(built.ROLLING), "mend ROLLING in catalogue/built.py"


@pytest.mark.slow
@pytest.mark.parametrize("name", CATALOGUE)
def test_the_example_runs_to_its_end(name):
    item = CATALOGUE[name]
    made = built.example(name)
    motion = integrate(made.system_on_level, made.start, np.linspace(0.0, item.start.until, 11))
    assert motion.times[-1] == item.start.until
    assert motion.events == ()
    size = len(made.system.symbols)
    assert np.ptp(motion.states[:, :size], axis=0).max() > 0.1


@pytest.mark.slow
@pytest.mark.parametrize("name", CATALOGUE)
def test_only_a_rolling_body_has_a_rolling(name):
    item = CATALOGUE[name]
    made = item.build(item.numbers())
    assert item.rolling() is None or isinstance(made, RollingBody)
    assert isinstance(made, System) == (item.rolling() is None)


def test_parameters_replace_defaults():
    system = from_catalogue("chaplygin-ball", I_1=1.2, m=3.0)
    values = {str(symbol): value for symbol, value in system.defaults.items()}
    assert values == {"m": 3.0, "I_1": 1.2, "I_2": 1.5, "I_3": 2.1, "R": 1.0}


def test_the_nearest_name_is_offered():
    with pytest.raises(InputError, match=r"'chaplygin-bal'.*did you mean 'chaplygin-ball'\?"):
        entry("chaplygin-bal")
    with pytest.raises(InputError, match=r"no system 'xyz' in the catalogue; `chaplygin list`"):
        from_catalogue("xyz")


def test_the_nearest_parameter_is_offered():
    with pytest.raises(InputError) as caught:
        from_catalogue("ball-on-sphere", I1=1.0)
    assert str(caught.value) == (
        "ball-on-sphere: no parameter I1 (did you mean I_1?); it has m, I_1, I_2, I_3, R, a"
    )
    with pytest.raises(InputError, match="veselova: no parameter friction; it has"):
        from_catalogue("veselova", friction=0.1)


@pytest.mark.parametrize(
    ("name", "parameters", "message"),
    [
        ("chaplygin-ball", {"m": 0.0}, "body.mass: must be a positive finite number, not m = 0.0"),
        ("chaplygin-ball", {"I_3": 9.0}, "triangle inequality"),
        ("veselova", {"I_3": 9.0}, "I_3 <= I_1 + I_2 must hold"),
        ("veselova", {"I_1": -1.0}, "I_1 > 0 must hold"),
        (
            "unbalanced-ball",
            {"R": -1.0},
            "a positive finite number, not R = -1.0",
        ),
        (
            "unbalanced-ball",
            {"c_1": float("inf")},
            "c_1: must be a finite number, not inf",
        ),
        (
            "rattleback",
            {"b_2": 0.0},
            "must be 3 positive semi-axes, not b_2 = 0.0",
        ),
        (
            "heavy-disk",
            {"g": -9.81},
            "must be a finite number not below zero, not g = -9.81",
        ),
        ("ball-on-sphere", {"a": 0.0}, "radius 0.0 of the supporting sphere"),
    ],
)
def test_inadmissible_parameters_are_refused(name, parameters, message):
    with pytest.raises(InputError) as caught:
        from_catalogue(name, **parameters)
    assert message in str(caught.value)


@pytest.mark.parametrize("name", ["unbalanced-ball", "heavy-disk", "veselova"])
def test_no_motion_of_a_body_that_cannot_be(name):
    system, start = built.system(name), built.example(name).start
    state, sizes = start[: len(system.symbols)], system.default_values
    for i in (1, 2, 3):
        others = sum(dict(sizes)[f"I_{j}"] for j in (1, 2, 3) if j != i)
        for value, sentence in (
            (0.0, f"I_{i} > 0"),
            (-others, f"I_{i} > 0"),
            (1.01 * others, " <= "),
        ):
            with pytest.raises(
                InputError, match=f"I_{i} = .* is not admissible; .*{sentence}.* must"
            ):
                integrate(system, state, [0.0, 1.0], parameters={f"I_{i}": value})
            with pytest.raises(
                InputError, match=f"I_{i} = .* is not admissible; .*{sentence}.* must"
            ):
                batch_integrator(system).propagate([state], [1.0], {f"I_{i}": value})


def test_a_case_is_decided_by_the_numbers_alone():
    """k = −1 needs R = 2a, for a hollow ball; a different ratio has neither law."""
    assert "linear" in {law.name for law in from_catalogue("ball-around-sphere").laws}
    other = from_catalogue("ball-around-sphere", R=2.5)
    assert {law.name for law in other.integrals} == {"energy", "momentum"}
    other = from_catalogue("rubber-ball-around-sphere", a=1.25)
    assert {law.name for law in other.integrals} == {"energy"}

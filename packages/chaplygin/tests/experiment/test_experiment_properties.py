"""Round trips of experiments through TOML, and files that nobody would write."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from chaplygin.experiment.models.catalogue_models import SystemExperiment
from chaplygin.experiment.models.experiment import Experiment, parse_experiment
from chaplygin.experiment.models.rolling_model import RollingExperiment
from flowlanes.errors import InputError

BALL = """
[body]
mass = 1.0
inertia = [1.0, 1.5, 2.1]     # principal
[body.shape]
kind = "ball"
radius = 1.0
[surface]
kind = "sphere"
radius = 3.0
[field]
potential = "gamma_3**2"
[start]
gamma = [0.2, -0.3, 0.93]
omega = [0.7, 0.4, 1.1]
[run]
samples = 101
"""

SYSTEM = """
[system]
name = "chaplygin-ball"
[system.parameters]
m = 2
"""

printed = st.characters(codec="utf-8", exclude_categories=("Cc", "Cs"))
finite = st.floats(allow_nan=False, allow_infinity=False)
positive = st.floats(min_value=0, exclude_min=True, allow_infinity=False)
finite_small = st.floats(-1, 1)
modest = st.floats(min_value=1e-3, max_value=1e3)
vectors = st.tuples(finite, finite, finite)
directions = vectors.filter(any)
moments = st.tuples(modest, modest, modest).map(lambda p: (p[1] + p[2], p[0] + p[2], p[0] + p[1]))
names = st.sampled_from(["a", "b", "epsilon", "R_1"])


@st.composite
def matrices(draw: st.DrawFn) -> list[list[float]]:
    q, _ = np.linalg.qr(
        np.array(draw(st.lists(finite_small, min_size=9, max_size=9))).reshape(3, 3)
    )
    tensor = q @ np.diag(draw(moments)) @ q.T
    return [[float(x) for x in row] for row in (tensor + tensor.T) / 2]


centred = {"centre": vectors}
shapes = st.one_of(
    st.fixed_dictionaries({"kind": st.just("ball"), "radius": positive}, optional=centred),
    st.fixed_dictionaries(
        {"kind": st.just("ellipsoid"), "axes": st.tuples(positive, positive, positive)},
        optional={"turn": finite, **centred},
    ),
    st.fixed_dictionaries({"kind": st.just("disk"), "radius": positive}, optional=centred),
    st.fixed_dictionaries(
        {"kind": st.just("torus"), "radius": positive, "tube": positive}, optional=centred
    ),
    st.fixed_dictionaries(
        {"kind": st.just("revolution"), "support": st.just("1 +\n\tgamma_3/3")},
        optional={"parameters": st.dictionaries(names, finite), **centred},
    ),
    st.fixed_dictionaries(
        {"kind": st.just("implicit"), "surface": st.just("x**2 + y**2 + z**2 - a**2")},
        optional=centred,
    ).map(lambda table: {**table, "parameters": {"a": 2.0}}),
)
starts = {"heading": finite}
runs = st.fixed_dictionaries(
    {},
    optional={
        "until": positive,
        "samples": st.integers(2, 10_000_000),
        "tolerance": st.floats(1e-16, 1e-3),
        "precision": st.sampled_from(["double", "quad"]),
        "direction": st.sampled_from(["forward", "backward"]),
        "on_liftoff": st.sampled_from(["stop", "warn"]),
        "keep_integrals": st.booleans(),
        "time_limit": positive,
    },
)
rolling_tables = st.fixed_dictionaries(
    {
        "body": st.fixed_dictionaries(
            {"mass": positive, "inertia": st.one_of(moments, matrices()), "shape": shapes},
            optional={"gyrostat": vectors},
        ),
        "start": st.fixed_dictionaries({"gamma": directions, "omega": vectors}, optional=starts),
    },
    optional={
        "surface": st.one_of(
            st.just({"kind": "plane"}),
            st.fixed_dictionaries({"kind": st.just("sphere"), "radius": positive}),
        ),
        "contact": st.fixed_dictionaries({"model": st.sampled_from(["marble", "rubber"])}),
        "field": st.fixed_dictionaries(
            {}, optional={"gravity": positive, "potential": st.just("I_1*gamma_1**2/2 + m")}
        ),
        "run": runs,
    },
)
system_tables = st.fixed_dictionaries(
    {
        "system": st.fixed_dictionaries(
            {
                "name": st.text(
                    alphabet=st.characters(codec="utf-8", exclude_categories=("Cc", "Cs")),
                    min_size=1,
                )
            },
            optional={"parameters": st.dictionaries(names, finite)},
        )
    },
    optional={
        "start": st.fixed_dictionaries({}, optional={"gamma": directions, "omega": vectors}),
        "run": runs,
    },
)


@pytest.mark.slow
@given(st.one_of(rolling_tables, system_tables))
def test_round_trip(tables: dict[str, Any]) -> None:
    model = SystemExperiment if "system" in tables else RollingExperiment
    experiment: Experiment = model.model_validate(tables)
    again = parse_experiment(experiment.toml())
    assert again == experiment
    assert again.toml() == experiment.toml()


def only_input_errors(text: str, *overrides: str) -> None:
    try:
        experiment = parse_experiment(text, "body.toml", overrides)
    except InputError as error:
        for line in str(error).split("\n"):
            assert line.startswith(("body.toml", "--set ", "    "))
    else:
        assert parse_experiment(experiment.toml()) == experiment


@given(st.text())
def test_any_text_is_refused_politely(text: str) -> None:
    only_input_errors(text)


@settings(max_examples=300)
@given(
    st.sampled_from([BALL, SYSTEM]),
    st.lists(
        st.tuples(
            st.integers(0, 400),
            st.integers(0, 12),
            st.one_of(st.sampled_from(["=", "[", "]", '"', "\n", "-", "nan", "1e999"]), st.text()),
        ),
        min_size=1,
        max_size=4,
    ),
)
def test_mutilated_files_are_refused_politely(text: str, cuts: list[tuple[int, int, str]]) -> None:
    for start, length, filling in cuts:
        text = text[:start] + filling + text[start + length :]
    only_input_errors(text)


values = st.recursive(
    st.one_of(
        st.integers().map(str),
        st.floats().map(repr),
        st.sampled_from(["true", '""', "'x'", "1979-05-27", "12:00:00", "1e400", "9" * 400]),
    ),
    lambda inner: st.one_of(
        st.lists(inner, max_size=4).map(lambda items: f"[{', '.join(items)}]"),
        st.dictionaries(names, inner, max_size=2).map(
            lambda table: "{" + ", ".join(f"{k} = {v}" for k, v in table.items()) + "}"
        ),
    ),
    max_leaves=9,
)
keys = {
    "body": "mass inertia gyrostat shape shape.kind shape.radius shape.axes shape.hollow",
    "body.shape": "centre parameters parameters.a tube support chi_1 surface turn",
    "surface": "kind radius",
    "contact": "model",
    "field": "gravity potential parameters parameters.a",
    "system": "name parameters parameters.a",
    "start": "gamma omega heading normal",
    "run": "until samples precision method tolerance direction on_liftoff keep_integrals "
    "time_limit",
}
places = st.sampled_from(
    [*keys, *(f"{table}.{key}" for table in keys for key in keys[table].split()), "_source"]
)
words = st.sampled_from(["ellipsoid", "disk", "torus", "revolution", "implicit", "sphere", "quad"])
options = st.tuples(places, st.one_of(values, words)).map("=".join)


@pytest.mark.slow
@settings(max_examples=300)
@given(st.sampled_from([BALL, SYSTEM]), st.lists(options, min_size=1, max_size=3))
def test_any_value_is_taken_or_refused_politely(text: str, overrides: list[str]) -> None:
    only_input_errors(text, *overrides)

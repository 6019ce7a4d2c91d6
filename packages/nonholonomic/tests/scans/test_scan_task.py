"""Charts as computations, and the words by which numbers are asked for."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.ensembles.computation import compute
from flowlanes.scans.grid import axis, scan_grid
from flowlanes.scans.observables import maximum
from flowlanes.scans.quantity_names import observables, quantity_from_text
from flowlanes.scans.scan_task import Scan, scan
from flowlanes.system.system import Guard, Observable, Parameter, System
from nonholonomic.catalogue import entry

x, y, c = sp.symbols("x y c", real=True)

PENDULUM = System(
    name="pendulum",
    title="Pendulum",
    field={x: y, y: -c * sp.sin(x)},
    parameters=(Parameter(c, "g over l", 1.0, "1/s^2", (c > 0,)),),
    guards=(Guard("over", 2.5 - x, "it has gone over"),),
    observables=(Observable("height", -sp.cos(x), "height", "m"),),
)
PLANE = scan_grid(PENDULUM, axis("c=-0.5:2:6"), axis("y=0:2.5:5"), {"x": 0.0, "y": 0.0})
TASK = scan(Scan(PLANE, maximum(PENDULUM, 20.0, x), "highest", "highest angle", "rad"))


def test_numbers_and_reasons() -> None:
    found = compute(TASK)
    assert found["highest"].dims == ("y", "c")
    assert np.array_equal(found["c"].values, np.linspace(-0.5, 2.0, 6))
    assert found["highest"].attrs["units"] == "rad"
    outcome = found["outcome"]
    meanings = dict(
        zip(outcome.attrs["flag_values"], outcome.attrs["flag_meanings"].split(), strict=True)
    )
    for i, speed in enumerate(found["y"].values):
        for j, factor in enumerate(found["c"].values):
            word = meanings[int(outcome[i, j])]
            value = float(found["highest"][i, j])
            cosine = 1 - speed**2 / (2 * factor) if factor > 0 else np.nan
            if factor <= 0:
                assert word == "the_parameters_are_not_admissible"
            elif cosine < np.cos(2.5):
                assert word == "it_has_gone_over"
                assert 0 < found["ended"][i, j] < 20
            else:
                assert word == "followed_to_the_end"
                assert abs(value - np.arccos(cosine)) < 1e-3
            assert np.isnan(value) == (word != "followed_to_the_end")


def test_the_same_bits_from_a_store_and_in_other_blocks(tmp_path) -> None:
    whole = compute(TASK)
    stored = compute(TASK, tmp_path / "chart.zarr")
    assert stored.equals(whole)
    assert stored["c"].attrs == whole["c"].attrs
    first, second = TASK.work(0, 2), TASK.work(2, 5)
    for name in whole:
        joined = np.concatenate([first[name], second[name]])
        assert np.array_equal(joined, whole[name].values, equal_nan=True)


def test_resumed_where_it_was(tmp_path, monkeypatch) -> None:
    from dataclasses import replace

    task = replace(TASK, block=1)
    rows: list[int] = []

    class StopError(Exception):
        pass

    def progress(done: float) -> None:
        rows.append(round(done * task.size))
        if rows[-1] == 2:
            raise StopError

    with pytest.raises(StopError):
        compute(task, tmp_path / "chart.zarr", progress=progress)
    begun = list(rows)
    rows.clear()
    found = compute(task, tmp_path / "chart.zarr", progress=rows.append)
    assert begun == [0, 1, 2]
    assert len(rows) <= 5
    assert found.equals(compute(TASK))


@pytest.mark.parametrize("word", sorted(observables()))
def test_every_kind_of_number_is_finite(word: str) -> None:
    free = System(
        name="free",
        title="Free",
        field=PENDULUM.field,
        parameters=PENDULUM.parameters,
        observables=PENDULUM.observables,
    )
    made = scan_grid(free, axis("c=0.5:2:3"), axis("y=0.1:1.5:2"), {"x": 0.5, "y": 0.0})
    of = "x" if word == "frequency" else "height"
    number = quantity_from_text(
        free, f"{word}:{of}" if observables()[word].of_formula else word, 30.0
    )
    found = compute(scan(Scan(made, number.rule, number.name, number.title, number.unit)))
    assert np.isfinite(found[number.name].values).all()
    assert not found["outcome"].values.any()


def test_numbers_of_formulas() -> None:
    assert quantity_from_text(PENDULUM, "mean:height", 1.0).unit == "m"
    assert quantity_from_text(PENDULUM, "mean:x", 1.0).unit == "unknown"
    assert (
        quantity_from_text(PENDULUM, "mean:x", 1.0, variables={"x": ("angle", "rad")}).unit == "rad"
    )
    assert quantity_from_text(PENDULUM, "highest: x + y", 1.0).title == "highest value of x + y"
    assert quantity_from_text(PENDULUM, "frequency:x", 1.0).unit == "1/s"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("liapunov", "no number has this name, did you mean 'lyapunov'"),
        ("mean", "written mean:FORMULA"),
        ("lyapunov:x", "written lyapunov"),
        ("mean:q", "unknown name 'q'"),
        ("rotation:x", "a section is needed"),
    ],
)
def test_numbers_that_are_none(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        quantity_from_text(PENDULUM, text, 1.0)


@pytest.mark.parametrize(
    ("quantity", "wrong"),
    [
        ("gamma_1", "it stays within bounds and makes no turns"),
        ("m*gamma_1*gamma_2 - 2", "it stays within bounds"),
        ("energy", "it is measured in J"),
    ],
)
def test_what_is_no_angle_has_no_frequency(quantity: str, wrong: str) -> None:
    ball = entry("chaplygin-ball").system()
    with pytest.raises(InputError, match=wrong):
        quantity_from_text(ball, f"frequency:{quantity}", 1.0)
    assert quantity_from_text(ball, "frequency:atan2(gamma_2, gamma_1)", 1.0).unit == "1/s"


def test_an_axis_like_a_result_is_refused() -> None:
    with pytest.raises(InputError, match="must not have the name of a result"):
        made = scan_grid(
            PENDULUM,
            axis("ended=0.5:2:3"),
            axis("y=0:1:2"),
            {"x": 0, "y": 0},
            formulas={"c": "ended"},
        )
        scan(Scan(made, maximum(PENDULUM, 2.0, x), "highest", "highest angle"))

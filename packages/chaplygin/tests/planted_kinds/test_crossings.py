"""A planted observable is a number of scans and charts like any other."""

import pickle

import numpy as np
import pytest
import sympy as sp

from cli.test_cli import ask
from flowlanes.errors import InputError
from flowlanes.flow.ensembles.computation import compute
from flowlanes.formulas.digest import digest
from flowlanes.scans import quantity_names
from flowlanes.scans.grid import axis, scan_grid
from flowlanes.scans.quantity_names import quantity_from_text
from flowlanes.scans.scan_task import Scan, scan
from flowlanes.system.system import Parameter, System
from planted_kinds.crossings import crossings

__all__ = ["ask"]

x, v, w = sp.symbols("x v w", real=True)
OSCILLATOR = System(
    "oscillator",
    "Oscillator",
    {x: w * v, v: -w * x},
    (Parameter(w, "frequency", 1.0),),
)


@pytest.fixture(autouse=True)
def _planted(monkeypatch):
    monkeypatch.setattr(quantity_names, "_OBSERVABLES", dict(quantity_names.observables()))
    quantity_names.register(crossings)


def test_the_number_of_many_motions():
    starts = np.array([[1.0, 0.0], [2.0, 0.0]])
    found = crossings(OSCILLATOR, 10.0, x)(starts, {w: np.array([1.0, 2.0])})
    # cos(w t) vanishes at (n + 1/2) π/w
    assert found["value"].tolist() == [3.0, 6.0]
    assert found["ended"].tolist() == [10.0, 10.0]


def test_a_scan_by_its_name():
    number = quantity_from_text(OSCILLATOR, "crossings:x", 10.0)
    assert (number.name, number.title) == ("crossings", "changes of sign of x")
    plane = scan_grid(OSCILLATOR, axis("w=1:2:2"), axis("x=1:2:2"), {"x": 1.0, "v": 0.0})
    found = compute(scan(Scan(plane, number.rule, number.name, number.title, number.unit)))
    assert found["crossings"].values.tolist() == [[3.0, 6.0], [3.0, 6.0]]
    assert found["crossings"].attrs["long_name"] == "changes of sign of x"


def test_a_task_of_it_can_be_sent_and_resumed():
    rule = crossings(OSCILLATOR, 10.0, x)
    assert digest(pickle.loads(pickle.dumps(rule))) == digest(rule)
    assert digest(rule) != digest(crossings(OSCILLATOR, 10.0, v))


def test_a_formula_is_needed():
    with pytest.raises(InputError, match="crossings: a formula is needed"):
        crossings(OSCILLATOR, 10.0)
    with pytest.raises(InputError, match="crossings: this number is written crossings:FORMULA"):
        quantity_from_text(OSCILLATOR, "crossings", 10.0)


def test_the_command_line_draws_its_chart(ask, tmp_path):
    code, out, err = ask(
        "chart", "heavy-disk", "--x", "omega_1=0.5:1:2", "--y", "omega_2=0.5:1:2",
        "--of", "crossings:omega_1", "--until", "1", "--output", str(tmp_path / "chart.zarr"),
    )  # fmt: skip
    assert code == 0, err
    assert "changes of sign of omega_1" in out

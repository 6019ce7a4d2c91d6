"""The code for graphics processors, carried out instruction by instruction: the same bits."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp

import flowlanes.flow.devices.graphics as module
from catalogue import built
from flow.devices.ptx_machine import PtxMachine
from flow.small import FENCED, LOGARITHM, OSCILLATOR, RUNAWAY, body, starts, x, y
from flowlanes.errors import InputError
from flowlanes.flow.batch import BatchIntegrator, batch_integrator
from flowlanes.flow.devices.graphics import graphics_loop, refuse_graphics
from flowlanes.flow.kernel.equations import Section, equations_of, poincare_section
from flowlanes.flow.kernel.outcomes import NOT_A_NUMBER
from flowlanes.flow.kernel.tableaux import explicit
from flowlanes.flow.machine_code.ir_writer import literal
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE, from_catalogue


def on_both(
    system: System,
    *,
    deviations: int = 0,
    section: Section | None = None,
    backward: bool = False,
    precision: Any = "double",
    tolerance: float = 1e-13,
    machine: PtxMachine | None = None,
) -> tuple[BatchIntegrator, BatchIntegrator]:
    """The flow on the processor, and on a graphics processor that is imitated."""
    here = batch_integrator(
        system,
        tolerance=tolerance,
        deviations=deviations,
        section=section,
        backward=backward,
        precision=precision,
    )
    equations = equations_of(system, deviations, section, backward)
    loop = graphics_loop(equations, precision, 1e-13, lambda: machine or PtxMachine())
    return here, replace(here, loop=loop)


def assert_same(found: Any, right: Any) -> None:
    """All results equal, to the bit."""
    for name, value in vars(right).items():
        if value is not None:
            np.testing.assert_array_equal(getattr(found, name), value, name)


def test_motions() -> None:
    here, there = on_both(body("chaplygin-ball"))
    states, times = starts("chaplygin-ball", 5), [0.0, 0.1, 0.3]
    assert_same(there.propagate(states, times), here.propagate(states, times))


@pytest.mark.slow
@pytest.mark.parametrize("name", CATALOGUE)
def test_every_system(name: str) -> None:
    system = replace(from_catalogue(name), reconstruction=None)
    start = built.example(name).reduced_start
    here, there = on_both(system)
    states = np.array([[float(value) for value in start]])
    assert_same(there.propagate(states, [0.05]), here.propagate(states, [0.05]))


def test_parameters_of_each_motion() -> None:
    here, there = on_both(OSCILLATOR)
    states, values = [[1.0, 0.0]] * 4, {"p": [0.5, 1.0, 2.0, 4.0]}
    found = there.propagate(states, [0.5], values)
    assert_same(found, here.propagate(states, [0.5], values))
    np.testing.assert_allclose(found.states[:, 0, 0], np.cos(0.5 * np.sqrt(values["p"])))


def test_a_section() -> None:
    ball = body("unbalanced-ball")
    here, there = on_both(ball, section=poincare_section(ball, "gamma_3"))
    states = starts("unbalanced-ball", 3)
    found = there.crossings(states, 2, t_end=8.0)
    assert_same(found, here.crossings(states, 2, t_end=8.0))
    assert found.counts.max() == 2


def test_deviations_backward() -> None:
    ball = body("chaplygin-ball")
    here, there = on_both(ball, deviations=2, backward=True)
    states = starts("chaplygin-ball", 2)
    deviations = np.random.default_rng(1).normal(size=(2, 2, 6))
    found = there.propagate(states, [-0.2], deviations=deviations)
    assert_same(found, here.propagate(states, [-0.2], deviations=deviations))


def test_30_digits() -> None:
    here, there = on_both(OSCILLATOR, precision="quad", tolerance=1e-20)
    found = there.propagate([[1.0, 0.0]], [0.2])
    assert_same(found, here.propagate([[1.0, 0.0]], [0.2]))


def test_special_functions() -> None:
    system = System(
        name="functions",
        title="Functions",
        field={
            x: sp.sin(y) + sp.exp(-(x**2)) + sp.atan2(x, 1 + y**2) + sp.tanh(x * y),
            y: sp.cos(x) * sp.log(1 + y**2) + sp.asin(sp.sin(x) / 2) + sp.Abs(x) + sp.tan(y / 9),
        },
    )
    here, there = on_both(system)
    states = np.random.default_rng(2).normal(size=(3, 2))
    assert_same(there.propagate(states, [0.2]), here.propagate(states, [0.2]))


@pytest.mark.parametrize(
    ("system", "state", "until"),
    [(FENCED, [0.4, -1.0], 3.0), (RUNAWAY, [1.0], 2.0), (LOGARITHM, [-1.0, 0.0], 1.0)],
)
def test_motions_that_end(system: System, state: list[float], until: float) -> None:
    here, there = on_both(system)
    found = there.propagate([state, state], [0.01, until])
    assert_same(found, here.propagate([state, state], [0.01, until]))
    assert found.outcome.all()
    if system is LOGARITHM:
        assert found.outcome.tolist() == [NOT_A_NUMBER] * 2


def test_pieces_and_threads_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    machine = PtxMachine(threads=2)
    here, there = on_both(OSCILLATOR, machine=machine)
    states, values = np.random.default_rng(0).normal(size=(7, 2)), {"p": np.linspace(1, 2, 7)}
    monkeypatch.setattr(module, "PIECE", 3 * 2 * 2 * 8)
    found = there.propagate(states, [0.1, 0.2], values)
    assert_same(found, here.propagate(states, [0.1, 0.2], values))
    assert sorted(machine.launches) == [("march", 1), ("march", 3), ("march", 3)]


def test_another_coefficient_gives_other_bits() -> None:
    here, there = on_both(OSCILLATOR)
    assert isinstance(there.loop, module.GraphicsLoop)
    weight = float(explicit().b[5])
    old, new = (literal(number).replace("0x", "0d") for number in (weight, weight * (1 + 1e-9)))
    assert old in there.loop.ptx
    changed = replace(there.loop, ptx=there.loop.ptx.replace(old, new))
    found = replace(there, loop=changed).propagate([[1.0, 0.3]], [0.5])
    assert found.states.tolist() != here.propagate([[1.0, 0.3]], [0.5]).states.tolist()


def test_friction_stays_on_the_processor() -> None:
    refuse_graphics("cpu")
    with pytest.raises(InputError, match="computed on the 'cpu' alone"):
        refuse_graphics("gpu")

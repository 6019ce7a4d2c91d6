"""Every system of the catalogue by two methods that share nothing but its formulas."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.gauss import gauss_integrator
from flowlanes.flow.initial_states import flat_starts
from flowlanes.system.named_formulas import flat
from nonholonomic.catalogue import CATALOGUE, from_catalogue

#: Two systems at all times, the others among the slow tests.
SYSTEMS = [
    pytest.param(name, marks=[pytest.mark.slow] if i % 40 else [])
    for i, name in enumerate(CATALOGUE)
]


@pytest.mark.parametrize("name", SYSTEMS)
def test_lanes_and_collocation_agree(name: str) -> None:
    """From the start that the catalogue names; neither ends before its time."""
    system = replace(from_catalogue(name), reconstruction=None, observables=())
    chosen = CATALOGUE[name].start
    variables = {str(part) for part in (*flat(system.state), *system.state)}
    given = {
        key: np.array([value], dtype=float)
        for key, value in chosen.values.items()
        if key in variables | {"omega", "gamma"}
    }
    start = flat_starts(system, given)
    times = [min(chosen.until, 5.0)]
    fine = gauss_integrator(system, start[0]).propagate(start, times)
    found = batch_integrator(system).propagate(start, times)
    assert found.outcome.tolist() == fine.outcome.tolist() == [0]
    allowed = 1e-10 * np.maximum(1, np.abs(fine.states))
    assert (np.abs(found.states - fine.states) < allowed).all()

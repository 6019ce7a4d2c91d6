"""The table of options: every row is used, every option is described and written once."""

from __future__ import annotations

import inspect
from typing import Any

import pytest
import typer

from chaplygin.cli import app, ensemble, find, lyapunov, orbit, section, sweep
from chaplygin.cli.terminal.option_table import BOUNDS, OPTIONS, WORDS, with_options
from chaplygin.experiment.friction_studies.ensemble import contact_ensemble_task
from chaplygin.experiment.friction_studies.section import contact_section_task
from chaplygin.experiment.poincare import section_of
from flowlanes.flow.ensembles.run import ensemble_task
from flowlanes.flow.sampling.level_sampler import sample_level
from flowlanes.lyapunov.spectrum import lyapunov_spectrum
from flowlanes.orbits.periodic import find_periodic
from lawproof.search.request import search_space

COMMANDS: dict[str, Any] = vars(typer.main.get_command(app))["commands"]


def test_every_option_is_described_once() -> None:
    unused = set(OPTIONS)
    for name, command in COMMANDS.items():
        for parameter in command.params:
            place = f"{name} {parameter.name}"
            assert parameter.help, place
            assert not parameter.secondary_opts, place
            unused.discard(place if place in OPTIONS else parameter.name)
    assert not unused
    assert WORDS.keys() | BOUNDS.keys() <= {p.name for c in COMMANDS.values() for p in c.params}


def test_a_new_option_needs_a_row() -> None:
    def command(what: str, colour: str = "red") -> None:
        raise AssertionError

    with pytest.raises(KeyError, match="colour"):
        with_options("paint", command)


@pytest.mark.parametrize(
    ("command", "function", "names"),
    [
        (section, section_of, {"tolerance": "tolerance"}),
        (section, contact_section_task, {"tolerance": "tolerance"}),
        (ensemble, ensemble_task, {"tolerance": "tolerance", "device": "device"}),
        (ensemble, contact_ensemble_task, {"tolerance": "tolerance"}),
        (sweep, ensemble_task, {"tolerance": "tolerance"}),
        (lyapunov, lyapunov_spectrum, {"tolerance": "tolerance", "device": "device"}),
        (lyapunov, sample_level, {"seed": "seed"}),
        (orbit, find_periodic, {"period": "period"}),
        (
            find,
            search_space,
            {name: name for name in ("degree", "gamma_degree", "momenta", "parameter_degree")}
            | {"power": "powers"},
        ),
    ],
)
def test_defaults_are_those_of_the_functions(
    command: Any, function: Any, names: dict[str, str]
) -> None:
    ours, theirs = (inspect.signature(f).parameters for f in (command.command, function))
    for option, name in names.items():
        assert ours[option].default == theirs[name].default, option

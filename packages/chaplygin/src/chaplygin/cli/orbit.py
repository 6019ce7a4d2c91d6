"""``chaplygin orbit``: a periodic orbit near a motion, and its branch."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from flowlanes.system.tolerance import TOLERANCE

from ..interruption import NOTHING_SAVED, message_on_interrupt
from .terminal.options import inform, print_json, study_of
from .terminal.output_destination import check_figure, check_output, deliver
from .terminal.progress import progress

if TYPE_CHECKING:
    from flowlanes.orbits.continuation import Branch
    from flowlanes.orbits.periodic import Orbit

    from ..experiment.study import Study


def command(
    what: str,
    on: str,
    value: float = 0.0,
    direction: str = "rising",
    angle: bool = False,
    after: int = 1,
    period: int = 1,
    hold: list[str] | None = None,
    follow: str | None = None,
    tolerance: float = TOLERANCE["double"],
    output: Path | None = None,
    figure: Path | None = None,
    overrides: list[str] | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Find a periodic orbit near the motion: period, multipliers, stability; or continue it.

    The motion is integrated to the Poincaré section; from there Newton's method
    finds a closed orbit. All results are observed, not proven.
    """
    from ..experiment.formats import check_output as check_trajectory

    varied = None if follow is None else _varied_quantity(follow)
    if output is not None:
        check_output("--output", output, force, json, what, place=check_trajectory)
    if figure is not None:
        check_figure("--figure", figure)
        check_output("--figure", figure, force, json)
    study = study_of(what, overrides)
    how = (after, period, tolerance)
    from flowlanes.orbits.orbit_near import orbit_near

    from ..experiment.poincare import DIRECTIONS
    from ..experiment.single_system import without_reconstruction
    from ..report.drawing.files import save

    system = without_reconstruction(study)
    begin = [float(x) for x in study.start[: len(system.symbols)]]
    where = (on, value, DIRECTIONS[direction], angle)

    with progress(study.system.title) as update, message_on_interrupt(NOTHING_SAVED):
        orbit, branch = orbit_near(
            system, begin, study.until, where, how, hold or [], varied, update
        )
    if output is not None:
        deliver(_one_period(study, orbit), output, force)
    if figure is not None:
        if branch is None:
            from ..report.figures.state import state

            dataset = _one_period(study, orbit)
            save(state(dataset, [str(name) for name in study.system.state]), figure)
        else:
            from ..report.figures.orbit_branch import branch as drawn

            save(drawn(branch, study.system.title), figure)
    if json:
        print_json(_record(study, orbit, branch))
        return
    _print(study, orbit, branch)
    for place, words in ((output, "one period is in"), (figure, "figure:")):
        if place is not None:
            inform(f"{words} {place}")


def _varied_quantity(text: str) -> tuple[str, float]:
    """Quantity that varies along a branch, and its last value."""
    from flowlanes.errors import InputError

    name, equals, number = (part.strip() for part in text.partition("="))
    try:
        if not (name and equals):
            raise ValueError
        return name, float(number)
    except ValueError:
        raise InputError(
            f"--follow {text}: it is written NAME=VALUE, such as energy=2 or I_1=1.2"
        ) from None


def _one_period(study: Study, orbit: Orbit) -> Any:
    """Orbit as a trajectory, from its first point on the section."""
    import numpy as np

    from flowlanes.flow.integrator import integrate

    from ..experiment.study import dataset_of

    size = len(study.system.symbols)
    times = np.linspace(0.0, orbit.duration, study.experiment.run.samples).tolist()
    return dataset_of(
        study, integrate(study.system_on_level, orbit.points[0, :size].tolist(), times)
    )


def _record(study: Study, orbit: Orbit, branch: Branch | None) -> dict[str, object]:
    from flowlanes.orbits.orbit_near import orbit_facts

    return {
        "system": study.system.name,
        **orbit_facts(orbit),
        "branch": None
        if branch is None
        else {
            "varied": branch.parameter,
            "reason": branch.reason,
            "orbits": [orbit_facts(item) for item in branch.orbits],
            "events": [
                {"kind": event.kind, "value": event.place, **orbit_facts(event.orbit)}
                for event in branch.events
            ],
        },
    }


def _print(study: Study, orbit: Orbit, branch: Branch | None) -> None:
    returns = "1 return" if orbit.period == 1 else f"{orbit.period} returns"
    typer.echo(f"{study.system.title}: a periodic orbit of {returns}, {orbit.kind} (observed)")
    typer.echo(f"  period  {orbit.duration:.15g} s, closed to {orbit.gap:.1e}")
    for name, number in orbit.values.items():
        typer.echo(f"  {name}  {number:.15g}")
    for name, number in zip(orbit.names, orbit.points[0], strict=True):
        typer.echo(f"  {name}  {number:.15g}")
    multipliers = orbit.multipliers
    for value, error in zip(multipliers.values, multipliers.errors, strict=True):
        imaginary = (
            f" {'+' if value.imag > 0 else '−'} {abs(value.imag):.9g} i" if value.imag else ""
        )
        typer.echo(f"  multiplier  {value.real:.9g}{imaginary} ± {error:.0e}")
    typer.echo(f"  trivial multipliers (equal to 1): {', '.join(multipliers.trivial)}")
    if branch is None:
        return
    places = branch.places
    typer.echo(
        f"\ncontinued through {len(branch.orbits)} orbits, {branch.parameter} "
        f"from {places[0]:.9g} to {places[-1]:.9g}: {branch.reason}"
    )
    for event in branch.events:
        typer.echo(f"  {event.kind} at {branch.parameter} = {event.place:.12g}")

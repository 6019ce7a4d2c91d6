"""Facts of a run, as JSON and as text."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flowlanes.flow.trajectory import Trajectory
    from nonholonomic.contact.simulation.events import ContactEvent

    from ...experiment.contact.trajectory import ContactTrajectory
    from ...experiment.study import Study

#: Line width, and maximum number of printed events of a motion with friction.
COLUMNS, FIRST = 80, 10


def results(study: Study, trajectory: Trajectory) -> tuple[dict[str, Any], str]:
    """Facts of a run as data, and as lines of text."""
    from ...experiment.contact.trajectory import ContactTrajectory
    from ...report.summary import summary, summary_text

    if isinstance(trajectory, ContactTrajectory):
        facts = contact_facts(trajectory)
        return facts, contact_text(trajectory)
    facts = summary(trajectory)
    return facts, summary_text(study.system, trajectory, facts)


def contact_facts(trajectory: ContactTrajectory) -> dict[str, Any]:
    """Facts of a motion with friction as JSON-compatible data."""
    system, statistics = trajectory.system, trajectory.statistics
    return {
        "system": system.name,
        "time": float(trajectory.times[-1]),
        "final": dict(
            zip(map(str, system.symbols), map(float, trajectory.states[-1]), strict=True)
        ),
        "drift": {"energy_balance": trajectory.drift},
        "work": {name: float(values[-1]) for name, values in trajectory.works.items()},
        "events": [
            {
                "time": event.time,
                "what": event.kind,
                "mode": event.mode,
                "impulse": [float(x) for x in event.impulse],
                "couple_impulse": float(event.couple_impulse),
            }
            for event in trajectory.changes
        ],
        "warnings": list(trajectory.warnings),
        "ended": trajectory.reason,
        "steps": statistics.steps,
        "order": statistics.order,
        "seconds": statistics.seconds,
    }


def contact_text(trajectory: ContactTrajectory) -> str:
    """Facts of a motion with friction as lines of at most 80 columns."""
    statistics, times = trajectory.statistics, trajectory.times
    works = ", ".join(
        f"{name.removeprefix('work_')} {values[-1]:.4g}"
        for name, values in trajectory.works.items()
    )
    lines = [
        trajectory.system.title,
        f"  t = {times[0]:.9g} … {times[-1]:.9g}, {statistics.steps} steps of order "
        f"{statistics.order} in {statistics.seconds:.3g} s",
        f"  energy with all work lost: drift {trajectory.drift:.1e}",
        f"  work lost (J): {works}",
        f"  {_numbers(trajectory)}",
        *(f"    {_event(event)}" for event in trajectory.changes[:FIRST]),
    ]
    more = len(trajectory.changes) - FIRST
    if more > 0:
        lines.append(f"    … and {more} more, in event_time and event_kind of the dataset")
    lines += [f"  warning: {warning}" for warning in trajectory.warnings]
    if trajectory.reason:
        lines.append(f"  the motion ends at t = {times[-1]:.9g}: {trajectory.reason}")
    return "\n".join(textwrap.fill(line, COLUMNS, subsequent_indent="    ") for line in lines)


def _numbers(trajectory: ContactTrajectory) -> str:
    """Numbers of events by kind."""
    count = len(trajectory.changes)
    if not count:
        return "no events"
    kinds = ", ".join(f"{number} {kind}" for kind, number in trajectory.kinds.items())
    return f"{count} event{'s' if count > 1 else ''}: {kinds}"


def _event(event: ContactEvent) -> str:
    other = "" if event.unique else " (another motion is possible)"
    return f"{event}{other}"

"""Tables of results."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from .bodies import BODIES
from .peak import peak, per_step, reached
from .programs import Result
from .tasks import Outcome

__all__ = ["arithmetic", "machine", "show"]


def machine() -> str:
    """Processor, number of processors, and load of the machine."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    model = next((x.split(":")[1].strip() for x in lines if x.startswith("model name")), "unknown")
    wide = "AVX-512" if any("avx512f" in x for x in lines) else "no AVX-512"
    return f"{model}, {os.cpu_count()} processors, {wide}; load {os.getloadavg()[0]:.1f}"


def arithmetic() -> Table:
    """Operations per second of one core: the peak rate, and the rate of the engine."""
    most = max(peak(width) for width in (2, 4, 8))
    made = Table(title=f"arithmetic: one core does {most / 1e9:.0f} operations in a nanosecond")
    for head in ("body", "operations of a step", "in a nanosecond", "part of the most"):
        made.add_column(head, justify="right")
    for body in BODIES.values():
        done = reached(body)
        cells = (str(per_step(body)), f"{done / 1e9:.0f}", f"{100 * done / most:.0f} %")
        made.add_row(body.name, *cells)
    return made


def show(outcomes: Iterable[Outcome], width: int = 118) -> None:
    """One table for each task, body and target, in the order of measurement; arithmetic last."""
    console = Console(width=width)
    console.print(machine())
    for outcome in outcomes:
        console.print(table(outcome))
    console.print(arithmetic())


def table(outcome: Outcome) -> Table:
    """Table with a row per program; times in microseconds for each motion or section point."""
    unit = {"section": "point", "ball": "second"}.get(outcome.task, "motion")
    target = f", error {outcome.target:.0e}" if np.isfinite(outcome.target) else ""
    made = Table(title=f"{outcome.task}, {outcome.body}{target}")
    made.add_column("program")
    heads = ("setting", "median error", "worst", f"core µs/{unit}", "wall µs", "ratio", "compile s")
    for head in heads:
        made.add_column(head, justify="right")
    for result in sorted(outcome.results.values(), key=lambda r: np.nan_to_num(r.core, nan=9e9)):
        made.add_row(result.name, *_cells(result, outcome))
    return made


def _cells(result: Result, outcome: Outcome) -> tuple[str, ...]:
    if result.setting is None:
        return ("not reached",)
    return (
        f"{result.setting:.3g}",
        f"{result.error:.1e}",
        f"{result.worst:.1e}",
        f"{1e6 * result.core / outcome.each:.3g}",
        f"{1e6 * result.wall / outcome.each:.3g}",
        f"{result.core / outcome.own.core:.2f}",
        f"{result.compile:.2f}",
    )

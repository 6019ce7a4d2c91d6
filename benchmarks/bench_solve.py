"""Closed forms compared with integration: time per state, set-up, errors, and their growth in time.

The errors of the evaluation in doubles are relative to the evaluation with error bounds.  The
fastest integration runs to the same time at the largest tolerance with the same error, or at the
smallest tolerance if this error is not attained; for a long run the time of a shorter run is
scaled.  Times are processor times.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

import chaplygin
import nonholonomic
from chaplygin import System, initial_state, solve
from nonholonomic import Solution
from nonholonomic.closed_form.rigorous import rigorous_motion

#: Systems, with angular velocities at γ = (0, 0, 1).  Doubles represent these starts, and the
#: bodies with I₃ changed, exactly, so all methods solve exactly the same motion.
CASES = {
    "veselova": (1.0, 0.5, 0.0),
    "rubber-chaplygin-ball": (1.0, 0.5, 0.0),
    "chaplygin-ball": (1.0, 0.5, 0.25),
}
BODY = {"I_3": 2.125}
TIMES = (1e3, 1e4, 1e6)
STATES = 10_000
DIGITS = 20
#: Longest motion that is integrated; for longer ones the time is scaled.
LONGEST = 1e4
TURNS = 5
TOLERANCES = (1e-10, 1e-12, 1e-14, 1e-15, 1e-16)


@dataclass(frozen=True)
class Case:
    """Reduced motion; all parameters except `BODY` have defaults that are exact in doubles."""

    system: System
    start: list[float]

    @classmethod
    def of(cls, name: str) -> Case:
        """A system of the catalogue, without its motion in space."""
        system = nonholonomic.CATALOGUE[name].system()
        body = {p.symbol: BODY[str(p.symbol)] for p in system.parameters if str(p.symbol) in BODY}
        start = initial_state(system, CASES[name], (0.0, 0.0, 1.0), parameters=body)
        core = replace(system, reconstruction=None, observables=(), guards=())
        return cls(core, [float(x) for x in start[: len(core.symbols)]])


def set_up(case: Case) -> tuple[Solution, float]:
    """Prepared solution, and the time of its preparation in seconds."""
    begun = time.process_time()
    solution = solve(case.system, case.start, BODY)
    solution.states(np.array([0.0]))
    return solution, time.process_time() - begun


def per_state(solution: Solution, until: float, turns: int) -> float:
    """Seconds for one of many states about a time."""
    times = until + np.arange(STATES) * 0.01
    found = []
    for _ in range(turns):
        begun = time.process_time()
        solution.states(times)
        found.append((time.process_time() - begun) / STATES)
    return statistics.median(found)


def exact(solution: Any, until: float) -> tuple[Any, float]:
    """State with error bounds, and the largest radius."""
    balls = rigorous_motion(solution, DIGITS, until).state(until)
    return balls, max(float(ball.rad()) for ball in balls)


def error(balls: Sequence[Any], state: Sequence[Any]) -> float:
    """Largest distance of a state in doubles from the exact state."""
    return max(abs(float((ball - float(x)).mid())) for ball, x in zip(balls, state, strict=True))


def integration(case: Case, until: float, target: float, balls: Any) -> dict[str, float]:
    """Seconds of the fastest integration to a time at an error, its error and its tolerance."""
    reached = min(until, LONGEST)
    for tolerance in TOLERANCES:
        options = {"parameters": BODY, "tolerance": tolerance}
        chaplygin.integrate(case.system, case.start, [0.0, 1.0], **options)  # compiles
        begun = time.process_time()
        run = chaplygin.integrate(case.system, case.start, [0.0, reached], **options)
        seconds = time.process_time() - begun
        missed = error(balls, run.states[-1])
        if missed <= target:
            break
    return {"seconds": seconds * until / reached, "error": missed, "tolerance": tolerance}


def measure(name: str, turns: int) -> list[dict[str, object]]:
    case = Case.of(name)
    set_up(case)  # formulas are read once for all motions of a system
    solution, preparation = set_up(case)
    rows: list[dict[str, object]] = []
    comparable, _ = exact(solution, LONGEST)
    for until in TIMES:
        seconds = per_state(solution, until, turns)
        balls, radius = exact(solution, until)
        missed = error(balls, solution.states(np.array([until]))[0])
        near = balls if until <= LONGEST else comparable
        run = integration(case, until, missed, near)
        rows.append(
            {
                "system": name,
                "until": until,
                "set_up": preparation,
                "per_state": seconds,
                "error": missed,
                "bound": radius,
                "integration": run["seconds"],
                "integration_error": run["error"],
                "tolerance": run["tolerance"],
                "ratio": run["seconds"] / seconds,
            }
        )
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--turns", type=int, default=TURNS)
    parser.add_argument("systems", nargs="*", default=list(CASES))
    arguments = parser.parse_args()
    rows = [row for name in arguments.systems for row in measure(name, arguments.turns)]
    if arguments.json:
        print(json.dumps(rows, indent=2))
        return
    print(
        "system                 until  set-up s  us/state  error    integration s  error    ratio"
    )
    for row in rows:
        print(
            f"{row['system']:<22}{row['until']:>6.0e}{row['set_up']:>10.2f}"
            f"{1e6 * float(str(row['per_state'])):>10.1f}{row['error']:>9.1e}"
            f"{row['integration']:>15.3g}{row['integration_error']:>9.1e}{row['ratio']:>9.0f}"
        )


if __name__ == "__main__":
    main()

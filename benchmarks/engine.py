"""The engine, heyoka, SciPy, numba, JAX and MuJoCo at equal error.

Three bodies roll on a plane: the Chaplygin ball, a heavy unbalanced ball and a heavy ellipsoid.
The tolerance or step number of every program is chosen for some random starts, so that the median
error of a motion attains the target; errors and times are measured for other starts, against
motions with 34 digits or more.  The programs alternate, and medians are compared.  Times are
processor times of all threads together, which depend little on other work on the machine;
wall-clock times are shown too.

``--body ball-4`` selects a ball in four dimensions, ``ball-4-tensor`` one with a mass tensor.
``--json`` prints, for five tasks and three bodies, the ratio of the time of the best variant of
heyoka to that of this engine; of two targets the smaller ratio.  The row ``"numba"`` is for
ensembles, compared with hand-written loops over 16 lanes, with the number of equal steps for the
same median and worst errors.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator, Sequence
from importlib.util import find_spec

from contest import taylor
from contest.bodies import BEYOND, BODIES, Body
from contest.tasks import QUICK, TASKS, THOROUGH, Effort, Outcome, ball


def measure(
    effort: Effort, tasks: Sequence[str], bodies: Sequence[Body] = tuple(BODIES.values())
) -> Iterator[Outcome]:
    """Results of every task for every body and target, one after another."""
    for task in TASKS:
        if task.name in tasks:
            for body in bodies:
                for target in task.targets[: None if effort.thorough else 1]:
                    yield task.run(body, target, effort)
    if "ball" in tasks and find_spec("mujoco"):
        yield ball(BODIES["chaplygin-ball"], effort)


def ratios(outcomes: Sequence[Outcome]) -> dict[str, dict[str, float]]:
    """Smallest ratio of each task and body."""
    found: dict[str, dict[str, float]] = {}
    for outcome in outcomes:
        row = found.setdefault(outcome.task, {})
        ratio = min(row.get(outcome.body, outcome.ratio), outcome.ratio)
        row[outcome.body] = round(ratio, 2)
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--quick", action="store_true", help="few starts, heyoka's best alone")
    names = [task.name for task in TASKS]
    parser.add_argument("--task", action="append", choices=[*names, "ball"], help="it alone")
    every = {**BODIES, **BEYOND}
    parser.add_argument("--body", action="append", choices=list(every), help="it alone")
    options = parser.parse_args()
    bodies = [every[name] for name in options.body or BODIES]
    taylor.forget()
    effort = QUICK if options.quick else THOROUGH
    if options.json:
        outcomes = list(measure(effort, options.task or names, bodies))
        print(json.dumps(ratios(outcomes), indent=2))
        return
    from contest import report

    report.show(measure(effort, options.task or [*names, "ball"], bodies))


if __name__ == "__main__":
    main()

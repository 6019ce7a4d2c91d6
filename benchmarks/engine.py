"""The engine beside heyoka, SciPy, numba, JAX and MuJoCo, at equal achieved error.

Three bodies roll on a plane: the Chaplygin ball, a heavy unbalanced ball and a heavy ellipsoid.
Every program chooses its tolerance or its steps on some random starts, so that the median error
of a motion meets the target, and is scored on others, against motions with 34 digits or more.
Programs take turns and medians are compared.  Times are of the processor, all threads together,
which other work on the machine changes little; time that passed is shown beside.

``--body ball-4`` asks of a ball of four dimensions, ``ball-4-tensor`` of one with a mass tensor.
``--json`` prints, for five tasks and three bodies, the time of heyoka's best variant in that of
this engine; of two targets the smaller ratio.  The row ``"numba"`` is that of ensembles beside
loops written by hand over 16 lanes, with as many equal steps as their median and worst errors need.
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
    """Every task with every body and target, one after another."""
    for task in TASKS:
        if task.name in tasks:
            for body in bodies:
                for target in task.targets[: None if effort.thorough else 1]:
                    yield task.run(body, target, effort)
    if "ball" in tasks and find_spec("mujoco"):
        yield ball(BODIES["chaplygin-ball"], effort)


def ratios(outcomes: Sequence[Outcome]) -> dict[str, dict[str, float]]:
    """The smallest ratio of each task and body."""
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

"""Time and operations for the Whipple bicycle, compared with Kane's method in SymPy.

The results are times for the derivation of the equations, the numbers of arithmetic operations in
them (for SymPy, of mass matrix and forcing as returned, and after elimination of common
subexpressions), the time of one evaluation of the accelerations in NumPy, and of the eigenvalues
of straight running at 5 m/s.  The accelerations of this package are given by formulas; those of
SymPy are solved numerically in every evaluation.  A third method is a Kane model converted by
`from_sympy`.  For derivations the methods alternate, each in a new process without cached results;
medians of processor time are compared.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from collections.abc import Callable
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
from kane_bicycle import kane_bicycle

from chaplygin import System, equations_of_motion, from_sympy, linear_stability
from flowlanes import lambdify

sys.path.insert(0, str(Path(__file__).parents[1] / "examples"))
import whipple_bicycle

SPEED = 5
VALUES = {name: float(value) for name, value in whipple_bicycle.VALUES.items()}


def operations(system: System) -> int:
    """Number of operations in the rates and in the definitions on which they depend."""
    steps = system.required_definitions(system.rates)
    return int(sum(sp.count_ops(e) for e in (*system.rates, *(value for _, value in steps))))


def own() -> System:
    whipple_bicycle.bicycle.cache_clear()
    return equations_of_motion(whipple_bicycle.bicycle())


def kane() -> Any:
    method, bodies, loads = kane_bicycle()
    method.kanes_equations(bodies, loads)
    return method


def taken_in() -> System:
    return from_sympy(kane_bicycle()[0], VALUES, name="kane")


def own_rate(system: System) -> Callable[[], Any]:
    """Function for one evaluation of the rates in straight running."""
    field = lambdify(system, "numpy")
    state = {name: float(x) for name, x in whipple_bicycle.upright(SPEED).items()}
    point = np.array([state.get(str(s), 0.0) for s in system.symbols])
    parameters = np.array([VALUES[str(p.symbol)] for p in system.parameters])
    return lambda: field(0.0, point, parameters)


def kane_rate(method: Any) -> Callable[[], Any]:
    """The same for SymPy: mass matrix and forcing with common subexpressions, solved by NumPy."""
    moving = [*method.q, *method.u]
    constants = [sp.Symbol(name) for name in VALUES]
    pair = [method.mass_matrix, method.forcing]
    function = sp.lambdify([moving, constants], pair, "numpy", cse=True)
    point = [0.0] * len(moving)
    numbers = list(VALUES.values())

    def rate() -> Any:
        mass, forcing = function(point, numbers)
        return np.linalg.solve(mass, forcing)

    return rate


def kane_eigenvalues(method: Any) -> list[complex]:
    """Eigenvalues from the linearization by SymPy: lean, steer and their rates."""
    point = dict.fromkeys([*method.q, *method.u, *(u.diff() for u in method.u)], 0)
    by_name = {str(u.func): u for u in method.u}
    point[by_name["u3"]] = -SPEED / sp.Symbol("R_R")
    point[by_name["u6"]] = -SPEED / sp.Symbol("R_F")
    matrix = method.linearize(A_and_B=True, op_point=point, linear_solver="CRAMER")[0]
    numbers = {sp.Symbol(name): value for name, value in VALUES.items()}
    dense = np.array(matrix.xreplace(numbers).evalf(), dtype=float)
    kept = [1, 2, 3, 5]
    return list(np.linalg.eigvals(dense[np.ix_(kept, kept)]))


def taken_in_eigenvalues(system: System) -> list[complex]:
    numbers = whipple_bicycle.VALUES
    still: dict[str, Any] = dict.fromkeys(map(str, system.symbols), 0)
    wheels = {"u3": -1 / numbers["R_R"], "u6": -1 / numbers["R_F"]}
    state = still | {name: SPEED * rate for name, rate in wheels.items()}
    return [
        complex(x) for x in linear_stability(system, state, numbers, along=[wheels]).eigenvalues
    ]


def seconds(job: Callable[[], Any]) -> float:
    """Processor time of a job."""
    began = time.process_time()
    job()
    return time.process_time() - began


def each(job: Callable[[], Any], seconds: float = 0.5) -> float:
    """Seconds for one call."""
    count, began = 0, time.process_time()
    while time.process_time() - began < seconds:
        job()
        count += 1
    return (time.process_time() - began) / count


def measured(turns: int, linearisation: bool) -> dict[str, dict[str, float]]:
    """Medians by method and quantity."""
    found: dict[str, dict[str, list[float]]] = {}
    ways = (("chaplygin", own), ("SymPy", kane), ("SymPy, taken in", taken_in))

    def note(way: str, what: str, value: float) -> None:
        found.setdefault(way, {}).setdefault(what, []).append(value)

    for _ in range(turns):
        for way, derive in ways:
            with get_context("spawn").Pool(1) as fresh:
                note(way, "derivation (s)", fresh.apply(seconds, (derive,)))
    for way, derive in ways:
        model = derive()
        if isinstance(model, System):
            note(way, "operations", operations(model))
            note(way, "one evaluation (µs)", 1e6 * each(own_rate(model)))
        else:
            pair = (model.mass_matrix_full, model.forcing_full)
            note(way, "operations", int(sum(sp.count_ops(part) for part in pair)))
            steps, parts = sp.cse(pair)
            shared = (*(value for _, value in steps), *parts)
            note(way, "after sharing", int(sum(sp.count_ops(e) for e in shared)))
            note(way, "one evaluation (µs)", 1e6 * each(kane_rate(model)))
        if linearisation:
            job = {
                "chaplygin": lambda: whipple_bicycle.linearisation_near(SPEED).eigenvalues,
                "SymPy": lambda model=model: kane_eigenvalues(model),
                "SymPy, taken in": lambda model=model: taken_in_eigenvalues(model),
            }[way]
            whipple_bicycle.model()
            note(way, "eigenvalues (s)", seconds(job))
    return {
        way: {what: statistics.median(values) for what, values in row.items()}
        for way, row in found.items()
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument(
        "--linearisation", action="store_true", help="eigenvalues too (SymPy takes minutes)"
    )
    options = parser.parse_args()
    table = measured(options.turns, options.linearisation)
    if options.json:
        print(json.dumps(table, indent=2))
        return
    rows = list(dict.fromkeys(what for row in table.values() for what in row))
    print(f"{'Whipple bicycle':22}" + "".join(f"{way:>18}" for way in table))
    for what in rows:
        cells = [f"{row[what]:18,.5g}" if what in row else f"{'':>18}" for row in table.values()]
        print(f"{what:22}" + "".join(cells))
    first, second = table["chaplygin"], table["SymPy"]
    print("\nSymPy to chaplygin")
    for what in first:
        print(f"{what:22}{second[what] / first[what]:18.3g}")


if __name__ == "__main__":
    main()

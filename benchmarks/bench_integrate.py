"""Time to reach a given error, compared with DOP853 and LSODA of SciPy.

Each method uses the largest tolerance for which it attains the target error at the end of the
motion (error against 34-digit integration); then the methods alternate, and medians are compared.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from scipy.integrate import solve_ivp

import chaplygin
import nonholonomic
from chaplygin import System, initial_state
from flowlanes import lambdify

CASES = {"chaplygin-ball": 50.0, "unbalanced-ball": 50.0, "rattleback": 2.0}
TARGETS = (1e-6, 1e-9, 1e-12)
TOLERANCES = [10.0 ** (-n / 2) for n in range(6, 31)]
TURNS = 7

Method = Callable[[float], np.ndarray]


def reduced(name: str) -> tuple[System, list[float]]:
    """The system without its motion in space, and the catalogue's start."""
    entry = nonholonomic.CATALOGUE[name]
    system = entry.system()
    start = initial_state(system, entry.start.omega, entry.start.gamma)
    core = replace(system, reconstruction=None, guards=())
    return core, [float(x) for x in start[: len(core.symbols)]]


def methods(system: System, start: list[float], until: float) -> dict[str, Method]:
    """Final state as a function of the tolerance, for each method."""
    field = lambdify(system, "numpy")

    def taylor(tolerance: float) -> np.ndarray:
        run = chaplygin.integrate(system, start, [0.0, until], tolerance=max(tolerance, 1e-16))
        return np.asarray(run.states[-1], dtype=float)

    def scipy_method(name: str) -> Method:
        def final(tolerance: float) -> np.ndarray:
            options = {"rtol": max(tolerance, 2.3e-14), "atol": tolerance}
            run = solve_ivp(field, (0.0, until), start, method=name, **options)
            return np.asarray(run.y[:, -1])

        return final

    return {
        "chaplygin": taylor,
        "DOP853": scipy_method("DOP853"),
        "LSODA": scipy_method("LSODA"),
    }


def loosest(method: Method, exact: np.ndarray, target: float) -> tuple[float, float] | None:
    """Largest tolerance that attains the target error, and the error."""
    for tolerance in TOLERANCES:
        error = float(np.abs(method(tolerance) - exact).max())
        if error <= target:
            return tolerance, error
    return None


def measure(name: str, until: float, turns: int) -> list[dict[str, object]]:
    system, start = reduced(name)
    quad = chaplygin.integrate(
        system, start, [0.0, until], tolerance=1e-30, precision="quad"
    ).states[-1]
    exact = np.array([float(x) for x in quad])
    candidates = methods(system, start, until)
    rows: list[dict[str, object]] = []
    for target in TARGETS:
        chosen = {key: loosest(method, exact, target) for key, method in candidates.items()}
        times: dict[str, list[float]] = {key: [] for key, found in chosen.items() if found}
        for _ in range(turns):
            for key, taken in times.items():
                began = time.perf_counter()
                candidates[key](chosen[key][0])
                taken.append(time.perf_counter() - began)
        own = statistics.median(times["chaplygin"])
        for key, found in chosen.items():
            row: dict[str, object] = {"system": name, "until": until, "target": target}
            row |= {"method": key, "error": None, "milliseconds": None, "ratio": None}
            if found:
                median = statistics.median(times[key])
                row |= {"error": found[1], "milliseconds": 1e3 * median, "ratio": median / own}
            rows.append(row)
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--quick", action="store_true", help="three turns instead of seven")
    options = parser.parse_args()
    turns = 3 if options.quick else TURNS
    rows = [row for name, until in CASES.items() for row in measure(name, until, turns)]
    if options.json:
        print(json.dumps(rows, indent=2))
        return
    print(f"{'system':16} {'target':>7} {'method':10} {'error':>9} {'median ms':>10} {'ratio':>8}")
    for row in rows:
        head = f"{row['system']:16} {row['target']:7.0e} {row['method']:10}"
        if row["ratio"] is None:
            print(f"{head} {'not reached at any tolerance':>29}")
        else:
            numbers = f"{row['error']:9.1e} {row['milliseconds']:10.2f} {row['ratio']:8.1f}"
            print(f"{head} {numbers}")


if __name__ == "__main__":
    main()

"""numba: the order-8 method as a compiled loop, with equal steps in lanes or error control."""

from __future__ import annotations

from typing import Any

import numpy as np

from flowlanes.flow.kernel.tableaux import explicit

from .bodies import Body
from .generated import defined, field_text, increment, step_text
from .programs import TOLERANCES, Program, Run

__all__ = ["numba_adaptive", "numba_fixed", "step_counts"]


def step_counts(fewest: int = 32) -> tuple[float, ...]:
    """Numbers of steps for the choice of settings, in ratios of 1.06."""
    return tuple(float(round(fewest * 1.06**k)) for k in range(70))


_LANES = """
def march(starts, until, steps):
    many = len(starts)
    ends = np.empty_like(starts)
    h = until / steps
    y, k = np.empty(({size}, {lanes})), np.empty(({stages}, {size}, {lanes}))
    for first in range(0, many, {lanes}):
        for l in range({lanes}):
            y[:, l] = starts[min(first + l, many - 1)]
        for _ in range(steps):
{stage_loops}
        for l in range(min({lanes}, many - first)):
            ends[first + l] = y[:, l]
    return ends
"""

_ADAPTIVE = """
def march(starts, until, tolerance):
    ends = np.empty_like(starts)
    for n in range(len(starts)):
        {state} = starts[n]
        t, h = 0.0, 0.01
        while t < until:
            h = min(h, until - t)
            {next}, {third}, {fifth} = step(h, {state})
            three, five = 0.0, 0.0
            for x, y, a, b in (({rows})):
                scale = tolerance * (1.0 + max(abs(x), abs(y)))
                three += (a / scale) ** 2
                five += (b / scale) ** 2
            error = 0.0
            if five > 0.0:
                error = five / sqrt((five + 0.01 * three) * {size})
            if error < 1.0:
                t += h
                {state} = {next}
            h *= min(6.0, max(0.333, 0.9 * error ** -0.125)) if error > 0.0 else 6.0
        ends[n] = {state}
    return ends
"""


def numba_fixed(body: Body, until: float, lanes: int = 16) -> Program:
    """Equal steps, whose number is the setting; loops over lanes that LLVM vectorizes."""
    march = _lanes(body, lanes)

    def build(steps: float) -> Run:
        def run(starts: np.ndarray) -> np.ndarray:
            return np.asarray(march(starts, until, int(steps)))

        return run

    return Program(f"numba, {lanes} lanes, equal steps", build, step_counts())


def _lanes(body: Body, lanes: int) -> Any:
    _, *lines, last = field_text(body).splitlines()
    rates = last.removeprefix("    return ").split(", ")
    table, state = explicit(), range(body.size)

    def combined(row: Any, i: int) -> str:
        return f"y[{i}, l]" + increment(row, lambda j: f"k[{j}, {i}, l]")

    loops = []
    for stage, row in enumerate(table.a):
        loops.append(f"for l in range({lanes}):")
        loops += [f"    x{i} = {combined(row, i)}" for i in state]
        loops += lines
        loops += [f"    k[{stage}, {i}, l] = {rates[i]}" for i in state]
    loops.append(f"for l in range({lanes}):")
    loops += [f"    y[{i}, l] = {combined(table.b, i)}" for i in state]
    text = _LANES.format(
        size=body.size,
        lanes=lanes,
        stages=len(table.a),
        stage_loops="\n".join(f"            {line}" for line in loops),
    )
    return _jit(defined(text, {"np": np, "sqrt": np.sqrt, "sin": np.sin, "cos": np.cos})["march"])


def numba_adaptive(body: Body, until: float) -> Program:
    """Error control as in DOP853 of SciPy."""
    march = _adaptive(body)

    def build(tolerance: float) -> Run:
        def run(starts: np.ndarray) -> np.ndarray:
            return np.asarray(march(starts, until, tolerance))

        return run

    return Program("numba, error control", build, TOLERANCES, share=0.5)


def _jit(function: Any) -> Any:
    import numba

    return numba.njit(error_model="numpy", fastmath={"contract"})(function)


def _adaptive(body: Body) -> Any:
    names: dict[str, Any] = {"np": np, "sqrt": np.sqrt, "sin": np.sin, "cos": np.cos}
    names["field"] = _jit(defined(field_text(body), names)["field"])
    names["step"] = _jit(defined(step_text(body.size), names)["step"])
    each = range(body.size)
    words = {letter: ", ".join(f"{letter}{i}" for i in each) for letter in "xyab"}
    rows = "), (".join(f"x{i}, y{i}, a{i}, b{i}" for i in each)
    text = _ADAPTIVE.format(
        state=words["x"],
        next=words["y"],
        third=words["a"],
        fifth=words["b"],
        rows=rows,
        size=body.size,
    )
    return _jit(defined(text, names)["march"])

"""Limits on the speed of each task of the engine, from small measurements on one core.

Operations are those in the graphs and tables of the engine, where a fused product and sum is two
operations; the control of steps is not included.  They are compared with the peak rate of fused
operations and, for a single motion, with the time of its longest chain of dependent operations.
"""

from __future__ import annotations

import argparse
import json
import re
import time
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from contest.bodies import BODIES, Body
from contest.generated import operations
from contest.peak import peak, per_step

from flowlanes import batch_integrator, gauss_integrator, poincare_section
from flowlanes.flow.kernel.tableaux import explicit
from flowlanes.flow.machine_code.arithmetic import Pair
from flowlanes.flow.machine_code.ir_writer import IRWriter
from flowlanes.flow.machine_code.jit import width
from flowlanes.formulas.graph import of_system, topological_order

#: Cycles until a result can be used, and those of a division or root (Zen 3 and 4).
LATENCY, DIVISION = 4, 13
TURNS = 15


def seconds(job: Callable[[], Any]) -> float:
    """Processor time of a job, the minimum of several runs: other work only adds to it."""
    spent = []
    for _ in range(TURNS):
        began = time.process_time()
        job()
        spent.append(time.process_time() - began)
    return min(spent)


def chain(body: Body, latency: Mapping[str, int]) -> int:
    """Number of cycles from a state to its rates along the longest chain of operations."""
    _, rates = of_system(body.system)
    depth: dict[int, int] = {}
    for node in topological_order(rates):
        below = max((depth[id(a)] for a in node.operands), default=0)
        moving = node.kind == "state" or below > 0
        # parameter-only terms are computed before; states are available at cycle 1
        depth[id(node)] = below + latency.get(node.kind, 1) if moving else 0
    return max(depth[id(rate)] for rate in rates)


def tangent_step(body: Body) -> int:
    """Number of operations of a step with as many tangent vectors as variables."""
    reader, rates = of_system(body.system)
    graph = reader.graph
    leaves = [graph.state(i) for i in range(body.size)]
    moved = graph.directional_derivative(
        rates, {x: graph.state(body.size + i) for i, x in enumerate(leaves)}
    )
    count = len(topological_order([*rates, *moved])) - len(topological_order(rates))
    stages = len(explicit().a)
    sums = per_step(body) - stages * sum(operations(body).values())
    return per_step(body) + body.size * (stages * count + sums)


def pairs() -> tuple[dict[str, int], dict[str, int]]:
    """Numbers of double operations in a pair operation, and cycles of their longest chain."""
    count, cycles = {}, {}
    for kind, taken in (("add", 2), ("sub", 2), ("mul", 2), ("recip", 1)):
        writer = IRWriter(4)
        getattr(Pair(writer), kind)(*((f"%a{i}", f"%b{i}") for i in range(taken)))
        depth: dict[str, int] = {}
        count[kind] = 0
        for line in writer.lines:
            made, _, text = line.strip().partition(" = ")
            below = max((depth.get(name, 0) for name in re.findall(r"%\w+", text)), default=0)
            depth[made] = below + (DIVISION if "fdiv" in text else LATENCY)
            count[kind] += 1 + ("fma" in text)
        cycles[kind] = max(depth.values())
    return count, cycles


def measured(body: Body, most: float) -> dict[str, float]:
    """Results for one body, by quantity."""
    found: dict[str, float] = {}
    starts = body.starts(3, 256)
    plain = batch_integrator(body.system, tolerance=1e-11)
    motions = plain.propagate(starts, [body.span], threads=1)
    spent = seconds(lambda: plain.propagate(starts, [body.span], threads=1))
    rate = per_step(body) * motions.steps.sum() / spent
    found["ensembles: share of peak"] = rate / most

    where = poincare_section(body.system, body.system.symbols[-1])
    flow = batch_integrator(body.system, tolerance=1e-11, section=where)
    crossed = flow.crossings(starts, 200, t_end=body.span, threads=1)
    with_section = seconds(lambda: flow.crossings(starts, 200, t_end=body.span, threads=1))
    points, steps = int(crossed.counts.sum()), int(crossed.steps.sum())
    found["sections: points of a motion"] = points / len(starts)
    found["sections: time with and without"] = with_section / spent
    found["sections: steps with and without"] = steps / motions.steps.sum()
    found["sections: further steps for a point"] = (steps - motions.steps.sum()) / points
    found["sections: time of a step, with to without"] = (with_section / steps) / (
        spent / motions.steps.sum()
    )

    some = starts[:64]
    tangent = batch_integrator(body.system, tolerance=1e-11, deviations=body.size)
    unit = np.repeat(np.eye(body.size)[None], len(some), axis=0)
    carried = lambda: tangent.propagate(some, [body.short], deviations=unit, threads=1)  # noqa: E731
    took = carried().steps.sum()
    found["tangents: share of peak"] = tangent_step(body) * took / seconds(carried) / most
    variables = body.size * (body.size + 1)
    found["tangents: kB of stages"] = len(explicit().a) * variables * width() * 8 / 1000
    found["ensembles: kB of stages"] = len(explicit().a) * body.size * width() * 8 / 1000

    cycle = 1 / (most / (4 * min(8, width() // 2)))
    for digits, precision in ((16, "double"), (30, "quad")):
        single = gauss_integrator(body.system, starts[0], precision=precision)
        one = [body.starts(4, 1)[0]]
        short = seconds(lambda s=single, x=one: s.propagate(x, [1e-3], threads=1))
        long = body.short if precision == "quad" else 20.0
        count = int(single.propagate(one, [long], threads=1).steps[0])
        step = (seconds(lambda s=single, x=one, t=long: s.propagate(x, [t], threads=1)) - short) / (
            count
        )
        found[f"{digits} digits: µs of a call"] = 1e6 * short
        found[f"{digits} digits: ns of a step"] = 1e9 * step
        found[f"{digits} digits: cycles of a step"] = step / cycle
    plain_chain = dict.fromkeys(("add", "sub", "mul"), LATENCY) | {"recip": DIVISION, "neg": 0}
    turn = chain(body, plain_chain) + (8 + 3) * LATENCY
    exact = chain(body, pairs()[1])
    found["16 digits: cycles of an iteration's chain"] = turn
    found["16 digits: cycles of the chain of rates in pairs"] = exact
    found["16 digits: iterations that the rest has time for"] = (
        found["16 digits: cycles of a step"] - exact
    ) / turn
    kinds = operations(body)
    shares = {kind: n * pairs()[0].get(kind, 1) for kind, n in kinds.items()}
    found["30 digits: doubles for an operation of rates"] = sum(shares.values()) / sum(
        kinds.values()
    )
    at_peak = 16 * sum(shares.values()) / most
    found["30 digits: evaluations at peak that a step has time for"] = (
        found["30 digits: ns of a step"] / 1e9 / at_peak
    )
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    most = max(peak(lanes) for lanes in (2, 4, 8))
    table = {name: measured(body, most) for name, body in BODIES.items()}
    count, cycles = pairs()
    if options.json:
        print(json.dumps({"peak": most, "pairs": count, **table}, indent=2))
        return
    print(f"peak {most / 1e9:.0f} operations in a nanosecond; lanes {width()}")
    print("one operation of pairs: operations of doubles", count, "cycles", cycles)
    print(f"{'':50}" + "".join(f"{name:>18}" for name in table))
    for what in next(iter(table.values())):
        print(f"{what:50}" + "".join(f"{row[what]:18.3g}" for row in table.values()))


if __name__ == "__main__":
    main()

"""Peak rate of operations of a core, and the rate attained by the engine."""

from __future__ import annotations

import ctypes
import time
from collections.abc import Callable

import numpy as np

from flowlanes import batch_integrator
from flowlanes.flow.kernel.tableaux import explicit

from .bodies import Body
from .generated import operations

__all__ = ["peak", "per_step", "reached"]

#: Independent chains of fused products and sums, enough to hide their latency.
CHAINS = 16
LOOPS = 2_000_000
TURNS = 7


def peak(width: int = 8) -> float:
    """Operations per second of one core (a fused product and sum is two), by measurement."""
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    features = llvm.get_host_cpu_features().flatten()
    options = {"cpu": llvm.get_host_cpu_name(), "features": features, "opt": 3}
    machine = target.create_target_machine(**options)
    module = llvm.parse_assembly(_kernel(width))
    engine = llvm.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    kernel = ctypes.CFUNCTYPE(None, ctypes.c_int64, ctypes.c_void_p)(
        engine.get_function_address("chains")
    )
    memory = np.zeros(width * (CHAINS + 8))
    place = memory.ctypes.data + (-memory.ctypes.data) % (8 * width)
    best = min(_timed(kernel, place) for _ in range(TURNS))
    return 2 * width * CHAINS * LOOPS / best


def _timed(kernel: Callable[[int, int], None], place: int) -> float:
    began = time.process_time()
    kernel(LOOPS, place)
    return time.process_time() - began


def _kernel(width: int) -> str:
    vector = f"<{width} x double>"
    name = f"@llvm.fma.v{width}f64"
    ones = ", ".join(["double 0.5"] * width)
    chains = range(CHAINS)
    lines = [
        f"declare {vector} {name}({vector}, {vector}, {vector})",
        "define void @chains(i64 %n, ptr %out) {",
        "entry:",
        "  br label %loop",
        "loop:",
        "  %i = phi i64 [0, %entry], [%next, %loop]",
        *(f"  %x{c} = phi {vector} [<{ones}>, %entry], [%y{c}, %loop]" for c in chains),
        *(
            f"  %y{c} = call {vector} {name}({vector} %x{c}, {vector} <{ones}>, {vector} <{ones}>)"
            for c in chains
        ),
        "  %next = add i64 %i, 1",
        "  %more = icmp slt i64 %next, %n",
        "  br i1 %more, label %loop, label %done",
        "done:",
    ]
    for c in chains:
        lines.append(f"  %p{c} = getelementptr {vector}, ptr %out, i64 {c}")
        lines.append(f"  store {vector} %y{c}, ptr %p{c}, align {8 * width}")
    return "\n".join([*lines, "  ret void", "}"])


def per_step(body: Body) -> int:
    """Number of operations in the formulas of one step, including error estimates.

    The control of steps is not included; a division is one operation.
    """
    table = explicit()
    rows = (*table.a, table.b, table.e3, table.e5)
    products = sum(sum(w != 0 for w in row) for row in rows)
    return len(table.a) * sum(operations(body).values()) + 2 * products * body.size


def reached(body: Body, tolerance: float = 1e-11, count: int = 1024) -> float:
    """Operations per second of the engine on one core."""
    starts = body.starts(3, count)
    flow = batch_integrator(body.system, tolerance=tolerance)
    spent = []
    for _ in range(TURNS):
        began = time.process_time()
        found = flow.propagate(starts, [body.span], threads=1)
        spent.append(time.process_time() - began)
    return float(per_step(body) * found.steps.sum() / np.median(spent))

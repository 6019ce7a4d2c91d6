"""Vector instructions run on arrays of numbers, for tests of what is written in them."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from typing import Any

import mpmath
import numpy as np

from flowlanes.flow.machine_code.arithmetic import Arithmetic
from flowlanes.flow.machine_code.ir_writer import IRWriter
from flowlanes.flow.machine_code.jit import aligned_zeros, load_code

HEAD = "void @numbers(ptr %given, ptr %found, i64 %count)"


def run(
    arithmetic: Callable[[IRWriter], Any],
    lanes: int,
    build: Callable[[Arithmetic[Any], Sequence[Any]], Sequence[Any]],
    given: np.ndarray,
) -> np.ndarray:
    """What instructions make of numbers.

    Parameters
    ----------
    arithmetic : Double or Pair
    lanes : int
    build : callable
        Writes the instructions: from an arithmetic and the values of variables to results.
    given : ndarray (n, variables, words)

    Returns
    -------
    ndarray (n, results, words)
    """
    w = IRWriter(lanes)
    number = arithmetic(w)
    n, variables, words = given.shape
    with w.count("%count") as block:
        at = w.emit(f"mul i64 {block}, {variables}")
        places = [w.emit(f"add i64 {at}, {i}") for i in range(variables)]
        results = build(number, [number.load("%given", place) for place in places])
        at = w.emit(f"mul i64 {block}, {len(results)}")
        for i, result in enumerate(results):
            number.store(result, "%found", w.emit(f"add i64 {at}, {i}"))
    text = w.text(HEAD, "#0")
    pointer = ctypes.c_void_p
    native = load_code(text, lambda: (text, 0), {"numbers": (pointer, pointer, ctypes.c_int64)})

    blocks = -(-n // lanes)
    filled = np.concatenate([given, np.ones((blocks * lanes - n, variables, words))])
    source = aligned_zeros(filled.size)
    source[:] = filled.reshape(blocks, lanes, variables, words).transpose(0, 2, 3, 1).ravel()
    target = aligned_zeros(blocks * lanes * len(results) * words)
    native.functions["numbers"](source.ctypes.data, target.ctypes.data, blocks)
    made = target.reshape(blocks, len(results), words, lanes).transpose(0, 3, 1, 2)
    return np.ascontiguousarray(made.reshape(-1, len(results), words)[:n])


def exact(words: np.ndarray) -> Any:
    """A number of one double or two with all its digits (mpmath)."""
    return mpmath.fsum(map(float, words))


def pairs(values: Sequence[Any]) -> np.ndarray:
    """Numbers of mpmath as pairs of doubles (n, 2)."""
    heads = np.array([float(v) for v in values])
    return np.stack([heads, [float(v - h) for v, h in zip(values, heads, strict=True)]], axis=1)

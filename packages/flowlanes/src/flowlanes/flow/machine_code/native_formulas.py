"""Formulas as one compiled function of states and parameters."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import accumulate

import numpy as np

from ...formulas.graph import Term
from ...system.arrays import FloatArray
from . import code_cache
from .arithmetic import Double
from .codegen import functions
from .jit import Native, code_name, link, object_code

_P = ctypes.c_void_p
SIGNATURE = (ctypes.c_int64, _P, _P, _P, _P)

_LOOP = """
define void @{name}(i64 %count, ptr %states, ptr %parameters, ptr %results, ptr %work) {{
entry:
  call void @prepare_{name}(ptr %work, ptr %parameters)
  br label %head
head:
  %i = phi i64 [ 0, %entry ], [ %next, %body ]
  %on = icmp slt i64 %i, %count
  br i1 %on, label %body, label %end
body:
  %s = mul i64 %i, {size}
  %r = mul i64 %i, {count}
  %state = getelementptr double, ptr %states, i64 %s
  %result = getelementptr double, ptr %results, i64 %r
  call void @values_{name}(ptr %result, ptr %state, ptr %work)
  %next = add i64 %i, 1
  br label %head
end:
  ret void
}}
"""


@dataclass(frozen=True)
class FormulaShape:
    """Sizes of a compiled function.

    Attributes
    ----------
    size, count, work : int
        Number of state variables, number of values, and doubles of memory for a call.
    """

    size: int
    count: int
    work: int


@dataclass(frozen=True)
class NativeFormulas:
    """Terms as one compiled function.

    Attributes
    ----------
    shape : FormulaShape
    code : Native
    name : str
        Name of the function in the code.
    """

    shape: FormulaShape
    code: Native = field(repr=False)
    name: str

    def __call__(self, states: FloatArray, parameters: FloatArray) -> FloatArray:
        """Values (count,) or (count, n) at a state (size,) or at states (size, n).

        NaN where a formula has no real value.
        """
        rows = np.asarray(states, dtype=float).T
        many = 1 if rows.ndim == 1 else len(rows)
        # One array for everything, because the address of a NumPy array takes longer than a
        # formula.
        ends = list(accumulate((rows.size, len(parameters), many * self.shape.count)))
        memory = np.empty(ends[2] + self.shape.work)
        memory[: ends[0]] = rows.ravel()
        memory[ends[0] : ends[1]] = parameters
        first = memory.ctypes.data
        self.code.functions[self.name](many, first, *(first + 8 * end for end in ends))
        results = memory[ends[1] : ends[2]]
        return results if rows.ndim == 1 else results.reshape(many, self.shape.count).T


def emit_formulas(name: str, terms: Sequence[Term], size: int) -> tuple[str, FormulaShape]:
    """Emit a function called `name` that computes terms.

    Parameters
    ----------
    name : str
    terms : sequence of Term
    size : int
        Number of state variables.
    """
    pieces, constants = functions(Double, {f"values_{name}": terms}, 1, f"prepare_{name}")
    loop = _LOOP.format(name=name, size=size, count=len(terms))
    return pieces + loop, FormulaShape(size, len(terms), max(constants, 1))


def native_formulas(key: str, size: int, terms: Callable[[], Sequence[Term]]) -> NativeFormulas:
    """Formulas, compiled or from the cache.

    Parameters
    ----------
    key : str
        Text that contains everything on which the terms depend.
    size : int
        Number of state variables.
    terms : callable
        Returns the terms; it is called only if the code is not in the cache.
    """
    name = code_name(f"formulas {size} {key}")

    def compute() -> tuple[bytes, FormulaShape]:
        text, shape = emit_formulas("evaluate", terms(), size)
        return object_code(text), shape

    (code, shape), from_cache = code_cache.cached_entry(name, compute)
    native = Native(*link(name, code, {"evaluate": SIGNATURE}), from_cache)
    return NativeFormulas(shape, native, "evaluate")

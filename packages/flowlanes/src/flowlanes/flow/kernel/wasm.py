"""Compilation of LLVM code to WebAssembly, the machine code of web pages.

The code is that of :mod:`flowlanes.flow.machine_code.codegen`, in vectors of one or two lanes.
WebAssembly has no fused multiply-add, so the last bits differ from native code.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache

import llvmlite.binding as llvm

from ...formulas.graph import Term
from ..machine_code import code_cache as cache
from ..machine_code.arithmetic import WithoutFused
from ..machine_code.codegen import functions
from ..machine_code.ir_writer import IRWriter
from ..machine_code.jit import ATTRIBUTES, optimised_object
from ..machine_code.wasm_object import module_of_object
from .equations import Equations
from .runge_kutta import runge_kutta_loop
from .tableaux import arithmetic_and_method

_FEATURES = "+simd128,+bulk-memory,+sign-ext,+nontrapping-fptoint"


@lru_cache
def _machine() -> llvm.TargetMachine:
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple("wasm32-unknown-unknown")
    return target.create_target_machine(features=_FEATURES, opt=2, reloc="static")


def wasm_module(texts: Sequence[str], exports: Sequence[str]) -> bytes:
    """Compile functions to a WebAssembly module.

    Parameters
    ----------
    texts : sequence of str
        Functions in the language of LLVM, with different names.
    exports : sequence of str
        Functions that can be called from outside.

    Returns
    -------
    bytes
        Module that imports a memory, ``env.memory``.
    """
    text = "\n".join(texts)
    # WebAssembly has neither of these; its own minimum also propagates NaN.
    text = text.replace("@llvm.fma.", "@llvm.fmuladd.")
    text = re.sub(r"@llvm\.(min|max)num\.", r"@llvm.\1imum.", text)
    name = cache.code_name("wasm", _FEATURES, str(llvm.llvm_version_info), text)
    code, _ = cache.cached_entry(name, lambda: optimised_object(text + ATTRIBUTES, _machine()))
    return module_of_object(code, exports)


def with_prefix(prefix: str, text: str) -> str:
    """Add a prefix to all function names, so that several codes can be combined."""
    return re.sub(r"@(?!llvm\.)(\w+)", rf"@{prefix}_\1", text)


def emit_integration_loop(
    prefix: str, equations: Equations, lanes: int, tolerance: float
) -> tuple[str, int]:
    """Code of the loop ``<prefix>_march`` for a tolerance, and its memory in doubles."""
    _, method = arithmetic_and_method("double", tolerance)
    text, work = runge_kutta_loop(WithoutFused, method, equations, lanes)
    return with_prefix(prefix, text), work


def emit_row_functions(
    prefix: str, pieces: Mapping[str, Sequence[Term]], inputs: int
) -> tuple[str, dict[str, str], int]:
    """Functions that evaluate formulas on many rows.

    ``<prefix>_<piece>_rows(n, rows, parameters, results, work)`` computes n rows of results from n
    rows of `inputs` numbers.

    Parameters
    ----------
    prefix : str
    pieces : mapping of str to sequence of Term
    inputs : int
        Number of values in a row.

    Returns
    -------
    text : str
    names : dict of str to str
        Name of the function of each piece.
    work : int
        Number of doubles of memory for a call.
    """
    text, constants = functions(WithoutFused, pieces, 1)
    names = {piece: f"{prefix}_{piece}_rows" for piece in pieces}
    loops = [_rows_loop(piece, inputs, len(terms)) for piece, terms in pieces.items()]
    return with_prefix(prefix, "\n".join([text, *loops])), names, max(constants, 1)


def _rows_loop(piece: str, inputs: int, outputs: int) -> str:
    w = IRWriter(1)
    w.line("call void @prepare(ptr %work, ptr %parameters)")
    with w.count("%rows") as i:
        row = w.address("double", "%states", w.emit(f"mul i64 {i}, {inputs}"))
        result = w.address("double", "%results", w.emit(f"mul i64 {i}, {outputs}"))
        w.line(f"call void @{piece}(ptr {result}, ptr {row}, ptr %work)")
    head = (
        f"void @{piece}_rows(i64 %rows, ptr noalias %states, ptr noalias %parameters, "
        "ptr noalias %results, ptr noalias %work)"
    )
    return w.text(head, "#0")

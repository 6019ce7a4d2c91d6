"""Machine code from text: compiled for this processor, kept on disk, called without a lock."""

from __future__ import annotations

import ctypes
import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import llvmlite
import llvmlite.binding as llvm
import numpy as np

from . import code_cache as cache

__all__ = ["Native", "aligned", "load_code", "width"]

_ATTRIBUTES = """
attributes #0 = { nounwind "prefer-vector-width"="512" "min-legal-vector-width"="512" }
attributes #1 = { nounwind "prefer-vector-width"="512" "min-legal-vector-width"="512" }
"""


@dataclass(frozen=True)
class Native:
    """Compiled functions.

    Attributes
    ----------
    functions : dict of str to callable
        C functions by name; they return nothing and release Python's lock.
    room : int
        Doubles of memory that a call needs.
    keeper : object
        What keeps the code in memory.
    found : bool
        Whether it came from the cache.
    """

    functions: dict[str, Callable[..., None]]
    room: int
    keeper: Any
    found: bool


@lru_cache
def _machine() -> Any:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(
        cpu=llvm.get_host_cpu_name(),
        features=llvm.get_host_cpu_features().flatten(),
        opt=2,
        reloc="pic",
        codemodel="small",
    )


@lru_cache
def _linker() -> Any:
    return llvm.create_lljit_compiler(_machine())


@lru_cache
def width() -> int:
    """Doubles in two registers of this processor, which keeps its pipelines full."""
    features = llvm.get_host_cpu_features()
    if features.get("avx512f"):
        return 16
    return 8 if features.get("avx") else 4


def _processor() -> str:
    """What code is made for."""
    return " ".join(
        (
            llvm.get_default_triple(),
            llvm.get_host_cpu_name(),
            llvm.get_host_cpu_features().flatten(),
            *map(str, llvm.llvm_version_info),
            llvmlite.__version__,
        )
    )


def _compile(text: str) -> bytes:
    module = llvm.parse_assembly(text + _ATTRIBUTES)
    machine = _machine()
    module.triple = machine.triple
    module.data_layout = str(machine.target_data)
    options = llvm.create_pipeline_tuning_options(speed_level=1)
    options.loop_vectorization = options.slp_vectorization = options.loop_unrolling = False
    builder = llvm.create_pass_builder(machine, options)
    passes = llvm.create_new_module_pass_manager()
    passes.add_sroa_pass()
    passes.add_instruction_combine_pass()
    passes.add_simplify_cfg_pass()
    passes.run(module, builder)
    code: bytes = machine.emit_object(module)
    return code


_numbers = itertools.count()


def load_code(
    key: str, text: Callable[[], tuple[str, int]], signatures: dict[str, Sequence[Any]]
) -> Native:
    """Functions of a text, compiled or fetched from the cache.

    Parameters
    ----------
    key : str
        All that the text depends on.
    text : callable
        Gives the text, and the doubles of memory that a call needs; asked only when the code is
        not in the cache.
    signatures : dict of str to sequence of ctypes types
        Of each function that is to be called from Python.
    """
    name = cache.code_name(key, _processor())

    def make() -> tuple[bytes, int]:
        written, room = text()
        return _compile(written), room

    (code, room), found = cache.remember(name, make)
    library = llvm.JITLibraryBuilder().add_object_img(code).add_current_process()
    for symbol in signatures:
        library = library.export_symbol(symbol)
    tracker = library.link(_linker(), f"{name}_{next(_numbers)}")
    functions: dict[str, Callable[..., None]] = {
        symbol: ctypes.CFUNCTYPE(None, *arguments)(tracker[symbol])
        for symbol, arguments in signatures.items()
    }
    return Native(functions, room, tracker, found)


def aligned(doubles: int) -> Any:
    """Zeros at an address that any vector accepts."""
    room = np.zeros(doubles + 8)
    shift = (-room.ctypes.data // 8) % 8
    return room[shift : shift + doubles]

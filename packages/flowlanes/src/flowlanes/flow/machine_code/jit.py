"""Compilation of LLVM text for this processor, with a cache on disk and calls without the GIL."""

from __future__ import annotations

import ctypes
import itertools
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import llvmlite
import llvmlite.binding as llvm
import numpy as np

from ...system.arrays import FloatArray
from . import code_cache as cache

#: Argument types of the functions.
ATTRIBUTES = """
attributes #0 = { nounwind "prefer-vector-width"="512" "min-legal-vector-width"="512" }
attributes #1 = { nounwind "prefer-vector-width"="512" "min-legal-vector-width"="512" }
"""


@dataclass(frozen=True)
class Native:
    """Compiled functions.

    Attributes
    ----------
    functions : dict of str to callable
        C functions by name; they return nothing and release the GIL.
    keeper : object
        Object that keeps the code in memory.
    from_cache : bool
        True if the code was read from the cache.
    work_size : int
        Number of doubles of memory for a call.
    """

    functions: dict[str, Callable[..., None]]
    keeper: object
    from_cache: bool
    work_size: int = 0


@dataclass(frozen=True)
class InstructionSets:
    """Instruction sets that code may use.

    Attributes
    ----------
    features : str
        LLVM names such as ``"+avx2,-avx512f"``.
    width : int
        Number of doubles in two registers, which is enough to keep the pipelines full.
    """

    features: str
    width: int


def instruction_sets(*left_out: str) -> InstructionSets:
    """Instruction sets of this processor, with some removed to emulate an older one.

    Parameters
    ----------
    *left_out : str
        Prefixes of LLVM names to be removed: ``"avx512"`` leaves AVX2.
    """
    known = llvm.get_host_cpu_features()
    for name in known:
        known[name] = known[name] and not name.startswith(left_out)
    width = 16 if known.get("avx512f") else 8 if known.get("avx") else 4
    return InstructionSets(known.flatten(), width)


@lru_cache
def host() -> InstructionSets:
    """All instruction sets of this processor."""
    return instruction_sets()


@lru_cache
def _machine(sets: InstructionSets) -> llvm.TargetMachine:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(
        cpu=llvm.get_host_cpu_name(),
        features=sets.features,
        # With level 2, compilation takes a sixth longer and the code is not faster.
        opt=1,
        reloc="pic",
        codemodel="small",
    )


@lru_cache
def _linker() -> llvm.LLJIT:
    # The older linker of LLVM places code and constants anywhere and aborts the process if they
    # are more than 2 GiB apart; the newer one keeps them together, but does not support Windows.
    together = sys.platform != "win32"
    return llvm.create_lljit_compiler(_machine(instruction_sets()), use_jit_link=together)


def width() -> int:
    """Number of doubles in a vector of the code for this processor."""
    return host().width


def _processor(sets: InstructionSets) -> str:
    """Target of the code: processor, instruction sets, LLVM version."""
    return " ".join(
        (
            llvm.get_default_triple(),
            llvm.get_host_cpu_name(),
            sets.features,
            *map(str, llvm.llvm_version_info),
            llvmlite.__version__,
        )
    )


def optimise(text: str, machine: llvm.TargetMachine) -> llvm.ModuleRef:
    """Parse and optimise LLVM assembly text for a machine."""
    module = llvm.parse_assembly(text)
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
    return module


def optimised_object(text: str, machine: llvm.TargetMachine) -> bytes:
    """Object file of LLVM assembly text for a machine."""
    code: bytes = machine.emit_object(optimise(text, machine))
    return code


_numbers = itertools.count()


def load_code(
    key: str,
    text: Callable[[], tuple[str, int]],
    signatures: Mapping[str, Sequence[type]],
) -> Native:
    """Functions given as LLVM assembly text, compiled or from the cache.

    Parameters
    ----------
    key : str
        Text that contains everything on which the code depends.
    text : callable
        Returns the assembly text, and the number of doubles of memory for a call; it is called
        only if the code is not in the cache.
    signatures : mapping of str to sequence of ctypes types
        Argument types of each function that is called from Python.
    """
    name = code_name(key)

    def compute() -> tuple[bytes, int]:
        assembly, work_size = text()
        return object_code(assembly), work_size

    (code, work_size), from_cache = cache.cached_entry(name, compute)
    return Native(*link(name, code, signatures), from_cache, work_size)


def code_name(key: str) -> str:
    """Cache name of code that depends on a key, for this processor."""
    return cache.code_name(key, _processor(host()))


def object_code(text: str) -> bytes:
    """Object file of functions in LLVM assembly text, for this processor."""
    return optimised_object(text + ATTRIBUTES, _machine(host()))


def link(
    name: str, code: bytes, signatures: Mapping[str, Sequence[type]]
) -> tuple[dict[str, Callable[..., None]], object]:
    """Link an object file; also return an object that keeps its code alive.

    Parameters
    ----------
    name : str
    code : bytes
    signatures : mapping of str to sequence of ctypes types
    """
    library = llvm.JITLibraryBuilder().add_object_img(code).add_current_process()
    for symbol in signatures:
        library = library.export_symbol(symbol)
    tracker = library.link(_linker(), f"{name}_{next(_numbers)}")
    functions: dict[str, Callable[..., None]] = {
        symbol: ctypes.CFUNCTYPE(None, *arguments)(tracker[symbol])
        for symbol, arguments in signatures.items()
    }
    return functions, tracker


def aligned_zeros(doubles: int) -> FloatArray:
    """Zeros at an address that is aligned for any vector."""
    memory = np.zeros(doubles + 8)
    shift = (-memory.ctypes.data // 8) % 8
    return memory[shift : shift + doubles]

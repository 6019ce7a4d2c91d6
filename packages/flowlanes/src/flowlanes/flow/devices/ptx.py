"""Compile LLVM code to PTX, the assembly language of NVIDIA's graphics processors.

The driver translates PTX for the device.  All operations are rounded as on CPUs (IEEE 754), and
products and sums are fused only where the code prescribes it: instructions have
``.rn``, which forbids contraction.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import llvmlite
import llvmlite.binding as llvm

from ..machine_code import code_cache as cache
from ..machine_code.jit import optimise

#: The oldest architecture that current drivers support (Turing).
ARCHITECTURE = "sm_75"


@lru_cache
def _machine() -> llvm.TargetMachine:
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple("nvptx64-nvidia-cuda")
    return target.create_target_machine(cpu=ARCHITECTURE, opt=3)


def compile_ptx(text: str) -> str:
    """Compile LLVM code to PTX."""
    machine = _machine()
    ptx: str = machine.emit_assembly(optimise(text, machine))
    return ptx


def cached_ptx(key: str, text: Callable[[], str]) -> str:
    """PTX for LLVM code, compiled or from the cache.

    Parameters
    ----------
    key : str
        All that the text depends on.
    text : callable
    """
    versions = (ARCHITECTURE, *map(str, llvm.llvm_version_info), llvmlite.__version__)
    ptx, _ = cache.cached_entry(cache.code_name(key, *versions), lambda: compile_ptx(text()))
    return ptx

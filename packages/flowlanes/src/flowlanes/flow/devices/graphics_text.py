"""LLVM code of the integration loop for one thread of a graphics processor.

The code is that of a single vector lane.  Threads take motions from a shared counter, so none waits
for its neighbours.  Everything that a thread does between steps happens within one loop, so the
threads of a warp take their steps together.
"""

from __future__ import annotations

from collections.abc import Iterator

from ..kernel.equations import Equations
from ..kernel.runge_kutta import RungeKuttaLoop
from ..kernel.tableaux import Explicit
from ..machine_code.arithmetic import Arithmetic, V

#: Name of the kernel function.
ENTRY = "march"

_HEAD = (
    f"ptx_kernel void @{ENTRY}(ptr noalias %counter, i64 %last, ptr noalias %starts, "
    "ptr noalias %values, i64 %stride, ptr noalias %times, i64 %wanted, double %tolerance, "
    "i64 %limit, ptr noalias %states, ptr noalias %moments, ptr noalias %counts, "
    "ptr noalias %outcome, ptr noalias %ended, ptr noalias %taken)"
)

# Calls instead of a dozen inlined copies of the rates: this leaves more registers, and the code
# stays in the instruction cache.
_ATTRIBUTES = """
attributes #0 = { nounwind }
attributes #1 = { nounwind noinline }
"""


class _ThreadLoop(RungeKuttaLoop[V]):
    """Generates the loop of one thread."""

    def write(self) -> str:
        """The complete LLVM code."""
        w = self.w
        w.entry.append(f"  %work = alloca [{self.space.size} x {w.type}], align 64")
        self.start_lanes()
        with w.forever() as leave:
            with w.branch(self._in_event()):
                self.attend()
            leave(w.emit(f"xor i1 {w.any(self.live())}, true"))
            with w.branch(w.any(w.compare("ogt", self.get("fresh"), w.constant(0.0)))):
                self.begin_fresh()
            # A rejected start has an event before its first step.
            with w.branch(w.emit(f"xor i1 {self._in_event()}, true")):
                self.step()
        return "\n".join((self.pieces, w.text(_HEAD, "#0"), _ATTRIBUTES))

    def variables(self, first: int, last: int) -> Iterator[int]:
        """Indices of some variables, unrolled: registers of a thread cannot be indexed."""
        yield from range(first, last)

    def _in_event(self) -> str:
        return self.w.any(self.w.compare("ogt", self.get("event"), self.w.constant(0.0)))

    def next_index(self) -> str:
        """The index of the next motion, from a counter shared by all threads."""
        return self.w.emit("atomicrmw add ptr %counter, i64 1 monotonic, align 8")


def thread_loop(arithmetic: type[Arithmetic[V]], method: Explicit, equations: Equations) -> str:
    """Generate the LLVM code of the loop.

    Parameters
    ----------
    arithmetic : Double or Pair
    method : Explicit
    equations : Equations
    """
    return _ThreadLoop(arithmetic, method, equations, 1).write()

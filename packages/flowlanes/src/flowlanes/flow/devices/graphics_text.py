"""The loop over motions for one thread of a graphics processor.

The text is that of one vector lane.  Threads take motions from a counter that they share, so that
none waits for its neighbours; whatever a thread has to do between steps is done within one loop,
so that the threads of a warp take their steps together.
"""

from __future__ import annotations

from collections.abc import Iterator

from ..kernel.equations import Equations
from ..kernel.runge_kutta import RungeKuttaLoop
from ..kernel.tableaux import Explicit
from ..machine_code.arithmetic import Arithmetic, V

#: The name of the function that a graphics processor starts.
ENTRY = "march"

_HEAD = (
    f"ptx_kernel void @{ENTRY}(ptr noalias %counter, i64 %last, ptr noalias %starts, "
    "ptr noalias %values, i64 %stride, ptr noalias %times, i64 %wanted, double %tolerance, "
    "i64 %limit, ptr noalias %states, ptr noalias %moments, ptr noalias %counts, "
    "ptr noalias %outcome, ptr noalias %ended, ptr noalias %taken)"
)

# calls instead of a dozen copies of the rates: they leave more registers, and their code stays in
# the cache of instructions
_ATTRIBUTES = """
attributes #0 = { nounwind }
attributes #1 = { nounwind noinline }
"""


class _ThreadLoop(RungeKuttaLoop[V]):
    """The loop of one thread."""

    def write(self) -> str:
        """The whole text."""
        w = self.w
        w.entry.append(f"  %work = alloca [{self.space.size} x {w.type}], align 64")
        self.start_lanes()
        with w.forever() as leave:
            with w.branch(self._in_event()):
                self.attend()
            leave(w.emit(f"xor i1 {w.any(self.live())}, true"))
            with w.branch(w.any(w.compare("ogt", self.get("fresh"), w.constant(0.0)))):
                self.begin_fresh()
            # a start that is refused has an event before its first step
            with w.branch(w.emit(f"xor i1 {self._in_event()}, true")):
                self.step()
        return "\n".join((self.pieces, w.text(_HEAD, "#0"), _ATTRIBUTES))

    def variables(self, first: int, last: int) -> Iterator[int]:
        """The places of some variables, written out: registers of a thread have no index."""
        yield from range(first, last)

    def _in_event(self) -> str:
        return self.w.any(self.w.compare("ogt", self.get("event"), self.w.constant(0.0)))

    def next_index(self) -> str:
        """The number of the next trajectory, from the counter of all threads."""
        return self.w.emit("atomicrmw add ptr %counter, i64 1 monotonic, align 8")


def thread_loop(arithmetic: type[Arithmetic[V]], method: Explicit, equations: Equations) -> str:
    """The text of the loop in LLVM's language.

    Parameters
    ----------
    arithmetic : Double or Pair
    method : Explicit
    equations : Equations
    """
    return _ThreadLoop(arithmetic, method, equations, 1).write()

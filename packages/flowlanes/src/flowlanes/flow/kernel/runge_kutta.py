"""Explicit Runge–Kutta integration of many motions, with one motion per vector lane.

Every lane has its own time, step size and outcome.  When the motion of a lane has ended, the lane
takes the next motion of the batch, so all lanes are busy until few motions are left.  Lanes do not
affect each other.

Crossings of a section are located within the steps.  A step across the section is rejected;
instead the lane steps to the zero of the cubic interpolant, and refines it by Newton's method in
time until the remaining distance is below rounding.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Generic, TypeAlias

from ...formulas.graph import Term
from ..machine_code.arithmetic import Arithmetic, V, pair_of
from ..machine_code.codegen import Clock, functions
from ..machine_code.compensated import any_sum, fast_sum
from ..machine_code.ir_writer import IRWriter, literal
from .equations import Equations
from .hermite import crossing_step, double_crossing, side_after_crossing
from .outcomes import COLLAPSED, IN_VAIN, NOT_A_NUMBER, OVER, STATUS_MESSAGES, STEPS
from .tableaux import Explicit

#: Number of steps without a crossing after which a motion ends; a motion at rest never crosses.
MAX_STEPS_WITHOUT_CROSSING = 1e6

#: Safety factor for the error of the cubic interpolant, which is estimated at the stage near the
#: middle.
ERROR_MARGIN = 4.0

#: Tolerance of the deviations, relative to that of the motion.
LOOSER = 100.0

#: Indices of the variables that are summed, and their change divided by the step length.
Component: TypeAlias = tuple[Sequence[int | str], V | None]

#: Vectors that are kept in memory between steps.
_LANE_VECTORS = (
    "time target step floor saved g gdot g_here tries steps marked "
    "mode fault event fresh index samples"
)

# Events of a lane.
_SAMPLE, _POINT, _END = 1.0, 2.0, 3.0

# States of a lane.
_EMPTY, _RUNNING, _REFINING = 0.0, 1.0, 2.0


@dataclass
class Workspace:
    """Memory layout of one thread, in vectors."""

    size: int = 0
    places: dict[str, int] = field(default_factory=dict)

    def reserve(self, name: str, vectors: int = 1) -> int:
        """Reserve memory for some vectors."""
        self.places[name] = self.size
        self.size += vectors
        return self.places[name]


class RungeKuttaLoop(Generic[V]):
    """Generates the LLVM code of the integration loop.

    Parameters
    ----------
    arithmetic : Double or Pair
    method : Explicit
    equations : Equations
    lanes : int
        Number of motions in a vector.
    """

    def __init__(
        self, arithmetic: type[Arithmetic[V]], method: Explicit, equations: Equations, lanes: int
    ) -> None:
        self.w = IRWriter(lanes)
        self.n = arithmetic(self.w)
        self.method, self.equations = method, equations
        self.dimension = len(equations.rates)
        # Numbers of 30 digits need no rounding errors in addition.
        self.clock, self.pace = None, 0
        if equations.clock is not None and self.n.words == 1:
            place, self.pace = equations.clock
            self.clock = Clock("rates", place, self.dimension)
        self.pieces, constants = functions(
            arithmetic, equations.pieces, lanes, clock=self.clock, steady=method.steady
        )
        self.space = Workspace()
        words = self.n.words
        state = self.dimension + (self.clock is not None)
        for name, count in (
            ("y", state),
            ("rest", self.dimension),
            ("new", state),
            ("stage", state),
            ("rates", (len(method.b) + 1) * self.dimension),
            ("constants", max(constants, 1)),
            ("parameters", max(equations.parameters, 1)),
            ("section", 3),
            ("halfway", 3 if equations.choices else 1),
            ("choice", 3 if equations.choices else 0),
            ("flow", 2 * self.dimension if equations.choices else 0),
            ("guards", max(len(equations.guards), 1)),
            ("renewal", len(equations.renewal)),
        ):
            self.space.reserve(name, count * words)
        for name in _LANE_VECTORS.split():
            self.space.reserve(name)

    # --- places ------------------------------------------------------------------------------

    def place(self, name: str, number: int = 0) -> str:
        """The address of a number of an array."""
        vectors = self.space.places[name] + number * self.n.words
        return self.w.address(self.w.type, "%work", vectors)

    def get(self, name: str) -> str:
        """Load a vector that the lanes keep between steps."""
        return self.w.load(self.w.type, self.place(name))

    def put(self, name: str, value: str) -> None:
        """Store a vector that the lanes keep between steps."""
        self.w.store(self.w.type, value, self.place(name))

    def lane_address(self, name: str, lane: str) -> str:
        """Address of one lane of a vector."""
        return self.w.address("double", self.place(name), lane)

    def rates(self, stage: int, of: str) -> None:
        """Compute the rates of a stage."""
        to, state = self.place("rates", stage * self.dimension), self.place(of)
        self.w.line(f"call void @rates(ptr {to}, ptr {state}, ptr {self.place('constants')})")

    def evaluate_section(self, piece: str, of: str, stage: int) -> None:
        """Compute the section function at a state whose rates are those of a stage."""
        if not self.equations.choices:
            self.evaluate(piece, of)
            return
        w, n = self.w, self.n
        rates = self.place("rates", stage * self.dimension)
        for i in range(self.dimension):
            n.store(n.load(self.place(of), i), self.place("flow"), i)
            n.store(n.load(rates, i), self.place("flow"), self.dimension + i)
        for number, choice in enumerate(self.equations.choices):
            chosen = n.leading(n.load(self.place("parameters"), choice.parameter))
            mask = w.compare("ogt", chosen, w.constant(0.0))
            # Only sections chosen by some lane are computed.
            with w.branch(w.any(mask)):
                w.line(
                    f"call void @section_{number}(ptr {self.place('choice')}, "
                    f"ptr {self.place('flow')}, ptr {self.place('constants')})"
                )
                for k in range(3):
                    before, now = n.load(self.place(piece), k), n.load(self.place("choice"), k)
                    n.store(n.choose(mask, now, before), self.place(piece), k)

    def evaluate(self, piece: str, of: str) -> None:
        """Compute the section or the guards at a state."""
        self.w.line(
            f"call void @{piece}(ptr {self.place(piece)}, ptr {self.place(of)}, "
            f"ptr {self.place('constants')})"
        )

    # --- the loop ------------------------------------------------------------------------------

    def write(self) -> str:
        """The complete LLVM code."""
        w = self.w
        self.next = w.variable("i64", "%first")
        self.start_lanes()
        with w.forever() as leave:
            self.attend()
            leave(w.emit(f"xor i1 {w.any(self.live())}, true"))
            with w.branch(w.any(w.compare("ogt", self.get("fresh"), w.constant(0.0)))):
                self.begin_fresh()
            with w.forever() as pause:
                pause(w.any(w.compare("ogt", self.get("event"), w.constant(0.0))))
                self.step()
        head = (
            "void @march(i64 %first, i64 %last, ptr noalias %starts, ptr noalias %values, "
            "i64 %stride, ptr noalias %times, i64 %wanted, double %tolerance, i64 %limit, "
            "ptr noalias %states, ptr noalias %moments, ptr noalias %counts, "
            "ptr noalias %outcome, ptr noalias %ended, ptr noalias %taken, ptr noalias %work)"
        )
        return self.pieces + "\n" + w.text(head, "#0")

    def live(self) -> str:
        """Mask of lanes with a motion."""
        return self.w.compare("ogt", self.get("mode"), self.w.constant(_EMPTY))

    def start_lanes(self) -> None:
        """Clear the workspace and let all lanes request a motion."""
        w, zero = self.w, self.w.constant(0.0)
        with w.count(self.space.size) as i:
            w.store(w.type, zero, w.address(w.type, "%work", i))
        self.put("event", w.constant(_END))

    def attend(self) -> None:
        """Handle every lane in which an event has occurred."""
        w = self.w
        with w.count(w.lanes) as lane:
            event = w.load("double", self.lane_address("event", lane))
            with w.branch(w.emit(f"fcmp ogt double {event}, 0.0")):
                mode = w.load("double", self.lane_address("mode", lane))
                with w.branch(w.emit(f"fcmp ogt double {mode}, 0.0")):
                    self._leave_sample(lane, event)
                w.store("double", "0.0", self.lane_address("event", lane))
                mode = w.load("double", self.lane_address("mode", lane))
                with w.branch(w.emit(f"fcmp oeq double {mode}, 0.0")):
                    index = self.next_index()
                    with w.branch(w.emit(f"icmp slt i64 {index}, %last")):
                        self._take(lane, index)

    def next_index(self) -> str:
        """The index of the next motion; each index is returned only once."""
        w = self.w
        index = w.load("i64", self.next)
        w.store("i64", w.emit(f"add i64 {index}, 1"), self.next)
        return index

    def _take(self, lane: str, index: str) -> None:
        """Assign the next motion to a lane."""
        w, words = self.w, self.n.words
        w.store("i64", index, self.lane_address("index", lane))
        row = w.emit(f"mul i64 {index}, {self.dimension * words}")
        for i in range(self.dimension * words):
            value = w.load("double", w.address("double", w.address("double", "%starts", row), i))
            w.store("double", value, self._component("y", i, lane))
            w.store("double", "0.0", self._component("rest", i, lane))
        if self.clock is not None:
            w.store("double", "0.0", self._component("y", self.clock.rest, lane))
        row = w.emit(f"mul i64 {index}, %stride")
        for i in range(self.equations.parameters * words):
            value = w.load("double", w.address("double", w.address("double", "%values", row), i))
            w.store("double", value, self._component("parameters", i, lane))
        for name, value in (
            ("time", "0.0"),
            ("fault", "0.0"),
            ("samples", "0.0"),
            ("tries", "0.0"),
            ("steps", "0.0"),
            ("marked", "0.0"),
            ("mode", literal(_RUNNING)),
            ("fresh", "1.0"),
        ):
            w.store("double", value, self.lane_address(name, lane))
        w.store("double", w.load("double", "%times"), self.lane_address("target", lane))

    def _component(self, name: str, i: int, lane: str) -> str:
        place = self.w.address(self.w.type, "%work", self.space.places[name] + i)
        return self.w.address("double", place, lane)

    def _leave_sample(self, lane: str, event: str) -> None:
        """Store a sample, or end the motion."""
        w = self.w
        index = w.load("i64", self.lane_address("index", lane))
        done = w.emit(
            f"fptosi double {w.load('double', self.lane_address('samples', lane))} to i64"
        )
        over = w.emit(f"fcmp oeq double {event}, {literal(_END)}")
        with w.branch(w.emit(f"xor i1 {over}, true")):
            self._write_state(lane, index, done)
            done_now = w.emit(f"add i64 {done}, 1")
            w.store(
                "double",
                w.emit(f"sitofp i64 {done_now} to double"),
                self.lane_address("samples", lane),
            )
            w.store("i64", done_now, w.address("i64", "%counts", index))
            full = w.emit(f"icmp sge i64 {done_now}, %wanted")
            with w.branch(full):
                self._finish(lane, index)
            if self.equations.has_section:
                steps = w.load("double", self.lane_address("steps", lane))
                w.store("double", steps, self.lane_address("marked", lane))
            else:
                with w.branch(w.emit(f"xor i1 {full}, true")):
                    following = w.load("double", w.address("double", "%times", done_now))
                    w.store("double", following, self.lane_address("target", lane))
        with w.branch(over):
            self._finish(lane, index)

    def _finish(self, lane: str, index: str) -> None:
        w = self.w
        fault = w.emit(f"fptosi double {w.load('double', self.lane_address('fault', lane))} to i64")
        w.store("i64", fault, w.address("i64", "%outcome", index))
        w.store(
            "double",
            w.load("double", self.lane_address("time", lane)),
            w.address("double", "%ended", index),
        )
        steps = w.emit(f"fptosi double {w.load('double', self.lane_address('steps', lane))} to i64")
        w.store("i64", steps, w.address("i64", "%taken", index))
        w.store("double", literal(_EMPTY), self.lane_address("mode", lane))

    def _write_state(self, lane: str, index: str, row_number: str) -> None:
        """Store a state; on a section, first move it onto the section along the flow."""
        w, words = self.w, self.n.words
        row = w.emit(f"add i64 {w.emit(f'mul i64 {index}, %wanted')}, {row_number}")
        if self.equations.has_section:
            left = w.load("double", self.lane_address("saved", lane))
            now = w.load("double", self.lane_address("time", lane))
            w.store(
                "double", w.emit(f"fadd double {now}, {left}"), w.address("double", "%moments", row)
            )
        name, first, last = "y", 0, self.dimension
        if self.equations.renewal:
            name, first, last = "renewal", self.dimension, len(self.equations.renewal)
        recorded = (last - first) * words
        start = w.emit(f"mul i64 {row}, {recorded}")
        for i in range(recorded):
            value = w.load("double", self._component(name, first * words + i, lane))
            if self.equations.has_section:
                rate = w.load("double", self._component("rates", i, lane))
                value = w.emit(
                    f"call double @llvm.fma.f64(double {left}, double {rate}, double {value})"
                )
            w.store("double", value, w.address("double", w.address("double", "%states", start), i))

    def begin_fresh(self) -> None:
        """Initialise a lane before its first step."""
        w, n, zero = self.w, self.n, self.w.constant(0.0)
        fresh = w.compare("ogt", self.get("fresh"), zero)
        w.line(f"call void @prepare(ptr {self.place('constants')}, ptr {self.place('parameters')})")
        self.rates(0, "y")
        size, speed = w.constant(1e-12), w.constant(1e-300)
        for i in (i for group in self.equations.groups for i in group):
            y = n.leading(n.load(self.place("y"), i))
            k = n.leading(n.load(self.place("rates"), i))
            size, speed = w.call("fma", y, y, size), w.call("fma", k, k, speed)
        ratio = w.op("fdiv", size, speed)
        first = w.op("fmul", w.constant(1e-2), w.call("sqrt", ratio))
        # At an equilibrium no rate gives a time scale.
        index = "0" if self.equations.has_section else w.emit("sub i64 %wanted, 1")
        end = w.splat(w.load("double", w.address("double", "%times", index)))
        first = w.call("minnum", first, w.call("minnum", end, w.constant(1e6)))
        self.put("step", w.choose(fresh, first, self.get("step")))
        floor = w.op("fmul", w.constant(1e-12), first)
        self.put("floor", w.choose(fresh, floor, self.get("floor")))
        if self.equations.has_section:
            self.evaluate_section("section", "y", 0)
            g = n.leading(n.load(self.place("section"), 0))
            gdot = n.leading(n.load(self.place("section"), 1))
            # A start on the section is not a return.
            reach = w.op("fmul", w.op("fmul", w.constant(1e-8), first), w.call("fabs", gdot))
            close = w.compare("ole", w.call("fabs", g), reach)
            self.put(
                "g",
                w.choose(fresh, w.choose(close, side_after_crossing(w, gdot), g), self.get("g")),
            )
            self.put("g_here", w.choose(fresh, g, self.get("g_here")))
            self.put("gdot", w.choose(fresh, gdot, self.get("gdot")))
        if self.equations.guards:
            self.evaluate("guards", "y")
            self._notice_guards(fresh)
        bad = w.conjunction(fresh, w.complement(w.compare("ord", ratio, ratio)))
        self.put("fault", w.choose(bad, w.constant(float(NOT_A_NUMBER)), self.get("fault")))
        ended = w.conjunction(fresh, w.compare("ogt", self.get("fault"), zero))
        self.put("event", w.choose(ended, w.constant(_END), self.get("event")))
        self.put("fresh", zero)

    def _guard_masks(self) -> list[str]:
        """For each guard, the mask of lanes where it is not positive.

        NaN counts as not positive.
        """
        w, n = self.w, self.n
        places = range(len(self.equations.guards))
        values = [n.leading(n.load(self.place("guards"), i)) for i in places]
        return [w.compare("ule", value, w.constant(0.0)) for value in values]

    def _notice_guards(self, among: str, before: Sequence[str] = ()) -> str:
        """Mark lanes whose state violates a guard; return the mask of all others.

        `before` has the masks of guards that were violated earlier in the step.
        """
        w = self.w
        fine = "splat (i1 true)"
        fault = self.get("fault")
        for i, now in reversed(list(enumerate(self._guard_masks()))):
            passed = w.disjunction(now, before[i]) if before else now
            fine = w.conjunction(fine, w.complement(passed))
            code = w.constant(float(len(STATUS_MESSAGES) + i))
            fault = w.choose(w.conjunction(among, passed), code, fault)
        self.put("fault", fault)
        return fine

    def step(self) -> None:
        """Attempt one step in all lanes.

        In every lane, with the tableau (a, b, c) of `Explicit` and y the state at the time t,

            k_i = f(y + h Σ_{j<i} a_ij k_j),    y_new = y + h Σ_i b_i k_i.

        The two embedded error estimates e5 = Σ e5_i k_i and e3 = Σ e3_i k_i (sums of squares over
        the vectors of the state, each relative to its size) are combined as in DOP853 (Hairer,
        Nørsett, Wanner, Solving Ordinary Differential Equations I, section II.10),

            err² = h² e5⁴/(e5² + e3²/100),

        with the tolerance as unit.  A step is accepted if err ≤ 1, no guard is violated and, with a
        section, the section function is close enough to its cubic interpolant (`_wavering`).  The
        next step is h·min(5, max(0.2, 0.9 err^{−1/p})) with the order p of the method.

        Branches would serialize the lanes, so everything is computed in all lanes, and masks
        select the stored values: `moved` marks lanes whose step is accepted, `event` those that
        need attention afterwards, `fault` gives the reason for which a lane would end.  A step
        that would pass the next sample is shortened to end there exactly.  A motion ends if its
        step is below 1e-15 of the time, or after `limit` steps.
        """
        w, n, zero = self.w, self.n, self.w.constant(0.0)
        mode = self.get("mode")
        running = w.compare("oeq", mode, w.constant(_RUNNING))
        refining = w.compare("oeq", mode, w.constant(_REFINING))
        live = self.live()
        time, target, planned = self.get("time"), self.get("target"), self.get("step")
        left = w.op("fsub", target, time)
        last = w.conjunction(
            running, w.compare("oge", w.op("fmul", planned, w.constant(1.00001)), left)
        )
        step = w.choose(live, w.choose(last, left, planned), zero)
        arrived = w.op("fadd", time, step)
        # Use the difference of two clock values as the step, so that no time is lost by rounding.
        step_number = n.difference(arrived, time)
        halfway: list[str] = []
        step = n.leading(step_number)
        for stage in range(1, len(self.method.b)):
            for i in self.variables(0, self.dimension):
                value = self._after(step_number, self._sum(self.method.a[stage], i), i)
                n.store(value, self.place("stage"), i)
            self._set_clock("stage", step, sum(self.method.a[stage], Fraction(0)))
            if stage == self.method.halfway and self.equations.has_section:
                self.evaluate_section("halfway", "stage", 0)
            if stage == self.method.halfway and self.equations.guards:
                self.evaluate("guards", "stage")
                halfway = self._guard_masks()
            self.rates(stage, "stage")
        error = self._advance_all(step_number)
        self._set_clock("new", step, Fraction(1))
        last_stage = len(self.method.b)
        self.rates(last_stage, "new")
        allowed = w.conjunction(live, w.compare("ole", error, w.constant(1.0)))
        number = w.compare("ord", error, error)
        factor = w.op("fmul", w.constant(0.9), w.inverse_root(error, 2 * self.method.order))
        factor = w.choose(w.compare("ogt", factor, w.constant(0.2)), factor, w.constant(0.2))
        factor = w.choose(w.compare("olt", factor, w.constant(5.0)), factor, w.constant(5.0))
        factor = w.choose(number, factor, w.constant(0.2))
        if self.equations.has_section:
            self.evaluate_section("section", "new", last_stage)
            off, excess = self._wavering(step)
            slower = w.op("fmul", w.constant(0.9), w.inverse_root(excess, 8))
            factor = w.choose(w.compare("olt", slower, factor), slower, factor)
            allowed = w.conjunction(
                allowed, w.complement(w.compare("ogt", excess, w.constant(1.0)))
            )
        reason = w.choose(number, w.constant(float(COLLAPSED)), w.constant(float(NOT_A_NUMBER)))
        self.put("fault", w.choose(live, w.choose(allowed, zero, reason), self.get("fault")))
        if self.equations.guards:
            self.evaluate("guards", "new")
            fine = self._notice_guards(allowed, halfway)
            factor = w.choose(w.conjunction(allowed, w.complement(fine)), w.constant(0.5), factor)
            allowed = w.conjunction(allowed, fine)
        following = w.op("fmul", step, factor)
        # A shortened step does not reduce the planned one.
        short = w.conjunction(allowed, last)
        following = w.choose(short, w.call("maxnum", following, planned), following)
        moved = allowed
        event = w.choose(w.conjunction(allowed, last), w.constant(_SAMPLE), zero)
        if self.equations.has_section:
            over = w.conjunction(allowed, last)
            fault = w.choose(over, w.constant(float(OVER)), self.get("fault"))
            event = w.choose(over, w.constant(_END), zero)
            moved, following, event, fault = self._cross(
                step, running, refining, allowed, following, event, fault, off
            )
            self.put("fault", fault)
        floor = w.call("fma", w.call("fabs", time), w.constant(1e-15), self.get("floor"))
        tiny = w.compare("ole", w.call("fabs", following), floor)
        lost = w.conjunction(w.conjunction(live, w.complement(allowed)), tiny)
        steps = w.op("fadd", self.get("steps"), w.choose(live, w.constant(1.0), zero))
        self.put("steps", steps)
        limit = w.splat(w.emit("sitofp i64 %limit to double"))
        late = w.conjunction(
            w.compare("oeq", event, zero), w.conjunction(live, w.compare("oge", steps, limit))
        )
        self.put("fault", w.choose(late, w.constant(float(STEPS)), self.get("fault")))
        if self.equations.has_section:
            vain = w.op("fsub", steps, self.get("marked"))
            vain = w.conjunction(
                w.compare("oeq", event, zero),
                w.compare("oge", vain, w.constant(MAX_STEPS_WITHOUT_CROSSING)),
            )
            vain = w.conjunction(live, vain)
            self.put("fault", w.choose(vain, w.constant(float(IN_VAIN)), self.get("fault")))
            late = w.disjunction(late, vain)
        event = w.choose(w.disjunction(lost, late), w.constant(_END), event)
        self.put("step", w.choose(live, following, zero))
        self.put("event", event)
        self.put("time", w.choose(moved, w.choose(last, target, arrived), time))
        for i in self.variables(0, self.dimension):
            for name, source in (("y", "new"), ("rest", "stage")):
                value = n.choose(moved, n.load(self.place(source), i), n.load(self.place(name), i))
                n.store(value, self.place(name), i)
            fresh = n.load(self.place("rates", last_stage * self.dimension), i)
            chosen = n.choose(moved, fresh, n.load(self.place("rates"), i))
            n.store(chosen, self.place("rates"), i)
        self._keep_clock()
        if self.equations.renewal:
            at_sample = w.compare("oeq", event, w.constant(_SAMPLE))
            with w.branch(w.any(at_sample)):
                self._renew(at_sample)

    def _renew(self, at_sample: str) -> None:
        """Replace the numbers of some lanes by the new values after a sample."""
        n = self.n
        self.evaluate("renewal", "y")
        for i in range(self.dimension):
            if self.equations.renewal[i] is self.equations.graph.state(i):
                continue
            new = n.choose(at_sample, n.load(self.place("renewal"), i), self._y(i))
            n.store(new, self.place("y"), i)
            rest = n.load(self.place("rest"), i)
            n.store(n.choose(at_sample, n.number(Fraction(0)), rest), self.place("rest"), i)
        self._keep_clock()
        self.rates(0, "y")

    def _set_clock(self, of: str, step: str, share: Fraction) -> None:
        """Set the clock variable of a state to the time after a fraction of the step, exactly."""
        if self.clock is None:
            return
        n, pair, place = self.n, pair_of(self.n), self.clock.place
        now = tuple(n.leading(n.load(self.place(name), place)) for name in ("y", "rest"))
        passed = pair.mul(pair.number(share * self.pace), pair.whole(step))
        time, rest = pair.add((now[0], now[1]), passed)
        n.store(n.whole(time), self.place(of), place)
        n.store(n.whole(rest), self.place(of), self.clock.rest)
        if of == "new":
            n.store(n.whole(rest), self.place("stage"), place)

    def _keep_clock(self) -> None:
        """Store the rounding error of the time beside it."""
        if self.clock is not None:
            rest = self.n.load(self.place("rest"), self.clock.place)
            self.n.store(rest, self.place("y"), self.clock.rest)

    def variables(self, first: int, last: int) -> Iterator[int | str]:
        """Iterate over the indices of some variables, in a loop of the generated code."""
        with self.w.count(last, first) as i:
            yield i

    def _y(self, i: int | str) -> V:
        return self.n.load(self.place("y"), i)

    def _after(self, step: V, slope: V, i: int | str) -> V:
        """The value of a variable at a stage, reached with a given slope."""
        n = self.n
        if not self.method.steady:
            return n.multiply_add(step, slope, self._y(i))
        rest = n.load(self.place("rest"), i)
        return n.add(self._y(i), n.multiply_add(step, slope, rest))

    def _sum(self, weights: Sequence[Fraction], *members: int | str) -> V:
        """A weighted sum over the stages of the rates of one or several variables."""
        n = self.n
        total = None
        for stage, weight in enumerate(weights):
            if weight == 0:
                continue
            rates = self.place("rates", stage * self.dimension)
            k = n.load(rates, members[0])
            for i in members[1:]:
                k = n.plus(k, n.load(rates, i))
            a = n.number(weight)
            total = n.mul(a, k) if total is None else n.multiply_add(a, k, total)
        assert total is not None
        return total

    def _weighted_rates(
        self, weights: Sequence[Fraction], result: V | None, *members: int | str
    ) -> V:
        """A weighted sum of rates, computed from the sum of the result if few weights differ."""
        others = [weight - b for weight, b in zip(weights, self.method.b, strict=True)]
        nothing = Fraction(0)
        if result is None or others.count(nothing) <= list(weights).count(nothing):
            return self._sum(weights, *members)
        return self.n.add(result, self._sum(others, *members))

    def _advance(self, step: V, i: int | str) -> V:
        """Store the new value of a variable and its rounding error.

        Return its change divided by the step length.
        """
        n = self.n
        if self.method.steady:
            return self._advance_steadily(step, i)
        y = self._y(i)
        result = self._sum(self.method.b, i)
        change = n.multiply_add(step, result, n.load(self.place("rest"), i))
        new = n.add(y, change)
        n.store(new, self.place("new"), i)
        n.store(n.sub(change, n.sub(new, y)), self.place("stage"), i)
        return result

    def _advance_steadily(self, step: V, i: int | str) -> V:
        """The same, with rounding only in the differences between stages before the final sum."""
        n, middle = self.n, self.method.middle
        slope = n.load(self.place("rates", middle * self.dimension), i)
        rest = n.load(self.place("rest"), i)
        others = n.number(Fraction(0))
        for stage, weight in enumerate(self.method.b):
            if weight != 0 and stage != middle:
                rate = n.load(self.place("rates", stage * self.dimension), i)
                others = n.multiply_add(n.number(weight), n.sub(rate, slope), others)
        most = n.mul(step, slope)
        lost = n.fma(step, slope, n.neg(most))
        change = n.multiply_add(step, others, n.add(rest, lost))
        total = any_sum(n, self._y(i), most)
        new = fast_sum(n, total.head, n.add(total.tail, change))
        n.store(new.head, self.place("new"), i)
        n.store(new.tail, self.place("stage"), i)
        return n.add(slope, others)

    def _group(self, step: V, group: Sequence[int]) -> Iterator[Component[V]]:
        """The components of a vector, with their new values."""
        for i in self.variables(group[0], group[-1] + 1):
            yield (i,), self._advance(step, i)

    def _deviations(self) -> Iterator[Component[V]]:
        """The components of the sum of all deviations."""
        for i in self.variables(0, len(self.equations.deviations)):
            first = self.equations.deviations[0]
            yield [self.w.emit(f"add i64 {i}, {place}") for place in first], None

    def _advance_all(self, step_number: V) -> str:
        """Compute the new state; return err², relative to the tolerance."""
        w, n = self.w, self.n
        step = n.leading(step_number)
        # The deviations follow the components of vectors.
        for i in self.variables(self.equations.groups[-1][-1] + 1, self.dimension):
            self._advance(step_number, i)
        fifth, third = w.constant(0.0), w.constant(0.0)
        square = w.op("fmul", step, step)
        # A variable that is close to zero is measured relative to 1e-6 of the acting variables, or,
        # at rest in the origin, to 1e-12 of their change in the step.
        whole, speed = w.constant(1e-200), w.constant(0.0)
        for i in self.equations.acting:
            y, k = n.leading(self._y(i)), n.leading(n.load(self.place("rates"), i))
            whole, speed = w.call("fma", y, y, whole), w.call("fma", k, k, speed)
        whole = w.op("fmul", whole, w.constant(1e-12))
        change = w.op("fmul", w.op("fmul", speed, square), w.constant(1e-24))
        whole = w.call("maxnum", whole, change)
        for group in self.equations.groups:
            e5, e3 = self._share(self._group(step_number, group), square, whole)
            fifth, third = w.op("fadd", fifth, e5), w.op("fadd", third, e3)
        if self.equations.deviations:
            # The equations are linear in the deviations, so the error of their sum represents all
            # of them.
            e5, e3 = self._share(self._deviations(), square, w.constant(1e-200))
            looser = w.constant(LOOSER**-2)
            fifth, third = w.call("fma", looser, e5, fifth), w.call("fma", looser, e3, third)
        # err² = h² e5⁴ / (e5² + e3²/100), relative to the tolerance, averaged over the groups.
        below = w.call("fma", third, w.constant(0.01), fifth)
        below = w.op("fadd", below, w.constant(1e-290))
        error = w.op("fdiv", w.op("fmul", fifth, w.op("fmul", fifth, square)), below)
        tolerance = w.emit("fmul double %tolerance, %tolerance")
        share = w.emit(f"fmul double {tolerance}, {literal(float(len(self.equations.groups)))}")
        return w.op("fdiv", error, w.splat(share))

    def _share(
        self, components: Iterator[Component[V]], square: str, floor: str
    ) -> tuple[str, str]:
        """The squares of both error estimates for a vector, relative to its size.

        Each component is the sum of some variables.
        """
        w, n = self.w, self.n
        sums = [w.variable(w.type, x) for x in (floor, *3 * [w.constant(0.0)])]
        for members, result in components:
            size, speed, e5, e3 = (w.load(w.type, x) for x in sums)
            y = self._register_sum([n.leading(self._y(i)) for i in members])
            k = self._register_sum([n.leading(n.load(self.place("rates"), i)) for i in members])
            size, speed = w.call("fma", y, y, size), w.call("fma", k, k, speed)
            # The sums cancel down to the tolerance, so double-doubles need all their digits here.
            a = n.leading(self._sum(self.method.e5, *members))
            b = n.leading(self._weighted_rates(self.method.e3, result, *members))
            e5, e3 = w.call("fma", a, a, e5), w.call("fma", b, b, e3)
            for x, value in zip(sums, (size, speed, e5, e3), strict=True):
                w.store(w.type, value, x)
        size, speed, e5, e3 = (w.load(w.type, x) for x in sums)
        share = w.op("fdiv", w.constant(1.0), w.call("fma", square, speed, size))
        return w.op("fmul", e5, share), w.op("fmul", e3, share)

    def _register_sum(self, values: Sequence[str]) -> str:
        total = values[0]
        for value in values[1:]:
            total = self.w.op("fadd", total, value)
        return total

    def _cross(
        self,
        step: str,
        running: str,
        refining: str,
        mask: str,
        following: str,
        event: str,
        fault: str,
        off: str,
    ) -> tuple[str, str, str, str]:
        """Detect crossings of the section, and steer the lanes to them.

        The section is g = 0.  A running lane whose g changes sign in the required direction rejects
        the step and becomes a refining lane: it steps to the zero of the cubic interpolant of g,
        then by −g/ġ (Newton's method in time) until this correction is below 1e-8 of a step; the
        rest, whose error is quadratically smaller, is made along the flow when the point is stored.
        If g has equal signs at both ends but its interpolant touches zero within its error
        (`double_crossing`), the step is shortened to the extremum, so that each half has at most
        one zero.  Refinement is abandoned after 12 attempts, as for a tangency; the motion then
        continues beyond.  After a crossing g is replaced by a tiny value of its new sign, so that
        the same zero is not found twice.
        """
        w, n, zero = self.w, self.n, self.w.constant(0.0)
        g, g_here, gdot = self.get("g"), self.get("g_here"), self.get("gdot")
        g_new = n.leading(n.load(self.place("section"), 0))
        gdot_new = n.leading(n.load(self.place("section"), 1))
        rises = w.conjunction(w.compare("olt", g, zero), w.compare("oge", g_new, zero))
        falls = w.conjunction(w.compare("ogt", g, zero), w.compare("ole", g_new, zero))
        x = float(sum(self.method.a[self.method.halfway]))
        slack = w.op("fmul", w.constant(ERROR_MARGIN / (x * (1 - x)) ** 2), w.call("fabs", off))
        dips, turn = double_crossing(w, step, g_here, g_new, gdot, gdot_new, slack)
        dips = w.conjunction(
            w.conjunction(running, mask),
            w.conjunction(dips, w.complement(w.disjunction(rises, falls))),
        )
        through = self._crossing_mask(rises, falls)
        crossed = w.conjunction(w.conjunction(running, mask), through)
        # Running lanes: stop before a crossing and go to it.
        moved = w.conjunction(mask, w.complement(w.disjunction(crossed, dips)))
        following = w.choose(dips, turn, following)
        event = w.choose(dips, zero, event)
        fault = w.choose(dips, zero, fault)
        place = w.variable(w.type, zero)
        with w.branch(w.any(crossed)):
            w.store(w.type, crossing_step(w, step, g, g_new, gdot, gdot_new), place)
        ahead = w.load(w.type, place)
        saved = self.get("saved")
        saved = w.choose(crossed, following, saved)
        following = w.choose(crossed, ahead, following)
        event = w.choose(crossed, zero, event)
        fault = w.choose(crossed, zero, fault)
        mode = w.choose(crossed, w.constant(_REFINING), self.get("mode"))
        tries = w.choose(crossed, zero, self.get("tries"))
        # Refining lanes: Newton's method in time.
        arrived = w.conjunction(refining, mask)
        left = w.op("fdiv", w.op("fneg", g_new), gdot_new)
        close = w.compare("ole", w.call("fabs", left), w.op("fmul", w.constant(1e-8), saved))
        there = w.conjunction(arrived, close)
        tries = w.choose(arrived, w.op("fadd", tries, w.constant(1.0)), tries)
        # Give up on a section that is only touched.
        stuck = w.conjunction(
            w.conjunction(arrived, w.complement(close)), w.compare("ogt", tries, w.constant(12.0))
        )
        following = w.choose(w.conjunction(arrived, w.complement(close)), left, following)
        counted = there
        if self.equations.where is not None or self.equations.choices:
            where = n.leading(n.load(self.place("section"), 2))
            counted = w.conjunction(there, w.compare("ogt", where, zero))
        back = w.disjunction(there, stuck)
        event = w.choose(counted, w.constant(_POINT), event)
        following = w.choose(back, saved, following)
        mode = w.choose(back, w.constant(_RUNNING), mode)
        # The remaining distance to the section, for the code that records the point.
        saved = w.choose(counted, left, saved)
        self.put("saved", saved)
        self.put("mode", mode)
        self.put("tries", tries)
        # A section that was just crossed must not be crossed again, but may be crossed back.
        self.put("g", w.choose(moved, w.choose(back, side_after_crossing(w, gdot_new), g_new), g))
        self.put("g_here", w.choose(moved, g_new, self.get("g_here")))
        self.put("gdot", w.choose(moved, gdot_new, gdot))
        return moved, following, event, fault

    def _crossing_mask(self, rises: str, falls: str) -> str:
        """The mask of crossings in the direction of the section."""
        w, direction = self.w, self.equations.direction
        if isinstance(direction, Term):
            way = self.n.leading(self.n.load(self.place("parameters"), direction.args[0]))
            up, down = (w.compare(r, way, w.constant(0.0)) for r in ("oge", "ole"))
            return w.disjunction(w.conjunction(rises, up), w.conjunction(falls, down))
        if direction == 0:
            return w.disjunction(rises, falls)
        return rises if direction > 0 else falls

    def _wavering(self, step: str) -> tuple[str, str]:
        """The distance of the section function from its cubic interpolant; and its relative square.

        If the relative distance is at most 1, the function has the zeros of the cubic; beyond, it
        may have turned unnoticed in between.
        """
        w, n = self.w, self.n
        x = float(sum(self.method.a[self.method.halfway]))
        g, rise = self.get("g_here"), w.op("fmul", step, self.get("gdot"))
        g_new = n.leading(n.load(self.place("section"), 0))
        rise_new = w.op("fmul", step, n.leading(n.load(self.place("section"), 1)))
        cubic = w.op("fmul", w.constant((1 + 2 * x) * (1 - x) ** 2), g)
        cubic = w.call("fma", w.constant(x * (1 - x) ** 2), rise, cubic)
        cubic = w.call("fma", w.constant(x * x * (3 - 2 * x)), g_new, cubic)
        cubic = w.call("fma", w.constant(x * x * (x - 1)), rise_new, cubic)
        off = w.op("fsub", n.leading(n.load(self.place("halfway"), 0)), cubic)
        ends = w.op("fadd", w.call("fabs", g), w.call("fabs", g_new))
        rises = w.op("fadd", w.call("fabs", rise), w.call("fabs", rise_new))
        allowed = w.call("fma", w.constant(0.02), rises, w.constant(1e-13))
        allowed = w.call("fma", w.constant(0.05), ends, allowed)
        share = w.op("fdiv", off, allowed)
        return off, w.op("fmul", share, share)


def runge_kutta_loop(
    arithmetic: type[Arithmetic[V]], method: Explicit, equations: Equations, lanes: int
) -> tuple[str, int]:
    """Generate the code of the loop; also return the number of doubles of memory it needs.

    Parameters
    ----------
    arithmetic : Double or Pair
    method : Explicit
    equations : Equations
    lanes : int
        Number of motions in a vector.
    """
    loop = RungeKuttaLoop(arithmetic, method, equations, lanes)
    return loop.write(), loop.space.size * lanes

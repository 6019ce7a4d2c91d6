"""LLVM code of the Gauss–Legendre integrator: one motion, with one SIMD lane per stage.

A step of length h from the state y solves the collocation equations

    k_i = f(y + h Σ_j a_ij k_j),    i = 1, …, s,    then    y ← y + h Σ_i b_i k_i

with the nodes, weights and matrix of `tableaux.gauss` (order 2s; Hairer, Lubich, Wanner,
Geometric Numerical Integration, sections II.1 and VIII.6).  They are solved by fixed-point
iteration, which contracts if h times the Lipschitz constant of f is below one, and starts from
the collocation polynomial of the previous step, extrapolated.  A step that does not converge is
repeated with a smaller h.  The error estimate is the highest Legendre coefficient of the rates
over the step.

The state is carried as an unevaluated sum of two doubles.  For 30 digits the stages are first
found to 16; each further iteration adds a correction so small that 16 digits of it suffice.

With 16 digits the state is orthogonally projected onto the level of its integrals every few steps,
with residuals computed to 32 digits.  Without this no method in doubles stays below its own
rounding errors.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from ...formulas.graph import Term
from ..machine_code.arithmetic import Arithmetic, Double, Pair, Registers, V
from ..machine_code.codegen import functions
from ..machine_code.ir_writer import IRWriter, literal
from .equations import Equations
from .outcomes import COLLAPSED, NOT_A_NUMBER, STATUS_MESSAGES, STEPS
from .projection_terms import ProjectionTerms
from .runge_kutta import Workspace
from .tableaux import Gauss

#: Number of steps between two projections.
EVERY = 4

#: Maximum number of iterations; then the step is repeated with half its length.
MOST = 60

#: Number of initial steps whose length follows the error estimate freely.
SETTLING = 8

#: A step is lengthened once the estimate has been below this fraction of its bound for this many
#: steps.  Otherwise the length stays constant, so that the extrapolated stages are good guesses.
ROOM_TO_LENGTHEN, STEPS_TO_LENGTHEN = 0.1, 32

#: Factor by which stage displacements are multiplied so that the change of the rates, a difference
#: of doubles, is far above rounding.
MAGNIFICATION = 2.0**20

#: Vectors used by the linear iteration.
_LINEAR = ("at_stage", "defect", "missing", "displacement")


class _LoopGenerator:
    """Generates the LLVM code of the loop."""

    def __init__(
        self, method: Gauss, equations: Equations, projection: ProjectionTerms | None, refine: bool
    ) -> None:
        self.method, self.equations, self.projection, self.refine = (
            method,
            equations,
            projection,
            refine,
        )
        self.stages = len(method.b)
        self.size = len(equations.rates)
        self.w = IRWriter(self.stages)
        self.thin = self.w.narrow()
        self.d, self.p = Double(self.w), Pair(self.w)
        self.d1, self.p1 = Double(self.thin), Pair(self.thin)
        self.texts: list[str] = []
        self.space = Workspace()
        wide = dict(equations.pieces)
        self._functions("wide", Double, wide, self.stages)
        self._functions("fine", Pair, {"fine_rates": equations.rates}, self.stages)
        if projection is not None:
            self._functions("exact", Pair, {"residuals": projection.residuals}, 1)
            self._functions("thin", Double, {"correct": projection.correction}, 1)
        count = 0 if projection is None else len(projection.residuals)
        self.space.reserve("y", 2 * (self.size + count))
        self.space.reserve("new", 2 * (self.size + count))
        self.space.reserve("point", self.size + count)
        self.space.reserve("left", 2 * max(count, 1))
        self.space.reserve("move", self.size)
        for name in (*("stage", "rates", "fresh", "before"), *_LINEAR):
            self._vectors(name, self.size)
        for name in ("fine_stage", "fine_rates", "fine_before"):
            self._vectors(name, 2 * self.size)
        self._vectors("guards", max(len(equations.guards), 1))

    def _vectors(self, name: str, count: int) -> None:
        """Allocate memory for vectors, aligned to their size."""
        self.space.size += -self.space.size % 8
        self.space.reserve(name, count * self.stages)

    def _functions(
        self,
        name: str,
        kind: type[Arithmetic[V]],
        pieces: dict[str, tuple[Term, ...]],
        lanes: int,
    ) -> None:
        text, constants = functions(kind, pieces, lanes, f"prepare_{name}")
        self.texts.append(text)
        # Vectors must be aligned to their size.
        self.space.size += -self.space.size % 8
        self.space.reserve(f"{name}_constants", max(constants, 1) * lanes * kind.words)
        self.space.reserve(
            f"{name}_parameters", max(self.equations.parameters, 1) * lanes * kind.words
        )

    def address(self, name: str, doubles: int | str = 0) -> str:
        """The address of a double in an array of the workspace."""
        base = self.w.address("double", "%work", self.space.places[name])
        return base if doubles == 0 else self.w.address("double", base, doubles)

    # --- the loop --------------------------------------------------------------------------------

    def write(self) -> str:
        w = self.w
        with w.count("%last", "%first") as index:
            self._motion(index)
        head = (
            "void @gauss(i64 %first, i64 %last, ptr noalias %starts, ptr noalias %values, "
            "i64 %stride, ptr noalias %times, i64 %wanted, double %tolerance, i64 %limit, "
            "ptr noalias %states, ptr noalias %outcome, ptr noalias %ended, ptr noalias %taken, "
            "ptr noalias %work)"
        )
        return "\n".join([*self.texts, w.text(head, "#0")])

    def _motion(self, index: str) -> None:
        w = self.w
        row = w.address("double", "%starts", w.emit(f"mul i64 {index}, {2 * self.size}"))
        for i in range(2 * self.size):
            w.store("double", w.load("double", w.address("double", row, i)), self.address("y", i))
        self._parameters(index)
        self.time = w.variable("double", "0.0")
        self.planned_step = w.variable("double", "0.0")
        self.last_step = w.variable("double", "0.0")
        self.outcome = w.variable("i64", "0")
        self.attempts = w.variable("i64", "0")
        self.calm = w.variable("i64", "0")
        self.accepted_steps = w.variable("i64", "0")
        self._targets()
        self._first_step()
        self.floor = w.variable(
            "double", self._scalar("fmul", w.load("double", self.planned_step), literal(1e-12))
        )
        with w.count("%wanted") as sample:
            target = w.load("double", w.address("double", "%times", sample))
            with w.forever() as leave:
                leave(w.emit(f"fcmp oge double {w.load('double', self.time)}, {target}"))
                leave(w.emit(f"icmp ne i64 {w.load('i64', self.outcome)}, 0"))
                self._step(target)
            fine = w.emit(f"icmp eq i64 {w.load('i64', self.outcome)}, 0")
            with w.branch(fine):
                self._project()
                number = w.emit(f"add i64 {w.emit(f'mul i64 {index}, %wanted')}, {sample}")
                row = w.address("double", "%states", w.emit(f"mul i64 {number}, {2 * self.size}"))
                for i in range(2 * self.size):
                    w.store(
                        "double",
                        w.load("double", self.address("y", i)),
                        w.address("double", row, i),
                    )
        w.store("i64", w.load("i64", self.outcome), w.address("i64", "%outcome", index))
        w.store("double", w.load("double", self.time), w.address("double", "%ended", index))
        w.store("i64", w.load("i64", self.attempts), w.address("i64", "%taken", index))

    def _scalar(self, op: str, a: str, b: str) -> str:
        return self.w.emit(f"{op} double {a}, {b}")

    def _parameters(self, index: str) -> None:
        """Load the parameters into all lanes, and compute everything that depends only on them."""
        w = self.w
        row = w.address("double", "%values", w.emit(f"mul i64 {index}, %stride"))
        uses: list[tuple[str, Double | Pair]] = [("wide", self.d), ("fine", self.p)]
        if self.projection is not None:
            uses += [("exact", self.p1), ("thin", self.d1)]
        for name, arithmetic in uses:
            base = self.address(f"{name}_parameters")
            for i in range(self.equations.parameters):
                words = [
                    arithmetic.writer.splat(w.load("double", w.address("double", row, 2 * i + k)))
                    for k in range(arithmetic.words)
                ]
                if isinstance(arithmetic, Double):
                    arithmetic.store(words[0], base, i)
                else:
                    arithmetic.store((words[0], words[1]), base, i)
            w.line(
                f"call void @prepare_{name}(ptr {self.address(f'{name}_constants')}, ptr {base})"
            )

    def _targets(self) -> None:
        """Store the values to be conserved: the residuals at the start."""
        if self.projection is None:
            return
        w = self.w
        count = len(self.projection.residuals)
        for k in range(2 * count):
            w.store("double", "0.0", self.address("y", 2 * self.size + k))
        self._residuals("y")
        for k in range(2 * count):
            value = w.load("double", self.address("left", k))
            w.store("double", value, self.address("y", 2 * self.size + k))

    def _residuals(self, of: str) -> None:
        self.w.line(
            f"call void @residuals(ptr {self.address('left')}, ptr {self.address(of)}, "
            f"ptr {self.address('exact_constants')})"
        )

    def _first_step(self) -> None:
        """Initial step length: a tenth of the time in which the state changes by its own size."""
        w = self.w
        for i in range(self.size):
            self.d.store(self._y(i), self.address("stage"), i)
        self._rates("rates", "stage")
        size, speed = w.constant(1e-12), w.constant(1e-300)
        for i in range(self.size):
            y, k = self.d.load(self.address("stage"), i), self.d.load(self.address("rates"), i)
            size, speed = w.call("fma", y, y, size), w.call("fma", k, k, speed)
        first = w.op("fmul", w.constant(0.1), w.call("sqrt", w.op("fdiv", size, speed)))
        # At an equilibrium no rate gives a time scale; use the last sample time.
        last = w.address("double", "%times", w.emit("sub i64 %wanted, 1"))
        first = w.call("minnum", first, w.splat(w.load("double", last)))
        w.store("double", self._first_lane(first), self.planned_step)

    def _first_lane(self, vector: str, lane: int = 0) -> str:
        return self.w.emit(f"extractelement {self.w.type} {vector}, i64 {lane}")

    def _y(self, i: int) -> str:
        return self.w.splat(self.w.load("double", self.address("y", 2 * i)))

    def _y_rest(self, i: int) -> str:
        return self.w.splat(self.w.load("double", self.address("y", 2 * i + 1)))

    def _rates(self, to: str, of: str) -> None:
        self.w.line(
            f"call void @rates(ptr {self.address(to)}, ptr {self.address(of)}, "
            f"ptr {self.address('wide_constants')})"
        )

    def _step(self, target: str) -> None:
        """Attempt one step."""
        w = self.w
        now, planned = w.load("double", self.time), w.load("double", self.planned_step)
        left = self._scalar("fsub", target, now)
        # Divide the remaining time into equal steps, so that the next step resembles the last one.
        ratio = self._scalar("fdiv", left, planned)
        count = self._call("ceil", self._scalar("fsub", ratio, literal(1e-6)))
        count = self._call("maxnum", count, "1.0")
        final = w.emit(f"fcmp ole double {count}, 1.0")
        arrived = self._scalar("fadd", now, self._scalar("fdiv", left, count))
        arrived = w.emit(f"select i1 {final}, double {target}, double {arrived}")
        # The step is the exact difference of two clock values, so that no time is lost.
        whole = self.p.difference(w.splat(arrived), w.splat(now))
        step = self._first_lane(whole[0])
        attempts = w.emit(f"add i64 {w.load('i64', self.attempts)}, 1")
        w.store("i64", attempts, self.attempts)
        self._guess(step)
        good = self._iterate(whole)
        self._judge(step, whole, arrived, good)
        with w.branch(w.emit(f"icmp sge i64 {attempts}, %limit")):
            w.store("i64", str(STEPS), self.outcome)

    def _call(self, name: str, *values: str) -> str:
        listed = ", ".join(f"double {v}" for v in values)
        return self.w.emit(f"call double @llvm.{name}.f64({listed})")

    def _guess(self, step: str) -> None:
        """Initial rates: extrapolated from the last step, or evaluated at the start."""
        w = self.w
        before = w.load("double", self.last_step)
        off = self._call("fabs", self._scalar("fsub", step, before))
        same = w.emit(f"fcmp ole double {off}, {self._scalar('fmul', step, literal(1e-3))}")
        with w.branch(same):
            columns = self._columns(self.method.ahead)
            for i in range(self.size):
                self.d.store(self._matrix_product(columns, "before", i), self.address("rates"), i)
        with w.branch(w.emit(f"xor i1 {same}, true")):
            for i in range(self.size):
                self.d.store(self._y(i), self.address("stage"), i)
            self._rates("rates", "stage")

    def _columns(self, matrix: Sequence[Sequence[Fraction]]) -> list[str]:
        """The columns of a matrix as vectors of doubles."""
        return [self._vector([float(row[j]) for row in matrix]) for j in range(self.stages)]

    def _vector(self, entries: Sequence[float]) -> str:
        return f"<{', '.join(f'double {literal(x)}' for x in entries)}>"

    def _exact_vector(self, entries: Sequence[Fraction]) -> Registers:
        """A vector of double-double numbers."""
        high = [float(x) for x in entries]
        low = [float(x - Fraction(h)) for x, h in zip(entries, high, strict=True)]
        return self._vector(high), self._vector(low)

    def _matrix_product(self, columns: Sequence[str], name: str, i: int) -> str:
        """Multiply a matrix by the stage values of one variable."""
        w = self.w
        total = ""
        for j, column in enumerate(columns):
            each = w.splat(w.load("double", self.address(name, i * self.stages + j)))
            total = w.call("fma", column, each, total) if total else w.op("fmul", column, each)
        return total

    def _iterate(self, whole: Registers) -> str:
        """Iterate the stages; return a bit that tells whether they converged."""
        w, d, h = self.w, self.d, whole[0]
        columns = self._columns(self.method.a)
        convergence = _Convergence(self, h, 1e-26, 1e-24)
        with w.forever() as leave:
            for i in range(self.size):
                change = w.call(
                    "fma", h, self._matrix_product(columns, "rates", i), self._y_rest(i)
                )
                d.store(w.op("fadd", self._y(i), change), self.address("stage"), i)
            self._rates("fresh", "stage")
            changes = []
            for i in range(self.size):
                fresh = d.load(self.address("fresh"), i)
                changes.append(w.op("fsub", fresh, d.load(self.address("rates"), i)))
                d.store(fresh, self.address("rates"), i)
            convergence.look(changes, leave)
        good = convergence.has_converged()
        with w.branch(good):
            if self.refine:
                self._begin_fine(whole)
                fine = self._iterate_fine(h, columns)
            else:
                fine = self._iterate_linear(h, columns)
        return w.emit(f"and i1 {good}, {w.load('i1', fine)}")

    def _iterate_linear(self, h: str, columns: Sequence[str]) -> str:
        """Compute the rates to 32 digits from stages of 16.

        Return the address of the convergence bit.

        Doubles alone have rounded constants that shift the stages in the same direction in every
        step, so that quadratic integrals would drift by one rounding error each time.  Instead,
        with the converged rates k in doubles and the stages Y = y + hAk in 32 digits, the corrected
        rates k + m satisfy

            m = d + [f(Y + hAm) − f(Y)],    d = f(Y) − k,

        where d is computed once in 32 digits.  The bracket is of rounding size, so it is evaluated
        in doubles for the displacement 2²⁰ hAm and divided by 2²⁰; the nonlinear error of this is
        of the order of 2²⁰ |hAm|², far below the digits kept.
        """
        w, p, d = self.w, self.p, self.d
        exact = [self._exact_vector([row[j] for row in self.method.a]) for j in range(self.stages)]
        rests = [low for _, low in exact]
        for i in range(self.size):
            change = w.call("fma", h, self._matrix_product(columns, "rates", i), self._y_rest(i))
            high, low = p.two_sum(self._y(i), change)
            low = w.call("fma", h, self._matrix_product(rests, "rates", i), low)
            stage = p.two_sum(high, low)
            p.store(stage, self.address("fine_stage"), i)
            d.store(p.leading(stage), self.address("stage"), i)
        self._fine_rates()
        self._rates("at_stage", "stage")
        for i in range(self.size):
            rate = d.load(self.address("rates"), i)
            defect = p.sub(p.load(self.address("fine_rates"), i), p.whole(rate))
            for name in ("defect", "missing"):
                d.store(p.leading(defect), self.address(name), i)
        convergence = _Convergence(self, h, 1e-37, 1e-34)
        further = w.op("fmul", h, w.constant(MAGNIFICATION))
        with w.forever() as leave:
            for i in range(self.size):
                off = self._matrix_product(columns, "missing", i)
                further_off = w.call("fma", further, off, d.load(self.address("stage"), i))
                d.store(further_off, self.address("displacement"), i)
            self._rates("fresh", "displacement")
            changes = []
            for i in range(self.size):
                fresh, base = (d.load(self.address(n), i) for n in ("fresh", "at_stage"))
                difference = w.op("fmul", w.op("fsub", fresh, base), w.constant(1 / MAGNIFICATION))
                missing = w.op("fadd", d.load(self.address("defect"), i), difference)
                changes.append(w.op("fsub", missing, d.load(self.address("missing"), i)))
                d.store(missing, self.address("missing"), i)
            convergence.look(changes, leave)
        for i in range(self.size):
            last, first = (d.load(self.address(name), i) for name in ("missing", "defect"))
            more = p.whole(w.op("fsub", last, first))
            exact_rate = p.plus(p.load(self.address("fine_rates"), i), more)
            p.store(exact_rate, self.address("fine_rates"), i)
        return convergence.place

    def _fine_rates(self) -> None:
        names = ("fine_rates", "fine_stage", "fine_constants")
        arguments = ", ".join(f"ptr {self.address(name)}" for name in names)
        self.w.line(f"call void @fine_rates({arguments})")

    def _begin_fine(self, whole: Registers) -> None:
        """Compute stages of 32 digits from rates of 16."""
        w, p = self.w, self.p
        columns = [
            self._exact_vector([row[j] for row in self.method.a]) for j in range(self.stages)
        ]
        for i in range(self.size):
            total: Registers | None = None
            for j, column in enumerate(columns):
                each = w.splat(w.load("double", self.address("rates", i * self.stages + j)))
                term = p.mul(column, p.whole(each))
                total = term if total is None else p.plus(total, term)
            high, low = (w.splat(w.load("double", self.address("y", 2 * i + k))) for k in range(2))
            assert total is not None
            p.store(p.multiply_add(whole, total, (high, low)), self.address("fine_stage"), i)
            rate = self.d.load(self.address("rates"), i)
            p.store(p.whole(rate), self.address("fine_before"), i)

    def _iterate_fine(self, h: str, columns: Sequence[str]) -> str:
        """Correct the stages by the changes of the rates.

        Return the address of the convergence bit.
        """
        w, p, d = self.w, self.p, self.d
        convergence = _Convergence(self, h, 1e-65, 1e-58)
        with w.forever() as leave:
            self._fine_rates()
            changes = []
            for i in range(self.size):
                now = p.load(self.address("fine_rates"), i)
                change = p.leading(p.sub(now, p.load(self.address("fine_before"), i)))
                p.store(now, self.address("fine_before"), i)
                d.store(change, self.address("fresh"), i)
                changes.append(change)
            for i in range(self.size):
                more = w.op("fmul", h, self._matrix_product(columns, "fresh", i))
                stage = p.plus(p.load(self.address("fine_stage"), i), p.whole(more))
                p.store(stage, self.address("fine_stage"), i)
            convergence.look(changes, leave)
        return convergence.place

    def relative(self, h: str, changes: Sequence[str]) -> str:
        """The largest squared relative change, over the vectors of the state, that rates cause."""
        w, d = self.w, self.d
        square = w.op("fmul", h, h)
        worst = w.constant(0.0)
        # A variable that is close to zero is measured relative to 1e-6 of the acting variables.
        whole = w.constant(1e-200)
        for i in self.equations.acting:
            whole = w.call("fma", self._y(i), self._y(i), whole)
        whole = w.op("fmul", whole, w.constant(1e-12))
        for group in self.equations.groups:
            size, change = whole, w.constant(0.0)
            for i in group:
                y, k = self._y(i), d.load(self.address("rates"), i)
                size = w.call("fma", y, y, size)
                size = w.call("fma", w.op("fmul", k, k), square, size)
                change = w.call("fma", changes[i], changes[i], change)
            share = w.op("fdiv", w.op("fmul", change, square), size)
            # Unlike maxnum, this propagates NaN.
            worst = w.choose(w.compare("ogt", worst, share), worst, share)
        return self._largest(worst)

    def _rotation(self, vector: str, by: int) -> str:
        """Rotate the lanes of a vector."""
        kind = self.w.type
        places = ", ".join(f"i32 {(k + by) % self.stages}" for k in range(self.stages))
        mask = f"<{self.stages} x i32> <{places}>"
        return self.w.emit(f"shufflevector {kind} {vector}, {kind} poison, {mask}")

    def _largest(self, vector: str) -> str:
        w, by = self.w, self.stages // 2
        while by:
            other = self._rotation(vector, by)
            vector = w.choose(w.compare("ogt", vector, other), vector, other)
            by //= 2
        return self._first_lane(vector)

    def _total(self, vector: str) -> str:
        """The sum over the lanes, in every lane."""
        by = self.stages // 2
        while by:
            vector = self.w.op("fadd", vector, self._rotation(vector, by))
            by //= 2
        return vector

    def _fine_total(self, value: Registers) -> Registers:
        by = self.stages // 2
        while by:
            high, low = (self._rotation(part, by) for part in value)
            value = self.p.plus(value, (high, low))
            by //= 2
        return value

    def _judge(self, step: str, whole: Registers, end_time: str, good: str) -> None:
        """Accept the step or reduce its length.

        With the estimate e (the highest Legendre coefficient of h·rates relative to the state), a
        converged step is accepted if e ≤ tolerance and no guard is violated.  The coefficient
        scales like hˢ, so the next length is h·0.95·(tolerance/e)^{1/s}, limited to factors in
        [0.3, 2].  Steps below 1e-15 of the time, or 1e-12 of the first step, end the motion.
        """
        w, d, h = self.w, self.d, whole[0]
        top = self._vector([float(x) for x in self.method.top])
        tops = [
            self._total(w.op("fmul", top, d.load(self.address("rates"), i)))
            for i in range(self.size)
        ]
        estimate = self.relative(h, tops)
        bound = self._scalar("fmul", "%tolerance", "%tolerance")
        power = self._scalar("fdiv", bound, estimate)
        order = 2 * self.stages
        while order > 1:
            power = self._call("sqrt", power)
            order //= 2
        number = w.emit(f"fcmp ord double {estimate}, {estimate}")
        good = w.emit(f"and i1 {good}, {number}")
        small = w.emit(f"fcmp ole double {estimate}, {bound}")
        reason = w.emit(f"select i1 {number}, i64 {COLLAPSED}, i64 {NOT_A_NUMBER}")
        reason = w.variable("i64", reason)
        accepted = w.variable("i1", w.emit(f"and i1 {good}, {small}"))
        if self.equations.guards:
            self._guards(h, accepted, reason)
        factor = w.variable("double", literal(0.5))
        with w.branch(good):
            by = self._scalar("fmul", power, literal(0.95))
            by = self._call("maxnum", by, literal(0.3))
            w.store("double", self._call("minnum", by, literal(2.0)), factor)
        fine = w.load("i1", accepted)
        with w.branch(fine):
            self._advance(whole)
            w.store("double", end_time, self.time)
            w.store("double", step, self.last_step)
            self._plan_taken(step, w.load("double", factor), estimate, bound)
        with w.branch(w.emit(f"xor i1 {fine}, true")):
            shorter = self._call("minnum", w.load("double", factor), literal(0.9))
            shorter = self._scalar("fmul", step, shorter)
            w.store("double", shorter, self.planned_step)
            w.store("double", "0.0", self.last_step)
            now = w.load("double", self.time)
            floor = self._scalar("fmul", now, literal(1e-15))
            floor = self._scalar("fadd", floor, w.load("double", self.floor))
            with w.branch(w.emit(f"fcmp ule double {shorter}, {floor}")):
                w.store("i64", w.load("i64", reason), self.outcome)

    def _guards(self, h: str, is_accepted: str, reason: str) -> None:
        """Reject the step if a guard is violated at a stage or at its end."""
        w, d = self.w, self.d
        weights = self._vector([float(x) for x in self.method.b])
        for i in range(self.size):
            change = self._total(w.op("fmul", weights, d.load(self.address("rates"), i)))
            d.store(w.call("fma", h, change, self._y(i)), self.address("fresh"), i)
        for points in ("stage", "fresh"):
            w.line(
                f"call void @guards(ptr {self.address('guards')}, ptr {self.address(points)}, "
                f"ptr {self.address('wide_constants')})"
            )
            for i in reversed(range(len(self.equations.guards))):
                passed = w.any(w.compare("ule", d.load(self.address("guards"), i), w.constant(0.0)))
                with w.branch(passed):
                    w.store("i1", "false", is_accepted)
                    w.store("i64", str(len(STATUS_MESSAGES) + i), reason)

    def _plan_taken(self, step: str, factor: str, estimate: str, bound: str) -> None:
        """Choose the next step length: at first from the estimate, later rarely changed."""
        w = self.w
        done = w.emit(f"add i64 {w.load('i64', self.accepted_steps)}, 1")
        w.store("i64", done, self.accepted_steps)
        planned = w.load("double", self.planned_step)
        early = w.emit(f"icmp sle i64 {done}, {SETTLING}")
        room = literal(ROOM_TO_LENGTHEN**2)
        calm = w.emit(f"fcmp ole double {estimate}, {self._scalar('fmul', bound, room)}")
        count = w.emit(f"add i64 {w.load('i64', self.calm)}, 1")
        count = w.emit(f"select i1 {calm}, i64 {count}, i64 0")
        long = w.emit(f"icmp sge i64 {count}, {STEPS_TO_LENGTHEN}")
        w.store("i64", w.emit(f"select i1 {long}, i64 0, i64 {count}"), self.calm)
        free = self._scalar("fmul", planned, factor)
        longer = self._scalar("fmul", planned, literal(1.25))
        following = w.emit(f"select i1 {long}, double {longer}, double {planned}")
        # A shortened step gives no information about the planned length.
        whole = w.emit(f"fcmp oge double {step}, {self._scalar('fmul', planned, literal(0.5))}")
        first = w.emit(f"and i1 {early}, {whole}")
        w.store(
            "double",
            w.emit(f"select i1 {first}, double {free}, double {following}"),
            self.planned_step,
        )
        due = w.emit(f"urem i64 {done}, {EVERY}")
        with w.branch(w.emit(f"icmp eq i64 {due}, 0")):
            self._project()

    def _advance(self, whole: Registers) -> None:
        """Advance the state with twice the digits."""
        d, p, p1 = self.d, self.p, self.p1
        weights = self._exact_vector(self.method.b)
        for i in range(self.size):
            rates = p.load(self.address("fine_rates"), i)
            d.store(p.leading(rates), self.address("before"), i)
            total = p.mul(whole, self._fine_total(p.mul(weights, rates)))
            change = self._first(total[0]), self._first(total[1])
            p1.store(p1.add(p1.load(self.address("y"), i), change), self.address("y"), i)

    def _first(self, vector: str) -> str:
        """The first lane, as a vector of one."""
        kind = self.w.type
        return self.w.emit(
            f"shufflevector {kind} {vector}, {kind} poison, <1 x i32> zeroinitializer"
        )

    def _project(self) -> None:
        """Project the state onto the level of the conserved functions."""
        if self.projection is None:
            return
        w, p1, d1 = self.w, self.p1, self.d1
        self._residuals("y")
        for i in range(self.size):
            d1.store(p1.load(self.address("y"), i)[0], self.address("point"), i)
        for k in range(len(self.projection.residuals)):
            d1.store(p1.load(self.address("left"), k)[0], self.address("point"), self.size + k)
        w.line(
            f"call void @correct(ptr {self.address('move')}, ptr {self.address('point')}, "
            f"ptr {self.address('thin_constants')})"
        )
        for i in range(self.size):
            move = p1.whole(d1.load(self.address("move"), i))
            p1.store(p1.add(p1.load(self.address("y"), i), move), self.address("y"), i)


class _Convergence:
    """The convergence test of an iteration.

    An iteration has converged if its squared change is below `small`, or is below `low` and no
    longer decreases.
    """

    def __init__(self, loop: _LoopGenerator, h: str, small: float, low: float) -> None:
        self.loop, self.h, self.small, self.low = loop, h, small, low
        w = loop.w
        self.last = w.variable("double", literal(1e300))
        self.place = w.variable("i1", "false")
        self.tries = w.variable("i64", "0")

    def look(self, changes: Sequence[str], leave: Callable[[str], None]) -> None:
        """Leave the iteration if it has converged or will not converge."""
        w = self.loop.w
        change = self.loop.relative(self.h, changes)
        before = w.load("double", self.last)
        w.store("double", change, self.last)
        small = w.emit(f"fcmp ole double {change}, {literal(self.small)}")
        level = w.emit(f"fcmp oge double {change}, {before}")
        low = w.emit(f"fcmp ole double {change}, {literal(self.low)}")
        converged = w.emit(f"or i1 {small}, {w.emit(f'and i1 {level}, {low}')}")
        w.store("i1", converged, self.place)
        leave(converged)
        leave(w.emit(f"fcmp uno double {change}, {change}"))
        tries = w.emit(f"add i64 {w.load('i64', self.tries)}, 1")
        w.store("i64", tries, self.tries)
        leave(w.emit(f"icmp sge i64 {tries}, {MOST}"))

    def has_converged(self) -> str:
        """The result as a bit."""
        return self.loop.w.load("i1", self.place)


def gauss_loop(
    method: Gauss, equations: Equations, projection: ProjectionTerms | None, refine: bool
) -> tuple[str, int]:
    """Code of the loop, and the number of doubles of memory that it needs.

    Parameters
    ----------
    method : Gauss
        Method with 4, 8 or 16 stages.
    equations : Equations
        Equations without a section.
    projection : ProjectionTerms or None
        Functions on whose level the state is kept.
    refine : bool
        True if the stages are computed with 32 digits.
    """
    loop = _LoopGenerator(method, equations, projection, refine)
    return loop.write(), loop.space.size

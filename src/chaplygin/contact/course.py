"""The course of a motion in contact: smooth pieces, joined by the events between them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from ..core.arrays import FloatArray
from ..errors import InputError
from .beginning import Beginning, beginning
from .compiled import (
    ATTITUDE,
    OMEGA,
    POSITION,
    VELOCITY,
    WORK,
    CompiledContact,
    ContactNumbers,
    ModeIntegrator,
    with_values,
)
from .contensou import held_range_of, range_of
from .events import ContactEvent
from .friction import (
    ContensouErismann,
    ContourResistance,
    Coulomb,
    RollingResistance,
    SpinFriction,
)
from .impact import ImpactLaw, impact, zeno_closure
from .modes import FLIGHT, Mode
from .stopping import DryContact, exit_direction, remaining_time

#: Sizes relative to the typical speed √(energy/m) of a motion.
SLIP_FLOOR, NO_SLIP, LAST_BOUNCE = 1e-8, 1e-13, 1e-7

#: So many events without progress of time end a motion.
_STUCK = 60

OnLiftoff = Literal["fly", "stop"]
OnParadox = Literal["stop", "impact"]


@dataclass(frozen=True, eq=False)
class Piece:
    """A part of a motion in one mode.

    Attributes
    ----------
    mode : Mode
    integrator : ModeIntegrator
    begin, end : float
        Times.
    times : array (n,)
        Sample times within.
    states : array (n, size)
    """

    mode: Mode
    integrator: ModeIntegrator
    begin: float
    end: float
    times: FloatArray
    states: FloatArray


@dataclass(frozen=True)
class Rules:
    """What happens at events.

    Attributes
    ----------
    restitution : float
    impact_law : str
    on_liftoff : ``"fly"`` or ``"stop"``
    on_paradox : ``"stop"`` or ``"impact"``
        Whether a motion ends where none in contact is possible, or takes an impact without
        collision.
    most_events : int
    """

    restitution: float = 0.0
    impact_law: ImpactLaw = "stronge"
    on_liftoff: OnLiftoff = "fly"
    on_paradox: OnParadox = "stop"
    most_events: int = 100_000


class EndError(Exception):
    """A motion that cannot go on, with the reason."""


@dataclass
class Course:
    """A motion while it is computed."""

    contact: CompiledContact
    rules: Rules
    moments: FloatArray
    time: float
    state: FloatArray
    mode: Mode
    spin_sign: float = 1.0
    pieces: list[Piece] = field(default_factory=list)
    events: list[ContactEvent] = field(default_factory=list)
    steps: int = 0
    next_moment: int = 0
    reason: str = ""
    floor_factor: float = 1.0
    scale: float = 1.0
    idle: int = 0

    # --- driving ---------------------------------------------------------------------------

    def run(self, progress: Callable[[float], None] | None = None) -> None:
        """Follow the motion through its moments, or to where it ends."""
        end = float(self.moments[-1])
        try:
            self._enter_contact_or_flight()
            while self.time < end or self.next_moment < len(self.moments):
                guard = self._piece()
                if not guard:
                    break
                self._handle(guard)
                if progress is not None:
                    progress(self.time / end if end else 1.0)
        except EndError as stop:
            self.reason = str(stop)

    def _piece(self) -> str:
        """Integrate in the present mode up to the next event; return its guard."""
        integrator = self._integrator(self.mode)
        wanted = self.moments[self.next_moment :]
        end = float(self.moments[-1])
        outcome = integrator.advance(self.time, self.state, list(wanted), end)
        count = len(outcome.samples)
        self._add_piece(integrator, outcome.time, wanted[:count], outcome.samples)
        self.steps += outcome.steps
        if outcome.guard == "failure":
            raise EndError("the state stopped being a number")
        self.idle = 0 if outcome.time > self.time else self.idle + 1
        if self.idle > _STUCK or len(self.events) > self.rules.most_events:
            raise EndError(f"{len(self.events)} events up to t = {self.time:.9g}: too many")
        self.time, self.state = outcome.time, outcome.state
        return outcome.guard

    def _add_piece(
        self, integrator: ModeIntegrator, end: float, times: FloatArray, states: FloatArray
    ) -> None:
        size = self.contact.size
        self.pieces.append(
            Piece(self.mode, integrator, self.time, end, np.array(times), states[:, :size])
        )
        self.next_moment += len(times)

    def _integrator(self, mode: Mode) -> ModeIntegrator:
        energy = abs(self.contact.numbers(self.state).energy)
        values = {
            "spin_sign": self.spin_sign,
            "slip_floor": SLIP_FLOOR * self.scale * self.floor_factor,
            "rolling_floor": SLIP_FLOOR * self.scale * self.floor_factor,
        }
        del energy
        return with_values(self.contact.mode(mode), values)

    # --- laws ------------------------------------------------------------------------------

    @property
    def _coulomb(self) -> Coulomb | None:
        return self.contact.situation.law(Coulomb)  # type: ignore[return-value]

    @property
    def _coupled(self) -> ContensouErismann | None:
        return self.contact.situation.law(ContensouErismann)  # type: ignore[return-value]

    @property
    def _mu(self) -> float:
        law = self._coulomb or self._coupled
        return law.mu if law else 0.0

    @property
    def _spin_arm(self) -> float:
        law = self.contact.situation.law(SpinFriction)
        return law.arm if isinstance(law, SpinFriction) else 0.0

    @property
    def _patch(self) -> float:
        return self._coupled.patch if self._coupled else 0.0

    @property
    def _is_dry(self) -> bool:
        return self._coulomb is not None or self._coupled is not None

    def _dry_contact(self, known: ContactNumbers, spin_held: bool) -> DryContact:
        q = known.q
        if self._spin_arm and not spin_held:
            q = q - self._spin_arm * self.spin_sign * known.mobility.gamma
        return DryContact(known, self._mu, self._patch, q, spin_held)

    # --- deciding on the mode --------------------------------------------------------------

    def _enter_contact_or_flight(self) -> None:
        known = self.contact.numbers(self.state)
        length = float(np.linalg.norm(known.r))
        speed = float(np.linalg.norm(known.contact_velocity))
        self.scale = max(
            math.sqrt(9.81e-6 * length),
            speed,
            float(np.linalg.norm(self.state[VELOCITY])),
            float(np.linalg.norm(self.state[OMEGA])) * length,
        )
        if known.gap > 1e-12 * length:
            self.mode = FLIGHT
            return
        normal = float(known.mobility.gamma @ known.contact_velocity)
        if normal > 1e-12 * self.scale:
            self._take_off()
        elif normal < -1e-12 * self.scale:
            self._land()
        else:
            self._settle(None)

    def _settle(self, kind: str | None) -> None:
        """Choose the mode of a contact without normal velocity; record an event of a kind."""
        before = self.state
        known = self.contact.numbers(self.state)
        slip = float(np.linalg.norm(known.slip))
        arm = self._patch * abs(known.spin)
        self.spin_sign = math.copysign(1.0, known.spin) if known.spin else self.spin_sign
        resting = slip <= NO_SLIP * self.scale and arm <= NO_SLIP * self.scale
        if not self._is_dry or not resting:
            spin_held = self._spin_arm > 0 and known.spin == 0
            self._slide(known, spin_held)
            if kind:
                self._record(kind, before)
            return
        self._hold_or_begin(kind, before, self._spin_arm > 0 and known.spin == 0)

    def _slide(self, known: ContactNumbers, spin_held: bool = False) -> None:
        span = ""
        if self._coupled:
            span = range_of(float(np.linalg.norm(known.slip)), known.spin, self._patch)
        self.mode = Mode(sliding=True, spinning=not spin_held, range=span)  # type: ignore[arg-type]
        self._check_pressed()

    def _check_pressed(self) -> None:
        """Leave the support, or find no motion, where the contact presses no longer."""
        integrator = self._integrator(self.mode)
        N = float(integrator.outputs(self.state)["normal_force"])
        guards = {g.name for g in integrator.system.guards}
        if N > 0:
            return
        if "paradox" in guards and self._paradox_margin(integrator) <= 0:
            self._paradox()
        else:
            self._take_off()

    def _paradox_margin(self, integrator: ModeIntegrator) -> float:
        known = self.contact.numbers(self.state)
        dry = self._dry_contact(known, not self.mode.spinning)
        slip = known.slip
        x = np.append(slip, self._patch * known.spin) if self._patch else slip
        p, q = dry._friction(x / np.linalg.norm(x))
        touch = known.mobility
        along = touch.A @ (touch.gamma + p) + np.cross(touch.inverse_inertia @ q, touch.r)
        return float(touch.gamma @ along)

    def _hold_or_begin(self, kind: str | None, before: FloatArray, spin_held: bool) -> None:
        """Hold a contact without slip if friction can, or begin to slide."""
        known = self.contact.numbers(self.state)
        coupled = self._patch > 0
        spin_held = spin_held or coupled
        span = "above" if coupled else ""
        held = Mode(sliding=False, spinning=not spin_held, range=span)  # type: ignore[arg-type]
        integrator = self._integrator(held)
        self.state = self._projected(held, self.state)
        values = integrator.outputs(self.state)
        N, f = float(values["normal_force"]), values["friction_force"]
        tau = float(values["gamma"] @ (values["friction_couple"] - N * known.q))
        if self.contact.situation.never_slips:
            if N <= 0:
                self._leave_ideal(known)
                return
            self.mode = held
            if kind:
                self._record(kind, before)
            return
        if coupled:
            inside = N > 0 and self._inside(float(np.linalg.norm(f)) / N, abs(tau) / N)
            self.spin_sign = math.copysign(1.0, tau)
            if inside:
                span = held_range_of(tau / self._patch, self._mu * N)
                self.mode = replace(held, range=span)
                if kind:
                    self._record(kind, before)
                return
        elif N > 0 and float(f @ f) <= (self._mu * N) ** 2:
            if not spin_held or abs(tau) <= self._spin_arm * N:
                self.mode = held
                if kind:
                    self._record(kind, before)
                return
            # the couple cannot hold the spin: it starts, with the slip held or not
            self.spin_sign = -math.copysign(1.0, tau)
            self.mode = replace(held, spinning=True)
            if kind:
                self._record(kind, before)
            return
        if N <= 0 and float(known.mobility.gamma @ known.slip_rate) + known.normal_rate >= 0:
            self._take_off()
            return
        again = "direct restart" if kind == "stick" else kind
        self._begin(known, spin_held and not coupled, f, tau, again, before)

    def _leave_ideal(self, known: ContactNumbers) -> None:
        free = float(known.mobility.gamma @ known.slip_rate) + known.normal_rate
        if free > 0:
            self._take_off()
            return
        raise EndError(
            "the rolling contact would have to pull, while the body left alone would be pressed "
            "into the support: neither rolling nor leaving is possible"
        )

    def _inside(self, x: float, arm: float) -> bool:
        """Whether |f|/N and |τ|/N are within the limit set of the coupled law."""
        from .pressure import Hertz
        from .pressure_limits import load_factor

        unit = self._mu * self._patch
        return bool(load_factor(Hertz(), x / self._mu, arm / unit) <= 1)

    def _begin(
        self,
        known: ContactNumbers,
        spin_held: bool,
        f: FloatArray,
        tau: float,
        kind: str | None,
        before: FloatArray,
    ) -> None:
        """Begin to slide at once, along the direction in which motion leaves zero."""
        dry = self._dry_contact(known, spin_held)
        first = -f
        if self._patch:
            first = np.append(-f, -tau / self._patch)
        direction = exit_direction(dry.acceleration, dry.basis, first)
        if direction is None:
            raise EndError("the contact can neither be held nor begin to slide in any direction")
        self._begin_along(direction, spin_held, kind, before)

    def _begin_along(
        self, direction: FloatArray, spin_held: bool, kind: str | None, before: FloatArray
    ) -> None:
        omega = float(np.linalg.norm(self.state[OMEGA]))
        known = self.contact.numbers(self.state)
        length = float(np.linalg.norm(known.r))
        strength = float(np.linalg.norm(known.free_acceleration)) + 1e-300
        longest = 0.02 * min(1 / max(omega, 1e-9), math.sqrt(length / strength))
        if self._patch and direction[3]:
            self.spin_sign = math.copysign(1.0, direction[3])
        mode = Mode(sliding=True, spinning=not spin_held)
        result = beginning(
            self.contact, self.time, self.state, mode, direction, self.spin_sign, longest
        )
        if result is None:
            raise EndError("sliding begins, but no motion with a growing slip was found")
        if kind:
            self.mode = mode
            self._record(kind, before)
        self._slide_through(result, spin_held)

    def _slide_through(self, result: Beginning, spin_held: bool) -> None:
        end = self.time + result.duration
        wanted = [t for t in self.moments[self.next_moment :] if t <= end]
        samples = result.samples(self.time, self.state, wanted)
        self.mode = Mode(sliding=True, spinning=not spin_held)
        begin_state = self.state
        self.state = result.state
        known = self.contact.numbers(self.state)
        span = ""
        if self._coupled:
            span = range_of(float(np.linalg.norm(known.slip)), known.spin, self._patch)
        self.mode = replace(self.mode, range=span)  # type: ignore[arg-type]
        del begin_state
        self._add_piece(self._integrator(self.mode), end, np.array(wanted), samples)
        self.time = end
        size = float(np.linalg.norm(known.slip)) + self._patch * abs(known.spin)
        # an episode of sliding may be slower than the usual floor
        self.floor_factor = min(1.0, 1e-2 * size / (SLIP_FLOOR * self.scale))

    def _projected(self, mode: Mode, state: FloatArray) -> FloatArray:
        return self._integrator(mode).project(state)

    # --- events ----------------------------------------------------------------------------

    def _record(self, kind: str, before: FloatArray, **more: object) -> None:
        self.events.append(
            ContactEvent(
                self.time,
                kind,
                self.mode.name,
                before.copy(),
                self.state.copy(),
                **more,  # type: ignore[arg-type]
            )
        )

    def _handle(self, guard: str) -> None:
        handlers: dict[str, Callable[[], None]] = {
            "lift-off": self._lift_off,
            "landing": self._land,
            "stick": self._stick,
            "stop": self._stick,
            "slip": self._slip,
            "spin stop": self._spin_stop,
            "spin start": self._spin_start,
            "rolling stop": self._rolling_stop,
            "range": self._change_range,
            "paradox": self._paradox,
        }
        if guard in handlers:
            handlers[guard]()
            return
        guards = {g.name: g.message for g in self._integrator(self.mode).system.guards}
        raise EndError(guards.get(guard, guard))

    def _lift_off(self) -> None:
        if self.contact.situation.never_slips and not self.mode.sliding:
            self._leave_ideal(self.contact.numbers(self.state))
            return
        self._take_off()

    def _take_off(self) -> None:
        before = self.state
        self.mode = FLIGHT
        self.state = self._projected(FLIGHT, self.state)
        self._record("lift-off", before)
        if self.rules.on_liftoff == "stop":
            raise EndError("the body leaves the support")
        self._rise()

    def _rise(self) -> None:
        """Put a flying body above the support by a height of rounding size, so that it leaves."""
        known = self.contact.numbers(self.state)
        rise = 4e-16 * (float(np.linalg.norm(known.r)) + float(np.abs(self.state[POSITION]).max()))
        self.state = self.state.copy()
        up = self._space(known.mobility.gamma)
        self.state[POSITION] += max(0.0, rise - known.gap) * up

    def _space(self, u: FloatArray) -> FloatArray:
        w, x, y, z = self.state[ATTITUDE]
        turn = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )
        return turn @ u

    def _land(self) -> None:
        """An impact, after which the body flies on or stays."""
        before = self.state
        known = self.contact.numbers(self.state)
        normal = float(known.mobility.gamma @ known.contact_velocity)
        if normal > 0 or abs(normal) <= 1e-12 * self.scale:
            # a grazing contact
            self.mode = Mode()
            self.state = self._projected(Mode(), self.state)
            self._settle("landing")
            return
        result = self._impact(known)
        rebound = float(known.mobility.gamma @ result.contact_velocity)
        if rebound > LAST_BOUNCE * self.scale:
            self.mode = FLIGHT
            self._rise()
            self._record(
                "landing", before, impulse=result.impulse, couple_impulse=result.couple_impulse
            )
            return
        if rebound > 0:
            closing, couple = zeno_closure(
                known.mobility,
                result.contact_velocity,
                result.spin,
                mu=self._mu,
                spin_arm=self._spin_arm,
            )
            self._push(self.contact.numbers(self.state), closing, couple)
        sliding = Mode()
        self.state = self._projected(sliding, self.state)
        slip = float(np.linalg.norm(self.contact.numbers(self.state).slip))
        if self._is_dry and slip <= 1e-12 * self.scale:
            self.state = self._projected(Mode(sliding=False), self.state)
        self._settle("landing")
        self.events[-1] = replace(
            self.events[-1], impulse=result.impulse, couple_impulse=result.couple_impulse
        )

    def _impact(self, known: ContactNumbers):  # type: ignore[no-untyped-def]
        velocity = known.slip.copy()
        spin = known.spin if self._spin_arm else 0.0
        result = impact(
            known.mobility,
            velocity,
            spin,
            mu=self._mu,
            spin_arm=self._spin_arm,
            restitution=self.rules.restitution,
            law=self.rules.impact_law,
        )
        self._push(known, result.impulse, result.couple_impulse)
        return result

    def _push(self, known: ContactNumbers, impulse: FloatArray, couple_impulse: float) -> None:
        """Change the velocities by an impulse; the energy lost is work of the impact."""
        state = self.state.copy()
        touch = known.mobility
        state[VELOCITY] += touch.velocity_jump(impulse)
        state[OMEGA] += touch.angular_velocity_jump(impulse, couple_impulse)
        state[WORK] += known.energy - self.contact.numbers(state).energy
        self.state = state

    def _stick(self) -> None:
        """Complete a stop, and hold the contact or leave zero in another direction."""
        before = self.state
        known = self.contact.numbers(self.state)
        spin_held = not self.mode.spinning
        dry = self._dry_contact(known, spin_held)
        x = np.append(known.slip, self._patch * known.spin) if self._patch else known.slip
        remaining = remaining_time(x, dry.acceleration, dry.basis)
        if remaining is None:
            # the slip passes close by zero
            self.floor_factor *= 1e-2
            if self.floor_factor < 1e-6:
                raise EndError("the slip stays at rounding size without coming to an end")
            return
        self.floor_factor = 1.0
        self._halt(known, dry, remaining)
        self._hold_or_begin("stick", before, spin_held)

    def _halt(self, known: ContactNumbers, dry: DryContact, remaining: float) -> None:
        """Move on to the end of sliding, where the slip (and the spin) is zero."""
        touch = known.mobility
        gamma, A, c, Y = touch.gamma, touch.A, touch.spin_force, touch.inverse_inertia
        held = self._patch > 0 or dry.spin_held
        # impulse and couple impulse (about the normal) of the remaining time
        matrix = np.zeros((4, 4))
        matrix[:3, :3] = A + np.outer(np.cross(Y @ dry.q, touch.r), gamma)
        matrix[:3, 3] = c
        right = np.zeros(4)
        right[:3] = -known.slip - known.slip_rate * remaining
        if held:
            matrix[3, :3] = c + float(gamma @ Y @ dry.q) * gamma
            matrix[3, 3] = touch.spin
            right[3] = -(known.spin if self._patch else 0.0) - known.spin_rate * remaining
        else:
            matrix[3, 3] = 1.0
        solution = np.linalg.solve(matrix, right)
        impulse = solution[:3]
        couple = dry.q * float(gamma @ impulse) + solution[3] * gamma
        state = self.state.copy()
        state[:WORK] += known.rates[:WORK] * remaining
        state[VELOCITY] = (
            self.state[VELOCITY] + known.free_acceleration * remaining + impulse / touch.mass
        )
        turn = Y @ (np.cross(touch.r, impulse) + couple)
        state[OMEGA] = self.state[OMEGA] + known.free_turn * remaining + turn
        law = self._coupled or self._coulomb
        column = [str(s) for s in self.contact.mode(FLIGHT).system.symbols].index(
            f"work_{law.name}"  # type: ignore[union-attr]
        )
        self.time += remaining
        held_mode = Mode(sliding=False, spinning=not held, range="above" if self._patch else "")
        state = self._projected(held_mode, state)
        state[column] += known.energy - self.contact.numbers(state).energy
        self.state = state

    def _slip(self) -> None:
        """A held contact reaches the limit of friction."""
        before = self.state
        integrator = self._integrator(self.mode)
        values = integrator.outputs(self.state)
        known = self.contact.numbers(self.state)
        f = values["friction_force"]
        N = float(values["normal_force"])
        spin_held = not self.mode.spinning
        direction = -f / np.linalg.norm(f)
        if self._patch:
            from .pressure import Hertz
            from .pressure_limits import slip_ratio

            tau = float(values["gamma"] @ (values["friction_couple"] - N * known.q))
            x = float(np.linalg.norm(f)) / (self._mu * N)
            z = abs(tau) / (self._mu * N * self._patch)
            k = float(slip_ratio(Hertz(), x, z))
            sine, cosine = (1.0, 0.0) if math.isinf(k) else (k, 1.0)
            size = math.hypot(sine, cosine)
            direction = np.append(direction * sine / size, -math.copysign(cosine / size, tau))
            spin_held = False
        self._begin_along(direction, spin_held, "slip", before)

    def _spin_stop(self) -> None:
        """The spin has come to zero: hold it, or let it change its sign."""
        before = self.state
        held = replace(self.mode, spinning=False)
        self.state = self._projected(held, self.state)
        integrator = self._integrator(held)
        values = integrator.outputs(self.state)
        N = float(values["normal_force"])
        known = self.contact.numbers(self.state)
        tau = float(values["gamma"] @ (values["friction_couple"] - N * known.q))
        if abs(tau) <= self._spin_arm * N:
            self.mode = held
            self._record("spin stop", before)
            return
        self.spin_sign = -math.copysign(1.0, tau)
        self._record("spin reversal", before)

    def _spin_start(self) -> None:
        before = self.state
        values = self._integrator(self.mode).outputs(self.state)
        known = self.contact.numbers(self.state)
        N = float(values["normal_force"])
        tau = float(values["gamma"] @ (values["friction_couple"] - N * known.q))
        self.spin_sign = -math.copysign(1.0, tau)
        self.mode = replace(self.mode, spinning=True)
        self._record("spin start", before)

    def _rolling_stop(self) -> None:
        """Rolling comes to its end under resistance."""
        before = self.state
        known = self.contact.numbers(self.state)
        law = self.contact.situation.law(RollingResistance) or self.contact.situation.law(
            ContourResistance
        )
        rolling = float(np.linalg.norm(known.rolling))
        values = self._integrator(self.mode).outputs(self.state)
        N = float(values["normal_force"])
        if self.mode.sliding:
            raise EndError(
                "rolling has ended while the body slides: its resistance holds the rolling, which "
                "the equations do not cover"
            )
        touch = known.mobility
        # ω̇ by the difference of the field along the motion
        integrator = self._integrator(self.mode)
        step = integrator.advance(self.time, self.state, [], self.time + 1e-3 * rolling)
        after = self.contact.numbers(step.state)
        loss = rolling - float(np.linalg.norm(after.rolling))
        del touch, law, N
        if step.guard or loss <= 0:
            raise EndError("rolling comes close to its end and does not reach it")
        remaining = 1e-3 * rolling * rolling / loss
        if abs(known.spin) > 1e-9 * self.scale:
            raise EndError(
                "rolling has ended while the body still spins about the normal, which the "
                "equations do not cover"
            )
        state = self.state.copy()
        state[:WORK] += known.rates[:WORK] * remaining / 2
        state[VELOCITY] = 0.0
        state[OMEGA] = 0.0
        names = [str(s) for s in self.contact.mode(FLIGHT).system.symbols]
        rest = self.contact.situation
        name = next(x.name for x in rest.laws if x.name in ("rolling", "contour"))
        state[names.index(f"work_{name}")] += known.energy - self.contact.numbers(state).energy
        self.time += remaining
        self.state = state
        self.mode = Mode(sliding=False, spinning=False, rolling=False)
        self._record("rest", before)

    def _change_range(self) -> None:
        known = self.contact.numbers(self.state)
        if self.mode.sliding:
            span = range_of(float(np.linalg.norm(known.slip)), known.spin, self._patch)
        else:
            values = self._integrator(self.mode).outputs(self.state)
            N = float(values["normal_force"])
            tau = float(values["gamma"] @ (values["friction_couple"] - N * known.q))
            span = held_range_of(tau / self._patch, self._mu * N)
            self.spin_sign = math.copysign(1.0, tau)
        order = {"inner": 0, "middle": 1, "outer": 2, "below": 0, "above": 1}
        if span == self.mode.range:
            # the event lies on the border: go over to the neighbour
            neighbours = {"inner": "middle", "outer": "middle", "below": "above", "above": "below"}
            span = neighbours.get(self.mode.range, span)  # type: ignore[assignment]
        del order
        self.mode = replace(self.mode, range=span)

    def _paradox(self) -> None:
        """No motion in contact: end, or take an impact without collision."""
        if self.rules.on_paradox == "stop":
            raise EndError(
                "no motion in contact is possible here (Painlevé's paradox: the friction of any "
                "normal force would press the body into the support)"
            )
        before = self.state
        known = self.contact.numbers(self.state)
        result = self._impact(known)
        self.state = self._projected(Mode(), self.state)
        slip = float(np.linalg.norm(self.contact.numbers(self.state).slip))
        if slip <= 1e-12 * self.scale:
            self.state = self._projected(Mode(sliding=False), self.state)
        self._settle("impact without collision")
        self.events[-1] = replace(
            self.events[-1],
            before=before,
            impulse=result.impulse,
            couple_impulse=result.couple_impulse,
        )


def follow(
    contact: CompiledContact,
    state: Sequence[float],
    moments: FloatArray,
    rules: Rules,
    progress: Callable[[float], None] | None = None,
) -> Course:
    """The course of a motion from a state through moments.

    Raises
    ------
    InputError
        If the body penetrates the support at the start.
    """
    start = np.array(state, dtype=float)
    known = contact.numbers(start)
    length = float(np.linalg.norm(known.r))
    if known.gap < -1e-9 * length:
        raise InputError(
            f"position: the body lies {-known.gap:.6g} m inside the support; raise it at least so "
            "much"
        )
    course = Course(
        contact, rules, np.asarray(moments, dtype=float), float(moments[0]), start, Mode()
    )
    course.run(progress)
    return course

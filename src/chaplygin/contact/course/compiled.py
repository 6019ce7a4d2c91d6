"""Compiled modes of a contact, and numbers at a state."""

from __future__ import annotations

import copy
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import heyoka as hy
import numpy as np
import sympy as sp

from ...core.arrays import FloatArray
from ...core.system import System
from ...core.vectors import constant, to_components
from ...flow.heyoka_expressions import Translator
from ...flow.kernel import code_cache
from ...flow.taylor import CompiledSystem, compile_system
from ..equations.equations_of_motion import equations_of_motion, work_symbol
from ..equations.situation import FrictionalContact
from ..friction.friction_law import FrictionLaw, Reaction
from ..friction.modes import FLIGHT, Mode
from ..friction.symbols import (
    contact_velocity,
    free_acceleration,
    free_turn,
    gamma,
    gammadot,
    normal_rate,
    r,
    rolling,
    slip,
    slip_rate,
    spin,
    spin_rate,
)
from ..impact.mobility import Mobility, mobility

#: Columns of the state that all modes share.
ATTITUDE, POSITION, VELOCITY, OMEGA, NORMAL = (
    slice(0, 4),
    slice(4, 7),
    slice(7, 10),
    slice(10, 13),
    slice(13, 16),
)
WORK = 16

_VECTORS = (
    r,
    gamma,
    gammadot,
    slip,
    rolling,
    slip_rate,
    free_acceleration,
    free_turn,
    contact_velocity,
)
_SCALARS = (spin, normal_rate, spin_rate)


@dataclass(frozen=True)
class Outcome:
    """The end of one piece of a motion.

    Attributes
    ----------
    time : float
    state : array (size,)
    guard : str
        Name of the guard that ended it; empty at the end of the interval, ``"failure"`` if the
        state stopped being a number.
    samples : array (n, size)
        States at the sample times that were passed.
    steps : int
    """

    time: float
    state: FloatArray
    guard: str
    samples: FloatArray
    steps: int


@dataclass(frozen=True)
class ModeIntegrator:
    """A mode of a contact, ready to be integrated.

    Attributes
    ----------
    system : System
    code : CompiledSystem
    stepper : heyoka.taylor_adaptive
        A copy of its integrator, since stepping changes it and the code is shared.
    values : array
        Values of the parameters of `system`.
    columns : mapping of str to (int, int)
        First column and number of components of each observable among the outputs of the code.
    places : mapping of str to int
        Place of each parameter in `values`, by name.
    """

    system: System
    code: CompiledSystem
    stepper: hy.taylor_adaptive
    values: FloatArray
    columns: Mapping[str, tuple[int, int]]
    places: Mapping[str, int]

    def state_of_system(self, state: FloatArray) -> FloatArray:
        """The state with all variables of its system; those of its own at their ends, 1."""
        more = len(self.system.symbols) - len(state)
        return np.append(state, np.ones(max(more, 0)))

    def outputs(self, states: FloatArray) -> dict[str, FloatArray]:
        """Observables at a state (size,) or at states (n, size), by name."""
        numbers = self._numbers(states)
        return {
            name: numbers[..., first : first + size] if size > 1 else numbers[..., first]
            for name, (first, size) in self.columns.items()
        }

    def rates(self, state: FloatArray) -> FloatArray:
        """The right-hand sides of the equations at a state (size,)."""
        stepper = copy.copy(self.stepper)
        count = min(len(self.values), len(stepper.pars))
        stepper.pars[:count] = self.values[:count]
        stepper.state[:] = state
        stepper.step(write_tc=True, max_delta_t=1e-300)
        result: FloatArray = np.array(stepper.tc[:, 1])
        return result

    def guard_values(self, state: FloatArray) -> FloatArray:
        """What the guards watch, at a state (size,), in their order."""
        return self._numbers(state)[-1 - len(self.system.guards) : -1]

    def _numbers(self, states: FloatArray) -> FloatArray:
        function = self.code.outputs
        columns = np.ascontiguousarray(states.T[: len(self.system.symbols)], dtype=float)
        values = self.values[: function.nparams]
        if columns.ndim == 2:
            values = np.tile(values[:, None], columns.shape[1])
        result: FloatArray = function(columns, pars=values).T
        return result

    def project(self, state: FloatArray) -> FloatArray:
        """The state moved onto the relations of the mode, along the shortest way."""
        point = np.array(state, dtype=float)
        for block in self.code.core:
            for _ in range(3):
                defect = block.residual(point, pars=self.values[: block.residual.nparams])
                if np.abs(defect).max() < 1e-16:
                    break
                slope = block.slope(point, pars=self.values[: block.slope.nparams])
                # dependent rows: the normal is tied to the attitude, and both have unit length
                point -= np.linalg.pinv(slope.reshape(block.count, -1), rcond=1e-9) @ defect
        return point

    def advance(
        self,
        time: float,
        state: FloatArray,
        moments: Sequence[float],
        end: float,
        most_steps: int = 0,
    ) -> Outcome:
        """Integrate from a state to an end, or to the first guard that falls to zero.

        Parameters
        ----------
        time : float
        state : array (size,)
        moments : sequence of float
            Sample times, increasing, from `time` to `end`.
        end : float
        most_steps : int
            Number of steps after which to give up with the guard ``"failure"``; 0 for no limit.
        """
        stepper = self.stepper
        # heyoka counts the parameters up to the last one that occurs in the formulas
        count = min(len(self.values), len(stepper.pars))
        stepper.pars[:count] = self.values[:count]
        if self.code.watched:
            stepper.pars[count:] = self._event_scales(state)
            if stepper.time != time or not np.array_equal(stepper.state, state):
                # heyoka is deaf for a while to an event that has just happened, but not elsewhere
                stepper.reset_cooldowns()
        stepper.time = time
        stepper.state[:] = state
        at_start = sum(t <= time for t in moments)
        grid = [time, *moments[at_start:]]
        if grid[-1] < end:
            grid.append(end)
        first = np.tile(np.asarray(state, dtype=float), (at_start, 1))
        if len(grid) == 1:
            return Outcome(time, np.array(state), "", first, 0)
        outcome, _, _, steps, _, values = stepper.propagate_grid(
            np.array(grid), max_steps=most_steps
        )
        code = int(outcome)
        guard = ""
        if code > _SUCCESS:
            guard = self.system.guards[self.code.watched[-code - 1]].name
        elif code != _TIME_LIMIT:
            guard = "failure"
        samples = np.concatenate([first, values[1 : len(moments) - at_start + 1]])
        return Outcome(float(stepper.time), np.array(stepper.state), guard, samples, steps)

    def _event_scales(self, state: FloatArray) -> list[float]:
        """Powers of two that scale large guards to one."""
        sizes = np.abs(self.guard_values(state)[list(self.code.watched)])
        exponents = np.maximum(np.frexp(np.where(np.isfinite(sizes), sizes, 1.0))[1], 0)
        return list(np.ldexp(1.0, -exponents))


_TIME_LIMIT, _SUCCESS = -4294967299, -4294967297


@dataclass(frozen=True, eq=False)
class ContactNumbers:
    """What is known of a contact at a state, without normal force and dry friction; body axes.

    Attributes
    ----------
    r, gamma, gammadot, slip, rolling : array (3,)
    slip_rate, free_acceleration, free_turn : array (3,)
        Accelerations of the touching particle over the support and of the centre of mass, and ω̇,
        with the forces that do not depend on the normal force alone.
    contact_velocity : array (3,)
        Of the touching particle in space.
    spin, normal_rate, spin_rate, energy, gap : float
    q : array (3,)
        Couple for each unit of normal force of the laws without threshold for slip and spin; zero
        for a body that does not roll, whose resistance to rolling has no direction.
    rates_of_place : array (size,)
        Of attitude, position and normal, in the columns of the state; zero in the others.
    mobility : Mobility
    """

    r: FloatArray
    gamma: FloatArray
    gammadot: FloatArray
    slip: FloatArray
    rolling: FloatArray
    slip_rate: FloatArray
    free_acceleration: FloatArray
    free_turn: FloatArray
    contact_velocity: FloatArray
    spin: float
    normal_rate: float
    spin_rate: float
    energy: float
    gap: float
    q: FloatArray
    rates_of_place: FloatArray
    mobility: Mobility


class CompiledContact:
    """A situation with all its modes, compiled when they are first needed.

    Parameters
    ----------
    situation : FrictionalContact
    tolerance : float
        Relative error of each step.
    """

    def __init__(self, situation: FrictionalContact, tolerance: float = 1e-16) -> None:
        self.situation = situation
        self.tolerance = tolerance
        self._modes: dict[tuple[FrictionalContact, Mode], ModeIntegrator] = {}
        self._names = [str(name) for name in self.mode(FLIGHT).system.symbols]
        self.size = len(self._names)
        # laws without a threshold for slip or spin act alike in all modes
        others = tuple(law for law in situation.laws if law.static_mu is None and not law.spin_arm)
        self._neutral = equations_of_motion(replace(situation, laws=others), Mode())
        self._function = _neutral_function(self._neutral, situation.laws)
        self._values = np.array([float(x) for x in self._neutral.defaults.values()])
        self._mass, self._inertia = situation.body.mass, situation.body.tensor

    def mode(self, mode: Mode, situation: FrictionalContact | None = None) -> ModeIntegrator:
        """The integrator of a mode, of the situation or one like it."""
        situation = situation or self.situation
        if (situation, mode) not in self._modes:
            system = equations_of_motion(situation, mode)
            code = compile_system(system, self.tolerance)
            numbers = np.array([float(x) for x in system.defaults.values()])
            self._modes[situation, mode] = ModeIntegrator(
                system=system,
                code=code,
                stepper=copy.copy(code.integrator),
                values=numbers,
                columns=_observable_columns(system),
                places={str(p.symbol): i for i, p in enumerate(system.parameters)},
            )
        return self._modes[situation, mode]

    def work_column(self, law: str) -> int:
        """The column of the state with the work lost to a law."""
        return self._names.index(str(work_symbol(law)))

    def numbers(self, state: FloatArray) -> ContactNumbers:
        """What is known of the contact at a state."""
        padded = np.zeros(len(self._neutral.symbols))
        padded[:WORK] = state[:WORK]
        numbers = self._function(padded, pars=self._values[: self._function.nparams])
        vectors = dict(
            zip(_VECTORS, numbers.reshape(-1)[: 3 * len(_VECTORS)].reshape(-1, 3), strict=True)
        )
        rest = numbers[3 * len(_VECTORS) :]
        spin_now, normal, turning, energy, height = map(float, rest[:5])
        rates = np.zeros(self.size)
        for columns in (ATTITUDE, POSITION, NORMAL):
            rates[columns] = rest[11 : 11 + WORK][columns]
        unit = vectors[gamma] / float(np.linalg.norm(vectors[gamma]))
        touch = mobility(self._mass, self._inertia, vectors[r], unit)
        # a couple that does not depend on the normal force belongs to the free motion
        turn = touch.inverse_inertia @ rest[8:11]
        return ContactNumbers(
            r=vectors[r],
            gamma=vectors[gamma],
            gammadot=vectors[gammadot],
            slip=vectors[slip],
            rolling=vectors[rolling],
            slip_rate=vectors[slip_rate] + np.cross(turn, touch.r),
            free_acceleration=vectors[free_acceleration],
            free_turn=vectors[free_turn] + turn,
            contact_velocity=vectors[contact_velocity],
            spin=spin_now,
            normal_rate=normal,
            spin_rate=turning + float(touch.gamma @ turn),
            energy=energy,
            gap=height,
            q=rest[5:8] if np.isfinite(rest[5:8]).all() else np.zeros(3),
            rates_of_place=rates,
            mobility=touch,
        )


def _observable_columns(system: System) -> dict[str, tuple[int, int]]:
    """First column and number of components of each observable, by name."""
    columns: dict[str, tuple[int, int]] = {}
    first = 0
    for item in system.observables:
        value = to_components(item.value)
        size = len(value) if isinstance(value, sp.MatrixBase) else 1
        columns[item.name] = (first, size)
        first += size
    return columns


def with_values(mode: ModeIntegrator, values: Mapping[str, float]) -> ModeIntegrator:
    """A mode with other values of parameters, by name."""
    numbers = mode.values.copy()
    for name, value in values.items():
        if name in mode.places:
            numbers[mode.places[name]] = value
    return replace(mode, values=numbers)


@lru_cache(maxsize=32)
def _neutral_function(system: System, laws: tuple[FrictionLaw, ...]) -> hy.cfunc:
    """The numbers of a contact, compiled; see ContactNumbers."""
    total = sum((law.reaction_at_rest for law in laws), Reaction())

    def compute() -> hy.cfunc:
        translate = Translator(system)
        values = {item.name: item.value for item in system.observables}
        formulas = [*_VECTORS, *_SCALARS, values["energy"], values["gap"]]
        formulas += [constant(list(to_components(x))) for x in (total.q, total.couple)]
        formulas += system.rates[:WORK]
        return hy.cfunc(translate.all(formulas), translate.variables)

    parts = [
        *system.symbols,
        *(x for pair in system.scalar_definitions for x in pair),
        *system.rates,
        *(p.symbol for p in system.parameters),
        *to_components(total.q),
        *to_components(total.couple),
    ]
    name = code_cache.code_name("contact", sp.srepr(parts))
    return code_cache.remember(name, compute)[0]

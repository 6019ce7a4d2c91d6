"""Compiled equations of each contact mode, and the contact quantities evaluated at a state."""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.flow.machine_code.native_formulas import NativeFormulas, native_formulas
from flowlanes.flow.taylor.compiled_system import compile_system
from flowlanes.flow.validation import overflow_reason
from flowlanes.formulas.graph import Graph, Reader, Term
from flowlanes.system.arrays import FloatArray
from flowlanes.system.formula_text import exact_text
from flowlanes.system.named_formulas import flat, scalars
from flowlanes.system.system import System
from flowlanes.system.tolerance import FINEST_TOLERANCE

from ..equations.equations_of_motion import contact_equations, work_symbol
from ..equations.free_body import free_body_parameters
from ..equations.situation import FrictionalContact
from ..equations.structure import SharedEquations
from ..friction.friction_law import FrictionLaw, Reaction
from ..friction.modes import FLIGHT, Mode
from ..friction.symbols import (
    contact_velocity,
    free_acceleration,
    free_turn,
    gamma,
    gammadot,
    height,
    normal_rate,
    r,
    rolling,
    slip,
    slip_rate,
    spin,
    spin_rate,
)
from ..impact.mobility import Mobility, inverse_of, mobility_at
from .event_rules import COARSEST_WITH_FRICTION
from .mode_integrator import ModeIntegrator, observable_columns, with_values

#: Columns of the state that are common to all modes.
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

NO_RATES = (
    "the equations of motion have no finite value there; the body must be smooth and strictly "
    "convex where it touches, and its formulas finite"
)

#: Index, among the compiled outputs, of the couple per unit of normal force.
_COUPLE = 3 * len(_VECTORS) + len(_SCALARS) + 2


@dataclass(frozen=True, eq=False)
class ContactNumbers:
    """Kinematics and free dynamics of a contact, in body axes.

    "Free" means without normal force and without dry friction.

    Attributes
    ----------
    r, gamma, gammadot, slip, rolling : array (3,)
    slip_rate, free_acceleration, free_turn : array (3,)
        Accelerations of the touching particle over the support and of the centre of mass, and ω̇,
        with the forces that do not depend on the normal force alone.
    contact_velocity : array (3,)
        Velocity of the touching particle in space.
    spin, normal_rate, spin_rate, energy, gap : float
    q : array (3,)
        Couple for each unit of normal force of the laws without threshold for slip and spin; zero
        for a body that does not roll, whose resistance to rolling has no direction.
    rates_of_place : array (size,)
        Rates of attitude, position and normal, in the columns of the state; zero elsewhere.
    mobility : Mobility
    support_turn_rate : array (3,)
        Rate of the angular velocity of the support, Ω_s ζ×ω.
    unheld_rise : float
        Normal acceleration of the contact without any force of the support.
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
    support_turn_rate: FloatArray
    unheld_rise: float


@arguments_checked
class CompiledContact:
    """A situation with all its modes, compiled when they are first needed.

    Parameters
    ----------
    situation : FrictionalContact
    tolerance : float
        See :mod:`flowlanes.system.tolerance`, at most 1e-10.

    Raises
    ------
    InputError
        If the tolerance is greater, or not a positive number of double precision.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> from nonholonomic.contact import Coulomb, FrictionalContact
    >>> ball = nonholonomic.Body(0.2, (2e-4, 2e-4, 2e-4), nonholonomic.Ball(0.05))
    >>> table = FrictionalContact(
    ...     ball, laws=(Coulomb(0.2),), field=nonholonomic.Forces(gravity=9.81)
    ... )
    >>> nonholonomic.contact.CompiledContact(table).size
    18
    """

    def __init__(
        self, situation: FrictionalContact, tolerance: float = FINEST_TOLERANCE["double"]
    ) -> None:
        if tolerance > COARSEST_WITH_FRICTION:
            raise InputError(
                f"tolerance {tolerance:g}: with friction it must be at most "
                f"{COARSEST_WITH_FRICTION:g}, since slips are followed until they are as small"
            )
        self.situation = situation
        self.tolerance = tolerance
        # The equations are prepared once and shared by all situations that differ only in
        # parameters.
        self._defaults = {str(p.symbol): float(p.default) for p in free_body_parameters(situation)}
        self._modes: dict[tuple[FrictionalContact, Mode], ModeIntegrator] = {}
        flight = self.mode(FLIGHT).system.symbols
        self._names = [str(name) for name in flight if name != height]
        self.size = len(self._names)
        self._numbers = _prepared_numbers(SharedEquations(situation))
        self._values = self._numbers.values_of(self._values_of(situation))
        self._last: tuple[bytes, ContactNumbers] | None = None
        self._mass = situation.body.mass
        self._inverse_inertia = inverse_of(situation.body.tensor)

    def __repr__(self) -> str:
        return f"CompiledContact({self.situation.setting}; tolerance {self.tolerance:g})"

    def __reduce__(self) -> tuple[type[CompiledContact], tuple[FrictionalContact, float]]:
        return CompiledContact, (self.situation, self.tolerance)

    def mode(self, mode: Mode, situation: FrictionalContact | None = None) -> ModeIntegrator:
        """The integrator of a mode, for this situation or for one with other laws of friction."""
        situation = situation or self.situation
        if (situation, mode) not in self._modes:
            equations, thread = SharedEquations(situation), threading.get_ident()
            prepared = _mode_of_thread(equations, mode, self.tolerance, thread)
            self._modes[situation, mode] = with_values(prepared, self._values_of(situation))
        return self._modes[situation, mode]

    def _values_of(self, situation: FrictionalContact) -> dict[str, float]:
        laws = {str(p.symbol): float(p.default) for law in situation.laws for p in law.parameters}
        return self._defaults | laws

    @property
    def columns(self) -> dict[str, slice]:
        """The columns of each variable of the state, by name; the dissipated works come last."""
        columns: dict[str, slice] = {}
        first = 0
        for name in self.mode(FLIGHT).system.state:
            if name == height:
                continue
            size = len(flat([name]))
            columns[str(name)] = slice(first, first + size)
            first += size
        return columns

    def work_column(self, law: str) -> int:
        """The column of the state that holds the work dissipated by a law."""
        return self._names.index(str(work_symbol(law)))

    def obstacle(self, state: FloatArray) -> str:
        """Explain why nothing can be computed from a state; empty if the state is usable.

        The squares of energies and forces must be representable as doubles.
        """
        function, count = self._numbers.function, self._numbers.size
        start = np.append(state[:WORK], np.zeros(count - WORK))
        names = [*self._names[:WORK], *self._numbers.names]

        def finite(numbers: Sequence[float]) -> bool:
            values = np.array([*numbers[:WORK], *start[WORK:], *numbers[WORK:]])
            result = function(values[:count], values[count:])
            # A body that does not roll gives the rolling resistance no direction, so its couple is
            # undefined.
            rates = _COUPLE + 6
            without = np.r_[_COUPLE : _COUPLE + 3, rates + VELOCITY.start : rates + OMEGA.stop]
            known = np.delete(result.reshape(-1), without)
            return bool(np.isfinite(known * known).all())

        numbers = [*start[:WORK].tolist(), *self._values.tolist()]
        with np.errstate(all="ignore"):
            return "" if finite(numbers) else overflow_reason(names, numbers, finite) or NO_RATES

    def numbers(self, state: FloatArray) -> ContactNumbers:
        """The contact quantities at a state; the most recent result is cached."""
        key = state[:WORK].tobytes()
        if self._last is None or self._last[0] != key:
            self._last = (key, self._computed_numbers(state))
        return self._last[1]

    def without_rolling(self, numbers: ContactNumbers) -> ContactNumbers:
        """Kinematics and dynamics without rolling; see `equations.held_rolling`.

        Parameters
        ----------
        numbers : ContactNumbers
            Contact quantities of a body that may roll.
        """
        mobility, inertia = numbers.mobility, np.linalg.inv(self._inverse_inertia)
        given = numbers.spin * numbers.gammadot + numbers.support_turn_rate
        moment = float(mobility.gamma @ inertia @ mobility.gamma)
        along = float(mobility.gamma @ inertia @ (numbers.free_turn - given)) / moment
        turn = given + along * mobility.gamma
        change = turn - numbers.free_turn
        return replace(
            numbers,
            free_turn=turn,
            slip_rate=numbers.slip_rate + np.cross(change, mobility.r),
            spin_rate=numbers.spin_rate + float(mobility.gamma @ change),
            # A rolling velocity of rounding size would give this couple an arbitrary direction.
            q=np.zeros(3),
            mobility=mobility_at(
                mobility.mass,
                np.outer(mobility.gamma, mobility.gamma) / moment,
                mobility.r,
                mobility.gamma,
            ),
        )

    def _computed_numbers(self, state: FloatArray) -> ContactNumbers:
        padded = np.zeros(self._numbers.size)
        padded[:WORK] = state[:WORK]
        function = self._numbers.function
        numbers = function(padded, self._values)
        vectors = dict(
            zip(_VECTORS, numbers.reshape(-1)[: 3 * len(_VECTORS)].reshape(-1, 3), strict=True)
        )
        rest = numbers[3 * len(_VECTORS) :]
        spin_now, normal, turning, energy, height = map(float, rest[:5])
        rates = np.zeros(self.size)
        for columns in (ATTITUDE, POSITION, NORMAL):
            rates[columns] = rest[11 : 11 + WORK][columns]
        unit = vectors[gamma] / float(np.linalg.norm(vectors[gamma]))
        mobility = mobility_at(self._mass, self._inverse_inertia, vectors[r], unit)
        turntable, support_turn_rate = self.situation.surface.turntable, np.zeros(3)
        if turntable:
            from scipy.spatial.transform import Rotation

            vertical = Rotation.from_quat(state[ATTITUDE], scalar_first=True).as_matrix()[2]
            support_turn_rate = turntable * np.cross(vertical, state[OMEGA])
        # A couple that does not depend on the normal force is part of the free motion.
        turn = mobility.inverse_inertia @ rest[8:11]
        return ContactNumbers(
            r=vectors[r],
            gamma=vectors[gamma],
            gammadot=vectors[gammadot],
            slip=vectors[slip],
            rolling=vectors[rolling],
            slip_rate=vectors[slip_rate] + np.cross(turn, mobility.r),
            free_acceleration=vectors[free_acceleration],
            free_turn=vectors[free_turn] + turn,
            contact_velocity=vectors[contact_velocity],
            spin=spin_now,
            normal_rate=normal,
            spin_rate=turning + float(mobility.gamma @ turn),
            energy=energy,
            gap=height,
            q=rest[5:8] if np.isfinite(rest[5:8]).all() else np.zeros(3),
            rates_of_place=rates,
            mobility=mobility,
            support_turn_rate=support_turn_rate,
            unheld_rise=float(unit @ vectors[slip_rate]) + normal,
        )


@lru_cache(maxsize=512)
def _mode_of_thread(
    equations: SharedEquations, mode: Mode, tolerance: float, _: int
) -> ModeIntegrator:
    """A mode with an integrator owned by the current thread, since integrating changes it."""
    prepared = _prepared_mode(equations, mode, tolerance)
    return replace(prepared, stepper=prepared.stepper.copy())


@lru_cache(maxsize=256)
def _prepared_mode(equations: SharedEquations, mode: Mode, tolerance: float) -> ModeIntegrator:
    """A mode shared by all situations with the same equations, with the values of one of them."""
    system = contact_equations(equations.situation, mode)
    code = compile_system(system, tolerance)
    return ModeIntegrator(
        system=system,
        code=code,
        stepper=code.series,
        values=np.array([float(x) for x in system.defaults.values()]),
        columns=observable_columns(system),
        places={str(p.symbol): i for i, p in enumerate(system.parameters)},
    )


@dataclass(frozen=True, eq=False)
class _PreparedNumbers:
    """The compiled function for the contact quantities; see ContactNumbers.

    Attributes
    ----------
    function : NativeFormulas
        Function of a state without work columns.
    size : int
        Size of that state.
    names : tuple of str
        Names of its parameters.
    defaults : array
    """

    function: NativeFormulas
    size: int
    names: tuple[str, ...]
    defaults: FloatArray

    def values_of(self, numbers: Mapping[str, float]) -> FloatArray:
        """Values of the parameters, in the order of the function's arguments."""
        pairs = zip(self.names, self.defaults.tolist(), strict=True)
        return np.array([numbers.get(name, value) for name, value in pairs])


@lru_cache(maxsize=64)
def _prepared_numbers(equations: SharedEquations) -> _PreparedNumbers:
    situation = equations.situation
    # Laws without a threshold for slip or spin act the same way in all modes.
    others = tuple(law for law in situation.laws if law.static_mu is None and not law.spin_arm)
    neutral = contact_equations(replace(situation, laws=others), Mode())
    return _PreparedNumbers(
        function=_compile_numbers(neutral, situation.laws),
        size=len(neutral.symbols),
        names=tuple(str(p.symbol) for p in neutral.parameters),
        defaults=np.array([float(x) for x in neutral.defaults.values()]),
    )


def _compile_numbers(system: System, laws: tuple[FrictionLaw, ...]) -> NativeFormulas:
    """Compile the contact quantities; see ContactNumbers."""
    total = sum((law.reaction_at_rest for law in laws), Reaction())

    def compute() -> list[Term]:
        reader = Reader(system, Graph())
        values = {item.name: item.value for item in system.observables}
        formulas = [*_VECTORS, *_SCALARS, values["energy"], values["gap"]]
        formulas += [total.q, total.couple]
        formulas += system.rates[:WORK]
        return reader.components(formulas)

    parts = [
        *system.symbols,
        *(x for pair in system.scalar_definitions for x in pair),
        *system.rates,
        *(p.symbol for p in system.parameters),
        *scalars((total.q, total.couple)),
    ]
    return native_formulas(f"contact {exact_text(parts)}", len(system.symbols), compute)

"""Motions on a torus in closed form: from theta functions to states at any time."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.balls import ball_values, components, number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System

from .base.exact_start import with_definitions
from .base.solution import ClosedForm, NamedConstant, Solution, finite_times
from .genus_two.reconstruction import Lift, lift
from .genus_two.separated_motion import SeparatedMotion, on_arrays, separate
from .genus_two.separation import SeparatedSystem, nu
from .genus_two.time_map import TimeMap, clock_of

#: Working precision of the set-up, in bits.
BITS = 320
QUATERNION = 4


# Compared by identity, so that prepared data can be cached.
@dataclass(frozen=True, repr=False, eq=False)
class GenusTwo(Solution):
    """A motion on a two-dimensional torus.

    Attributes
    ----------
    system : System
        Lifted to space if it has a motion there.
    start : tuple of numbers
        The lifted state at t = 0, as given.
    """

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    start: tuple[NumberOrText, ...]
    separated_motion: SeparatedMotion

    @property
    def separable(self) -> SeparatedSystem:
        """The formulas."""
        return self.separated_motion.separable

    @cached_property
    def clock(self) -> TimeMap:
        """t as a function of τ, and its inverse."""
        return clock_of(self.separated_motion, BITS)

    @cached_property
    def lift(self) -> Lift | None:
        """The motion in space."""
        return lift(
            self.separated_motion, self.clock, self.start[len(self.separable.system.symbols) :]
        )

    @cached_property
    def _state(self) -> Callable[..., FloatArray]:
        return on_arrays(self.separated_motion, self.separable.system.symbols)

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """Lifted states (n, size) at `times` (n,), in double precision."""
        moment = self.clock.torus_point(finite_times(times))
        reduced = self._state(*self.separated_motion.torus.values(moment.v))
        if self.lift is None:
            return reduced.T
        return np.concatenate([reduced, self.lift.in_space(moment)]).T

    @property
    def phase_rate(self) -> float:
        """The rate at which the phases grow with time, in turns."""
        V_1, V_2 = (abs(number(x)) for x in self.separated_motion.torus.V)
        return (V_1 + V_2) / number(self.clock.mean)

    @property
    def not_rigorous(self) -> str:
        """A sentence on the part of the state for which :meth:`rigorous` has no bounds; or ""."""
        of = self.separable
        lifted = len(self.start) - len(of.system.symbols)
        if of.system.reconstruction is None or len(of.fixed) > 1:
            return ""
        if not of.fixed:
            return (
                f"{of.title}: no direction is known that stays in space, so that the motion there "
                f"has no error bounds, beside {', '.join(map(str, of.system.state))}"
            )
        if lifted == QUATERNION:
            return ""
        return (
            f"{of.title}: one direction alone is known that stays in space, so that the place "
            "there has no error bounds"
        )

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The lifted state at one time as balls."""
        from .rigorous import rigorous_state

        return rigorous_state(self, time, digits)

    @cached_property
    def form(self) -> ClosedForm:
        """The curve, its ovals, frequencies."""
        with ctx.workprec(BITS):
            return _form(self)


def _form(solution: GenusTwo) -> ClosedForm:
    motion, separable = solution.separated_motion, solution.separable
    torus = motion.torus
    turns = torus.turns
    y, z, kappa = sp.symbols("y z kappa")
    z_1, z_2, y_1, y_2 = sp.symbols("z_1 z_2 y_1 y_2")
    d = [sp.Symbol(f"d{name}") for name in ("z_1", "z_2", "tau", "t")]
    a, b = separable.speeds
    clock = solution.clock
    figures = [
        *(
            NamedConstant(
                str(name), motion.values[name], *_meaning_and_unit(motion, motion.values[name])
            )
            for name, _ in separable.constants
        ),
        *(
            NamedConstant(f"e_{i}", root, "root of the curve")
            for i, root in enumerate(motion.curve.roots, 1)
        ),
        *(
            NamedConstant(f"V_{i}", x, f"turns of z_{i} per unit of τ")
            for i, x in enumerate(turns, 1)
        ),
        NamedConstant("V_1/V_2", turns[0] / turns[1], "rotation number"),
        *(
            NamedConstant(f"Y_{i + 1}{j + 1}", torus.lattice.Y[i, j], "period matrix iY")
            for i, j in ((0, 0), (0, 1), (1, 1))
        ),
        NamedConstant("mean dt/dtau", clock.mean, "mean rate of the clock (error estimated)"),
        *(
            NamedConstant(
                f"Omega_{i}", x / clock.mean, f"frequency of z_{i} (error estimated)", "turns/s"
            )
            for i, x in enumerate(turns, 1)
        ),
    ]
    ends = [motion.curve.ends(left) for left in torus.lattice.ovals]
    return ClosedForm(
        title=separable.title,
        motion="two-frequency motion on a torus",
        equations=(
            (nu, separable.direction),
            *(
                (own**2, kappa * weight * (pole - z_1) * (pole - z_2))
                for own, weight, pole in zip(
                    nu.symbols, separable.weights, separable.poles, strict=True
                )
            ),
            (y**2, sp.Mul(separable.leading, *(z - root for root in separable.roots))),
            (d[0] / y_1 + d[1] / y_2, sp.sympify(a) * d[2]),
            (z_1 * d[0] / y_1 + z_2 * d[1] / y_2, sp.sympify(b) * d[2]),
            (d[3] / d[2], components(separable.time_rescaling)[0]),
        ),
        constants=tuple(figures),
        ovals=tuple((number(low), number(high)) for low, high in ends),
        source=separable.source,
    )


def _meaning_and_unit(motion: SeparatedMotion, value: arb) -> tuple[str, str]:
    """Meaning and unit of a constant: those of the integral with this value."""
    system = motion.separable.system
    known = with_definitions(system, motion.values, motion.state)
    for law in system.integrals:
        if ball_values(components(law.value), known)[0].overlaps(value):
            return law.meaning or law.name, law.unit
    return "constant", ""


def solve_on_torus(
    separable: SeparatedSystem,
    values: Mapping[sp.Symbol, NumberOrText],
    start: Sequence[NumberOrText],
) -> GenusTwo:
    """Solve one motion of a separable system.

    Parameters
    ----------
    values : mapping of Symbol to number
        The parameters of its system, taken as exact numbers.
    start : sequence of numbers
        The lifted state at t = 0, in flat order (the reduced one where there is no motion).

    Raises
    ------
    InputError
        If the start is off the phase space or off the level.
    DegenerateError
        If roots of the curve coincide.
    """
    system = separable.system
    lifted = system.lifted() if system.reconstruction else system
    if len(start) != len(lifted.symbols):
        raise InputError(
            f"start: it has {len(start)} numbers; {lifted.name} needs {len(lifted.symbols)}"
        )
    with ctx.workprec(BITS):
        motion = separate(separable, values, start[: len(system.symbols)])
    return GenusTwo(lifted, dict(values), tuple(start), motion)

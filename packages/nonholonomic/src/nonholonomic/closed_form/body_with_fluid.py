"""Bodies filled with fluid that move like their equivalent rigid body.

A fluid in potential flow, N = 0, remains so.  In a spherical cavity, C = E, Ṅ = ξ×N = N×ω, so N is
fixed in space.  If each cavity is of one of these kinds, P = M − ΣN satisfies the equations of the
equivalent rigid body, and so does ω if it is part of the state (docs/fluid.md).  The motion is then
that of the rigid body, and N follows from the attitude.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb, ctx, fmpq

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.formulas.balls import ball, exact
from flowlanes.formulas.errors import NotExactError, OutOfReachError, UnknownSymbolError
from flowlanes.formulas.relative_zero import ROUNDING
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import Reconstruction, System
from flowlanes.system.vectors import Diagonal, Symmetric, Vector, zero

from ..mechanics.rolling.attitude import attitude, attitude_relations, quaternion_rate, unit_length
from .base.derived_solution import DerivedSolution
from .base.problem import Problem, rates_at, rational_points
from .base.solution import Solution
from .one_degree.functions import N
from .one_degree.vectors import conjugate, product

SPACE = 3
#: Number of components of the two vectors of a rigid body's state, and end of its attitude.
RIGID, TURNED = 6, 10
M, omega, gamma = (Vector(name) for name in ("M", "omega", "gamma"))

Numbers = Mapping[sp.Symbol, Fraction]


@dataclass(frozen=True, repr=False)
class FluidSolution(DerivedSolution):
    """A motion of a body with fluid, from that of the equivalent rigid body.

    Attributes
    ----------
    fixed : tuple of three arb, or none
        The vectors N in space axes; empty ones for a fluid in potential flow.
    in_space : bool
        Whether the attitude is part of the state.
    momentum : bool
        Whether the state contains M instead of ω.
    """

    fixed: tuple[Sequence[arb], ...]
    in_space: bool
    momentum: bool

    def _state(self, inner: Sequence[N], number: Callable[[arb], N]) -> list[N]:
        first: list[N] = list(inner[:SPACE])
        vertical: list[N] = list(inner[SPACE:RIGID])
        turn: list[N] = list(inner[RIGID:TURNED])
        space: list[N] = list(inner[RIGID:]) if self.in_space else []
        vectors: list[list[N]] = [
            product(conjugate(turn), [number(x) for x in direction])
            if direction
            else [0 * first[0]] * SPACE
            for direction in self.fixed
        ]
        if self.momentum:
            for vector in vectors:
                first = [x + y for x, y in zip(first, vector, strict=True)]
        state = first + vertical
        for vector in vectors:
            state = state + vector
        return state + space

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """Lifted states at `times` (n,), as an array (n, size), in double precision."""
        columns = self.inner.states(times).T
        return np.stack(self._state(list(columns), lambda x: np.asarray(float(x))), axis=1)

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The lifted state at one time as balls that contain the exact state."""
        with ctx.workdps(digits + 30):
            return tuple(self._state(self.inner.rigorous(time, digits), lambda x: x))


def solve_with_fluid(
    problem: Problem, fluids: tuple[Vector, ...], solve: Callable[[Problem], Solution]
) -> Solution | None:
    """Solve a body with fluid; None unless each cavity is spherical or has no circulation.

    Parameters
    ----------
    problem : Problem
    fluids : tuple of Vector
        The circulation vectors in its state.
    solve : callable
        Solves the problem of the rigid body.
    """
    system = problem.system
    if system.state != (system.state[0], gamma, *fluids) or system.state[0] not in (M, omega):
        return None
    spherical = [name for name in fluids if _is_spherical(problem, name)]
    if not all(name in spherical or _is_potential(problem, name) for name in fluids):
        return None
    rigid = _rigid_body(problem, fluids)
    numbers = {s: exact(x) for s, x in problem.parameters.items()}
    try:
        if not _has_equations_of(rigid, system, fluids, spherical, numbers):
            return None
    except (NotExactError, OutOfReachError, UnknownSymbolError, ZeroDivisionError):
        # A field with roots cannot be compared exactly; for a given rolling body it is known to
        # agree.
        if problem.rolling is None:
            return None
    parameters = {p.symbol: problem.parameters[p.symbol] for p in rigid.parameters}
    with_momentum = system.state[0] == M
    places = {name: place for name, place in system.slices}
    with ctx.workdps(120):
        start = [ball(exact(x)) for x in problem.start]
        first = start[:SPACE]
        # The fluid in a spherical cavity keeps its momentum N in space (C = E): M − ΣN moves as the
        # momentum of the rigid body.
        if with_momentum:
            for name in spherical:
                first = [x - y for x, y in zip(first, start[places[name]], strict=True)]
        vertical, space = start[SPACE:RIGID], start[len(system.symbols) :]
        if system.reconstruction is None:
            space = _upright(vertical)
        fixed = tuple(
            product(space[:4], start[places[name]]) if name in spherical else () for name in fluids
        )
    rolling = None if problem.rolling is None else problem.rolling.equivalent
    inner = solve(Problem(rigid, parameters, (*first, *vertical, *space), rolling))
    lifted = system.lifted() if system.reconstruction else system
    return FluidSolution(
        lifted,
        problem.parameters,
        inner,
        fixed,
        system.reconstruction is not None,
        with_momentum,
    )


def _tensor(problem: Problem, letter: str, name: Vector) -> Diagonal | Symmetric:
    """The tensor W or C of a fluid."""
    full = Symmetric(letter + str(name)[1:])
    return full if full.symbols[1] in problem.parameters else Diagonal(str(full))


def _is_spherical(problem: Problem, name: Vector) -> bool:
    """Whether C = E, exactly."""
    entries = _tensor(problem, "C", name).entries
    numbers = {s: exact(problem.parameters[s]) for s in entries.free_symbols}
    return all(
        numbers.get(entries[i, j], Fraction(0)) == int(i == j)
        for i in range(SPACE)
        for j in range(SPACE)
    )


def _is_potential(problem: Problem, name: Vector) -> bool:
    """Whether N = K(ξ + Cω) vanishes, up to rounding of doubles."""
    if all(exact(problem.start[i]) == 0 for i in _components_of(problem.system, name)):
        return True
    C, W = _tensor(problem, "C", name), _tensor(problem, "W", name)
    sizes = [
        max(abs(float(x)) for x in problem.values(scalars(vector)))
        for vector in (W * name, C * omega)
    ]
    return sizes[0] <= float(Fraction(int(ROUNDING.p), int(ROUNDING.q))) * sizes[1]


def _components_of(system: System, name: Vector) -> range:
    (place,) = (place for each, place in system.slices if each == name)
    return range(place.start, place.stop)


def _rigid_body(problem: Problem, fluids: tuple[Vector, ...]) -> System:
    """The equivalent rigid body with N = 0, and a motion in space even if the problem has none."""
    system = problem.system
    if problem.rolling is not None:
        rigid = problem.rolling.equivalent.system(system.name, system.title)
    else:
        none = dict.fromkeys(fluids, zero)
        own = {str(name)[1:] for name in none}
        gone = {f"{letter}{number}" for letter in "WC" for number in own}
        kept = [p for p in system.parameters if str(p.symbol).rpartition("_")[0] not in gone]
        rigid = System(
            name=system.name,
            title=system.title,
            parameters=tuple(kept),
            definitions=[
                (symbol, formula.xreplace(none))
                for symbol, formula in system.definitions
                if not _is_fluid_velocity(symbol, own)
            ],
            field=[(s, f.xreplace(none)) for s, f in system.field if s not in none],
            relations=system.relations,
            reconstruction=system.reconstruction,
        )
    if system.reconstruction is not None:
        return rigid
    turning = Reconstruction(
        field={attitude: quaternion_rate(omega)},
        relations=(unit_length(), *attitude_relations(gamma)),
        observables=(),
    )
    return replace(rigid, reconstruction=turning)


def _is_fluid_velocity(symbol: sp.Basic, numbers: set[str]) -> bool:
    """Whether a definition is the ξ of a fluid."""
    return str(symbol) in {f"xi{number}" for number in numbers}


def _has_equations_of(
    rigid: System,
    system: System,
    fluids: Sequence[Vector],
    spherical: Sequence[Vector],
    numbers: Numbers,
) -> bool:
    """Whether the system has the equations of the rigid body with fluid, tested at exact points."""
    own = {p.symbol: numbers[p.symbol] for p in rigid.parameters}
    compared = False
    for point in rational_points(replace(rigid, reconstruction=None), own):
        compared = True
        vectors = [
            [fmpq(3 * i + j - 4, 5 + i) if name in spherical else fmpq(0) for j in range(SPACE)]
            for i, name in enumerate(fluids)
        ]
        shift = [sum((v[j] for v in vectors), fmpq(0)) for j in range(SPACE)]
        first = point[:SPACE]
        if system.state[0] == M:
            first = [x + y for x, y in zip(first, shift, strict=True)]
        whole = [*first, *point[SPACE:], *(x for v in vectors for x in v)]
        rates = rates_at(system, whole, numbers)
        expected = rates_at(rigid, point, own)
        turning = [rates[RIGID + SPACE * i : RIGID + SPACE * (i + 1)] for i in range(len(fluids))]
        if system.state[0] == M:
            gains = [sum((v[j] for v in turning), fmpq(0)) for j in range(SPACE)]
            expected = [*(x + y for x, y in zip(expected, gains, strict=False)), *expected[SPACE:]]
        if rates[:RIGID] != expected:
            return False
        spin = rates_at(_spinning(system), whole, numbers)
        for vector, rate in zip(vectors, turning, strict=True):
            a, b, c = vector
            x, y, z = spin[:SPACE]
            if rate != [b * z - c * y, c * x - a * z, a * y - b * x]:
                return False
    return compared


def _spinning(system: System) -> System:
    """A system whose first rates are ω."""
    first, *others = system.field
    return replace(system, field=[(first[0], omega), *others])


def _upright(vertical: Sequence[arb]) -> list[arb]:
    """The shortest rotation of a unit vector to the third axis, as a unit quaternion."""
    x, y, z = vertical
    # The rotation about v × e₃ = (y, −x, 0) by the angle with the cosine z, not normalised.
    w = 1 + z
    size = (w * w + x * x + y * y).sqrt()
    if size < arb("1e-30"):
        return [arb(0), arb(1), arb(0), arb(0)]
    return [w / size, y / size, -x / size, arb(0)]

"""Linear stability of a System near a steady motion, with any number of digits.

At a point x of the phase space where the field v vanishes, or is a combination of symmetry fields
(a relative equilibrium, at rest in a frame that moves along the symmetries), small deviations ξ
satisfy

    ξ̇ = A ξ,    A = ∂v/∂x − Σ c_i ∂u_i/∂x,    v(x) = Σ c_i u_i(x).

Deviations stay in the phase space: ξ is tangent to the relations, and A acts on the tangent space.
State variables on which no rate depends (a position, a heading) are omitted, and directions along
a family of steady motions can be excluded.  Derivatives are exact: formulas are differentiated
symbolically, through the definitions by the chain rule.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NoReturn, TypeAlias

import mpmath
import sympy as sp

from ...arguments import Parameters, arguments_checked
from ...errors import InputError
from ...formulas.multiprecision import number, slopes
from ...system.laws import Symmetry
from ...system.named_formulas import flat_pairs
from ...system.overview import Overview, WithOverview
from ...system.parameters import parameter_values
from ...system.system import System
from ..initial_states import reduced_start, vector_components
from ..taylor.working_numbers import WorkingNumber
from .multiprecision_subspaces import minimum_norm_solution, null_space_basis, orthogonal_part

NEWTON_STEPS = 60

#: Numbers by variable, or in flat order.
State: TypeAlias = Mapping[Any, Any] | Sequence[Any]


#: Number of growth rates in an overview.
SHOWN = 12


@dataclass(frozen=True, repr=False)
class Linearisation(WithOverview):
    """Small deviations from a steady motion.

    Attributes
    ----------
    system : System
    state : dict of Symbol to mpf
        Steady motion.
    variables : tuple of Symbol
        State variables of the linear equations, in the order of rows and columns of `matrix`.
    matrix : mpmath.matrix (variables, variables)
        A, without the relations.
    basis : mpmath.matrix (variables, dimension)
        Orthonormal basis of the deviations that are tangent to the relations and orthogonal to the
        given family of steady motions.
    reduced : mpmath.matrix (dimension, dimension)
        A in that basis.
    drift : dict of str to mpf
        c_i, the speed of the steady motion along each symmetry.
    digits : int
        Number of correct digits.
    """

    system: System
    state: dict[sp.Symbol, mpmath.mpf]
    variables: tuple[sp.Symbol, ...]
    matrix: mpmath.matrix
    basis: mpmath.matrix
    reduced: mpmath.matrix
    drift: dict[str, mpmath.mpf]
    digits: int

    def __reduce__(self) -> NoReturn:
        raise TypeError("matrices of mpmath cannot be pickled: pickle the eigenvalues")

    def overview(self) -> Overview:
        """System, dimension, and growth rates."""
        rates = [mpmath.nstr(rate, 8) for rate in self.eigenvalues]
        more = f", and {len(rates) - SHOWN} more" if len(rates) > SHOWN else ""
        return Overview(
            f"{self.system.title}: small deviations from a steady motion",
            (
                ("variables", ", ".join(map(str, self.variables))),
                ("dimension", str(self.reduced.rows)),
                ("growth rates", ", ".join(rates[:SHOWN]) + more),
                ("digits", str(self.digits)),
            ),
        )

    @cached_property
    def _modes(self) -> list[tuple[mpmath.mpc, mpmath.matrix]]:
        with mpmath.workdps(_working(self.digits)):
            values, vectors = mpmath.eig(self.reduced)
            modes = [(value, self.basis * vectors[:, i]) for i, value in enumerate(values)]
            # The real parts of a conjugate pair differ only by rounding.
            grain = mpmath.mpf(10) ** (4 - self.digits) * (1 + mpmath.mnorm(self.reduced, 1))
            return sorted(modes, key=lambda m: (-mpmath.nint(m[0].real / grain), -m[0].imag))

    @property
    def eigenvalues(self) -> tuple[mpmath.mpc, ...]:
        """Growth rates (1/s), largest real part first, as complex numbers of mpmath."""
        with mpmath.workdps(self.digits):
            floor = mpmath.mpf(10) ** (-self.digits) * (1 + mpmath.mnorm(self.reduced, 1))
            return tuple(+_clean(value, floor) for value, _ in self._modes)

    @property
    def modes(self) -> tuple[dict[sp.Symbol, mpmath.mpc], ...]:
        """Deviation for each of `eigenvalues`, by state variable."""
        return tuple(dict(zip(self.variables, vector, strict=True)) for _, vector in self._modes)

    @property
    def stable(self) -> bool:
        """True if all eigenvalues have a negative real part (exponential stability)."""
        return all(value.real < 0 for value in self.eigenvalues)


@arguments_checked
def linear_stability(
    system: System,
    state: State,
    parameters: Mapping[Any, Any] | None = None,
    *,
    along: Iterable[Mapping[Any, Any]] = (),
    digits: int = 30,
) -> Linearisation:
    """Linearize a system near a steady motion and compute the eigenvalues.

    Parameters
    ----------
    system : System
        The steady motion may move along symmetries among its laws.
    state : mapping of Symbol or name to number or numbers, or sequence in flat order
        The steady motion, by the variables and vectors of the state, or by others from which
        they follow in double precision.  Numbers of SymPy and mpmath, and strings, count
        with all their digits; a float means the shortest decimal that gives it.  Variables on
        which nothing depends may be left out.
    parameters : mapping of Symbol or name to number, optional
        Values that replace the defaults of the system.
    along : iterable of mappings of Symbol or name to number
        Tangents to a family of steady motions through this one (for example with other speeds).  A
        is zero on them, and their zero eigenvalues are excluded.
    digits : int
        Digits of the eigenvalues.  The computation uses four times as many, so that double and
        fourfold eigenvalues have these digits too, even without a full set of eigenvectors.

    Returns
    -------
    Linearisation

    Raises
    ------
    InputError
        If the state is not in the phase space or not steady, if a name is unknown, or if A is not
        zero on a direction of `along`.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> well = flowlanes.System("well", "Double well", {x: v, v: 3 * x - x**3})
    >>> growth_rates = flowlanes.linear_stability(well, {"x": 0, "v": 0}).eigenvalues
    >>> round(float(growth_rates[0].real), 6)
    1.732051
    """
    with mpmath.workdps(_working(digits)):
        point = _LinearisedSystem(system, state, parameters, digits)
        matrix, drift = point.moving()
        relations = point.slopes_of_relations()
        tangent = null_space_basis(relations, len(point.variables))
        family = [point.vector(direction, "along") for direction in along]
        for direction in family:
            _require_family(system, (matrix, relations), direction, point.tolerance)
        basis = orthogonal_part(tangent, family)
        return Linearisation(
            system=system,
            state=point.point,
            variables=point.variables,
            matrix=matrix,
            basis=basis,
            # the projection of A onto the tangent space; A maps it into itself
            reduced=basis.T * matrix * basis,
            drift=drift,
            digits=digits,
        )


@arguments_checked
def relative_equilibrium(
    system: System,
    guess: State,
    parameters: Parameters = None,
    *,
    fixed_variables: Iterable[sp.Symbol | str] = (),
    digits: int = 30,
) -> dict[sp.Symbol, mpmath.mpf]:
    """Steady motion near a guess, by Newton's method with steps of minimal norm.

    Parameters
    ----------
    system, parameters, digits
        See :func:`linear_stability`.
    guess : mapping of Symbol or name to number or numbers, or sequence in flat order
    fixed_variables : iterable of Symbol or name
        State variables that keep their guessed values, which selects a member of a family.

    Returns
    -------
    dict of Symbol to mpf
        State where the field and the relations vanish, as input of :func:`linear_stability`.

    Raises
    ------
    InputError
        If the iteration does not converge.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> well = flowlanes.System("well", "Double well", {x: v, v: x - x**3})
    >>> state = flowlanes.flow.relative_equilibrium(well, {"x": 0.9, "v": 0.1})
    >>> isinstance(flowlanes.linear_stability(well, state), flowlanes.flow.Linearisation)
    True
    """
    with mpmath.workdps(_working(digits)):
        variables = _variables(system)
        point = _state(system, guess, parameters, variables)
        constants = _constants(system, parameters)
        fixed = {_symbol(system, name, "held") for name in fixed_variables}
        loose = [i for i, s in enumerate(variables) if s not in fixed]
        if not loose:
            raise InputError(f"{system.name}: all state variables are held; leave one to be found")
        formulas = [*_rates(system, variables), *_relations(system)]
        for _ in range(NEWTON_STEPS):
            values, rows = slopes(system, formulas, variables, {**point, **constants})
            # eight more digits than requested, so that the steady motion does not limit the
            # eigenvalues
            if mpmath.norm(values, mpmath.inf) < mpmath.mpf(10) ** (-digits - 8):
                return point
            free = mpmath.matrix([[rows[i, j] for j in loose] for i in range(rows.rows)])
            # Minimal norm, because steady motions form families and the equations are then
            # degenerate.
            move = minimum_norm_solution(free, values)
            for j, change in zip(loose, move, strict=True):
                point[variables[j]] -= change
    raise InputError(
        f"{system.name}: no steady motion was found near the guess; the rates there are still of "
        f"the size {mpmath.nstr(mpmath.norm(values, mpmath.inf), 3)}"
    )


class _LinearisedSystem:
    """System at one state, with its derivatives."""

    def __init__(
        self,
        system: System,
        state: State,
        parameters: Parameters,
        digits: int,
    ) -> None:
        self.system = system
        self.variables = _variables(system)
        self.point = _state(system, state, parameters, self.variables)
        self.values = {**self.point, **_constants(system, parameters)}
        # A state given as floats is accurate to about 16 digits.
        self.tolerance = mpmath.mpf(10) ** (-min(digits, 12))
        self._require_on_phase_space()

    def _field(self, formulas: Sequence[sp.Expr]) -> tuple[mpmath.matrix, mpmath.matrix]:
        return slopes(self.system, formulas, self.variables, self.values)

    def _require_on_phase_space(self) -> None:
        relations = _relations(self.system)
        values, _ = self._field(relations)
        for relation, value in zip(relations, values, strict=True):
            if abs(value) > self.tolerance:
                raise InputError(
                    f"{self.system.name}: the state misses the phase space; the relation "
                    f"{_brief(relation)} is {mpmath.nstr(value, 6)} there and must vanish"
                )

    def _carries(self, law: Symmetry) -> bool:
        """True if a symmetry is valid on the whole phase space for these parameters."""
        level = law.scalar.level
        moving = set(self.system.symbols) | {s for s, _ in self.system.scalar_definitions}
        if any(condition.free_symbols & moving for condition in level):
            return False
        return all(abs(value) < self.tolerance for value in self._field(level)[0])

    def slopes_of_relations(self) -> mpmath.matrix:
        """Differentials of the relations, one per row."""
        return self._field(_relations(self.system))[1]

    def moving(self) -> tuple[mpmath.matrix, dict[str, mpmath.mpf]]:
        """Matrix A, and the speeds along the symmetries."""
        value, matrix = self._field(_rates(self.system, self.variables))
        symmetries = [law for law in self.system.laws_of(Symmetry) if self._carries(law)]
        # Without symmetry fields the motion must be an equilibrium; with them v = Σ c_i u_i is
        # solved for c in the least-squares sense, and a remainder means that the motion is not
        # steady.
        drift: dict[str, mpmath.mpf] = {}
        if symmetries and mpmath.norm(value, mpmath.inf) > self.tolerance:
            fields = [self._field(components(law, self.variables)) for law in symmetries]
            columns = mpmath.matrix([[u[i] for u, _ in fields] for i in range(len(value))])
            speeds = minimum_norm_solution(columns, value)
            for law, speed, (u, slope) in zip(symmetries, speeds, fields, strict=True):
                drift[law.name] = speed
                value, matrix = value - speed * u, matrix - speed * slope
        for symbol, rate in zip(self.variables, value, strict=True):
            if abs(rate) > self.tolerance * 10:
                raise InputError(
                    f"{self.system.name}: the state is not steady; {symbol} changes at the rate "
                    f"{mpmath.nstr(rate, 6)}"
                )
        return matrix, drift

    def vector(self, entries: Mapping[sp.Symbol | str, WorkingNumber], where: str) -> mpmath.matrix:
        """Direction as a column."""
        named = {_symbol(self.system, key, where): number(x, where) for key, x in entries.items()}
        return mpmath.matrix([named.get(s, mpmath.mpf(0)) for s in self.variables])


def _working(digits: int) -> int:
    """Working precision in digits."""
    if not 5 <= digits <= 1000:
        raise InputError(f"digits = {digits}: it must lie between 5 and 1000")
    return 4 * digits + 20


def _clean(value: mpmath.mpc, floor: mpmath.mpf) -> mpmath.mpc:
    """Number without a real or imaginary part that is zero up to rounding."""
    return mpmath.mpc(
        0 if abs(value.real) < floor else value.real, 0 if abs(value.imag) < floor else value.imag
    )


def _brief(formula: sp.Expr) -> str:
    return text if len(text := str(formula)) <= 60 else f"{text[:57]}..."


def _relations(system: System) -> list[sp.Expr]:
    return list(system.scalar.relations)


def _rates(system: System, variables: Sequence[sp.Symbol]) -> list[sp.Expr]:
    rates = dict(zip(system.symbols, system.rates, strict=True))
    return [rates[s] for s in variables]


def components(law: Symmetry, variables: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """Components of a symmetry field along some state variables."""
    named = dict(flat_pairs(law.field))
    return [sp.sympify(named.get(s, 0)) for s in variables]


def essential_variables(system: System) -> tuple[sp.Symbol, ...]:
    """State variables without those on which nothing depends, removed one after the other."""
    rates = dict(zip(system.symbols, system.rates, strict=True))
    # After a variable has been removed, another one may no longer be used.
    while True:
        formulas = [*rates.values(), *_relations(system)]
        used = {s for formula in formulas for s in formula.free_symbols}
        used |= {
            s for _, value in system.required_definitions(formulas) for s in value.free_symbols
        }
        if rates.keys() <= used:
            return tuple(rates)
        rates = {symbol: rate for symbol, rate in rates.items() if symbol in used}


def _variables(system: System) -> tuple[sp.Symbol, ...]:
    if not (variables := essential_variables(system)):
        raise InputError(f"{system.name}: no rate depends on the state; nothing can be linearised")
    return variables


def _symbol(system: System, name: object, where: str) -> sp.Symbol:
    for symbol in system.symbols:
        if str(symbol) == str(name):
            return symbol
    names = ", ".join(map(str, system.symbols))
    raise InputError(f"{system.name}: {where}: no state variable {name}; it has {names}")


def _state(
    system: System, state: State, parameters: Parameters, variables: Sequence[sp.Symbol]
) -> dict[sp.Symbol, mpmath.mpf]:
    others = set(map(str, system.start_variables)) - set(map(str, system.state))
    if not isinstance(state, Mapping) or not others.isdisjoint(map(str, state)):
        by_name = state
        if isinstance(state, Mapping):
            by_name = {str(key): value for key, value in state.items()}
        state = dict(zip(system.symbols, reduced_start(system, by_name, parameters), strict=True))
    named = {}
    for key, value in state.items():
        for name, component in vector_components(system, key, value):
            named[_symbol(system, name, "state")] = number(component, str(name))
    missing = [str(s) for s in variables if s not in named]
    if missing:
        raise InputError(f"{system.name}: the state gives no value for {', '.join(missing)}")
    return {s: named[s] for s in variables}


def _constants(system: System, parameters: Parameters) -> dict[sp.Symbol, mpmath.mpf]:
    return {s: number(x, str(s)) for s, x in parameter_values(system, parameters).items()}


def _require_family(
    system: System, forms: Sequence[mpmath.matrix], direction: mpmath.matrix, tolerance: mpmath.mpf
) -> None:
    """Raise an error for a direction not annihilated by A or the differentials of the relations."""
    size = mpmath.norm(direction)
    # The tolerance is relative to the size of the matrix, because rates have units.
    for form in forms:
        scale = 1 + mpmath.mnorm(form, 1) if form.rows else 1
        moved = mpmath.norm(form * direction) if form.rows else 0
        if size == 0 or moved > tolerance * size * scale:
            raise InputError(
                f"{system.name}: a direction given by 'along' does not lead along a family of "
                "steady motions: the linear equations or the relations do not annul it"
            )

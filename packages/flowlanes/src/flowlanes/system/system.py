"""Systems: a vector field on a phase space with the laws claimed for it."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, TypeAlias, final

import numpy.typing as npt
import sympy as sp

from ..arguments import Conditions, Formula, NamedFormulas, Parameters, arguments_checked
from ..errors import InputError, require_label, require_visible
from .arrays import FloatArray
from .display import Displayed
from .laws import AnyLaw, Integral, Law, of_kind
from .named_formulas import Pairs, as_pairs, expand, flat, flat_pairs, needed_steps, require_names
from .vectors import Vector, to_components

Name: TypeAlias = Vector | sp.Symbol

#: Meaning, unit, source and frame of a variable.
Metadata: TypeAlias = tuple[str, str, str, str]

#: Unit of a variable without metadata.
UNKNOWN = "unknown"


@arguments_checked
@dataclass(frozen=True)
class Parameter:
    """A number that is constant during motion.

    Parameters
    ----------
    symbol : sympy.Symbol
        The symbol used in formulas.
    meaning : str
        Description, with the frame if there is one.
    default : float
        Value used when none is given.
    unit : str
        SI unit of the examples; any consistent units can be used.
    admissible : tuple of sympy relations
        Conditions on this and other parameters; ``(a > 1) | (a < -1)`` admits two ranges.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v, k = sp.symbols("x v k", real=True)
    >>> stiffness = flowlanes.Parameter(k, "stiffness over mass", 4.0, "1/s^2", (k > 0,))
    >>> flowlanes.System("spring", "Spring", {x: v, v: -k * x}, (stiffness,)).defaults
    {k: 4.0}
    """

    symbol: sp.Symbol
    meaning: str
    default: float
    unit: str = ""
    admissible: Conditions = ()


@dataclass(frozen=True)
class Observable:
    """A quantity that can be recorded along a motion.

    `value` is a scalar or vector formula in the state, the definitions and the parameters;
    `frame` is ``"body"`` or ``"space"`` for vectors and empty for scalars.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> speed = flowlanes.system.Observable("speed", v, "angular velocity", "rad/s")
    >>> upright = flowlanes.system.Guard("upright", sp.cos(x), "the pendulum is level")
    >>> pendulum = flowlanes.System(
    ...     "pendulum", "Pendulum", {x: v, v: sp.sin(x)}, observables=(speed,), guards=(upright,)
    ... )
    >>> pendulum.observables[0].unit, isinstance(pendulum.guards[0], flowlanes.system.Guard)
    ('rad/s', True)
    """

    name: str
    value: sp.Basic
    meaning: str
    unit: str = ""
    frame: str = ""
    source: str = ""

    @property
    def scalar(self) -> Observable:
        """The observable with its value in components."""
        return replace(self, value=to_components(sp.sympify(self.value)))


@dataclass(frozen=True)
class Guard:
    """A quantity that must stay positive for the equations to describe the motion.

    Parameters
    ----------
    name : str
        Short name, such as ``"flat"``.
    value : sympy.Expr
        Positive in the domain.
    message : str
        The event at which it becomes zero: "the disk lies flat".
    lift_off : bool
        Whether the equations remain valid beyond (a two-sided contact), so that a run may
        continue.
    """

    name: str
    value: sp.Expr
    message: str
    lift_off: bool = False

    @property
    def scalar(self) -> Guard:
        """The guard with its value in components."""
        return replace(self, value=to_components(sp.sympify(self.value)))


@dataclass(frozen=True)
class Theorem:
    """A proof by hand of laws of a system, up to identities that can be certified.

    Parameters
    ----------
    laws : tuple of str
        Names of the implied laws.
    words : str
        Statement, and where its proof can be found.
    identities : callable
        () ↦ systems with the laws that remain to be proven.
    positive : tuple of sympy.Expr
        Formulas that are positive by the theorem.
    """

    laws: tuple[str, ...]
    words: str
    identities: Callable[[], tuple[System, ...]]
    positive: tuple[sp.Expr, ...] = ()


@dataclass(frozen=True)
class Reconstruction:
    """The equations that lift a reduced system back to space.

    `field` gives the time derivatives of the additional variables in terms of the reduced state
    and themselves; `relations` vanish along the motion and couple both; `observables` are
    positions and directions in space.
    """

    field: NamedFormulas
    relations: tuple[sp.Expr, ...]
    observables: tuple[Observable, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "field", as_pairs(self.field))


def unknown_names(formula: sp.Expr, scope: Collection[sp.Symbol]) -> str:
    """The unknown symbols of a formula, as text; empty if there are none.

    A symbol with the name of a known one but other assumptions is reported with both.
    """
    missing = formula.free_symbols - set(scope)
    if not missing:
        return ""
    symbols = {str(s): s for s in scope}
    names = []
    for symbol in sorted(missing, key=str):
        like = symbols.get(str(symbol))
        names.append(
            str(symbol)
            if like is None
            else f"{symbol} ({_assumptions(symbol)}; the known {like} has {_assumptions(like)})"
        )
    return ", ".join(names)


def _assumptions(symbol: sp.Symbol) -> str:
    """The assumptions with which a symbol was created."""
    text = [f"{key}={value}" for key, value in sorted(symbol._assumptions_orig.items())]
    return ", ".join(text) or "no assumptions"


@dataclass(frozen=True)
class ScalarForm:
    """A system in components, without vectors in its formulas.

    Formulas are declared and printed in vector notation; computations use this form. Nothing is
    expanded, and the order is preserved.

    Examples
    --------
    >>> import flowlanes
    >>> from flowlanes.system import Vector, constant, cross, norm_squared
    >>> u = Vector("u")
    >>> field, relations = {u: cross(u, constant([0, 0, 1]))}, (norm_squared(u) - 1,)
    >>> system = flowlanes.System("turning", "A turning direction", field, relations=relations)
    >>> system.scalar.relations
    (u_1**2 + u_2**2 + u_3**2 - 1,)
    """

    system: System

    @cached_property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The state, in flat order."""
        return self.system.symbols

    @cached_property
    def rates(self) -> tuple[sp.Expr, ...]:
        """The time derivatives of `symbols`."""
        return self.system.rates

    @cached_property
    def definitions(self) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """The definitions, in order."""
        return self.system.scalar_definitions

    @cached_property
    def relations(self) -> tuple[sp.Expr, ...]:
        """Formulas that vanish on the phase space."""
        return tuple(map(to_components, self.system.relations))

    @cached_property
    def laws(self) -> tuple[Law, ...]:
        """The laws in components; see `Law.scalar`."""
        return tuple(law.scalar for law in self.system.laws)

    @cached_property
    def integrals(self) -> tuple[Integral, ...]:
        """The first integrals among the laws."""
        return tuple(law.scalar for law in self.system.integrals)

    @cached_property
    def observables(self) -> tuple[Observable, ...]:
        """The observables in components; a vector is a matrix with one column."""
        return tuple(item.scalar for item in self.system.observables)

    @cached_property
    def guards(self) -> tuple[Guard, ...]:
        """The guards."""
        return tuple(guard.scalar for guard in self.system.guards)

    def of(self, formula: sp.Basic | float) -> sp.Basic:
        """Any formula in the quantities of the system, in components."""
        return to_components(sp.sympify(formula))


class Conventions(ABC):
    """How starts of a system are given, and what its variables mean.

    `flowlanes` itself has `VariablesByName`, the default of every `System`.  A package for some
    kind of systems may have its own: a frozen dataclass of formulas and numbers, so that systems
    can be compared and sent to other processes.

    Examples
    --------
    >>> import flowlanes
    >>> issubclass(flowlanes.system.VariablesByName, flowlanes.system.Conventions)
    True
    """

    @property
    @abstractmethod
    def start_formulas(self) -> Pairs:
        """Formulas of state variables in others that a start may give instead."""

    @abstractmethod
    def start_variables(self, system: System) -> tuple[Name, ...]:
        """The variables by which a start may be given besides the state."""

    @abstractmethod
    def states(
        self, system: System, given: Mapping[str, FloatArray], parameters: Parameters
    ) -> Mapping[str, FloatArray]:
        """The variables of the state by name, for many starts, from those that were given.

        Parameters
        ----------
        system : System
        given : mapping of str to array
            One row or number for each start.
        parameters : mapping of Symbol or name to number or array, optional

        Raises
        ------
        InputError
            If the state does not follow from what was given.
        """

    @abstractmethod
    def split_motion(
        self, system: System, start: Mapping[str, npt.ArrayLike]
    ) -> tuple[dict[str, npt.ArrayLike], dict[str, list[Any]]]:
        """A start of the reduced system, and the numbers given for its reconstruction."""

    @abstractmethod
    def first_values(self, system: System, name: Name, state: Mapping[str, Any]) -> Sequence[Any]:
        """The numbers at which a variable of the reconstruction begins unless they are given.

        Parameters
        ----------
        system : System
        name : Vector or Symbol
            The variable of the reconstruction.
        state : mapping of str to number
            The components of the reduced state.
        """

    @abstractmethod
    def metadata(
        self, system: System, name: str, size: int, description: tuple[str, str] | None
    ) -> Metadata:
        """Meaning, unit, source and frame of a variable; see `variable_metadata`."""

    @property
    @abstractmethod
    def frames(self) -> Mapping[str, tuple[str, tuple[int | str, ...]]]:
        """The frames of vectors: dimension in a dataset, and labels of the components."""

    @property
    @abstractmethod
    def axis_meanings(self) -> Mapping[str, str]:
        """The meanings of dimensions."""

    @abstractmethod
    def dimensions(self, variable: Any) -> tuple[str, ...]:
        """The dimensions of a column or a matrix in a dataset, besides time."""

    @property
    @abstractmethod
    def unrecorded(self) -> frozenset[str]:
        """State variables that datasets leave out."""


@final
@dataclass(frozen=True)
class VariablesByName(Conventions):
    """Every variable of the state is given by its name, and nothing is known of its meaning.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> pendulum.conventions == flowlanes.system.VariablesByName()
    True
    """

    @property
    def start_formulas(self) -> Pairs:
        """None."""
        return ()

    def start_variables(self, system: System) -> tuple[Name, ...]:
        """None."""
        return ()

    def states(
        self, system: System, given: Mapping[str, FloatArray], parameters: Parameters
    ) -> Mapping[str, FloatArray]:
        """What was given."""
        return given

    def split_motion(
        self, system: System, start: Mapping[str, npt.ArrayLike]
    ) -> tuple[dict[str, npt.ArrayLike], dict[str, list[Any]]]:
        """The start as it is; the reconstruction begins at zero."""
        return dict(start), {}

    def first_values(self, system: System, name: Name, state: Mapping[str, Any]) -> Sequence[Any]:
        """Zeros."""
        return [0.0] * len(flat([name]))

    def metadata(
        self, system: System, name: str, size: int, description: tuple[str, str] | None
    ) -> Metadata:
        """The description, or the name and an unknown unit."""
        meaning, unit = description or (name, UNKNOWN)
        return meaning, unit, "", "" if size == 1 else f"{name}_component"

    @property
    def frames(self) -> Mapping[str, tuple[str, tuple[int | str, ...]]]:
        """Axes fixed in a body and in space, of which an `Observable` may speak."""
        return {"body": ("axis", (1, 2, 3)), "space": ("space", ("x", "y", "z"))}

    @property
    def axis_meanings(self) -> Mapping[str, str]:
        """Of these axes."""
        return {"axis": "body axis", "space": "space axis"}

    def dimensions(self, variable: Any) -> tuple[str, ...]:
        """``NAME_component``, or rows and columns."""
        rows, columns = map(int, variable.shape)
        if columns > 1 and len(flat([variable])) == rows * columns:
            return (f"{variable}_row", f"{variable}_column")
        return (f"{variable}_component",)

    @property
    def unrecorded(self) -> frozenset[str]:
        """None."""
        return frozenset()


@arguments_checked
@dataclass(frozen=True, repr=False)
class System(Displayed):
    """A vector field on a phase space, with the laws claimed for it.

    Parameters
    ----------
    name, title : str
        Identifier (``"henon-heiles"``) and readable title.
    field : mapping of Vector or Symbol to formula
        Time derivatives of the state; the order of declaration is the flat order.
    definitions : mapping of Vector, tensor or Symbol to formula
        Named intermediate quantities, each in terms of the state, the parameters and the preceding
        ones.
    parameters : tuple of Parameter
    relations : tuple of sympy.Expr
        Expressions that vanish on the phase space.
    laws : tuple of Law
    observables : tuple of Observable
    guards : tuple of Guard
    reconstruction : Reconstruction, optional
    source : str
        Equation numbers in the paper.
    summary : str
        One or two sentences that describe the system.
    printed_definitions : pairs of quantity and formula
        Definitions to print in place of `definitions`: equations instead of the steps of their
        solution.  Empty to print the definitions.
    conventions : Conventions
        How starts are given, and what the variables mean; by default every variable of the state
        is given by its name.
    theorems : tuple of Theorem
        Proofs by hand of some laws, which the prover completes.

    Raises
    ------
    InputError
        If a formula uses a symbol that is not a state variable, definition or parameter, or two of
        these have the same name.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> energy = flowlanes.Integral("energy", v**2 / 2 - sp.cos(x))
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)}, laws=(energy,))
    >>> pendulum.symbols, pendulum.rates
    ((x, v), (v, -sin(x)))
    >>> flowlanes.integrate(pendulum, {"x": 0.0, "v": 1.0}, [0.0, 5.0])["x"].shape
    (2,)
    """

    name: str
    title: str
    field: NamedFormulas
    parameters: tuple[Parameter, ...] = ()
    definitions: NamedFormulas = ()
    relations: tuple[sp.Expr, ...] = ()
    laws: tuple[Law, ...] = ()
    observables: tuple[Observable, ...] = ()
    guards: tuple[Guard, ...] = ()
    reconstruction: Reconstruction | None = None
    source: str = ""
    summary: str = ""
    conventions: Conventions = VariablesByName()
    printed_definitions: NamedFormulas = ()
    theorems: tuple[Theorem, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "field", as_pairs(self.field))
        object.__setattr__(self, "definitions", as_pairs(self.definitions))
        object.__setattr__(self, "printed_definitions", as_pairs(self.printed_definitions))
        self._check_symbols()

    @cached_property
    def start_variables(self) -> tuple[Name, ...]:
        """The variables by which a start may be given besides the state."""
        return self.conventions.start_variables(self)

    # --- flat view -------------------------------------------------------------------------

    @cached_property
    def scalar(self) -> ScalarForm:
        """The system in components, for computations."""
        return ScalarForm(self)

    def __getstate__(self) -> dict[str, object]:
        # The form in components is recomputed rather than pickled.
        return {name: value for name, value in vars(self).items() if name != "scalar"}

    @cached_property
    def state(self) -> tuple[Name, ...]:
        """The state as declared: vectors and scalars."""
        return tuple(name for name, _ in self.field)

    @cached_property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The state as scalars, in flat order."""
        return flat(self.state)

    @cached_property
    def slices(self) -> tuple[tuple[Name, slice], ...]:
        """The state variables, each with its slice in the flat order."""
        ends = [len(flat(self.state[:i])) for i in range(len(self.state) + 1)]
        return tuple((name, slice(*ends[i : i + 2])) for i, name in enumerate(self.state))

    @cached_property
    def rates(self) -> tuple[sp.Expr, ...]:
        """Time derivatives of `symbols`, in terms of state, definitions and parameters."""
        return tuple(rate for _, rate in flat_pairs(self.field))

    @cached_property
    def scalar_definitions(self) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """The definitions as scalar assignments, in order."""
        return flat_pairs(self.definitions)

    @arguments_checked
    def required_definitions(
        self, formulas: Iterable[Formula], inputs: Iterable[sp.Symbol] = ()
    ) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """The definitions on which `formulas` depend, in order; the symbols `inputs` are known."""
        return needed_steps(self.scalar_definitions, map(to_components, formulas), inputs)

    @arguments_checked
    def expand(self, formula: Formula) -> sp.Expr:
        """A scalar or vector formula in components, in terms of state and parameters."""
        return expand(to_components(sp.sympify(formula)), self.scalar_definitions)

    @property
    def integrals(self) -> tuple[Integral, ...]:
        """The first integrals among the laws."""
        return of_kind(self.laws, Integral)

    def laws_of(self, kind: type[AnyLaw]) -> tuple[AnyLaw, ...]:
        """The laws of one kind."""
        return of_kind(self.laws, kind)

    @property
    def defaults(self) -> dict[sp.Symbol, float]:
        """Default values of all parameters."""
        return {p.symbol: p.default for p in self.parameters}

    @cached_property
    def default_values(self) -> tuple[tuple[str, float], ...]:
        """Names and default values of all parameters, as strings and doubles."""
        return tuple((str(p.symbol), float(p.default)) for p in self.parameters)

    def _check_symbols(self) -> None:
        require_label(self.name, self.title, self.summary, *(p.meaning for p in self.parameters))
        require_visible([o.meaning for o in self.observables] + [i.meaning for i in self.integrals])
        for p in self.parameters:
            if not math.isfinite(p.default):
                raise InputError(f"{self.name}: {p.symbol} = {p.default} must be a finite number")
        names = [p.symbol for p in self.parameters] + [
            *self.symbols,
            *(s for s, _ in self.scalar_definitions),
        ]
        moved = flat(name for name, _ in self.reconstruction.field) if self.reconstruction else ()
        whole = [n for n, _ in (*self.field, *self.definitions) if not isinstance(n, sp.Symbol)]
        # Provers, recorders and printers identify quantities by name only.
        require_names(self.name, (*names, *moved, *whole))
        known = {p.symbol for p in self.parameters} | set(self.symbols)
        for symbol, value in self.scalar_definitions:
            self._require(value, known, f"the definition of {symbol}")
            known.add(symbol)
        for symbol, value in zip(self.symbols, self.rates, strict=True):
            self._require(value, known, f"the rate of {symbol}")
        for law in self.scalar.integrals:
            self._require(law.value, known, f"the law {law.name!r}")
        for relation, scalar in zip(self.relations, self.scalar.relations, strict=True):
            self._require(scalar, known, f"the relation {relation}")

    def _require(self, value: sp.Expr, symbols: set[sp.Symbol], where: str) -> None:
        missing = unknown_names(value, symbols)
        if missing:
            raise InputError(
                f"{self.name}: {where} uses {missing}, which is neither a state variable, an "
                "earlier definition nor a parameter"
            )

    # --- making other systems --------------------------------------------------------------

    @arguments_checked
    def with_laws(self, *laws: Law) -> System:
        """The system with further laws."""
        return replace(self, laws=self.laws + laws)

    def lifted(self) -> System:
        """The system combined with its motion in space.

        Raises
        ------
        InputError
            If the system has no motion in space.
        """
        if self.reconstruction is None:
            raise InputError(f"{self.name}: this system has no motion in space to be lifted to")
        return self._lifted

    @cached_property
    def _lifted(self) -> System:
        motion = self.reconstruction
        if motion is None:
            return self
        return replace(
            self,
            field=self.field + motion.field,
            relations=self.relations + motion.relations,
            observables=self.observables + motion.observables,
            reconstruction=None,
        )

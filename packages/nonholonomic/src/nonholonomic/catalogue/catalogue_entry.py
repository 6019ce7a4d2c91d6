"""Entries of the catalogue, read by `list`, `show` and the documentation."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial, wraps
from importlib import import_module
from typing import TYPE_CHECKING, Any, Protocol, SupportsFloat, TypeAlias

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Law
from flowlanes.system.parameters import require_parameters
from flowlanes.system.system import System, VariablesByName

from ..mechanics.ball.ball import RollingBall
from ..mechanics.conventions import BODY
from ..mechanics.lagrangian.plan import Plan
from ..mechanics.rolling.equations import ContactModel, RollingBody
from ..mechanics.shapes.shape_base import Shape
from ..mechanics.shapes.surfaces import Surface
from .entry_files import EntryFile, entry_file

if TYPE_CHECKING:
    from ..mechanics.ball.ball import RollingBall
    from ..mechanics.lagrangian.plan import Plan

Numbers = Mapping[str, float]
#: Parameters as a user gives them: numbers, or of a family also lists and rows of numbers.
Settings: TypeAlias = Mapping[str, object]
Triple: TypeAlias = tuple[float, float, float]
#: Values of a state by the names of its variables: a number, or the components of a vector.
Values: TypeAlias = Mapping[str, float | tuple[float, ...]]


@arguments_checked
@dataclass(frozen=True, kw_only=True)
class Start:
    """The start of an instructive motion: ω and γ, or the whole state by name.

    Parameters
    ----------
    until : float
        Duration of the motion.
    omega, gamma : 3 floats, optional
        Angular velocity and normal, body axes, from which the rest of the state follows.
    state : mapping of str to float or floats, optional
        The state by the names of its variables, for a system that is not given by ω and γ; what
        belongs to the lift to space may be left out.

    Raises
    ------
    InputError
        Unless either ω and γ are given, or a state.

    Examples
    --------
    >>> import nonholonomic
    >>> nonholonomic.catalogue.Start(
    ...     until=10.0, omega=(1.0, 0.0, 0.5), gamma=(0.0, 0.0, 1.0)
    ... ).values
    {'omega': (1.0, 0.0, 0.5), 'gamma': (0.0, 0.0, 1.0)}
    """

    until: float
    omega: Triple | None = None
    gamma: Triple | None = None
    state: Values | None = None

    def __post_init__(self) -> None:
        # ω and γ come together, and stand for the whole state
        halves = [self.omega is not None, self.gamma is not None]
        if all(halves) == (self.state is not None) or any(halves) != all(halves):
            raise InputError("a start is given either by both omega and gamma or by a state")

    @property
    def values(self) -> dict[str, float | tuple[float, ...]]:
        """The start by name: ω and γ, or the variables of the state."""
        if self.omega is not None and self.gamma is not None:
            return {"omega": self.omega, "gamma": self.gamma}
        return {**(self.state or {})}


#: A rolling body and its system ↦ the laws that are known of them.
LawsOf: TypeAlias = Callable[[RollingBody, System], tuple[Law, ...]]


def _no_laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    return ()


def laws_for(
    contact: ContactModel | None, surface: Surface | type[Surface] | None, *shapes: type[Shape]
) -> Callable[[LawsOf], LawsOf]:
    """A decorator: laws of bodies with this contact on this surface, of these shapes; None is any.

    For any other body the result is empty, and the function is not called.
    """

    def decorator(laws: LawsOf) -> LawsOf:
        @wraps(laws)
        def restriction(rolling: RollingBody, system: System) -> tuple[Law, ...]:
            fits = (
                contact in (None, rolling.contact)
                and surface in (None, rolling.surface, type(rolling.surface))
                and (not shapes or isinstance(rolling.body.shape, shapes))
            )
            return laws(rolling, system) if fits else ()

        return restriction

    return decorator


@dataclass(frozen=True)
class Entry:
    """One system of the catalogue.

    Attributes
    ----------
    name, title, summary, source : str
        Identifier, human form, one or two sentences, equation numbers in the paper.
    defaults : mapping of str to float
        Parameters by symbol name, with values of an instructive example.
    build : callable
        Numbers by symbol name ↦ RollingBody; or ↦ System where nothing rolls.
    start : Start
    laws : callable
        (RollingBody, System) ↦ the laws that the paper states besides the energy; empty for a
        RollingBody of another kind.
    general : callable, optional
        The System with unspecified functions (a potential U(γ), a profile) and the laws that
        hold for every choice of these: it can be proven, not run.
    variables : mapping of str to (str, str)
        Meaning and SI unit of state variables by name, where the start is given by a state.
    ball : callable, optional
        Numbers by symbol name ↦ the homogeneous ball on a surface whose System `build` gives.
    letters : mapping of str to str
        Meanings of letters that occur in the equations of this system only.
    plan : Plan, optional
        The drawing of a mechanism in the plane.
    family : Family, optional
        For a system that exists in every dimension, the entries of all dimensions.
    dimension : int, optional
        The dimension of an entry of a family.

    Examples
    --------
    >>> import nonholonomic
    >>> entry = nonholonomic.CATALOGUE["chaplygin-ball"]
    >>> entry.title, entry.start.omega
    ('Chaplygin ball', (0.7, 0.4, 1.1))
    """

    name: str
    title: str
    summary: str
    source: str
    defaults: Numbers
    build: Callable[[Numbers], RollingBody | System]
    start: Start
    laws: LawsOf = _no_laws
    general: Callable[[], System] | None = None
    variables: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    ball: Callable[[Numbers], RollingBall] | None = None
    letters: Mapping[str, str] = field(default_factory=dict)
    plan: Plan | None = None
    family: Family | None = None
    dimension: int | None = None

    def __repr__(self) -> str:
        return f"<Entry {self.name}: {self.title}>"

    @arguments_checked
    def member(self, parameters: Settings | None = None) -> Entry:
        """The entry of the dimension and with the numbers that settings give; else itself."""
        return self if self.family is None else self.family.entry(parameters or {})

    @arguments_checked
    def settings(self, parameters: Settings | None = None) -> dict[str, float]:
        """All parameters, and the dimension where there is one."""
        numbers = self.numbers(parameters)
        if self.family is None:
            return numbers
        return {"dimension": self.member(parameters).dimension or 0, **numbers}

    @arguments_checked
    def numbers(self, parameters: Settings | None = None) -> dict[str, float]:
        """All parameters, the given ones replacing the defaults.

        Raises
        ------
        InputError
            If a parameter is not one of this system's.
        """
        if self.family is not None:
            return dict(self.member(parameters).defaults)
        replacements: dict[str, float] = {}
        require_parameters(self.name, self.defaults, parameters or {})
        for name, value in (parameters or {}).items():
            if not isinstance(value, SupportsFloat):
                raise InputError(f"{name}: must be a number, not {value!r}")
            replacements[name] = value  # type: ignore[assignment]
        return {**self.defaults, **replacements}

    @arguments_checked
    def rolling(self, parameters: Settings | None = None) -> RollingBody | None:
        """The rolling body and its surface; None for a body about a fixed point."""
        # these have a `build` that makes the System at once
        if self.family is not None or self.ball is not None:
            return None
        model = self.build(self.numbers(parameters))
        return model if isinstance(model, RollingBody) else None

    @arguments_checked
    def rolling_ball(self, parameters: Settings | None = None) -> RollingBall | None:
        """The homogeneous ball and its surface; None where there is none."""
        return None if self.ball is None else self.ball(self.numbers(parameters))

    @arguments_checked
    def system(self, parameters: Settings | None = None) -> System:
        """The System, with the laws that the paper names."""
        from dataclasses import replace

        member = self.member(parameters)
        model = member.build(self.numbers(parameters))
        if isinstance(model, System):
            by_name = model.conventions == VariablesByName()
            return replace(model, conventions=BODY) if by_name else model
        system = model.system(self.name, self.title)
        system = replace(system, source=self.source, summary=self.summary)
        return system.with_laws(*self.laws(model, system))


class Family(Protocol):
    """A system that exists in every dimension."""

    @property
    def constraint(self) -> str:
        """The condition on ω, as a sentence; empty where it is free."""

    @property
    def upright(self) -> bool:
        """Whether γ is the last row of the attitude."""

    def entry(self, parameters: Settings | None = None) -> Entry:
        """The entry of the dimension and with the numbers that settings give."""

    def admissible(self, omega: Sequence[Sequence[Any]], gamma: Sequence[Any]) -> list[list[Any]]:
        """The nearest ω that the constraint admits, as a skew matrix."""


def bruns_factor(potential: sp.Expr) -> sp.Expr | None:
    """k of the Bruns field U = ½k(γ, Iγ) for a diagonal tensor I; None for another potential."""
    gamma = sp.symbols("gamma_1:4", real=True)
    inertia = sp.symbols("I_1:4", real=True)
    # k from the first term of ½k Σ I_i γ_i²; whether the others have it too is tried afterwards
    factor = sp.cancel(2 * sp.diff(potential, gamma[0]) / (2 * gamma[0] * inertia[0]))
    bruns = factor / 2 * sp.Add(*(i * c**2 for i, c in zip(inertia, gamma, strict=True)))
    fits = not factor.free_symbols & {*gamma, *inertia} and sp.expand(potential - bruns) == 0
    return factor if fits and factor != 0 else None


# --- from files -----------------------------------------------------------------------------


def entry_with(name: str, **parts: Any) -> Entry:
    """The entry of a file, with the parts that its tables do not hold.

    Parameters
    ----------
    name : str
    **parts
        ``build``, and further attributes of an Entry.
    """
    file = entry_file(name)
    return Entry(
        name=name,
        title=file.title,
        summary=file.summary,
        source=file.source,
        defaults=file.parameters,
        start=start_of(file),
        variables=file.variables,
        letters=file.letters,
        **parts,
    )


def start_of(file: EntryFile) -> Start:
    """The start of a file: ω and γ of a body with an attitude in space, or the state by name."""
    values = file.start
    tables = file.tables.keys()
    moves_in_space = bool(file.python) or bool(tables & {"body", "reconstruction"})
    if moves_in_space and values.keys() == {"omega", "gamma"}:
        return Start(until=file.until, **values)  # type: ignore[arg-type]
    return Start(until=file.until, state=values)


def function_of(place: str) -> Callable[..., Any]:
    """The function that a file names as ``module:function`` in the catalogue.

    Its module is imported when it is called: not every use of an entry needs its laws.
    """
    return partial(_call, place)


def _call(place: str, *arguments: object) -> Any:
    module, _, function = place.partition(":")
    return getattr(import_module(f".{module}", __package__), function)(*arguments)

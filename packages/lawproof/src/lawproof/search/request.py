"""Specification of a search from a user's input, with validation and defaults."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.system import System

from ..proof.fields.budget import EFFORT, checked_effort
from .ansatz import Ansatz, default_momenta
from .candidate_factors import natural_bases, natural_divisors
from .input_formulas import condition, formula, quantities
from .phase_space import restricted_system
from .result import SearchSpace
from .scaling import weights
from .vector_invariants import VectorInvariants

_MOMENTUM_LIKE = ("M", "omega")
_CIRCULAR = (sp.sin, sp.cos, sp.tan, sp.cot)


@arguments_checked
def search_space(
    system: System,
    *,
    degree: int = 2,
    gamma_degree: int = 2,
    momenta: str = "",
    coordinates: str = "",
    at: Sequence[str] = (),
    level: Sequence[str] = (),
    divisors: Sequence[str] | None = None,
    bases: Sequence[str] | None = None,
    powers: int = 1,
    parameter_degree: int = 3,
    effort: int = EFFORT,
) -> SearchSpace:
    """Specify a search.

    Parameters
    ----------
    system : System
    degree, gamma_degree : int
        Largest degrees in the momenta and in the coordinates.
    momenta, coordinates : str
        Names of vectors and scalars, and formulas such as ``"log(x)"``, separated by commas; by
        default M and ω, and the rest of the state. An angle is replaced by its sine and cosine.
    at : sequence of str
        Conditions on the parameters, such as ``"k = -1"``.
    level : sequence of str
        Formulas that vanish on the level, such as ``"M·γ"``.
    divisors : sequence of str, optional
        Formulas by whose powers an integral may be divided; by default natural candidates.
    bases : sequence of str, optional
        Bases of the powers in a density; by default natural candidates.
    powers : int
        Largest exponent of a divisor.
    parameter_degree : int
        Largest degree of a coefficient in the parameters.
    effort : int
        Maximum number of term operations for the proof of one law.

    Returns
    -------
    SearchSpace

    Raises
    ------
    InputError
        If an argument is unknown, impossible or too large.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    >>> question = lawproof.search.search_space(top, divisors=["a", "b"])
    >>> question.divisors
    (a, b)
    """
    for value, name, least in (
        (degree, "degree", 0),
        (gamma_degree, "gamma_degree", 0),
        (powers, "powers", 0),
        (parameter_degree, "parameter_degree", 0),
    ):
        if value < least:
            raise InputError(f"{name} is {value}; it must not be negative")
    checked_effort(effort)
    chosen_momenta = quantities(momenta, system, "momenta")
    second = quantities(coordinates, system, "coordinates")
    families = (chosen_momenta,) if chosen_momenta else default_momenta(system)
    if set(families[0]) == set(system.symbols):
        angles = _angles(system)
        second = second or tuple(s for s in system.symbols if s in angles)
        families = (tuple(s for s in system.symbols if s not in second),)
    second = second or _other_variables(system, families[0])
    common = set(families[0]) & set(second)
    if common:
        raise InputError(f"{min(map(str, common))} is both a momentum and a coordinate")
    places = _without_angles(system, second)
    ansatz, *also = (Ansatz(family, places, degree, gamma_degree) for family in families)
    ansatz.check()
    space = restricted_system(
        system,
        [condition(text, system, "at") for text in at],
        [formula(text, system, "level") for text in level],
    )
    vocabulary = VectorInvariants(space, ansatz, weights(space))
    return SearchSpace(
        stage=space,
        ansatz=ansatz,
        also=tuple(also),
        divisors=natural_divisors(vocabulary)
        if divisors is None
        else tuple(_factor(text, system, "denominator") for text in divisors),
        bases=natural_bases(vocabulary)
        if bases is None
        else tuple(_factor(text, system, "base") for text in bases),
        powers=powers,
        parameter_degree=parameter_degree,
        effort=effort,
    )


def _factor(text: str, system: System, where: str) -> sp.Expr:
    """A formula that may be a divisor or factor; zero is rejected."""
    value = formula(text, system, where)
    if value == 0:
        raise InputError(f"{text} is zero, which divides nothing", where)
    return value


def _other_variables(system: System, momenta: tuple[sp.Expr, ...]) -> tuple[sp.Symbol, ...]:
    """The state without the momentum-like variables."""
    names = [n for n in system.state if getattr(n, "name", "") in _MOMENTUM_LIKE]
    like = {s for name in names if not isinstance(name, sp.Symbol) for s in name.symbols}
    return tuple(s for s in system.symbols if s not in like | set(momenta))


def _without_angles(system: System, symbols: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    """Angles replaced by their sines and cosines."""
    angles = _angles(system)
    variables: list[sp.Expr] = []
    for symbol in symbols:
        variables += [sp.sin(symbol), sp.cos(symbol)] if symbol in angles else [symbol]
    return tuple(variables)


def _angles(system: System) -> set[sp.Symbol]:
    """The symbols that enter the equations through sines and cosines."""
    formulas = [*system.rates, *(value for _, value in system.scalar_definitions)]
    return {s for f in formulas for node in f.atoms(*_CIRCULAR) for s in node.args[0].free_symbols}

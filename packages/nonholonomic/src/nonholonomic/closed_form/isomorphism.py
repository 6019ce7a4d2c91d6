"""Closed forms transported by an isomorphism (Theorems 8 and 10, Proposition 6).

An isomorphism maps the state x of its system to y(x) in a new time dτ = N(x) dt.  If it acts on a
unit vector by stretching the axes, and linearly on a second vector for each value of the first, its
inverse x(y) is a formula.  A system that separates on one side then separates on the other, with
the same curve, the same unit vector ν and another clock.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Any, TypeAlias

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity
from flowlanes.system.named_formulas import flat_pairs, scalars
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector, norm_squared, real_symbol

from .genus_two.separation import SeparatedSystem

#: Scalar symbols with their replacements.
Formulas: TypeAlias = dict[sp.Symbol, sp.Expr]


# --- the inverse map -----------------------------------------------------------------------


@arguments_checked
def inverse(system: System, law: Isomorphism) -> Formulas:
    """The state of `system` as formulas in the state of the target, and parameters.

    Parameters
    ----------
    system : System
        The source of the isomorphism `law`.
    law : Isomorphism
        Its map must take a unit vector of the state to that vector with its axes stretched by
        positive factors, and be linear in the other one.

    Returns
    -------
    dict
        Formulas by the variables of the state.

    Raises
    ------
    InputError
        If the map is of another kind.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> veselova = nonholonomic.from_catalogue("veselova")
    >>> law = next(law for law in veselova.laws if isinstance(law, flowlanes.Isomorphism))
    >>> [str(name) for name in nonholonomic.closed_form.inverse(veselova, law)][:2]
    ['gamma_1', 'gamma_2']
    """
    images = [(name, system.expand(formula)) for name, formula in law.map]
    vectors = [name for name in system.state if isinstance(name, Vector)]
    if len(vectors) == len(system.state) == len(images):
        for unit in (v for v in vectors if norm_squared(v) - 1 in system.relations):
            for name, image in images:
                if image.free_symbols.isdisjoint(_others(system, unit)):
                    place = _unit_vector(system, unit, name, image)
                    others = [pair for pair in images if pair[0] != name]
                    return place | _linear(system, unit, others, place)
    raise InputError(
        f"{system.name}: the isomorphism {law.name!r} has no explicit inverse here; its map must "
        "stretch the axes of a unit vector and be linear in one further vector"
    )


def _others(system: System, unit: Vector) -> set[sp.Symbol]:
    return set(system.symbols) - set(unit.symbols)


def _unit_vector(system: System, unit: Vector, name: Vector, image: sp.MatrixExpr) -> Formulas:
    """The unit vector γ with γ_i s_i λ = y_i, for factors s_i independent of the state."""
    scales = [part / s for part, s in zip(image, unit.symbols, strict=True)]
    factors = [sp.cancel(scale / scales[0]) for scale in scales]
    if any(factor.free_symbols & set(system.symbols) for factor in factors):
        raise InputError(f"{system.name}: {name} is not {unit} with its axes stretched")
    if all(scale == 1 for scale in scales):
        return dict(zip(unit.symbols, name.symbols, strict=True))
    parts = [s / factor for s, factor in zip(name.symbols, factors, strict=True)]
    length = sp.sqrt(sp.Add(*(part**2 for part in parts)))
    return {s: part / length for s, part in zip(unit.symbols, parts, strict=True)}


def _linear(
    system: System, unit: Vector, images: list[tuple[Vector, sp.MatrixExpr]], place: Formulas
) -> Formulas:
    """The other vector, from the image that is linear in it."""
    (other,) = (v for v in system.state if v != unit)
    ((name, image),) = images
    matrix = sp.Matrix(image).jacobian(sp.Matrix(other.symbols))
    if matrix.free_symbols & set(other.symbols):
        raise InputError(f"{system.name}: {name} is not linear in {other}")
    offset = sp.Matrix(image).xreplace({s: sp.S.Zero for s in other.symbols})
    wanted = sp.Matrix(name.symbols) - offset
    if matrix.is_diagonal():
        components = [w / matrix[i, i] for i, w in enumerate(wanted)]
    else:
        first, second, third = (matrix.col(i) for i in range(3))
        normals = (second.cross(third), third.cross(first), first.cross(second))
        components = [wanted.dot(normal) / first.dot(normals[0]) for normal in normals]
    return {s: f.xreplace(place) for s, f in zip(other.symbols, components, strict=True)}


@arguments_checked
def inverse_identity(system: System, law: Isomorphism) -> Identity:
    """The law of `system` that the inverse undoes the map.

    Parameters
    ----------
    system : System
        The source of the isomorphism `law`.
    law : Isomorphism

    Returns
    -------
    Identity

    Raises
    ------
    InputError
        If the map has no explicit inverse.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import nonholonomic
    >>> veselova = nonholonomic.from_catalogue("veselova")
    >>> law = next(law for law in veselova.laws if isinstance(law, flowlanes.Isomorphism))
    >>> lawproof.prove(veselova, nonholonomic.closed_form.inverse_identity(veselova, law)).decision
    'proven'
    """
    images = dict(flat_pairs(law.map))
    back = inverse(system, law)
    return Identity(
        f"{law.name}_and_back",
        tuple(back[s].xreplace(images) - s for s in system.symbols),
        "the inverse undoes the map",
        level=law.level,
        source=law.source,
    )


# --- systems that separate, carried over ---------------------------------------------------


@arguments_checked
def pull_back(
    system: System,
    law: Isomorphism,
    separable: SeparatedSystem,
    fixed: tuple[sp.MatrixExpr, ...] = (),
) -> SeparatedSystem:
    """Separation of variables of a system, carried over from the target of its isomorphism.

    Parameters
    ----------
    system : System
        The source of the isomorphism `law`.
    law : Isomorphism
    separable : SeparatedSystem
        The separation of the target.
    fixed : tuple of vectors
        Vectors of `system` with a constant direction in space.

    Returns
    -------
    SeparatedSystem
        The separation of `system`, on the level of `law`. The images of the target's parameters
        under the isomorphism are constants; a name that `system` has already gets a tilde.

    Raises
    ------
    InputError
        If the map has no explicit inverse.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> veselova = nonholonomic.from_catalogue("veselova")
    >>> law = next(law for law in veselova.laws if isinstance(law, flowlanes.Isomorphism))
    >>> from nonholonomic.closed_form.separations.neumann import neumann_system
    >>> nonholonomic.closed_form.pull_back(veselova, law, neumann_system()).system.name
    'veselova'
    """
    target = separable.system
    parameters = {p for p, _ in law.constants}
    names = _unused_names((*parameters, *(s for s, _ in separable.constants)), system)
    image = dict(flat_pairs(law.map))

    def text(formula: sp.Expr) -> sp.Expr:
        return _substitution(target.expand(formula), names | image)

    state = {s: _substitution(f, names) for s, f in flat_pairs(separable.state)}
    back = {s: _substitution(f, state) for s, f in inverse(system, law).items()}
    rate = _substitution(system.expand(law.time), back)
    return replace(
        _with_names(separable, text, names),
        name=system.name,
        title=system.title,
        system=system,
        level=law.level,
        constants=(
            *((names[p], formula) for p, formula in law.scalar.constants),
            *((names[s], text(formula)) for s, formula in separable.constants),
        ),
        time_rescaling=_substitution(scalars(separable.time_rescaling)[0], names) / rate,
        state=tuple(back.items()),
        fixed=fixed,
        laws=(law,),
        source=law.source,
    )


@arguments_checked
def push_forward(system: System, law: Isomorphism, separable: SeparatedSystem) -> SeparatedSystem:
    """The separation of the target of an isomorphism, from that of its system.

    Parameters
    ----------
    system : System
        The source of the isomorphism `law`.
    law : Isomorphism
    separable : SeparatedSystem
        The separation of `system`.

    Returns
    -------
    SeparatedSystem
        The separation of the target, for motions that are images: the parameters that the
        isomorphism gives as integrals must have the values of these on the motion. Parameters of
        `system` that the target does not share become its parameters too; a name that it has gets a
        tilde.

    Raises
    ------
    InputError
        If the map has no explicit inverse.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> veselova = nonholonomic.from_catalogue("veselova")
    >>> law = next(law for law in veselova.laws if isinstance(law, flowlanes.Isomorphism))
    >>> from nonholonomic.closed_form.separations.veselova import veselova as separated
    >>> nonholonomic.closed_form.push_forward(veselova, law, separated()).system.name
    'veselova-on-e3'
    """
    named = {p for p, _ in law.constants}
    shared = {p.symbol for p in law.target.parameters} - named
    further = [p for p in system.parameters if p.symbol not in shared]
    constants = (s for s, _ in separable.constants)
    names = _unused_names((*(p.symbol for p in further), *constants), law.target)
    target = replace(
        law.target,
        parameters=(
            *law.target.parameters,
            *(
                replace(
                    p,
                    symbol=names[p.symbol],
                    admissible=tuple(_substitution(relation, names) for relation in p.admissible),
                )
                for p in further
            ),
        ),
    )
    back = {s: _substitution(f, names) for s, f in inverse(system, law).items()}

    def text(formula: sp.Expr) -> sp.Expr:
        return _substitution(system.expand(formula), names | back)

    state = {s: _substitution(system.expand(f), names) for s, f in flat_pairs(separable.state)}
    rate = _substitution(_substitution(system.expand(law.time), names), state)
    image = {s: system.expand(f) for s, f in flat_pairs(law.map)}
    return replace(
        _with_names(separable, text, names),
        name=target.name,
        title=target.title,
        system=target,
        level=tuple(text(condition) for condition in law.level),
        constants=tuple((names[s], text(formula)) for s, formula in separable.constants),
        time_rescaling=_substitution(system.expand(separable.time_rescaling), names) * rate,
        state=tuple((s, _substitution(_substitution(f, names), state)) for s, f in image.items()),
        fixed=(),
        laws=(),
        source=law.source,
    )


def _with_names(
    separable: SeparatedSystem, text: Callable[[sp.Expr], sp.Expr], names: Formulas
) -> SeparatedSystem:
    """The curve with other symbols, and ν and ν′ in another state."""

    def each(formulas: Iterable[sp.Expr]) -> Any:
        return tuple(_substitution(sp.sympify(formula), names) for formula in formulas)

    return replace(
        separable,
        direction=text(separable.direction),
        turning=text(separable.turning),
        poles=each(separable.poles),
        weights=each(separable.weights),
        leading=_substitution(sp.sympify(separable.leading), names),
        roots=each(separable.roots),
        speeds=each(separable.speeds),
        along=None if separable.along is None else each(separable.along),
    )


def _unused_names(symbols: Iterable[sp.Symbol], system: System) -> Formulas:
    """New names for symbols in a system that may already use the same ones."""
    names = {p.symbol for p in system.parameters} | set(system.symbols)
    names |= {s for s, _ in system.scalar_definitions}
    return {s: _tilde(s) if s in names else s for s in symbols}


def _tilde(symbol: sp.Symbol) -> sp.Symbol:
    stem, bar, index = str(symbol).partition("_")
    return real_symbol(f"{stem}tilde{bar}{index}")


def _substitution(formula: sp.Expr, values: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    return formula.xreplace(dict(values))

"""Constants of the motion, as covectors that annihilate the field of the system.

Besides first integrals these are Casimir functions, reductions to linear equations (whose solutions
are integrals, though not elementary functions), and the integrals of the target of an isomorphism.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Rate, Reduction, of_kind
from flowlanes.system.named_formulas import scalars

from .facts import Fact, fact_of
from .ranks import Covectors, Element, View

#: Functions of an angle are multivalued, so their level sets need not be closed.
_MANY_VALUED = (sp.atan, sp.atan2)


@dataclass(frozen=True)
class AnnihilatingCovectors:
    """Covectors that annihilate the field, and their origin.

    Attributes
    ----------
    fact : Fact
    rows : callable
        View ↦ the covectors there.
    functions : tuple of sympy.Expr
        Functions on this system: a field along which they are constant leaves the integrals
        invariant. Empty if they are functions on another system.
    """

    fact: Fact
    rows: Covectors
    functions: tuple[sp.Expr, ...] = ()


def many_valued(formula: sp.Expr) -> bool:
    """Whether a function may be multivalued."""
    return any(part.has(*_MANY_VALUED) for part in scalars(formula))


def casimirs(law: ConformallyHamiltonian) -> tuple[sp.Expr, ...]:
    """The single-valued Casimir functions of a bracket."""
    return tuple(c for c in law.structure.casimirs if not many_valued(c))


def sources(laws: Iterable[Law]) -> list[AnnihilatingCovectors]:
    """Annihilating covectors of proven laws, from single-valued functions only."""
    laws = list(laws)
    covectors = [_function(fact_of(law), law.value) for law in of_kind(laws, Integral)]
    for law in laws:
        if isinstance(law, ConformallyHamiltonian):
            fact = fact_of(law)
            covectors.append(_function(fact, law.hamiltonian))
            named = Fact(law.name, "Casimir function", law.structure.source)
            covectors += [_function(named, value) for value in casimirs(law)]
        elif isinstance(law, Reduction):
            linear = _linear(law)
            if linear is not None:
                covectors.append(linear)
    return [s for s in covectors if not any(map(many_valued, s.functions))]


def pulled_back(law: Isomorphism, source: AnnihilatingCovectors) -> AnnihilatingCovectors:
    """The pullback of a covector of the target of an isomorphism."""
    text = source.fact
    system = text.system or law.target.title
    fact = Fact(law.name, text.words, text.source, system, text.functions)
    return AnnihilatingCovectors(fact, lambda view: source.rows(view.through(law)))


def _function(fact: Fact, value: sp.Expr) -> AnnihilatingCovectors:
    return AnnihilatingCovectors(fact, lambda view: [view.differential(value)], (value,))


def _linear(law: Reduction) -> AnnihilatingCovectors | None:
    """The covectors dqᵢ − Σ aᵢⱼ qⱼ du of linear equations q̇ᵢ = u̇ Σ aᵢⱼ(u) qⱼ.

    The constants of integration are integrals wherever the aᵢⱼ(u) are regular.
    """
    named = dict(law.scalar.quantities)
    rates = {rate.args[0] for equation in law.equations for rate in equation.atoms(Rate)}
    if not rates <= set(named) or len(rates) != len(law.equations) + 1:
        return None
    for variable in rates:
        moving = sorted(rates - {variable}, key=str)
        slopes = _slopes(law.equations, variable, moving)
        if slopes is not None and _homogeneous(slopes, variable, moving, named):
            fact = replace(fact_of(law), functions=len(slopes))
            return AnnihilatingCovectors(
                fact, _rows(named, variable, slopes), tuple(named[s] for s in rates)
            )
    return None


def _slopes(
    equations: tuple[sp.Expr, ...], variable: sp.Symbol, moving: list[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr] | None:
    """dqᵢ/du from the equations, if they determine it."""
    rates = {}
    for equation in map(sp.expand, equations):
        own = [q for q in moving if equation.coeff(Rate(q)) != 0]
        if len(own) != 1:
            return None
        factor, remainder = equation.coeff(Rate(own[0])), equation.coeff(Rate(variable))
        left = equation - factor * Rate(own[0]) - remainder * Rate(variable)
        if sp.expand(left) != 0 or factor.free_symbols & {variable, *moving}:
            return None
        rates[own[0]] = -remainder / factor
    return rates if set(rates) == set(moving) else None


def _homogeneous(
    slopes: Mapping[sp.Symbol, sp.Expr],
    variable: sp.Symbol,
    moving: list[sp.Symbol],
    quantities: Mapping[sp.Symbol, sp.Expr],
) -> bool:
    """Whether slopes are linear in the unknowns, with coefficients that depend on u."""
    others = set(quantities) - {variable, *moving}
    for slope in slopes.values():
        factors = [sp.diff(slope, q) for q in moving]
        linear = sp.Add(*(a * q for a, q in zip(factors, moving, strict=True)))
        closed = all(not a.free_symbols & {*moving, *others} and not a.has(Rate) for a in factors)
        if not closed or sp.simplify(slope - linear) != 0:
            return False
    return True


def _rows(
    quantities: Mapping[sp.Symbol, sp.Expr],
    variable: sp.Symbol,
    slopes: Mapping[sp.Symbol, sp.Expr],
) -> Covectors:
    def rows(view: View) -> list[list[Element]]:
        names = {s: view.level_set.without_rates(f, quantities) for s, f in quantities.items()}
        reading = view.evaluate.with_steps(names)
        along = view.differential(names[variable])
        covectors = []
        for quantity, slope in slopes.items():
            factor = reading.value(slope)
            own = view.differential(names[quantity])
            covectors.append([a - factor * b for a, b in zip(own, along, strict=True)])
        return covectors

    return rows

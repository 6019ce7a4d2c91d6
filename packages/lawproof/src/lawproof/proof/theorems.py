"""Theorems by which laws are proven, and the identities to which they reduce a law."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from certificate_checker import CheckError
from certificate_checker.claim.claim import read_claim
from certificate_checker.claim.power import claims_of_identities
from flowlanes.system.formula_text import short_text
from flowlanes.system.laws import Identity, Integral, Law, Rate
from flowlanes.system.named_formulas import needed_steps
from flowlanes.system.system import System, Theorem
from flowlanes.system.vectors import real_symbol

from .claim_text import Text, claim_text
from .power_theorem import PowerTheorem


def theorem_of(system: System, law: Law) -> Theorem | None:
    """The theorem of a system that may imply a law of it, or None."""
    for theorem in system.theorems:
        if isinstance(theorem, PowerTheorem):
            if isinstance(law, Integral):
                return theorem
        elif law in system.laws and law.name in theorem.laws:
            return theorem
    return None


def identities_of(theorem: Theorem, system: System, law: Law) -> tuple[System, ...]:
    """Systems whose laws together imply a law by a theorem; empty if it does not apply.

    The energy theorem does not apply if its identities divide by an expression that neither the
    equations nor the law divide by.
    """
    if not isinstance(theorem, PowerTheorem):
        return theorem.identities()
    if not isinstance(law, Integral) or not _applies(theorem, system, law):
        return ()
    # The conditions of the checker are used here too, so every proof by the theorem has a
    # certificate.
    stated = claim_text(system, law)
    try:
        claims_of_identities(stated, read_claim(stated, "the claim"), rates_text(theorem, system))
    except CheckError:
        return ()
    return power_identity(theorem, system, law), solution_identity(theorem, system)


def _applies(theorem: PowerTheorem, system: System, law: Law) -> bool:
    """True if the theorem has velocities and constraints of the system."""
    relations = set(system.scalar.relations)
    known = {*theorem.constraints, *(relation for relation, _ in theorem.positions)}
    return (
        not law.level
        and {*theorem.velocities} <= {*system.symbols}
        and {*theorem.constraints} <= relations <= known
    )


def rates_text(theorem: PowerTheorem, system: System) -> Text:
    """The linear equations of the accelerations as text of a certificate."""
    relations = list(system.scalar.relations)
    known = {*system.symbols, *system.defaults}
    known |= {s for s, _ in (*system.scalar_definitions, *theorem.definitions)}
    return {
        "velocities": [str(s) for s in theorem.velocities],
        "accelerations": [str(s) for s in accelerations(theorem, known)],
        "mass": [_texts(row) for row in theorem.mass],
        "force": _texts(theorem.force),
        "slopes": [_texts(row) for row in theorem.slopes],
        "drift": _texts(theorem.drift),
        "multipliers": _texts(theorem.multipliers),
        "constraints": [relations.index(f) for f in theorem.constraints],
        "degrees": [int(degree) for degree in theorem.degrees],
        "positions": [
            [relations.index(f), relations.index(rate) if rate else None]
            for f, rate in theorem.positions
            if f in relations
        ],
        "definitions": [[str(s), short_text(f)] for s, f in theorem.definitions],
        "opaque": [str(s) for s in theorem.opaque],
    }


def _texts(formulas: Iterable[sp.Expr]) -> list[str]:
    return [short_text(f) for f in formulas]


def accelerations(theorem: PowerTheorem, names: Iterable[sp.Symbol]) -> tuple[sp.Symbol, ...]:
    """Unused names for the rates of the velocities."""
    used = set(map(str, names))
    symbols = []
    for velocity in theorem.velocities:
        name = f"{velocity}_rate"
        while name in used:
            name += "_"
        used.add(name)
        symbols.append(real_symbol(name))
    return tuple(symbols)


def power_identity(theorem: PowerTheorem, system: System, law: Integral) -> System:
    """The system with the law F' = uᵀ(A a − h), C u = κ f and f' = C a − b, for free a."""
    definitions = (*system.scalar_definitions, *theorem.definitions)
    u = theorem.velocities
    known = {*system.symbols, *(p.symbol for p in system.parameters), *(s for s, _ in definitions)}
    a = accelerations(theorem, known)
    terms = [
        velocity * (_product(row, a) - force)
        for velocity, row, force in zip(u, theorem.mass, theorem.force, strict=True)
    ]
    values = [Rate(law.scalar.value) - sp.Add(*terms)]
    constraints = zip(
        theorem.slopes, theorem.degrees, theorem.drift, theorem.constraints, strict=True
    )
    for row, degree, drift, f in constraints:
        values += [_product(row, u) - degree * f, Rate(f) - _product(row, a) + drift]
    here = set(system.scalar.relations)
    values += [Rate(relation) - rate for relation, rate in theorem.positions if relation in here]
    data = [*_entries(theorem), *values]
    places = _unknown(data, definitions, {*known, *a})
    rates = dict(zip(system.symbols, system.rates, strict=True)) | dict(zip(u, a, strict=True))
    return System(
        name=f"{system.name}-power",
        title="The power of the forces, whatever the accelerations",
        field={**rates, **dict.fromkeys((*a, *places), sp.S.Zero)},
        parameters=system.parameters,
        definitions=definitions,
        guards=system.guards,
        laws=(Identity("power", tuple(values)),),
    )


def solution_identity(theorem: PowerTheorem, system: System) -> System:
    """The system with the law A u̇ = h + Cᵀλ and C u̇ = b for its accelerations."""
    opaque = set(theorem.opaque)
    definitions = [
        (s, f) for s, f in (*system.scalar_definitions, *theorem.definitions) if s not in opaque
    ]
    rates = dict(zip(system.symbols, system.rates, strict=True))
    own = [rates[velocity] for velocity in theorem.velocities]
    values = [
        _product(row, own)
        - force
        - _product(theorem.multipliers, [slopes[i] for slopes in theorem.slopes])
        for i, (row, force) in enumerate(zip(theorem.mass, theorem.force, strict=True))
    ]
    values += [
        _product(row, own) - drift for row, drift in zip(theorem.slopes, theorem.drift, strict=True)
    ]
    data = [*_entries(theorem), *theorem.multipliers, *own]
    needed = needed_steps(definitions, data)
    parameters = {p.symbol for p in system.parameters}
    known = parameters | {s for s, _ in needed}
    free = _unknown(data, needed, known)
    return System(
        name=f"{system.name}-solution",
        title="The linear equations of the accelerations, solved",
        # A system must have a state, even if everything is constant.
        field=dict.fromkeys(free or theorem.velocities[:1], sp.S.Zero),
        parameters=system.parameters,
        definitions=needed,
        laws=(Identity("solution", tuple(values)),),
    )


def _entries(theorem: PowerTheorem) -> list[sp.Expr]:
    """The entries of A, h, C and b; the identity must know all their names, even if they cancel."""
    rows = (*theorem.mass, theorem.force, *theorem.slopes, theorem.drift)
    return [entry for row in rows for entry in row]


def _product(left: Sequence[sp.Expr], right: Sequence[sp.Expr]) -> sp.Expr:
    return sp.Add(*(x * y for x, y in zip(left, right, strict=True)))


def _unknown(
    formulas: Iterable[sp.Expr],
    definitions: Iterable[tuple[sp.Symbol, sp.Expr]],
    others: set[sp.Symbol],
) -> list[sp.Symbol]:
    """Symbols in formulas and definitions that are not among `others`, sorted."""
    listed = [*formulas, *(f for _, f in definitions)]
    return sorted({s for f in listed for s in f.free_symbols} - others, key=str)

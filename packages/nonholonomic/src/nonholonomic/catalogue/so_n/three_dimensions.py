"""The systems of n dimensions for n = 3, which are systems of the paper.

The skew matrix ω belongs to the vector of angular velocity, ω_12 = −ω_3, ω_13 = ω_2, ω_23 = −ω_1,
as γ̇ = −ωγ and γ̇ = γ×ω; moments I_12, I_13, I_23 are I_3, I_2, I_1.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism, with_any_parameters
from flowlanes.system.matrices import Skew
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.system import System
from flowlanes.system.vectors import Components, Vector, vectors

from ...mechanics.rolling.attitude import rotation
from ..systems import catalogue_system
from .entry_of_dimension import SOURCE
from .inertia import Inertia, Moments
from .motion_in_space import attitude_of, contact_of, gamma_of, omega_of

NAME = "three_dimensions"
SIZE = 3
MOMENTS = ("I_23", "I_13", "I_12")

#: The systems of three dimensions by the names of those of n dimensions.
TARGETS: Mapping[str, str] = {
    "veselova-nd": "veselova",
    "chaplygin-ball-nd": "chaplygin-ball",
    "rubber-chaplygin-ball-nd": "rubber-chaplygin-ball",
    "chaplygin-ball-on-sphere-nd": "ball-on-sphere",
    "rubber-ball-on-sphere-nd": "rubber-ball-on-sphere",
}

omega, gamma, M = vectors("omega gamma M")


def vector_of(matrix: Skew) -> Components:
    """The vector v of a skew matrix A of three dimensions, Ax = x×v."""
    a, b, c = matrix.symbols
    return Components([-c, b, -a])


def entries_of(vector: Vector) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """The entries 12, 13, 23 of the skew matrix of a vector."""
    x, y, z = vector.symbols
    return -z, y, -x


def onto_three_dimensions(
    name: str, inertia: Inertia, momentum: Skew | None
) -> tuple[Isomorphism, ...]:
    """The law that the system is one of the paper; none for n > 3 or for a mass tensor.

    Parameters
    ----------
    name : str
        Of the system of n dimensions.
    inertia : Inertia
    momentum : Skew, optional
        k, where the state has it and not p.
    """
    if inertia.dimension != SIZE or not isinstance(inertia, Moments) or name not in TARGETS:
        return ()
    whole = catalogue_system(TARGETS[name], {})
    # one step is enough: further systems are found at the target
    laws = tuple(law for law in whole.laws if not isinstance(law, Isomorphism))
    target = replace(with_any_parameters(whole), laws=laws)
    moving = {omega: vector_of(omega_of(SIZE))} if momentum is None else {M: vector_of(momentum)}
    moments = {f"I_{i}": moment for i, moment in enumerate(MOMENTS, 1)}
    symbols = {p.symbol.name: p.symbol for p in inertia.parameters}
    constants = {
        p.symbol: symbols[moments[p.symbol.name]]
        for p in target.parameters
        if p.symbol.name in moments
    }
    return (
        Isomorphism(
            NAME,
            target,
            {**moving, gamma: Components(gamma_of(SIZE).symbols)},
            constants=constants,
            meaning="the system of three dimensions",
            source=SOURCE,
        ),
    )


def state_in_three_dimensions(system: System) -> dict[sp.Symbol, sp.Expr]:
    """The lifted state of a system with that law, as formulas in the lifted state of the target.

    Parameters
    ----------
    system : System
        Of n = 3, with its start, not lifted.
    """
    (named,) = (name for name in system.state if str(name) != str(gamma))
    known = dict(zip(gamma_of(SIZE).symbols, gamma.symbols, strict=True))
    if isinstance(named, Skew):
        back = dict(zip(named.symbols, entries_of(M), strict=True))
    else:
        spin = dict(zip(omega_of(SIZE).symbols, entries_of(omega), strict=True))
        back = {
            s: f.xreplace(spin | known) for s, f in flat_pairs(system.conventions.start_formulas)
        }
    back |= known
    if system.reconstruction is not None:
        back |= dict(zip(attitude_of(SIZE).symbols, rotation(), strict=True))
        contact = contact_of(SIZE).symbols
        if set(contact) <= set(system.lifted().symbols):
            back |= dict(zip(contact, sp.symbols("place_x place_y", real=True), strict=True))
    return back

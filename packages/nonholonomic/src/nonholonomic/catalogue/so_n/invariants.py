"""Invariants of the momentum k and the direction γ of a Chaplygin ball in n dimensions."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.matrices import Column, MatrixProduct, Pfaffian, Skew, SymmetricMatrix
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import norm_squared

from .entry_of_dimension import SOURCE, SQUARE


def invariants(k: Skew, gamma: Column) -> tuple[Pairs, tuple[Integral, ...]]:
    """The n − 1 independent invariants of k and γ under rotations, and definitions that they use.

    Returns
    -------
    definitions : pairs
    integrals : tuple of Integral
    """
    n = int(gamma.shape[0])
    definitions: list[tuple[sp.Basic, sp.Basic]] = []
    laws = [
        Integral(
            "square", MatrixProduct(k, k), "square of the momentum", source=SOURCE, unit=SQUARE
        )
    ]
    if n >= 5:
        S = SymmetricMatrix("S", n)
        definitions.append((S, k * k))
        laws.append(
            Integral(
                "fourth",
                MatrixProduct(S, S),
                "half the trace of the fourth power of the momentum",
                source=SOURCE,
                unit="kg^4 m^8/s^4",
            )
        )
        power = S
        for degree in range(6, n, 2):
            power = power * S
            laws.append(
                Integral(
                    f"trace_{degree}",
                    MatrixProduct(power, S),
                    f"half the trace of power {degree} of the momentum",
                    source=SOURCE,
                )
            )
    if n % 2 == 0:
        laws.append(Integral("pfaffian", Pfaffian(k), "Pfaffian of the momentum", source=SOURCE))
    last = gamma
    for degree in range(1, (n - 1) // 2 + 1):
        lever = Column("abcd"[degree - 1], n)
        definitions.append((lever, k * last))
        words = "square of the momentum in planes through γ"
        laws.append(
            Integral(
                "lever" if degree == 1 else f"lever_{degree}",
                norm_squared(lever),
                words if degree == 1 else f"square of power {degree} of the momentum applied to γ",
                source=SOURCE,
                unit=SQUARE if degree == 1 else "",
            )
        )
        last = lever
    return tuple(definitions), tuple(laws)


def invariants_of_ball(n: int) -> System:
    """The Chaplygin ball with ω left arbitrary, and the invariants of k and γ that it keeps.

    They are constant whatever ω is, hence for every inertia.

    Parameters
    ----------
    n : int
        The dimension of space.

    Returns
    -------
    System
        k and γ move, the entries of ω are parameters.
    """
    k, omega, gamma = Skew("k", n), Skew("omega", n), Column("gamma", n)
    definitions, laws = invariants(k, gamma)
    return System(
        name="chaplygin-ball-invariants",
        title=f"Momentum and direction of the Chaplygin ball in {n} dimensions",
        field={k: k * omega - omega * k, gamma: -omega * gamma},
        parameters=tuple(Parameter(s, "angular velocity", 1.0, "rad/s") for s in omega.symbols),
        definitions=definitions,
        laws=laws,
    )


def momentum_on_level(n: int) -> System:
    """The Chaplygin ball on the level k = p∧γ with ω left arbitrary, and its constant p².

    Parameters
    ----------
    n : int
        The dimension of space.

    Returns
    -------
    System
        p moves, the entries of ω are parameters.
    """
    p, omega = Column("p", n), Skew("omega", n)
    law = Integral("momentum", norm_squared(p), "square of the momentum", source=SOURCE)
    return System(
        name="chaplygin-ball-momentum-on-level",
        title=f"The momentum of the Chaplygin ball on k = p∧γ in {n} dimensions",
        field={p: -omega * p},
        parameters=tuple(Parameter(s, "angular velocity", 1.0, "rad/s") for s in omega.symbols),
        laws=(law,),
    )

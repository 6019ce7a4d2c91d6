"""Theorems on n-dimensional systems with any inertia, as :func:`lawproof.prove` uses them.

The arguments are in :mod:`nonholonomic.catalogue.so_n.any_inertia` and, of the quadratic integrals,
in docs/quadratic-integrals.md; the identities on which they rest are certified for the dimension at
hand, those of the quadratic integrals for all dimensions at once.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TypeAlias

import sympy as sp

from flowlanes.system.system import System, Theorem
from flowlanes.system.vectors import real_symbol

from .any_inertia import (
    chaplygin_ball,
    chaplygin_ball_on_level,
    energy_of_ball,
    energy_of_veselova,
    momentum_of_veselova,
    suslov,
    veselova,
)
from .equal_radii import identities as equal_radii
from .invariants import invariants_of_ball, momentum_on_level

WORDS = "theorem for every operator of inertia (docs/n-dimensions.md)"


Identities: TypeAlias = Callable[[], System]


def _single(make: Identities) -> tuple[System]:
    return (make(),)


def _theorem(
    laws: tuple[str, ...],
    identities: Identities,
    *positive: sp.Expr,
    words: str = WORDS,
) -> Theorem:
    """The theorem that one system of identities proves, where some formulas are positive."""
    return Theorem(laws, words, partial(_single, identities), positive)


def of_ball(n: int, determinant: sp.Symbol, invariants: tuple[str, ...]) -> tuple[Theorem, ...]:
    """Energy, invariants of the momentum and measure of the Chaplygin ball.

    Parameters
    ----------
    n : int
        The dimension of space.
    determinant : Symbol
        That of the operator from ω to k, or of a positive definite one in proportion to it.
    invariants : tuple of str
        The names of the laws that hold whatever ω is.
    """
    return (
        _theorem(invariants, partial(invariants_of_ball, n)),
        _theorem(("energy",), partial(energy_of_ball, n)),
        _theorem(("measure",), partial(chaplygin_ball, n), determinant),
    )


def of_ball_on_level(n: int, determinant: sp.Symbol) -> tuple[Theorem, ...]:
    """Energy, momentum and measure of the Chaplygin ball on the level k = p∧γ.

    Parameters
    ----------
    n : int
        The dimension of space.
    determinant : Symbol
        That of the operator from ω to k, or of a positive definite one in proportion to it.
    """
    measure = partial(chaplygin_ball_on_level, n)
    return (
        _theorem(("energy",), partial(energy_of_ball, n)),
        _theorem(("momentum",), partial(momentum_on_level, n)),
        _theorem(("measure",), measure, determinant),
    )


def of_veselova(n: int, determinant: sp.Symbol) -> tuple[Theorem, ...]:
    """Energy, momentum and measure of the Veselova system and the rubber ball.

    Parameters
    ----------
    n : int
        The dimension of space.
    determinant : Symbol
        That of the operator from u to p.
    """
    return (
        _theorem(("energy",), partial(energy_of_veselova, n)),
        _theorem(("momentum",), partial(momentum_of_veselova, n)),
        _theorem(("measure",), partial(veselova, n), determinant),
    )


def of_quadratic_integrals(names: tuple[str, ...], identities: Identities) -> tuple[Theorem, ...]:
    """Quadratic integrals where k = p∧γ.

    Parameters
    ----------
    names : tuple of str
        The names of these laws, perhaps none.
    identities : callable
        () ↦ System: `rate_of_pencil`, of a body with a mass tensor that does not twist, or `lemma`.
    """
    words = "theorem for every dimension (docs/quadratic-integrals.md)"
    return (_theorem(names, identities, words=words),) if names else ()


def of_suslov(n: int) -> tuple[Theorem, ...]:
    """Energy and decreasing momentum of Suslov's problem with a mass tensor.

    Parameters
    ----------
    n : int
        The dimension of space.
    """
    words = "theorem for every mass tensor (docs/n-dimensions.md)"
    return (_theorem(("energy", "monotone"), partial(suslov, n), words=words),)


def of_rubber_ball_on_sphere(n: int, determinant: sp.Symbol) -> tuple[Theorem, ...]:
    """Energy and measure of the rubber ball on a sphere, for every ratio ε; its form for ε = 1/2.

    Parameters
    ----------
    n : int
        The dimension of space.
    determinant : Symbol
        That of the operator from u to p.
    """
    ratio = real_symbol("epsilon")
    measure = partial(veselova, n, 1 / (2 * ratio) - 1, ratio)
    return (
        _theorem(("energy",), partial(energy_of_veselova, n)),
        _theorem(("measure",), measure, determinant),
        Theorem(("bracket", "hamiltonian"), WORDS, partial(equal_radii, n)),
    )

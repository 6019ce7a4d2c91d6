"""Theorems on n-dimensional systems with any inertia, as :func:`chaplygin.prove` uses them.

The arguments are in :mod:`chaplygin.catalogue.so_n.any_inertia` and, of the quadratic integrals, in
docs/quadratic-integrals.md; the identities on which they rest are certified for the dimension at
hand, those of the quadratic integrals for all dimensions at once.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import sympy as sp

from ...core.system import System, Theorem
from ...core.vectors import real_symbol
from .any_inertia import (
    chaplygin_ball,
    energy_of_ball,
    energy_of_veselova,
    momentum_of_veselova,
    veselova,
)
from .invariants import invariants_of_ball
from .mass_tensor_identities import rate_of_pencil

WORDS = "theorem for every operator of inertia (docs/n-dimensions.md)"


def _together(*makers: Callable[[], System]) -> tuple[System, ...]:
    return tuple(make() for make in makers)


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
        Theorem(invariants, WORDS, partial(_together, partial(invariants_of_ball, n))),
        Theorem(("energy",), WORDS, partial(_together, partial(energy_of_ball, n))),
        Theorem(
            ("measure",), WORDS, partial(_together, partial(chaplygin_ball, n)), (determinant,)
        ),
    )


def of_veselova(n: int, determinant: sp.Symbol, quadratic: tuple[str, ...]) -> tuple[Theorem, ...]:
    """Energy, measure and quadratic integrals of the Veselova system and the rubber ball.

    Parameters
    ----------
    n : int
        The dimension of space.
    determinant : Symbol
        That of the operator from u to p.
    quadratic : tuple of str
        The names of the laws that are quadratic integrals of a body with a mass tensor.
    """
    found = [
        Theorem(("energy",), WORDS, partial(_together, partial(energy_of_veselova, n))),
        Theorem(("momentum",), WORDS, partial(_together, partial(momentum_of_veselova, n))),
        Theorem(("measure",), WORDS, partial(_together, partial(veselova, n)), (determinant,)),
    ]
    if quadratic:
        words = "theorem for every mass tensor and dimension (docs/quadratic-integrals.md)"
        found.append(Theorem(quadratic, words, partial(_together, rate_of_pencil)))
    return tuple(found)


def of_rubber_ball_on_sphere(n: int, determinant: sp.Symbol) -> tuple[Theorem, ...]:
    """Energy and measure of the rubber ball on a sphere, for every ratio ε of the radii.

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
        Theorem(("energy",), WORDS, partial(_together, partial(energy_of_veselova, n))),
        Theorem(("measure",), WORDS, partial(_together, measure), (determinant,)),
    )

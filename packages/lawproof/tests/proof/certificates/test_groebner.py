"""Gröbner bases whose elements are known as combinations of the equations."""

from __future__ import annotations

import pytest
from flint import Ordering, fmpq_mpoly_ctx

from lawproof.proof.certificates.groebner import Basis
from lawproof.proof.fields.budget import Budget

RING = fmpq_mpoly_ctx.get([f"a_{i}{j}" for i in range(3) for j in range(3)], Ordering.lex)
ROWS = [RING.gens()[3 * i : 3 * i + 3] for i in range(3)]
COLUMNS = list(zip(*ROWS, strict=True))


def products(vectors):
    """What vanishes where three vectors are orthonormal."""
    return [
        sum((a * b for a, b in zip(vectors[i], vectors[j], strict=True)), RING.constant(-(i == j)))
        for i in range(3)
        for j in range(i, 3)
    ]


def test_orthonormal_rows_make_orthonormal_columns():
    equations = products(ROWS)
    basis = Basis(RING, equations, Budget())
    for wanted in products(COLUMNS)[:2]:
        quotients = basis.quotients(wanted)
        assert quotients is not None
        total = sum((q * equations[i] for i, q in quotients.items()), RING.constant(0))
        assert total == wanted


@pytest.mark.slow
def test_what_is_no_combination_is_none():
    basis = Basis(RING, products(ROWS), Budget())
    assert basis.quotients(RING.gens()[0]) is None

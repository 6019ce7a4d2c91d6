"""Many small vectors and matrices at once."""

from __future__ import annotations

import numpy as np

from chaplygin.flow.batched_linalg import applied, dots, solved, squares

dice = np.random.default_rng(1)
MATRICES, VECTORS = dice.normal(size=(50, 3, 3)), dice.normal(size=(50, 3))


def test_products() -> None:
    assert np.allclose(dots(VECTORS, VECTORS), (VECTORS**2).sum(axis=1))
    assert np.allclose(squares(VECTORS.T), (VECTORS**2).sum(axis=1))
    assert np.allclose(applied(MATRICES, VECTORS), (MATRICES @ VECTORS[:, :, None])[:, :, 0])
    assert np.allclose(applied(MATRICES, solved(MATRICES, VECTORS)), VECTORS)


def test_each_row_by_itself() -> None:
    whole = applied(MATRICES, solved(MATRICES, VECTORS))
    for k in (0, 17, 49):
        part = slice(k, k + 1)
        assert (applied(MATRICES[part], solved(MATRICES[part], VECTORS[part])) == whole[part]).all()


def test_vectors_of_one_component() -> None:
    assert np.allclose(
        solved(MATRICES[:, :1, :1], VECTORS[:, :1]) * MATRICES[:, 0, :1], VECTORS[:, :1]
    )


def test_vectors_of_no_length() -> None:
    nothing = np.zeros((5, 0))
    assert (dots(nothing, nothing) == 0).all()
    assert solved(np.zeros((5, 0, 0)), nothing).shape == (5, 0)

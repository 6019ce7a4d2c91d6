"""Many small vectors and matrices at once."""

from __future__ import annotations

import numpy as np

from flowlanes.flow.batched_linalg import (
    batched_matvec,
    batched_solve,
    norm_squared_columns,
    row_dots,
)

rng = np.random.default_rng(1)
MATRICES, VECTORS = rng.normal(size=(50, 3, 3)), rng.normal(size=(50, 3))


def test_products() -> None:
    assert np.allclose(row_dots(VECTORS, VECTORS), (VECTORS**2).sum(axis=1))
    assert np.allclose(norm_squared_columns(VECTORS.T), (VECTORS**2).sum(axis=1))
    assert np.allclose(batched_matvec(MATRICES, VECTORS), (MATRICES @ VECTORS[:, :, None])[:, :, 0])
    assert np.allclose(batched_matvec(MATRICES, batched_solve(MATRICES, VECTORS)), VECTORS)


def test_each_row_by_itself() -> None:
    whole = batched_matvec(MATRICES, batched_solve(MATRICES, VECTORS))
    for k in (0, 17, 49):
        part = slice(k, k + 1)
        assert (
            batched_matvec(MATRICES[part], batched_solve(MATRICES[part], VECTORS[part]))
            == whole[part]
        ).all()


def test_vectors_of_one_component() -> None:
    assert np.allclose(
        batched_solve(MATRICES[:, :1, :1], VECTORS[:, :1]) * MATRICES[:, 0, :1], VECTORS[:, :1]
    )


def test_vectors_of_no_length() -> None:
    nothing = np.zeros((5, 0))
    assert (row_dots(nothing, nothing) == 0).all()
    assert batched_solve(np.zeros((5, 0, 0)), nothing).shape == (5, 0)

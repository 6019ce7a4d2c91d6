"""The surface under a ball, painted."""

from __future__ import annotations

import numpy as np

from chaplygin.report.scenes.ball import _with_soft_borders


def test_the_border_of_a_surface_has_no_steps() -> None:
    rows, columns = np.mgrid[0:120, 0:120] - 59.5
    away = np.hypot(rows, columns)
    cover = (away < 40.0).astype(float)[..., None]
    paint = np.where(cover > 0.0, [0.2, 0.5, 0.7], [1.0, 1.0, 1.0])
    painted = _with_soft_borders(paint, cover)
    assert np.array_equal(
        painted[away < 36.0], np.full((int((away < 36.0).sum()), 4), [0.2, 0.5, 0.7, 1.0])
    )
    assert not painted[away > 44.0][:, 3].any()
    seen = painted[..., 3] > 0.01
    # nothing of what is beside the surface is mixed in
    assert np.abs(painted[seen][:, :3] - [0.2, 0.5, 0.7]).max() < 1e-9
    # the opacity falls with the distance alone, which it did in steps of a dot
    border = np.abs(away - 40.0) < 1.0
    from_line = np.polynomial.Polynomial.fit(away[border], painted[border][:, 3], 3)
    off = painted[border][:, 3] - from_line(away[border])
    steps = cover[border][:, 0] - np.polynomial.Polynomial.fit(
        away[border], cover[border][:, 0], 3
    )(away[border])
    assert np.abs(off).max() < 0.25 < np.abs(steps).max()

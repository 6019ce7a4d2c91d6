"""The picture of a sweep: lines between samples only where these show the motion."""

from __future__ import annotations

import numpy as np
import xarray as xr

from chaplygin.report.figures.sweep import are_close_enough, sweep


def motions(per_turn: float) -> xr.Dataset:
    times = np.arange(101) / per_turn
    values = np.stack([np.sin(2 * np.pi * times + phase) for phase in (0.0, 1.0)])
    return xr.Dataset(
        {"theta": (("run", "time"), values), "m": ("run", [1.0, 2.0])},
        coords={"time": times},
        attrs={"title": "Pendulum"},
    )


def test_samples_too_far_apart_are_points() -> None:
    (first, second), (third, _) = (
        sweep(motions(per_turn), ["m"], "theta").axes[0].lines for per_turn in (25.0, 3.0)
    )
    assert {first.get_linestyle(), second.get_linestyle()} == {"-"}
    assert (third.get_linestyle(), third.get_marker()) == ("None", ".")


def test_close_enough() -> None:
    assert are_close_enough(np.zeros((1, 2)))
    assert are_close_enough(np.full((1, 50), np.nan))
    assert are_close_enough(motions(12.0).theta.values)
    assert not are_close_enough(motions(6.0).theta.values)

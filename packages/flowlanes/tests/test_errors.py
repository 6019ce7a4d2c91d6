"""Errors told and carried between processes."""

from __future__ import annotations

import pickle

from flowlanes.errors import EarlyEndError, nearest


def test_an_early_end_names_system_time_and_reason() -> None:
    failure = EarlyEndError("coin", "the disk lies flat", 6.3219)
    for item in (failure, pickle.loads(pickle.dumps(failure))):
        assert str(item) == "coin: the motion ends at t = 6.3219 s: the disk lies flat"
        assert (item.system, item.reason, item.time) == ("coin", "the disk lies flat", 6.3219)


def test_the_nearest_name() -> None:
    names = ["mass", "mu", "M", "M_1", "M_2", "M_3", "x_1", "x_2", "a_2", "a_3", "a_4"]
    allowed = " allowed: mass, mu, M, M_1 … M_3, x_1, x_2, a_2, a_3, a_4"
    assert nearest("Mu", names) == f", did you mean 'mu'?{allowed}"
    assert nearest("m_3", names) == f", did you mean 'M_3'?{allowed}"
    assert nearest("masss", names) == f", did you mean 'mass'?{allowed}"
    assert nearest("diameter", ["parameters"]) == "; allowed: parameters"
    assert nearest("q", names) == f";{allowed}"
    assert nearest("q", []) == "; allowed: none"

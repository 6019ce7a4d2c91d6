"""Errors told and carried between processes."""

from __future__ import annotations

import pickle

from chaplygin.errors import EarlyEndError


def test_an_early_end_names_system_time_and_reason() -> None:
    failure = EarlyEndError("coin", "the disk lies flat", 6.3219)
    for item in (failure, pickle.loads(pickle.dumps(failure))):
        assert str(item) == "coin: the motion ends at t = 6.3219 s: the disk lies flat"
        assert (item.system, item.reason, item.time) == ("coin", "the disk lies flat", 6.3219)

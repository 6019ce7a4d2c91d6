"""Times at which a closed form is asked for its states."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pytest

from flowlanes.errors import InputError
from nonholonomic.closed_form.base.solution import finite_times


def test_one_time_is_a_sequence_of_one() -> None:
    assert finite_times(2.5).tolist() == [2.5]
    assert finite_times([1, 2.5]).tolist() == [1.0, 2.5]


@pytest.mark.parametrize(
    ("times", "sentence"),
    [
        ([[1.0, 2.0], [3.0, 4.0]], "they must be one number or a sequence of numbers"),
        (np.nan, "all of them must be finite numbers"),
        ([0.0, np.inf], "all of them must be finite numbers"),
    ],
)
def test_times_that_are_none(times: npt.ArrayLike, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        finite_times(times)

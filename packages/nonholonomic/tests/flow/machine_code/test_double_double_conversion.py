"""Numbers of 32 digits as two doubles: split and joined without loss."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import given, strategies as st

from flow.small import OSCILLATOR
from flowlanes.errors import InputError
from flowlanes.flow.machine_code.double_double_conversion import (
    as_pairs,
    from_pairs,
    parameter_pairs,
)

DOUBLES = st.floats(-1e150, 1e150, allow_subnormal=False)


def exact(pair: np.ndarray) -> Fraction:
    return Fraction(float(pair[0])) + Fraction(float(pair[1]))


@given(
    first=DOUBLES.filter(lambda x: x == 0 or abs(x) > 1e-100),
    share=st.sampled_from([0, 0.24, -0.24, 1e-3, -0.2]),
)
def test_a_pair_is_split_and_joined_to_the_bit(first: float, share: float) -> None:
    rest = float(np.spacing(first) * share) if first else 0.0
    with mpmath.workdps(60):
        number = mpmath.mpf(first) + mpmath.mpf(rest)
        found = as_pairs("x", np.array([number], dtype=object))
    assert found.tolist() == [[first, rest]]
    (joined,) = from_pairs(found[:, 0], found[:, 1])
    with mpmath.workdps(60):
        assert abs(joined - number) <= abs(number) * mpmath.mpf(10) ** -38


@given(st.fractions(max_denominator=10**9).filter(lambda f: abs(f) < 10**9))
def test_digits_beyond_the_second_word_are_rounded(value: Fraction) -> None:
    with mpmath.workdps(60):
        number = mpmath.mpf(value.numerator) / value.denominator
        pair = as_pairs("x", np.array([number], dtype=object))[0]
    assert abs(exact(pair) - value) <= abs(value) / 2**105
    assert pair[0] == float(value)
    assert pair[0] + pair[1] == pair[0]


def test_shapes_and_doubles() -> None:
    numbers = np.arange(6.0).reshape(2, 3)
    found = as_pairs("x", numbers)
    assert found.shape == (2, 3, 2)
    np.testing.assert_array_equal(found[..., 0], numbers)
    assert not found[..., 1].any()
    with mpmath.workdps(40):
        mixed = np.array([[1, mpmath.mpf("0.1")], [2.5, mpmath.mpf("0.3")]], dtype=object)
    found = as_pairs("x", mixed)
    assert found.shape == (2, 2, 2)
    assert (found[:, 0, 1] == 0).all()
    assert (found[:, 1, 1] != 0).all()
    assert from_pairs(found[..., 0], found[..., 1]).shape == (2, 2)
    assert as_pairs("x", np.zeros((0, 3))).shape == (0, 3, 2)


def test_parameters_keep_their_digits() -> None:
    """Of mpmath's numbers; a double is what it is."""
    with mpmath.workdps(40):
        tenth = mpmath.mpf("0.1")
    assert parameter_pairs(OSCILLATOR, None, 3).tolist() == [[[1.0, 0.0]]]
    assert parameter_pairs(OSCILLATOR, {"p": 0.1}, 3).tolist() == [[[0.1, 0.0]]]
    fine = parameter_pairs(OSCILLATOR, {"p": tenth}, 3)
    assert fine.shape == (1, 1, 2)
    assert abs(exact(fine[0, 0]) - Fraction(1, 10)) < Fraction(1, 10**33)
    each = parameter_pairs(OSCILLATOR, {"p": np.array([tenth, 2 * tenth, 1])}, 3)
    assert each.shape == (3, 1, 2)
    assert each[:, 0, 0].tolist() == [0.1, 0.2, 1.0]
    assert each[2, 0, 1] == 0


@pytest.mark.parametrize("values", [["a", "b"], [[1, 2], [3]], [1j]])
def test_what_is_no_number(values: list[object]) -> None:
    with pytest.raises(InputError) as caught:
        as_pairs("starts", values)
    assert str(caught.value) == "starts: all must be real numbers, in rows of one length"

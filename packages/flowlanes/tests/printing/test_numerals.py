"""Numbers and units as they are printed."""

import pytest

from flowlanes.printing.numerals import number, typographic_signs, unit


@pytest.mark.parametrize(
    ("value", "digits", "printed"),
    [
        (0.0, 2, "0"),
        (-0.0, 2, "0"),
        (-2.5, 10, "−2.5"),
        (1.8e-15, 2, "1.8 × 10⁻¹⁵"),
        (-2e-05, 10, "−2 × 10⁻⁵"),
        (1e22, 3, "1 × 10²²"),
        (9.81, 6, "9.81"),
    ],
)
def test_a_number(value, digits, printed):
    assert number(value, digits) == printed


@pytest.mark.parametrize(
    ("words", "printed"),
    [
        ("as at φ = -2*atan(5/3), x = -0.5", "as at φ = −2*atan(5/3), x = −0.5"),
        ("[-1.5, 2]", "[−1.5, 2]"),
        ("1.25e-07 ± 5.64e-22 J", "1.25 × 10⁻⁷ ± 5.64 × 10⁻²² J"),
        # no signs: words, ranges of letters, names
        ("a well-known two-frequency motion, law-2 of 1903-04", None),
        ("x_1e5 and f1e3", None),
    ],
)
def test_signs_and_powers_within_words(words, printed):
    assert typographic_signs(words) == (words if printed is None else printed)


@pytest.mark.parametrize("written", ["kg^2 m^4/s^2", "kg**2*m**4/s**2", "kg^{2} m^{4}/s^{2}"])
def test_a_unit(written):
    assert unit(written) == "kg² m⁴/s²"
    assert unit("m s^-1") == "m s⁻¹"
    # it was kg⁰.5
    assert unit("kg^0.5 m/s") == "kg^0.5 m/s"

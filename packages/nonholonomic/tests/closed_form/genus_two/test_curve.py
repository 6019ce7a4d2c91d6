import pytest
from flint import arb, ctx

from nonholonomic.closed_form.genus_two.curve import Curve, DegenerateError

ROOTS = [arb("2.1"), arb(0), arb("1.5"), arb("1.7"), arb(1)]


def test_ovals_are_where_the_curve_is_real() -> None:
    for leading, roots in ((1, ROOTS), (-1, ROOTS), (1, [*ROOTS, arb(-1)]), (-1, [*ROOTS, arb(3)])):
        curve = Curve.of(arb(leading), roots)
        for left in range(len(roots) - 1):
            low, high = curve.ends(left)
            assert (curve((low + high) / 2) > 0) == (left in curve.ovals)


def test_a_point_is_on_the_nearest_oval() -> None:
    curve = Curve.of(arb(1), ROOTS)
    assert curve.ovals == (0, 2)
    assert curve.oval_of(arb("0.3")) == 0
    assert curve.oval_of(arb("1.5") - arb("1e-30")) == 2
    assert curve.oval_of(arb(1) + arb("1e-30")) == 0


def test_the_rest_completes_the_curve() -> None:
    with ctx.workprec(200):
        curve = Curve.of(arb(-2), [*ROOTS, arb(3)])
        for left in range(5):
            low, high = curve.ends(left)
            s = arb("0.9")
            z = (low + high) / 2 - (high - low) / 2 * s.cos()
            assert ((z - low) * (high - z) * curve.cofactor(left, s)).overlaps(abs(curve(z)))


def test_equal_roots_are_told() -> None:
    with pytest.raises(DegenerateError):
        Curve.of(arb(1), [*ROOTS[:4], arb("1.7", 1e-20)])

import mpmath
import pytest
from flint import arb, ctx

from flowlanes.formulas.balls import number
from nonholonomic.closed_form.genus_two.curve import Curve
from nonholonomic.closed_form.genus_two.periods import abelian, lattice

FIVE = [arb(0), arb(1), arb("1.5"), arb("1.7"), arb("2.1")]
SIX = [*FIVE, arb(-1)]


@pytest.mark.parametrize("left", range(5))
def test_integrals_agree_with_another_quadrature(left: int) -> None:
    curve = Curve.of(arb(-1), SIX)
    roots = [mpmath.mpf(root.str(17, radius=False)) for root in curve.roots]

    def integrand(z: mpmath.mpf) -> mpmath.mpf:
        return 1 / mpmath.sqrt(abs(mpmath.fprod(z - root for root in roots)))

    both = abelian(curve, left)
    for power, value in enumerate(both):
        other = mpmath.quad(lambda z: z**power * integrand(z), roots[left : left + 2])  # noqa: B023
        assert number(value) == pytest.approx(float(other), rel=1e-7)


@pytest.mark.parametrize(
    ("leading", "roots", "ovals"),
    [(1, FIVE, (0, 2)), (-1, SIX, (0, 2)), (-1, SIX, (2, 4)), (-1, SIX, (0, 4)), (1, SIX, (1, 3))],
    ids=["five", "first", "last", "outer", "through infinity"],
)
def test_the_period_matrix_is_reduced_and_the_odd_characteristics_are_all_there(
    leading: int, roots: list[arb], ovals: tuple[int, int]
) -> None:
    with ctx.workprec(200):
        found = lattice(Curve.of(arb(leading), roots), ovals)
        Y = found.Y
        assert Y.det() > 0
        assert Y[0, 0] > 0
        assert 2 * abs(Y[0, 1]) <= Y[0, 0] + arb("1e-50")
        assert Y[0, 0] <= Y[1, 1] + arb("1e-50")
        odd = {found.characteristic(root) for root in range(6)}
        assert len(odd) == 6
        assert all(sum(a * b for a, b in zip(*pair, strict=True)) % 2 == 1 for pair in odd)


def test_a_turn_around_an_oval_is_one_unit() -> None:
    curve = Curve.of(arb(1), FIVE)
    found = lattice(curve, (0, 2))
    for index, left in enumerate(found.ovals):
        x, y = abelian(curve, left)
        turns = found.around_ovals(found.normalised_integrals((2 * x, 2 * y)))
        assert turns[index].contains(1)
        assert turns[1 - index].contains(0)


@pytest.mark.parametrize("gap", ["1e-8", "1e-20"])
def test_nearly_equal_roots_are_no_trouble(gap: str) -> None:
    with ctx.workprec(320):
        curve = Curve.of(arb(1), [*FIVE[:3], arb("1.5") + arb(gap), arb("2.1")])
        found = lattice(curve, (0, 2))
        assert found.Y.det() > 0
        assert found.Y[0, 1].rad() < arb("1e-40")

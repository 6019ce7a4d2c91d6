"""The plane cut along curves: the right number of faces, and every point in its own."""

from __future__ import annotations

import pytest
from flint import arb, fmpq, fmpq_poly
from hypothesis import given, strategies as st

from flowlanes.formulas.balls import exact
from nonholonomic.closed_form.bifurcation.arrangement import (
    RING,
    arrangement,
    highest,
    lowest,
    ordered_roots,
    rational,
    short_rational,
    stack,
)

x, y, _ = RING.gens()


def faces(cut):
    """Classes of cells that are joined across critical verticals."""
    parent = {cell: cell for cell in cut.cells}

    def root(cell):
        while parent[cell] != cell:
            cell = parent[cell]
        return cell

    for one, other in cut.joints:
        parent[root(one)] = root(other)
    return {cell: root(cell) for cell in cut.cells}


@pytest.mark.parametrize(
    ("curves", "count"),
    [
        ([y], 2),
        ([x], 1),
        ([y * (y - 1)], 3),
        ([x**2 + y**2 - 1], 2),
        ([x**2 + y**2], 1),
        ([x**2 + y**2 + 1], 1),
        ([x**2 + y**2 - 1, y - x, 3 * y - x], 8),
        # a parabola and a line that touches it: inside, left and right of the point, below
        ([y - x**2, y - 2 * x + 1], 4),
        ([x * y - 1], 3),
        ([y**2 - x**3], 2),
        # a node
        ([y**2 - x**2 * (x + 1)], 3),
        # with a circle around the loop: 4 corners (one at infinity), 7 edges, so 5 faces
        ([y**2 - x**2 * (x + 1), x**2 + y**2 - 2], 5),
        # abscissae that are not rational
        ([y - x**3 + 2 * x, y], 6),
        ([(x**2 + y**2 - 2) * (y - x**2)], 4),
    ],
    ids=str,
)
def test_faces(curves, count):
    assert len(set(faces(arrangement(curves)).values())) == count


def test_samples_lie_in_their_cells():
    cut = arrangement([y**2 - x**2 * (x + 1), x**2 + y**2 - 2, x - y])
    for cell in cut.cells:
        assert cut.cell(*cut.sample(cell)) == cell
    orders = [len(order) for order in cut.orders]
    assert len(list(cut.arcs)) == sum(orders)
    assert len(list(cut.cells)) == sum(orders) + len(orders)


def test_points_on_verticals_and_curves():
    cut = arrangement([x**2 + y**2 - 1])
    joined = faces(cut)
    inside, outside = (joined[cut.cell(fmpq(0), fmpq(h))] for h in (0, 2))
    assert inside != outside
    # beside and above the points where the circle has vertical tangents
    assert joined[cut.cell(fmpq(1), fmpq(1, 100))] == outside
    assert joined[cut.cell(fmpq(99, 100), fmpq(1, 100))] == inside
    assert cut.cell(fmpq(3, 5), fmpq(4, 5)) is None
    assert cut.arc(fmpq(3, 5), fmpq(4, 5)) == (1, 1)
    assert cut.arc(fmpq(3, 5), fmpq(-4, 5)) == (1, 0)
    assert cut.arc(fmpq(1), fmpq(0)) is None
    assert cut.arc(fmpq(0), fmpq(0)) is None


def test_close_roots_keep_their_order():
    """Two curves that all but touch: 1e-30 apart, beyond doubles."""
    gap = fmpq(1, 10**30)
    heights = stack((y - 1, y - 1 - gap), fmpq(0))
    assert [number for _, number in heights] == [0, 1]
    assert [number for _, number in stack((y - 1 - gap, y - 1), fmpq(0))] == [1, 0]


def test_common_roots_are_noticed():
    with pytest.raises(ArithmeticError, match="without a common root"):
        ordered_roots([fmpq_poly([-1, 1]), fmpq_poly([-1, 0, 1])])


@given(st.fractions(), st.fractions())
def test_between(first, second):
    low, high = sorted((first, second))
    if low < high:
        found = short_rational(low, high)
        assert low < found < high
        assert found.denominator <= 4 * max(1, round(1 / (high - low)))


@given(st.fractions())
def test_ends_of_balls(value):
    ball = arb(rational(value))
    assert lowest(ball) <= value <= highest(ball)
    assert highest(ball) - lowest(ball) <= abs(value) / 2**50
    assert exact(ball) == (lowest(ball) + highest(ball)) / 2


def test_a_gap_beyond_doubles():
    """The cell between two lines 1e-30 apart."""
    gap = fmpq(1, 10**30)
    cut = arrangement([y - 1, y - 1 - gap])
    assert len(list(cut.cells)) == 3
    _, height = cut.sample((0, 1))
    assert 1 < height < 1 + gap
    assert cut.cell(fmpq(7), 1 + gap / 2) == (0, 1)
    # and a critical vertical as close to the point
    crossed = arrangement([x + y * 10**30])
    assert crossed.cell(fmpq(1), -gap / 2) == (0, 1)
    cornered = arrangement([x**2 + y**2 - 1])
    assert cornered.cell(1 - gap, fmpq(0)) == (1, 1)
    assert cornered.cell(1 + gap, fmpq(0)) == (2, 0)
    assert cornered.cell(-1 - gap, fmpq(0)) == (0, 0)

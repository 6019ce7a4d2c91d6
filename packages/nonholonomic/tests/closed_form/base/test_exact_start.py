import pytest
from flint import arb, ctx

from flowlanes.errors import InputError
from flowlanes.formulas.balls import ball
from nonholonomic.closed_form.base.exact_start import on_phase_space
from nonholonomic.closed_form.separations.veselova import veselova

SYSTEM = veselova().system
VALUES = {s: ball(x) for s, x in SYSTEM.defaults.items()}


def test_rounding_is_made_up() -> None:
    with ctx.workprec(320):
        state = on_phase_space(SYSTEM, (), (0.8, 0.1, -0.6, 0.6, 0.0, 0.8 + 1e-12), VALUES)
        gamma = state[3:]
        assert abs(sum((x * x for x in gamma), arb(0)) - 1) < arb("1e-90")
        assert abs(sum((x * y for x, y in zip(state, gamma, strict=False)), arb(0))) < arb("1e-90")
        assert abs(state[0] - arb("0.8")) < arb("1e-11")


def test_more_than_rounding_is_refused() -> None:
    for unit in (1.0, 1e-7, 1e7):
        omega = (0.8 * unit, 0.1 * unit, -0.6 * unit)
        # γ² − 1 misses 0.0001 of 3·0.8² + 1
        with pytest.raises(InputError, match=r"misses the constraints by 3\.42e-05 of the size"):
            on_phase_space(SYSTEM, (), (*omega, 0.6, 0.0, 0.8 + 0.0001 / 1.6), VALUES)
        with pytest.raises(InputError, match=r"by 2\.08e-06 of the size"):
            # 4·10⁻⁶ of 3·0.8·0.8
            tilted = (0.8 * unit, 0.1 * unit, -0.600005 * unit)
            on_phase_space(SYSTEM, (), (*tilted, 0.6, 0.0, 0.8), VALUES)


def test_conditions_on_parameters_are_not_on_the_state() -> None:
    with ctx.workprec(100):
        start = (0.8, 0.1, -0.6, 0.6, 0.0, 0.8)
        (symbol, *_) = VALUES
        assert on_phase_space(SYSTEM, (symbol - 5,), start, VALUES) == on_phase_space(
            SYSTEM, (), start, VALUES
        )

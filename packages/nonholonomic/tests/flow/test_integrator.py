"""Trajectories: how accurate they are, and every way in which they can be asked for."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp

from evaluation import drift
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.flow.taylor.working_numbers import number_type
from flowlanes.system.system import Observable, Parameter, System
from flowlanes.system.vectors import vectors
from needs import needs
from nonholonomic.catalogue import CATALOGUE, from_catalogue
from nonholonomic.starts import initial_state

x, y, p, b = sp.symbols("x y p b", real=True)

NEEDS_HEYOKA = needs("heyoka")
QUAD = pytest.param("quad", marks=NEEDS_HEYOKA)

OSCILLATOR = System(
    name="oscillator",
    title="Oscillator",
    parameters=(
        Parameter(p, "square of the frequency", 1.0, admissible=(p > b,)),
        Parameter(b, "least square of the frequency", 0.0),
    ),
    field={x: y, y: -p * x},
    observables=(Observable("square", x**2, "square"),),
)


def example(name):
    entry = CATALOGUE[name]
    system = entry.system()
    return system, initial_state(system, entry.start.omega, entry.start.gamma)


def far(one, other):
    return max(abs(float(u - v)) for u, v in zip(np.ravel(one), np.ravel(other), strict=True))


# --- accuracy --------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "until"),
    [
        ("chaplygin-ball", 50.0),
        ("unbalanced-rubber-ball", 50.0),
        ("ball-around-sphere", 50.0),
        ("heavy-disk", 10.0),
    ],
)
def test_double_agrees_with_thirty_digits(name, until):
    system, start = example(name)
    times = np.linspace(0.0, until, 11)
    double = integrate(system, start, times)
    quad = integrate(system, start, times, precision="quad", tolerance=1e-32)
    assert double.states.dtype == float
    assert quad.states.dtype == number_type("quad")
    assert far(double.states, quad.states) < 1e-12
    for law in system.integrals:
        values = quad.records[f"law_{law.name}"]
        assert drift(values) < 1e-30
        assert float(values[0]) == pytest.approx(double.records[f"law_{law.name}"][0], rel=1e-14)


def test_thirty_digits_are_right():
    """cos 10 and sin 10, from mpmath."""
    motion = integrate(OSCILLATOR, [1, 0], [0, 10], precision="quad", tolerance=1e-33)
    with mpmath.workdps(40):
        exact = mpmath.cos(10), -mpmath.sin(10)
        found = [mpmath.mpf(str(value)) for value in motion.states[-1]]
        assert all(abs(u - v) < 1e-31 for u, v in zip(found, exact, strict=True))


def test_a_start_keeps_all_its_digits():
    with mpmath.workdps(40):
        third = mpmath.mpf(1) / 3
    quad = integrate(OSCILLATOR, [third, 0], [0, 1], precision="quad")
    assert abs(quad.states[0, 0] - number_type("quad")(1) / 3) < 1e-33
    with mpmath.workdps(20):
        root = mpmath.sqrt(2)
    double = integrate(OSCILLATOR, [root, 0], [0, 1])
    assert double.states[0, 0] == np.sqrt(2.0)


def test_a_decimal_means_itself_at_any_precision():
    motion = integrate(OSCILLATOR, [0.1, 0], [0.3, 1], precision="quad", parameters={p: 0.7})
    assert str(motion.states[0, 0]).startswith("0.1000000000000000000000000000000000")
    assert str(motion.times[0]).startswith("0.29999999999999999999999999999999999")
    same = integrate(
        OSCILLATOR, [0.1, 0], ["0.3", "1"], precision="quad", parameters={p: mpmath.mpf("0.7")}
    )
    assert far(motion.states, same.states) < 1e-15


@pytest.mark.parametrize(("tolerance", "largest"), [(1e-6, 1e-5), (1e-12, 1e-11)])
def test_a_coarser_tolerance_is_cheaper(tolerance, largest):
    system, start = example("chaplygin-ball")
    times = [0.0, 10.0]
    best, coarse = (integrate(system, start, times, tolerance=tol) for tol in (1e-15, tolerance))
    assert 1e-15 < far(best.states, coarse.states) < largest
    assert coarse.statistics.order < best.statistics.order


# --- attitude --------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["chaplygin-ball", "unbalanced-rubber-ball", "veselova"])
def test_attitude_stays_consistent_for_long(name):
    """The quaternion has length 1 and carries γ to the vertical, to the last digit."""
    system, start = example(name)
    motion = integrate(system, start, np.linspace(0.0, 1000.0, 501))
    w, x, y, z = motion["attitude"].T
    third = np.array([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x**2 + y**2)]).T
    # 1e-15 by the reckoning of the package, and rounding here
    assert np.abs(w**2 + x**2 + y**2 + z**2 - 1).max() < 1.5e-15
    assert np.abs(third - motion["gamma"]).max() < 1.5e-15
    assert np.abs((motion["gamma"] ** 2).sum(axis=1) - 1).max() < 1.5e-15


def test_attitude_does_not_spoil_the_dynamics():
    """The reduced motion is the same, whatever the heading of the body."""
    system, _ = example("unbalanced-rubber-ball")
    omega, gamma = (0.5, -0.5, 0.25), (0.0, 0.447213595499958, 0.894427190999916)
    motions = [
        integrate(system, initial_state(system, omega, gamma, heading=angle), np.linspace(0, 20, 5))
        for angle in (0.0, 1.0)
    ]
    assert far(motions[0].states[:, :6], motions[1].states[:, :6]) < 1e-13
    assert far(motions[0]["centre"], motions[1]["centre"]) > 0.1
    assert far(motions[0]["centre"][:, 2], motions[1]["centre"][:, 2]) < 1e-13


# --- quadratures -----------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["chaplygin-ball", "heavy-disk"])
def test_a_place_far_away_costs_no_digits(name):
    system, start = example(name)
    shift = 1e6
    columns = [system.lifted().symbols.index(sp.Symbol(f"place_{i}", real=True)) for i in "xy"]
    moved = [x + shift * (i in columns) for i, x in enumerate(start)]
    times = np.linspace(0.0, 50.0, 11)
    here, there = (integrate(system, state, times) for state in (start, moved))
    for name in ("omega", "gamma", "attitude", "normal_force"):
        assert here[name].tolist() == there[name].tolist()
    shifted = here["contact"] + np.array([shift, shift, 0.0])
    assert np.abs(there["contact"] - shifted).max() <= 2 * np.spacing(shift)


def test_the_contact_moves_over_the_plane_as_over_the_body():
    """The trace on the plane has the velocity of the trace on the ball, ṙ = −R γ×ω with R = 1."""
    system, start = example("unbalanced-ball")
    step = 1e-3
    motion = integrate(system, start, step * np.arange(5))
    velocity = np.array([1, -8, 0, 8, -1]) @ motion["contact"] / (12 * step)
    w, *vector = motion["attitude"][2]
    over_body = -np.cross(motion["gamma"][2], motion["omega"][2])
    turned = np.cross(vector, np.cross(vector, over_body) + w * over_body)
    assert velocity == pytest.approx(over_body + 2 * turned, abs=1e-10)
    assert motion["contact"][:, 2].tolist() == [0.0] * 5


# --- times -----------------------------------------------------------------------------------


def test_chosen_times_are_met():
    system, start = example("chaplygin-ball")
    chosen = [0.0, 1e-9, 0.1, 0.1 + 1e-12, 3.7, 3.75, 20.0]
    motion = integrate(system, start, chosen)
    assert motion.times.tolist() == chosen
    whole = integrate(system, start, chosen, dense=True)
    for moment, state in zip(chosen[1:], motion.states[1:], strict=True):
        alone = integrate(system, start, [0.0, moment])
        assert far(alone.states[-1], state) < 1e-13
        assert far(whole.dense(moment)[0], state) < 4e-15


def test_samples_do_not_disturb_the_motion():
    system, start = example("heavy-disk")
    few, many = (integrate(system, start, np.linspace(0, 5, n)) for n in (2, 1001))
    assert few.states[-1].tolist() == many.states[-1].tolist()
    assert few.statistics.steps == many.statistics.steps


def test_time_need_not_begin_at_zero():
    system, start = example("chaplygin-ball")
    early = integrate(system, start, [0.0, 2.0, 5.0])
    late = integrate(system, start, [64.0, 66.0, 69.0])
    assert far(early.states, late.states) < 1e-13


@pytest.mark.parametrize("name", ["chaplygin-ball", "heavy-disk", "rubber-ball-around-sphere"])
def test_backward_returns_to_the_start(name):
    system, start = example(name)
    there = integrate(system, start, [0.0, 10.0])
    back = integrate(system, there.states[-1], [10.0, 5.0, 0.0])
    assert back.times.tolist() == [10.0, 5.0, 0.0]
    assert far(back.states[-1], there.states[0]) < 2e-13


@pytest.mark.parametrize(
    ("times", "message"),
    [
        ([], "0 time(s) given: at least a first and a last are needed"),
        ([1.0], "1 time(s) given: at least a first and a last are needed"),
        ([0.0, 1.0, 1.0], "times: they must be all increasing or all decreasing"),
        ([0.0, 2.0, 1.0], "times: they must be all increasing or all decreasing"),
        ([0.0, -2.0, -1.0], "times: they must be all increasing or all decreasing"),
        ([0.0, 0.0], "times: they must be all increasing or all decreasing"),
        ([0.0, float("nan")], "times: all of them must be finite numbers"),
        ([0.0, float("inf")], "times: all of them must be finite numbers"),
        ([float("-inf"), 0.0], "times: all of them must be finite numbers"),
    ],
)
@pytest.mark.parametrize("precision", ["double", QUAD])
def test_useless_times_are_refused(times, message, precision):
    with pytest.raises(InputError) as caught:
        integrate(OSCILLATOR, [1, 0], times, precision=precision)
    assert str(caught.value) == message


@pytest.mark.parametrize(
    ("tolerance", "precision", "message"),
    [
        (0.0, "double", "tolerance 0.0: it must lie between 0 and 1"),
        pytest.param(1.0, "quad", "tolerance 1.0: it must lie between 0 and 1", marks=NEEDS_HEYOKA),
        (float("nan"), "double", "tolerance nan: it must lie between 0 and 1"),
        (1e-17, "double", "beyond double precision: use at least 1e-16, or precision 'quad'"),
    ],
)
def test_useless_tolerances_are_refused(tolerance, precision, message):
    with pytest.raises(InputError) as caught:
        integrate(OSCILLATOR, [1, 0], [0, 1], tolerance=tolerance, precision=precision)
    assert message in str(caught.value)


# --- dense output ----------------------------------------------------------------------------


@pytest.mark.parametrize("until", [10.0, -10.0])
@pytest.mark.parametrize("name", ["chaplygin-ball", "heavy-disk"])
def test_dense_output_passes_through_the_samples(name, until):
    system, start = example(name)
    times = np.linspace(0.0, until, 101)
    motion = integrate(system, start, times, dense=True)
    assert motion.dense.span == (0.0, until)
    assert far(motion.dense(times), motion.states) < 2e-14
    between = (times[1:] + times[:-1]) / 2
    exact = integrate(system, start, [0.0, *between]).states[1:]
    assert far(motion.dense(between), exact) < 2e-14


def test_dense_output_of_one_time_and_of_none_outside():
    motion = integrate(OSCILLATOR, [1, 0], [0, 3], dense=True)
    assert motion.dense(1.25) == pytest.approx(np.array([[np.cos(1.25), -np.sin(1.25)]]), abs=1e-15)
    for outside in (-1e-9, 3.0 + 1e-9, [1.0, 4.0]):
        with pytest.raises(InputError, match="time outside the computed interval from 0 to 3"):
            motion.dense(outside)


def test_dense_output_with_thirty_digits():
    motion = integrate(OSCILLATOR, [1, 0], [0, 3], dense=True, precision="quad", tolerance=1e-33)
    (state,) = motion.dense(1.25)
    with mpmath.workdps(40):
        assert abs(mpmath.mpf(str(state[0])) - mpmath.cos(mpmath.mpf("1.25"))) < 1e-31


def test_dense_output_is_kept_only_on_request():
    assert integrate(OSCILLATOR, [1, 0], [0, 1]).dense is None


def test_a_far_place_is_in_the_dense_output_too():
    system, start = example("chaplygin-ball")
    moved = [*start[:-2], 1e6, -1e6]
    times = np.linspace(0.0, 10.0, 21)
    motion = integrate(system, moved, times, dense=True)
    assert far(motion.dense(times), motion.states) <= 2 * np.spacing(1e6)


# --- parameters ------------------------------------------------------------------------------


def test_parameters_at_run_time_are_those_of_another_system():
    entry = CATALOGUE["chaplygin-ball"]
    other = entry.system({"I_1": 1.3, "R": 0.8})
    start = initial_state(other, entry.start.omega, entry.start.gamma)
    symbols = sp.symbols("I_1 R", real=True)
    given = dict(zip(symbols, (1.3, 0.8), strict=True))
    one = integrate(entry.system(), start, [0.0, 10.0], parameters=given)
    two = integrate(other, start, [0.0, 10.0])
    assert one.states.tolist() == two.states.tolist()
    assert one.records["law_energy"].tolist() == two.records["law_energy"].tolist()
    assert one.parameters == two.parameters


def test_an_unknown_parameter_is_refused():
    with pytest.raises(InputError) as caught:
        integrate(OSCILLATOR, [1, 0], [0, 1], parameters={sp.Symbol("q", real=True): 1.0})
    assert str(caught.value) == "oscillator: no parameter q; it has p, b"


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({p: float("nan")}, "oscillator: p = nan must be a finite number"),
        ({b: float("inf")}, "oscillator: b = inf must be a finite number"),
        ({p: -1.0}, "oscillator: p = -1.0 is not admissible; p > b must hold"),
        ({b: 2}, "oscillator: p = 1.0 is not admissible; p > b must hold"),
        ({p: Fraction(0)}, "oscillator: p = 0 is not admissible; p > b must hold"),
    ],
)
def test_inadmissible_parameters_are_refused(values, message):
    with pytest.raises(InputError) as caught:
        integrate(OSCILLATOR, [1, 0], [0, 1], parameters=values)
    assert str(caught.value) == message


# --- start -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("start", "message"),
    [
        ([1], "start has 1 numbers: 2 are needed (x, y)"),
        ([1, 0, 0], "start has 3 numbers: 2 are needed (x, y)"),
        ([1, float("nan")], "start: all of its numbers must be finite"),
        ([float("inf"), 1], "start: all of its numbers must be finite"),
        ([mpmath.inf, 1], "start: all of its numbers must be finite"),
    ],
)
def test_a_useless_start_is_refused(start, message):
    with pytest.raises(InputError) as caught:
        integrate(OSCILLATOR, start, [0, 1])
    assert str(caught.value) == message


@pytest.mark.parametrize("index", [3, 6])
def test_a_start_off_the_phase_space_is_refused(index):
    system, start = example("unbalanced-ball")
    moved = [float(value) for value in start]
    moved[index] += 1e-6
    with pytest.raises(InputError, match="start: it misses the relations of the phase space by"):
        integrate(system, moved, [0.0, 1.0])


def test_a_start_close_to_the_phase_space_is_put_on_it():
    system, start = example("veselova")
    moved = [float(value) + 1e-11 for value in start]
    motion = integrate(system, moved, [0.0, 1.0])
    omega, gamma = motion["omega"][0], motion["gamma"][0]
    assert abs(omega @ gamma) < 1e-15
    assert abs(gamma @ gamma - 1) < 1e-15
    assert far(motion.states[0], start) < 1e-10


# --- integrals kept --------------------------------------------------------------------------


def test_integrals_are_kept_at_a_coarse_tolerance():
    system, start = example("unbalanced-ball")
    times = np.linspace(0.0, 100.0, 101)
    free, kept = (
        integrate(system, start, times, tolerance=1e-6, keep_integrals=keep)
        for keep in (False, True)
    )
    for law in system.laws:
        assert drift(free.records[f"law_{law.name}"]) > 1e-8
        assert drift(kept.records[f"law_{law.name}"]) < 5e-15
    gamma = kept["gamma"]
    assert np.abs((gamma**2).sum(axis=1) - 1).max() < 5e-15
    best = integrate(system, start, [0.0, 10.0])
    assert far(kept.states[10], best.states[-1]) < 1e-4


def test_keeping_integrals_does_not_disturb_a_good_motion():
    system, start = example("chaplygin-ball")
    times = [0.0, 20.0]
    free, kept = (integrate(system, start, times, keep_integrals=keep) for keep in (False, True))
    assert far(free.states, kept.states) < 1e-13


# --- what comes back -------------------------------------------------------------------------


def test_variables_by_name():
    system, start = example("unbalanced-ball")
    motion = integrate(system, start, np.linspace(0.0, 1.0, 7))
    assert motion["M"].shape == motion["gamma"].shape == motion["omega"].shape == (7, 3)
    assert motion["centre"].shape == motion["contact"].shape == (7, 3)
    assert motion["attitude"].shape == (7, 4)
    assert motion["place"].shape == (7, 2)
    assert motion["normal_force"].shape == motion["law_energy"].shape == (7,)
    with pytest.raises(KeyError, match="velocity"):
        motion["velocity"]
    scalars = integrate(OSCILLATOR, [1, 0], [0.0, 1.0, 2.0])
    assert scalars["x"] == pytest.approx(np.cos(scalars.times), abs=1e-15)
    assert scalars["square"] == pytest.approx(scalars["x"] ** 2, abs=1e-16)


def test_progress_rises_to_nearly_one():
    system, start = example("chaplygin-ball")
    seen = []
    integrate(system, start, [0.0, 200.0], progress=seen.append)
    assert len(seen) > 5
    assert seen == sorted(seen)
    assert 0 < seen[0] < 0.2
    assert 0.8 < seen[-1] <= 1.0


def test_statistics():
    system, start = example("chaplygin-ball")
    integrate(system, start, [0.0, 1.0])
    statistics = integrate(system, start, [0.0, 10.0]).statistics
    assert statistics.from_cache
    assert 10 < statistics.steps < 200
    assert 15 <= statistics.order <= 25
    assert 0 < statistics.seconds < 60


def test_one_system_can_be_integrated_from_many_starts():
    """No run leaves anything behind for the next one."""
    system, start = example("chaplygin-ball")
    first = integrate(system, start, [0.0, 5.0])
    integrate(system, initial_state(system, (3, 2, 1), (1, 0, 0)), [3.0, -5.0], dense=True)
    again = integrate(system, start, [0.0, 5.0])
    assert first.states.tolist() == again.states.tolist()


def test_a_run_within_a_run():
    """The compiled code is shared, the state of a run is its own."""
    system, start = example("chaplygin-ball")
    alone = integrate(system, start, [0.0, 100.0])
    inner = []

    def disturb(_: float) -> None:
        inner.append(integrate(system, start, [5.0, -5.0], parameters={m: 2.0}))

    m = sp.Symbol("m", real=True)
    assert integrate(system, start, [0.0, 100.0], progress=disturb).states.tolist() == (
        alone.states.tolist()
    )
    assert len(inner) > 1
    assert inner[0].states.tolist() == inner[-1].states.tolist()

    def disturb_alike(_: float) -> None:
        integrate(system, start, [0.0, 5.0], parameters={m: 2.0})

    assert integrate(system, start, [0.0, 100.0], progress=disturb_alike).states.tolist() == (
        alone.states.tolist()
    )


def test_a_system_without_anything_recorded():
    (u,) = vectors("u")
    bare = System(name="bare", title="Bare", field={u: -u})
    motion = integrate(bare, [1, 2, 3], [0.0, 1.0])
    assert motion.records == {}
    assert motion["u"][-1] == pytest.approx(np.exp(-1) * np.array([1, 2, 3]), rel=1e-15)


def test_a_catalogue_system_has_its_name_in_errors():
    system = from_catalogue("veselova")
    with pytest.raises(InputError, match="veselova: no parameter z; it has I_1, I_2, I_3"):
        integrate(system, [0] * 10, [0, 1], parameters={sp.Symbol("z"): 1})

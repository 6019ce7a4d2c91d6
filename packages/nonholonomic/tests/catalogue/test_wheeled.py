"""Trailers, snakeboard, vertical disk and roller-racer: their nonholonomy and their motions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.vectors import real_symbol
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.mechanism_systems import mechanism_in_catalogue
from nonholonomic.catalogue.mechanisms import trailers
from nonholonomic.mechanics.constraints.exceptional_parameters import exceptional_values
from nonholonomic.mechanics.constraints.integrability import nonholonomy, nonholonomy_at

FOLDED = sp.pi / 2


@pytest.mark.parametrize("count", range(5))
def test_trailers_grow_by_one_dimension_a_step(count):
    found = nonholonomy(trailers.train(count))
    assert found.growth == tuple(range(2, count + 4))
    assert (found.verdict, found.proven) == ("completely nonholonomic", True)


JACKKNIFED = [
    (1, {"phi_1": FOLDED}, (2, 3, 4)),
    (2, {"phi_2": FOLDED}, (2, 3, 4, 5)),
    (2, {"phi_1": FOLDED}, (2, 3, 4, 4, 5)),
    (3, {"phi_2": FOLDED}, (2, 3, 4, 5, 5, 6)),
    (3, {"phi_1": FOLDED, "phi_2": FOLDED}, (2, 3, 4, 4, 5, 5, 5, 6)),
]


@pytest.mark.parametrize(("count", "angles", "expected"), JACKKNIFED)
def test_trailers_take_longer_words_where_they_are_folded(count, angles, expected):
    """The longest words have Fibonacci lengths: 3, 5, 8 for one, two and three trailers."""
    point = {real_symbol(name): value for name, value in angles.items()}
    found = nonholonomy_at(trailers.train(count), point)
    assert found.growth == expected
    assert found.is_final
    assert len(expected) <= (3, 5, 8)[count - 1]


@pytest.mark.parametrize(
    ("mechanism", "growth"),
    [
        (mechanism_in_catalogue("snakeboard"), (3, 4, 5)),
        (mechanism_in_catalogue("vertical-rolling-disk"), (2, 3, 4)),
        (mechanism_in_catalogue("roller-racer"), (2, 3, 4)),
    ],
    ids=lambda value: getattr(value, "name", ""),
)
def test_growth(mechanism, growth):
    found = nonholonomy(mechanism)
    assert (found.growth, found.verdict) == (growth, "completely nonholonomic")
    assert found.proven and not found.elsewhere


@pytest.mark.parametrize("angle", [0, FOLDED, sp.pi, sp.pi / 3, sp.Rational(1, 3)])
def test_the_snakeboard_grows_alike_everywhere(angle):
    board = mechanism_in_catalogue("snakeboard")
    assert nonholonomy_at(board, {real_symbol("phi"): angle}).growth == (3, 4, 5)


def test_no_dimensions_of_roller_racer_or_trailer_are_exceptional():
    racer = mechanism_in_catalogue("roller-racer")
    for mechanism, names in ((racer, ("d_1", "d_2")), (trailers.train(2), ("l_1", "l_2"))):
        for name in names:
            assert exceptional_values(mechanism, real_symbol(name)) == ()


def run(name, until=4.0, **changes):
    entry = CATALOGUE[name]
    system = entry.system().lifted()
    values = {**entry.start.state, **changes}
    start = [float(values.get(str(s), 0.0)) for s in system.symbols]
    motion = integrate(system, start, np.linspace(0.0, until, 4001))
    table = {str(s): motion.states[:, i] for i, s in enumerate(system.symbols)}
    return motion.times, table, entry.defaults


def rate(values, times):
    """Central differences of fourth order, inner points."""
    step = times[1] - times[0]
    return (values[:-4] - 8 * values[1:-3] + 8 * values[3:-1] - values[4:]) / (12 * step)


@pytest.mark.slow
def test_the_axles_of_the_trailers_do_not_slip_in_space():
    times, q, p = run("trailers")
    heading = q["theta"]
    place = q["x"] + 1j * q["y"]
    for i in (0, 1, 2):
        if i:
            heading = heading - q[f"phi_{i}"]
            place = place - p[f"l_{i}"] * np.exp(1j * heading)
        slip = (rate(place, times) * np.exp(-1j * heading[2:-2])).imag
        assert np.abs(slip).max() < 1e-9


def test_the_wheels_of_the_snakeboard_do_not_slip_in_space():
    times, q, p = run("snakeboard")
    place = q["x"] + 1j * q["y"]
    for sign in (1, -1):
        wheel = place + sign * p["l"] * np.exp(1j * q["theta"])
        heading = q["theta"] + sign * q["phi"]
        slip = (rate(wheel, times) * np.exp(-1j * heading[2:-2])).imag
        assert np.abs(slip).max() < 1e-9


def test_the_axles_of_the_roller_racer_do_not_slip_in_space():
    times, q, p = run("roller-racer")
    first = q["x"] + 1j * q["y"]
    heading = q["theta"] + q["phi"]
    second = first + p["d_1"] * np.exp(1j * q["theta"]) + p["d_2"] * np.exp(1j * heading)
    for place, angle in ((first, q["theta"]), (second, heading)):
        slip = (rate(place, times) * np.exp(-1j * angle[2:-2])).imag
        assert np.abs(slip).max() < 1e-9


def test_the_momentum_of_a_roller_racer_changes_by_the_wheels_alone():
    """Newton and Euler for the first body: forces across both axles, none along the first."""
    times, q, p = run("roller-racer")
    u = q["u"]
    D = p["d_1"] * np.cos(q["phi"]) + p["d_2"]
    turn = (u * np.sin(q["phi"]) - p["d_2"] * q["phidot"]) / D
    inner = slice(2, -2)
    # force F across the second axle: m u̇ = −F sin φ, and the torques about the pivot's body
    force = -p["m"] * rate(u, times) / np.sin(q["phi"][inner])
    swung = p["I_2"] * (rate(turn, times) + rate(q["phidot"], times))
    np.testing.assert_allclose(swung, p["d_2"] * force, atol=1e-7)
    total = p["I_1"] * rate(turn, times) + swung
    np.testing.assert_allclose(total, D[inner] * force, atol=1e-7)


def test_a_disk_on_a_slope_drifts_sideways_and_not_downhill():
    entry = CATALOGUE["vertical-rolling-disk"]
    turn = entry.start.state["w"]
    period = 2 * np.pi / turn
    _, q, p = run("vertical-rolling-disk", until=period)
    pull = p["m"] * p["g"] * p["R"] * np.sin(p["alpha"]) / (p["I"] + p["m"] * p["R"] ** 2)
    assert q["x"][-1] - q["x"][0] == pytest.approx(0.0, abs=1e-12)
    assert q["y"][-1] - q["y"][0] == pytest.approx(np.pi * p["R"] * pull / turn**2, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "changes", "complaint"),
    [
        ("trailers", {"l_1": 0.0}, "length of trailer 1 l_1 = 0.0: it must be a positive"),
        ("trailers", {"m": -1.0}, "mass"),
        ("snakeboard", {"J_0": 0.0}, "moment of inertia of the rotor J_0 = 0.0"),
        ("snakeboard", {"l": float("nan")}, "distance of each wheel pair"),
        ("roller-racer", {"d_2": -0.1}, "distance of the second axle"),
        ("vertical-rolling-disk", {"R": 0.0}, "radius R = 0.0"),
        ("vertical-rolling-disk", {"alpha": float("inf")}, "angle of the slope alpha = inf"),
    ],
)
def test_mistakes_in_parameters(name, changes, complaint):
    with pytest.raises(InputError, match=complaint):
        CATALOGUE[name].system(changes)

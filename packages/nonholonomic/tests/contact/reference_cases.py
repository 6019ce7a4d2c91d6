"""The motions of `reference_cases.json`, and the command that computes them anew.

Run with the directory `tests` on the Python path::

    python tests/contact/reference_cases.py            # every case
    python tests/contact/reference_cases.py egg        # the cases whose names contain "egg"

Every motion is computed twice, with different tolerances, different sizes at which small sliding
is treated apart, and Taylor series of different length and reach where sliding begins; motions
that are sensitive to rounding with nineteen digits and by another method (extrapolation). The first
is written down; `error` is the largest difference between the two, over all events and the final
state (absolute, in the units of each number, but relative for numbers above 1).
"""

from __future__ import annotations

import json
import math
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import contact.reference_motion as reference_motion
from contact.reference import placed, simulate
from contact.reference_bodies import rotation, transposed
from contact.reference_motion import Motion

FILE = Path(__file__).with_name("reference_cases.json")
RARE = Path(__file__).with_name("rare_cases.json")
"""Motions drawn at random in which something rare happens, without results."""

PLANE = {"kind": "plane"}


def tilted(angle: float, about: int = 1) -> list[float]:
    """Attitude turned by an angle about a space axis (0, 1, 2)."""
    q = [math.cos(angle / 2), 0.0, 0.0, 0.0]
    q[1 + about] = math.sin(angle / 2)
    return q


def upright(gamma: Sequence[float]) -> list[float]:
    """Attitude that carries a direction in the body to the vertical by the shortest turn."""
    return [1.0 + gamma[2], gamma[1], -gamma[0], 0.0]


def in_body(attitude: Sequence[float], omega: Sequence[float]) -> list[float]:
    """Body components of an angular velocity in space axes."""
    far = math.sqrt(sum(x * x for x in attitude))
    return [float(x) for x in transposed(rotation([x / far for x in attitude]), omega)]


def homogeneous_ball(mass: float, radius: float) -> dict[str, Any]:
    """Solid ball."""
    return {
        "mass": mass,
        "inertia": [0.4 * mass * radius**2] * 3,
        "shape": {"kind": "ball", "radius": radius},
    }


def homogeneous_ellipsoid(mass: float, axes: Sequence[float]) -> dict[str, Any]:
    """Solid ellipsoid."""
    a, b, c = (x * x for x in axes)
    inertia = [mass * s / 5.0 for s in (b + c, a + c, a + b)]
    return {"mass": mass, "inertia": inertia, "shape": {"kind": "ellipsoid", "axes": list(axes)}}


BALL = homogeneous_ball(1.0, 0.1)
LOADED = {
    "mass": 1.0,
    "inertia": [0.3, 0.35, 0.4],
    "shape": {"kind": "ball", "radius": 1.0, "centre": [0.1, 0.2, 0.3]},
}
PEBBLE = {
    "mass": 1.3,
    "inertia": [[0.2, 0.01, 0.02], [0.01, 0.3, -0.03], [0.02, -0.03, 0.4]],
    "gyrostat": [0.1, -0.2, 0.3],
    "shape": {
        "kind": "ellipsoid",
        "axes": [1.0, 0.8, 0.6],
        "turn": 0.3,
        "centre": [0.05, -0.1, 0.04],
    },
}
TIPPE_TOP = {
    "mass": 0.006,
    "inertia": [8e-7, 8e-7, 7e-7],
    "shape": {"kind": "ball", "radius": 0.015, "centre": [0.0, 0.0, 0.003]},
}
RATTLEBACK = {
    "mass": 1.0,
    "inertia": [[0.0002, -0.00002, 0.0], [-0.00002, 0.0016, 0.0], [0.0, 0.0, 0.0017]],
    "shape": {"kind": "ellipsoid", "axes": [0.2, 0.03, 0.02], "centre": [0.0, 0.0, 0.01]},
}
EGG = homogeneous_ellipsoid(0.06, [0.02, 0.02, 0.03])

SENSITIVE = ("tippe top", "tippe top, viscous in N", "tippe top, coupled law", "rising egg")
"""Motions that double the error of rounding many times over: computed in long double."""

DRAWN = (0, 2, 5, 6, 8, 10, 12, 15, 18, 19, 21, 23, 24)
"""Seeds of motions drawn at random, with several changes of mode or with rarer supports."""

ASKEW = [1.0, 0.2, 0.3, -0.4]


def drawn(seed: int) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any], dict[str, Any]]:
    """Body, support, law and start drawn at random."""
    g = np.random.default_rng(seed)
    moments = g.uniform(0.3, 1.0, 3)
    axes = np.linalg.qr(g.normal(size=(3, 3)))[0]
    inertia = 0.5 * moments.sum() * np.eye(3) - 0.6 * np.diag(moments)
    inertia = axes @ inertia @ axes.T * g.uniform(0.15, 0.5)
    shape: dict[str, Any]
    if g.random() < 0.5:
        shape = {"kind": "ball", "radius": 1.0, "centre": rounded(g.uniform(-0.35, 0.35, 3))}
    else:
        shape = {
            "kind": "ellipsoid",
            "axes": rounded(g.uniform(0.6, 1.2, 3)),
            "turn": rounded(g.uniform(-1.0, 1.0, 1))[0],
            "centre": rounded(g.uniform(-0.2, 0.2, 3)),
        }
    body = {
        "mass": rounded(g.uniform(0.5, 2.0, 1))[0],
        "inertia": [rounded(row, 4) for row in 0.5 * (inertia + inertia.T)],
        "gyrostat": rounded(g.uniform(-0.3, 0.3, 3) * (g.random() < 0.5)),
        "shape": shape,
    }
    which = int(g.integers(4))
    surface: dict[str, Any] = [
        {"kind": "plane"},
        {"kind": "plane", "turntable": rounded(g.uniform(-2.0, 2.0, 1))[0]},
        {"kind": "sphere", "radius": 4.0, "side": "outside"},
        {"kind": "sphere", "radius": 4.0, "side": "inside"},
    ][which]
    mu = rounded(g.uniform(0.1, 0.6, 1))[0]
    contact: dict[str, Any] = [
        {"mu": mu},
        {"mu": mu, "spin_arm": rounded(g.uniform(0.02, 0.1, 1))[0]},
        {"mu": mu, "patch": rounded(g.uniform(0.1, 0.3, 1))[0]},
        {"mu": mu, "rolling_viscous": 0.02, "viscous": 0.1},
    ][int(g.integers(4))]
    at = [*rounded(g.uniform(-0.5, 0.5, 2)), -1.0 if which == 3 else 1.0]
    attitude = rounded(g.normal(size=4))
    omega = rounded(g.uniform(-3.0, 3.0, 3))
    slip = [*rounded(g.uniform(-0.6, 0.6, 2)), 0.0]
    return body, surface, contact, placed(body, surface, attitude, omega, slip, at)


def loaded_ball(seed: int) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any], dict[str, Any]]:
    """Ball with a far centre of mass on the plane, drawn at random, that slides slowly."""
    g = np.random.default_rng(seed)
    body = {
        "mass": 1.0,
        "inertia": rounded(0.15 + g.uniform(0.1, 0.2, 3), 2),
        "shape": {"kind": "ball", "radius": 1.0, "centre": rounded(g.uniform(-0.5, 0.5, 3), 2)},
    }
    mu = rounded(g.uniform(0.15, 0.6, 1), 2)[0]
    contact = {"mu": mu} if seed % 3 else {"mu": mu, "patch": 0.2}
    attitude = rounded(g.normal(size=4), 2)
    omega = rounded(g.uniform(-4.0, 4.0, 3), 2)
    slip = [*rounded(g.uniform(-0.3, 0.3, 2), 2), 0.0]
    return body, PLANE, contact, placed(body, PLANE, attitude, omega, slip)


def rounded(values: Any, digits: int = 3) -> list[float]:
    """Numbers with few digits."""
    return [round(float(x), digits) for x in values]


def case(
    name: str,
    body: dict[str, Any],
    surface: dict[str, Any],
    contact: dict[str, Any],
    start: dict[str, Any],
    until: float,
) -> dict[str, Any]:
    """One motion, without its results."""
    return {
        "name": name,
        "body": body,
        "surface": surface,
        "contact": contact,
        "gravity": 9.81,
        "start": start,
        "until": until,
    }


def cases() -> list[dict[str, Any]]:
    """Every motion of the table."""
    spinning = placed(BALL, PLANE, ASKEW, [3.0, -2.0, 5.0], [0.7, 0.2, 0.0])
    straight = placed(BALL, PLANE, tilted(0.0), [0.0, 12.0, 0.0])
    loaded = placed(LOADED, PLANE, ASKEW, [3.0, -2.0, 5.0], [0.7, 0.2, 0.0])
    gentle = placed(LOADED, PLANE, ASKEW, [1.0, -1.5, 0.8], [0.4, -0.3, 0.0])
    pebble = placed(PEBBLE, PLANE, ASKEW, [1.0, -2.0, 1.0], [0.7, 0.2, 0.0])
    thrown = placed(PEBBLE, PLANE, ASKEW, [3.0, -2.0, 5.0], [0.7, 0.2, 0.0], height=0.5)
    table = {"kind": "plane", "turntable": 2.0}
    hill = {"kind": "sphere", "radius": 3.0, "side": "outside"}
    bowl = {"kind": "sphere", "radius": 4.0, "side": "inside"}
    bouncing = {"mu": 0.3, "restitution": 0.5}
    fast, across = [2.0, -1.0, 3.0], [0.7, 0.4, 0.0]
    thrown_on_table = placed(PEBBLE, table, ASKEW, fast, across, [0.3, 0.2, 0.0], 0.3)
    thrown_on_hill = placed(PEBBLE, hill, ASKEW, fast, across, [0.1, 0.2, 1.0], 0.3)
    thrown_in_bowl = placed(PEBBLE, bowl, ASKEW, fast, across, [0.1, 0.4, -1.0], 0.3)
    dropped = placed(LOADED, PLANE, ASKEW, [1.0, -1.5, 0.8], [0.4, -0.3, 0.0], height=0.1)
    wide = {"mu": 0.3, "patch": 0.25}
    lean = tilted(0.1)
    top = placed(TIPPE_TOP, PLANE, lean, in_body(lean, [0.0, 0.0, 180.0]))
    top["velocity"] = [0.0, 0.0, top["velocity"][2]]
    dome = {"kind": "sphere", "radius": 1.0, "side": "outside"}
    beside_top = [math.sin(0.1), 0.0, math.cos(0.1)]
    fall = math.sqrt(10.0 / 7.0 * 9.81 * 1.1 * (1.0 - math.cos(0.1)))  # from rest at the top
    on_dome = placed(BALL, dome, tilted(0.0), [0.0, fall / 0.1, 0.0], at=beside_top)
    ball_in_bowl = placed(BALL, bowl, ASKEW, [5.0, -3.0, 8.0], [1.0, 1.5, 0.3], [0.5, 0.2, -1.0])
    pebble_in_bowl = placed(
        PEBBLE, bowl, ASKEW, [1.0, -2.0, 1.0], [0.7, 0.2, 0.0], [0.2, 0.1, -1.0]
    )
    pebble_on_hill = placed(
        PEBBLE, hill, ASKEW, [0.5, -0.7, 1.0], [0.3, 0.2, 0.0], [0.1, 0.05, 1.0]
    )
    loaded_on_hill = placed(
        LOADED, hill, ASKEW, [0.5, -0.7, 2.0], [0.3, 0.2, 0.0], [0.1, 0.05, 1.0]
    )
    lying = tilted(math.pi / 2 - 0.05)
    egg = placed(EGG, PLANE, lying, in_body(lying, [0.0, 0.0, 150.0]))
    tip = math.pi / 360
    upward = [-math.cos(tip) * math.sin(tip), math.sin(tip), math.cos(tip) ** 2]
    rocking = placed(RATTLEBACK, PLANE, upright(upward), [0.0, 0.0, -5.0])
    patch = {"mu": 0.3, "patch": 0.05}
    return [
        case("billiard ball", BALL, PLANE, {"mu": 0.2}, spinning, 0.5),
        case("ball under the coupled law", BALL, PLANE, {"mu": 0.2, "patch": 0.06}, spinning, 0.5),
        case("ball on a small patch", BALL, PLANE, {"mu": 0.2, "patch": 0.01}, spinning, 0.5),
        case("ball with a spin couple", BALL, PLANE, {"mu": 0.2, "spin_arm": 0.01}, spinning, 1.0),
        case(
            "ball with rolling resistance",
            BALL,
            PLANE,
            {"mu": 0.2, "rolling": 0.002},
            straight,
            10.0,
        ),
        case("loaded ball", LOADED, PLANE, {"mu": 0.3}, loaded, 3.0),
        case("loaded ball, spin couple", LOADED, PLANE, {"mu": 0.3, "spin_arm": 0.05}, loaded, 3.0),
        case("loaded ball, coupled law", LOADED, PLANE, patch, loaded, 3.0),
        case(
            "loaded ball, viscous",
            LOADED,
            PLANE,
            {"viscous": 2.0, "spin_viscous": 0.1},
            loaded,
            2.0,
        ),
        case("loaded ball, viscous in N", LOADED, PLANE, {"slip": 0.4}, loaded, 2.0),
        case(
            "loaded ball, Coulomb and viscous",
            LOADED,
            PLANE,
            {"mu": 0.2, "viscous": 0.5},
            gentle,
            2.0,
        ),
        case(
            "loaded ball, rolling viscous",
            LOADED,
            PLANE,
            {"mu": 0.4, "rolling_viscous": 0.03},
            gentle,
            2.0,
        ),
        case(
            "loaded ball, rolling resistance",
            LOADED,
            PLANE,
            {"mu": 0.4, "rolling": 0.03},
            gentle,
            2.0,
        ),
        case("loaded ball, contour", LOADED, PLANE, {"mu": 0.4, "contour": 0.03}, gentle, 2.0),
        case("pebble", PEBBLE, PLANE, {"mu": 0.4}, pebble, 2.0),
        case("pebble, coupled law", PEBBLE, PLANE, {"mu": 0.4, "patch": 0.1}, pebble, 2.0),
        case(
            "pebble, spin couple and contour",
            PEBBLE,
            PLANE,
            {"mu": 0.4, "spin_arm": 0.03, "contour": 0.02},
            pebble,
            2.0,
        ),
        case("ball on a turntable", BALL, table, {"mu": 0.2}, spinning, 2.0),
        case("pebble on a turntable", PEBBLE, table, {"mu": 0.4}, pebble, 1.2),
        case(
            "pebble on a turntable, coupled law",
            PEBBLE,
            table,
            {"mu": 0.4, "patch": 0.1},
            pebble,
            1.2,
        ),
        case("ball leaves a dome", BALL, dome, {"mu": 0.4}, on_dome, 2.0),
        case("ball leaves a smoother dome", BALL, dome, {"mu": 0.1}, on_dome, 2.0),
        case("ball in a bowl", BALL, bowl, {"mu": 0.15}, ball_in_bowl, 2.0),
        case("pebble in a bowl", PEBBLE, bowl, {"mu": 0.4, "spin_arm": 0.05}, pebble_in_bowl, 1.2),
        case(
            "pebble in a bowl, coupled law",
            PEBBLE,
            bowl,
            {"mu": 0.4, "patch": 0.1},
            pebble_in_bowl,
            1.2,
        ),
        case("pebble on a hill", PEBBLE, hill, {"mu": 0.4}, pebble_on_hill, 1.2),
        case(
            "loaded ball on a hill, viscous in N", LOADED, hill, {"slip": 0.5}, loaded_on_hill, 1.0
        ),
        case("loaded ball on a hill, coupled law", LOADED, hill, patch, loaded_on_hill, 1.2),
        case("bouncing pebble", PEBBLE, PLANE, {"mu": 0.3, "restitution": 0.6}, thrown, 1.2),
        case(
            "bouncing pebble, Poisson",
            PEBBLE,
            PLANE,
            {"mu": 0.3, "restitution": 0.6, "impact_law": "poisson"},
            thrown,
            1.2,
        ),
        case(
            "bouncing pebble, Newton",
            PEBBLE,
            PLANE,
            {"mu": 0.3, "restitution": 0.6, "impact_law": "newton"},
            thrown,
            1.2,
        ),
        case("pebble lands without bouncing", PEBBLE, PLANE, {"mu": 0.3}, thrown, 1.2),
        case(
            "pebble lands on a turntable",
            PEBBLE,
            table,
            {"mu": 0.3, "spin_arm": 0.05, "restitution": 0.4},
            thrown_on_table,
            0.429,
        ),
        case("pebble lands on a hill", PEBBLE, hill, bouncing, thrown_on_hill, 0.72),
        case("pebble lands in a bowl", PEBBLE, bowl, bouncing, thrown_in_bowl, 0.7),
        case("loaded ball lands, coupled law", LOADED, PLANE, wide, dropped, 0.6),
        case("tippe top", TIPPE_TOP, PLANE, {"mu": 0.3}, top, 1.15),
        case("tippe top, viscous in N", TIPPE_TOP, PLANE, {"slip": 0.3}, top, 1.0),
        case("tippe top, coupled law", TIPPE_TOP, PLANE, {"mu": 0.3, "patch": 0.0005}, top, 1.0),
        case("rising egg", EGG, PLANE, {"mu": 0.1}, egg, 1.03),
        case("rattleback", RATTLEBACK, PLANE, {"mu": 0.3}, rocking, 0.5),
        *(case(f"direct restart {seed}", *loaded_ball(seed), 0.6) for seed in (12, 115, 144)),
        *(case(f"drawn {seed}", *drawn(seed), 2.0) for seed in DRAWN),
        *json.loads(RARE.read_text()),
    ]


def with_results(data: dict[str, Any]) -> dict[str, Any]:
    """The case with its events, its final state and the error of both."""
    results = []
    sensitive = data["name"] in SENSITIVE
    number = np.longdouble if sensitive else float
    finer = 1e-3 if sensitive else 1.0
    for rtol, small, terms, reach in ((3e-14, 0.01, 18, 1.0), (1e-13, 0.03, 15, 0.5)):
        reference_motion.SMALL, reference_motion.TERMS, Motion.reach_factor = small, terms, reach
        results.append(
            simulate(
                data["body"],
                data["surface"],
                data["contact"],
                data["start"],
                data["until"],
                data["gravity"],
                rtol * finer,
                number,
            )
        )
    (events, final), (others, other_final) = results
    if [e["kind"] for e in events] != [e["kind"] for e in others]:
        raise ArithmeticError(f"{data['name']}: the two computations have different events")
    error = max(
        difference(a, b) for a, b in zip([*events, final], [*others, other_final], strict=True)
    )
    for event in events:
        del event["before"]
    return {**data, "events": events, "final": final, "error": float(f"{error:.1e}")}


def difference(one: dict[str, Any], other: dict[str, Any]) -> float:
    """Largest difference of two states with their times."""
    largest = 0.0
    for key, value in one.items():
        if key in ("kind", "before"):
            continue
        pairs = zip(value, other[key], strict=True) if key != "time" else [(value, other[key])]
        for a, b in pairs:
            largest = max(largest, abs(a - b) / max(1.0, abs(a)))
    return largest


def main(words: Sequence[str]) -> None:
    """Compute the cases whose names contain one of the words, or all, and write the file."""
    known = {c["name"]: c for c in json.loads(FILE.read_text())} if FILE.exists() else {}
    everything = cases()
    for data in everything:
        if words and not any(word in data["name"] for word in words):
            continue
        begun = time.perf_counter()
        try:
            known[data["name"]] = with_results(data)
        except (ArithmeticError, ValueError) as problem:
            print(f"{data['name']}: {problem}", flush=True)
            continue
        done = known[data["name"]]
        changes = ", ".join(f"{e['kind']} {e['time']:.6g}" for e in done["events"])
        seconds = time.perf_counter() - begun
        print(f"{data['name']}: {changes} (error {done['error']}, {seconds:.1f} s)", flush=True)
        order = [known[c["name"]] for c in everything if c["name"] in known]
        FILE.write_text(json.dumps(order, indent=1) + "\n")


if __name__ == "__main__":
    main(sys.argv[1:])

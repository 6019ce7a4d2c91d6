"""Time to derive the equations of a rolling body, compared with Kane's method in SymPy.

Both derive the unbalanced ball and the ellipsoid on a plane without slipping; the results are
seconds and the numbers of arithmetic operations in the equations.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Callable

import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

import chaplygin

TURNS = 3


def own(shape: chaplygin.Ball | chaplygin.Ellipsoid) -> int:
    body = chaplygin.Body(1.0, (1.0, 1.5, 2.1), shape)
    system = chaplygin.rolling_system(body, field=chaplygin.Forces(9.81))
    steps = system.required_definitions(system.rates)
    return int(sum(sp.count_ops(e) for e in (*system.rates, *(value for _, value in steps))))


def kane(ellipsoid: bool) -> int:
    """Operations by Kane's method, with Euler angles and body-fixed generalized speeds."""
    q = dynamicsymbols("q1:4")
    u = dynamicsymbols("u1:4")
    m, g, R = sp.symbols("m g R", positive=True)
    moments, c = sp.symbols("I1:4", positive=True), sp.symbols("c1:4", real=True)
    space, body = ReferenceFrame("N"), ReferenceFrame("B")
    body.orient_body_fixed(space, q, "313")
    rate = body.ang_vel_in(space)
    spin = u[0] * body.x + u[1] * body.y + u[2] * body.z
    kinematics = [(rate - spin).dot(axis) for axis in body]
    body.set_ang_vel(space, spin)
    up = space.z.express(body)
    if ellipsoid:
        b = sp.symbols("b1:4", positive=True)
        parts = [s**2 * up.dot(axis) for s, axis in zip(b, body, strict=True)]
        length = sp.sqrt(sum(s**2 * up.dot(axis) ** 2 for s, axis in zip(b, body, strict=True)))
        reach = sum((-p / length * axis for p, axis in zip(parts, body, strict=True)), 0 * body.x)
    else:
        reach = -R * up
    r = sum((x * axis for x, axis in zip(c, body, strict=True)), reach)
    centre = Point("C")
    centre.set_vel(space, r.cross(spin))
    part = RigidBody("body", centre, body, m, (inertia(body, *moments), centre))
    method = KanesMethod(space, q_ind=q, u_ind=u, kd_eqs=kinematics)
    method.kanes_equations([part], [(centre, -m * g * space.z)])
    return int(sp.count_ops(method.mass_matrix_full) + sp.count_ops(method.forcing_full))


def timed(job: Callable[[], int]) -> tuple[float, int]:
    began = time.perf_counter()
    operations = job()
    return time.perf_counter() - began, operations


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    pairs = {
        "unbalanced ball": (
            lambda: own(chaplygin.Ball(1.0, centre=(0.1, 0.2, 0.3))),
            lambda: kane(ellipsoid=False),
        ),
        "ellipsoid": (
            lambda: own(chaplygin.Ellipsoid((1.0, 0.8, 0.6), centre=(0.1, 0.2, 0.3))),
            lambda: kane(ellipsoid=True),
        ),
    }
    rows = []
    for name, (ours, theirs) in pairs.items():
        times: tuple[list[float], list[float]] = ([], [])
        counts = [0, 0]
        for _ in range(TURNS):
            for i, job in enumerate((ours, theirs)):
                sp.core.cache.clear_cache()
                seconds, counts[i] = timed(job)
                times[i].append(seconds)
        medians = [statistics.median(t) for t in times]
        rows.append(
            {
                "body": name,
                "seconds": medians[0],
                "seconds_kane": medians[1],
                "time_ratio": medians[1] / medians[0],
                "operations": counts[0],
                "operations_kane": counts[1],
                "operations_ratio": counts[1] / counts[0],
            }
        )
    if options.json:
        print(json.dumps(rows, indent=2))
        return
    print(f"{'body':16} {'chaplygin':>18} {'Kane (SymPy)':>20} {'ratio: time':>12} {'ops':>6}")
    for row in rows:
        ours = f"{row['seconds']:.3f} s {row['operations']:6d} ops"
        theirs = f"{row['seconds_kane']:.2f} s {row['operations_kane']:7d} ops"
        print(
            f"{row['body']:16} {ours:>18} {theirs:>20} {row['time_ratio']:12.1f} "
            f"{row['operations_ratio']:6.1f}"
        )


if __name__ == "__main__":
    main()

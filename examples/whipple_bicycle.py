"""The Whipple bicycle: four rigid bodies on two wheels that roll without slipping.

The benchmark of Meijaard, Papadopoulos, Ruina and Schwab (Proc. R. Soc. A 463, 2007, 1955–1982).
The nonlinear model is derived from its Lagrangian and constraints, linearised about straight
upright running, and its eigenvalues are compared with those of the linear equations that the
authors derived by hand.  A run of the nonlinear equations shows the bicycle righting itself.

    python examples/whipple_bicycle.py                 a table, and figures beside it
    python examples/whipple_bicycle.py --json          eigenvalues at 0, 1, …, 10 m/s
    chaplygin study examples/whipple_bicycle.py        the run below, as a report

Axes are fixed in the rear frame: e₃ along the steering axis (downward), e₂ along the rear axle (to
the right), e₁ forward.  The fork's axes are these, turned about e₃ by the steering angle δ.  The
upward vertical is γ in the axes of the frame and γ_F in those of the fork.  The place (x, y) of the
rear hub and the heading, by a horizontal direction α in the axes of the frame, matter to nothing:
the equations do without them, and they are found afterwards.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import mpmath
import numpy as np
import sympy as sp
from scipy.optimize import brentq
from whipple_by_hand import by_hand
from whipple_figures import eigenvalue_figure, run_figure

from chaplygin import (
    Frame,
    Mechanism,
    Parameter,
    System,
    Trajectory,
    equations_of_motion,
    integrate,
    linear_stability,
)
from chaplygin.report.drawing.style import STYLE
from flowlanes.flow import Linearisation
from flowlanes.system import (
    Guard,
    Observable,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    unit_vector,
)
from flowlanes.system.vectors import vectors
from nonholonomic.mechanics.lagrangian import Plan, euclidean

DIGITS = 20

# --- the machine -------------------------------------------------------------------------------
# lengths in m, masses in kg, moments of inertia in kg m²; x forward, y right, z down, upright
PARAMETERS: Mapping[str, tuple[str, str, str]] = {
    "w": ("1.02", "wheel base", "m"),
    "c": ("0.08", "trail", "m"),
    "lambda": ("pi/10", "tilt of the steering axis", ""),
    "g": ("9.81", "gravity", "m/s**2"),
    "R_R": ("0.3", "radius of the rear wheel", "m"),
    "m_R": ("2", "mass of the rear wheel", "kg"),
    "I_Rxx": ("0.0603", "moment of inertia of the rear wheel about a diameter", "kg*m**2"),
    "I_Ryy": ("0.12", "moment of inertia of the rear wheel about its axle", "kg*m**2"),
    "x_B": ("0.3", "centre of mass of frame and rider, forward of the rear contact", "m"),
    "z_B": ("-0.9", "centre of mass of frame and rider, below the ground", "m"),
    "m_B": ("85", "mass of frame and rider", "kg"),
    "I_Bxx": ("9.2", "moment of inertia of frame and rider", "kg*m**2"),
    "I_Byy": ("11", "moment of inertia of frame and rider", "kg*m**2"),
    "I_Bzz": ("2.8", "moment of inertia of frame and rider", "kg*m**2"),
    "I_Bxz": ("2.4", "entry xz of the inertia tensor of frame and rider", "kg*m**2"),
    "x_H": ("0.9", "centre of mass of fork and handlebar, forward of the rear contact", "m"),
    "z_H": ("-0.7", "centre of mass of fork and handlebar, below the ground", "m"),
    "m_H": ("4", "mass of fork and handlebar", "kg"),
    "I_Hxx": ("0.05892", "moment of inertia of fork and handlebar", "kg*m**2"),
    "I_Hyy": ("0.06", "moment of inertia of fork and handlebar", "kg*m**2"),
    "I_Hzz": ("0.00708", "moment of inertia of fork and handlebar", "kg*m**2"),
    "I_Hxz": ("-0.00756", "entry xz of the inertia tensor of fork and handlebar", "kg*m**2"),
    "R_F": ("0.35", "radius of the front wheel", "m"),
    "m_F": ("3", "mass of the front wheel", "kg"),
    "I_Fxx": ("0.1405", "moment of inertia of the front wheel about a diameter", "kg*m**2"),
    "I_Fyy": ("0.28", "moment of inertia of the front wheel about its axle", "kg*m**2"),
}
P = {name: real_symbol(name) for name in PARAMETERS}
VALUES = {name: sp.sympify(text, rational=True) for name, (text, _, _) in PARAMETERS.items()}

alpha, gamma, gamma_f, omega, omega_f, v, v_b, v_s, v_h, v_f, r_r, r_f, d_b, d_h, d_f = vectors(
    "alpha gamma gamma_F omega omega_F v v_B v_S v_H v_F r_R r_F d_B d_H d_F"
)
x, y, delta, deltadot, spin_r, spin_f = (
    real_symbol(name) for name in ("x", "y", "delta", "deltadot", "Omega_R", "Omega_F")
)
ell, s_r, s_f = (real_symbol(name) for name in ("ell", "s_R", "s_F"))
cl, sl, cd, sd = (real_symbol(name) for name in ("c_l", "s_l", "c_d", "s_d"))
inertia_b, inertia_h = (
    [real_symbol(f"I_{body}{axis}") for axis in ("1", "3", "13")] for body in "BH"
)
e_1, e_2, e_3 = (unit_vector(axis) for axis in (1, 2, 3))


def tilted(x: sp.Expr, z: sp.Expr) -> Any:
    """A vector of the plane of symmetry, given forward and downward, in the axes of the frame."""
    return constant([x * cl - z * sl, 0, x * sl + z * cl])


def turned(u: Any) -> Any:
    """A vector given in the axes of the frame, in those of the fork."""
    u_1, u_2, u_3 = u.symbols
    return constant([cd * u_1 + sd * u_2, cd * u_2 - sd * u_1, u_3])


def tilted_inertia(body: str) -> tuple[sp.Expr, ...]:
    """Entries 11, 33 and 13 of an inertia tensor in the axes of the frame."""
    xx, zz, xz = (P[f"I_{body}{axis}"] for axis in ("xx", "zz", "xz"))
    return (
        xx * cl**2 - 2 * xz * cl * sl + zz * sl**2,
        xx * sl**2 + 2 * xz * cl * sl + zz * cl**2,
        (xx - zz) * cl * sl + xz * (cl**2 - sl**2),
    )


def spinning(u: Any, I_1: sp.Expr, I_2: sp.Expr, I_3: sp.Expr, I_13: sp.Expr) -> sp.Expr:
    """½ (u, I u) for a body symmetric about the plane of e₁ and e₃."""
    u_1, u_2, u_3 = u.symbols
    return (I_1 * u_1**2 + I_2 * u_2**2 + I_3 * u_3**2) / 2 + I_13 * u_1 * u_3


def rolling(radius: sp.Expr, up: Any, s: sp.Symbol) -> Any:
    """From the hub of a wheel with axle e₂ to its lowest point."""
    up_1, _, up_3 = up.symbols
    return constant([-radius * up_1 / s, 0, -radius * up_3 / s])


@cache
def bicycle() -> Mechanism:
    """The bicycle as a mechanism: Lagrangian, two wheels that roll, two that touch the ground."""
    w, c, g, R_R, R_F = (P[name] for name in ("w", "c", "g", "R_R", "R_F"))
    m_R, m_B, m_H, m_F = (P[f"m_{body}"] for body in "RBHF")
    g_1, _, g_3 = gamma.symbols
    f_1, _, f_3 = gamma_f.symbols
    definitions = {
        cl: sp.cos(P["lambda"]),
        sl: sp.sin(P["lambda"]),
        # the foot of the rear hub on the steering axis lies at ell e₁
        ell: (w + c) * cl - R_R * sl,
        d_b: tilted(P["x_B"], P["z_B"] + R_R),
        d_h: tilted(P["x_H"], P["z_H"] + R_R) - ell * e_1,
        d_f: tilted(w, R_R - R_F) - ell * e_1,
        **dict(zip(inertia_b, tilted_inertia("B"), strict=True)),
        **dict(zip(inertia_h, tilted_inertia("H"), strict=True)),
        cd: sp.cos(delta),
        sd: sp.sin(delta),
        gamma_f: turned(gamma),
        s_r: sp.sqrt(g_1**2 + g_3**2),
        s_f: sp.sqrt(f_1**2 + f_3**2),
        r_r: rolling(R_R, gamma, s_r),
        r_f: rolling(R_F, gamma_f, s_f),
        omega_f: turned(omega) + deltadot * e_3,
        v_b: v + cross(omega, d_b),
        v_s: v + cross(omega, ell * e_1),
        v_h: turned(v_s) + cross(omega_f, d_h),
        v_f: turned(v_s) + cross(omega_f, d_f),
    }
    w_1, w_2, w_3 = omega.symbols
    f1, f2, f3 = omega_f.symbols
    kinetic = (
        m_R * norm_squared(v) / 2
        + m_B * norm_squared(v_b) / 2
        + m_H * norm_squared(v_h) / 2
        + m_F * norm_squared(v_f) / 2
        + spinning(omega, inertia_b[0], P["I_Byy"], inertia_b[1], inertia_b[2])
        + spinning(omega_f, inertia_h[0], P["I_Hyy"], inertia_h[1], inertia_h[2])
        + (P["I_Rxx"] * (w_1**2 + w_3**2) + P["I_Ryy"] * (w_2 + spin_r) ** 2) / 2
        + (P["I_Fxx"] * (f1**2 + f3**2) + P["I_Fyy"] * (f2 + spin_f) ** 2) / 2
    )
    # heights above the rear contact, which is R_R s_r below the hub
    height_S = ell * g_1
    potential = g * (
        (m_R + m_B + m_H + m_F) * R_R * s_r
        + m_B * dot(gamma, d_b)
        + m_H * (height_S + dot(gamma_f, d_h))
        + m_F * (height_S + dot(gamma_f, d_f))
    )
    rear_slip = v + cross(omega + spin_r * e_2, r_r)
    front_slip = v_f + cross(omega_f, r_f)
    forward = constant([-f_3 / s_f, 0, f_1 / s_f])
    return Mechanism(
        name="whipple-bicycle",
        title="Whipple bicycle",
        summary="A bicycle with a rigid rider rolls on a horizontal plane without slipping.",
        source="Meijaard, Papadopoulos, Ruina, Schwab 2007",
        frame=Frame(
            rates={
                gamma: cross(gamma, omega),
                delta: deltadot,
                alpha: cross(alpha, omega),
                x: dot(alpha, v),
                y: dot(cross(gamma, alpha), v),
            },
            velocities=(omega, v, deltadot, spin_r, spin_f),
            relations=(norm_squared(gamma) - 1, norm_squared(alpha) - 1, dot(alpha, gamma)),
            structure=euclidean(omega, v),
        ),
        lagrangian=kinetic - potential,
        constraints=(
            rear_slip,
            # at the front along the wheel and along its axle; its height is a constraint on places
            spin_f + dot(forward, front_slip) / R_F,
            dot(e_2, front_slip),
        ),
        positions=(R_R * s_r + height_S + dot(gamma_f, d_f) - R_F * s_f,),
        definitions=definitions,
        parameters=tuple(
            Parameter(P[name], meaning, float(VALUES[name]), unit)
            for name, (_, meaning, unit) in PARAMETERS.items()
        ),
        observables=(
            Observable("lean", -sp.asin(gamma.symbols[1]), "lean of the rear frame", "rad"),
            Observable("speed", -R_R * spin_r, "speed of the rear wheel", "m/s"),
        ),
        guards=(
            Guard("rear_upright", s_r - sp.Rational(1, 1000), "the rear wheel lies flat"),
            Guard("front_upright", s_f - sp.Rational(1, 1000), "the front wheel lies flat"),
        ),
    )


def below(u: Any) -> tuple[sp.Expr, sp.Expr]:
    """Horizontal components, along x and y, of a vector given in the axes of the frame."""
    return to_components(dot(alpha, u)), to_components(dot(cross(gamma, alpha), u))


def drawn() -> Plan:
    """The wheels where they touch the ground, and the line between them."""
    g_1, _, g_3 = gamma.symbols
    f_1, _, f_3 = gamma_f.symbols
    hub, low = (to_components(u) for u in (d_f, r_f))
    reach = [a + b for a, b in zip(hub, low, strict=True)]
    ahead = constant([ell + cd * reach[0] - sd * reach[1], sd * reach[0] + cd * reach[1], reach[2]])
    rear, front = below(r_r), below(ahead)
    rear, front = ((x + u, y + v) for u, v in (rear, front))
    along = below(constant([-g_3, 0, g_1]))
    steered = below(constant([-cd * f_3, -sd * f_3, f_1]))
    headings = [sp.atan2(v, u) for u, v in (along, steered)]
    return Plan(
        rear, links=((*rear, *front),), wheels=((*rear, headings[0]), (*front, headings[1]))
    )


@cache
def model() -> System:
    """The closed equations of motion."""
    return equations_of_motion(bicycle())


# --- straight upright running ------------------------------------------------------------------


def upright(speed: Any) -> dict[str, Any]:
    """The state of straight upright running at a speed (m/s)."""
    tilt = VALUES["lambda"]
    still = dict.fromkeys(("gamma_2", "delta", "omega_1", "omega_2", "omega_3", "deltadot"), 0)
    spin = -sp.sympify(str(speed), rational=True) / VALUES["R_R"]
    return {**still, "gamma_1": sp.sin(tilt), "gamma_3": -sp.cos(tilt), "Omega_R": spin}


def linearisation_near(speed: Any, digits: int = DIGITS) -> Linearisation:
    """The linear equations at a speed, faster and slower running divided out."""
    family = [{"Omega_R": 1}]
    return linear_stability(model(), upright(speed), VALUES, along=family, digits=digits)


def difference(speed: Any) -> float:
    """Largest distance between an eigenvalue found here and the nearest one by hand."""
    with mpmath.workdps(DIGITS + 10):
        machine = {name: mpmath.mpmathify(sp.N(x, DIGITS + 10)) for name, x in VALUES.items()}
        others = by_hand(machine, speed)
        return float(
            max(min(abs(a - b) for b in others) for a in linearisation_near(speed).eigenvalues)
        )


def weaving(speed: float) -> float:
    """Growth rate of the weave: the largest real part of an oscillation."""
    values = linearisation_near(speed, 14).eigenvalues
    return float(max(value.real for value in values if value.imag > 0))


def capsizing(speed: float) -> float:
    """Growth rate of the capsize: the largest real eigenvalue."""
    values = linearisation_near(speed, 14).eigenvalues
    return float(max(value.real for value in values if value.imag == 0))


def critical_speeds() -> tuple[float, float]:
    """The speeds (m/s) at which the weave becomes stable and the capsize unstable."""
    return (
        float(brentq(weaving, 4.0, 5.0, xtol=1e-14)),
        float(brentq(capsizing, 5.0, 7.0, xtol=1e-14)),
    )


# --- a nonlinear run ---------------------------------------------------------------------------


#: What the command line takes: running straight at 4.6 m/s, hit from the side.
mechanism = bicycle()
plan = drawn()
FORWARD = np.array([np.cos(np.pi / 10), 0.0, np.sin(np.pi / 10)])
start = {
    "gamma": [float(FORWARD[2]), 0.0, -float(FORWARD[0])],
    "alpha": FORWARD.tolist(),
    "omega": (0.5 * FORWARD).tolist(),
    "delta": 0.0,
    "deltadot": 0.0,
    "Omega_R": -4.6 / 0.3,
}
run = {"until": 5.0, "samples": 501}


def pushed_motion(seconds: float = 5.0) -> Trajectory:
    """The same from here; nobody steers."""
    flat = {f"{name}_{i}": x for name in ("gamma", "alpha", "omega") for i, x in vector(name)}
    state = [{**start, **flat}.get(str(symbol), 0.0) for symbol in model().lifted().symbols]
    return integrate(model(), state, np.linspace(0.0, seconds, 501))


def vector(name: str) -> list[tuple[int, float]]:
    """Components of a vector of the start, numbered."""
    return list(enumerate(start[name], 1))


# --- in words ----------------------------------------------------------------------------------


def report(folder: Path) -> None:
    """Everything in words, and two figures."""
    print("Eigenvalues (1/s) of the Whipple bicycle, straight and upright\n")
    print(f"{'m/s':>4}  {'eigenvalues':58}  {'from those by hand':>18}")
    for speed in range(11):
        shown = [
            shown_number(value)
            for value in linearisation_near(speed).eigenvalues
            if value.imag >= 0
        ]
        print(f"{speed:4d}  {shown[0]:58}  {difference(speed):18.1e}")
        for line in shown[1:]:
            print(f"      {line}")
    weave, capsize = critical_speeds()
    print(f"\nThe weave dies out above {weave:.12f} m/s,")
    print(f"the capsize grows above {capsize:.12f} m/s: between the two the bicycle rights itself.")
    run = pushed_motion()
    energy = run.records["law_energy"]
    lean = np.degrees(run.records["lean"])
    print(
        f"\nHit from the side at 4.6 m/s it leans by {max(abs(lean)):.1f}° and after "
        f"{float(run.times[-1]):g} s by {abs(lean[-1]):.2f}°; its speed has become "
        f"{run.records['speed'][-1]:.4f} m/s, its energy has changed by "
        f"{max(abs(energy / energy[0] - 1)):.0e} of its value."
    )
    speeds = np.linspace(0.0, 10.0, 201)
    values = [linearisation_near(speed, 8).eigenvalues for speed in speeds]
    with plt.rc_context(STYLE):
        figures = {
            "whipple_eigenvalues.png": eigenvalue_figure(speeds, values, (weave, capsize)),
            "whipple_run.png": run_figure(run),
        }
        folder.mkdir(parents=True, exist_ok=True)
        for name, figure in figures.items():
            figure.savefig(folder / name, dpi=160)
            print(f"wrote {folder / name}")


def shown_number(value: Any) -> str:
    """An eigenvalue with fifteen digits; one of a conjugate pair stands for both."""
    real = mpmath.nstr(value.real, 15, strip_zeros=False)
    return f"{real} ± {mpmath.nstr(value.imag, 15)}i" if value.imag else real


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", action="store_true", help="eigenvalues at 0, 1, …, 10 m/s")
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figures")
    options = parser.parse_args()
    if options.json:
        pairs = {
            str(speed): [
                [float(x.real), float(x.imag)] for x in linearisation_near(speed).eigenvalues
            ]
            for speed in range(11)
        }
        print(json.dumps(pairs, indent=2))
    else:
        report(options.output)


if __name__ == "__main__":
    main()

"""A constraint put into a Lagrangian: what goes wrong with a rolling disc.

The tutorial "A rolling disc using Lagrange's Method" of SymPy starts from a contact point at rest,
so that the kinetic energy contains the three angles alone, and writes down Lagrange's equations for
them.  But rolling without slipping is no condition on places: it must enter by its reaction, after
differentiation.  (The potential energy of the tutorial has the wrong sign, too; that is another
matter, and put right here where it says so.)

    python examples/rolling_disc_mistake.py

says what is the case, proves it, and draws both motions.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

import matplotlib.pyplot as plt
import mpmath
import numpy as np
import sympy as sp
from matplotlib.figure import Figure
from scipy.integrate import cumulative_simpson
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from chaplygin import (
    Frame,
    Mechanism,
    Parameter,
    System,
    Trajectory,
    Verdict,
    equations_of_motion,
    from_sympy,
    integrate,
    linear_stability,
    prove,
)
from chaplygin.report.drawing.style import QUIET, SERIES, STYLE, WIDTH
from flowlanes import Identity, Rate
from flowlanes.system import Guard, real_symbol
from nonholonomic import nonholonomy

DEFAULTS = {"m": 1.0, "r": 0.3, "g": 9.81}
m, r, g = (real_symbol(name) for name in DEFAULTS)
q1, q2, q3, q1dot, q2dot, q3dot, x, y, v1, v2 = (
    real_symbol(name)
    for name in ("q1", "q2", "q3", "q1dot", "q2dot", "q3dot", "x", "y", "v1", "v2")
)
s, c = sp.sin(q2), sp.cos(q2)
sine, cosine = real_symbol("sin_q2"), real_symbol("cos_q2")


# --- the tutorial, and two right ways with SymPy -------------------------------------------------


def disc(point_at_rest: bool, sign: int) -> tuple[RigidBody, ReferenceFrame, ReferenceFrame]:
    """The disc with heading q1, lean q2 and roll q3; its body, the ground and the leaning axes."""
    angles = dynamicsymbols("q1 q2 q3")
    mass, radius, gravity = sp.symbols("m r g")
    ground = ReferenceFrame("N")
    heading = ground.orientnew("Y", "Axis", [angles[0], ground.z])
    leaning = heading.orientnew("L", "Axis", [angles[1], heading.x])
    rolling = leaning.orientnew("R", "Axis", [angles[2], leaning.y])
    contact = Point("C")
    centre = contact.locatenew("D", radius * leaning.z)
    if point_at_rest:
        contact.set_vel(ground, 0)
        centre.v2pt_theory(contact, ground, rolling)
    else:
        origin = Point("O")
        origin.set_vel(ground, 0)
        place = dynamicsymbols("x y")
        contact.set_pos(origin, place[0] * ground.x + place[1] * ground.y)
        centre.set_vel(ground, centre.pos_from(origin).dt(ground))
    unit = mass * radius**2 / 4
    body = RigidBody("D", centre, rolling, mass, (inertia(leaning, unit, 2 * unit, unit), centre))
    body.potential_energy = sign * mass * gravity * radius * sp.cos(angles[1])
    return body, ground, leaning


def substituted(sign: int) -> System:
    """Lagrange's equations of the Lagrangian with the constraint put in; sign −1 as printed."""
    body, ground, _ = disc(point_at_rest=True, sign=sign)
    method = LagrangesMethod(Lagrangian(ground, body), dynamicsymbols("q1 q2 q3"))
    return from_sympy(method, DEFAULTS, name="substituted", title="Disc, constraint substituted")


def with_multipliers() -> System:
    """Lagrange's equations with the constraints given to SymPy as such."""
    body, ground, leaning = disc(point_at_rest=False, sign=1)
    below = -sp.Symbol("r") * leaning.z
    slip = body.masscenter.vel(ground) + body.frame.ang_vel_in(ground).cross(below)
    method = LagrangesMethod(
        Lagrangian(ground, body),
        dynamicsymbols("x y q1 q2 q3"),
        nonhol_coneqs=[slip.dot(ground.x), slip.dot(ground.y)],
    )
    return from_sympy(method, DEFAULTS, name="multipliers", title="Disc, with multipliers")


def by_kane() -> System:
    """Kane's equations, for which a contact point at rest is right."""
    body, ground, _ = disc(point_at_rest=True, sign=1)
    angles, speeds = dynamicsymbols("q1 q2 q3"), dynamicsymbols("u1 u2 u3")
    weight = -body.mass * sp.Symbol("g") * ground.z
    method = KanesMethod(
        ground,
        q_ind=angles,
        u_ind=speeds,
        kd_eqs=[angle.diff() - speed for angle, speed in zip(angles, speeds, strict=True)],
        bodies=[body],
        forcelist=[(body.masscenter, weight)],
    )
    return from_sympy(method, DEFAULTS, name="kane", title="Disc, Kane's method")


# --- the same from first principles --------------------------------------------------------------


def mechanism() -> Mechanism:
    """The rolling disc: the velocity v₁, v₂ of its contact point along and across its heading.

    (x, y) is where the wheel touches the ground; it rolls when v₁ = r q̇₃ and v₂ = 0.
    """
    across = v2 - r * q2dot * c
    along = v1 + r * q1dot * s
    spin = q3dot + q1dot * s
    kinetic = m / 2 * (along**2 + across**2 + (r * q2dot * s) ** 2) + m * r**2 / 8 * (
        q2dot**2 + 2 * spin**2 + q1dot**2 * c**2
    )
    return Mechanism(
        name="rolling-disc",
        title="Rolling disc",
        frame=Frame(
            rates={
                x: v1 * sp.cos(q1) - v2 * sp.sin(q1),
                y: v1 * sp.sin(q1) + v2 * sp.cos(q1),
                q1: q1dot,
                q2: q2dot,
                q3: q3dot,
            },
            velocities=(v1, v2, q1dot, q2dot, q3dot),
        ),
        lagrangian=kinetic - m * g * r * c,
        constraints=(v1 - r * q3dot, v2),
        parameters=tuple(Parameter(real_symbol(k), k, value) for k, value in DEFAULTS.items()),
    )


# --- what is the case ----------------------------------------------------------------------------


def same(source: System, target: System, change: dict[str, sp.Symbol]) -> Verdict:
    """Whether the motions of one system, its variables renamed, obey the equations of another.

    The first equation that is not obeyed, or the last that is.
    """
    names = {symbol: change.get(str(symbol), symbol) for symbol in target.symbols}
    demanded = accelerations(target)
    for symbol in target.symbols:
        gap = Rate(names[symbol]) - demanded[str(symbol)].xreplace(names)
        verdict = prove(source, Identity(f"the rate of {symbol}", gap))
        if not verdict:
            break
    return verdict


def in_cosines(system: System) -> System:
    """The same equations with sin q2 and cos q2 as variables: points can be rational numbers."""
    rates = {
        real_symbol(name): sp.expand_trig(rate.rewrite(sp.cos)).xreplace({s: sine, c: cosine})
        for name, rate in accelerations(system).items()
        if name != "q2"
    }
    return System(
        name=system.name,
        title=system.title,
        field={sine: cosine * q2dot, cosine: -sine * q2dot, **rates},
        parameters=system.parameters,
        relations=(sine**2 + cosine**2 - 1,),
        guards=(Guard("upright", cosine, "the disc lies flat"),),
    )


def written(system: System, formula: sp.Expr) -> sp.Expr:
    """A formula with all definitions written out; the disc's are short."""
    for name, value in reversed(system.scalar_definitions):
        formula = formula.xreplace({name: value})
    return formula


def accelerations(system: System) -> dict[str, sp.Expr]:
    """The rates of the state by name, in state and parameters alone."""
    rates = zip(system.symbols, system.rates, strict=True)
    return {str(symbol): written(system, rate) for symbol, rate in rates}


def difference(mistaken: System) -> Identity:
    """By how much the accelerations of the mistaken system differ: by multiples of q̇₂."""
    false = accelerations(mistaken)
    return Identity(
        "difference",
        (
            Rate(q1dot) - false["q1dot"] - 4 * q2dot * (q1dot * s + q3dot) / c,
            Rate(q2dot) - false["q2dot"],
            Rate(q3dot)
            - false["q3dot"]
            + q2dot * (4 * (q3dot * s + q1dot) / c - sp.Rational(10, 3) * q1dot * c),
        ),
    )


def growth(system: System, spin: sp.Expr) -> float:
    """The largest growth rate (1/s) about straight rolling at an angular velocity (rad/s)."""
    numbers = {name: sp.Rational(str(value)) for name, value in DEFAULTS.items()}
    straight = {"q1dot": 0, "q2": 0, "q2dot": 0, "q3dot": spin}
    with mpmath.workdps(30):
        modes = linear_stability(system, straight, numbers)
        return float(max(value.real for value in modes.eigenvalues))


def critical(share: int) -> sp.Expr:
    """√(g / (share · r)) with the numbers of the example."""
    return sp.sqrt(sp.Rational(str(DEFAULTS["g"])) / (share * sp.Rational(str(DEFAULTS["r"]))))


def rolled(
    system: System, spin: float = 2.5, lean: float = 0.02, seconds: float = 4.0
) -> Trajectory:
    """A disc let go at a spin (rad/s), leaning a little (rad)."""
    start = {"q2": lean, "q3dot": spin}
    whole = system.lifted() if system.reconstruction else system
    names = [str(symbol) for symbol in whole.symbols]
    state = [start.get(name, 0.0) for name in names]
    return integrate(system, state, np.linspace(0.0, seconds, 2001))


def column(run: Trajectory, name: str) -> np.ndarray:
    """One variable of the state along a run."""
    names = [str(symbol) for symbol in run.system.symbols]
    return np.asarray(run.states[:, names.index(name)], dtype=float)


def figure(true: Trajectory, false: Trajectory) -> Figure:
    """Lean against time, and the paths of the contact point."""
    drawing, (left, right) = plt.subplots(
        1, 2, figsize=(WIDTH, 3.0), layout="constrained", width_ratios=(1.4, 1)
    )
    pairs = (("rolling disc", true, SERIES[0]), ("constraint substituted", false, SERIES[1]))
    for label, run, colour in pairs:
        times, heading = np.asarray(run.times, dtype=float), column(run, "q1")
        speed = DEFAULTS["r"] * column(run, "q3dot")
        path = [
            cumulative_simpson(speed * turn(heading), x=times, initial=0)
            for turn in (np.cos, np.sin)
        ]
        left.plot(times, np.degrees(column(run, "q2")), color=colour, label=label)
        right.plot(*path, color=colour)
        right.plot(path[0][-1], path[1][-1], "o", color=colour)
    left.axhline(0, color=QUIET, linewidth=0.6)
    left.set(xlabel="time (s)", ylabel="lean (degrees)")
    right.set(xlabel="$x$ (m)", ylabel="$y$ (m)", aspect="equal")
    drawing.legend(loc="outside upper left", ncols=2)
    return drawing


# --- in words ------------------------------------------------------------------------------------


def verdict_text(verdict: Verdict, fails: str = "is off by") -> str:
    """A verdict; of a refutation, the point."""
    if verdict.witness is None:
        return f"{verdict.decision} ({verdict.finding or verdict.reason})"
    point = ", ".join(f"{name} = {value}" for name, value in verdict.witness["point"].items())
    return f"refuted; {verdict.law} {fails} {verdict.witness['residual']} at\n    {point}"


def report(folder: Path) -> None:
    """The whole story, and the figure."""
    disc_itself, model = equations_of_motion(mechanism()), mechanism()
    printed, mistaken = substituted(-1), substituted(1)
    exact = in_cosines(disc_itself)
    print("The constraint\n")
    print(nonholonomy(model))
    print("\nEquations of the rolling disc, from its Lagrangian with constraints\n")
    for name, rate in accelerations(disc_itself).items():
        print(f"    d{name}/dt = {rate}")
    print("\nRight ways to them")
    print(
        "  SymPy, Lagrange with multipliers:",
        verdict_text(same(with_multipliers(), disc_itself, {})),
    )
    speeds = {f"q{i}dot": real_symbol(f"u{i}") for i in (1, 2, 3)}
    print("  SymPy, Kane:", verdict_text(same(by_kane(), disc_itself, speeds)))
    print("\nThe tutorial's equations: the same motions?")
    print("  as printed:", verdict_text(same(exact, in_cosines(printed), {})))
    print(
        "  with the sign of gravity put right:", verdict_text(same(exact, in_cosines(mistaken), {}))
    )
    print("\nThey differ by")
    print("    d(q1dot)/dt:  4 q2dot (q1dot sin q2 + q3dot) / cos q2")
    print("    d(q2dot)/dt:  0")
    print("    d(q3dot)/dt:  q2dot (10/3 q1dot cos q2 − 4 (q3dot sin q2 + q1dot) / cos q2)")
    print("  ", verdict_text(prove(disc_itself, difference(mistaken))))
    print("  Where the lean does not change both agree: steady circles and straight rolling are")
    print("  the same, but how they respond to a push is not.")
    print("\nWhat would be conserved if it were right")
    for law in mistaken.integrals:
        value = sp.expand_trig(written(mistaken, law.value)).xreplace({s: sine, c: cosine})
        verdict = prove(exact, replace(law, value=value))
        print(f"  {law.meaning}: {verdict_text(verdict, 'changes at the rate')}")
    print("  The energy is kept by both, so that a check of the energy shows nothing.")
    print("\nStraight rolling is stable above")
    for label, system, share in (("rolling disc", disc_itself, 3), ("tutorial", mistaken, 9)):
        edge = critical(share)
        below, above = growth(system, edge * sp.Rational(99, 100)), growth(system, edge)
        print(
            f"  {label:14} Ω² = g/({share} r), Ω = {float(edge):.4f} rad/s "
            f"(growth {below:.3f} 1/s a hundredth below, {above:.3f} there)"
        )
    print(f"  as printed     every Ω: at Ω = 0 growth {growth(printed, sp.S.Zero):.3f} 1/s")
    runs = rolled(disc_itself), rolled(mistaken)
    lean = [np.degrees(np.abs(column(run, "q2"))).max() for run in runs]
    print(f"\nLet go at 2.5 rad/s with a lean of 1.1°, the disc leans by up to {lean[0]:.0f}°;")
    print(f"by the tutorial's equations it never leans by more than {lean[1]:.1f}°.")
    with plt.rc_context(STYLE):
        folder.mkdir(parents=True, exist_ok=True)
        figure(*runs).savefig(folder / "rolling_disc_mistake.png", dpi=160)
    print(f"wrote {folder / 'rolling_disc_mistake.png'}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path(), help="folder of the figure")
    report(parser.parse_args().output)


if __name__ == "__main__":
    main()

"""A case of the reference in the package's own terms, and what both say of it.

The reference (tests/reference.py) integrates Newton's and Euler's equations with the contact
force as an unknown and shares no code with the package.  Everything the package says of a motion
is translated here into the same names, axes and units; nothing is computed with the package's
formulas on the side of the reference.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy as sp
from scipy.integrate import DOP853

import reference
from flowlanes.flow.trajectory import Trajectory
from flowlanes.system.system import System
from flowlanes.system.vectors import to_components
from nonholonomic.mechanics.rolling import (
    body as bodies,
    equations as rolling,
    initial_state as start,
)
from nonholonomic.mechanics.shapes import implicit, revolution, shapes, surfaces
from reference import Case

GAMMA = sp.symbols("gamma_1:4", real=True)
XYZ = sp.symbols("x y z", real=True)


@dataclass(frozen=True)
class Package:
    """The modules under test; the mutation tests put changed copies in their place."""

    bodies: Any = bodies
    shapes: Any = shapes
    surfaces: Any = surfaces
    rolling: Any = rolling
    start: Any = start
    revolution: Any = revolution
    implicit: Any = implicit


PACKAGE = Package()


# ---------------------------------------------------------------------------------------------
# Cases


def draw(
    shape: str, support: str, contact: str, inertia: str, seed: int, loaded: bool = False
) -> Case:
    """A regular motion; `loaded` ones have a gyrostat and a potential for certain.

    Besides the shapes of the reference there is the ``"ball centred"``.
    """
    names = (*reference.SHAPES, "ball centred"), reference.SUPPORTS, reference.CONTACTS
    place = [
        listed.index(name) for listed, name in zip(names, (shape, support, contact), strict=True)
    ]
    rng = np.random.default_rng([seed, *place, reference.INERTIAS.index(inertia)])
    while True:
        case = reference.random_case(rng, shape.removesuffix(" centred"), support, contact, inertia)
        if shape == "ball centred":
            case = centred(case)
        if loaded:
            case = load(case, rng)
        if not comes_to_lie(case):
            return case


def centred(case: Case) -> Case:
    """The case of a ball with its centre of mass moved to its centre."""
    table = case.shape_table | {"centre": [0.0, 0.0, 0.0]}
    ball = reference.ball(float(table["radius"]))
    return replace(case, body=replace(case.body, shape=ball), shape_table=table)


def load(case: Case, rng: np.random.Generator) -> Case:
    """The case with rotors and a potential that depends on all of gamma."""
    linear, square = 0.2 * rng.normal(size=3), 0.2 * rng.normal(size=3)
    mixed = 0.2 * rng.normal()

    def potential(gamma: np.ndarray) -> float:
        return float(linear @ gamma + square @ gamma**2 + mixed * gamma.prod())

    def gradient(gamma: np.ndarray) -> np.ndarray:
        x, y, z = gamma
        return linear + 2 * square * gamma + mixed * np.array([y * z, z * x, x * y])

    terms = [
        f"({b!r})*gamma{i} + ({c!r})*gamma{i}**2"
        for i, b, c in zip((1, 2, 3), linear.tolist(), square.tolist(), strict=True)
    ]
    return replace(
        case,
        body=replace(case.body, gyrostat=0.3 * rng.normal(size=3)),
        forces=reference.Forces(case.forces.gravity, potential, gradient),
        potential=" + ".join([*terms, f"({mixed!r})*gamma1*gamma2*gamma3"]),
    )


def comes_to_lie(case: Case) -> bool:
    """Whether a body with a flat side comes near to lying on it."""
    if case.shape_table["kind"] not in ("disk", "torus"):
        return False
    motion = reference.Rolling(case.body, case.surface, case.contact, case.forces)
    solver = DOP853(motion.rate, 0.0, motion.state(case.start), 10.0, rtol=1e-6, atol=1e-7)
    while solver.status == "running":
        solver.step()
        gamma = motion.instant(solver.y).gamma
        if np.hypot(gamma[0], gamma[1]) < reference.LEAST_LEAN:
            return True
    return False


# ---------------------------------------------------------------------------------------------
# From the reference's terms to the package's


def shape_of(table: Mapping[str, Any], package: Package = PACKAGE) -> Any:
    """The package's shape for a shape table of the reference."""
    kinds, at = package.shapes, {"centre": tuple(table["centre"])}
    match table["kind"]:
        case "ball":
            return kinds.Ball(table["radius"], table.get("hollow", False), **at)
        case "ellipsoid":
            return kinds.Ellipsoid(tuple(table["axes"]), table["turn"], **at)
        case "disk":
            return kinds.Disk(table["radius"], **at)
        case "torus":
            return kinds.Torus(table["radius"], table["tube"], **at)
        case "revolution":
            names = {"g3": GAMMA[2]}
            profile = (formula(table[key], names) for key in ("chi1", "chi2"))
            return package.revolution.ShapeOfRevolution.from_profile(*profile, **at)
        case "implicit":
            return package.implicit.ImplicitShape(
                formula(table["surface"], dict(zip("xyz", XYZ, strict=True))), **at
            )
    raise KeyError(table["kind"])


def formula(text: object, names: Mapping[str, sp.Symbol]) -> sp.Expr:
    """A text as a formula, its decimals exact."""
    return sp.sympify(text, dict(names), rational=True)


def equations(case: Case, package: Package = PACKAGE) -> System:
    """The package's equations of a case."""
    tensor = np.asarray(case.body.inertia)
    principal = np.array_equal(tensor, np.diag(np.diag(tensor)))
    body = package.bodies.Body(
        case.body.mass,
        tuple(np.diag(tensor)) if principal else tuple(map(tuple, tensor)),
        shape_of(case.shape_table, package),
        tuple(case.body.gyrostat),
    )
    names = {f"gamma{i}": symbol for i, symbol in enumerate(GAMMA, 1)}
    field = package.rolling.Forces(case.forces.gravity, formula(case.potential, names))
    return package.rolling.rolling_system(
        body, surface_of(case.surface, package), case.contact, field
    )


def surface_of(surface: reference.Surface, package: Package = PACKAGE) -> Any:
    """The package's surface for one of the reference."""
    if isinstance(surface, reference.Sphere):
        return package.surfaces.Sphere.of_signed_radius(surface.radius)
    return package.surfaces.Plane()


def begin(case: Case, system: System, package: Package = PACKAGE) -> tuple[Case, tuple[Any, ...]]:
    """The package's start of a case, and the case with the attitude of that start."""
    gamma, attitude = (np.asarray(case.start[key]) for key in ("gamma", "attitude"))
    flat = isinstance(case.surface, reference.Plane)
    normal = reference.E3 if flat else reference.rotation(attitude) @ gamma
    state = package.start.rolling_state(
        system,
        case.start["omega"].tolist(),
        gamma.tolist(),
        heading=heading(gamma, normal, attitude),
        normal=normal.tolist(),
    )
    names = [str(s) for s in (system.lifted() if system.reconstruction else system).symbols]
    first = names.index("attitude_w")
    own = np.array([float(x) for x in state[first : first + 4]])
    return replace(case, start=case.start | {"attitude": own}), state


def heading(gamma: np.ndarray, normal: np.ndarray, attitude: np.ndarray) -> float:
    """Angle about `normal` between the shortest way from `gamma` to it and an attitude."""
    short = reference.attitude_with_normal(gamma, normal)
    turn = reference.quaternion_product(attitude, short * (1.0, -1.0, -1.0, -1.0))
    return float(2.0 * np.arctan2(turn[1:] @ normal, turn[0]))


# ---------------------------------------------------------------------------------------------
# What both say of a motion


def told_by_package(trajectory: Trajectory) -> dict[str, np.ndarray]:
    """Everything recorded along a trajectory, and its state."""
    told = {name: np.asarray(values, float) for name, values in trajectory.records.items()}
    told |= {str(name): np.asarray(trajectory[str(name)]) for name in trajectory.system.state}
    told["energy"] = told.pop("law_energy")
    return told


def told_by_reference(case: Case, motion: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The same of a motion of the reference."""
    turns = np.array([reference.rotation(q) for q in motion["attitude"]])
    force = np.einsum("nji,nj->ni", turns, motion["contact_force"])
    r = np.einsum("nji,nj->ni", turns, motion["contact"] - motion["centre"])
    omega, gamma = motion["omega"], motion["gamma"]
    orbital = case.body.mass * np.cross(r, np.cross(omega, r))
    return {
        "omega": omega,
        "gamma": gamma,
        "attitude": motion["attitude"],
        "centre": motion["centre"],
        "contact": motion["contact"],
        "place": motion["centre"][:, :2],
        "zeta": turns[:, 2, :],
        "r": r,
        "M": omega @ np.asarray(case.body.inertia) + orbital,
        "normal_force": motion["normal_force"],
        "friction_force": force - motion["normal_force"][:, None] * gamma,
        "spin_torque": motion["spin_torque"],
        "energy": motion["energy"],
    }


def deviations(
    found: Mapping[str, np.ndarray], expected: Mapping[str, np.ndarray]
) -> dict[str, float]:
    """Greatest difference of every found quantity, in units of its size (at least 1)."""
    return {
        name: float(np.abs(values - _same_sign(name, values, expected[name])).max())
        / max(1.0, float(np.abs(expected[name]).max()))
        for name, values in found.items()
    }


def worst(deviation: Mapping[str, float]) -> float:
    """The greatest deviation; not a number if one of them is none."""
    return float(np.max(list(deviation.values())))


def _same_sign(name: str, values: np.ndarray, expected: np.ndarray) -> np.ndarray:
    """An attitude quaternion and its opposite are one attitude."""
    if name != "attitude":
        return expected
    signs = np.sign(np.sum(values * expected, axis=-1, keepdims=True))
    return signs * expected


# ---------------------------------------------------------------------------------------------
# What both say of one instant


def evaluate(
    system: System, formulas: Sequence[Any], values: Mapping[sp.Symbol, float]
) -> np.ndarray:
    """Scalar formulas of a system at known symbols."""
    steps = list(system.required_definitions(formulas, inputs=values))
    function = sp.lambdify(list(values), list(formulas), "math", cse=lambda e: (steps, e))
    return np.array(function(*values.values()), dtype=float)


def instant_of_package(system: System, state: Sequence[Any]) -> dict[str, np.ndarray]:
    """Rates, observables, laws, guards and relations of a system in one lifted state.

    The relations vanish in that state; they are compared at a state close to it.
    """
    lifted = system.lifted()
    values = dict(lifted.defaults)
    values |= {s: float(x) for s, x in zip(lifted.symbols, state, strict=True)}
    pieces: dict[str, list[Any]] = {}
    for name, rate in lifted.field:
        pieces[f"rate of {name}"] = list(to_components(rate))
    for item in lifted.observables:
        pieces[item.name] = _entries(item.value)
    pieces["energy"] = [to_components(law.value) for law in lifted.laws if law.name == "energy"]
    for guard in lifted.guards:
        pieces.setdefault(f"guard {guard.name}", []).append(to_components(guard.value))
    numbers = iter(evaluate(lifted, [e for piece in pieces.values() for e in piece], values))
    told = {name: np.array([next(numbers) for _ in piece]) for name, piece in pieces.items()}
    relations = [to_components(relation) for relation in lifted.relations]
    told["relations"] = evaluate(lifted, relations, values)
    near = values | dict(zip(lifted.symbols, displaced(lifted, state), strict=True))
    told["relations nearby"] = evaluate(lifted, relations, near)
    return told


def _entries(value: Any) -> list[sp.Expr]:
    parts = to_components(value)
    return list(parts) if isinstance(parts, sp.MatrixBase) else [parts]


def displaced(lifted: System, state: Sequence[Any]) -> list[float]:
    """A state close by, off the phase space in every direction."""
    return [float(x) + 0.01 * (1 + i % 5) for i, x in enumerate(state)]


def instant_of_reference(case: Case, system: System, state: Sequence[Any]) -> dict[str, np.ndarray]:
    """The same by the reference, and by hand what only one of both sides has."""
    motion = reference.Rolling(case.body, case.surface, case.contact, case.forces)
    y = motion.state(case.start)
    now, rates = motion.instant(y), motion.rate(0.0, y)
    tensor, mass = motion.inertia, case.body.mass
    omega, r = y[reference.W], y[reference.P]
    turn, gamma, force = now.turn, now.gamma, now.contact_force
    normal = force @ gamma
    momentum_rate = (
        tensor @ now.omega_rate
        + mass * np.cross(now.r_rate, np.cross(omega, r))
        + mass * np.cross(r, np.cross(now.omega_rate, r))
        + mass * np.cross(r, np.cross(omega, now.r_rate))
    )
    told = {
        "rate of M": momentum_rate,
        "rate of omega": now.omega_rate,
        "rate of gamma": now.gamma_rate,
        "rate of r": now.r_rate,
        "rate of zeta": np.cross(turn[2], omega),
        "rate of attitude": rates[reference.Q],
        "rate of place": y[reference.V][:2],
        "omega": omega,
        "M": tensor @ omega + mass * np.cross(r, np.cross(omega, r)),
        "gamma": gamma,
        "attitude": y[reference.Q],
        "centre": y[reference.X],
        "contact": y[reference.X] + turn @ r,
        "normal_force": np.array([normal]),
        "friction_force": force - normal * gamma,
        "spin_torque": np.array([now.spin_torque]),
        "energy": np.array([motion.energy(y)]),
        "guard contact": np.array([normal]),
        "relations nearby": _relations(case, system, state),
    }
    told["relations"] = np.zeros_like(told["relations nearby"])
    return told | _guards(case, gamma)


def _relations(case: Case, system: System, state: Sequence[Any]) -> np.ndarray:
    """What vanishes on the phase space, written by hand, at the displaced state."""
    lifted = system.lifted()
    values = np.array(displaced(lifted, state))
    widths = [len(name.symbols) for name in lifted.state]
    blocks = np.split(values, np.cumsum(widths)[:-1])
    at = {str(name): block for name, block in zip(lifted.state, blocks, strict=True)}
    known: list[float] = []
    if case.shape_table["kind"] == "implicit":
        shape = case.body.shape
        s = at["r"] - np.asarray(shape.centre)
        at["gamma"] = -shape.normal(s)
        known.append(shape.f(s))
    else:
        known.append(at["gamma"] @ at["gamma"] - 1)
    if case.contact == "rubber":
        known.append(at["omega"] @ at["gamma"])
    if "zeta" in at:
        known.append(at["zeta"] @ at["zeta"] - 1)
    known.append(at["attitude"] @ at["attitude"] - 1)
    w, x, y, z = at["attitude"]
    third = np.array([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)])
    vertical = at["gamma"] if isinstance(case.surface, reference.Plane) else at.get("zeta")
    return np.array([*known, *([] if vertical is None else third - vertical)])


def _guards(case: Case, gamma: np.ndarray) -> dict[str, np.ndarray]:
    """The domain of the equations, from the curvature of the body seen by the reference."""
    first, second = radii_of_curvature(case, gamma)
    product = first * second
    implicit = case.shape_table["kind"] == "implicit"
    guards = {
        "guard flat": np.array([gamma[0] ** 2 + gamma[1] ** 2 - 1e-12]),
        "guard convex": np.array(
            [1 / product, 1 / first + 1 / second] if implicit else [product, first + second]
        ),
    }
    if isinstance(case.surface, reference.Sphere):
        a = case.surface.radius
        both = np.array([(a + first) * (a + second), a * (2 * a + first + second)])
        both_curved = np.array([both[0] / product, 1 / first + 1 / second + 2 / a])
        guards["guard fits"] = both_curved if implicit else both
    return guards


def radii_of_curvature(case: Case, gamma: np.ndarray) -> tuple[float, float]:
    """Principal radii of curvature of the body at the contact.

    The reference's conditions of contact, differentiated on a plane, give the rate of the
    contact point for a given rate of the normal; its matrix is minus the inverse Weingarten map.
    """
    shape = case.body.shape
    left, right = shape.rate_rows(shape.touching(gamma), gamma, 0.0)
    u = np.cross(gamma, reference.IDENTITY[int(np.argmin(np.abs(gamma)))])
    u /= np.linalg.norm(u)
    frame = np.stack([u, np.cross(gamma, u)])
    spread = -frame @ np.linalg.solve(left, right) @ frame.T
    first, second = np.linalg.eigvalsh((spread + spread.T) / 2)
    return float(first), float(second)

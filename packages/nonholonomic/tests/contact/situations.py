"""Bodies, supports and laws of the motions of `reference_cases.json`, for the package."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import nonholonomic
from flowlanes.system.arrays import FloatArray
from nonholonomic.contact import (
    AirFilm,
    ContensouErismann,
    ContourResistance,
    Coulomb,
    EventRules,
    FrictionalContact,
    FrictionLaw,
    NormalViscous,
    PowerFriction,
    RollingResistance,
    SpinFriction,
    UserFriction,
    Viscous,
    ViscousRolling,
)
from nonholonomic.contact.starts import state_in_space

CASES: dict[str, dict[str, Any]] = {
    case["name"]: case
    for case in json.loads(Path(__file__).with_name("reference_cases.json").read_text())
}


def situation(case: dict[str, Any]) -> FrictionalContact:
    """The body on its support."""
    given, shape, surface = case["body"], case["body"]["shape"], case["surface"]
    centre = tuple(shape.get("centre", (0.0, 0.0, 0.0)))
    if shape["kind"] == "ball":
        form: nonholonomic.Ball | nonholonomic.Disk | nonholonomic.Ellipsoid = nonholonomic.Ball(
            shape["radius"], centre=centre
        )
    elif shape["kind"] == "disk":
        form = nonholonomic.Disk(shape["radius"], centre=centre)
    else:
        form = nonholonomic.Ellipsoid(
            tuple(shape["axes"]), turn=shape.get("turn", 0.0), centre=centre
        )
    inertia = tuple(tuple(row) if isinstance(row, list) else row for row in given["inertia"])
    body = nonholonomic.Body(
        given["mass"], inertia, form, gyrostat=tuple(given.get("gyrostat", (0, 0, 0)))
    )
    turntable = surface.get("turntable", 0.0)
    support: nonholonomic.Plane | nonholonomic.Sphere = nonholonomic.Plane(turntable=turntable)
    if surface["kind"] == "sphere":
        support = nonholonomic.Sphere(surface["radius"], surface["side"], turntable=turntable)
    return FrictionalContact(
        body, support, laws(case), nonholonomic.Forces(gravity=case["gravity"])
    )


def laws(case: dict[str, Any]) -> tuple[FrictionLaw, ...]:
    """Its laws of friction."""
    given, result = case["contact"], []
    if "patch" in given:
        result.append(ContensouErismann(given["mu"], given["patch"]))
    elif "mu" in given:
        result.append(Coulomb(given["mu"]))
    if "force" in given:
        user = {name: given.get(name) for name in ("mu_static", "values")}
        result.append(UserFriction(given["force"], given.get("couple", 0), **user))
    if "air" in given:
        result.append(AirFilm(given["air"], case["body"]["shape"]["radius"]))
    if "viscous" in given or "spin_viscous" in given:
        result.append(Viscous(given.get("viscous", 0.0), given.get("spin_viscous", 0.0)))
    kinds = {
        "spin_arm": SpinFriction,
        "slip": NormalViscous,
        "rolling": RollingResistance,
        "rolling_viscous": ViscousRolling,
        "contour": ContourResistance,
    }
    if "slip_order" in given:
        result.append(PowerFriction(given["slip"], given["slip_order"]))
        del kinds["slip"]
    result += [kind(given[name]) for name, kind in kinds.items() if name in given]
    return tuple(result)


def rules(case: dict[str, Any]) -> EventRules:
    """What happens at its impacts."""
    given = case["contact"]
    return EventRules(given.get("restitution", 0.0), given.get("impact_law", "stronge"))


def start(case: dict[str, Any], contact: FrictionalContact) -> FloatArray:
    """Its first state."""
    given = case["start"]
    return state_in_space(
        contact, given["position"], given["attitude"], given["velocity"], given["omega"]
    )

"""Conditions that hold functions, linear in a variable."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from certificate_checker import CheckError, check
from flowlanes.system.laws import Identity, Integral, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol
from lawproof import prove
from lawproof.proof.certificates.certificate import prove_with_certificate

x, y, z, u, v, w, g = (real_symbol(n) for n in ("x", "y", "z", "u", "v", "w", "g"))
HEIGHT = sp.Function("f")(x, y)
f_x, f_y = sp.diff(HEIGHT, x), sp.diff(HEIGHT, y)


def on_a_surface(height: sp.Expr) -> System:
    """A heavy particle on z = f(x, y): λ from the second derivative of the constraint."""
    by_x, by_y = sp.diff(height, x), sp.diff(height, y)
    bend = (
        sp.diff(height, x, 2) * u**2
        + 2 * sp.diff(height, x, y) * u * v
        + sp.diff(height, y, 2) * v**2
    )
    force = (g + bend) / (1 + by_x**2 + by_y**2)
    return System(
        "particle",
        "Particle on a surface",
        field={x: u, y: v, z: w, u: -by_x * force, v: -by_y * force, w: force - g},
        relations=(z - height, w - by_x * u - by_y * v),
        parameters=(Parameter(g, "gravity", 9.8),),
    )


ENERGY = Integral("energy", (u**2 + v**2 + w**2) / 2 + g * z)


def test_energy_on_every_surface() -> None:
    assert prove(on_a_surface(HEIGHT), ENERGY).decision == "proven"


def test_energy_on_a_wavy_surface() -> None:
    assert prove(on_a_surface(sp.cos(x) * sp.exp(y)), ENERGY).decision == "proven"


def test_certificate_of_a_law_on_every_surface() -> None:
    verdict = prove_with_certificate(on_a_surface(HEIGHT), ENERGY)
    assert verdict.certificate is not None
    check(verdict.certificate)
    verdict.certificate["proofs"][0]["residuals"][0]["numerator"].append(["1", []])
    with pytest.raises(CheckError):
        check(verdict.certificate)


def test_a_planted_error_is_refuted() -> None:
    wrong = Integral("energy", (u**2 + v**2 + w**2) / 2 - g * z)
    assert prove(on_a_surface(sp.cos(x) * sp.exp(y)), wrong).decision == "refuted"


def test_a_relation_that_is_not_kept_proves_nothing() -> None:
    system = on_a_surface(HEIGHT)
    field = dict(system.field) | {w: -g}
    loose = System(
        "loose", "Loose", field=field, relations=system.relations, parameters=system.parameters
    )
    assert prove(loose, ENERGY).decision == "refuted"


def test_volume_on_a_graph() -> None:
    """The volume cut out by z = f(x, y) is dx dy: a divergence-free field of the plane keeps it."""
    system = System(
        "flow",
        "Flow",
        field={x: y, y: -x, z: y * f_x - x * f_y},
        relations=(z - HEIGHT,),
    )
    assert prove(system, Measure("area", {sp.S.One * 2: 1})).decision == "proven"
    assert prove(system, Measure("weighted", {1 + x**2: 1})).decision == "refuted"


def named(system: System, *orders: int) -> System:
    """The same system with names for its relations, in some order."""
    names = [real_symbol(f"c_{i}") for i in range(len(system.relations))]
    return replace(
        system,
        definitions=tuple(zip(names, system.relations, strict=True)),
        relations=tuple(names[i] for i in orders),
    )


@pytest.mark.parametrize("orders", [(0, 1), (1, 0)])
def test_a_name_hides_no_condition(orders: tuple[int, int]) -> None:
    system = named(on_a_surface(sp.sqrt(1 + x**2) * sp.exp(y)), *orders)
    assert prove(system, ENERGY).decision == "proven"
    assert prove(system, Integral("wrong", ENERGY.value + w)).decision == "refuted"
    assert prove(system, Measure("volume", {})).decision == "refuted"
    general = named(on_a_surface(HEIGHT), *orders)
    assert prove(general, ENERGY).decision == "proven"


def test_a_condition_leaves_another_the_variable_it_needs() -> None:
    """The first is linear in u and v, the second in v alone: whichever comes first."""
    first, second = u + v - sp.exp(w), v * sp.exp(w) - 1
    still = {s: sp.S.Zero for s in (u, v, w)}
    for relations in ((first, second), (second, first)):
        system = System("still", "Still", still, relations=relations)
        law = Identity("sinh", u - sp.exp(w) + sp.exp(-w))
        assert prove(system, law).decision == "proven"
        wrong = Identity("wrong", u - sp.exp(w) - sp.exp(-w))
        assert prove(system, wrong).decision == "refuted"

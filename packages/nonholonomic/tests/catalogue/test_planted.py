"""Laws of the catalogue with one slip are refuted: no proof is had for nothing."""

from __future__ import annotations

from collections import Counter

import pytest

from catalogue.claimed import LABELS, all_claimed, claimed
from flowlanes.errors import InputError
from lawproof.proof.prover import prove
from planted import SLIPS, wrong_laws

#: Slips that leave a law right.
HARMLESS = {
    # the body does not turn about its third axis: ω₃ = 0
    "suslov energy": {"value sign"},
    "suslov-quadratic energy": {"value sign"},
    # M₃ is constant
    "lagrange-top energy": {"value sign"},
    # the energy is made of two integrals, one of which changes its sign
    "clebsch energy": {"value sign"},
    "special-chaplygin-ball-nd energy": {"value sign"},
    "veselova-geodesic-flow energy": {"value sign"},
    # the edge is equally far from the centre of mass everywhere: the first base is constant
    "rubber-disk measure": {"density sign", "density power"},
    # the slip falls on a term with c₁ = 0
    "rubber-routh-sphere spin": {"value exponent", "value index"},
    "rubber-routh-sphere quadratures": {"quantities exponent"},
    # any function of the angles makes a Poisson bracket in this place
    # every function of a constant velocity is constant
    "snakeboard energy": {"value exponent"},
    "trailers energy": {"value exponent"},
    "vertical-rolling-disk momentum_w": {"value exponent"},
    "chaplygin-ball-reduced bracket": {"bracket exponent"},
    # the gradient of a sphere's and of a circular cylinder's equation is as long everywhere
    "marble-ball-on-sphere volume": {"density power"},
    "marble-ball-on-cylinder volume": {"density power"},
    # on a cone the square of its length is a multiple of z², whatever the sign of one term
    "marble-ball-on-cone volume": {"density sign"},
    "rubber-ball-on-cone volume": {"density sign"},
    # one component of the direction of the slip, and of the jerk, is as constant as the other
    "sliding-ball direction_x": {"value index"},
    "sliding-ball direction_y": {"value index"},
    "sliding-ball parabola": {"value index"},
    "sliding-ball (general) direction_x": {"value index"},
    # the axis is at rest in the body: one component is as constant as another
    **{f"two-veselova-constraints (general) axis_{i}": {"value index"} for i in (1, 2, 3)},
    # every function of the constant spin is constant
    "sliding-ball momentum_z": {"value exponent"},
    # every function of the constant height is constant
    "marble-ball particle_in_plane": {"map exponent"},
}

#: Slips that make the number below a root negative: no point is left to decide them at.
IMAGINARY = {"straight-line-ball-momenta measure": {"density sign"}}


@pytest.fixture
def forgotten(tmp_path, monkeypatch):
    """Verdicts on wrong laws are not kept."""
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path))


@pytest.mark.slow
@pytest.mark.parametrize("label", LABELS)
def test_every_slip_is_refuted(label, forgotten):
    one = claimed(label)
    found: dict[str, set[str]] = {}
    for slip, wrong in wrong_laws(one.law, one.system):
        try:
            decision = prove(one.system, wrong).decision
        except InputError as error:
            assert "takes a root of a negative quantity, at every point" in str(error)
            decision = "imaginary"
        found.setdefault(decision, set()).add(slip)
    assert found.pop("refuted")
    expected = {
        "proven": HARMLESS.get(label, set()),
        "imaginary": IMAGINARY.get(label, set()),
    }
    assert found == {decision: slips for decision, slips in expected.items() if slips}


@pytest.mark.slow
def test_slips_of_every_kind_fall_on_every_kind_of_law():
    falls = Counter(
        (type(one.law).__name__, *slip.split(maxsplit=1))
        for one in all_claimed()
        for slip, _ in wrong_laws(one.law, one.system)
    )
    parts = {
        "Integral": ("value",),
        "Identity": ("value",),
        "Measure": ("density",),
        "Symmetry": ("field",),
        "PoissonStructure": ("bracket", "casimirs"),
        "ConformallyHamiltonian": ("hamiltonian", "multiplier", "bracket"),
        "Isomorphism": ("map", "time"),
        "Reduction": ("equations", "quantities"),
        "Separation": ("equations", "quantities"),
    }
    for kind, names in parts.items():
        for name in names:
            assert sum(falls[kind, name, slip] for slip in SLIPS) > 1, (kind, name)
    assert falls["Measure", "density", "power"]
    assert falls["Isomorphism", "time", "factor"]
    assert falls["ConformallyHamiltonian", "multiplier", "factor"]
    assert falls["PoissonStructure", "rank", "two less"]


def test_what_is_listed_here_is_in_the_catalogue():
    assert {*HARMLESS, *IMAGINARY} <= set(LABELS)

"""Bodies about a fixed point with fluid, against unreduced equations."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.laws import ConformallyHamiltonian
from flowlanes.system.system import System
from lawproof.proof.prover import prove
from mechanics.rolling.fluid_reference import Chamber, FilledTop
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.fixed_point.fluid_filled_bodies import with_fluid
from nonholonomic.mechanics.rolling.cavity import Cavity

AXES, MASS, UNTIL = (0.9, 0.5, 0.3), 2.0, 10.0
XI = np.array([0.5, -2.0, 1.2])
GAMMA = np.array([0.2, -0.3, 0.93]) / np.linalg.norm([0.2, -0.3, 0.93])


ALONG = (Cavity(AXES, MASS),)
TURNED = (Cavity(AXES, MASS, turn=(1.0, 0.3, -0.2, 0.5), centre=(0.1, -0.3, 0.2)),)
TWO = (*TURNED, Cavity((0.2, 0.4, 0.3), 0.7, turn=(0.3, 1.0, 0.0, 0.2), centre=(0.5, 0.9, -1.2)))


def start_of(name: str, system: System) -> tuple[np.ndarray, np.ndarray, np.ndarray | str]:
    """Inertia of the solid, ω, and what ω is orthogonal to."""
    I = {str(s): value for s, value in system.defaults.items()}
    inertia = np.diag([I["I_1"], I["I_2"], I["I_3"]])
    axis, n = {"veselova": ("vertical", GAMMA), "free-body": ("free", np.zeros(3))}.get(
        name, (np.array([0.0, 0.0, 1.0]),) * 2
    )
    if name == "suslov":
        inertia[0, 2] = inertia[2, 0] = I["I_13"]
        inertia[1, 2] = inertia[2, 1] = I["I_23"]
    omega = np.array([0.9, -0.5, 0.4])
    return inertia, omega - omega @ n * n, axis


@pytest.mark.slow
@pytest.mark.parametrize("cavities", [ALONG, TURNED, TWO], ids=["along", "turned", "two"])
@pytest.mark.parametrize("name", ["free-body", "veselova", "suslov"])
def test_the_motion_is_that_of_the_unreduced_equations(name, cavities):
    system = from_catalogue(name)
    filled = with_fluid(system, cavities)
    inertia, omega, axis = start_of(name, system)
    chambers = [Chamber(c.mass, *map(np.array, (c.axes, c.centre, c.turn))) for c in cavities]
    xis = [XI, -XI[::-1]][: len(cavities)]
    reference = FilledTop(inertia, chambers, axis).end(omega, GAMMA, xis, UNTIL)
    names = ["fluid"] if len(cavities) == 1 else ["fluid1", "fluid2"]
    fluid = {key: tuple(xi) for key, xi in zip(names, xis, strict=True)}
    run = integrate(filled, {"omega": tuple(omega), "gamma": tuple(GAMMA), **fluid}, [0.0, UNTIL])
    ours = (run["omega"][-1], run["gamma"][-1], *(run.records[key][-1] for key in names))
    for here, there in zip(ours, reference, strict=True):
        assert np.abs(here - there).max() < 1e-10


@pytest.mark.parametrize("name", ["free-body", "veselova", "suslov"])
def test_laws_with_a_cavity_along_the_axes(name):
    filled = with_fluid(from_catalogue(name), ALONG)
    assert {law.name: prove(filled, law).decision for law in filled.laws} == dict.fromkeys(
        (law.name for law in filled.laws), "proven"
    )


def test_with_the_sign_of_the_fluid_reversed_the_bracket_is_refuted():
    """{N_i, N_j} = −ε_ijk N_k, that of the body, is no form of these equations."""
    filled = with_fluid(from_catalogue("free-body"), ALONG)
    form = next(law for law in filled.laws if isinstance(law, ConformallyHamiltonian))
    matrix = sp.Matrix(form.structure.matrix)
    matrix[6:, 6:] = -matrix[6:, 6:]
    slip = replace(form, structure=replace(form.structure, matrix=matrix))
    assert prove(filled, slip).decision == "refuted"


def test_a_spherical_cavity_leaves_the_free_body_alone():
    """The momentum of the fluid stays in space, the body moves as if it were empty."""
    system = from_catalogue("free-body")
    filled = with_fluid(system, [Cavity((0.6, 0.6, 0.6), 2.0)])
    start = {"omega": (0.9, -0.5, 0.4), "gamma": tuple(GAMMA)}
    dry = integrate(system, start, [0.0, 5.0])
    wet = integrate(filled, {**start, "fluid": tuple(XI)}, [0.0, 5.0])
    assert wet["gamma"][-1] == pytest.approx(dry["gamma"][-1], abs=1e-13)


def test_an_empty_cavity_changes_nothing():
    system = from_catalogue("veselova")
    assert with_fluid(system, [Cavity(AXES, 0.0)]) is system


def test_other_systems_hold_no_fluid():
    with pytest.raises(InputError) as caught:
        with_fluid(from_catalogue("veselova-bruns"), ALONG)
    assert caught.value.message == (
        "cavity: veselova-bruns cannot hold fluid; a rolling body, free-body, veselova and suslov "
        "can"
    )

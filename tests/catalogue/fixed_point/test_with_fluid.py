"""Veselova's system and Suslov's problem with fluid, against unreduced equations."""

from __future__ import annotations

import numpy as np
import pytest

from chaplygin.catalogue import from_catalogue
from chaplygin.catalogue.fixed_point.with_fluid import with_fluid
from chaplygin.errors import InputError
from chaplygin.flow.integrator import integrate
from chaplygin.mechanics.rolling.cavity import Cavity
from mechanics.rolling.fluid_reference import Chamber, FilledTop

AXES, MASS, UNTIL = (0.9, 0.5, 0.3), 2.0, 10.0
XI = np.array([0.5, -2.0, 1.2])
GAMMA = np.array([0.2, -0.3, 0.93]) / np.linalg.norm([0.2, -0.3, 0.93])


@pytest.mark.slow(every=2)
@pytest.mark.parametrize("name", ["veselova", "suslov"])
def test_the_motion_is_that_of_the_unreduced_equations(name):
    system = from_catalogue(name)
    filled = with_fluid(system, [Cavity(AXES, MASS)])
    I = {str(s): value for s, value in system.defaults.items()}
    inertia = np.diag([I["I_1"], I["I_2"], I["I_3"]])
    axis, n = None, GAMMA
    if name == "suslov":
        inertia[0, 2] = inertia[2, 0] = I["I_13"]
        inertia[1, 2] = inertia[2, 1] = I["I_23"]
        axis = n = np.array([0.0, 0.0, 1.0])
    omega = np.array([0.9, -0.5, 0.4])
    omega = omega - omega @ n * n
    chamber = Chamber(MASS, np.array(AXES), np.zeros(3), np.array([1.0, 0.0, 0.0, 0.0]))
    reference = FilledTop(inertia, chamber, axis).end(omega, GAMMA, XI, UNTIL)
    start = {"omega": tuple(omega), "gamma": tuple(GAMMA), "fluid": tuple(XI)}
    run = integrate(filled, start, [0.0, UNTIL])
    ours = (run["omega"][-1], run["gamma"][-1], run.recorded["fluid"][-1])
    for here, there in zip(ours, reference, strict=True):
        assert np.abs(here - there).max() < 1e-10


def test_an_empty_cavity_changes_nothing():
    system = from_catalogue("veselova")
    assert with_fluid(system, [Cavity(AXES, 0.0)]) is system


def test_one_cavity_about_the_fixed_point_alone():
    with pytest.raises(InputError) as caught:
        with_fluid(from_catalogue("veselova"), [Cavity(AXES, 1.0), Cavity(AXES, 1.0)])
    assert caught.value.message == "cavity: only one has its centre in the fixed point"

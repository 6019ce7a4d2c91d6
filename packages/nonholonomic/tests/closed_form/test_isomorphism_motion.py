"""Motions of any kind carried over isomorphisms."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form.isomorphism_motion import IsomorphismMap

TIMES = np.linspace(0.0, 20.0, 11)
CASES = {
    "Theorem 8": ("veselova", "neumann", (0.9, -0.3, -1.04, 0.48, -0.64, 0.6)),
    "Theorem 10": ("chaplygin-ball", "clebsch_case", (2, -0.3, -1.92, 0.48, -0.64, 0.6)),
}


@pytest.fixture(scope="module", params=CASES)
def case(request):
    """A carrier and an integrated motion of its system, through and at `TIMES`."""
    name, law, start = CASES[request.param]
    system = replace(from_catalogue(name), reconstruction=None, observables=(), guards=())
    (found,) = (each for each in system.laws if each.name == law)
    motion = integrate(system, start, [*TIMES, 30.0], dense=True)
    return IsomorphismMap(system, found, system.defaults), motion


def test_states_there_and_back(case):
    carrier, motion = case
    again = carrier.preimage(carrier.image(motion.states))
    assert np.abs(again - motion.states).max() < 1e-14


def test_image_is_a_motion_of_the_target(case):
    carrier, motion = case
    values = {str(s): x for s, x in carrier.target_parameters(motion.states[0]).items()}
    taus = np.linspace(0.0, 3.0, 7)
    start = carrier.image(motion.states[:1])[0]
    own = integrate(carrier.law.target, start, taus, parameters=values)
    assert np.abs(carrier.target_motion(motion.dense, taus) - own.states).max() < 1e-12


def test_motions_there_and_back(case):
    carrier, motion = case
    # as far in τ as the integrated motion reaches
    reach = 20.0 * float(carrier.rate(motion.states).min())
    taus = np.linspace(0.0, reach, 9)
    images = carrier.target_motion(motion.dense, taus)
    assert np.abs(images[0] - carrier.image(motion.states[:1])[0]).max() < 1e-15

    def image(tau):
        return carrier.target_motion(motion.dense, tau)

    times = np.linspace(0.0, 5.0, 6)
    again = carrier.system_motion(image, times)
    assert np.abs(again - motion.dense(times)).max() < 1e-12


def test_negative_times_are_refused(case):
    carrier, motion = case
    with pytest.raises(InputError, match="none may be negative"):
        carrier.target_motion(motion.dense, [-1.0])

"""§11.4: the steady motions of a disk that whirls, against the catalogue's own equations."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

import flowlanes
import lawproof
import nonholonomic
from borisov_mamaev_2008.section_11.section_11_4 import whirling


@pytest.mark.parametrize("inclination", [0.05, 0.4, 1.1])
def test_a_homogeneous_disk_whirls_at_the_rate_of_the_claim(inclination: float) -> None:
    """Ω² = 4g/(R sin α), with the root √(γ, Bγ) of the equations as it stands."""
    disk = nonholonomic.from_catalogue("heavy-disk")
    sine, cosine = math.sin(inclination), math.cos(inclination)
    turn = math.sqrt(4 * 9.81 / sine)
    start = {"M": [0.25 * turn * sine, 0, 0], "gamma": [sine, 0, cosine]}
    motion = flowlanes.integrate(disk, start, [n / turn for n in range(21)])
    assert max(abs(motion.states[:, 5] - cosine)) < 1e-12


def test_another_rate_is_refuted() -> None:
    disk, law = whirling()
    assert lawproof.prove(disk, law).decision == "proven"
    *others, rate = law.level
    m = next(p.symbol for p in disk.parameters if p.symbol.name == "m")
    wrong = replace(law, level=(*others, rate.subs(m, 2 * m)))
    assert lawproof.prove(disk, wrong).decision == "refuted"

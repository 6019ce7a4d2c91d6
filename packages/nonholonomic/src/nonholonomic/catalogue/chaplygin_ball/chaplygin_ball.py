"""The Chaplygin ball (§7): a balanced, dynamically asymmetric ball on a plane.

It may carry rotors or move in Bruns' field; what holds in every potential U(γ) is stated for an
unspecified one in the general systems.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, PoissonStructure
from flowlanes.system.system import System
from flowlanes.system.vectors import (
    Diagonal,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
    zero,
)

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces, RollingBody
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Plane
from ..catalogue_entry import Numbers, bruns_factor, laws_for
from ..e3 import lie_poisson
from ..file_systems import python_entry
from .chaplygin_ball_clebsch import onto_clebsch, onto_fedorov
from .chaplygin_bracket import DET_IQ, D, hamiltonian_form

M, gamma, k, omega, L = vectors("M gamma k omega L")
J, A = Diagonal("J"), Diagonal("A")
K = real_symbol("K")

#: Bruns' field U = ½K(γ, Iγ); K is the paper's k, a name that the rotors need.
BRUNS = to_components(K / 2 * dot(gamma, Diagonal("I") * gamma))
#: ρ = (det I_Q)^(−1/2) of (7.3), in the symbols of a rolling ball.
DENSITY = 1 / sp.sqrt(DET_IQ)
MOMENTUM_UNIT = "kg^2 m^4/s^2"


def ball(p: Numbers, rotors: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> RollingBody:
    """A ball with its centre of mass at its centre, with rotors or without."""
    return RollingBody(Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), Ball(p["R"]), gyrostat=rotors))


def build(p: Numbers) -> RollingBody:
    """The ball alone."""
    return ball(p)


def with_rotors(p: Numbers) -> RollingBody:
    """The ball with the constant gyrostatic momentum k."""
    return ball(p, (p["k_1"], p["k_2"], p["k_3"]))


def in_bruns_field(p: Numbers) -> RollingBody:
    """The ball in the potential U = ½K(γ, Iγ)."""
    return replace(ball(p), field=Forces(potential=BRUNS, parameters={K: p["K"]}))


@laws_for("marble", Plane(), Ball)
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """The laws in every potential, and M² without one or in Bruns' field."""
    body = rolling.body
    if any(body.shape.centre):
        return ()
    total = M + k if any(body.gyrostat) else M + zero
    area = dot(total, gamma)
    known: list[Law] = [
        Integral("area", area, "area integral", source="(7.2)", unit="kg m^2/s"),
    ]
    potential = rolling.field.potential
    square = norm_squared(total)
    meaning = "square of the momentum"
    factor = bruns_factor(potential) if body.principal and total == M else None
    if factor is not None:
        square = square - factor * J.symbols[0] * J.symbols[1] * J.symbols[2] * dot(
            gamma, A * gamma
        )
        meaning = "square of the momentum, Bruns field"
    if factor is not None or potential == 0:
        source = "(7.4)" if potential == 0 else "Remark 20"
        known.append(Integral("momentum", square, meaning, source=source, unit=MOMENTUM_UNIT))
    if body.principal:
        known += _forms(system, total)
    if body.principal and potential == 0:
        known.append(_onto_bracket(potential, zero if total == M else k))
    if body.principal and potential == 0 and total == M:
        known += [onto_clebsch(), onto_fedorov()]
    return tuple(known)


def _forms(system: System, total: sp.MatrixExpr) -> tuple[Law, ...]:
    """Measure, Poisson structure and conformally Hamiltonian form, in any potential."""
    (energy,) = (law.value for law in system.integrals if law.name == "energy")
    structure = PoissonStructure(
        "bracket",
        lie_poisson((total - D * dot(omega, gamma) * gamma) / DENSITY, gamma / DENSITY),
        casimirs=(norm_squared(gamma), dot(total, gamma)),
        rank=4,
        meaning="minus the bracket (7.6), in the variables M, γ",
        source="(7.6)" if total == M else "§7.4",
    )
    return (
        Measure(
            "measure",
            {DET_IQ: -sp.Rational(1, 2)},
            "invariant measure ρ d³M d³γ",
            source="(7.3)",
        ),
        structure,
        ConformallyHamiltonian(
            "hamiltonian",
            DENSITY,
            structure,
            energy,
            "conformally Hamiltonian form",
            source="(7.5), (7.6)" if total == M else "§7.4",
        ),
    )


def _onto_bracket(potential: sp.Expr, rotors: sp.MatrixExpr) -> Isomorphism:
    """The Hamiltonian form in L = ρ(M + k)."""
    return Isomorphism(
        "hamiltonian_form",
        hamiltonian_form(potential, rotors),
        {L: DENSITY * (M + rotors), gamma: gamma},
        DENSITY,
        meaning="Hamiltonian system on a nonlinear bracket",
        source="(7.5)–(7.7)" if rotors == zero else "§7.4",
    )


def _general(rolling: RollingBody, rotors: sp.MatrixExpr, name: str) -> System:
    """The ball in an unspecified potential, with its Hamiltonian form."""
    potential = sp.Function("U")(*gamma.symbols)
    system = RollingBody(rolling.body, field=Forces(potential=potential)).system(name)
    area, *_ = laws(rolling, system)
    forms = _forms(system, M + rotors)
    return system.with_laws(area, *forms, _onto_bracket(potential, rotors))


def general_system() -> System:
    """The ball in an arbitrary potential U(γ)."""
    return _general(build(NUMBERS), zero, "chaplygin-ball")


def unspecified_with_rotors() -> System:
    """The ball with rotors in an arbitrary potential U(γ)."""
    return _general(with_rotors(GYROSTAT), k, "chaplygin-ball-gyrostat")


NUMBERS = {"m": 1.0, "I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "R": 1.0}
GYROSTAT = {**NUMBERS, "k_1": 0.3, "k_2": -0.2, "k_3": 0.5}

ENTRIES = (
    python_entry(
        name="chaplygin-ball",
        build=build,
        laws=laws,
        general=general_system,
    ),
    python_entry(
        name="chaplygin-ball-gyrostat",
        build=with_rotors,
        laws=laws,
        general=unspecified_with_rotors,
    ),
    python_entry(
        name="chaplygin-ball-bruns",
        build=in_bruns_field,
        laws=laws,
    ),
)

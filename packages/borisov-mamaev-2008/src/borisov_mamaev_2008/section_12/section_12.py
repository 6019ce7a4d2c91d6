"""§12: the claims made in connection with the open problems."""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import ConformallyHamiltonian, Identity, Integral, Law, Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import (
    constant,
    cross,
    dot,
    identity,
    norm_squared,
    to_components,
    vectors,
    zero,
)
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.ball_on_sphere import ball_on_sphere_equations as sphere
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball_angles import (
    ACROSS,
    COS,
    SIN,
    TURN,
    ball_in_angles,
    c,
    phidot,
    psidot,
    thetadot,
)
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import D, I, gamma, k
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark
from ..methods.catalogue_laws import laws_named
from ..methods.derived_verdicts import conclusion_verdict, contrary
from ..methods.tori import not_hamiltonian, of_rank_two
from ..open_problems.findings import findings_of, measures_of_several_dimensions
from ..section_07.section_07_3a import PRECESSION, SPIN, SPREAD

M, omega = vectors("M omega")


def conformally_hamiltonian(name: str) -> tuple[tuple[System, Law], ...]:
    """The conformally Hamiltonian form of a system of the catalogue, with its integrals."""
    system = from_catalogue(name)
    kinds = (ConformallyHamiltonian, Integral)
    return tuple((system, law) for law in system.laws if isinstance(law, kinds))


def with_rotors() -> tuple[tuple[System, Law], ...]:
    """Markeev's generalisation."""
    return conformally_hamiltonian("chaplygin-ball-gyrostat")


def in_bruns_field() -> tuple[tuple[System, Law], ...]:
    """Kozlov's generalisation."""
    return conformally_hamiltonian("chaplygin-ball-bruns")


def around_a_sphere() -> Case:
    """The problem of Borisov and Fedorov with a Bruns field preserves its integrals and measure."""
    system = from_catalogue("ball-around-sphere-bruns")
    return laws_named(system, "energy", "momentum", "linear", "measure")


# --- integrals in the velocities of the reduced system ---------------------------------------


def _momentum_and_energy(rotors: MatrixExpr) -> tuple[sp.Expr, sp.Expr]:
    """(M + k)² and H in θ, φ, θ̇, φ̇ and the area constant c, with ψ̇ of (7.11) and §7.4."""
    share = to_components(dot(constant([SIN * TURN, SIN * ACROSS, COS]), rotors))
    spin = SPIN.xreplace({psidot: PRECESSION - share / SPREAD})
    momentum = I * spin + D * cross(gamma, cross(spin, gamma))
    return to_components(norm_squared(momentum + rotors)), to_components(dot(momentum, spin)) / 2


def _linear(value: sp.Expr) -> sp.Expr:
    """The part linear in θ̇, φ̇ of a formula quadratic in them."""
    reversed_ = value.xreplace({thetadot: -thetadot, phidot: -phidot})
    return (value - reversed_) / 2


def in_velocities(rotors: MatrixExpr) -> tuple[tuple[System, Identity], ...]:
    """The formulas agree with those of the ball, and the energy has no linear part.

    The integral in Bruns' field is M² minus a function of γ and has the linear part of M².
    """
    system = ball_in_angles(rotors)
    square, energy = _momentum_and_energy(rotors)
    values = (square - norm_squared(M + rotors), energy - dot(M, omega) / 2, _linear(energy))
    return ((system, Identity("velocities", values)),)


def linear_part(rotors: MatrixExpr, *level: sp.Expr) -> tuple[System, Identity]:
    """The law that (M + k)² has no part linear in the velocities, on a level."""
    law = Identity("linear part", _linear(_momentum_and_energy(rotors)[0]), level=level)
    return ball_in_angles(rotors), law


def linear_terms() -> Verdict:
    """Both integrals have linear parts that no multiple of the energy can remove."""
    parts = [contrary(prove(*linear_part(rotors))) for rotors in (zero, k)]
    integrals = (law for case in (with_rotors(), in_bruns_field()) for law in case)
    return conclusion_verdict(
        "linear terms",
        "the linear part of the integral is not zero at a point, that of the energy is zero",
        (*parts, *in_velocities(zero), *in_velocities(k), *integrals),
    )


def without_area() -> Case:
    """(M, γ) = 0: the linear part of M² vanishes."""
    return linear_part(zero, c), *in_velocities(zero)


def around_sphere_linear() -> Verdict:
    """k = −1, F₂ = (AM, n): the parts of (M, ω) and M² linear in ṅ vanish only if F₂ does."""
    system = sphere.equations_on_sphere()
    tensor = (sp.Add(*sphere.I.symbols) + sphere.d) / 2 * identity - sphere.I
    drawn = sphere.contact_inertia(tensor * sphere.n)
    swing, area = cross(drawn, rate(sphere.n)), dot(tensor * sphere.M, sphere.n)
    shared, spun = sphere.contact_inertia(swing), sphere.contact_inertia(sphere.n)
    form = dot(sphere.n, drawn)
    # ω = (Bn×ṅ + F₂n)/(n, Bn); (8.4) is the case F₂ = 0.
    parts = (2 * area * dot(spun, swing), 2 * area * dot(spun, shared))
    constant_parts = (
        dot(swing, shared) + area**2 * dot(sphere.n, spun),
        norm_squared(shared) + area**2 * norm_squared(spun),
    )
    values = (dot(sphere.M, sphere.omega), norm_squared(sphere.M))
    split = Identity(
        "parts",
        tuple(
            form**2 * value - part - other
            for value, part, other in zip(values, parts, constant_parts, strict=True)
        ),
        level=(sphere.k + 1,),
    )
    present = [
        contrary(prove(system, Identity("linear part", part, level=(sphere.k + 1,))))
        for part in parts
    ]
    return conclusion_verdict(
        "linear terms",
        "the parts of H and F₁ linear in ṅ have the factor F₂ and are not zero at a point",
        ((system, split), *present),
    )


def euler_jacobi(name: str) -> tuple[tuple[System, Law], ...]:
    """All integrals of a system, and its invariant measure."""
    system = from_catalogue(name)
    kinds = (Integral, Measure)
    return tuple((system, law) for law in system.laws if isinstance(law, kinds))


def fedorov() -> tuple[tuple[System, Law], ...]:
    """A ball in a ball bearing."""
    return euler_jacobi("ball-bearing")


def straight_line() -> tuple[tuple[System, Law], ...]:
    """A Chaplygin ball along a straight line; the measure is stated in its momenta."""
    plain = from_catalogue("straight-line-ball")
    by_momenta = from_catalogue("straight-line-ball-momenta")
    return (
        *((plain, law) for law in plain.laws),
        *laws_named(by_momenta, "energy", "measure"),
    )


def therefore_conformally_hamiltonian() -> Verdict:
    """The assertion of Corollary 2 applied to each of these systems."""
    return contrary(not_hamiltonian())


def hamiltonian_near_tori() -> Verdict:
    """(4.3) with two or more integrals has a bracket of rank two."""
    return conclusion_verdict(
        "near tori",
        "both systems have more than two integrals and a measure, and v∧∂/∂F₁ is a bracket",
        (*fedorov(), *straight_line(), *of_rank_two()),
    )


CLAIMS = (
    Claim(
        "§12, problem 1",
        "The generalisation of the Chaplygin ball due to Markeev, with a gyrostat, is conformally "
        "Hamiltonian, and has a quadratic integral.",
        with_rotors,
    ),
    Claim(
        "§12, problem 1",
        "The generalisation of the Chaplygin ball due to Kozlov, in a potential Bruns field, is "
        "conformally Hamiltonian, and has a quadratic integral.",
        in_bruns_field,
    ),
    Claim(
        "§12, problem 1, linear terms",
        "Upon a change of time, one gets a Hamiltonian system on a sphere which is integrable: the "
        "system has a quadratic integral which contains terms linear in velocities.",
        linear_terms,
        note="for the gyrostat and for the Bruns field, with any area constant; the energy has no "
        "linear terms, so that they are not taken away by a multiple of it. The Hamiltonian system "
        "is that of Theorem 9 and §7.4",
    ),
    Claim(
        "§12, problem 1, zero area",
        "Kozlov's problem was explicitly solved only in the special case when the integral of "
        "areas is zero and therefore these linear summands vanish.",
        without_area,
        note="it is decided that they vanish in this case, with and without Bruns' field; that "
        "only this case was solved is a statement about the literature, [106]. Here, too, the "
        "closed form in the field is for this case alone",
    ),
    Claim(
        "§12, problem 1, around a sphere",
        "In the Borisov–Fedorov problem linear gyroscopic terms arise again if the linear integral "
        "is different from zero.",
        around_sphere_linear,
        note="read as: for $k = -1$ the energy and $F_1$ have parts linear in $\\dot{\\mathbf n}$, "
        "with the factor $F_2$",
    ),
    Claim(
        "§12, problem 1",
        "The Borisov–Fedorov problem of a Chaplygin ball that rolls over a sphere can be "
        "generalised by adding a Bruns field.",
        around_a_sphere,
        note="read as: energy, the momentum integral, the linear integral of $k = -1$ and the "
        "invariant measure have counterparts in the field",
    ),
    Claim(
        "§12, problem 2",
        "Fedorov's system, a ball in a ball-type suspension, is integrable by the Euler–Jacobi "
        "theorem.",
        fedorov,
        note="equations derived here; in space the momentum is constant, so that with the energy "
        "four integrals and a measure are left for a motion in six dimensions",
    ),
    Claim(
        "§12, problem 2",
        "The motion of a Chaplygin ball along a straight line is integrable by the Euler–Jacobi "
        "theorem.",
        straight_line,
        note="equations derived here; two momenta and the energy are constant and a measure is "
        "invariant for a motion in five dimensions",
    ),
    Claim(
        "§12, problem 2, conformally Hamiltonian form",
        "They are only known to be integrable by the Euler–Jacobi theorem and therefore, "
        "theoretically, can be written in conformally Hamiltonian form.",
        therefore_conformally_hamiltonian,
        hamiltonian_near_tori,
        "They are known to be integrable by the Euler–Jacobi theorem and therefore, having more "
        "than one integral, can be written in Hamiltonian form, with a bracket of rank two, near "
        "every invariant torus at which the rotation number has a differential that is not zero, "
        "or is constant.",
        "the inference is Corollary 2, which fails for $n = 3$; near such a torus it is right for "
        "$n \\ge 4$, as here. (4.3) is Kolmogorov's theorem",
    ),
    Claim(
        "§12, problem 3",
        "Invariant measures for the multidimensional Chaplygin and Veselova systems are found.",
        measures_of_several_dimensions,
        note="for every operator of inertia; equations derived here",
        argument="for every n, by nonholonomic/docs/n-dimensions.md; computed is n = 4",
    ),
)

REMARKS = (
    Remark(
        "§12, problem 1",
        "No general methods exist for integrable systems on a sphere with such integrals.",
        "an opinion about the state of the field",
    ),
    Remark(
        "§12, problem 1",
        "Kozlov's problem and the Borisov–Fedorov problem are solved in quadratures where the "
        "linear integral vanishes.",
        "literature [68, 106]; the quadratures are not printed",
    ),
    Remark(
        "§12, problem 2",
        "No conformally Hamiltonian representation is known of either system.",
        "a statement about what is not known",
        findings=findings_of("2a", "lift"),
    ),
    Remark("Remark 25", "Explicit integration is a matter of tradition.", "a judgement"),
    Remark(
        "§12, after Remark 25",
        "It is open whether the Poisson structure can be lifted to the unreduced system.",
        "an open question",
        findings=findings_of("lift"),
    ),
    Remark(
        "§12, problem 3",
        "Existence of a Poisson structure and integrability of the four-dimensional Chaplygin ball "
        "cannot be stated with assurance.",
        "a statement about what is not known",
        findings=findings_of("3", "3, level"),
    ),
    Remark(
        "§12, problem 4",
        "Nothing is known of tensor invariants of a rolling body with a cavity filled with fluid.",
        "a statement about what is not known",
        findings=findings_of("4"),
    ),
)

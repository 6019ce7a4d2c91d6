"""§7.1: equations of motion and conservation laws of the Chaplygin ball."""

from __future__ import annotations

from functools import cache

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Measure
from flowlanes.system.system import System
from flowlanes.system.vector_operators import gradient, outer
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    identity,
    norm_squared,
    to_components,
    vectors,
)
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball import general_system
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import DET_J, D
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import conclusion_verdict, contrary
from ..methods.independence import independent, rational_point
from ..methods.tori import of_rank_two
from ..obstructions.unequal_periods import unequal_periods
from ..section_04.section_04_2 import equal_periods

M, omega, gamma, k = vectors("M omega gamma k")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
HALF = sp.Rational(1, 2)
U = sp.Function("U")(*gamma.symbols)
TORQUE = cross(gamma, gradient(U, gamma))
#: An erratum of (7.2) to (7.5).
MOVED = "(6.1), the Veselova system, is printed for (7.1)"


@cache
def ball() -> System:
    """The rolling ball in an unspecified potential, derived from mechanics."""
    return general_system()


@cache
def free_ball() -> System:
    """The rolling ball without a field."""
    return CATALOGUE["chaplygin-ball"].system()


def identity_of(name: str, *formulas: object) -> Identity:
    """The law that some formulas vanish."""
    return Identity(name, formulas)


# --- equations -----------------------------------------------------------------------------


def equations() -> Case:
    """(7.1)."""
    return ball(), identity_of(
        "equations",
        rate(M) - (cross(M, omega) + TORQUE),
        rate(gamma) - cross(gamma, omega),
    )


def momentum() -> Case:
    """M of (7.1)."""
    return ball(), identity_of("momentum", M - (I * omega + D * cross(gamma, cross(omega, gamma))))


def about_contact() -> Case:
    """M is the momentum about the point of contact: Iω + (R γ)×m v, v = ω×Rγ."""
    arm = sp.Symbol("R", real=True) * gamma
    moment = I * omega + sp.Symbol("m", real=True) * cross(arm, cross(omega, arm))
    return ball(), identity_of("about_contact", M - moment)


def tensor() -> Case:
    """I_Q = J − D γ⊗γ, J = I + D E, with M = I_Q ω."""
    return ball(), identity_of(
        "tensor",
        M - (J * omega - D * (outer(gamma, gamma) * omega)),
        to_components(J - (I + D * identity)),
    )


# --- conservation laws ---------------------------------------------------------------------


def energy() -> Case:
    """The energy in (7.2), for a marble and a rubber ball."""
    law = Integral("energy", HALF * dot(M, omega) + U)
    return ball(), law


def geometric() -> Case:
    """γ² of (7.2)."""
    law = Integral("geometric", norm_squared(gamma))
    return ball(), law


def area() -> Case:
    """(M, γ) of (7.2)."""
    return ball(), Integral("area", dot(M, gamma))


def measure() -> Case:
    """The density (7.3)."""
    tensor_Q = to_components(J - D * outer(gamma, gamma))
    return ball(), Measure("measure", {sp.Matrix(tensor_Q).det(): -HALF})


def determinant() -> Case:
    """det I_Q of (7.3)."""
    tensor_Q = sp.Matrix(to_components(J - D * outer(gamma, gamma)))
    return ball(), identity_of(
        "determinant", tensor_Q.det() - DET_J * (1 - D * dot(gamma, A * gamma))
    )


def square() -> Case:
    """(7.4)."""
    return free_ball(), Integral("momentum", norm_squared(M))


def euler_jacobi() -> Case:
    """H, γ², (M, γ), M² are independent on R^6."""
    system = free_ball()
    thirds = {f"gamma_{i}": sp.Rational(n, 3) for i, n in enumerate((1, 2, -2), 1)}
    point = rational_point(system, {"M_1": 3, "M_2": -1, "M_3": 2, **thirds})
    integrals = [dot(M, omega), norm_squared(gamma), dot(M, gamma), norm_squared(M)]
    return independent(system, integrals, point)


def bruns() -> Case:
    """The generalised integral in Bruns' field."""
    system = CATALOGUE["chaplygin-ball-bruns"].system()
    (law,) = (item for item in system.integrals if item.name == "momentum")
    return system, law


def gyrostat() -> Case:
    """The generalised integral with rotors."""
    return CATALOGUE["chaplygin-ball-gyrostat"].system(), Integral("momentum", norm_squared(M + k))


def periods_exclude_printed() -> Verdict:
    """A bracket of rank two near the torus on which the periods differ."""
    shown = "v∧∂/∂F₁ is a bracket of rank two near the torus with different periods"
    return contrary(conclusion_verdict("no form", shown, (unequal_periods(), *of_rank_two())))


def periods_exclude() -> Verdict:
    """Proposition 4 contradicted by the periods, and the bracket of rank two."""
    shown = f"{unequal_periods().finding}; Proposition 4 would make them equal"
    shifts = tuple(prove(system, law) for system, law in equal_periods())
    return conclusion_verdict(
        "no form of rank four", shown, (unequal_periods(), *shifts, *of_rank_two())
    )


CLAIMS = (
    Claim(
        "(7.1)",
        r"$\dot{M} = M \times \omega + \gamma \times \frac{\partial U}{\partial \gamma}$, "
        r"$\dot{\gamma} = \gamma \times \omega$",
        equations,
    ),
    Claim(
        "(7.1), M",
        r"$M = I\omega + D\gamma \times (\omega \times \gamma) = I_Q\omega$, $D = mR^2$",
        momentum,
    ),
    Claim(
        "§7.1, after (7.1)",
        "The vector M is the ball's angular momentum with respect to the point of contact.",
        about_contact,
    ),
    Claim(
        "§7.1, I_Q",
        r"$I_Q = J - D\gamma \otimes \gamma$, $J = I + DE$",
        tensor,
    ),
    Claim(
        "(7.2), energy",
        r"Equations (6.1) (with an arbitrary potential) admit the integral of energy $H = "
        r"\frac{1}{2}(M, \omega) + U(\gamma)$.",
        energy,
        erratum=MOVED,
    ),
    Claim(
        "(7.2), geometric integral",
        r"Equations (6.1) (with an arbitrary potential) admit the geometric integral "
        r"$(\gamma, \gamma) = 1$.",
        geometric,
        erratum=MOVED,
    ),
    Claim(
        "(7.2), area integral",
        r"Equations (6.1) (with an arbitrary potential) admit the integral of areas "
        r"$(M, \gamma) = c = $ const.",
        area,
        erratum=MOVED,
    ),
    Claim(
        "(7.3), measure",
        r"They preserve $\rho_\mu d^3M d^3\gamma$ with $\rho_\mu = (\det I_Q)^{-1/2}$.",
        measure,
        erratum=MOVED,
    ),
    Claim(
        "(7.3), determinant",
        r"$(\det I_Q)^{-1/2} = [\det J (1 - D(\gamma, J^{-1}\gamma))]^{-1/2}$",
        determinant,
    ),
    Claim(
        "(7.4)",
        r"If there is no external field ($U = 0$), the system (6.1) has an additional integral "
        r"$F = (M, M)$.",
        square,
        erratum=MOVED,
    ),
    Claim(
        "§7.1, after (7.4)",
        "With U = 0 it is integrable by the Euler–Jacobi theorem: an invariant measure and n − 2 "
        "independent integrals on the phase space of dimension n = 6.",
        euler_jacobi,
    ),
    Claim(
        "Remark 20, Bruns",
        r"The integral (7.4) can be generalised to the Bruns field "
        r"$U(\gamma) = \frac{k}{2}(\gamma, I\gamma)$.",
        bruns,
        note=r"the integral is $M^2 - k \det J (\gamma, J^{-1}\gamma)$",
    ),
    Claim(
        "Remark 20, gyrostat",
        "The integral (7.4) can be generalised to the gyrostat.",
        gyrostat,
        note=r"the integral is $(M + k)^2$, with the equations of §7.4",
    ),
    Claim(
        "Remark 21, periods",
        "The periods of motion for the orbits lying on the two-dimensional invariant resonance "
        "tori are not the same.",
        unequal_periods,
        note="by rigorous bounds: one angle of the torus turns twice while the other turns once, "
        "and two of its closed motions have the periods 21.76 and 21.81 for $2H = 1$",
        where=(
            "I = diag(0.2, 2, 2.1) and D = 5",
            "the torus is that with (M, γ) = 0 that the note names",
        ),
    ),
    Claim(
        "Remark 21, Hamiltonian form",
        "In [46], the authors showed numerically that without a time substitution, the equations "
        "of motion of the Chaplygin ball are not Hamiltonian because the periods of motion for the "
        "orbits lying on the two-dimensional invariant resonance tori are not the same.",
        periods_exclude_printed,
        periods_exclude,
        "Near a resonant torus on which the periods differ the equations have, without a time "
        "substitution, no Hamiltonian form whose bracket has rank four and makes the integrals "
        "commute; a Hamiltonian form of rank two they do have there.",
        "(3.5) admits brackets of any rank, such as (3.8) of rank two, and different periods do "
        "not exclude one: near this torus, where the rotation number has a differential that is "
        "not zero, $v\\wedge\\partial/\\partial F_1$ is one, with $F_1$ as Hamiltonian and the "
        "rotation number as Casimir function. Whether there is one on the whole phase space is "
        "not decided",
    ),
)

REMARKS = (
    Remark(
        "§7.1, after (7.4)",
        "The solution was given in hyperelliptic functions; qualitative analysis and stability "
        "were studied elsewhere.",
        "literature",
    ),
    Remark(
        "Remark 20",
        "Other integrable potentials at zero area constant can be found on e(3).",
        "no potential is stated",
    ),
    Remark(
        "Remark 21",
        "History of the Hamiltonisation of the Chaplygin ball.",
        "history; what is said of periods and of the Hamiltonian form is judged above, the form "
        "after a change of time with (7.5)",
    ),
)

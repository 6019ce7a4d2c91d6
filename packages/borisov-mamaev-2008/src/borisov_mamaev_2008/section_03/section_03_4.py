"""§3.4: Casimir functions, canonical form."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Identity, Law, PoissonStructure, Rate
from flowlanes.system.system import System
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import CATALOGUE

from ..claim import Case, Claim, Remark
from ..methods.any_number import any_number
from ..methods.catalogue_laws import laws_named
from ..methods.derived_verdicts import computed_verdict
from ..methods.unspecified_systems import gradient, hamiltonian, skew, system, unspecified_functions

x = sp.symbols("x_1:4", real=True)
J = skew(x)
Phi, H, N, f = unspecified_functions("Phi H N f", *x)

# --- Casimir functions ---------------------------------------------------------------------


def _along_kernel(function: sp.Expr) -> sp.Expr:
    """(∇function, J∇Φ), which vanishes for a Casimir function Φ."""
    return (gradient(function, x).T * J * gradient(Phi, x))[0, 0]


def casimir_is_integral() -> Case:
    """Φ̇ = −N (∇H, J∇Φ) for any Φ, so that Φ̇ = N{Φ, H} = 0 for a Casimir function."""
    return hamiltonian(J, H, x, N), Identity("rate", Rate(Phi) + N * _along_kernel(H))


def gradient_in_kernel() -> Case:
    """{x_i, Φ} are the components of J∇Φ, and {f, Φ} = (∇f, J∇Φ)."""
    components = J * gradient(Phi, x)
    product = sp.Add(*(sp.diff(f, s) * part for s, part in zip(x, components, strict=True)))
    return hamiltonian(J, H, x), Identity("kernel", product - _along_kernel(f))


# --- Darboux -------------------------------------------------------------------------------

DARBOUX = sp.symbols("q_1 q_2 p_1 p_2 z_1 z_2", real=True)


def _darboux(pairs: sp.Matrix, among_z: int) -> tuple[System, PoissonStructure]:
    """{q_i, p_j} as given, {z_1, z_2} = `among_z`, all other brackets zero."""
    turn = among_z * sp.Matrix([[0, 1], [-1, 0]])
    matrix = sp.diag(sp.zeros(4), turn)
    matrix[0:2, 2:4], matrix[2:4, 0:2] = pairs, -pairs.T
    dynamics = hamiltonian(matrix, unspecified_functions("H", *DARBOUX)[0], DARBOUX)
    law = PoissonStructure("darboux", matrix, casimirs=DARBOUX[4:], rank=4)
    return dynamics, law


def pairs_printed() -> Case:
    """{q_i, p_i} = 1, where {q_1, p_2} = {q_2, p_1} = 1 is not excluded: the rank is then 2."""
    return _darboux(sp.ones(2), 0)


def casimirs_printed() -> Case:
    """{z_1, z_2} = 1 is not excluded: then z_1 and z_2 are not Casimir functions."""
    return _darboux(sp.eye(2), 1)


def darboux() -> Case:
    """The canonical bracket, with two Casimir functions."""
    return _darboux(sp.eye(2), 0)


def local_casimirs() -> Case:
    """Rank two in dimension five, and three Casimir functions, near a regular point of (3.8)."""
    return laws_named(CATALOGUE["suslov-bracket"].system(), "bracket", "third_casimir")


def canonical_form() -> Case:
    """Check that q̇ = N ∂H/∂p, ṗ = −N ∂H/∂q is conformally Hamiltonian in the canonical bracket.

    For two degrees of freedom.
    """
    state = DARBOUX[:4]
    one, nothing = sp.eye(2), sp.zeros(2)
    matrix = nothing.row_join(one).col_join((-one).row_join(nothing))
    energy, multiplier = unspecified_functions("H N", *state)
    q_1, q_2, p1, p2 = state
    field = {
        q_1: multiplier * sp.diff(energy, p1),
        q_2: multiplier * sp.diff(energy, p2),
        p1: -multiplier * sp.diff(energy, q_1),
        p2: -multiplier * sp.diff(energy, q_2),
    }
    structure = PoissonStructure("canonical", matrix, rank=4)
    form = ConformallyHamiltonian("form", multiplier, structure, energy)
    return system("canonical", "q̇ = N ∂H/∂p, ṗ = −N ∂H/∂q", field), form


def _top(names: tuple[str, ...]) -> tuple[tuple[System, Law], ...]:
    return laws_named(CATALOGUE["lagrange-top"].system(), *names)


def additional_corrected() -> Case:
    """The Lagrange top: leaves of dimension four, one integral in addition to H, quadratures."""
    return _top(("bracket", "energy", "spin", "nutation", "intrinsic_rotation"))


def additional_printed() -> Verdict:
    """The claim that n = 2 integrals in addition to H are necessary; the Lagrange top has one.

    Three independent functions in involution cannot exist on a symplectic leaf of dimension four.
    """
    verdicts = [prove(*case) for case in _top(("bracket", "spin", "nutation"))]
    decided = all(verdicts)
    return computed_verdict(
        "additional",
        decided,
        "the Lagrange top, on leaves of dimension four, is integrated with one integral "
        "besides the Hamiltonian",
        "the laws of the Lagrange top are not proven",
        decision="refuted",
        witness={"n": 2, "additional integrals": 1} if decided else None,
    )


BLOCKS = "the matrix of any number of pairs is made of the same blocks"

CLAIMS = (
    Claim(
        "§3.4, Casimir functions",
        "A Casimir function is an integral of the system (3.7)",
        casimir_is_integral,
        argument=any_number(2),
    ),
    Claim(
        "§3.4, kernel",
        r"$\nabla\Phi_\alpha(\mathbf{x})$ lies in the kernel of the Poisson structure "
        r"$\mathbf{J}(\mathbf{x})$",
        gradient_in_kernel,
        argument=any_number(2),
    ),
    Claim(
        "Theorem 2, pairs",
        r"$\{q_i, p_i\} = \delta_{ij}$, $\{q_i, q_j\} = \{p_i, p_j\} = 0$, with symplectic leaves "
        "on which the structure is non-degenerate",
        pairs_printed,
        darboux,
        r"$\{q_i, p_j\} = \delta_{ij}$",
        "an index: as printed, {q₁, p₂} is not determined and the rank may be lower",
        argument=BLOCKS,
    ),
    Claim(
        "Theorem 2, Casimir functions",
        r"From $\{z_\alpha, q_i\} = \{z_\alpha, p_i\} = 0$ it follows that $z_\alpha$ are locally "
        "defined Casimir functions",
        casimirs_printed,
        darboux,
        r"$\{z_\alpha, q_i\} = \{z_\alpha, p_i\} = \{z_\alpha, z_\beta\} = 0$",
        "the brackets of the z with each other are missing",
        argument=BLOCKS,
    ),
    Claim(
        "Remark 9",
        r"The number of local Casimir functions near $\mathbf{x}_0$ is the dimension of the kernel "
        r"of $\mathbf{J}(\mathbf{x}_0)$",
        local_casimirs,
        note="z_α are those of Theorem 2, which has the rank constant; for (3.8): three",
        argument="Theorem 2 has as many functions z as the kernel has dimensions",
    ),
    Claim(
        "§3.4, canonical form",
        r"$\dot{\mathbf{q}} = N_c\,\partial H_c/\partial\mathbf{p}$, "
        r"$\dot{\mathbf{p}} = -N_c\,\partial H_c/\partial\mathbf{q}$ is (3.7) in the canonical "
        "bracket",
        canonical_form,
        argument=any_number(2),
    ),
    Claim(
        "§3.4, first situation",
        r"For the system to be integrable the existence of "
        r"$n = \frac12\dim\mathcal{M}_c$ additional first integrals is necessary",
        additional_printed,
        additional_corrected,
        r"$\frac12\dim\mathcal{M}_c - 1$ first integrals besides the Hamiltonian, in involution "
        "with it and with each other, are sufficient",
        "the Hamiltonian is one of the n; “additional” is read as besides it and the Casimir "
        "functions",
        argument="that so many independent ones are sufficient is Liouville's theorem; computed is "
        "the Lagrange top",
    ),
)

REMARKS = (
    Remark(
        "§3.4, beginning",
        "Most nonholonomic systems possess a degenerate Poisson structure",
        "judgement",
    ),
    Remark(
        "Theorem 2",
        "The generalized Darboux theorem",
        "a quoted theorem; its formulas are claims",
    ),
    Remark(
        "§3.4, first situation",
        "The two numbers of Casimir functions are equal in most applications; then a symplectic "
        "leaf is a manifold given by the Casimir functions, and integrability is proved by the "
        "Liouville–Arnold theorem",
        "a definition and quoted theorems; the canonical form and the number of integrals are "
        "claims",
    ),
    Remark(
        "§3.4, second situation",
        "This case is not discussed in the literature; the problem will be considered in "
        "subsequent papers",
        "literature",
    ),
)

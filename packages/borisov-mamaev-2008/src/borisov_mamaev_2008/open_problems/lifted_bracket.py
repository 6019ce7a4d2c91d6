"""Exact test whether the Poisson bracket of a rolling ball lifts to its full attitude.

A ball in a ball bearing has the momentum M = Bω, B = I + tr P − P, P = Σ D a⊗a over the directions
a of its supports, which are fixed in space; the Chaplygin ball is the case P = D γ⊗γ. A lifted
bracket would give a conformally Hamiltonian form v = N {·, E} in which functions of the attitude
commute and {M_i, a_j} depends only on the attitude. From ȧ = a×ω it follows that {L_i, a_j} =
ε_ijk a_k with L = NM, from the Jacobi identity that {L_i, L_j} = ε_ijk (L_k + w_k) with a function
w of the attitude, and from Ṁ = M×ω that

    (M, ω) Θ − (Θ, ω) M = w×ω/N + Σ a×∂E/∂a    for every M,    Θ = Σ a×∂ ln N/∂a.

These equations are linear in Θ and w/N. At an attitude with rational entries they are solved or
shown to have no solution; the proof for every attitude and body is in docs/open-problems.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.vectors import Diagonal, to_components
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue.chaplygin_ball.ball_bearing import SUPPORTS, alpha, beta, gamma, tensor

from ..methods.derived_verdicts import computed_verdict

#: An attitude whose rows α, β, γ in body axes are orthonormal.
ATTITUDE = sp.Matrix([[6, 2, -3], [3, -6, 2], [-2, -3, -6]]) / 7
MOMENTA = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, 1, 1), (1, 0, 1), (1, 2, 3))
MOMENTS = (Fraction(1), Fraction(3, 2), Fraction(21, 10))

WEIGHTS: dict[str, tuple[Fraction | int, ...]] = {
    "Chaplygin ball, D = 1": (0, 0, 1),
    "two supporting balls, D = ½, ⅓": (Fraction(1, 2), Fraction(1, 3), 0),
    "two equal supporting balls": (Fraction(1, 2), Fraction(1, 2), 0),
    "three different supporting balls": (Fraction(4, 5), Fraction(1, 2), Fraction(3, 10)),
    "three equal supporting balls": (Fraction(1, 2), Fraction(1, 2), Fraction(1, 2)),
}


def unknowns(moments: Sequence[Fraction], weights: Sequence[Fraction | int]) -> sp.Matrix:
    """The equations at :data:`ATTITUDE` as a rational augmented matrix in Θ and w/N.

    Parameters
    ----------
    moments : 3 rational numbers
        Principal moments of inertia.
    weights : 3 rational numbers
        D of the supporting balls in the orthonormal directions α, β, γ.
    """
    values = dict(zip(Diagonal("I").symbols, map(sp.Rational, moments), strict=True))
    values |= {
        weight: sp.Rational(value) for (weight, _), value in zip(SUPPORTS, weights, strict=True)
    }
    inertia = to_components(tensor()).xreplace(values)
    axes: tuple[MatrixExpr, ...] = (alpha, beta, gamma)
    here = {
        symbol: ATTITUDE[row, column]
        for row, axis in enumerate(axes)
        for column, symbol in enumerate(axis.symbols)
    }
    inverse = inertia.xreplace(here).inv()
    rows = []
    for momentum in map(sp.Matrix, MOMENTA):
        spin = inverse * momentum
        torque = sp.zeros(3, 1)
        for axis in axes:
            # ∂(½(M, B⁻¹M))/∂a = −½(ω, ∂B/∂a ω), since ∂B⁻¹ = −B⁻¹ ∂B B⁻¹.
            slope = sp.Matrix(
                [-(spin.T * inertia.diff(s).xreplace(here) * spin)[0] / 2 for s in axis.symbols]
            )
            torque += sp.Matrix([here[s] for s in axis.symbols]).cross(slope)
        twist = momentum.dot(spin) * sp.eye(3) - momentum * spin.T
        rows.append(twist.row_join(spin.hat()).row_join(torque))
    return sp.Matrix.vstack(*rows)


def lifts(moments: Sequence[Fraction], weights: Sequence[Fraction | int]) -> bool:
    """True if the equations have a solution at :data:`ATTITUDE`; if not, no bracket lifts.

    Examples
    --------
    >>> from fractions import Fraction
    >>> from borisov_mamaev_2008.open_problems.lifted_bracket import lifts
    >>> lifts((Fraction(1), Fraction(3, 2), Fraction(2)), (0, 0, 1))
    False
    """
    equations = unknowns(moments, weights)
    return bool(equations.rank() == equations[:, :-1].rank())


def of_cotangent_type() -> Verdict:
    """The verdict on such a bracket for the Chaplygin ball and for balls in a ball bearing."""
    refuted = not any(lifts(MOMENTS, w) for w in WEIGHTS.values() if len(set(w)) > 1)
    return computed_verdict(
        "bracket",
        refuted,
        "the equations for Θ and w have no solution at a rational attitude, for the Chaplygin ball "
        "and for two and three supporting balls",
        "the equations have a solution at the attitude tried",
        decision="refuted",
        witness={"attitude": str(ATTITUDE.tolist()), "moments": ", ".join(map(str, MOMENTS))},
    )

"""The rubber ball of n dimensions on a sphere of its own radius: Hamiltonian for every inertia.

With ε = a/(R + a) = 1/2 the equations of :mod:`nonholonomic.catalogue.so_n_systems.ball_on_sphere`
are

    ṗ = (u, p)γ + ku/2,    γ̇ = −u/2,    k = I(u∧γ),    p = kγ,

I the operator with m R² added.  The energy is E = (p, u)/2 = ⟨k, u∧γ⟩/2, so that ∂E/∂p = u and, at
fixed p, ∂E/∂γ = −∂/∂γ ⟨I(u∧γ), u∧γ⟩/2 at fixed u, which is ku.  In the canonical bracket of the
sphere for q = −2p,

    {γᵢ, pⱼ} = −(δᵢⱼ − γᵢγⱼ)/2,    {pᵢ, pⱼ} = −(pᵢγⱼ − pⱼγᵢ)/2,

these are the equations of motion, as (u, γ) = 0 and (γ, ku) = −(p, u): the geodesics of the metric
⟨I(γ̇∧γ), γ̇∧γ⟩, in the time t itself.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Identity, PoissonStructure
from flowlanes.system.matrices import Column
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Components, dot, norm_squared, real_symbol

from .any_inertia import above, named_operator, operator_of_planes, parameters_of, skew
from .entry_of_dimension import SOURCE, R
from .inertia import pairs
from .motion_in_space import gamma_of, unit_length

HALF = sp.Rational(1, 2)
a = real_symbol("a")


def bracket(p: Column) -> PoissonStructure:
    """The canonical bracket of the sphere for −2p and γ, in p and γ."""
    n = int(p.shape[0])
    gamma = gamma_of(n)
    x, y = sp.Matrix(p.symbols), sp.Matrix(gamma.symbols)
    corner = -HALF * (sp.eye(n) - y * y.T)
    top = -HALF * (x * y.T - y * x.T)
    return PoissonStructure(
        "bracket",
        sp.ImmutableDenseMatrix(top.row_join(-corner.T).col_join(corner.row_join(sp.zeros(n)))),
        casimirs=(norm_squared(gamma), dot(p, gamma)),
        rank=2 * n - 2,
        meaning="canonical bracket of the sphere for −2p and γ",
        source=SOURCE,
    )


def hamiltonian(p: Column, energy: sp.Expr) -> ConformallyHamiltonian:
    """The form of the equations on a sphere of the ball's own radius."""
    return ConformallyHamiltonian(
        "hamiltonian",
        sp.S.One,
        bracket(p),
        energy,
        "Hamiltonian form on a sphere of the ball's own radius",
        level=(a - R,),
        source=SOURCE,
    )


def identities(n: int) -> tuple[System, System]:
    """The identities that remain to be proven: the equations, and that of Jacobi.

    Parameters
    ----------
    n : int
        The dimension of space.

    Returns
    -------
    tuple of System
        Of the first u, γ and the entries of a symmetric operator I on so(n) are independent.
    """
    u, p, gamma = Column("u", n), Column("p", n), gamma_of(n)
    inertia = named_operator("I", len(pairs(n)))
    x, y = (sp.Matrix(name.entries) for name in (u, gamma))
    k = skew(n, inertia * sp.Matrix(above(x * y.T - y * x.T)))
    momentum = k * y
    B = operator_of_planes(inertia, y)
    # ∂E/∂γ at fixed p, what vanishes with (u, γ) in B left out
    slope = sp.Matrix(
        [-HALF * (x.T * B.diff(s) * x)[0] + x[i] * (x.T * y)[0] for i, s in enumerate(y)]
    )
    matrix = sp.Matrix(bracket(p).matrix).xreplace(dict(zip(p.symbols, momentum, strict=True)))
    rates = matrix * sp.Matrix([*x, *slope])
    wanted = [*((x.T * momentum)[0] * y + HALF * k * x), *(-HALF * x)]
    still = Components.zeros(n, 1)
    equations = System(
        name="rubber-ball-geodesics",
        title=f"The rubber ball on a sphere of its own radius in {n} dimensions",
        field={u: still, gamma: still},
        parameters=parameters_of(inertia, "entry of the operator of inertia"),
        relations=(unit_length(gamma), (x.T * y)[0]),
        laws=(
            Identity(
                "hamiltonian",
                tuple(r - w for r, w in zip(rates, wanted, strict=True)),
                "the equations are those of the bracket",
                source=SOURCE,
            ),
        ),
    )
    sphere = System(
        name="cotangent-bundle-of-sphere",
        title=f"The bracket of the sphere in {n} dimensions",
        field={p: still, gamma: still},
        parameters=(Parameter(R, "radius of the ball", 1.0, "m", (R > 0,)),),
        relations=(unit_length(gamma), sp.Add(*(b * c for b, c in zip(p, gamma, strict=True)))),
        laws=(bracket(p),),
    )
    return equations, sphere

"""Bodies about a fixed point that hold fluid: free, of Veselova's system, of Suslov's problem.

The fluid in a cavity acts on the equivalent body (docs/fluid.md), whose inertia about the fixed
point is I, as a gyrostat with the momentum CN.  In body axes, with a torque λ₀n of the constraint
(ω, n) = 0, n = γ or e₃,

    Iω̇ = Iω×ω + ΣCN×ω − ΣCṄ + λ₀n,    γ̇ = γ×ω,    Ṅ = ξ×N,    ξ = WN − Cω,

and for a free body Ṁ = M×ω with ω = I⁻¹(M − ΣCN).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, PoissonStructure
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import hat, unit_vector
from flowlanes.system.vectors import (
    Components,
    Diagonal,
    Symmetric,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
    zero,
)

from ...mechanics.conventions import BodyConventions
from ...mechanics.rolling.cavity import Cavity
from ...mechanics.rolling.fluid import Fluid, fluids_of_cavities
from .. import e3
from ..fluid_laws import SOURCE, SPIN, SQUARE, laws_of_sphere

omega, gamma, M, X, omegadot = vectors("omega gamma M X omegadot")
lambda_0 = real_symbol("lambda_0")
HALF = sp.Rational(1, 2)

#: The normal n of the constraint by the name of the system; none for a free body.
NORMALS: dict[str, MatrixExpr | None] = {
    "free-body": None,
    "veselova": gamma,
    "suslov": unit_vector(3),
}


def with_fluid(system: System, cavities: Sequence[Cavity]) -> System:
    """A body about a fixed point with fluid in cavities.

    Parameters
    ----------
    system : System
        ``free-body``, ``veselova`` or ``suslov``.
    cavities : sequence of Cavity
        Their centres are measured from the fixed point.

    Raises
    ------
    InputError
        If the system is another one.

    Examples
    --------
    >>> import nonholonomic
    >>> cavity = nonholonomic.Cavity(
    ...     (0.5, 0.4, 0.3), mass=2.0, turn=(1, 0.2, 0, 0), centre=(0, 0.1, 0.3)
    ... )
    >>> with_fluid(nonholonomic.from_catalogue("veselova"), [cavity]).state
    (omega, gamma, N)
    """
    fluids = fluids_of_cavities(cavities)
    if not fluids:
        return system
    if system.name not in NORMALS:
        raise InputError(f"cavity: {refusal(system.name)}")
    tensor = _inertia(system, [fluid.cavity for fluid in fluids])
    I = Diagonal("I") if tensor.is_diagonal() else Symmetric("I")
    A = type(I)("A")
    momentum = sum((fluid.momentum for fluid in fluids), zero)
    energy = sum(fluid.energy for fluid in fluids)
    normal = NORMALS[system.name]
    motion = [pair for fluid in fluids for pair in fluid.motion]
    circulations = [fluid.circulation for fluid in fluids]
    definitions: Pairs
    laws: list[Law]
    if normal is None:
        definitions = ((A, I**-1), (omega, A * (M - momentum)), *motion)
        field = {M: cross(M, omega)}
        whole = HALF * dot(M - momentum, omega) + energy
        start = [(M, I * omega + sum((f.C * f.initial for f in fluids), zero))]
        laws = [_energy(whole), *circulations, *_of_free_body(fluids, whole)]
    else:
        torque = cross(I * omega, omega) + cross(momentum, omega)
        torque -= sum((fluid.C * fluid.rate for fluid in fluids), zero)
        definitions = (
            *motion,
            (A, I**-1),
            (X, torque),
            (lambda_0, -dot(A * normal, X) / dot(A * normal, normal)),
            (omegadot, A * (X + lambda_0 * normal)),
        )
        field = {omega: omegadot}
        whole = HALF * dot(I * omega, omega) + energy
        start = []
        laws = [_energy(whole), *circulations, *_of_constraint(normal, I, A, momentum)]
    for fluid in fluids:
        if len(set(fluid.cavity.axes)) == 1:
            laws += laws_of_sphere(fluid, plane=True, momentum_fixed=normal is None)
    several = len(cavities) > 1
    return replace(
        system,
        title=f"{system.title} with fluid",
        summary=f"{system.summary} It is full of fluid in "
        f"{'ellipsoidal cavities' if several else 'an ellipsoidal cavity'}.",
        field={**field, gamma: cross(gamma, omega), **{f.N: f.rate for f in fluids}},
        definitions=definitions,
        parameters=(*_moments(I, tensor), *(p for f in fluids for p in f.parameters)),
        laws=tuple(laws),
        observables=(*system.observables, *(fluid.observable for fluid in fluids)),
        conventions=BodyConventions((*start, *((fluid.N, fluid.initial) for fluid in fluids))),
    )


def refusal(name: str) -> str:
    """Why a system of the catalogue holds no fluid."""
    *others, last = NORMALS
    return f"{name} cannot hold fluid; a rolling body, {', '.join(others)} and {last} can"


def _inertia(system: System, cavities: Sequence[Cavity]) -> sp.Matrix:
    """The tensor of the equivalent body about the fixed point, in rational numbers."""
    numbers = {str(s): exact_number(value) for s, value in system.defaults.items()}
    inertia = sp.diag(*(numbers[f"I_{i}"] for i in (1, 2, 3)))
    for i in (0, 1):
        inertia[i, 2] = inertia[2, i] = numbers.get(f"I_{i + 1}3", sp.S.Zero)
    for cavity in cavities:
        arm = sp.Matrix([exact_number(x) for x in cavity.centre])
        steiner = arm.dot(arm) * sp.eye(3) - arm * arm.T
        inertia += cavity.equivalent_inertia + exact_number(cavity.mass) * steiner
    return inertia


def _moments(I: Diagonal | Symmetric, tensor: sp.Matrix) -> list[Parameter]:
    """The entries of I, with their numbers."""
    diagonal = tuple(I.entries.diagonal())
    entries = I.independent(np.array(tensor.tolist(), dtype=float))
    return [
        Parameter(
            s,
            f"entry {str(s)[2:]} of the equivalent inertia about the fixed point",
            float(value),
            "kg m^2",
            (s > 0,) if s in diagonal else (),
        )
        for s, value in zip(I.symbols, entries, strict=True)
    ]


def _energy(value: sp.Expr) -> Integral:
    return Integral("energy", value, "energy", source=SOURCE, unit="J")


def _of_constraint(
    normal: MatrixExpr, I: Diagonal | Symmetric, A: Diagonal | Symmetric, momentum: MatrixExpr
) -> list[Law]:
    """Integrals of Veselova's system and Suslov's problem besides energy and circulations."""
    if normal == gamma:
        square = norm_squared(cross(I * omega + momentum, gamma))
        meaning = "square of the horizontal momentum"
        return [
            Integral("momentum", square, meaning, source=SOURCE, unit=SQUARE),
            Measure(
                "measure",
                {dot(gamma, A * gamma): HALF},
                "invariant measure in ω, γ, N",
                source=SOURCE,
            ),
        ]
    products = (I.entries[0, 2], I.entries[1, 2])
    return [
        Measure(
            "volume",
            {sp.S.One: sp.S.One},
            "volume of ω, γ, N, when the axis without rotation is a principal axis",
            level=tuple(s for s in products if s != 0),
            source=SOURCE,
        )
    ]


def _of_free_body(fluids: Sequence[Fluid], energy: sp.Expr) -> list[Law]:
    """Integrals and Hamiltonian form of a free body."""
    circulations = [norm_squared(fluid.N) for fluid in fluids]
    blocks = [e3.lie_poisson(M, gamma), *(-hat(fluid.N) for fluid in fluids)]
    structure = PoissonStructure(
        "bracket",
        Components(sp.diag(*blocks)),
        casimirs=(norm_squared(gamma), dot(M, gamma), *circulations),
        rank=4 + 2 * len(fluids),
        meaning="bracket of e(3), with {N_i, N_j} = ε_ijk N_k",
        source=SOURCE,
    )
    return [
        Integral("area", dot(M, gamma), "area integral", source=SOURCE, unit=SPIN),
        Integral("momentum", norm_squared(M), "square of the momentum", source=SOURCE, unit=SQUARE),
        Measure("volume", {sp.S.One: sp.S.One}, "volume of M, γ, N", source=SOURCE),
        structure,
        ConformallyHamiltonian(
            "hamiltonian", sp.S.One, structure, energy, "Hamiltonian form", source=SOURCE
        ),
    ]

"""The 1-form of a rolling body that must be exact for an invariant measure to exist.

A density e^σ over the momenta of the admissible velocities and the normal γ gives an invariant
measure if and only if dσ = θ.  For a rubber body θ = (Θ, dγ) with

    Θ = (1 − tr K) (E + W/a) Ĩ⁻¹γ / (γ, Ĩ⁻¹γ)   across γ,      tr K = 2 and W/a = 0 on a plane,

and for a marble body, with A = Ĩ⁻¹, V = WK and τ = Σ (A e_i, V(γ×e_i)),

    Θ = −m { W(Ar − r tr A) − (E + W/a)(γ×A(γ×V r) + τ γ×r) },

provided that spinning about the normal, which leaves γ fixed, does not change the volume either:

    (γ×V r, Aγ) + (γ, r) τ = 0.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Identity, Law, Measure, Rate
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    zero,
)

from ..mechanics.rolling.equations import RollingBody
from .shape_geometry import geometry

#: Bases with exponents.
Powers = tuple[tuple[sp.Expr, sp.Expr], ...]

gamma, r, gammatilde, theta, turn = (
    Vector(name) for name in ("gamma", "r", "gammatilde", "Theta", "u")
)
m, a = real_symbol("m"), real_symbol("a")


@dataclass(frozen=True)
class OneForm:
    """The 1-form θ = (Θ, dγ), and the conditions for an invariant measure to exist.

    Attributes
    ----------
    system : System
        An auxiliary system on the normals, whose field is divergence-free if and only if θ is
        closed.
    form : Vector
        Θ, a definition of `system`.
    scale : sympy.Expr
        A constant factor of θ, in the parameters.
    spin : Identity, optional
        The condition that spinning of a marble body preserves the volume.
    closed : Measure
        The law dθ = 0.
    period : Identity
        The law that θ vanishes on rotations about body axis 3; a closed θ is then exact also on the
        sphere without its poles.
    """

    system: System
    form: Vector
    scale: sp.Expr
    spin: Identity | None
    closed: Measure
    period: Identity

    def density_law(self, powers: Powers) -> tuple[System, Identity]:
        """The law dσ = θ, for a product of powers e^σ, along every rotation u of the normal.

        Parameters
        ----------
        powers : Powers
            Bases with exponents, in the definitions of `system`.
        """
        system = replace(
            self.system,
            name="turned-normal",
            field=((self.system.field[0][0], cross(gamma, turn)), (turn, zero)),
        )
        slope = sp.Add(*(exponent * Rate(base) / base for base, exponent in powers))
        along = sp.Add(
            *(t * Rate(g) for t, g in zip(self.form.symbols, gamma.symbols, strict=True))
        )
        return system, Identity("integrated", along - slope, "the density has the 1-form")

    @property
    def conditions(self) -> tuple[Law, ...]:
        """The laws to be proved."""
        return (self.closed,) if self.spin is None else (self.spin, self.closed)


def one_form(rolling: RollingBody) -> OneForm:
    """The 1-form of a body that rolls on a plane or a sphere, marble or rubber."""
    body = rolling.body
    here = geometry(body.shape, rolling.surface)
    inertia = Diagonal("I") if body.principal else Symmetric("I")
    J, A = type(inertia)("J"), type(inertia)("A")
    lever, share = Vector("l"), real_symbol("s_r")
    parameters = (
        Parameter(m, "mass", body.mass, "kg", (m > 0,)),
        *(
            Parameter(s, "entry of the inertia tensor", float(value), "kg m^2")
            for s, value in zip(inertia.symbols, inertia.independent(body.tensor), strict=True)
        ),
        *here.parameters,
    )
    definitions: Pairs = (
        *here.definitions,
        (J, inertia + m * norm_squared(r) * identity),
        (A, J**-1),
        (lever, A * r),
        # Ĩ = J − m r rᵀ, whose inverse is A + s_r A r (A r)ᵀ.
        (share, m / (1 - m * dot(r, lever))),
    )

    def inverse(vector: MatrixExpr) -> MatrixExpr:
        """Ĩ⁻¹ by the Sherman–Morrison formula."""
        return A * vector + share * dot(lever, vector) * lever

    spin = None
    if rolling.contact == "rubber":
        definitions += ((gammatilde, inverse(gamma)),)
        form = (1 - here.trace) / dot(gamma, gammatilde) * here.stretch(gammatilde)
    else:
        trace = sp.Add(*(A.entries[i, i] for i in range(3))) + share * norm_squared(lever)
        tau, wander = real_symbol("tau_A"), Vector("V_r")
        short, columns = Vector("K_r"), [Vector(f"K_{i}") for i in (1, 2, 3)]
        units = [unit_vector(i) for i in (1, 2, 3)]
        twists = [
            dot(inverse(unit), here.spread(column))
            for unit, column in zip(units, columns, strict=True)
        ]
        definitions += (
            (short, here.contract(r)),
            *((c, here.contract(cross(gamma, e))) for c, e in zip(columns, units, strict=True)),
            (wander, here.spread(short)),
            # Σ (A e_i, V(γ×e_i)), the trace of AVγ×
            (tau, sp.Add(*twists)),
        )
        turned = cross(gamma, inverse(cross(gamma, wander))) + tau * cross(gamma, r)
        form = -m * (here.spread(inverse(r) - trace * r) - here.stretch(turned))
        value = dot(cross(gamma, wander), inverse(gamma)) + dot(gamma, r) * tau
        spin = Identity("spin", value, "spinning about the normal keeps the volume")
    definitions += ((theta, form),)
    # the field γ×Θ on the sphere has the divergence of the 2-form dθ over the area element
    system = System(
        name="one-form",
        title="The 1-form of the invariant measure",
        field={here.state: here.flow(theta)},
        definitions=definitions,
        parameters=parameters,
        relations=here.relations,
    )
    return OneForm(
        system,
        theta,
        _scale(rolling),
        spin,
        Measure("closed", (), meaning="the 1-form is closed"),
        Identity("period", dot(theta, cross(unit_vector(3), gamma)), "no period about body axis 3"),
    )


def _scale(rolling: RollingBody) -> sp.Expr:
    """The factor 1 − R/a of θ for a rubber ball on a sphere, relative to a plane; otherwise 1."""
    shape, surface = rolling.body.shape, rolling.surface
    if rolling.contact == "marble" or surface.is_flat or not shape.is_ball:
        return sp.S.One
    scale: sp.Expr = 1 - shape.gauss().support / a
    return scale

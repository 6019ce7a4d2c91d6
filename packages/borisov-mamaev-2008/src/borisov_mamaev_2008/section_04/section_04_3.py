"""§4.3: generalised Chaplygin systems, the change of time."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.chaplygin_ball import generalised_chaplygin as chaplygin
from nonholonomic.catalogue.mechanisms import chaplygin_sleigh

from ..claim import Case, Claim, Remark
from ..methods.catalogue_laws import law_named, laws_named
from ..methods.unspecified_systems import system, unspecified_functions

q = q_1, q_2 = chaplygin.q_1, chaplygin.q_2
#: Velocities q̇, and q′ = dq/dτ.
v = sp.symbols("v_1:4", real=True)
u = sp.symbols("u_1:3", real=True)
(N,) = unspecified_functions("N", *q)


def _velocity_slopes(name: str, places: tuple[sp.Expr, ...]) -> tuple[sp.Expr, tuple[sp.Expr, ...]]:
    """An unspecified L(q, velocities) and its derivatives by the velocities, at given places."""
    slots = sp.symbols(f"w_1:{len(places) + 1}", real=True)
    function = sp.Function(name)
    inner = function(*q, *slots)

    def at(expression: sp.Expr) -> sp.Expr:
        return sp.Subs(expression, slots, places)

    return function(*q, *places), tuple(at(sp.diff(inner, s)) for s in slots)


def _coordinate_slopes(name: str, places: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    """∂L/∂q_i at fixed velocities, taken at given places."""
    slots = sp.symbols(f"w_1:{len(places) + 1}", real=True)
    inner = sp.Function(name)(*q, *slots)
    return tuple(sp.Subs(sp.diff(inner, s), slots, places) for s in q)


# --- ordinary Chaplygin systems ------------------------------------------------------------


def ordinary() -> Case:
    """q̇₃ = c₁(q)q̇₁ + c₂(q)q̇₂ with a Lagrangian that does not depend on q₃.

    The equations with multipliers, d/dt ∂L/∂q̇_i − ∂L/∂q_i + c_i d/dt ∂L/∂q̇₃ = 0, are (4.4) for
    the constrained Lagrangian L*, with S = (∂L/∂q̇₃)* (∂c₁/∂q₂ − ∂c₂/∂q₁), for any L.
    """
    c = unspecified_functions("c1 c2", *q)
    places = (v[0], v[1], c[0] * v[0] + c[1] * v[1])
    constrained, momenta = _velocity_slopes("L", places)
    forces = _coordinate_slopes("L", places)
    S = momenta[2] * (sp.diff(c[0], q_2) - sp.diff(c[1], q_1))
    residuals = []
    for i, other in enumerate((v[1] * S, -v[0] * S)):
        full = Rate(momenta[i]) - forces[i] + c[i] * Rate(momenta[2])
        reduced = Rate(sp.diff(constrained, v[i])) - sp.diff(constrained, q[i]) - other
        residuals.append(full - reduced)
    return _any_motion(), Identity("chaplygin", tuple(residuals))


def _any_motion() -> System:
    """q̇ = v with unspecified v̇."""
    field = dict(
        zip((*q, *v[:2]), (*v[:2], *unspecified_functions("a1 a2", *q, *v[:2])), strict=True)
    )
    return system("motion", "q̇ = v", field)


def sleigh() -> Case:
    """The Chaplygin sleigh with an arbitrary centre of mass, in q₁ = φ and q₂ = x."""
    dynamics = CATALOGUE["chaplygin-sleigh"].system()
    return dynamics, law_named(dynamics, "chaplygin_form")


def _condition() -> Identity:
    """∂A₁/∂q₁ + ∂A₂/∂q₂ = 0, which is necessary for a density ρ(q) with ρ₁/ρ = A₂, ρ₂/ρ = −A₁."""
    gyroscopic = dict(chaplygin_sleigh.sleigh_in_chaplygin_form().scalar_definitions)[chaplygin.S]
    A_1, A_2 = (sp.diff(gyroscopic, P) for P in (chaplygin.P_1, chaplygin.P_2))
    return Identity("condition", sp.diff(A_1, q_1) + sp.diff(A_2, q_2))


def sleigh_multiplier_printed() -> Case:
    """An arbitrary centre of mass."""
    return chaplygin_sleigh.sleigh_in_chaplygin_form(), _condition()


def sleigh_multiplier_corrected() -> Case:
    """N = cos φ if the centre of mass lies beside the contact."""
    return laws_named(chaplygin_sleigh.sleigh_in_chaplygin_form(), "measure", "form")


# --- the change of time --------------------------------------------------------------------


def new_time_motion() -> System:
    """q′ = u in the time τ, with unspecified u′."""
    field = dict(zip((*q, *u), (*u, *unspecified_functions("a1 a2", *q, *u)), strict=True))
    return system("new_time", "q′ = u, in the time τ", field)


VELOCITIES = (N * u[0], N * u[1])


def momenta() -> Case:
    """∂L/∂q̇_i = (1/N) ∂L̄/∂q′_i for any L."""
    barred, slopes = _velocity_slopes("L", VELOCITIES)
    residuals = tuple(slope - sp.diff(barred, s) / N for slope, s in zip(slopes, u, strict=True))
    return new_time_motion(), Identity("momenta", residuals)


def forces() -> Case:
    """∂L/∂q_i = ∂L̄/∂q_i − (1/N) ∂N/∂q_i Σ q′_k ∂L̄/∂q′_k for any L."""
    barred, _ = _velocity_slopes("L", VELOCITIES)
    power = sp.Add(*(s * sp.diff(barred, s) for s in u))
    residuals = tuple(
        slope - (sp.diff(barred, s) - sp.diff(N, s) / N * power)
        for slope, s in zip(_coordinate_slopes("L", VELOCITIES), q, strict=True)
    )
    return new_time_motion(), Identity("forces", residuals)


def new_time() -> Case:
    """(4.5) and (4.4) have the same residual along every motion, for any L and S."""
    barred, slopes = _velocity_slopes("L", VELOCITIES)
    S = sp.Function("S")(*q, *VELOCITIES)
    first, second = (sp.diff(barred, s) for s in u)
    bar = N * S + (sp.diff(N, q_2) * first - sp.diff(N, q_1) * second) / N
    residuals = []
    for i, (slope, force) in enumerate(
        zip(slopes, _coordinate_slopes("L", VELOCITIES), strict=True)
    ):
        sign, other = (1, u[1]) if i == 0 else (-1, u[0])
        old = N * Rate(slope) - force - sign * N * other * S
        new = Rate(sp.diff(barred, u[i])) - sp.diff(barred, q[i]) - sign * other * bar
        residuals.append(old - new)
    return new_time_motion(), Identity("new_time", tuple(residuals))


CLAIMS = (
    Claim(
        "(4.4)",
        r"If the function $S$ is specially chosen, (4.4) gives an ordinary Chaplygin system and "
        r"$b(\mathbf{q}) = 0$",
        ordinary,
        note="derived with multipliers: S = (∂L/∂q̇₃)* (∂c₁/∂q₂ − ∂c₂/∂q₁), which is linear and "
        "homogeneous in the velocities when the kinetic energy is a quadratic form",
    ),
    Claim(
        "§4.3, Chaplygin sleigh",
        "The governing equations for a so-called Chaplygin sleigh can be reduced to the form (4.4) "
        r"with $b(\mathbf{q}) = 0$",
        sleigh,
        note="q₁ = φ, q₂ = x, S = −m(u sin φ + aφ̇ cos φ)/cos²φ, with the centre of mass anywhere",
    ),
    Claim(
        "§4.3, reducing multiplier of the Chaplygin sleigh",
        "The equations of the Chaplygin sleigh can be integrated using the method of reducing "
        "multiplier and solution of a Hamilton–Jacobi equation",
        sleigh_multiplier_printed,
        sleigh_multiplier_corrected,
        r"They can, with $\mathcal{N} = \cos\varphi$, when the centre of mass lies on the "
        "perpendicular to the blade through its point of contact",
        "the hypothesis is missing: otherwise no measure has a density that depends on the "
        "coordinates alone, and the velocities tend to those of going straight on",
    ),
    Claim(
        "§4.3, momenta in the new time",
        r"$\dot q_i = \mathcal{N} q'_i$, $\frac{\partial L}{\partial\dot q_i} = "
        r"\frac{1}{\mathcal{N}}\frac{\partial\bar L}{\partial q'_i}$",
        momenta,
        note="for any L(q, q̇)",
    ),
    Claim(
        "§4.3, forces in the new time",
        r"$\frac{\partial L}{\partial q_i} = \frac{\partial\bar L}{\partial q_i} - "
        r"\frac{1}{\mathcal{N}}\frac{\partial\mathcal{N}}{\partial q_i}"
        r"\sum_{k=1}^2 q'_k\frac{\partial\bar L}{\partial q'_k}$",
        forces,
        note="for any L(q, q̇)",
    ),
    Claim(
        "(4.5)",
        r"$\frac{d}{d\tau}\left(\frac{\partial\bar L}{\partial q'_1}\right) - "
        r"\frac{\partial\bar L}{\partial q_1} = q'_2\bar S$, "
        r"$\frac{d}{d\tau}\left(\frac{\partial\bar L}{\partial q'_2}\right) - "
        r"\frac{\partial\bar L}{\partial q_2} = -q'_1\bar S$, "
        r"$\bar S = \mathcal{N}S + \frac{1}{\mathcal{N}}\left("
        r"\frac{\partial\mathcal{N}}{\partial q_2}\frac{\partial\bar L}{\partial q'_1} - "
        r"\frac{\partial\mathcal{N}}{\partial q_1}\frac{\partial\bar L}{\partial q'_2}\right)$",
        new_time,
        note="for any L(q, q̇) and S(q, q̇)",
    ),
)

REMARKS = (
    Remark(
        "§4.3, Veselova's problem and the Chaplygin ball",
        "Veselova's problem is a Chaplygin system [52]; the Chaplygin ball can be reduced to the "
        "form (4.4) with b ≠ 0",
        "claims of §6 and §7",
    ),
)

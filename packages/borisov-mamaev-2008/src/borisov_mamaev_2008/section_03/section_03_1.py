"""§3.1: first integrals, symmetry fields, conservation of energy."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.bodies import rubber_body
from nonholonomic.mechanics.lagrangian.structure_functions import lie_derivative

from ..claim import Case, Claim, Remark
from ..methods.any_number import any_number
from ..methods.catalogue_laws import law_named
from ..methods.unspecified_systems import fields, gradient, system, unspecified_functions

q = sp.symbols("q_1:4", real=True)
w = sp.symbols("w_1:4", real=True)
x = sp.symbols("x_1:4", real=True)

# --- integrals and symmetry fields ---------------------------------------------------------


def rate_of_a_function() -> Case:
    """Ḟ = (∇F, v) for any F and v."""
    (F,) = unspecified_functions("F", *x)
    field = fields("v1 v2 v3", x)
    return system("field", "ẋ = v(x)", field), Identity("rate", Rate(F) - lie_derivative(field, F))


def symmetry_of_integrals() -> Case:
    """[u, v] = 0 in components: u maps the rate of any F to the rate of u(F)."""
    (F,) = unspecified_functions("F", *x)
    v, u = fields("v1 v2 v3", x), fields("u1 u2 u3", x)

    lie = sp.Add(*((lie_derivative(u, v[s]) - lie_derivative(v, u[s])) * sp.diff(F, s) for s in x))
    commuted = (
        lie_derivative(u, lie_derivative(v, F)) - lie_derivative(v, lie_derivative(u, F)) - lie
    )
    return system("field", "ẋ = v(x)", v), Identity("commutator", commuted)


# --- energy of (1.9) -----------------------------------------------------------------------

FRAME = sp.Matrix(3, 3, lambda i, j: unspecified_functions(f"G{i + 1}{j + 1}", *q)[0])
VELOCITY = FRAME * sp.Matrix(w)
(LAGRANGIAN,) = unspecified_functions("L", *q, *w)
ENERGY = sp.Add(*(s * sp.diff(LAGRANGIAN, s) for s in w)) - LAGRANGIAN


def _structure(i: int, j: int, k: int) -> sp.Expr:
    """Unspecified structure functions c_ij^k = −c_ji^k."""
    if i == j:
        return sp.S.Zero
    first, second = min(i, j), max(i, j)
    (value,) = unspecified_functions(f"c{first + 1}{second + 1}{k + 1}", *q)
    return value if i < j else -value


def _any_motion() -> System:
    """q̇ = G w with unspecified ẇ."""
    field = dict(zip(q, VELOCITY, strict=True)) | dict(
        zip(w, unspecified_functions("a1 a2 a3", *q, *w), strict=True)
    )
    return system("motion", "q̇ = G(q) w", field)


def _left_side(i: int) -> sp.Expr:
    """d/dt ∂L/∂w_i − Σ c_ji^k ∂L/∂w_k w_j − E_i(L), the left side of (1.9)."""
    momenta = gradient(LAGRANGIAN, w)
    turning = sp.Add(*(_structure(j, i, k) * momenta[k] * w[j] for j in range(3) for k in range(3)))
    along = sp.Add(*(FRAME[j, i] * sp.diff(LAGRANGIAN, q[j]) for j in range(3)))
    return Rate(momenta[i]) - turning - along


def energy_identity() -> tuple[System, Identity]:
    """Ė = Σ w_i × (left side of (1.9))_i along every motion, for any ẇ."""
    power = sp.Add(*(s * _left_side(i) for i, s in enumerate(w)))
    return _any_motion(), Identity("power", Rate(ENERGY) - power)


def euler(degree: int) -> tuple[System, Identity]:
    """Euler's theorem for an unspecified homogeneous polynomial in w of the given degree."""
    monomials = sp.itermonomials(w, degree, degree)
    ordered = sorted(monomials, key=sp.default_sort_key)
    f = sp.Add(*(unspecified_functions(f"a{i}", *q)[0] * term for i, term in enumerate(ordered)))
    residual = sp.Add(*(sp.diff(f, s) * s for s in w)) - degree * f
    return _any_motion(), Identity(f"degree {degree}", residual)


def theorem_1() -> Case:
    """Ė = Σ λ_μ ϰ_μ f_μ, which vanishes on the constraints."""
    return energy_identity(), *(euler(degree) for degree in (1, 2, 3))


def power_of_reactions() -> Case:
    """The formula for Ė in the proof, since by (1.9) the left sides are Σ λ_μ ∂f_μ/∂w_i."""
    return energy_identity()


def eulers_theorem() -> Case:
    """Homogeneous constraints of degree one, two and three."""
    return tuple(euler(degree) for degree in (1, 2, 3))


def energy_in_coordinates() -> Case:
    """(1.6): the frame is that of the coordinates."""
    momenta = gradient(LAGRANGIAN, w)
    field = dict(zip(q, w, strict=True)) | dict(
        zip(w, unspecified_functions("a1 a2 a3", *q, *w), strict=True)
    )
    power = sp.Add(*(s * (Rate(momenta[i]) - sp.diff(LAGRANGIAN, q[i])) for i, s in enumerate(w)))
    moving = system("motion", "q̇ = w", field)
    return moving, Identity("power", Rate(ENERGY) - power)


def homogeneous_constraints() -> Case:
    """Σ q̇ ∂f/∂q̇ − f = −b for f = Σ a_k q̇_k + b; f is homogeneous if and only if b = 0."""
    a, (b,) = unspecified_functions("a1 a2 a3", *q), unspecified_functions("b", *q)
    f = sp.Add(*(s * rate for s, rate in zip(a, w, strict=True))) + b
    residual = sp.Add(*(sp.diff(f, s) * s for s in w)) - f + b
    return _any_motion(), Identity("degree", residual)


def examples() -> Case:
    """The energy of all rubber bodies, the Chaplygin ball and the Veselova system."""
    names = ("chaplygin-ball", "veselova")
    dynamics = [rubber_body.general(), *(CATALOGUE[name].system() for name in names)]
    return tuple((each, law_named(each, "energy")) for each in dynamics)


#: Euler's theorem for all homogeneous functions; the computation covers polynomials.
EULER = (
    "for every differentiable f, homogeneous of degree ϰ, the derivative of f(q, sw) = s^ϰ f(q, w) "
    "by s at s = 1 is Euler's identity"
)

CLAIMS = (
    Claim(
        "§3.1, first integral",
        r"a function $F(\mathbf{x})$ is a first integral if "
        r"$\dot F = (\nabla F, \mathbf{v}(\mathbf{x})) = 0$",
        rate_of_a_function,
        note="read as the formula for the rate of any function",
        argument=any_number(1),
    ),
    Claim(
        "(3.2)",
        r"a vector field $\mathbf{u}(\mathbf{x})$ is a symmetry field if "
        r"$[\mathbf{u}(\mathbf{x}), \mathbf{v}(\mathbf{x})] = 0$, where $[\cdot,\cdot]$ is the Lie "
        "bracket in the phase space",
        symmetry_of_integrals,
        note="read as: the components of the bracket are those of the commutator of derivatives, "
        "so that the derivative along u of an integral is an integral",
        argument=any_number(2),
    ),
    Claim(
        "Theorem 1, (3.3)",
        r"If $\hat L(\mathbf{q}, \mathbf{w})$ and the constraints are independent of time and the "
        r"constraints are homogeneous functions of $w_i$, the system (1.9) preserves the energy "
        r"$\mathcal{E} = \sum w_i\,\partial\hat L/\partial w_i - \hat L$ (3.3)",
        theorem_1,
        argument=f"{any_number(3)}; {EULER}",
    ),
    Claim(
        "Theorem 1, proof",
        r"$\dot{\mathcal{E}} = \sum_{\mu,i} \lambda_\mu "
        r"\frac{\partial\hat f_\mu}{\partial w_i} w_i$",
        power_of_reactions,
        note="by (1.9) the reactions are the left sides of its first line; their power is Ė",
        argument=any_number(3),
    ),
    Claim(
        "Theorem 1, proof, Euler's theorem",
        r"$\frac{\partial \hat f_\mu}{\partial w_i} w_i = \varkappa_\mu \hat f_\mu$, where "
        r"$\varkappa_\mu$ is the degree of homogeneity of $f_\mu$",
        eulers_theorem,
        note="summed over i",
        argument=EULER,
    ),
    Claim(
        "§3.1, energy for (1.6)",
        r"For the equation in local coordinates (1.6), the energy integral reads "
        r"$\mathcal{E} = (\dot{\mathbf{q}}, \partial L/\partial\dot{\mathbf{q}}) - L$",
        energy_in_coordinates,
        note="Ė is the power of the reactions",
        argument=any_number(2),
    ),
    Claim(
        "§3.1, homogeneous constraints",
        r"For the constraints (1.2) the homogeneity condition is equivalent to "
        r"$b_\mu(\mathbf{q}) = 0$",
        homogeneous_constraints,
        argument=any_number(1),
    ),
    Claim(
        "§3.1, examples",
        "These conditions are fulfilled for a rubber body (1.14), (1.15) and Chaplygin's and "
        "Veselova's problems",
        examples,
        note="their energy is preserved",
    ),
)

REMARKS = (
    Remark(
        "(3.1)",
        "The components of v are analytic functions in the problems under consideration",
        "an assumption, not a claim",
    ),
)

"""The separating coordinates of the hollow ball around a sphere, k = −1, F₂ = 0 (§8.3).

With A = ½ tr J − J, τ = ½ (ΣI + d) = tr A − d and ζ = τ − u, the coordinates u₁, u₂ are the roots
of Σ A_i² I_i n_i²/(u − A_i) = 0, so that

    n_i² = (u₁ − A_i)(u₂ − A_i) / (S A_i² I_i ∏_{k≠i}(A_i − A_k)),     1/S = Σ A_i² I_i n_i².

With e₂, e₃ the symmetric functions of A, p = ∏(u − A_i), L = e₂u − e₃ and Q = L − du² every motion
has

    (u₁ − u₂)² L(u₂) (du₁/dt)² = 4 u₂² p(u₁) S ((M, ω) ζ₁ L(u₁) − M² Q(u₁)),

and the same with 1 and 2 exchanged (everything here is symmetric in them); (M, ω) and M² have no
term with the product of both rates; e₃² S det I_Q = L(u₁) L(u₂).  The variable of (8.12) is
x = ζL/Q.

Here the coordinates move at arbitrary rates v₁, v₂, so that what is proved holds at every instant
of every motion.  ω follows from n, ṅ by (8.4): its components are ω_i = n_j n_k r_i.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Identity, Law
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Diagonal, Vector, constant, cross, identity, real_symbol

from . import ball_on_sphere_equations as ball

A, J = Diagonal("A"), Diagonal("J")
A_1, A_2, A_3 = A.symbols
TRACE, E_2, E_3 = A_1 + A_2 + A_3, A_1 * A_2 + A_2 * A_3 + A_3 * A_1, A_1 * A_2 * A_3

#: u₁, u₂ and their rates.
u = (real_symbol("u_1"), real_symbol("u_2"))
v = (real_symbol("v_1"), real_symbol("v_2"))
d, tau, S, det = real_symbol("d"), real_symbol("tau"), real_symbol("S"), real_symbol("det")
#: n_i², and what ω is made of for the two rates each.
square = Vector("s")
turns = (Vector("q"), Vector("r"))
#: (n, Bn) and (An, Bn).
form, weighted = real_symbol("F"), real_symbol("W")
#: Coefficients of v_i v_j in (M, ω) and in M², times 4 u₁² u₂² p(u_i) p(u_j) / e₃².
energies = (real_symbol("h_11"), real_symbol("h_12"), real_symbol("h_22"))
momenta = (real_symbol("f_11"), real_symbol("f_12"), real_symbol("f_22"))
_level, _share = real_symbol("g"), real_symbol("k")
_CYCLE = ((0, 1, 2), (1, 2, 0), (2, 0, 1))


def cubic(z: sp.Expr) -> sp.Expr:
    """p(z) = ∏(z − A_i)."""
    return sp.Mul(*(z - a for a in A.symbols))


def scale(z: sp.Expr) -> sp.Expr:
    """L(z) = e₂z − e₃."""
    return E_2 * z - E_3


def ratio_form(z: sp.Expr) -> sp.Expr:
    """Q(z) = L(z) − dz²."""
    return scale(z) - d * z**2


def variable(z: sp.Expr) -> sp.Expr:
    """x = ζL/Q of (8.12), ζ = τ − z."""
    return (tau - z) * scale(z) / ratio_form(z)


def _products() -> tuple[sp.Expr, sp.Expr]:
    """(u₁ − τ)(u₂ − τ)/p(τ) and u₁u₂/(τe₃), from which sums over the axes are built."""
    return (u[0] - tau) * (u[1] - tau) / cubic(tau), u[0] * u[1] / (tau * E_3)


def _sum() -> sp.Expr:
    """S as a function of the coordinates, from the residues at τ and 0."""
    pole, origin = _products()
    return pole / tau**2 + origin * (1 / tau + E_2 / E_3) - (u[0] + u[1]) / (tau * E_3)


def _square(i: int) -> sp.Expr:
    """S n_i²."""
    a = A.symbols[i]
    others = [a - A.symbols[k] for k in range(3) if k != i]
    return (u[0] - a) * (u[1] - a) / (a**2 * (tau - a) * sp.Mul(*others))


def _turn(which: int) -> MatrixExpr:
    """q_i for a unit rate of one coordinate z: r_i = S e₃ (A_j − A_k) q_i / (2 u₁u₂ p(z))."""
    z = u[which]
    middle = z**2 + _share - cubic(z) * sp.diff(_sum(), z) / S
    return constant([-z * a**2 + a * middle - z * _share for a in A.symbols])


def _weighted_turn(turn: Vector) -> MatrixExpr:
    """e₃ (A_j − A_k) q_i."""
    differences = [A.symbols[j] - A.symbols[k] for _, j, k in _CYCLE]
    return E_3 * constant([x * q for x, q in zip(differences, turn, strict=True)])


def _reach(i: int) -> sp.Expr:
    """S A_i² I_i n_i² ∏(A_i − A_k)."""
    return (u[0] - A.symbols[i]) * (u[1] - A.symbols[i])


def _pair(i: int, j: int, k: int) -> sp.Expr:
    """S² n_j² n_k² (A_j − A_k)²."""
    a, b, c = (A.symbols[n] for n in (i, j, k))
    weights = b**2 * (tau - b) * c**2 * (tau - c) * (a - b) * (a - c)
    return -_reach(j) * _reach(k) / weights


def _energy(first: int, second: int) -> sp.Expr:
    """Of (M, ω) = (Jω, ω) − d (n, ω)², the coefficient of both rates times 4u₁²u₂²pp/e₃²."""
    terms = [
        J.symbols[i] * _pair(i, j, k) * turns[first].symbols[i] * turns[second].symbols[i]
        for i, j, k in _CYCLE
    ]
    spun = cubic(u[0]) * cubic(u[1]) * u[first] * u[second] / (E_3**2 * cubic(tau))
    return sp.Add(*terms) + d / S * spun


def _momentum(first: int, second: int) -> sp.Expr:
    """The momentum integral M², M = Jω − d n (n, ω)."""

    def component(which: int, i: int) -> sp.Expr:
        a = A.symbols[i]
        share = _reach(i) / (S * a**2 * (tau - a))
        return J.symbols[i] * turns[which].symbols[i] + d * u[which] * share

    return sp.Add(
        *(_pair(i, j, k) * component(first, i) * component(second, i) for i, j, k in _CYCLE)
    )


def _energy_and_momentum(energy: sp.Expr, momentum: sp.Expr) -> sp.Expr:
    """e₃² S ((M, ω) ζ₁L(u₁) − M² Q(u₁)) for one coefficient."""
    z = u[0]
    return E_3**2 * S * (energy * (tau - z) * scale(z) - momentum * ratio_form(z))


def _log_rates(which: int) -> list[sp.Expr]:
    """ṅ_i/n_i for a unit rate of one coordinate."""
    z = u[which]
    logarithm = sp.diff(_sum(), z) / (2 * S)
    return [1 / (2 * (z - a)) - logarithm for a in A.symbols]


def _averages() -> tuple[sp.Expr, ...]:
    """(n, An), (n, JAn), (n, JA²n) and (n, J⁻¹n) as sums over the axes."""
    triples = tuple(zip(square, J.symbols, A.symbols, strict=True))
    return (
        sp.Add(*(s * a for s, _, a in triples)),
        sp.Add(*(s * j * a for s, j, a in triples)),
        sp.Add(*(s * j * a**2 for s, j, a in triples)),
        sp.Add(*(s / j for s, j, _ in triples)),
    )


def _laws() -> tuple[Law, ...]:
    drawn = constant([j * a - d * _level for j, a in zip(J.symbols, A.symbols, strict=True)])
    turned = [
        2 * u[0] * u[1] * cubic(z) * cross(drawn, constant(_log_rates(i)))
        - form * S * _weighted_turn(turn)
        for i, (z, turn) in enumerate(zip(u, turns, strict=True))
    ]
    first, second, third, fourth = _averages()
    return (
        Identity("sphere", sp.Add(*square) - 1, "n² = 1", source="§8.3"),
        Identity("velocity", tuple(turned), "ω from n and ṅ", source="(8.4)"),
        Identity(
            "sums",
            (
                _level - first,
                form - second + d * _level,
                weighted - third + d * _level**2,
                det - sp.Mul(*J.symbols) * (1 - d * fourth),
            ),
            "(n, An), (n, Bn), (An, Bn) and det I_Q in the coordinates",
            source="§8.3",
        ),
        Identity(
            "orthogonal",
            (energies[1], momenta[1]),
            "neither (M, ω) nor M² has a term with v₁v₂",
            source="(8.11)",
        ),
        Identity(
            "separation",
            (
                (u[0] - u[1]) ** 2 * u[0] ** 2 * cubic(u[0]) * scale(u[1])
                - _energy_and_momentum(energies[0], momenta[0]),
                _energy_and_momentum(energies[2], momenta[2]),
            ),
            "coefficients of v₁² and v₂² in the separated equation of u₁",
            source="§8.3",
        ),
        liouville(),
    )


def function(z: sp.Expr) -> sp.Expr:
    """S(x) = 8 (dx/dζ)² p L Q / u² of Liouville's form, for H = ½ (M, ω) and F = ½ M²."""
    slope = sp.diff(variable(z), z)
    return 8 * slope**2 * cubic(z) * scale(z) * ratio_form(z) / z**2


def liouville() -> Identity:
    """(x₁ − x₂)² (dx₁/dτ)² = 4 S(x₁) (x₁H − F) along the separated equation, dτ = 𝒩 dt.

    What is stated is the coefficient of (M, ω) ζ₁L(u₁) − M² Q(u₁) on both sides.
    """
    z, other = u
    slope = sp.diff(variable(z), z)
    gap = (variable(z) - variable(other)) / (z - other)
    multiplier_2 = form**2 / (4 * weighted**2 * det)
    left = gap**2 * slope**2 * 4 * other**2 * cubic(z) * S / scale(other)
    return Identity(
        "liouville",
        left - multiplier_2 * 2 * function(z) / ratio_form(z),
        "Liouville's form in the time τ",
        source="(8.11), (8.12)",
    )


def of_ball() -> Identity:
    """The coordinates on the ball of `ball.vanishing_area`: the roots of a quadratic."""
    names = [real_symbol(f"b_{i}") for i in range(3)]
    weights = [
        a**2 * (j - d) * x**2 for a, j, x in zip(A.symbols, J.symbols, ball.n.symbols, strict=True)
    ]
    root = real_symbol("D")
    solutions = [
        names[2] * (u[0] - a) * (u[1] - a) - w * sp.Mul(*(a - b for b in A.symbols if b != a))
        for a, w in zip(A.symbols, weights, strict=True)
    ]
    area = sp.Mul(*J.symbols) * ball.rho_2
    return Identity(
        "coordinates",
        (*solutions, names[2] * scale(u[0]) * scale(u[1]) - E_3**2 * area),
        "n in the coordinates, and det I_Q",
        {
            names[2]: sp.Add(*weights),
            names[1]: sp.Add(*(w * (TRACE - a) for w, a in zip(weights, A.symbols, strict=True))),
            names[0]: sp.Add(*(w * E_3 / a for w, a in zip(weights, A.symbols, strict=True))),
            root: sp.sqrt(names[1] ** 2 - 4 * names[0] * names[2]),
            u[0]: (names[1] + root) / (2 * names[2]),
            u[1]: (names[1] - root) / (2 * names[2]),
        },
        source="§8.3",
    )


def coordinates_around_sphere() -> System:
    """The ball in the separating coordinates, moving at arbitrary rates."""
    parameters = (
        *(
            Parameter(s, f"tensor of the linear integral, body axis {i}", value, "kg m^2")
            for i, (s, value) in enumerate(zip(A.symbols, (1.8, 1.3, 0.7), strict=True), 1)
        ),
        Parameter(tau, "half the trace of I plus half of d", 2.8, "kg m^2"),
        Parameter(v[0], "rate of the first coordinate", 0.3, "kg m^2/s"),
        Parameter(v[1], "rate of the second coordinate", -0.2, "kg m^2/s"),
    )
    pole, origin = _products()
    return System(
        name="ball-around-sphere-coordinates",
        title="Hollow ball around a sphere in its separating coordinates",
        summary="An instant of any motion with vanishing linear integral, k = −1.",
        source="§8.3",
        parameters=parameters,
        definitions=(
            (d, TRACE - tau),
            (J, TRACE * identity - A),
            (S, _sum()),
            (square, constant([_square(i) / S for i in range(3)])),
            (_level, (pole / tau + origin) / S),
            (_share, E_2 - d * _level),
            (turns[0], _turn(0)),
            (turns[1], _turn(1)),
            (form, u[0] * u[1] / (E_3 * S)),
            (det, scale(u[0]) * scale(u[1]) / (E_3**2 * S)),
            (weighted, (u[1] - u[0]) / (S * (variable(u[0]) - variable(u[1])))),
            *zip(energies, (_energy(0, 0), _energy(0, 1), _energy(1, 1)), strict=True),
            *zip(momenta, (_momentum(0, 0), _momentum(0, 1), _momentum(1, 1)), strict=True),
        ),
        field={u[0]: v[0], u[1]: v[1]},
        laws=_laws(),
    )

"""Laws of n-dimensional systems for every operator of inertia, as identities for the prover.

Let A be a symmetric operator that depends on γ, S = A⁻¹.  From dS = −S dA S and
d log det A = tr(S dA) the divergence of a field and the rate of log (det A)^(−1/2) are polynomials
in S, dA/dγ and the velocities, and the density is that of an invariant measure if their sum
vanishes.  It does so for *every* symmetric S, so that S need not be known: the identities below
have its entries as independent parameters, and hold for every operator of inertia.

The energy ½(k, Sk) or ½(p, Sp) is treated in the same way, its rate being a polynomial without S.

**Chaplygin ball**, k = A ω with A = I + m R² pr, pr(ω) = ωΓ + Γω, k̇ = [k, ω], γ̇ = −ωγ.  For
every n:

* ∂/∂k contributes tr(−ad ω) + tr(ad k ∘ S) = 0, as ad k is skew and S symmetric;
* with ∂ᵢpr(ω) = (ωeᵢ)∧γ + (ωγ)∧eᵢ the γ-part is D Σ (S(eᵢ∧γ), (ωeᵢ)∧γ + (ωγ)∧eᵢ), D = m R²,
  where the first sum is the trace of a symmetric form with the skew matrix ω, hence zero;
* pr along γ̇ = −v, v = ωγ, is X ↦ −(Xγ)∧v − (Xv)∧γ, and −½ tr of S with D times it is
  D Σ (S(eᵢ∧γ), eᵢ∧v), which cancels the second sum.

**Veselova system and rubber ball**, p = B u, (Bx, y) = (I(x∧γ), y∧γ) + (x, γ)(y, γ), γ̇ = −u,
ṗ = (u, p)γ, S = B⁻¹.  For every n:

* of I the divergence is Σ (I(u∧eᵢ), Seᵢ∧γ) + Σ (I(u∧γ), Seᵢ∧eᵢ), whose second sum vanishes, as S is
  symmetric, and −½ tr(S Ḃ) = Σ (I(Seᵢ∧γ), eᵢ∧u) cancels the first;
* what γγᵀ adds is 2(u, Sγ) + (u, γ) tr S, and ∂/∂p of (u, p)γ is 2(u, γ).  On the phase space
  (u, γ) = 0 and Bγ = γ, so that (u, Sγ) = (u, γ) = 0.

On a sphere γ̇ is multiplied by a ratio ε.  The terms with k̇ vanish identically, so that measure
and energy of the marble ball stay, and the energy of the rubber ball too.  The rubber ball has
(1 − ε)ku more in ṗ, k = I(u∧γ), whose divergence is (1 − ε) Σ (I(eᵢ∧γ), Seᵢ∧u), the sum above: the
exponent becomes 1/(2ε) − 1.

On the level k = p∧γ, ṗ = −ωp, what belongs to k is Σ (S(eₐ∧γ), p∧eₐ) + Σ (S(eₐ∧p), eₐ∧γ) instead,
zero as S is symmetric: the density stays, in p and γ.

These arguments hold for every n.  `chaplygin_ball` and `veselova` write the whole residual for one
n, derivatives taken entry by entry, as a law of a system without motion, which
:func:`lawproof.prove` certifies.
"""

from __future__ import annotations

from itertools import combinations_with_replacement

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.matrices import Column, Skew, SymmetricMatrix, wedge
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Components, dot, norm_squared, real_symbol

from .entry_of_dimension import SOURCE, D, R, m
from .inertia import pairs

HALF = sp.Rational(1, 2)


def _unit(n: int, i: int) -> sp.Matrix:
    return sp.Matrix([int(i == j) for j in range(n)])


def _bivector(n: int, place: tuple[int, int]) -> sp.Matrix:
    """The skew matrix with 1 at a place above the diagonal."""
    i, j = place
    return sp.Matrix(
        wedge(sp.ImmutableDenseMatrix(_unit(n, i)), sp.ImmutableDenseMatrix(_unit(n, j)))
    )


def named_operator(name: str, size: int) -> sp.Matrix:
    """A symmetric matrix of symbols ``name_i_j``."""
    return sp.Matrix(
        size, size, lambda i, j: real_symbol(f"{name}_{min(i, j) + 1}_{max(i, j) + 1}")
    )


def parameters_of(matrix: sp.Matrix, meaning: str) -> tuple[Parameter, ...]:
    """The entries of a symmetric matrix as parameters; by default it is the unit matrix."""
    places = combinations_with_replacement(range(matrix.shape[0]), 2)
    return tuple(Parameter(matrix[i, j], meaning, float(i == j)) for i, j in places)


def above(matrix: sp.MatrixBase) -> list[sp.Expr]:
    """The entries above the diagonal, in the order of the planes."""
    return [matrix[i, j] for i, j in pairs(matrix.shape[0])]


def chaplygin_ball(n: int, exponent: sp.Rational = -HALF) -> System:
    """The residual of the density (det ∂k/∂ω)^exponent of the Chaplygin ball.

    Parameters
    ----------
    n : int
        The dimension of space.
    exponent : sympy.Rational
        −1/2 in the law that holds.

    Returns
    -------
    System
        k, ω, γ and the entries of S are independent; its law ``measure`` is the identity.

    Examples
    --------
    >>> import lawproof
    >>> lawproof.prove(chaplygin_ball(3), "measure").decision
    'proven'
    """
    places = pairs(n)
    k, omega, gamma = Skew("k", n), Skew("omega", n), Column("gamma", n)
    S = named_operator("S", len(places))
    K, W = (sp.Matrix(name.entries) for name in (k, omega))
    residual = _of_the_normal(omega, gamma, S, exponent)
    # ∂/∂k of [k, ω], with ∂ω/∂k = S
    for row, place in enumerate(places):
        unit = _bivector(n, place)
        turned = skew(n, S.col(row))
        rate = unit * W - W * unit + K * turned - turned * K
        residual += rate[place]
    return _measure_of_ball(
        "chaplygin-ball-measure",
        f"The measure of the Chaplygin ball in {n} dimensions",
        (k, omega, gamma),
        S,
        residual,
    )


def chaplygin_ball_on_level(n: int, exponent: sp.Rational = -HALF) -> System:
    """The residual of the density (det ∂k/∂ω)^exponent in p and γ, on the level k = p∧γ.

    Parameters
    ----------
    n : int
        The dimension of space.
    exponent : sympy.Rational
        −1/2 in the law that holds.

    Returns
    -------
    System
        p, ω, γ and the entries of S are independent; its law ``measure`` is the identity.

    Examples
    --------
    >>> import lawproof
    >>> lawproof.prove(chaplygin_ball_on_level(3), "measure").decision
    'proven'
    """
    p, omega, gamma = Column("p", n), Skew("omega", n), Column("gamma", n)
    S = named_operator("S", len(pairs(n)))
    x, y = (sp.Matrix(name.entries) for name in (p, gamma))
    residual = _of_the_normal(omega, gamma, S, exponent)
    # ∂/∂p of −ωp and ∂/∂γ of −ωγ, as far as ω = S(p∧γ) moves with k
    for a in range(n):
        e = _unit(n, a)
        residual -= (skew(n, S * sp.Matrix(above(e * y.T - y * e.T))) * x)[a]
        residual -= (skew(n, S * sp.Matrix(above(x * e.T - e * x.T))) * y)[a]
    return _measure_of_ball(
        "chaplygin-ball-measure-on-level",
        f"The measure of the Chaplygin ball on k = p∧γ in {n} dimensions",
        (p, omega, gamma),
        S,
        residual,
    )


def _measure_of_ball(
    name: str,
    title: str,
    variables: tuple[Column | Skew, ...],
    S: sp.Matrix,
    residual: sp.Expr,
) -> System:
    """A system without motion whose law is that the residual vanishes."""
    words = "divergence and rate of the density cancel"
    return System(
        name=name,
        title=title,
        field={variable: _still(variable) for variable in variables},
        parameters=(
            *parameters_of(S, "entry of the inverse of the operator from ω to k"),
            Parameter(m, "mass", 1.0, "kg"),
            Parameter(R, "radius", 1.0, "m"),
        ),
        laws=(Identity("measure", residual, words, source=SOURCE),),
    )


def _of_the_normal(omega: Skew, gamma: Column, S: sp.Matrix, exponent: sp.Rational) -> sp.Expr:
    """The terms that ∂ω/∂γ at fixed k and the rate of (det ∂k/∂ω)^exponent add for a ball."""
    n = int(gamma.shape[0])
    W, y = (sp.Matrix(name.entries) for name in (omega, gamma))
    slopes = []
    for i in range(n):
        around = (y * y.T).diff(y[i])
        columns = [
            above(D * (unit * around + around * unit))
            for unit in (_bivector(n, place) for place in pairs(n))
        ]
        slopes.append(sp.Matrix(columns).T)
    residual, velocity = sp.S.Zero, -W * y
    # ∂/∂γ of −ωγ, with ∂ω/∂γᵢ = −S ∂ᵢA ω; the factor γ itself gives tr ω = 0
    for i, slope in enumerate(slopes):
        residual += (skew(n, S * (slope * sp.Matrix(above(W)))) * y)[i]
        residual += exponent * velocity[i] * (S * slope).trace()
    return residual


def skew(n: int, entries: sp.MatrixBase) -> sp.Matrix:
    """The skew matrix with these entries above the diagonal."""
    matrix = sp.zeros(n)
    for value, place in zip(entries, pairs(n), strict=True):
        matrix += value * _bivector(n, place)
    return matrix


def veselova(n: int, exponent: sp.Expr = -HALF, ratio: sp.Expr = sp.S.One) -> System:
    """The residual of the density (det B)^exponent of the Veselova system and the rubber ball.

    Parameters
    ----------
    n : int
        The dimension of space.
    exponent : sympy.Expr
        1/(2ε) − 1 in the law that holds, −1/2 on a plane.
    ratio : sympy.Expr
        ε of a ball on a sphere: 1 on a plane, or a symbol.

    Returns
    -------
    System
        u, γ, the entries of S and those of I, a symmetric operator on so(n), are independent; its
        law ``measure`` is the identity, what vanishes on the phase space subtracted.

    Examples
    --------
    >>> import lawproof
    >>> lawproof.prove(veselova(3), "measure").decision
    'proven'
    """
    places = pairs(n)
    u, gamma, S = Column("u", n), Column("gamma", n), SymmetricMatrix("S", n)
    inertia = named_operator("I", len(places))
    x, y, inverse = (sp.Matrix(name.entries) for name in (u, gamma, S))
    B = operator_of_planes(inertia, y)
    slopes = [B.diff(s) for s in y]
    weight = sp.expand(ratio * exponent)
    # ∂/∂γ of −εu, with ∂u/∂γᵢ = −S ∂ᵢB u
    residual = ratio * sp.Add(*((inverse * slope * x)[i] for i, slope in enumerate(slopes)))
    residual -= weight * sp.Add(
        *(x[i] * (inverse * slope).trace() for i, slope in enumerate(slopes))
    )
    vanishing = (ratio - 2 * weight) * (x.T * inverse * y)[0]
    vanishing += ratio * (x.T * y)[0] * inverse.trace()
    # ∂/∂p of (1 − ε) I(u∧γ) u, with ∂u/∂p = S
    turns = [above(_unit(n, b) * y.T - y * _unit(n, b).T) for b in range(n)]
    for b, turn in enumerate(turns):
        matrix = skew(n, inertia * sp.Matrix(turn))
        residual += (1 - ratio) * (inverse.row(b) * matrix * x)[0]
    return System(
        name="veselova-measure",
        title=f"The measure of the Veselova system in {n} dimensions",
        field={name: _still(name) for name in (u, gamma, S)},
        parameters=(
            *parameters_of(inertia, "entry of the operator of inertia"),
            *(Parameter(s, "ratio of radii", 0.5) for s in sorted(ratio.free_symbols, key=str)),
        ),
        laws=(
            Identity(
                "measure",
                residual - vanishing,
                "divergence and rate of the density cancel",
                source=SOURCE,
            ),
        ),
    )


def energy_of_ball(n: int) -> System:
    """The rate of the energy ½(k, Sk) of the Chaplygin ball, which vanishes for every inertia.

    It is ([k, ω], ω) − ½(ω, Ȧω), as Ṡ = −SȦS.

    Parameters
    ----------
    n : int
        The dimension of space.
    """
    k, omega, gamma = Skew("k", n), Skew("omega", n), Column("gamma", n)
    K, W, y = (sp.Matrix(name.entries) for name in (k, omega, gamma))
    turning = -W * y
    change = turning * y.T + y * turning.T
    terms = zip(above(K * W - W * K), above(W), strict=True)
    rate = sp.Add(*(a * b for a, b in terms))
    pairing = zip(above(W * change + change * W), above(W), strict=True)
    rate -= HALF * D * sp.Add(*(a * b for a, b in pairing))
    law = Identity("energy", rate, "the energy is constant", source=SOURCE)
    return System(
        name="chaplygin-ball-energy",
        title=f"The energy of the Chaplygin ball in {n} dimensions",
        field={name: _still(name) for name in (k, omega, gamma)},
        parameters=(Parameter(m, "mass", 1.0, "kg"), Parameter(R, "radius", 1.0, "m")),
        laws=(law,),
    )


def energy_of_veselova(n: int) -> System:
    """The rate of the energy ½(p, Sp) of the Veselova system, which vanishes for every inertia.

    It is (ṗ, u) − ½(u, Ḃu) = (u, p)(u, γ) + ½ Σ uᵢ (u, ∂ᵢB u), of which what I adds vanishes and
    γγᵀ adds u²(u, γ): both terms that are left have the factor (u, γ), zero on the phase space.

    Parameters
    ----------
    n : int
        The dimension of space.
    """
    u, gamma = Column("u", n), Column("gamma", n)
    inertia = named_operator("I", len(pairs(n)))
    x, y = (sp.Matrix(name.entries) for name in (u, gamma))
    B = operator_of_planes(inertia, y)
    rate = HALF * sp.Add(*(x[i] * (x.T * B.diff(y[i]) * x)[0] for i in range(n)))
    vanishing = (x.T * x)[0] * (x.T * y)[0]
    law = Identity("energy", rate - vanishing, "the energy is constant", source=SOURCE)
    return System(
        name="veselova-energy",
        title=f"The energy of the Veselova system in {n} dimensions",
        field={name: _still(name) for name in (u, gamma)},
        parameters=parameters_of(inertia, "entry of the operator of inertia"),
        laws=(law,),
    )


def momentum_of_veselova(n: int) -> System:
    """The rate of p² in the Veselova system, 2(u, p)(γ, p), which vanishes for every inertia.

    Parameters
    ----------
    n : int
        The dimension of space.
    """
    p, u, gamma = Column("p", n), Column("u", n), Column("gamma", n)
    rate = Rate(norm_squared(p)) - 2 * dot(u, p) * dot(gamma, p)
    law = Identity("momentum", rate, "the square of the momentum is constant", source=SOURCE)
    return System(
        name="veselova-momentum",
        title=f"The momentum of the Veselova system in {n} dimensions",
        field={p: dot(u, p) * gamma, gamma: -u},
        parameters=tuple(Parameter(s, "velocity of γ", 1.0, "rad/s") for s in u.symbols),
        laws=(law,),
    )


def suslov(n: int) -> System:
    """The rates of energy and of (j, Bw) in Suslov's problem, B ẇ = f, for every B.

    As B is constant, that of ½(Bw, w) is (w, f), and that of (j, Bw) is (j, f).

    Parameters
    ----------
    n : int
        The dimension of space.
    """
    j, w, f = (Column(name, n - 1) for name in ("j", "w", "f"))
    fall = dot(j, f) - dot(j, w) ** 2 + norm_squared(j) * norm_squared(w)
    return System(
        name="suslov-rates",
        title=f"Energy and momentum of Suslov's problem in {n} dimensions",
        field={name: _still(name) for name in (j, w)},
        definitions=((f, dot(j, w) * w - norm_squared(w) * j),),
        laws=(
            Identity("energy", dot(w, f), "the energy is constant", source=SOURCE),
            Identity("monotone", fall, "the momentum along j never grows", source=SOURCE),
        ),
    )


def operator_of_planes(inertia: sp.Matrix, y: sp.Matrix) -> sp.Matrix:
    """B with (Bx, z) = (I(x∧γ), z∧γ) + (x, γ)(z, γ)."""
    n = len(y)
    turns = [sp.Matrix(above(_unit(n, a) * y.T - y * _unit(n, a).T)) for a in range(n)]
    return sp.Matrix(n, n, lambda a, b: (turns[a].T * inertia * turns[b])[0] + y[a] * y[b])


def _still(name: sp.MatrixExpr) -> Components:
    return Components.zeros(*name.shape)

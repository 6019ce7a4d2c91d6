"""The rubber ball on a sphere of n dimensions whose inertia has the symmetry SO(r)×SO(n − r).

Let I_ij = A for i, j ≤ r, B for i, j > r, and C between both blocks, and γ′, γ″ be the parts of γ.
Then p′∧γ′ times a power of φ′ is constant in the body, entry by entry, and so is p″∧γ″:

    (p′∧γ′) φ′^(1/(2ε) − 1),    φ′ = (A + mR²)|γ′|² + (C + mR²)|γ″|²,    ε = a/(R + a),
    (p″∧γ″) φ″^(1/(2ε) − 1),    φ″ = (B + mR²)|γ″|² + (C + mR²)|γ′|².

The rates of these integrals are proven to vanish with A, B, C, m, R and a as symbols, and another
power is refuted; borisov-mamaev-2008/docs/open-problems.md has the argument for every n.
"""

from __future__ import annotations

from itertools import combinations

import sympy as sp

import chaplygin as ch
import flowlanes


def integrals(n: int, r: int, slip: sp.Expr = sp.S.Zero) -> tuple[ch.System, flowlanes.Identity]:
    """The ball of n dimensions, and the law that the logarithmic rates of the integrals vanish.

    Parameters
    ----------
    n, r : int
    slip : sympy.Expr, optional
        What is added to the power of φ′ and φ″.
    """
    system = ch.from_catalogue("rubber-ball-on-sphere-nd", dimension=n)
    known = {str(s): s for s in (*system.symbols, *(p.symbol for p in system.parameters))}
    numbers = range(1, n + 1)
    blocks = (range(1, r + 1), range(r + 1, n + 1))
    p, gamma = ({i: known[f"{name}_{i}"] for i in numbers} for name in ("p", "gamma"))
    moment = {(i, j): known[f"I_{i}{j}"] for i, j in combinations(numbers, 2)}
    kind = {(i, j): (i <= r) + (j <= r) for i, j in moment}
    first = {
        which: next((moment[x] for x in moment if kind[x] == which), None) for which in (0, 1, 2)
    }
    on = tuple(moment[x] - first[kind[x]] for x in moment if moment[x] != first[kind[x]])
    m, R, a = (known[name] for name in "mRa")
    power = (R + a) / (2 * a) - 1 + slip
    rates = []
    for which, (own, other) in zip((2, 0), (blocks, blocks[::-1]), strict=True):
        for i, j in combinations(own, 2):
            phi = (first[which] + m * R**2) * sum(gamma[k] ** 2 for k in own)
            phi += (first[1] + m * R**2) * sum(gamma[k] ** 2 for k in other)
            entry = p[i] * gamma[j] - p[j] * gamma[i]
            rates.append(phi * flowlanes.Rate(entry) + power * flowlanes.Rate(phi) * entry)
    meaning = "linear integrals of an operator of inertia with the symmetry SO(r)×SO(n − r)"
    return system, flowlanes.Identity("linear", tuple(rates), meaning, level=on)


def main() -> None:
    for n, r in ((4, 2), (4, 3), (5, 2)):
        system, law = integrals(n, r)
        print(
            f"n = {n}, r = {r}: {len(law.value)} linear integrals", ch.prove(system, law).decision
        )
    system, law = integrals(4, 2, slip=sp.Rational(1, 3))
    print("another power:", ch.prove(system, law).decision)


if __name__ == "__main__":
    main()

"""Relations with small integer coefficients between residues."""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpz_mat

from ..claim.jets import Number

#: Largest coefficient.
LARGEST = 64


def relation(target: Number, basis: Sequence[Number], modulus: int) -> list[int] | None:
    """Small integers k with target = Σ k · basis, or None if none are found.

    Short vectors of the lattice of all relations are found by the algorithm of Lenstra, Lenstra
    and Lovász; the result is verified.
    """
    size = len(basis)
    for sign in (1, -1):
        for i, element in enumerate(basis):
            if target == sign * element:
                return [sign * (i == j) for j in range(size)]
    if target == 0:
        return [0] * size
    if not size:
        return None
    # Large weights on the last column force short vectors to satisfy the relation modulo p.
    weight = 2**20
    column = [*(int(b) for b in basis), int(target), modulus]
    rows = [
        [*(int(i == j) for j in range(size + 1)), weight * entry]
        for i, entry in enumerate(column[:-1])
    ]
    rows.append([*[0] * (size + 1), weight * modulus])
    for row in fmpz_mat(rows).lll().tolist():
        numbers = [int(n) for n in row]
        if abs(numbers[size]) != 1 or numbers[-1]:
            continue
        found = [-numbers[size] * n for n in numbers[:size]]
        if max(map(abs, found), default=0) <= LARGEST and target == sum(
            (n * b for n, b in zip(found, basis, strict=True)), 0
        ):
            return found
    return None

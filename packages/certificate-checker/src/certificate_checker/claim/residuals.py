"""Residuals of a law, which vanish where it is valid, evaluated at a point.

An integral F has v(F) = 0.  A density ρ has div(ρv) = 0 for the volume on the level of the
conditions.  A symmetry field commutes with v and preserves the conditions.  A bracket is skew, has
the conditions and its Casimir functions as Casimirs, satisfies the Jacobi identity and has at most
the stated rank.  A conformally Hamiltonian field is N J dH.  An isomorphism maps field and
relations to those of its target.  Reductions, separations and identities are formulas that vanish;
the separation itself is checked in :mod:`.separation`.  For every law the rates of the conditions
come first.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations

from flint import arb

from .claim import Claim
from .errors import CheckError, UndefinedError
from .evaluate import Point
from .formulas import Formula, call, name, number
from .functions import Functions
from .jets import Number, add, inverse, multiply
from .separation import parts

#: Maximum number of residuals of a law.
MANY = 20_000


def residuals(claim: Claim, point: Point) -> list[Number]:
    """All expressions that must vanish, in order."""
    values = []
    for value in each_residual(claim, point):
        values.append(value)
        if len(values) > MANY:
            raise CheckError(f"the law has more than {MANY} residuals")
    return values


def each_residual(claim: Claim, point: Point) -> Iterator[Number]:
    """Residuals of a claim, computed one after the other."""
    for condition in claim.moving:
        yield point(call("Rate", [condition]))
    for value in _KINDS[claim.law.kind](claim, point):
        # An empty sum is the int 0, which becomes a number of the right kind here.
        yield add(value, point.functions.number(Fraction(0)))


def _sum(parts: Sequence[Number]) -> Number:
    result: Number = 0
    for part in parts:
        result = add(result, part)
    return result


def _minus(a: Number, b: Number) -> Number:
    return add(a, multiply(-1, b))


def _integral(claim: Claim, point: Point) -> Iterator[Number]:
    yield point(call("Rate", [claim.law.single["value"]]))


def _identity(claim: Claim, point: Point) -> Iterator[Number]:
    there = point.with_definitions(claim.law.quantities)
    for formula in claim.law.several["value"]:
        yield there(formula)


def _reduction(claim: Claim, point: Point) -> Iterator[Number]:
    there = point.with_definitions(claim.law.quantities)
    for formula in claim.law.several["equations"]:
        yield there(formula)


# --- invariant measure ---------------------------------------------------------------------------


def _measure(claim: Claim, point: Point) -> Iterator[Number]:
    system = claim.system
    partial = point.partial(system.state)
    rates = [point(rate) for rate in system.rates]
    # div(ρ v)/ρ = div v + Σ n v(f)/f for ρ = ∏ f^n.  On the level F = 0 the volume changes by the
    # trace of C in v(F) = C F, which is subtracted.
    total = _sum([partial.slopes(r).get(i, 0) for i, r in enumerate(system.rates)])
    for base, exponent in claim.law.pairs["density"]:
        along = _sum([multiply(s, rates[i]) for i, s in partial.slopes(base).items()])
        part = multiply(point(exponent), multiply(along, inverse(point(base))))
        total = add(total, part)
    yield _minus(total, _transverse(claim, partial))


def _transverse(claim: Claim, partial: Point) -> Number:
    """Trace of C, where v(F_i) = Σ C_ij F_j for the conditions F.

    C is the solution of ∇v(F_i) · ∇F_k = Σ C_ij ∇F_j · ∇F_k.
    """
    normals = _normals(claim, partial)
    drifts = [partial.slopes(call("Rate", [c])) for c in claim.moving]
    functions = partial.functions
    if not any(functions.is_nonzero(slope) for drift in drifts for slope in drift.values()):
        return 0
    gram = [[_dot(a, b) for b in normals] for a in normals]
    right = [[_dot(drift, normal) for normal in normals] for drift in drifts]
    size = len(normals)
    # The Gram matrix is symmetric, so its product with C^T is `right` transposed.
    columns = [[right[j][i] for j in range(size)] for i in range(size)]
    solution = _solution(gram, columns, functions)
    return _sum([solution[i][i] for i in range(size)])


def _normals(claim: Claim, partial: Point) -> list[Mapping[int, Number]]:
    return [partial.slopes(condition) for condition in claim.moving]


def _dot(a: Mapping[int, Number], b: Mapping[int, Number]) -> Number:
    return _sum([multiply(slope, b[i]) for i, slope in a.items() if i in b])


def gram_determinants(claim: Claim, point: Point) -> list[Number]:
    """Leading minors of the Gram matrix of the conditions.

    If the last one is nonzero, the conditions are independent and all minors are positive.
    """
    normals = _normals(claim, point.partial(claim.system.state))
    rows = [[_dot(a, b) for b in normals] for a in normals]
    determinants: list[Number] = []
    for i in range(len(rows)):
        if not point.functions.is_nonzero(rows[i][i]):
            raise UndefinedError("the conditions are dependent")
        determinants.append(multiply(determinants[-1], rows[i][i]) if determinants else rows[i][i])
        for j in range(i + 1, len(rows)):
            factor = rows[j][i] / rows[i][i]
            rows[j] = [x - factor * y for x, y in zip(rows[j], rows[i], strict=True)]
    return determinants


def _solution(
    matrix: Sequence[Sequence[Number]], right: Sequence[Sequence[Number]], functions: Functions
) -> list[list[Number]]:
    """Solution of linear equations with a positive matrix, whose leading minors are nonzero."""
    rows = [[*a, *b] for a, b in zip(matrix, right, strict=True)]
    # Elimination without pivoting is possible, because all leading minors are nonzero.
    size = len(rows)
    for i in range(size):
        if not functions.is_nonzero(rows[i][i]):
            raise UndefinedError("the conditions are dependent")
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for j in range(size):
            if j != i:
                factor = rows[j][i]
                rows[j] = [x - factor * y for x, y in zip(rows[j], rows[i], strict=True)]
    return [row[size:] for row in rows]


# --- symmetry fields, brackets -------------------------------------------------------------------


def _symmetry(claim: Claim, point: Point) -> Iterator[Number]:
    system = claim.system
    partial = point.partial(system.state)
    components = dict(claim.law.pairs["field"])
    rates = [point(rate) for rate in system.rates]
    push = [point(components[word]) if word in components else 0 for word in system.state]

    def along(slopes: Mapping[int, Number], field: Sequence[Number]) -> Number:
        return _sum([multiply(slope, field[i]) for i, slope in slopes.items()])

    for condition in claim.moving:
        yield along(partial.slopes(condition), push)
    # [u, v]_k = u(v_k) − v(u_k) for every coordinate k.
    for word, rate in zip(system.state, system.rates, strict=True):
        shift = partial.slopes(components[word]) if word in components else {}
        yield _minus(along(partial.slopes(rate), push), along(shift, rates))


def _poisson(claim: Claim, point: Point) -> Iterator[Number]:
    law, size = claim.law, len(claim.system.state)
    partial = point.partial(claim.system.state)
    values = [[point(entry) for entry in row] for row in law.matrix]
    slopes = [[partial.slopes(entry) for entry in row] for row in law.matrix]
    # Skew symmetry, Casimir functions and the Jacobi identity Σ J_an ∂_n J_bc = 0 over the cyclic
    # permutations of every triple.
    for i in range(size):
        for j in range(i, size):
            yield add(values[i][j], values[j][i])
    for condition in claim.moving:
        yield from _brackets(values, partial.slopes(condition))
    for i, j, k in combinations(range(size), 3):
        parts = [
            multiply(values[a][n], slope)
            for a, b, c in ((i, j, k), (j, k, i), (k, i, j))
            for n, slope in slopes[b][c].items()
        ]
        yield _sum(parts)
    for casimir in law.several["casimirs"]:
        yield from _brackets(values, partial.slopes(casimir))
    # A skew matrix has rank ≤ r exactly if all its Pfaffians of order r + 2 vanish.
    if law.rank is not None:
        for chosen in combinations(range(size), law.rank + 2):
            yield _pfaffian(values, chosen)


def _brackets(values: Sequence[Sequence[Number]], slopes: Mapping[int, Number]) -> Iterator[Number]:
    for row in values:
        yield _sum([multiply(row[j], slope) for j, slope in slopes.items()])


def _pfaffian(matrix: Sequence[Sequence[Number]], rows: tuple[int, ...]) -> Number:
    if not rows:
        return 1
    first, *others = rows
    # Expansion along the first row.
    total: Number = 0
    for position, other in enumerate(others):
        remaining = tuple(n for n in others if n != other)
        part = multiply(matrix[first][other], _pfaffian(matrix, remaining))
        total = add(total, part) if position % 2 == 0 else _minus(total, part)
    return total


def _hamiltonian(claim: Claim, point: Point) -> Iterator[Number]:
    yield from _poisson(claim, point)
    law = claim.law
    gradient = point.partial(claim.system.state).slopes(law.single["hamiltonian"])
    multiplier = point(law.single["multiplier"])
    for row, rate in zip(law.matrix, claim.system.rates, strict=True):
        total = _sum([multiply(point(row[j]), slope) for j, slope in gradient.items()])
        yield _minus(point(rate), multiply(multiplier, total))


# --- isomorphisms --------------------------------------------------------------------------------


def target_point(claim: Claim, point: Point) -> Point:
    """Image of a point in the target of an isomorphism."""
    law, target = claim.law, claim.law.target
    assert target is not None
    values = {word: point(formula) for word, formula in law.pairs["constants"]}
    for word in target.parameters:
        if word not in values:
            values[word] = point.values[word]
    settled = {}
    for word in target.parameters:
        exact = point.exact(dict(law.pairs["constants"]).get(word, name(word)))
        if exact is not None:
            settled[word] = number(exact)
    values |= {word: point(formula) for word, formula in law.pairs["map"]}
    for word in claim.system.parameters:
        # The conditions on the image may depend on parameters of the system.
        if word not in values and word not in target.definitions:
            values[word] = point.values[word]
    return target.point(values, point.functions, settled)


def _isomorphism(claim: Claim, point: Point) -> Iterator[Number]:
    law, target = claim.law, claim.law.target
    assert target is not None
    for _, formula in law.pairs["constants"]:
        yield point(call("Rate", [formula]))
    there = target_point(claim, point)
    for condition in (*target.relations, *law.several["onto"]):
        yield there(condition)
    speed = point(law.single["time"])
    images = dict(law.pairs["map"])
    for word, rate in zip(target.state, target.rates, strict=True):
        yield _minus(point(call("Rate", [images[word]])), multiply(speed, there(rate)))


_KINDS = {
    "Integral": _integral,
    "Identity": _identity,
    "Reduction": _reduction,
    "Separation": _reduction,
    "Measure": _measure,
    "Symmetry": _symmetry,
    "PoissonStructure": _poisson,
    "ConformallyHamiltonian": _hamiltonian,
    "Isomorphism": _isomorphism,
}


# --- ranks ---------------------------------------------------------------------------------------


def is_on_rank(claim: Claim) -> bool:
    """True if a law states a lower bound of a rank."""
    return claim.law.kind in ("Isomorphism", "Separation") or claim.law.rank is not None


def rank_at_least(claim: Claim, point: Point) -> bool:
    """True if at a point the ranks are certainly as large as stated."""
    law, system = claim.law, claim.system
    if law.rank is not None:
        return _rank([[point(entry) for entry in row] for row in law.matrix]) >= law.rank
    size = len(system.state)
    formulas: list[Formula] = [*claim.moving]
    if law.kind == "Separation":
        # On a level of the constants the quantities must be independent.
        stated = parts(claim)
        formulas += [name(word) for word in (*stated.constants, *stated.quantities)]
        wanted = len(formulas)
    else:
        formulas += [f for _, f in (*law.pairs["map"], *law.pairs["constants"])]
        wanted = size
    partial = point.with_definitions(law.quantities).partial(system.state)
    rows = [[partial.slopes(f).get(i, arb(0)) for i in range(size)] for f in formulas]
    return _rank(rows) >= wanted


def _rank(rows: list[list[arb]]) -> int:
    """Lower bound of the rank that is certain."""
    rows = [list(row) for row in rows]
    rank = 0
    for column in range(len(rows[0]) if rows else 0):
        if rank == len(rows):
            break
        # The pivot with the largest lower bound keeps the balls of the other rows narrow.
        best = max(range(rank, len(rows)), key=lambda i: rows[i][column].abs_lower())
        if rows[best][column].contains(0):
            continue
        rows[rank], rows[best] = rows[best], rows[rank]
        head = rows[rank]
        for i in range(rank + 1, len(rows)):
            factor = rows[i][column] / head[column]
            rows[i] = [x - factor * y for x, y in zip(rows[i], head, strict=True)]
        rank += 1
    return rank

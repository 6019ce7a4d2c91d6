"""Projection of a state onto a level of integrals and relations, as terms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from ...formulas.graph import Graph, Term


@dataclass(frozen=True)
class ProjectionTerms:
    """Functions of the state that are constant along every motion.

    Attributes
    ----------
    residuals : tuple of Term
        Functions that vanish; their variables are the state variables and then the values of the
        level.
    correction : tuple of Term
        Change of each state variable that makes them vanish, in terms of their residuals.
    """

    residuals: tuple[Term, ...]
    correction: tuple[Term, ...]


def projection_terms(
    graph: Graph,
    conserved: Sequence[Term],
    vanishing: Sequence[Term],
    groups: Sequence[Sequence[int]],
    residuals: Sequence[Term],
) -> ProjectionTerms:
    """Projection onto given values of some functions and zeros of others.

    The change is the shortest one if each vector of the state is measured relative to its length:
    −D Gᵀ(G D Gᵀ)⁻¹ c, with the gradients G, the residuals c and the squared lengths D.  Where
    gradients are dependent, as in a steady motion, their common part is corrected once.

    Parameters
    ----------
    graph : Graph
    conserved, vanishing : sequence of Term
    groups : sequence of sequence of int
        Indices of the components of each vector of the state.
    residuals : sequence of Term
        Deviations of the functions from their values, in this order.
    """
    size = sum(map(len, groups))
    states = [graph.state(i) for i in range(size)]
    functions = [*conserved, *vanishing]
    zero, one = graph.number(0), graph.number(1)
    lengths = [zero] * size
    for group in groups:
        # not zero, so that a vanishing vector has a finite reciprocal
        total = graph.number(Fraction(1, 10**200))
        for i in group:
            total = total + states[i] * states[i]
        for i in group:
            lengths[i] = total
    columns = [
        graph.directional_derivative(functions, {s: one if s is x else zero for s in states})
        for x in states
    ]
    gradients = [[columns[i][k] for i in range(size)] for k in range(len(functions))]
    scaled = [[g * d for g, d in zip(row, lengths, strict=True)] for row in gradients]
    matrix = [[dot(graph, row, other) for other in scaled] for row in gradients]
    shares = _solution(graph, matrix, residuals)
    moves = [
        -dot(graph, shares, [scaled[k][i] for k in range(len(functions))]) for i in range(size)
    ]
    left = [value - graph.state(size + k) for k, value in enumerate(conserved)]
    return ProjectionTerms((*left, *vanishing), tuple(moves))


def dot(graph: Graph, a: Sequence[Term], b: Sequence[Term]) -> Term:
    """The sum of products."""
    total = graph.number(0)
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def _solution(graph: Graph, matrix: list[list[Term]], right: Sequence[Term]) -> list[Term]:
    """Solve symmetric equations, ignoring rows that depend on earlier ones."""
    size = len(right)
    rows = [[*row, b] for row, b in zip(matrix, right, strict=True)]
    pivots = []
    for k in range(size):
        # In exact arithmetic the pivot of a dependent row is zero; here it is compared with the
        # diagonal entry before elimination.
        share = matrix[k][k] * graph.number(Fraction(1, 10**10))
        pivot = rows[k][k]
        inverse = graph.where_positive(pivot - share, graph.recip(pivot), graph.number(0))
        pivots.append(inverse)
        for i in range(k + 1, size):
            factor = rows[i][k] * inverse
            rows[i] = [
                rows[i][j] - factor * rows[k][j] if j > k else rows[i][j] for j in range(size + 1)
            ]
    solution: list[Term] = [graph.number(0)] * size
    for k in reversed(range(size)):
        remainder = rows[k][size]
        for j in range(k + 1, size):
            remainder = remainder - rows[k][j] * solution[j]
        solution[k] = remainder * pivots[k]
    return solution

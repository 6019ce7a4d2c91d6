"""Solve bodies described in non-principal axes in their principal axes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import acb_mat, arb, arb_mat, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.balls import ball, exact, number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Symmetric

from ..catalogue import entry
from ..mechanics.conventions import BODY
from ..mechanics.rolling.equations import RollingBody
from .base.derived_solution import DerivedSolution
from .base.problem import Problem, same_field
from .base.solution import Solution
from .one_degree.vectors import quaternion_products

#: Digits of the principal axes.
DIGITS = 220
SPACE, QUATERNION = 3, 4
#: Systems about a fixed point that are solved in principal axes.
ABOUT_FIXED_POINT = ("free-body", "veselova")


@dataclass(frozen=True, repr=False)
class PrincipalAxesSolution(DerivedSolution):
    """A motion that is known in other body axes.

    Attributes
    ----------
    matrix : arb_mat (size, size)
        Orthogonal; it takes its states to those of `system`.
    """

    matrix: arb_mat

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """Lifted states at `times` (n,), as an array (n, size), in double precision."""
        turn: FloatArray = np.array([[number(x) for x in row] for row in self.matrix.tolist()])
        return self.inner.states(times) @ turn.T

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The lifted state at one time as balls that contain the exact one."""
        with ctx.workdps(digits + 30):
            inner = self.inner.rigorous(time, digits)
            # Zero times an infinite ball is infinite in ball arithmetic.
            return tuple(
                sum((a * x for a, x in zip(row, inner, strict=True) if not a.is_zero()), arb(0))
                for row in self.matrix.tolist()
            )


def in_principal_axes(problem: Problem, rolling: RollingBody) -> tuple[Problem, arb_mat] | None:
    """A ball in its principal axes; the axis of symmetry of a rubber ball is last.

    Returns
    -------
    Problem, arb_mat
        The same motion in those axes, and the orthogonal matrix that takes its lifted states
        back; None where the axes are such already, or the body is no ball and has axes of its
        own.

    Raises
    ------
    InputError
        If two principal moments of a full tensor are so near that they do not determine the axes.
    """
    if not rolling.body.shape.is_ball:
        return None
    order = _order(problem, rolling) if rolling.body.principal else None
    if rolling.body.principal and order is None:
        return None
    with ctx.workdps(DIGITS):
        if order is not None:
            moments: Sequence[NumberOrText] = [
                problem.parameters[Diagonal("I").symbols[i]] for i in order
            ]
            axes = arb_mat([[int(i == row) for i in order] for row in range(SPACE)])
        else:
            a, b, c, d, e, f = (ball(exact(problem.parameters[s])) for s in Symmetric("I").symbols)
            moments, axes = principal_axes([[a, b, c], [b, d, e], [c, e, f]])
        lifted = problem.system.lifted() if problem.system.reconstruction else problem.system
        matrix = _blocks(lifted, axes)
        column = arb_mat([[ball(exact(x))] for x in problem.start])
        start = tuple(row[0] for row in (matrix.transpose() * column).tolist())
        turn = [[number(x) for x in row] for row in axes.tolist()]
        principal = _ball_in_axes(rolling, [number(x) for x in moments], np.array(turn))
        system = principal.system(problem.system.name, problem.system.title)
        if problem.system.reconstruction is None:
            system = replace(system, reconstruction=None)
        parameters = {
            **system.defaults,
            **{s: x for s, x in problem.parameters.items() if s in system.defaults},
            **dict(zip(Diagonal("I").symbols, moments, strict=True)),
        }
        return Problem(system, parameters, start, principal), matrix


def about_fixed_point(problem: Problem) -> tuple[Problem, arb_mat] | None:
    """A free body or Veselova system with a full inertia tensor, in principal axes.

    Recognised by its equations; the parameters of the problem are the tensor's.

    Returns
    -------
    Problem, arb_mat
        As `in_principal_axes`; None for any other system.

    Raises
    ------
    InputError
        If two principal moments are so near that they do not determine the axes.
    """
    system, full = problem.system, Symmetric("I")
    numbers = {s: exact(x) for s, x in problem.parameters.items()}
    tensors = {Diagonal("I"): full, Diagonal("A"): Symmetric("A")}
    for name in ABOUT_FIXED_POINT:
        principal = entry(name).system()
        definitions = [
            (_with_tensors(s, tensors), _with_tensors(f, tensors)) for s, f in principal.definitions
        ]
        same = replace(
            principal,
            parameters=system.parameters,
            definitions=definitions,
            laws=(),
            observables=(),
            conventions=BODY,
        )
        if system.state != principal.state or not same_field(system, numbers, same, numbers):
            continue
        with ctx.workdps(DIGITS):
            a, b, c, d, e, f = (ball(numbers[s]) for s in full.symbols)
            moments, axes = principal_axes([[a, b, c], [b, d, e], [c, e, f]])
            lifted = system.lifted() if system.reconstruction else system
            matrix = _blocks(lifted, axes)
            column = arb_mat([[ball(exact(x))] for x in problem.start])
            start = tuple(row[0] for row in (matrix.transpose() * column).tolist())
        if system.reconstruction is None:
            principal = replace(principal, reconstruction=None)
        parameters = dict(zip(Diagonal("I").symbols, moments, strict=True))
        return Problem(principal, parameters, start), matrix
    return None


def _with_tensors(formula: sp.Basic, tensors: Mapping[sp.Basic, sp.Basic]) -> sp.Basic:
    """A formula with some tensors replaced by others."""
    return formula.xreplace(dict(tensors))


def _order(problem: Problem, rolling: RollingBody) -> tuple[int, int, int] | None:
    """The order of axes for a rubber ball with two equal moments: its axis of symmetry last."""
    if rolling.contact != "rubber":
        return None
    first, second, third = (exact(problem.parameters[s]) for s in Diagonal("I").symbols)
    if first == second or third not in (first, second):
        return None
    return (1, 2, 0) if second == third else (2, 0, 1)


def to_original_axes(problem: Problem, inner: Solution, matrix: arb_mat) -> PrincipalAxesSolution:
    """A solution in principal axes expressed in the axes of the problem."""
    lifted = problem.system.lifted() if problem.system.reconstruction else problem.system
    return PrincipalAxesSolution(lifted, problem.parameters, inner, matrix)


def _ball_in_axes(rolling: RollingBody, moments: Sequence[float], axes: FloatArray) -> RollingBody:
    """The ball, described in its principal axes."""
    body, shape = rolling.body, rolling.body.shape
    first, second, third = moments
    turned = replace(
        body,
        inertia=(first, second, third),
        shape=replace(shape, centre=_along_columns(shape.centre, axes)),
        gyrostat=_along_columns(body.gyrostat, axes),
    )
    return replace(rolling, body=turned)


def _along_columns(vector: Sequence[float], axes: FloatArray) -> tuple[float, float, float]:
    """A vector by its components along the columns of `axes`."""
    x, y, z = (float(part) for part in axes.T @ np.array(vector))
    return x, y, z


def principal_axes(rows: Sequence[Sequence[arb]]) -> tuple[list[arb], arb_mat]:
    """Principal moments, increasing, and the right-handed matrix whose columns are the axes.

    Parameters
    ----------
    rows : 3×3 arb
        A symmetric tensor; one that is diagonal keeps its axes and their order.

    Raises
    ------
    InputError
        If two principal moments are so near that they do not determine the axes.
    """
    if all(rows[i][j] == 0 for i in range(SPACE) for j in range(SPACE) if i != j):
        unit = arb_mat([[int(i == j) for j in range(SPACE)] for i in range(SPACE)])
        return [rows[i][i] for i in range(SPACE)], unit
    tensor = acb_mat([list(row) for row in rows])
    try:
        values, vectors = tensor.eig(right=True)
    except ValueError:
        raise InputError(
            "inertia: two principal moments of this tensor coincide, so that its axes are not "
            "determined; give the body in principal axes"
        ) from None
    order = sorted(range(SPACE), key=lambda i: number(values[i].real))
    columns = []
    for i in order:
        column = [vectors[j, i].real for j in range(SPACE)]
        length = sum((x * x for x in column), arb(0)).sqrt()
        columns.append([x / length for x in column])
    axes = arb_mat(columns).transpose()
    if axes.det() < 0:
        axes = arb_mat([*columns[:2], [-x for x in columns[2]]]).transpose()
    return [values[i].real for i in order], axes


def _blocks(lifted: System, axes: arb_mat) -> arb_mat:
    """The matrix that takes lifted states in principal axes to the body's own axes.

    With u = S u′ for vectors in body axes the attitude is q = q′ s̄, s the quaternion of S.
    """
    size = len(lifted.symbols)
    matrix = [[arb(int(i == j)) for j in range(size)] for i in range(size)]
    blocks = {SPACE: axes, QUATERNION: _times_conjugate(quaternion_of(axes))}
    for _, place in lifted.slices:
        block = blocks.get(place.stop - place.start)
        if block is not None:
            for i, row in enumerate(matrix[place]):
                row[place] = block.table()[i]
    return arb_mat(matrix)


def quaternion_of(turn: arb_mat) -> tuple[arb, arb, arb, arb]:
    """The unit quaternion (w, x, y, z) of a rotation matrix, dividing by its largest component."""
    columns = quaternion_products(turn.tolist())
    largest = max(range(QUATERNION), key=lambda i: number(columns[i][i]))
    length = sum((x * x for x in columns[largest]), arb(0)).sqrt()
    w, x, y, z = (x / length for x in columns[largest])
    return w, x, y, z


def _times_conjugate(s: tuple[arb, arb, arb, arb]) -> arb_mat:
    """The matrix of p ↦ p s̄ for quaternions (w, x, y, z)."""
    w, x, y, z = s
    return arb_mat([[w, x, y, z], [-x, w, -z, y], [-y, z, w, -x], [-z, -y, x, w]])

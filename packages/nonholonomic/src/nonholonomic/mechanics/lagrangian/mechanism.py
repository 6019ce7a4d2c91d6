"""Mechanisms: coordinates, a frame, a Lagrangian and constraints (§1).

A frame of vector fields E_i on the configuration space, (1.7), gives every velocity by its
components w_i, the quasi-velocities: q̇ = G(q) w.  A `Mechanism` adds the Lagrangian in q and w,
generalised forces and constraints; :mod:`nonholonomic.mechanics.lagrangian.poincare_suslov` turns
it into a System.

Coordinates may be redundant (direction cosines, quaternions): the frame is then tangent to the
relations between them.  A frame may also act on fewer coordinates than it has fields: those of a
system reduced by a symmetry group, such as the vertical γ of a body whose position and heading are
cyclic. The fields on the coordinates are then dependent, and the structure functions of (1.8) have
to be given.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import sympy as sp

from flowlanes.arguments import Formula, NamedFormulas, arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Law
from flowlanes.system.named_formulas import Pairs, as_pairs, expand, flat, flat_pairs, scalars
from flowlanes.system.system import Guard, Name, Observable, Parameter, unknown_names
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import Vector, cross, real_symbol

#: c_ij^k by the velocities (w_i, w_j), then by w_k; missing entries are zero or follow by
#: antisymmetry.
Structure: TypeAlias = tuple[tuple[tuple[sp.Symbol, sp.Symbol], Pairs], ...]

StructureConstants: TypeAlias = dict[tuple[sp.Symbol, sp.Symbol], dict[sp.Symbol, sp.Expr]]

TIME = real_symbol("t")
"""The time, for Lagrangians and constraints that depend on it."""


@arguments_checked
@dataclass(frozen=True)
class Frame:
    """Coordinates and quasi-velocities, related by q̇ = G(q) w (1.7).

    Parameters
    ----------
    rates : mapping of Vector or Symbol to formula
        q̇ = G(q) w for every coordinate, linear and homogeneous in the velocities.
    velocities : tuple of Vector or Symbol
        The quasi-velocities w, in order.
    relations : tuple of sympy.Expr
        Expressions that vanish on the configuration space; the frame must be tangent to it.
    structure : Structure, optional
        c_ij^k of (1.8) if they are not to be computed from the fields: a mapping from pairs of
        velocities to mappings from velocity to coefficient.

    Raises
    ------
    InputError
        If a rate is not linear in the velocities, or two symbols have the same name.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, phi, u, v, w = sp.symbols("x y phi u v omega", real=True)
    >>> c, s = sp.cos(phi), sp.sin(phi)
    >>> body_axes = nonholonomic.Frame({x: u * c - v * s, y: u * s + v * c, phi: w}, (u, v, w))
    >>> body_axes.matrix
    Matrix([
    [cos(phi), -sin(phi), 0],
    [sin(phi),  cos(phi), 0],
    [       0,         0, 1]])
    """

    rates: NamedFormulas
    velocities: tuple[Name, ...]
    relations: tuple[sp.Expr, ...] = ()
    structure: NamedFormulas | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "rates", as_pairs(self.rates))
        object.__setattr__(self, "velocities", tuple(self.velocities))
        object.__setattr__(self, "relations", tuple(scalars(tuple(self.relations))))
        if self.structure is not None:
            structure = tuple((pair, as_pairs(row)) for pair, row in as_pairs(self.structure))
            object.__setattr__(self, "structure", structure)
        self._check()

    @cached_property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """The coordinates as scalars."""
        return flat(name for name, _ in self.rates)

    @cached_property
    def w(self) -> tuple[sp.Symbol, ...]:
        """The quasi-velocities as scalars."""
        return flat(self.velocities)

    @cached_property
    def qdot(self) -> tuple[sp.Expr, ...]:
        """The rates of `coordinates`."""
        return tuple(rate for _, rate in flat_pairs(self.rates))

    @cached_property
    def matrix(self) -> sp.ImmutableDenseMatrix:
        """G of q̇ = G w; its columns are the fields E_i."""
        rows = [[sp.diff(rate, s) for s in self.w] for rate in self.qdot]
        return sp.ImmutableDenseMatrix(
            len(self.qdot), len(self.w), [e for row in rows for e in row]
        )

    @arguments_checked
    def field(self, index: int) -> dict[sp.Symbol, sp.Expr]:
        """E_i as a mapping from coordinates to nonzero components."""
        if not 0 <= index < len(self.w):
            raise InputError(f"there is no field {index}; they are 0 to {len(self.w) - 1}")
        column = self.matrix[:, index]
        return {q: e for q, e in zip(self.coordinates, column, strict=True) if e != 0}

    def _check(self) -> None:
        if not self.w:
            raise InputError("frame: it has no velocities; a frame needs one at least")
        for name in _duplicate_names((*self.coordinates, *self.w)):
            raise InputError(f"frame: {name} stands for two things; rename one of them")
        velocities = set(self.w)
        for q, rate in zip(self.coordinates, self.qdot, strict=True):
            inhomogeneous = rate.xreplace(dict.fromkeys(velocities, sp.S.Zero))
            slopes = [sp.diff(rate, s) for s in self.w]
            if inhomogeneous != 0 or any(slope.free_symbols & velocities for slope in slopes):
                raise InputError(
                    f"frame: the rate of {q}, {rate}, must be linear and homogeneous in the "
                    f"velocities {', '.join(map(str, self.w))}"
                )


def _duplicate_names(names: Iterable[sp.Symbol]) -> list[str]:
    """Names shared by several symbols."""
    return [name for name, count in Counter(map(str, names)).items() if count > 1]


@arguments_checked
def coordinates(*names: Name, dot: str = "dot") -> Frame:
    """The coordinate frame w = q̇, with velocities named ``xdot`` for ``x``.

    Parameters
    ----------
    names : Vector or Symbol
        The coordinates, in order.
    dot : str
        Suffix that turns the name of a coordinate into that of its velocity.

    Returns
    -------
    Frame

    Raises
    ------
    InputError
        If a coordinate is neither a vector nor a symbol, or is given twice.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> nonholonomic.coordinates(*sp.symbols("x theta", real=True)).velocities
    (xdot, thetadot)
    """
    symbols = flat(names)
    speeds = tuple(real_symbol(f"{q}{dot}") for q in symbols)
    return Frame(dict(zip(symbols, speeds, strict=True)), speeds)


def rotations(omega: Vector) -> StructureConstants:
    """Structure constants of rotations in body axes, [ξ_i, ξ_j] = ε_ijk ξ_k (1.12)."""
    w = omega.symbols
    return {(w[i], w[(i + 1) % 3]): {w[(i + 2) % 3]: sp.S.One} for i in range(3)}


@arguments_checked
def euclidean(omega: Vector, v: Vector) -> StructureConstants:
    """Structure constants of the Euclidean group in body axes, (1.12).

    Parameters
    ----------
    omega, v : Vector
        Angular velocity and velocity, body axes.

    Returns
    -------
    dict
        Brackets of the quasi-velocities by pairs of their symbols.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> omega, v = flowlanes.system.Vector("omega"), flowlanes.system.Vector("v")
    >>> len(nonholonomic.mechanics.lagrangian.euclidean(omega, v))
    9
    """
    mixed: StructureConstants = {}
    for i in (1, 2, 3):
        for j in (1, 2, 3):
            product = scalars(cross(unit_vector(i), unit_vector(j)))
            row = {s: c for s, c in zip(v.symbols, product, strict=True) if c != 0}
            if row:
                mixed[omega.symbols[i - 1], v.symbols[j - 1]] = row
    return {**rotations(omega), **mixed}


@arguments_checked
@dataclass(frozen=True)
class Mechanism:
    """A Lagrangian in quasi-velocities, with forces and constraints.

    Parameters
    ----------
    name : str
        Identifier, such as ``"chaplygin-sleigh"``.
    frame : Frame
    lagrangian : sympy.Expr
        L̂(t, q, w) = T − U, in the coordinates, velocities, definitions and parameters.
    constraints : tuple of formulas
        f(t, q, w) that vanish: linear, affine, or nonlinear in the velocities; a vector counts
        as three.
    positions : tuple of formulas
        F(t, q) that vanish: holonomic constraints beyond the relations of the frame.
    forces : mapping of velocity to formula
        Generalised forces Q_i along the fields E_i, in addition to those of the potential.
    definitions : mapping of Vector or Symbol to formula
        Named quantities in t, q, w, parameters and earlier ones; never expanded.
    parameters : tuple of Parameter
    observables, guards, laws
        As of a :class:`~flowlanes.system.system.System`.
    title, source, summary : str

    Raises
    ------
    InputError
        If a formula uses a name that is not declared.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, phi, u, v, w = sp.symbols("x y phi u v omega", real=True)
    >>> c, s = sp.cos(phi), sp.sin(phi)
    >>> body_axes = nonholonomic.Frame({x: u * c - v * s, y: u * s + v * c, phi: w}, (u, v, w))
    >>> energy = (u**2 + (v + w) ** 2 + w**2) / 2
    >>> sleigh = nonholonomic.Mechanism("sleigh", body_axes, energy, constraints=(v,))
    >>> dict(
    ...     zip(
    ...         nonholonomic.equations_of_motion(sleigh).state,
    ...         nonholonomic.equations_of_motion(sleigh).rates,
    ...     )
    ... )
    {u: omega**2, omega: -omega*u/2}
    """

    name: str
    frame: Frame
    lagrangian: Formula
    constraints: tuple[Formula, ...] = ()
    positions: tuple[Formula, ...] = ()
    forces: NamedFormulas = ()
    definitions: NamedFormulas = ()
    parameters: tuple[Parameter, ...] = ()
    observables: tuple[Observable, ...] = ()
    guards: tuple[Guard, ...] = ()
    laws: tuple[Law, ...] = ()
    title: str = ""
    source: str = ""
    summary: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "forces", as_pairs(self.forces))
        object.__setattr__(self, "definitions", as_pairs(self.definitions))
        for kind in ("constraints", "positions"):
            object.__setattr__(self, kind, tuple(getattr(self, kind)))
        object.__setattr__(self, "title", self.title or self.name)
        self._check()

    @cached_property
    def L(self) -> sp.Expr:
        """The Lagrangian as a scalar formula."""
        return scalars(self.lagrangian)[0]

    @cached_property
    def f(self) -> tuple[sp.Expr, ...]:
        """The velocity constraints as scalars."""
        return tuple(scalars(self.constraints))

    @cached_property
    def F(self) -> tuple[sp.Expr, ...]:
        """The position constraints as scalars."""
        return tuple(scalars(self.positions))

    @cached_property
    def Q(self) -> dict[sp.Symbol, sp.Expr]:
        """The generalised forces by velocity."""
        return dict(flat_pairs(self.forces))

    @cached_property
    def steps(self) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """The definitions as scalar assignments, in order."""
        return flat_pairs(self.definitions)

    @arguments_checked
    def expand(self, formula: sp.Expr) -> sp.Expr:
        """A scalar formula with all definitions substituted."""
        return expand(sp.sympify(formula), self.steps)

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """Coordinates and velocities."""
        return (*self.frame.coordinates, *self.frame.w)

    def _check(self) -> None:
        parameters = {p.symbol for p in self.parameters}
        known = {TIME, *parameters}
        named = (*(p.symbol for p in self.parameters), *self.symbols, *(s for s, _ in self.steps))
        for name in _duplicate_names(named):
            raise InputError(f"{self.name}: {name} stands for two things; rename one of them")
        still = known | set(self.frame.coordinates)
        defined = {s for s, _ in self.steps}
        for q, rate in zip(self.frame.coordinates, self.frame.qdot, strict=True):
            self._require(rate, still | set(self.frame.w) | defined, f"the rate of {q}")
        for relation in self.frame.relations:
            self._require(relation, still, f"the relation {relation}")
        known = still | set(self.frame.w)
        for symbol, value in self.steps:
            self._require(value, known, f"the definition of {symbol}")
            known.add(symbol)
        self._require(self.L, known, "the Lagrangian")
        for f in self.f:
            self._require(f, known, f"the constraint {f}")
        for f in self.F:
            moving = sorted(map(str, f.free_symbols & set(self.frame.w)))
            if moving:
                raise InputError(
                    f"{self.name}: the position constraint {f} uses the velocity {moving[0]}; it "
                    "may use coordinates alone, or belongs to the constraints on velocities"
                )
            self._require(f, known, f"the position constraint {f}")
        for s, force in self.Q.items():
            if s not in self.frame.w:
                raise InputError(
                    f"{self.name}: a force along {s}, which is no velocity; allowed: "
                    f"{', '.join(map(str, self.frame.w))}"
                )
            self._require(force, known, f"the force along {s}")

    def _require(self, value: sp.Expr, symbols: set[sp.Symbol], where: str) -> None:
        missing = unknown_names(value, symbols)
        if missing:
            raise InputError(
                f"{self.name}: {where} uses {missing}, which is neither a coordinate nor a "
                "velocity, a definition or a parameter"
            )

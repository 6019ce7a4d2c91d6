"""Laws: statements about a system that can be proved or refuted.

Every law is a tensor invariant of the vector field v of its system, or an identity on its phase
space.  It is claimed at the points where the relations of the system and the expressions in
`level`, such as ``k + 1`` or ``(u, v)``, vanish and all its formulas are real.  The docstring of
each class defines its statement.

A new kind of law is a class in one file. If it states that some formulas vanish, it derives from
`VanishingLaw` and returns them as `residuals`; otherwise it derives from `Law` and returns, as
`basic`, an equivalent law of a kind in this module. Provers, certificates, printers and reports
use the methods of a law and do not depend on its class.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any, ClassVar, Protocol, Self, TypeAlias, TypeVar

import sympy as sp

from ..arguments import Formula, Formulas, NamedFormulas, arguments_checked
from ..errors import InputError
from .named_formulas import (
    Pairs,
    in_components,
    repeated_name,
    scalar_names,
    scalars,
    with_formulas,
)
from .overview import WithShortRepr

#: One side of an equation: a formula, or text.
Side: TypeAlias = sp.Basic | str
#: A base in words, with ``{}`` in place of its formula; the base; and its exponent.
Power: TypeAlias = tuple[str, sp.Expr, sp.Expr]


class Rate(sp.Function):
    """The time derivative of a scalar formula along the vector field of its system.

    ``Rate(x)`` stands for ẋ, ``Rate(Rate(theta))`` for the second derivative.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> newton = flowlanes.Identity("newton", flowlanes.Rate(flowlanes.Rate(x)) + x)
    >>> newton.value
    x + Rate(Rate(x))
    """

    nargs = 1

    @arguments_checked
    def __new__(cls, *formulas: Formula, **options: Any) -> Any:
        """Reject strings, which SymPy would evaluate."""
        return super().__new__(cls, *formulas, **options)


class VectorField(Protocol):
    """The part of a system on which a law may depend."""

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The state as scalars."""
        ...

    @property
    def rates(self) -> tuple[sp.Expr, ...]:
        """The time derivatives of `symbols`."""
        ...

    @property
    def scalar_definitions(self) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """The definitions as scalar assignments, in order."""
        ...


class ChangeOfVariables(Protocol):
    """A change of variables for formulas, vector fields and brackets."""

    def formula(self, value: Any) -> Any:
        """A formula, or all formulas in a tuple; other values unchanged."""
        ...

    def vector_field(self, components: Pairs) -> Pairs:
        """A vector field by its components."""
        ...

    def bracket(self, matrix: sp.MatrixBase) -> sp.MatrixBase:
        """A Poisson bracket by its matrix."""
        ...


def _check_named(law: str, quantities: Pairs) -> None:
    if twice := repeated_name(scalar_names(quantities)):
        raise InputError(
            f"the law {law!r} names two quantities {twice}; each needs a name of its own"
        )


@dataclass(frozen=True, kw_only=True, repr=False)
class Law(WithShortRepr, ABC):
    """A law of a system; the base class of all laws.

    Parameters
    ----------
    name : str
        Short name.
    level : tuple of sympy.Expr
        Expressions in the parameters or the state that must vanish for the law to hold; empty if
        it holds everywhere.
    source : str
        Where it is published, such as ``"(7.2)"``.
    as_printed : Law, optional
        The form printed in the source, if it differs.
    misprint : str
        The error in the printed form, in one phrase.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> laws = flowlanes.Integral("energy", v**2 + x**2), flowlanes.Measure("volume", {1: 1})
    >>> all(isinstance(law, flowlanes.system.Law) for law in laws)
    True
    """

    #: Whether the statement depends only on the points of the level, not on its conditions.
    pointwise: ClassVar[bool] = False
    #: Whether it concerns the volume that the conditions define on the level.
    of_volume: ClassVar[bool] = False
    #: Whether it is given by components along the state variables.
    by_components: ClassVar[bool] = False
    #: Property included in its residuals, for the text of a verdict.
    included: ClassVar[str] = ""

    name: str = field(kw_only=False)
    level: tuple[sp.Expr, ...] = ()
    source: str = ""
    as_printed: Law | None = None
    misprint: str = ""

    def __post_init__(self) -> None:
        for item in fields(self):
            object.__setattr__(self, item.name, with_formulas(getattr(self, item.name)))

    @property
    @abstractmethod
    def heading(self) -> str:
        """The kind of the law, in words."""

    @abstractmethod
    def basic(self, system: VectorField) -> Law:
        """An equivalent law of a kind known to the prover.

        Raises
        ------
        InputError
            If the law does not apply to this system.
        """

    @property
    def formulas(self) -> tuple[sp.Basic, ...]:
        """All formulas shown by the law, those of its level last."""
        own = [getattr(self, name) for name in self._own_fields]
        return tuple(map(sp.sympify, (*(f for value in own for f in _shown(value)), *self.level)))

    @property
    def _own_fields(self) -> tuple[str, ...]:
        """The fields that are specific to this kind of law."""
        common = {item.name for item in fields(Law)}
        return tuple(item.name for item in fields(self) if item.name not in common)

    def sides(self) -> tuple[tuple[Side, Side], ...]:
        """The equations that state the law, as left and right sides.

        By default, each formula with the name of its field.
        """
        own = {name: getattr(self, name) for name in self._own_fields}
        return tuple((n, f) for n, f in own.items() if isinstance(f, sp.Basic | sp.MatrixBase))

    def claim(self, system: VectorField) -> Mapping[str, object]:
        """The content of the law in a certificate, by the names of the format."""
        return self.basic(system).claim(system)

    @property
    def powers(self) -> tuple[Power, ...]:
        """Powers that must be real: a base with a non-integer exponent must be positive."""
        return ()

    @property
    def computed(self) -> tuple[sp.Basic | Pairs, ...]:
        """The formulas that are evaluated along motions."""
        return ()

    @property
    def by_formulas(self) -> Law:
        """The part of the law that is stated by formulas; usually all of it."""
        return self

    def weighted(self, powers: Pairs) -> Self:
        """The law for the volume of the conditions divided by a product of powers."""
        return self

    def under(self, change: ChangeOfVariables) -> Self:
        """The law in other variables."""
        fixed = {"name", "source", "misprint", "meaning", "as_printed", "target", "onto"}
        own = {f.name: getattr(self, f.name) for f in fields(self) if f.name not in fixed}
        changed = {name: change.formula(value) for name, value in own.items()}
        return replace(self, as_printed=None, **changed)

    @cached_property
    def scalar(self) -> Self:
        """The law with all formulas in components; the same object if they already are."""
        given = {f.name: getattr(self, f.name) for f in fields(self)}
        parts = {name: in_components(value) for name, value in given.items()}
        changed = {name: value for name, value in parts.items() if value != given[name]}
        return replace(self, **changed) if changed else self

    def __getstate__(self) -> dict[str, object]:
        return {name: value for name, value in vars(self).items() if name != "scalar"}


AnyLaw = TypeVar("AnyLaw", bound=Law)


def of_kind(laws: Iterable[Law], kind: type[AnyLaw]) -> tuple[AnyLaw, ...]:
    """The laws of one kind, in order."""
    return tuple(law for law in laws if isinstance(law, kind))


def _shown(value: object) -> list[sp.Basic]:
    """The formulas in a field of a law, without the names of named formulas."""
    if isinstance(value, Law):
        return list(value.formulas)
    if isinstance(value, sp.Basic | sp.MatrixBase):
        return [value]
    if not isinstance(value, tuple):
        return []
    parts = [part[1] if _names(part) else part for part in value]
    return [formula for part in parts for formula in _shown(part)]


def _names(value: object) -> bool:
    """True if a value is a pair of a name and a formula."""
    return (
        isinstance(value, tuple)
        and len(value) == 2
        and isinstance(value[0], sp.Symbol | sp.MatrixSymbol)
    )


@dataclass(frozen=True, kw_only=True, repr=False)
class VanishingLaw(Law):
    """A law stating that some formulas vanish on the level; the base class of new kinds.

    Parameters
    ----------
    name, level, source, as_printed, misprint
        As for every `Law`.
    """

    @abstractmethod
    def residuals(self, system: VectorField) -> Mapping[str, sp.Basic]:
        """Named formulas; the law holds where all of them vanish.

        A formula is a scalar, a vector or a matrix in the state, the definitions and the
        parameters; it may contain ``Rate``.
        """

    def basic(self, system: VectorField) -> Identity:
        """The identity that all residuals vanish."""
        values = tuple(self.residuals(system).values())
        return Identity(self.name, values, level=self.level, source=self.source)

    def tabulated(self) -> Mapping[str, object]:
        """The class name and all contents of the law, by the keys of a file."""
        own = {name: getattr(self, name) for name in self._own_fields} | {"on": self.level}
        given = {name: value for name, value in own.items() if value not in ("", ())}
        return {"kind": type(self).__name__, **given}


def vanishing_kinds(base: type[VanishingLaw] = VanishingLaw) -> dict[str, type[VanishingLaw]]:
    """The subclasses of `VanishingLaw` by class name."""
    found: dict[str, type[VanishingLaw]] = {}
    for kind in base.__subclasses__():
        found |= {kind.__name__: kind, **vanishing_kinds(kind)}
    return found


@dataclass(frozen=True, kw_only=True, repr=False)
class BasicLaw(Law):
    """A law of a kind that the prover and the certificate checker know."""

    def basic(self, system: VectorField) -> Self:
        """The law itself."""
        return self


@arguments_checked
@dataclass(frozen=True, repr=False)
class Integral(BasicLaw):
    """A first integral: a function F of the state with v(F) = 0.

    A constant is a trivial integral, which is mentioned in its verdict.

    Parameters
    ----------
    name : str
        Short name, used for the variable ``law_<name>`` of a dataset.
    value : sympy.Expr
        F, in terms of the state, the definitions and the parameters of its system.
    meaning : str
        A short description ("energy", "area integral").
    unit : str
        SI unit of its value.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> energy = flowlanes.Integral("energy", v**2 / 2 - sp.cos(x), unit="1/s^2")
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)}, laws=(energy,))
    >>> motion = flowlanes.integrate(pendulum, {"x": 0.0, "v": 1.0}, [0.0, 5.0])
    >>> motion["law_energy"].round(12).tolist()
    [-0.5, -0.5]
    """

    pointwise: ClassVar[bool] = True
    heading = "First integral"

    value: sp.Expr
    meaning: str = ""
    unit: str = ""

    def claim(self, system: VectorField) -> Mapping[str, object]:
        """F."""
        return {"value": self.scalar.value}

    @property
    def computed(self) -> tuple[sp.Basic | Pairs, ...]:
        """F, which is recorded along motions."""
        return (self.value,)


@arguments_checked
@dataclass(frozen=True, repr=False)
class Measure(BasicLaw):
    """An invariant measure: div(ρ v) = 0 with ρ = ∏ base^exponent.

    The volume is that of the state variables or, if there are relations, the form d^n x divided by
    the differentials of the relations and of `level`, where these are independent. The density is
    real and positive: a base with a non-integer exponent must be positive; a base with an odd
    exponent may have either sign, and the measure is then signed.

    Parameters
    ----------
    name : str
    density : mapping or pairs of base to exponent
        Bases in state, definitions and parameters; exponents independent of the state.
    meaning : str

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> y = sp.Symbol("y", real=True)
    >>> flowlanes.Measure("volume", {1 + y**2: sp.Rational(1, 2)}).value
    sqrt(y**2 + 1)
    """

    of_volume: ClassVar[bool] = True
    heading = "Invariant measure"

    density: NamedFormulas
    meaning: str = ""

    @property
    def formulas(self) -> tuple[sp.Basic, ...]:
        """Bases and exponents."""
        return tuple(
            map(sp.sympify, (*(part for pair in self.density for part in pair), *self.level))
        )

    def claim(self, system: VectorField) -> Mapping[str, object]:
        """Bases and exponents."""
        return {"density": self.scalar.density}

    @property
    def powers(self) -> tuple[Power, ...]:
        """The factors of the density."""
        return tuple(("the base {} of the density", base, power) for base, power in self.density)

    @property
    def computed(self) -> tuple[sp.Basic | Pairs, ...]:
        """The density, which is used to draw states."""
        return (self.density,)

    def weighted(self, powers: Pairs) -> Self:
        """The measure with further factors in its density."""
        return replace(self, density=(*self.density, *powers))

    @property
    def value(self) -> sp.Expr:
        """ρ as one formula."""
        return sp.Mul(*(sp.Pow(base, exponent) for base, exponent in self.density))


@arguments_checked
@dataclass(frozen=True, repr=False)
class Symmetry(BasicLaw):
    """A symmetry field u: [u, v] = 0, u tangent to the phase space and the level.

    Parameters
    ----------
    name : str
    field : mapping or pairs of state name to formula
        The components of u; those not given are zero.
    meaning : str

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, y, u, v = sp.symbols("x y u v", real=True)
    >>> rotation = flowlanes.Symmetry("rotation", {x: -y, y: x, u: -v, v: u})
    >>> dict(rotation.field)[u]
    -v
    """

    by_components: ClassVar[bool] = True
    heading = "Symmetry field"

    field: NamedFormulas
    meaning: str = ""

    def claim(self, system: VectorField) -> Mapping[str, object]:
        """The given components of u."""
        return {"field": self.scalar.field}

    @property
    def computed(self) -> tuple[sp.Basic | Pairs, ...]:
        """u, by which the flow is reduced."""
        return (self.field,)

    def under(self, change: ChangeOfVariables) -> Self:
        """The field in other variables."""
        moved = replace(self, field=(), as_printed=None, level=change.formula(self.level))
        return replace(moved, field=change.vector_field(self.scalar.field))


@arguments_checked
@dataclass(frozen=True, repr=False)
class PoissonStructure(BasicLaw):
    """A Poisson structure on the phase space: skew, with the Jacobi identity.

    Functions that vanish on the phase space and on the level have zero brackets with all
    functions, so that the bracket is defined for functions there.

    Parameters
    ----------
    name : str
    matrix : sympy.Matrix
        J_ij = {x_i, x_j} in the flat order of the state.
    casimirs : tuple of sympy.Expr
        Functions whose brackets with all functions vanish.
    rank : int, optional
        Rank at a generic point: attained at almost every point and nowhere exceeded.
    meaning : str

    Raises
    ------
    InputError
        If the matrix is not square, or the rank is impossible for a skew-symmetric matrix of its
        size.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> canonical = flowlanes.PoissonStructure("canonical", sp.Matrix([[0, 1], [-1, 0]]), rank=2)
    >>> canonical.matrix
    Matrix([
    [ 0, 1],
    [-1, 0]])
    """

    by_components: ClassVar[bool] = True
    included: ClassVar[str] = "Jacobi identity"
    heading = "Poisson bracket"

    matrix: Formulas
    casimirs: tuple[sp.Expr, ...] = ()
    rank: int | None = None
    meaning: str = ""

    def __post_init__(self) -> None:
        super().__post_init__()
        if isinstance(self.matrix, sp.Expr) and not self.matrix.is_Matrix:
            raise InputError(f"the law {self.name!r}: its matrix is one formula; rows are needed")
        object.__setattr__(self, "matrix", sp.ImmutableDenseMatrix(self.matrix))
        height, width = self.matrix.shape
        if height != width:
            raise InputError(
                f"the law {self.name!r}: its matrix is {height}×{width}; the matrix of a bracket "
                "is square"
            )
        rank = self.rank
        if rank is None:
            return
        if not isinstance(rank, sp.Integer) or rank % 2 or not 0 <= rank <= height:
            raise InputError(
                f"the law {self.name!r}: its rank is {rank}; a skew {height}×{height} matrix has "
                f"an even rank from 0 to {height - height % 2}"
            )
        object.__setattr__(self, "rank", int(rank))

    def claim(self, system: VectorField) -> Mapping[str, object]:
        """Matrix, Casimir functions and rank."""
        return {"matrix": self.matrix, "casimirs": self.scalar.casimirs, "rank": self.rank}

    def under(self, change: ChangeOfVariables) -> Self:
        """The bracket in other variables."""
        return replace(super().under(change), matrix=change.bracket(self.scalar.matrix))


@arguments_checked
@dataclass(frozen=True, repr=False)
class ConformallyHamiltonian(BasicLaw):
    """A conformally Hamiltonian form: v = N J dH, with J a Poisson structure.

    For N = 1 the vector field is Hamiltonian. The new time τ satisfies dτ = N dt; N must not
    vanish identically. The vector field vanishes at zeros of N; where N is negative, τ runs
    backwards.

    Parameters
    ----------
    name : str
    multiplier : sympy.Expr
        N, the reducing multiplier.
    structure : PoissonStructure
    hamiltonian : sympy.Expr
        H.
    meaning : str

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> u, w = sp.symbols("u w", real=True)
    >>> bracket = flowlanes.PoissonStructure("canonical", sp.Matrix([[0, 1], [-1, 0]]))
    >>> form = flowlanes.ConformallyHamiltonian("form", w / 2, bracket, u**2 / 2 + w**2)
    >>> slopes = sp.Matrix([form.hamiltonian.diff(u), form.hamiltonian.diff(w)])
    >>> list(form.multiplier * form.structure.matrix * slopes)
    [w**2, -u*w/2]
    """

    by_components: ClassVar[bool] = True

    multiplier: sp.Expr
    structure: PoissonStructure
    hamiltonian: sp.Expr
    meaning: str = ""

    @property
    def heading(self) -> str:
        """The title, which depends on whether the form is Hamiltonian in the time of the system."""
        return "Hamiltonian form" if self.multiplier == 1 else "Conformally Hamiltonian form"

    def claim(self, system: VectorField) -> Mapping[str, object]:
        """N, H and the bracket."""
        bracket = {"name": self.structure.name, **self.structure.claim(system)}
        N, H = self.scalar.multiplier, self.scalar.hamiltonian
        return {"multiplier": N, "hamiltonian": H, "structure": bracket}


@arguments_checked
@dataclass(frozen=True, repr=False)
class Reduction(BasicLaw):
    """A closed system of equations satisfied by some quantities along every motion.

    The variables are all symbols in the equations except parameters: the quantities, and state
    variables (definitions are expanded). The equations hold along every motion and are closed:
    together with the conditions between the variables, and with the definitions of quantities that
    are functions of the others, they determine the rates of all variables at almost every point;
    for a constant c of the motion the equation is ``Rate(c)``. Equations homogeneous in the rates
    need to determine them only up to a common factor; they then give the paths, but not the time.
    Equations that hold but are not closed form an `Identity`.

    Parameters
    ----------
    name : str
    quantities : mapping or pairs of Symbol to formula
        New quantities, each in terms of state, definitions, parameters and earlier ones.
    equations : tuple of sympy.Expr
        Expressions that vanish, in the quantities, the state, the parameters and their ``Rate``.
    meaning : str

    Raises
    ------
    InputError
        If there is no equation, or a quantity is named twice.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v, s, w = sp.symbols("x v s w", real=True)
    >>> equations = (flowlanes.Rate(s) - 2 * w, flowlanes.Rate(w) - 1 + 2 * s)
    >>> square = flowlanes.Reduction(
    ...     "square", {s: x**2, w: x * v}, equations, level=(x**2 + v**2 - 1,)
    ... )
    >>> len(square.equations)
    2
    """

    quantities: NamedFormulas
    equations: tuple[sp.Expr, ...]
    meaning: str = ""

    @property
    def heading(self) -> str:
        """The title of a reduction."""
        return "Reduction"

    def claim(self, system: VectorField) -> Mapping[str, object]:
        """Quantities and equations."""
        return {"quantities": self.scalar.quantities, "equations": self.scalar.equations}

    def __post_init__(self) -> None:
        super().__post_init__()
        _check_named(self.name, self.quantities)
        if not self.equations:
            raise InputError(f"the law {self.name!r} has no equation")


@arguments_checked
@dataclass(frozen=True, repr=False)
class Separation(Reduction):
    """Quantities that satisfy separate equations, up to a common change of time.

    For each of the separated quantities u_i, at least two, one equation gives its rate or the
    square of its rate, u̇_i = r_i or u̇_i² = r_i², and contains no other rate; every other
    equation is ``Rate(c)`` for a constant c. The ratios are r_i/r_k = f_i(u_i)/f_k(u_k), where f_i
    and f_k contain only parameters and constants besides u_i and u_k. Hence r_i = N f_i(u_i) with
    a common factor N, and du_i/dτ = f_i(u_i) in the time dτ = N dt. On a level of the constants
    the u_i are independent at almost every point. They are usually roots of a quadratic equation.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, y, u, v = sp.symbols("x y u v", real=True)
    >>> h, k = sp.symbols("h k", real=True)
    >>> energies = {h: u**2 + x**2, k: v**2 + y**2}
    >>> of_x, of_y = flowlanes.Rate(x) ** 2 - h + x**2, flowlanes.Rate(y) ** 2 - k + y**2
    >>> law = flowlanes.Separation(
    ...     "axes", energies, (of_x, of_y, flowlanes.Rate(h), flowlanes.Rate(k))
    ... )
    >>> dict(law.quantities)[h]
    u**2 + x**2
    """

    @property
    def heading(self) -> str:
        """The title of a separation."""
        return "Separation of variables"

    @property
    def by_formulas(self) -> Reduction:
        """The equations; separability itself is not stated by formulas."""
        return Reduction(self.name, self.quantities, self.equations, level=self.level)


@arguments_checked
@dataclass(frozen=True, repr=False)
class Identity(BasicLaw):
    """Formulas that vanish everywhere on the phase space.

    Parameters
    ----------
    name : str
    value : sympy.Expr, vector, matrix, or tuple of these
        The formulas that vanish; they may contain ``Rate``.
    meaning : str
    quantities : mapping or pairs of Symbol to formula
        Names for formulas in `value`, each in terms of state, definitions, parameters and earlier
        ones.

    Raises
    ------
    InputError
        If a quantity is named twice.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> circle = flowlanes.Identity("circle", x * flowlanes.Rate(x) + v * flowlanes.Rate(v))
    >>> circle.value
    v*Rate(v) + x*Rate(x)
    """

    pointwise: ClassVar[bool] = True
    heading = "Identity"

    value: Formulas
    meaning: str = ""
    quantities: NamedFormulas = ()

    def claim(self, system: VectorField) -> Mapping[str, object]:
        """Quantities, and all components of the formulas that vanish."""
        return {"quantities": self.scalar.quantities, "value": tuple(scalars(self.value))}

    def __post_init__(self) -> None:
        super().__post_init__()
        _check_named(self.name, self.quantities)

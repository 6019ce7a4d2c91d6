"""Laws as plain values: what is claimed of a system, apart from any proof.

Every law is a tensor invariant of the field v of its system, or an identity on its phase space.
A law speaks of the points where the relations of the system vanish, together with `on`: further
expressions in state and parameters that must vanish for the law to hold, such as ``k + 1`` or
``(M, γ)``.  :mod:`chaplygin.proof` proves or refutes them.

The docstring of each kind defines what it claims, and so what a proof of it has shown; a law
claims nothing at points where one of its formulas has no real value.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import sympy as sp

from ..arguments import Declared, Formula, Formulas, arguments_checked
from ..errors import InputError

__all__ = [
    "ConformallyHamiltonian",
    "Identity",
    "Integral",
    "Law",
    "Measure",
    "PoissonStructure",
    "Rate",
    "Reduction",
    "Separation",
    "Symmetry",
]

Pairs: TypeAlias = tuple[tuple[Any, Any], ...]


class Rate(sp.Function):
    """The time derivative of a scalar formula along the field of its system.

    ``Rate(gamma_1)`` stands for γ̇₁, ``Rate(Rate(theta))`` for the second derivative.
    """

    nargs = 1

    @arguments_checked
    def __new__(cls, *formulas: Formula, **options: Any) -> Any:
        """Refuse a text, which SymPy would run."""
        return super().__new__(cls, *formulas, **options)


def pairs(mapping: Mapping[Any, Any] | Pairs) -> Pairs:
    return tuple(mapping.items()) if isinstance(mapping, Mapping) else tuple(mapping)


def scalar_names(pairs: Pairs) -> list[sp.Symbol]:
    """The names of pairs (named quantity, formula), one for each scalar component."""
    names = ((name,) if isinstance(name, sp.Symbol) else name.symbols for name, _ in pairs)
    return [symbol for symbols in names for symbol in symbols]


def repeated(names: Sequence[sp.Symbol]) -> sp.Symbol | None:
    """A name that occurs more than once, or None."""
    return next((name for i, name in enumerate(names) if name in names[:i]), None)


def _check_named(law: str, quantities: Pairs) -> None:
    if twice := repeated(scalar_names(quantities)):
        raise InputError(
            f"the law {law!r} names two quantities {twice}; each needs a name of its own"
        )


@dataclass(frozen=True, kw_only=True)
class Law:
    """What all laws share.

    Parameters
    ----------
    name : str
        Short name.
    on : tuple of sympy.Expr
        Expressions in the parameters or the state that must vanish for the law to hold; empty
        when it holds everywhere.
    source : str
        Where it is stated, such as ``"(7.2)"``.
    as_printed : Law, optional
        The form in which the source prints it, where that differs.
    misprint : str
        What is wrong with the printed form, in one phrase.
    """

    name: str = field(kw_only=False)
    on: tuple[sp.Expr, ...] = ()
    source: str = ""
    as_printed: Law | None = None
    misprint: str = ""


@arguments_checked
@dataclass(frozen=True)
class Integral(Law):
    """A first integral: a function F of the state with v(F) = 0.

    A constant is one too, and a trivial one: the verdict on it says so.

    Parameters
    ----------
    name : str
        Short name, used for the variable ``law_<name>`` of a dataset.
    value : sympy.Expr
        F, written in the state, the definitions and the parameters of its system.
    meaning : str
        A few words for a reader ("energy", "area integral").
    unit : str
        SI unit of its value.
    """

    value: sp.Expr
    meaning: str = ""
    unit: str = ""


@arguments_checked
@dataclass(frozen=True)
class Measure(Law):
    """An invariant measure: div(ρ v) = 0 with ρ = ∏ base^exponent.

    The volume is that of the state variables.  Where relations hold, it is the volume that they
    cut out: the form d^n x divided by the differentials of the relations (and of `on`), wherever
    these are independent.

    A measure has a real positive density.  A base under a root, that is with an exponent that is
    no integer, must be positive; a base with an odd exponent may have either sign, and where it
    does the measure is a signed one.

    Parameters
    ----------
    name : str
    density : mapping or pairs of base to exponent
        Bases in state, definitions and parameters; exponents free of the state.
    meaning : str
    """

    density: Declared
    meaning: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "density", pairs(self.density))

    @property
    def value(self) -> sp.Expr:
        """ρ as one formula."""
        return sp.Mul(*(sp.Pow(base, exponent) for base, exponent in self.density))


@arguments_checked
@dataclass(frozen=True)
class Symmetry(Law):
    """A symmetry field: [u, v] = 0, and u is tangent to the phase space and to the level.

    Parameters
    ----------
    name : str
    field : mapping or pairs of state name to formula
        u; what is not named has component zero.
    meaning : str
    """

    field: Declared
    meaning: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "field", pairs(self.field))


@arguments_checked
@dataclass(frozen=True)
class PoissonStructure(Law):
    """A Poisson structure on the phase space: skew, with the Jacobi identity.

    What vanishes on the phase space and on the level has a vanishing bracket with everything, so
    that the bracket is one of functions there.

    Parameters
    ----------
    name : str
    matrix : sympy.Matrix
        J_ij = {x_i, x_j} in the flat order of the state.
    casimirs : tuple of sympy.Expr
        Functions whose bracket with everything vanishes.
    rank : int, optional
        Rank at a generic point: nowhere greater, and attained at almost every point.
    meaning : str

    Raises
    ------
    InputError
        If the matrix is not square, or has no skew matrix of its size the rank.
    """

    matrix: Formulas
    casimirs: tuple[sp.Expr, ...] = ()
    rank: int | None = None
    meaning: str = ""

    def __post_init__(self) -> None:
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
        whole = isinstance(rank, int | sp.Integer) and not isinstance(rank, bool)
        if not whole or rank % 2 or not 0 <= rank <= height:
            raise InputError(
                f"the law {self.name!r}: its rank is {rank}; a skew {height}×{height} matrix has "
                f"an even rank from 0 to {height - height % 2}"
            )


@arguments_checked
@dataclass(frozen=True)
class ConformallyHamiltonian(Law):
    """A conformally Hamiltonian form: v = N J dH, with J a Poisson structure.

    N = 1 states that the field is Hamiltonian.  The new time τ has dτ = N dt; N must not vanish
    identically.  Where N vanishes, v does; where N is negative, τ runs backwards.

    Parameters
    ----------
    name : str
    multiplier : sympy.Expr
        N, the reducing multiplier.
    structure : PoissonStructure
    hamiltonian : sympy.Expr
        H.
    meaning : str
    """

    multiplier: sp.Expr
    structure: PoissonStructure
    hamiltonian: sp.Expr
    meaning: str = ""


@arguments_checked
@dataclass(frozen=True)
class Reduction(Law):
    """Closed equations that some quantities satisfy by themselves along every motion.

    The variables of a reduction are the symbols in its equations that are no parameters: its
    quantities, and variables of the state (definitions stand for what they are in the state).  The
    equations hold along every motion.  They are closed: together with the conditions between these
    variables, and with the formulas of those quantities that are functions of the others, they
    determine the rates of all variables at almost every point; of a variable that is a constant of
    the motion the equation ``Rate(c)`` says so.  Equations that are homogeneous in the rates
    need determine them up to a common factor only: then they give the paths, whatever the time.

    Equations that hold along every motion but are not closed make an `Identity`.

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
    """

    quantities: Declared
    equations: tuple[sp.Expr, ...]
    meaning: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "quantities", pairs(self.quantities))
        object.__setattr__(self, "equations", tuple(self.equations))
        _check_named(self.name, self.quantities)
        if not self.equations:
            raise InputError(f"the law {self.name!r} has no equation")


@arguments_checked
@dataclass(frozen=True)
class Separation(Reduction):
    """Quantities each of which obeys an equation of its own, up to a common time.

    For every quantity u_i that separates, two at least, one equation gives its rate or the square
    of it:  u̇_i = r_i or u̇_i² = r_i², and mentions no other rate; every other equation is
    ``Rate(c)`` and says that c is a constant.  In r_i/r_k the formulas are such that
    r_i/r_k = f_i(u_i)/f_k(u_k), where f_i and f_k may contain parameters and constants, but
    nothing else that moves.  So there is a common factor N, depending on whatever it may, with
    r_i = N f_i(u_i), and du_i/dτ = f_i(u_i) in the time dτ = N dt.  On a level of the constants
    the u_i are independent at almost every point.

    The variables are usually roots of a quadratic, written with square roots.
    """


@arguments_checked
@dataclass(frozen=True)
class Identity(Law):
    """Formulas that vanish everywhere on the phase space.

    Parameters
    ----------
    name : str
    value : sympy.Expr, vector, matrix, or tuple of these
        What vanishes; it may use ``Rate``.
    meaning : str
    quantities : mapping or pairs of Symbol to formula
        Names for formulas in `value`, each in terms of state, definitions, parameters and earlier
        ones.

    Raises
    ------
    InputError
        If a quantity is named twice.
    """

    value: Formulas
    meaning: str = ""
    quantities: Declared = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "quantities", pairs(self.quantities))
        _check_named(self.name, self.quantities)

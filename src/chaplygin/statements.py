"""Laws as plain values: what is claimed of a system, apart from any proof.

Every law is a tensor invariant of the field v of its system, or an identity on its phase space.
A law speaks of the points where the relations of the system vanish, together with `on`: further
expressions in state and parameters that must vanish for the law to hold, such as ``k + 1`` or
``(M, γ)``.  :mod:`chaplygin.laws` proves or refutes them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

import sympy as sp

if TYPE_CHECKING:
    from .system import System

__all__ = [
    "ConformallyHamiltonian",
    "Identity",
    "Integral",
    "Isomorphism",
    "Law",
    "Measure",
    "PoissonStructure",
    "Rate",
    "Reduction",
    "Separation",
    "Symmetry",
]

Pairs: TypeAlias = tuple[tuple[Any, Any], ...]
#: Written as a mapping or as pairs, kept as pairs.
Declared: TypeAlias = Any


class Rate(sp.Function):
    """The time derivative of a scalar formula along the field of its system.

    ``Rate(gamma_1)`` stands for γ̇₁, ``Rate(Rate(theta))`` for the second derivative.
    """

    nargs = 1


def _pairs(mapping: Mapping[Any, Any] | Pairs) -> Pairs:
    return tuple(mapping.items()) if isinstance(mapping, Mapping) else tuple(mapping)


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


@dataclass(frozen=True)
class Integral(Law):
    """A first integral: a function F of the state with v(F) = 0.

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


@dataclass(frozen=True)
class Measure(Law):
    """An invariant measure: div(ρ v) = 0 with ρ = ∏ base^exponent.

    The volume is that of the state variables.  Where relations hold, it is the volume that they
    cut out: the form d^n x divided by the differentials of the relations (and of `on`).

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
        object.__setattr__(self, "density", _pairs(self.density))

    @property
    def value(self) -> sp.Expr:
        """ρ as one formula."""
        return sp.Mul(*(sp.Pow(base, exponent) for base, exponent in self.density))


@dataclass(frozen=True)
class Symmetry(Law):
    """A symmetry field: [u, v] = 0.

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
        object.__setattr__(self, "field", _pairs(self.field))


@dataclass(frozen=True)
class PoissonStructure(Law):
    """A Poisson structure on the phase space: skew, with the Jacobi identity.

    Parameters
    ----------
    name : str
    matrix : sympy.Matrix
        J_ij = {x_i, x_j} in the flat order of the state.
    casimirs : tuple of sympy.Expr
        Functions whose bracket with everything vanishes.
    rank : int, optional
        Rank at a generic point.
    meaning : str
    """

    matrix: Any
    casimirs: tuple[sp.Expr, ...] = ()
    rank: int | None = None
    meaning: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "matrix", sp.ImmutableDenseMatrix(self.matrix))


@dataclass(frozen=True)
class ConformallyHamiltonian(Law):
    """A conformally Hamiltonian form: v = N J dH, with J a Poisson structure.

    N = 1 states that the field is Hamiltonian.  The new time τ has dτ = N dt.

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


@dataclass(frozen=True)
class Isomorphism(Law):
    """A change of variables and time that carries the field onto another system's.

    Parameters
    ----------
    name : str
    target : System
    map : mapping or pairs of target state name to formula
        The new variables, as functions on the phase space of this system.
    time : sympy.Expr
        dτ/dt, for the time τ of the target.
    constants : mapping or pairs of target parameter to formula
        Values of the target's parameters: functions of the parameters, or integrals of this
        system (their constancy is proved along with the rest).  Parameters that are not named
        keep their symbol.
    meaning : str
    """

    target: System
    map: Declared
    time: sp.Expr = sp.S.One
    constants: Declared = ()
    meaning: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "map", _pairs(self.map))
        object.__setattr__(self, "constants", _pairs(self.constants))


@dataclass(frozen=True)
class Reduction(Law):
    """Equations that some quantities satisfy by themselves along every motion.

    Parameters
    ----------
    name : str
    quantities : mapping or pairs of Symbol to formula
        New quantities, each in terms of state, definitions, parameters and earlier ones.
    equations : tuple of sympy.Expr
        Expressions that vanish; they may use the quantities, ``Rate(quantity)`` and all symbols
        of the system.
    meaning : str
    """

    quantities: Declared
    equations: tuple[sp.Expr, ...]
    meaning: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "quantities", _pairs(self.quantities))


@dataclass(frozen=True)
class Separation(Reduction):
    """A reduction in which each quantity obeys an equation of its own, up to a common time.

    `equations` are as for `Reduction`; the variables are usually roots of a quadratic, written
    with square roots.
    """


@dataclass(frozen=True)
class Identity(Law):
    """Formulas that vanish everywhere on the phase space.

    Parameters
    ----------
    name : str
    value : sympy.Expr, vector, matrix, or tuple of these
        What vanishes; it may use ``Rate``.
    meaning : str
    """

    value: Any
    meaning: str = ""

"""Laws: statements about a system, for a prover to prove or refute.

Every law is a tensor invariant of the field v of its system, or an identity on its phase space.  It
concerns the points where the relations of the system and the expressions `on` vanish, such as
``k + 1`` or ``(M, γ)``, and where all its formulas have real values.  The docstring of each class
defines its statement.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from typing import Any

import sympy as sp

from ..arguments import Formula, Formulas, NamedFormulas, arguments_checked
from ..errors import InputError
from .named_formulas import Pairs, repeated_name, scalar_names, with_formulas
from .overview import WithShortRepr


class Rate(sp.Function):
    """The time derivative of a scalar formula along the field of its system.

    ``Rate(gamma_1)`` stands for γ̇₁, ``Rate(Rate(theta))`` for the second derivative.

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
        """Refuse a text, which SymPy would run."""
        return super().__new__(cls, *formulas, **options)


def _check_named(law: str, quantities: Pairs) -> None:
    if twice := repeated_name(scalar_names(quantities)):
        raise InputError(
            f"the law {law!r} names two quantities {twice}; each needs a name of its own"
        )


@dataclass(frozen=True, kw_only=True, repr=False)
class Law(WithShortRepr):
    """A law of a system; the base class of all laws.

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

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> laws = flowlanes.Integral("energy", v**2 + x**2), flowlanes.Measure("volume", {1: 1})
    >>> all(isinstance(law, flowlanes.system.Law) for law in laws)
    True
    """

    name: str = field(kw_only=False)
    on: tuple[sp.Expr, ...] = ()
    source: str = ""
    as_printed: Law | None = None
    misprint: str = ""

    def __post_init__(self) -> None:
        for item in fields(self):
            object.__setattr__(self, item.name, with_formulas(getattr(self, item.name)))


@arguments_checked
@dataclass(frozen=True, repr=False)
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

    value: sp.Expr
    meaning: str = ""
    unit: str = ""


@arguments_checked
@dataclass(frozen=True, repr=False)
class Measure(Law):
    """An invariant measure: div(ρ v) = 0 with ρ = ∏ base^exponent.

    The volume is that of the state variables or, on relations, the form d^n x divided by the
    differentials of the relations and of `on`, where these are independent.  The density is real
    and positive: a base with a non-integer exponent must be positive; a base with an odd exponent
    may have either sign, and the measure is then a signed one.

    Parameters
    ----------
    name : str
    density : mapping or pairs of base to exponent
        Bases in state, definitions and parameters; exponents free of the state.
    meaning : str

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> y = sp.Symbol("y", real=True)
    >>> flowlanes.Measure("volume", {1 + y**2: sp.Rational(1, 2)}).value
    sqrt(y**2 + 1)
    """

    density: NamedFormulas
    meaning: str = ""

    @property
    def value(self) -> sp.Expr:
        """ρ as one formula."""
        return sp.Mul(*(sp.Pow(base, exponent) for base, exponent in self.density))


@arguments_checked
@dataclass(frozen=True, repr=False)
class Symmetry(Law):
    """A symmetry field u: [u, v] = 0, u tangent to the phase space and the level.

    Parameters
    ----------
    name : str
    field : mapping or pairs of state name to formula
        u; what is not named has component zero.
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

    field: NamedFormulas
    meaning: str = ""


@arguments_checked
@dataclass(frozen=True, repr=False)
class PoissonStructure(Law):
    """A Poisson structure on the phase space: skew, with the Jacobi identity.

    Functions that vanish on the phase space and on the level have vanishing brackets with all
    others, so that the bracket is defined for functions there.

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


@arguments_checked
@dataclass(frozen=True, repr=False)
class ConformallyHamiltonian(Law):
    """A conformally Hamiltonian form: v = N J dH, with J a Poisson structure.

    N = 1 states that the field is Hamiltonian.  The new time τ has dτ = N dt; N must not vanish
    identically.  At zeros of N the field vanishes; for negative N the time τ runs backwards.

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

    multiplier: sp.Expr
    structure: PoissonStructure
    hamiltonian: sp.Expr
    meaning: str = ""


@arguments_checked
@dataclass(frozen=True, repr=False)
class Reduction(Law):
    """Closed equations that some quantities satisfy by themselves along every motion.

    The variables are the symbols in the equations that are no parameters: the quantities, and state
    variables (definitions are expanded).  The equations hold along every motion and are closed:
    together with the conditions between the variables, and with the formulas of those quantities
    that are functions of the others, they determine the rates of all variables at almost every
    point; for a constant c of the motion the equation is ``Rate(c)``.  Equations homogeneous in the
    rates need to determine them up to a common factor only; they then give the paths, but not the
    time.  Equations that hold along every motion but are not closed make an `Identity`.

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
    ...     "square", {s: x**2, w: x * v}, equations, on=(x**2 + v**2 - 1,)
    ... )
    >>> len(square.equations)
    2
    """

    quantities: NamedFormulas
    equations: tuple[sp.Expr, ...]
    meaning: str = ""

    def __post_init__(self) -> None:
        super().__post_init__()
        _check_named(self.name, self.quantities)
        if not self.equations:
            raise InputError(f"the law {self.name!r} has no equation")


@arguments_checked
@dataclass(frozen=True, repr=False)
class Separation(Reduction):
    """Quantities each of which obeys an equation of its own, up to a common time.

    For each of the separated quantities u_i, at least two, one equation gives its rate or the
    square of it, u̇_i = r_i or u̇_i² = r_i², and contains no other rate; every other equation is
    ``Rate(c)`` for a constant c.  The ratios are r_i/r_k = f_i(u_i)/f_k(u_k), where f_i and f_k
    contain only parameters and constants besides u_i and u_k.  There is then a common factor N with
    r_i = N f_i(u_i), and du_i/dτ = f_i(u_i) in the time dτ = N dt.  On a level of the constants the
    u_i are independent at almost every point.  They are usually roots of a quadratic.

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


@arguments_checked
@dataclass(frozen=True, repr=False)
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

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> circle = flowlanes.Identity("circle", x * flowlanes.Rate(x) + v * flowlanes.Rate(v))
    >>> circle.value
    v*Rate(v) + x*Rate(x)
    """

    value: Formulas
    meaning: str = ""
    quantities: NamedFormulas = ()

    def __post_init__(self) -> None:
        super().__post_init__()
        _check_named(self.name, self.quantities)

"""Systems that separate on a hyperelliptic curve of genus two, as formulas.

On a level of its integrals such a system has a unit vector ν, fixed neither in the body nor in
space, with body components

    ν_i² = κ · weights_i (e_i − z₁)(e_i − z₂),            i = 1, 2, 3,

with one common positive factor κ (found from ν² = 1).  The poles e_i are branch points of the curve
y² = leading ∏ (z − root), and in the new time τ, dt = clock · dτ,

    dz₁/y₁ + dz₂/y₂ = a dτ,        z₁ dz₁/y₁ + z₂ dz₂/y₂ = b dτ.

So ν moves linearly on the Jacobian of the curve, and everything else is a formula in ν and ν′ =
dν/dτ.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from flowlanes.system.laws import Law
from flowlanes.system.overview import Overview, WithOverview
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector, vectors

#: The unit vector and its derivative in the time τ, body axes.
nu, nuprime = vectors("nu nuprime")


@dataclass(frozen=True, kw_only=True, repr=False)
class SeparatedSystem(WithOverview):
    """A system on a level, separated; all formulas, no numbers.

    Vectors are formulas of :mod:`flowlanes.system.vectors`; a formula that may use the constants
    refers to them by their symbols.

    Attributes
    ----------
    name, title : str
        Identifier, and a description in words, such as "Chaplygin ball at zero area constant".
    system : System
        The system in its own symbols, as the catalogue has it.
    level : tuple of sympy.Expr
        Expressions in state and parameters that must vanish at the start (beside the relations).
    constants : pairs of Symbol to formula
        Constants of the motion, each in the state, the definitions and parameters of `system`
        and the constants before it.
    direction, turning : vectors
        ν and ν′ as formulas in the state, the definitions, the parameters and the constants.
    poles, weights : three formulas each
        In parameters and constants; poles in increasing order for the parameters' usual order.
    leading : formula
    roots : formulas
        Of the curve, five or six, the poles first; in parameters and constants.
    speeds : two formulas
        a and b, in parameters and constants.
    along : two formulas, optional
        The speeds of the flow along which ν′ is the derivative of ν, where that is another flow on
        the same torus.
    time_rescaling : formula
        dt/dτ > 0 in ν, ν′, parameters and constants.
    state : pairs of state name to formula
        The state of `system` in ν, ν′, parameters and constants.
    fixed : tuple of vectors
        Vectors (body components, in the state, definitions, parameters, constants) whose
        direction in space is constant: two that are never parallel on a generic motion, or one.
    laws : tuple of Law
        The statements above as laws of `system`, provable by :mod:`lawproof.proof`.
    source : str

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> from nonholonomic.closed_form.separations.veselova import veselova
    >>> veselova().title, veselova().roots
    ('Veselova system without a field', (I_1, I_2, I_3, 0, F/(2*h)))
    """

    name: str
    title: str
    system: System
    level: tuple[sp.Expr, ...] = ()
    constants: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    direction: sp.MatrixExpr
    turning: sp.MatrixExpr
    poles: tuple[sp.Expr, sp.Expr, sp.Expr]
    weights: tuple[sp.Expr, sp.Expr, sp.Expr]
    leading: sp.Expr
    roots: tuple[sp.Expr, ...]
    speeds: tuple[sp.Expr, sp.Expr]
    time_rescaling: sp.Expr
    state: tuple[tuple[sp.Symbol | Vector, sp.Expr], ...]
    fixed: tuple[sp.MatrixExpr, ...] = ()
    along: tuple[sp.Expr, sp.Expr] | None = None
    laws: tuple[Law, ...] = ()
    source: str = ""

    def overview(self) -> Overview:
        """System, constants, and the curve."""
        return Overview(
            f"{self.title}: separated on a curve of genus two",
            (
                ("constants", ", ".join(str(name) for name, _ in self.constants)),
                ("roots", ", ".join(map(str, self.roots))),
                ("leading coefficient", str(self.leading)),
                ("poles", ", ".join(map(str, self.poles))),
                ("dt/dτ", str(self.time_rescaling)),
                ("level", ", ".join(map(str, self.level))),
            ),
        )


def gaps(poles: Sequence[sp.Expr]) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Πᵢ = ∏_{j≠i}(eᵢ − eⱼ) of three numbers eᵢ."""
    e, f, g = poles
    return (e - f) * (e - g), (f - e) * (f - g), (g - e) * (g - f)

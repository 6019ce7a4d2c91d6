"""The meaning of the letters in the equations of a body."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp
from sympy.matrices.expressions import Inverse, MatPow

from flowlanes.parsing import Formula, NamedQuantity
from flowlanes.printing.formula import text
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Symmetric, Vector

#: Letters of every body, in body axes.
_BODY = {
    "omega": "angular velocity",
    "M": "angular momentum",
    "gamma": "unit vector fixed in space",
    "zeta": "upward vertical",
    "I": "inertia tensor",
    "X": "torque other than that of the constraints",
    "U": "potential",
    "k": "momentum of the rotors",
}

#: Letters of a body that touches a surface.
_TOUCHING = {
    **_BODY,
    "M": "momentum about the contact point",
    "gamma": "outward normal of the surface at the contact",
    "I": "inertia tensor about the centre of mass",
    "J": "inertia tensor about the contact point, plus m r ⊗ r with the arm r of the contact",
    "r": "from the centre of mass to the contact point",
    "c": "from the centre of mass to the geometric centre",
    "N": "contact force",
    "B": "tensor of the squared semi-axes",
    "s": "height of the geometric centre above the tangent plane",
    "p": "height of the geometric centre above the tangent plane",
    "pprime": "its derivative with respect to γ₃",
    "pprime2": "its second derivative",
    "gammatilde": "angular acceleration by a unit torque about the normal",
    "A_a": "(a + ρ₁)(a + ρ₂) with the principal radii of curvature ρ of the body",
    "tau": "ρ₁ + ρ₂",
    "x": "from the geometric centre to the contact point",
    "nu": "gradient of f at the contact",
    "F": "second derivatives of f there",
    "ell": "length of ν",
}

#: A scalar k is not the momentum of rotors.
_RATIO = "ratio of the radii"


def glossary(system: System, touching: bool, besides: Mapping[str, str] | None = None) -> str:
    """The meaning of the letters, in the order in which the equations use them.

    Parameters
    ----------
    system : System
    touching : bool
        Whether the body touches a surface; otherwise it turns about a fixed point.
    besides : mapping of str to str, optional
        Meanings particular to this system.
    """
    known = (_TOUCHING if touching else _BODY) | dict(besides or {})
    observed = {item.value: item.meaning for item in system.observables if _is_name(item.value)}
    sentence: dict[str, str] = {}
    for letter in _letters(system):
        if words := _meaning(letter, system, known, observed):
            # a name that is a word would be read as part of the text
            shown = text(letter)
            is_word = shown.isascii() and len(shown) > 2
            sentence[str(letter)] = f"{shown.replace('_', ' ')}{':' * is_word} {words}"
    return f"In body axes: {'; '.join(sentence.values())}; E is the unit tensor."


def _letters(system: System) -> tuple[NamedQuantity, ...]:
    """The names in the equations of motion, and in the definitions that these use."""
    written = dict(system.definitions)
    # A component represents its vector.
    whole = {s: v for v in (*system.state, *written) if isinstance(v, Vector) for s in v.symbols}
    letters: dict[NamedQuantity, None] = {}
    waiting = [part for pair in reversed(system.field) for part in reversed(pair)]
    while waiting:
        formula = waiting.pop()
        for name in sorted(formula.atoms(Vector, Diagonal, Symmetric, sp.Symbol), key=str):
            letter = whole.get(name, name)
            if letter not in letters:
                letters[letter] = None
                waiting += [written[letter]] if letter in written else []
    return tuple(letters)


def _is_name(value: object) -> bool:
    return isinstance(value, (sp.Symbol, Vector))


def _meaning(
    letter: NamedQuantity,
    system: System,
    meanings: Mapping[str, str],
    observables: Mapping[Formula, str],
) -> str:
    """The meaning of one letter; empty for parameters and rates."""
    label = str(letter)
    if letter in {parameter.symbol for parameter in system.parameters}:
        return ""
    written = dict(system.definitions).get(letter)
    if isinstance(written, (Inverse, MatPow)):
        return f"inverse of {text(written.args[0])}"
    if isinstance(letter, sp.Symbol) and label == "k":
        return _RATIO
    return meanings.get(label) or observables.get(letter, "")

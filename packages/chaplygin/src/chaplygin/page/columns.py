"""Quantities that a page records along a motion, and the scalars that it can plot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.recorded_quantities import recorded_quantities
from flowlanes.flow.variable_metadata import labels_of, variable_metadata
from flowlanes.formulas.array_evaluation import formula
from flowlanes.printing.formula import latex
from flowlanes.printing.mathml import mathml
from flowlanes.printing.symbol_names import GREEK
from flowlanes.system.named_formulas import flat, scalars
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector, real_symbol

from ..experiment.section_coordinates import is_angle
from ..experiment.study import Study

#: Horizontal position of a centre of mass, which is recorded as part of it.
_PLACE = "place"

#: Parts of a drawing in the plane, with their names in columns.
PARTS = {
    "links": "rod",
    "wheels": "wheel",
    "axles": "axle",
    "blades": "blade",
    "points": "point",
}


@dataclass(frozen=True)
class Column:
    """A quantity recorded along a motion, under its name in a dataset.

    Attributes
    ----------
    name : str
    formulas : tuple of sympy.Expr
        Components, in terms of the state lifted to space.
    axes : str
        ``"body"``, ``"space"`` or ``"quaternion"``, the dimension of another vector, or empty.
    unit, meaning, mathml : str
    """

    name: str
    formulas: tuple[sp.Expr, ...]
    axes: str
    unit: str
    meaning: str
    mathml: str


@dataclass(frozen=True)
class Scalar:
    """A scalar function of the state of the reduced system.

    Attributes
    ----------
    name : str
    formula : sympy.Expr
    text : str
        The formula in the syntax of the command line.
    unit, meaning, mathml : str
    angle : bool
        Whether its values are angles, modulo whole turns.
    """

    name: str
    formula: sp.Expr
    text: str
    unit: str
    meaning: str
    mathml: str
    angle: bool


def symbol_mathml(name: str, size: int = 1) -> str:
    """A letter in MathML; empty for a word."""
    letter = name.partition("_")[0].rstrip("0123456789").removesuffix("dot")
    if len(letter) > 1 and letter not in GREEK:
        return ""
    return mathml(latex(Vector(name, size) if size > 1 else real_symbol(name)))


def columns_of(study: Study) -> tuple[Column, ...]:
    """The columns of a study, named as in the dataset of a motion.

    For a mechanism in the plane, the positions of its drawing follow.
    """
    system = study.system_on_level
    whole = system.lifted() if system.reconstruction else system
    recorded = recorded_quantities(whole)
    taken = {_PLACE, *(quantity.name for quantity in recorded)}
    columns = [_of_state(study, whole, v) for v in whole.state if str(v) not in taken]
    for item in recorded:
        size = len(item.formulas)
        letter = "" if item.name.startswith("law_") else symbol_mathml(item.name, size)
        columns.append(
            Column(item.name, item.formulas, item.frame, item.unit, item.meaning, letter)
        )
    for law in system.scalar.integrals:
        if law.name == "energy":
            value = (law.value,)
            columns.append(Column("energy", value, "", law.unit or "1", law.meaning, ""))
    columns += [*_of_contact_force(columns), *_of_plan(study)]
    return tuple(columns)


def _of_state(study: Study, whole: System, variable: sp.Basic) -> Column:
    name = str(variable)
    symbols = flat([variable])
    meaning, unit, _, frame = variable_metadata(
        whole, name, len(symbols), study.variables.get(name)
    )
    axes = frame if len(symbols) > 1 else ""
    return Column(name, symbols, axes, unit or "1", meaning, symbol_mathml(name, len(symbols)))


def _of_contact_force(columns: Sequence[Column]) -> Iterator[Column]:
    """The total force at the contact, from its two recorded parts."""
    known = {column.name: column for column in columns}
    if not known.keys() >= {"normal_force", "friction_force", "gamma"}:
        return
    normal, friction = known["normal_force"], known["friction_force"]
    if friction.axes != "body":
        return
    formulas = tuple(
        normal.formulas[0] * g + f
        for g, f in zip(known["gamma"].formulas, friction.formulas, strict=True)
    )
    yield Column("contact_force", formulas, "body", "N", "contact force", "")


def _of_plan(study: Study) -> Iterator[Column]:
    plan = study.subject.plan
    if plan is None:
        return
    yield Column("plan_path", tuple(map(sp.sympify, plan.path)), "plane", "m", "path", "")
    for key, kind in PARTS.items():
        for number, part in enumerate(getattr(plan, key), 1):
            formulas = tuple(scalars(tuple(part)))
            yield Column(f"plan_{kind}_{number}", formulas, "plane", "m", f"{kind} {number}", "")


def scalars_of(study: Study, system: System) -> tuple[Scalar, ...]:
    """The scalars of a reduced system: its state, γ's longitude, observables, integrals."""
    scalars = [_of_symbol(study, system, symbol) for symbol in system.symbols]
    gamma = next((v for v in system.state if v == Vector("gamma")), None)
    if gamma is not None:
        one, two, _ = gamma.symbols
        scalars.append(
            Scalar(
                "longitude",
                sp.atan2(two, one),
                f"atan2({two}, {one})",
                "rad",
                "longitude of γ",
                mathml(latex(sp.atan2(two, one))),
                True,
            )
        )
    for item in recorded_quantities(system):
        name = item.name.removeprefix("law_")
        places = labels_of(item.frame, len(item.formulas))
        for i, component in zip(places, item.formulas, strict=True):
            own = f"{name}_{i}" if item.is_vector else name
            if any(scalar.name == own for scalar in scalars) or item.frame == "quaternion":
                continue
            text = own if not item.is_vector or _reads(system, own) else str(component)
            meaning = f"{item.meaning}, component {i}" if item.is_vector else item.meaning
            scalars.append(
                Scalar(own, component, text, item.unit, meaning, symbol_mathml(own), False)
            )
    return tuple(scalars)


def _of_symbol(study: Study, system: System, symbol: sp.Symbol) -> Scalar:
    name = str(symbol)
    owner = next(v for v in system.state if v == symbol or symbol in getattr(v, "symbols", ()))
    size = 1 if owner == symbol else len(owner.symbols)
    meaning, unit, _, _ = variable_metadata(
        system, str(owner), size, study.variables.get(str(owner))
    )
    if size > 1:
        meaning = f"{meaning}, component {owner.symbols.index(symbol) + 1}"
    angle = size == 1 and is_angle(system, symbol)
    return Scalar(name, symbol, name, unit or "1", meaning, symbol_mathml(name), angle)


def _reads(system: System, text: str) -> bool:
    """Whether a text names a quantity of the system."""
    try:
        formula(system, text)
    except InputError:
        return False
    return True

"""The machine code of a page: everything it computes for a system, as one WebAssembly module."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.kernel.equations import Equations, equations_of
from flowlanes.flow.kernel.outcomes import STATUS_MESSAGES
from flowlanes.flow.kernel.wasm import emit_integration_loop, emit_row_functions, wasm_module
from flowlanes.formulas.array_evaluation import read_formulas
from flowlanes.formulas.graph import Term
from flowlanes.system.parameters import ROUNDING, condition_words, conditions
from flowlanes.system.system import System

from ..experiment.study import Study
from ..experiment.subjects.subject import BodySubject
from .columns import Column, Scalar, columns_of, scalars_of
from .page_start import SPINS, start_tables
from .page_systems import page_system, reduced_system
from .scene_model import Json
from .sections import chosen_section, sectionable, terms_of
from .start_terms import StartTerms, start_terms
from .surface_terms import surface_terms

#: Lanes of the loops: WebAssembly has vectors of two doubles.
LANES = 2

#: Tolerances: of a motion in a page, so that states agree with Taylor series to 1e-12, and of its
#: sections, as on the command line.
TOLERANCE, SECTION_TOLERANCE = 2e-16, 1e-13


@dataclass(frozen=True)
class PageModule:
    """A module and the information its caller needs.

    Attributes
    ----------
    code : bytes
    tables : dict
        Tables for JSON; see ``WasmTables`` in ``web/src/model.ts``.
    """

    code: bytes
    tables: dict[str, Json]


class _Texts:
    """The generated functions of a module."""

    def __init__(self) -> None:
        self.texts: list[str] = []
        self.exports: list[str] = []

    def march(
        self, prefix: str, equations: Equations, deviations: int, tolerance: float
    ) -> dict[str, Json]:
        """Add an integration loop; return the table of its call."""
        text, work = emit_integration_loop(prefix, equations, LANES, tolerance)
        self.texts.append(text)
        self.exports.append(f"{prefix}_march")
        return {
            "name": f"{prefix}_march",
            "dimension": len(equations.rates),
            "deviations": deviations,
            "parameters": equations.parameters,
            "work": work,
        }

    def values(
        self, prefix: str, pieces: Mapping[str, Sequence[Term]], inputs: int
    ) -> dict[str, dict[str, Json]]:
        """Add groups of formulas; return the tables of their calls."""
        text, names, work = emit_row_functions(prefix, pieces, inputs)
        self.texts.append(text)
        self.exports.extend(names.values())
        return {
            piece: {"name": names[piece], "inputs": inputs, "outputs": len(terms), "work": work}
            for piece, terms in pieces.items()
        }


def page_module(study: Study) -> PageModule:
    r"""Generate the module of a study.

    Raises
    ------
    InputError
        If the equations change at events (friction), or a formula has a function without machine
        code.

    Examples
    --------
    >>> import chaplygin as ch
    >>> study = ch.Study.from_experiment(ch.parse_experiment('system = {name = "veselova"}'))
    >>> module = page_module(study)
    >>> module.code[:4], module.tables["motion"]["dimension"]
    (b'\x00asm', 10)
    """
    if study.subject.changes_equations:
        raise InputError(
            f"{study.system.name}: with friction the equations of motion change at events, and no "
            "module follows them; the equations of sliding are printed as text, latex, julia or c"
        )
    system, reduced = page_system(study), reduced_system(study)
    whole = system.lifted() if system.reconstruction else system
    scalars = scalars_of(study, reduced)
    places = sectionable(reduced, scalars)
    backward = study.experiment.run.direction == "backward"
    texts = _Texts()
    tables: dict[str, Json] = {
        "motion": texts.march("motion", equations_of(whole, 0, None, backward), 0, TOLERANCE),
        "section": texts.march(
            "section", chosen_section(reduced, places, backward), 0, SECTION_TOLERANCE
        ),
        "tangent": texts.march(
            "tangent", equations_of(reduced, 1, None, backward), 1, SECTION_TOLERANCE
        ),
        "section_quantities": [scalar.name for scalar in places],
        "groups": [list(group) for group in equations_of(reduced, 0, None, False).groups],
        "lanes": LANES,
        "relations": len(reduced.relations),
        "whole_relations": len(whole.relations),
        "integrals": [law.name for law in reduced.integrals],
        "reasons": [*STATUS_MESSAGES, *(guard.message for guard in system.guards)],
        "conditions_on_parameters": _admissible_table(system),
        **start_tables(study, whole),
    }
    tables |= texts.values("whole", _whole_pieces(study, whole), len(whole.symbols))
    tables |= texts.values("reduced", _reduced_pieces(reduced, scalars), len(reduced.symbols))
    tables |= _start(texts, study, system)
    tables |= _surfaces(texts, study, reduced)
    return PageModule(wasm_module(texts.texts, texts.exports), tables)


def _whole_pieces(study: Study, whole: System) -> dict[str, list[Term]]:
    """Terms of the columns, and of the relations with their gradients."""
    reader, _ = read_formulas(whole)
    graph = reader.graph
    columns: Sequence[Column] = columns_of(study)
    relations = [reader(r) for r in whole.scalar.relations]
    states = [graph.state(i) for i in range(len(whole.symbols))]
    slopes = [t for row in graph.jacobian(relations, states) for t in row] if relations else []
    pieces = {"columns": [reader(f) for column in columns for f in column.formulas]}
    pieces["phase_space"] = [*relations, *slopes]
    return pieces


def _reduced_pieces(reduced: System, scalars: Sequence[Scalar]) -> dict[str, list[Term]]:
    """Terms of quantities, conditions with their gradients, rates and guards."""
    reader, rates = read_formulas(reduced)
    graph = reader.graph
    quantities = list(terms_of(reduced, scalars))
    relations = [reader(r) for r in reduced.scalar.relations]
    integrals = [reader(law.value) for law in reduced.scalar.integrals]
    states = [graph.state(i) for i in range(len(reduced.symbols))]

    def with_slopes(terms: list[Term]) -> list[Term]:
        return [*terms, *(t for row in graph.jacobian(terms, states) for t in row)]

    return {
        "quantities": quantities,
        "conditions": with_slopes([*relations, *integrals, *quantities]),
        "invariants": with_slopes([*relations, *integrals]),
        "rates": list(rates),
        "guards": [reader(guard.value) for guard in reduced.scalar.guards],
        "admissible": [reader(side) for _, _, side in _admissible(reduced)],
    }


# --- parameters ------------------------------------------------------------------------------


def _admissible(system: System) -> list[tuple[str, sp.Basic, sp.Expr]]:
    """Conditions on parameters, each with a formula that is positive if it holds."""
    return [
        (str(item.symbol), condition, side)
        for item, condition in conditions(system.parameters)
        if (side := positive_where(condition)) is not None
    ]


def positive_where(condition: sp.Basic) -> sp.Expr | None:
    """A formula that is positive where a condition holds; None for an equation or a truth value."""
    match condition:
        case sp.Gt() | sp.Lt():
            return condition.gts - condition.lts
        case sp.Ge() | sp.Le():
            more, less = condition.gts, condition.lts
            # equality is admitted within rounding; the smallest double makes 0 ≥ 0 positive
            return more - less + ROUNDING * (sp.Abs(more) + sp.Abs(less)) + sp.Float(5e-324)
        case sp.Ne():
            return sp.Abs(condition.lhs - condition.rhs)
        case sp.And() | sp.Or():
            sides = [positive_where(part) for part in condition.args]
            # 2 where a side is positive, and 0 elsewhere
            parts = [sp.sign(side) * (1 + sp.sign(side)) for side in sides if side is not None]
            if isinstance(condition, sp.And):
                return sp.Mul(*parts)
            return sp.Add(*parts) if None not in sides else None
    return None


def _admissible_table(system: System) -> list[Json]:
    """The parameter and the text of each condition of `_admissible`."""
    return [
        {"parameter": name, "condition": condition_words(condition)}
        for name, condition, _ in _admissible(system)
    ]


# --- start and shape --------------------------------------------------------------------------


def _start(texts: _Texts, study: Study, system: System) -> dict[str, Json]:
    """The start from ω and γ; None if it is the state itself."""
    terms: StartTerms | None = None
    if isinstance(study.subject, BodySubject):
        terms = start_terms(study.subject, system)
    if terms is None:
        return {"start": None, "excess": []}
    every = [*terms.state, *terms.excess, *terms.nearest]
    table = texts.values("given", {"start": every}, len(terms.inputs))
    return {**table, "excess": [SPINS] * len(terms.excess)}


def _surfaces(texts: _Texts, study: Study, reduced: System) -> dict[str, Json]:
    """The tables of the drawn surfaces that are given by formulas."""
    pieces, place = surface_terms(study, reduced)
    tables: dict[str, Json] = {"contact": None, "inertia": None, "ground": None, "gamma": place}
    if pieces:
        tables.update(texts.values("shape", pieces, len(reduced.symbols)))
    return tables

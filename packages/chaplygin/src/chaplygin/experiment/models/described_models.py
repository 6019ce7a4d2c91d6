"""Experiments whose file describes the mechanics: a Lagrangian, or equations."""

from __future__ import annotations

from pydantic import Field

from ..file.mechanism_tables import (
    ConstraintsTable,
    EquationsTable,
    FormulaValue,
    FrameTable,
    GuardTable,
    LagrangianTable,
    LawsTable,
    MeaningTable,
    NumberTable,
    ObservableTable,
    PlanTable,
)
from ..file.tables import RunTable, StateTable
from ..file.toml import dumps
from .base import ExperimentBase


class OwnExperiment(ExperimentBase):
    """The base of systems of the user's own, whose start is given by their state."""

    summary: str = Field(default="", description="a text in quotes")
    """One or two sentences on what moves, for reports."""
    parameters: dict[str, NumberTable] = Field(default={}, description="a table of numbers")
    definitions: dict[str, FormulaValue] = Field(default={}, description="a table of formulas")
    """Named quantities in order, each in terms of those before it."""
    laws: LawsTable = Field(default=LawsTable(), description="a table")
    observables: dict[str, ObservableTable] = Field(default={}, description="a table of formulas")
    guards: dict[str, GuardTable] = Field(default={}, description="a table of tables")
    variables: dict[str, MeaningTable] = Field(default={}, description="a table of tables")
    """Meaning and unit of coordinates and velocities."""
    plan: PlanTable | None = Field(default=None, description="a table of what is drawn")
    start: StateTable = Field(default={}, description="a table of named values")
    run: RunTable = Field(default=RunTable(), description="a table")

    def toml(self) -> str:
        """A complete TOML text, defaults included, that reads back to an equal experiment."""
        tables = self.model_dump(exclude_none=True)
        last = ("definitions", "laws", "observables", "guards", "variables", "plan", "start", "run")
        for name in last:
            if name in tables:
                tables[name] = tables.pop(name)
        return dumps(tables)


class MechanismExperiment(OwnExperiment):
    """A Lagrangian in a frame, with forces and constraints.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of wrong parts; `load` raises InputError.
    """

    frame: FrameTable = Field(description="a table [frame] with coordinates or velocities")
    lagrangian: LagrangianTable = Field(description="a table [lagrangian] with kinetic or L")
    forces: dict[str, FormulaValue] = Field(default={}, description="a table of formulas")
    """Generalised forces by velocity."""
    constraints: ConstraintsTable = Field(default=ConstraintsTable(), description="a table")


class EquationsExperiment(OwnExperiment):
    """Equations of motion as they stand.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of wrong parts; `load` raises InputError.
    """

    equations: EquationsTable = Field(description="a table [equations] with state and rates")

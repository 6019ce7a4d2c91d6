"""The tables of a file that describes a system itself: by equations, or by a Lagrangian."""

from __future__ import annotations

from pydantic import Field

from .catalogue_table import CatalogueTable
from .law_tables import EquationsTables, SystemTables
from .sourced import SourcedTables
from .tables import (
    ConstraintsTable,
    FormulaValue,
    FrameTable,
    LagrangianTable,
    MeaningTable,
    PlanTable,
    Text,
)


class DescribedFile(SystemTables, SourcedTables):
    """The tables common to files with equations and with a Lagrangian."""

    variables: dict[str, MeaningTable] = Field(default={}, description="a table of tables")
    """Meaning and unit of coordinates and velocities."""
    letters: dict[str, Text] = Field(default={}, description="a table of texts in quotes")
    """Meaning of letters in the equations."""
    plan: PlanTable | None = Field(default=None, description="a table of what is drawn")
    catalogue: CatalogueTable | None = Field(default=None, description="a table with group")


class MechanismFile(DescribedFile):
    """A Lagrangian in a frame, with forces and constraints."""

    frame: FrameTable = Field(description="a table [frame] with coordinates or velocities")
    lagrangian: LagrangianTable = Field(description="a table [lagrangian] with kinetic or L")
    forces: dict[str, FormulaValue] = Field(default={}, description="a table of formulas")
    """Generalised forces by velocity."""
    constraints: ConstraintsTable = Field(default=ConstraintsTable(), description="a table")


class EquationsFile(DescribedFile, EquationsTables):
    """A file with equations of motion."""

"""Experiments whose file describes the mechanics: a Lagrangian, or equations."""

from __future__ import annotations

from pydantic import Field

from nonholonomic.system_files.described import DescribedFile, EquationsFile, MechanismFile

from ..file.tables import RunTable, StateTable
from .base import ExperimentBase


class OwnExperiment(DescribedFile, ExperimentBase):
    """The base class of user-defined systems, whose start gives their state."""

    start: StateTable = Field(default={}, description="a table of named values")
    run: RunTable = Field(default=RunTable(), description="a table")

    def toml(self) -> str:
        """A complete TOML text, defaults included, that reads back to an equal experiment."""
        from nonholonomic.system_files.write import file_text

        return file_text(self.model_dump(exclude_none=True))


class MechanismExperiment(MechanismFile, OwnExperiment):
    """A Lagrangian in a frame, with forces and constraints.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of wrong parts; `load` raises InputError.
    """


class EquationsExperiment(EquationsFile, OwnExperiment):
    """Equations of motion in explicit form.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of wrong parts; `load` raises InputError.
    """

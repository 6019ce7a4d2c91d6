"""Experiments with a system of the catalogue."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pydantic import Field, ValidationInfo, field_validator, model_validator

from nonholonomic.system_files.body_tables import FilledBodyTable

from ..file.tables import StateTable, SystemRunTable, SystemStartTable, SystemTable
from .base import ExperimentBase

if TYPE_CHECKING:
    from nonholonomic.mechanics.rolling.cavity import Cavity


class CatalogueExperiment(ExperimentBase):
    """The part common to all systems of the catalogue."""

    system: SystemTable = Field(description="a table [system] with a name")
    body: FilledBodyTable | None = Field(default=None, description="a table with cavity")

    @property
    def cavities(self) -> tuple[Cavity, ...]:
        """The cavities of its body, none by default."""
        return () if self.body is None else self.body.cavities

    @model_validator(mode="before")
    @classmethod
    def _parameters_beside(cls, tables: object) -> object:
        """For an n-dimensional system, [parameters] belongs to [system]."""
        if not isinstance(tables, dict) or not isinstance(tables.get("parameters"), dict):
            return tables
        system = tables.get("system")
        if not isinstance(system, dict):
            return tables
        from nonholonomic.catalogue import CATALOGUE

        item, own = CATALOGUE.get(str(system.get("name"))), system.get("parameters", {})
        if item is None or item.family is None or not isinstance(own, dict):
            return tables
        others = {key: value for key, value in tables.items() if key != "parameters"}
        return others | {"system": system | {"parameters": own | tables["parameters"]}}

    def complete_tables(self) -> dict[str, Any]:
        """All tables, with every parameter of the system."""
        from nonholonomic.catalogue import entry

        parameters = entry(self.system.name).settings(self.system.parameters)
        system = {**self.system.model_dump(), "parameters": parameters}
        return super().complete_tables() | {"system": system}


class SystemExperiment(CatalogueExperiment):
    """A system of the catalogue, which determines body, surface, contact and field.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of wrong parts; `load` raises InputError.
    """

    start: SystemStartTable = Field(default=SystemStartTable(), description="a table")
    run: SystemRunTable = Field(default=SystemRunTable(), description="a table")

    @field_validator("start")
    @classmethod
    def _fluid_in_cavities(cls, start: SystemStartTable, info: ValidationInfo) -> SystemStartTable:
        if "body" in info.data:
            body = info.data["body"]
            start.require_cavities(() if body is None else body.cavities, "body")
        return start


class StateExperiment(CatalogueExperiment):
    """A system of the catalogue whose start is given by the names of its state.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of wrong parts; `load` raises InputError.
    """

    start: StateTable = Field(default={}, description="a table of named values")
    run: SystemRunTable = Field(default=SystemRunTable(), description="a table")

    @field_validator("body")
    @classmethod
    def _without_fluid(
        cls, body: FilledBodyTable | None, info: ValidationInfo
    ) -> FilledBodyTable | None:
        if body is not None and "system" in info.data:
            # Only an invalid file needs this module, which imports the equations of rolling.
            from nonholonomic.catalogue.fixed_point.fluid_filled_bodies import refusal

            raise ValueError(refusal(info.data["system"].name))
        return body

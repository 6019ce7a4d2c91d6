"""The table by which a file has its place in the catalogue."""

from __future__ import annotations

from pydantic import Field, StrictBool, StrictStr

from .table import Table


class CatalogueTable(Table):
    """The place of a system in the catalogue."""

    group: StrictStr = Field(description="the name of a group of the catalogue")
    integrable: StrictBool = Field(default=False, description="true or false")
    """Whether the system is proven integrable with the values of its parameters."""
    python: StrictStr = Field(default="", description="the name of a module of the catalogue")
    """Its ``ENTRIES`` make the equations that no file can express."""
    laws: StrictStr = Field(default="", description="the name of a module and a function")
    """It states the laws of a body besides the energy."""
    general: StrictStr = Field(default="", description="the name of a module and a function")
    """Where the system is made with what is arbitrary left arbitrary."""

"""The drawing of a mechanism, from the table [plan] of a file."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.system import System

from ..mechanics.lagrangian.plan import Plan
from .described import DescribedFile
from .names import Names
from .parts import names_of
from .tables import PlanTable


def described_plan(experiment: DescribedFile, system: System) -> Plan | None:
    """The drawing of the table [plan]; None without one.

    Raises
    ------
    InputError
        If a formula cannot be read; the message names its place.
    """
    table = experiment.plan
    if table is None:
        return None
    whole = system.lifted() if system.reconstruction else system
    names = Names(experiment.where, names_of(whole))

    def read(key: str) -> tuple[tuple[sp.Expr, ...], ...]:
        return tuple(
            tuple(names.scalar(text, "plan", key) for text in texts)
            for texts in getattr(table, key)
        )

    x, y = (names.scalar(text, "plan", "path") for text in table.path)
    others = {key: read(key) for key in PlanTable.model_fields if key != "path"}
    return Plan((x, y), **others)

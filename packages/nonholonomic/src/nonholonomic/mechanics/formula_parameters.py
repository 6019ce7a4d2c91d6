"""Parameters of a formula of the user: of a shape, a surface, a potential or a law of friction."""

from __future__ import annotations

import math
from collections.abc import Mapping

from flowlanes.arguments import FormulaParameters
from flowlanes.errors import InputError
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol


def formula_parameters(
    given: FormulaParameters, meaning: str, unit: str = ""
) -> tuple[Parameter, ...]:
    """The parameters of a formula, declared.

    Parameters
    ----------
    given : mapping of str or Symbol to float, or sequence of Parameter
        Values by name or symbol; a `Parameter` has a meaning and a unit of its own.
    meaning, unit : str
        Those of the values of a mapping.

    Raises
    ------
    InputError
        If a value is not finite.

    Examples
    --------
    >>> (a,) = formula_parameters({"a": 0.02}, "parameter of the profile", "m")
    >>> a.symbol, a.default, a.unit
    (a, 0.02, 'm')
    """
    declared = (
        tuple(Parameter(real_symbol(str(name)), meaning, x, unit) for name, x in given.items())
        if isinstance(given, Mapping)
        else tuple(given)
    )
    for parameter in declared:
        if not math.isfinite(parameter.default):
            raise InputError(
                f"parameter {parameter.symbol} = {parameter.default}: it must be a finite number"
            )
    return declared

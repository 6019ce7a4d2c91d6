"""Laws that need certain values of the parameters."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp

from flowlanes.system.laws import Law
from flowlanes.system.vectors import real_symbol


def holding(laws: Iterable[Law], numbers: Mapping[str, float]) -> tuple[Law, ...]:
    """The laws whose conditions on the parameters the numbers fulfil.

    Parameters
    ----------
    laws : iterable of Law
    numbers : mapping of str to float
        Parameters by symbol name, taken as the decimals they are given by.

    Examples
    --------
    >>> from flowlanes import Integral
    >>> from flowlanes.system import real_symbol
    >>> law = Integral("field", real_symbol("x"), level=(real_symbol("K"),))
    >>> len(holding([law], {"K": 0.0})), len(holding([law], {"K": 1.0}))
    (1, 0)
    """
    values = {real_symbol(name): sp.Rational(str(value)) for name, value in numbers.items()}
    return tuple(
        law
        for law in laws
        if not any((level := c.xreplace(values)).is_number and level != 0 for c in law.level)
    )

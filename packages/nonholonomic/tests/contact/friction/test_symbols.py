"""Names at a contact."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.vectors import Vector
from nonholonomic.contact.friction import symbols


def test_no_name_stands_for_two_quantities():
    quantities = [x for x in vars(symbols).values() if isinstance(x, Vector | sp.Symbol)]
    scalars = [s for x in quantities for s in (x.symbols if isinstance(x, Vector) else [x])]
    assert len(quantities) > 25
    assert len({str(s) for s in scalars}) == len(scalars)
    # a vector beside a scalar of its name would be mistaken for it in a table
    assert len({str(x) for x in quantities}) == len(quantities)

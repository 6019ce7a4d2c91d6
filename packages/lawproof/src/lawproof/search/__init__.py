"""Search for laws: integrals, measures and symmetries, from the equations alone.

A question names an ansatz.  Its linear algebra is done modulo a large prime at random points of the
phase space; a solution is converted to a formula in the parameters and proved.

>>> from nonholonomic.catalogue import from_catalogue
>>> from lawproof.search import search_space, integrals
>>> for found in integrals(search_space(from_catalogue("veselova"))):
...     print(found.formula, found.verdict.decision)
Dot(omega, I*omega) proven
Dot(I*omega, I*omega) - Dot(omega, I*gamma)**2 proven
"""

from .integrals import integrals
from .measures import measures
from .request import search_space
from .result import SearchResult, SearchSpace
from .symmetries import symmetries

__all__ = ["SearchResult", "SearchSpace", "integrals", "measures", "search_space", "symmetries"]

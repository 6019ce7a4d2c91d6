"""Search for laws: integrals, measures and symmetries, from the equations alone.

A question names an ansatz.  Its linear algebra is done modulo a large prime at random points of the
phase space; a solution is converted to a formula in the parameters and proved.

>>> import flowlanes
>>> import sympy as sp
>>> from lawproof.search import search_space, integrals
>>> a, b, c = sp.symbols("a b c", real=True)
>>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
>>> for found in integrals(search_space(top)):
...     print(found.formula, found.verdict.decision)
4*a**2 + b**2 proven
3*a**2 - c**2 proven
"""

from .finder import SEARCHES, find_laws
from .integrals import integrals
from .measures import measures
from .request import search_space
from .result import SearchResult, SearchSpace
from .symmetries import symmetries

__all__ = [
    "SEARCHES",
    "SearchResult",
    "SearchSpace",
    "find_laws",
    "integrals",
    "measures",
    "search_space",
    "symmetries",
]

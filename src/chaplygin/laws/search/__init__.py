"""The search for laws: integrals, measures and symmetries that nobody has told.

A question names an ansatz; its linear algebra is done modulo a large prime at random points of
the phase space, and what is found there becomes a formula in the parameters and is proven.

>>> from chaplygin.systems import from_catalogue
>>> from chaplygin.laws.search import ask, integrals
>>> for found in integrals(ask(from_catalogue("veselova"))):
...     print(found.formula, found.verdict.decision)
"""

from .finding import Finding, Question
from .integrals import integrals
from .measures import measures
from .question import ask
from .symmetries import symmetries

__all__ = ["Finding", "Question", "ask", "integrals", "measures", "symmetries"]

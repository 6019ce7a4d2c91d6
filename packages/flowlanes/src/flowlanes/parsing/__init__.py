"""Formulas typed by the user, read into SymPy without running any code of theirs.

The language is small: decimal numbers, the names that the caller knows, ``pi``, the operators
``+ - * / **``, parentheses and the functions of `FUNCTIONS`; ``γ₃²`` is read as ``gamma_3**2``.
Decimal numbers become exact rationals (``0.3`` is 3/10), so that what is proved of a formula later
is proved exactly.  If there are vectors, ``dot(u, v)``, ``cross(u, v)`` and ``[a, b, c]`` may be
used besides.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

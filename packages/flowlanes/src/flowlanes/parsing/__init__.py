"""Parse formulas typed by the user into SymPy without executing any code.

The language is small: decimal numbers, the names known to the caller, ``pi``, the operators ``+ - *
/ **``, parentheses and the functions of `FUNCTIONS`; ``θ₃²`` is read as ``theta_3**2``.  Decimal
numbers become exact rationals (``0.3`` is 3/10), so proofs about a formula are exact.  With
vectors, ``dot(u, v)``, ``cross(u, v)`` and ``[a, b, c]`` are available too.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

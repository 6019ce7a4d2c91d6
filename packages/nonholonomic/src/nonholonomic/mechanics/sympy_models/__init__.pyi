from .conversion import from_sympy as from_sympy, mechanism_from_sympy as mechanism_from_sympy

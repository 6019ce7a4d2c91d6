"""Arithmetic and formulas as LLVM code: generation, elementary functions, compilation, cache."""

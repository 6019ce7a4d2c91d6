"""Arithmetic and formulas as LLVM code: text, elementary functions, compiling, and its cache."""

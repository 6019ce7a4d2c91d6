"""Formulas turned into numbers of any kind: doubles, balls, jets, Taylor series, fields."""

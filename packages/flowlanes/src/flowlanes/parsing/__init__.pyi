from .formula_printer import formula_text as formula_text
from .grammar import (
    CONSTANTS as CONSTANTS,
    FUNCTIONS as FUNCTIONS,
    MAX_LENGTH as MAX_LENGTH,
    PRODUCTS as PRODUCTS,
    RESERVED_WORDS as RESERVED_WORDS,
)
from .reading import nearest as nearest, parse as parse, parse_formula as parse_formula
from .vector import Formula as Formula, NamedQuantity as NamedQuantity

from .array_evaluation import values as values
from .array_formulas import Formulas as Formulas
from .balls import ball as ball, ball_function as ball_function, ball_values as ball_values

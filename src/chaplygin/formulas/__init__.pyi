from .balls import ball as ball, ball_function as ball_function, ball_values as ball_values
from .batch import Formulas as Formulas
from .evaluate import values as values

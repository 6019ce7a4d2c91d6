from .chaplygin import chaplygin_form as chaplygin_form
from .numerical import gyroscopic_integral as gyroscopic_integral, log_multiplier as log_multiplier
from .reduced_form import ChaplyginForm as ChaplyginForm

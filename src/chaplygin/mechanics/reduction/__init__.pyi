from .chaplygin import chaplygin_form as chaplygin_form
from .reduced_form import ChaplyginForm as ChaplyginForm

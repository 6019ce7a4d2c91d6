from .chaplygin import chaplygin_form as chaplygin_form
from .form import ChaplyginForm as ChaplyginForm

from .chaplygin import chaplygin_form as chaplygin_form
from .chaplygin_form import ChaplyginForm as ChaplyginForm

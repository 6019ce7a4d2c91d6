from . import figures as figures
from .write import write_study as write_study

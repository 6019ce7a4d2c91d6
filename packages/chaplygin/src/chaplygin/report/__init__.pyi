from . import figures as figures
from .study_output import write_study as write_study

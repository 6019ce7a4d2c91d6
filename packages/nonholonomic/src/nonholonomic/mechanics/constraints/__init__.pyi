from .exceptional_parameters import exceptional_values as exceptional_values
from .integrability import nonholonomy as nonholonomy, nonholonomy_at as nonholonomy_at

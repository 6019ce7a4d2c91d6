from .integrability import nonholonomy as nonholonomy, nonholonomy_at as nonholonomy_at

from .base.solution import ClosedForm as ClosedForm, Solution as Solution
from .genus_two.separation import SeparatedSystem as SeparatedSystem
from .isomorphism import inverse as inverse, pull_back as pull_back, push_forward as push_forward
from .solver import solve as solve

from .base.solution import (
    ClosedForm as ClosedForm,
    NamedConstant as NamedConstant,
    Solution as Solution,
)
from .bifurcation import bifurcation_diagram as bifurcation_diagram, locate as locate
from .genus_two.separation import SeparatedSystem as SeparatedSystem
from .isomorphism import (
    inverse as inverse,
    inverse_identity as inverse_identity,
    pull_back as pull_back,
    push_forward as push_forward,
)
from .isomorphism_motion import IsomorphismMap as IsomorphismMap
from .revolution.diagram import revolution_diagram as revolution_diagram
from .solver import solve as solve

from . import (
    catalogue as catalogue,
    classification as classification,
    closed_form as closed_form,
    contact as contact,
    control as control,
    invariant_measures as invariant_measures,
    mechanics as mechanics,
    system_files as system_files,
)
from ._version import __version__ as __version__
from .catalogue import (
    CATALOGUE as CATALOGUE,
    from_catalogue as from_catalogue,
)
from .classification.classifier import classify as classify
from .closed_form.base.solution import Solution as Solution
from .closed_form.solver import solve as solve
from .invariant_measures.existence import invariant_measure as invariant_measure
from .mechanics.ball.ball import RollingBall as RollingBall
from .mechanics.constraints.integrability import nonholonomy as nonholonomy
from .mechanics.lagrangian.mechanism import (
    Frame as Frame,
    Mechanism as Mechanism,
    coordinates as coordinates,
)
from .mechanics.lagrangian.poincare_suslov import equations_of_motion as equations_of_motion
from .mechanics.reduction.chaplygin import chaplygin_form as chaplygin_form
from .mechanics.rolling.body import Body as Body
from .mechanics.rolling.cavity import Cavity as Cavity
from .mechanics.rolling.equations import (
    Forces as Forces,
    RollingBody as RollingBody,
    rolling_system as rolling_system,
)
from .mechanics.rolling.mechanism import rolling_mechanism as rolling_mechanism
from .mechanics.shapes.implicit import ImplicitShape as ImplicitShape
from .mechanics.shapes.revolution import ShapeOfRevolution as ShapeOfRevolution
from .mechanics.shapes.shapes import (
    Ball as Ball,
    Disk as Disk,
    Ellipsoid as Ellipsoid,
    Torus as Torus,
)
from .mechanics.shapes.surfaces import (
    Plane as Plane,
    Sphere as Sphere,
)
from .mechanics.sympy_models.conversion import (
    from_sympy as from_sympy,
    mechanism_from_sympy as mechanism_from_sympy,
)
from .starts import initial_state as initial_state

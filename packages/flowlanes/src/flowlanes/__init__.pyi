from . import (
    flow as flow,
    formulas as formulas,
    lyapunov as lyapunov,
    orbits as orbits,
    parsing as parsing,
    printing as printing,
    scans as scans,
    system as system,
)
from ._version import __version__ as __version__
from .errors import (
    InputError as InputError,
    RunError as RunError,
)
from .flow.batch import batch_integrator as batch_integrator
from .flow.ensembles.run import ensemble as ensemble
from .flow.gauss import gauss_integrator as gauss_integrator
from .flow.integrator import integrate as integrate
from .flow.kernel.equations import poincare_section as poincare_section
from .flow.linearisation.linear_stability import linear_stability as linear_stability
from .flow.sampling.level_sampler import sample_level as sample_level
from .flow.sections.poincare_map import PoincareMap as PoincareMap
from .flow.trajectory import Trajectory as Trajectory
from .lyapunov.spectrum import lyapunov_spectrum as lyapunov_spectrum
from .orbits.reversor import reversing_symmetries as reversing_symmetries
from .orbits.rotation import rotation_number as rotation_number
from .printing.code import (
    lambdify as lambdify,
    source_code as source_code,
)
from .system.isomorphism import Isomorphism as Isomorphism
from .system.laws import (
    ConformallyHamiltonian as ConformallyHamiltonian,
    Identity as Identity,
    Integral as Integral,
    Measure as Measure,
    PoissonStructure as PoissonStructure,
    Rate as Rate,
    Reduction as Reduction,
    Separation as Separation,
    Symmetry as Symmetry,
)
from .system.system import (
    Parameter as Parameter,
    System as System,
)

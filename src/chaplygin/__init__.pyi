from . import (
    analysis as analysis,
    borisov_mamaev as borisov_mamaev,
    catalogue as catalogue,
    contact as contact,
    control as control,
    core as core,
    experiment as experiment,
    explicit as explicit,
    flow as flow,
    lab as lab,
    measures as measures,
    mechanics as mechanics,
    proof as proof,
    report as report,
    search as search,
)
from ._version import __version__ as __version__
from .analysis.classification.classifier import classify as classify
from .analysis.lyapunov.spectrum import lyapunov_spectrum as lyapunov_spectrum
from .analysis.orbits.reversing_symmetries import reversors as reversors
from .analysis.orbits.rotation import rotation_number as rotation_number
from .borisov_mamaev.audit import audit as audit
from .catalogue import CATALOGUE as CATALOGUE, from_catalogue as from_catalogue
from .core.isomorphism import Isomorphism as Isomorphism
from .core.laws import (
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
from .core.system import Parameter as Parameter, System as System
from .errors import InputError as InputError, RunError as RunError
from .experiment.dataset import read as read, to_dataset as to_dataset, write as write
from .experiment.models.experiment import load as load, loads as loads
from .experiment.study import Study as Study, prepare as prepare
from .explicit.base.solution import Solution as Solution
from .explicit.solver import solve as solve
from .flow.batch import batch_integrator as batch_integrator
from .flow.ensemble.run import ensemble as ensemble
from .flow.gauss import gauss_integrator as gauss_integrator
from .flow.integrator import integrate as integrate
from .flow.kernel.equations import poincare_section as poincare_section
from .flow.linearisation.linear_stability import linear_stability as linear_stability
from .flow.sampling.level_sampler import sample_level as sample_level
from .flow.sections.poincare_map import PoincareMap as PoincareMap
from .flow.trajectory import Trajectory as Trajectory
from .measures.existence import measure_exists as measure_exists
from .mechanics.ball.ball import RollingBall as RollingBall
from .mechanics.constraints.integrability import nonholonomy as nonholonomy
from .mechanics.lagrangian.mechanism import (
    Frame as Frame,
    Mechanism as Mechanism,
    coordinates as coordinates,
)
from .mechanics.lagrangian.poincare_suslov import equations as equations
from .mechanics.reduction.chaplygin import chaplygin_form as chaplygin_form
from .mechanics.rolling.body import Body as Body
from .mechanics.rolling.cavity import Cavity as Cavity
from .mechanics.rolling.equations import Forces as Forces, Rolling as Rolling, roll as roll
from .mechanics.rolling.initial_state import initial_state as initial_state
from .mechanics.rolling.mechanism import rolling_mechanism as rolling_mechanism
from .mechanics.shapes.implicit import Implicit as Implicit
from .mechanics.shapes.revolution import Revolution as Revolution
from .mechanics.shapes.shapes import (
    Ball as Ball,
    Disk as Disk,
    Ellipsoid as Ellipsoid,
    Torus as Torus,
)
from .mechanics.shapes.surfaces import Plane as Plane, Sphere as Sphere
from .mechanics.sympy_models.conversion import (
    from_sympy as from_sympy,
    mechanism_from_sympy as mechanism_from_sympy,
)
from .printing.code import lambdify as lambdify, source_code as source_code
from .proof.prover import prove as prove
from .proof.verdict import Verdict as Verdict

from . import ensembles as ensembles
from .batch import batch_integrator as batch_integrator
from .ensembles.run import ensemble as ensemble
from .gauss import gauss_integrator as gauss_integrator
from .integrator import integrate as integrate
from .kernel.equations import Section as Section, poincare_section as poincare_section
from .level_projection import project_to_level as project_to_level
from .linearisation.linear_stability import (
    Linearisation as Linearisation,
    relative_equilibrium as relative_equilibrium,
)
from .linearisation.tangent_space import TangentSpace as TangentSpace
from .motion import Motion as Motion
from .sampling.level_sampler import level_sampler as level_sampler, sample_level as sample_level
from .sampling.resampling import resampled_level as resampled_level
from .sections.poincare_map import PoincareMap as PoincareMap
from .stepping import Stepper as Stepper, stepper as stepper
from .trajectory import Event as Event, Trajectory as Trajectory

from flowlanes.errors import (
    InputError as InputError,
    RunError as RunError,
)
from flowlanes.flow.batch import (
    batch_integrator as batch_integrator,
)
from flowlanes.flow.ensembles.run import (
    ensemble as ensemble,
)
from flowlanes.flow.gauss import (
    gauss_integrator as gauss_integrator,
)
from flowlanes.flow.integrator import (
    integrate as integrate,
)
from flowlanes.flow.kernel.equations import (
    poincare_section as poincare_section,
)
from flowlanes.flow.linearisation.linear_stability import (
    linear_stability as linear_stability,
)
from flowlanes.flow.sampling.level_sampler import (
    sample_level as sample_level,
)
from flowlanes.flow.sections.poincare_map import (
    PoincareMap as PoincareMap,
)
from flowlanes.flow.trajectory import (
    Trajectory as Trajectory,
)
from flowlanes.lyapunov.spectrum import (
    lyapunov_spectrum as lyapunov_spectrum,
)
from flowlanes.orbits.reversor import (
    reversing_symmetries as reversing_symmetries,
)
from flowlanes.orbits.rotation import (
    rotation_number as rotation_number,
)
from flowlanes.printing.code import (
    lambdify as lambdify,
    source_code as source_code,
)
from flowlanes.system.isomorphism import (
    Isomorphism as Isomorphism,
)
from flowlanes.system.laws import (
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
from flowlanes.system.system import (
    Parameter as Parameter,
    System as System,
)
from lawproof.proof.prover import (
    prove as prove,
    prove_all as prove_all,
)
from lawproof.proof.verdict import (
    Verdict as Verdict,
)
from nonholonomic.catalogue import (
    CATALOGUE as CATALOGUE,
    from_catalogue as from_catalogue,
)
from nonholonomic.classification.classifier import (
    classify as classify,
)
from nonholonomic.closed_form.base.solution import (
    Solution as Solution,
)
from nonholonomic.closed_form.solver import (
    solve as solve,
)
from nonholonomic.invariant_measures.existence import (
    invariant_measure as invariant_measure,
)
from nonholonomic.mechanics.ball.ball import (
    RollingBall as RollingBall,
)
from nonholonomic.mechanics.constraints.integrability import (
    nonholonomy as nonholonomy,
)
from nonholonomic.mechanics.lagrangian.mechanism import (
    Frame as Frame,
    Mechanism as Mechanism,
    coordinates as coordinates,
)
from nonholonomic.mechanics.lagrangian.poincare_suslov import (
    equations_of_motion as equations_of_motion,
)
from nonholonomic.mechanics.reduction.chaplygin import (
    chaplygin_form as chaplygin_form,
)
from nonholonomic.mechanics.rolling.body import (
    Body as Body,
)
from nonholonomic.mechanics.rolling.cavity import (
    Cavity as Cavity,
)
from nonholonomic.mechanics.rolling.equations import (
    Forces as Forces,
    RollingBody as RollingBody,
    rolling_system as rolling_system,
)
from nonholonomic.mechanics.rolling.initial_state import (
    initial_state as initial_state,
)
from nonholonomic.mechanics.rolling.mechanism import (
    rolling_mechanism as rolling_mechanism,
)
from nonholonomic.mechanics.shapes.implicit import (
    ImplicitShape as ImplicitShape,
)
from nonholonomic.mechanics.shapes.revolution import (
    ShapeOfRevolution as ShapeOfRevolution,
)
from nonholonomic.mechanics.shapes.shapes import (
    Ball as Ball,
    Disk as Disk,
    Ellipsoid as Ellipsoid,
    Torus as Torus,
)
from nonholonomic.mechanics.shapes.surfaces import (
    Plane as Plane,
    Sphere as Sphere,
)
from nonholonomic.mechanics.sympy_models.conversion import (
    from_sympy as from_sympy,
    mechanism_from_sympy as mechanism_from_sympy,
)

from . import (
    experiment as experiment,
    page as page,
    report as report,
    server as server,
)
from ._version import __version__ as __version__
from .experiment.dataset import (
    open_dataset as open_dataset,
    write_dataset as write_dataset,
)
from .experiment.models.experiment import (
    load_experiment as load_experiment,
    parse_experiment as parse_experiment,
)
from .experiment.study import (
    Study as Study,
)

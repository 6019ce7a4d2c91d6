from flowlanes.errors import (
    InputError as InputError,
    RunError as RunError,
)
from flowlanes.flow.ensembles.run import (
    ensemble as ensemble,
)
from flowlanes.flow.integrator import (
    integrate as integrate,
)
from flowlanes.flow.linearisation.linear_stability import (
    linear_stability as linear_stability,
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
from flowlanes.printing.code import (
    source_code as source_code,
)
from flowlanes.system.laws import (
    Integral as Integral,
    Measure as Measure,
    Symmetry as Symmetry,
)
from flowlanes.system.system import (
    Parameter as Parameter,
    System as System,
)
from lawproof.proof.prover import (
    prove as prove,
)
from lawproof.proof.verdict import (
    Verdict as Verdict,
)
from lawproof.search.finder import (
    find_laws as find_laws,
)
from nonholonomic.catalogue import (
    from_catalogue as from_catalogue,
)
from nonholonomic.classification.classifier import (
    classify as classify,
)
from nonholonomic.closed_form.solver import (
    solve as solve,
)
from nonholonomic.invariant_measures.existence import (
    invariant_measure as invariant_measure,
)
from nonholonomic.mechanics.lagrangian.mechanism import (
    Frame as Frame,
    Mechanism as Mechanism,
)
from nonholonomic.mechanics.lagrangian.poincare_suslov import (
    equations_of_motion as equations_of_motion,
)
from nonholonomic.mechanics.rolling.body import (
    Body as Body,
)
from nonholonomic.mechanics.rolling.equations import (
    Forces as Forces,
    RollingBody as RollingBody,
    rolling_system as rolling_system,
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
)
from nonholonomic.starts import (
    initial_state as initial_state,
)

from ._version import (
    __version__ as __version__,
)
from .experiment.dataset import (
    open_dataset as open_dataset,
)
from .experiment.models.experiment import (
    load_experiment as load_experiment,
    parse_experiment as parse_experiment,
)
from .experiment.study import (
    Study as Study,
)

__all__ = [  # noqa: RUF022  (in the order in which they are used)
    # describe
    "Body",
    "Ball",
    "Disk",
    "Ellipsoid",
    "Torus",
    "ShapeOfRevolution",
    "ImplicitShape",
    "Plane",
    "Sphere",
    "Forces",
    # make a system
    "System",
    "Parameter",
    "Mechanism",
    "Frame",
    "RollingBody",
    "rolling_system",
    "equations_of_motion",
    "from_catalogue",
    "from_sympy",
    # move it
    "initial_state",
    "integrate",
    "ensemble",
    "Trajectory",
    "PoincareMap",
    "lyapunov_spectrum",
    "linear_stability",
    # know it
    "Integral",
    "Measure",
    "Symmetry",
    "prove",
    "Verdict",
    "find_laws",
    "invariant_measure",
    "classify",
    "solve",
    # keep it
    "load_experiment",
    "parse_experiment",
    "Study",
    "open_dataset",
    "source_code",
    # errors
    "InputError",
    "RunError",
]

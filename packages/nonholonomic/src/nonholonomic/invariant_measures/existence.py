"""Existence of a smooth measure whose density depends on the configuration alone.

On the distribution of a system with linear constraints, with admissible fields η_β, momenta p_β
and structure functions C projected orthogonally in the kinetic energy, div(e^σ v) = 0 reads

    η_β(σ) = θ_β,      θ_β = −(div η_β + C^s_βs),

so that a density e^σ(q) exists if and only if the functions θ_β are the derivatives of one function
along the admissible fields (Fedorov, García-Naranjo, Marrero, *Unimodularity and preservation of
volumes in nonholonomic mechanics*).  Potentials and gyrostats have no influence.
"""

from __future__ import annotations

from flowlanes.arguments import arguments_checked
from lawproof.proof.fields.budget import EFFORT

from ..mechanics.lagrangian.mechanism import Mechanism
from ..mechanics.rolling.equations import RollingBody
from .mechanisms import decide_mechanism
from .result import MeasureExistence
from .rolling_bodies import decide_body


@arguments_checked
def invariant_measure(
    source: RollingBody | Mechanism, name: str = "", *, effort: int = EFFORT
) -> MeasureExistence:
    """Decide whether an invariant measure exists whose density depends on the configuration alone.

    Parameters
    ----------
    source : RollingBody or Mechanism
        A body that rolls on a plane or a sphere, with its numbers; or a mechanism whose
        constraints are linear and homogeneous in the velocities, and do not depend on the time.
    name : str
        Name in the result; by default that of the mechanism.
    effort : int
        Largest number of term operations of a single proof.

    Returns
    -------
    MeasureExistence

    Raises
    ------
    InputError
        If the source or its constraints are of another kind.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, z, xdot, ydot, zdot = sp.symbols("x y z xdot ydot zdot", real=True)
    >>> lagrangian, constraint = (xdot**2 + ydot**2 + zdot**2) / 2, zdot - y * xdot
    >>> particle = nonholonomic.Mechanism(
    ...     "particle", nonholonomic.coordinates(x, y, z), lagrangian, (constraint,)
    ... )
    >>> print(nonholonomic.invariant_measure(particle))
    particle: has a smooth invariant measure whose density depends on the configuration alone
    density: √(1 + y²)
    """
    if isinstance(source, RollingBody):
        return decide_body(source, name or "rolling-body", effort)
    return decide_mechanism(source, name or source.name, effort)

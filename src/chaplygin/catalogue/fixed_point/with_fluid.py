"""Bodies about a fixed point that hold fluid: the Veselova system, Suslov's problem.

The equations Iω̇ = X + λn of a body about a fixed point become those with fluid (docs/fluid.md) if
I is the inertia of the equivalent body and X gets the terms CN×ω − CṄ.  Densities that depend on γ
alone stay.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ...core.laws import Integral, Law, Measure
from ...core.system import Parameter, System
from ...core.vectors import Diagonal, cross, norm_squared, vectors
from ...errors import InputError
from ...mechanics.rolling.cavity import Cavity
from ...mechanics.rolling.fluid import Fluid, total
from ...parsing.exact_decimals import exact_number
from ..fluid_laws import SOURCE, SQUARE

omega, gamma, X = vectors("omega gamma X")
I = Diagonal("I")


def with_fluid(system: System, cavities: Sequence[Cavity]) -> System:
    """A body about a fixed point with fluid in cavities about that point.

    Parameters
    ----------
    system : System
        State ω, γ and the torque X by definition, such as ``veselova`` and ``suslov``.
    cavities : sequence of Cavity
        Their axes along the body axes, their centre in the fixed point.

    Raises
    ------
    InputError
        If the system is of another kind, or a cavity lies otherwise.

    Examples
    --------
    >>> import chaplygin as ch
    >>> cavity = ch.Cavity((0.5, 0.4, 0.3), mass=2.0)
    >>> with_fluid(ch.from_catalogue("veselova"), [cavity]).state
    (omega, gamma, N)
    """
    filled = [cavity for cavity in cavities if cavity.mass]
    if not filled:
        return system
    symbols = {str(p.symbol) for p in system.parameters}
    fits = X in dict(system.definitions) and system.state == (omega, gamma)
    if not fits or symbols & set(map(str, Diagonal("C").symbols)):
        raise InputError(
            f"cavity: {system.name} cannot hold fluid; a rolling body, veselova and suslov can"
        )
    fluids = _fluids(filled)
    added = cross(total([f.momentum for f in fluids]), omega) - total(
        [f.C * f.rate for f in fluids]
    )
    definitions = [
        (name, value + added if name == X else value) for name, value in system.definitions
    ]
    motion = [pair for fluid in fluids for pair in fluid.motion]
    return replace(
        system,
        title=f"{system.title} with fluid",
        summary=f"{system.summary} It is full of fluid in an ellipsoidal cavity.",
        field=(*system.field, *((fluid.N, fluid.rate) for fluid in fluids)),
        definitions=(*motion, *definitions),
        parameters=(*_equivalent(system, fluids), *(p for f in fluids for p in f.parameters)),
        laws=_laws(system, fluids),
        observables=(*system.observables, *(fluid.observable for fluid in fluids)),
        start=tuple((fluid.N, fluid.initial) for fluid in fluids),
    )


def _fluids(cavities: Sequence[Cavity]) -> list[Fluid]:
    for cavity in cavities:
        if any(cavity.centre):
            raise InputError(
                f"cavity: its centre {cavity.centre} must be the fixed point, [0, 0, 0]"
            )
        if not cavity.solid_inertia.is_diagonal():
            raise InputError("cavity: its axes must be along the body axes; leave out turn")
    several = len(cavities) > 1
    if several:
        raise InputError("cavity: only one has its centre in the fixed point")
    return [Fluid(cavity) for cavity in cavities]


def _equivalent(system: System, fluids: Sequence[Fluid]) -> list[Parameter]:
    """The parameters of the body, its moments those of the equivalent body."""
    added = {
        s: sum(fluid.cavity.equivalent_inertia[i, i] for fluid in fluids)
        for i, s in enumerate(I.symbols)
    }
    return [
        replace(
            p,
            default=float(exact_number(p.default) + added[p.symbol]),
            meaning=p.meaning.replace("moment", "equivalent moment"),
            admissible=(p.symbol > 0,),
        )
        if p.symbol in added
        else p
        for p in system.parameters
    ]


def _laws(system: System, fluids: Sequence[Fluid]) -> tuple[Law, ...]:
    laws: list[Law] = []
    for law in system.laws:
        if law.name == "energy" and isinstance(law, Integral):
            value = law.value + sum(fluid.energy for fluid in fluids)
            laws += [replace(law, value=value), *(fluid.circulation for fluid in fluids)]
        elif isinstance(law, Measure) and not system.expand(law.value).has(*omega.symbols):
            laws.append(law)
        elif law.name == "momentum" and law.source == "(6.4)" and isinstance(law, Integral):
            momentum = I * omega + total([fluid.momentum for fluid in fluids])
            value, meaning = norm_squared(cross(momentum, gamma)), law.meaning
            laws.append(Integral("momentum", value, meaning, source=SOURCE, unit=SQUARE))
    return tuple(laws)

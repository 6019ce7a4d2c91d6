"""A body on a support, with the laws of friction between them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeVar

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces
from ...mechanics.shapes.surfaces import Plane, Surface
from ..friction.compatible_laws import require_compatible
from ..friction.friction_law import FrictionLaw

Law = TypeVar("Law", bound=FrictionLaw)


@arguments_checked
@dataclass(frozen=True)
class FrictionalContact:
    """A body on a support that it touches with friction, and may leave.

    Parameters
    ----------
    body : Body
    surface : Plane or Sphere
        The support, at rest or turning about the z axis.
    laws : sequence of FrictionLaw
        The laws of friction, which add up; none for a smooth contact.
    field : Forces
        Gravity; on a plane also a potential U(γ).

    Raises
    ------
    InputError
        If two laws exclude each other, a patch is larger than the body, or there is a potential on
        a sphere.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.contact.friction.dry_friction import Coulomb
    >>> from nonholonomic.contact.equations.situation import FrictionalContact
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0))
    >>> billiard = FrictionalContact(
    ...     ball, laws=(Coulomb(0.2),), field=nonholonomic.Forces(gravity=9.81)
    ... )
    >>> billiard.setting
    'dry friction, μ = 0.2'
    """

    body: Body
    surface: Surface = Plane()  # noqa: RUF009  (immutable)
    laws: tuple[FrictionLaw, ...] = ()
    field: Forces = Forces()  # noqa: RUF009  (immutable)

    def __post_init__(self) -> None:
        object.__setattr__(self, "laws", tuple(self.laws))
        require_compatible(self.laws)
        if self.body.fluids:
            raise InputError(
                "cavity: a body with fluid inside rolls by a marble or rubber contact alone; with "
                "friction there may be none"
            )
        patch = max((law.patch_radius for law in self.laws), default=0.0)
        if patch and patch > (size := self.body.shape.half_breadth):
            raise InputError(
                f"patch = {patch:g} m: a patch of contact lies within the body, so that its "
                f"radius is at most {size:g} m, half the largest breadth of the body"
            )
        if not self.surface.is_even:
            raise InputError(
                f"surface: a body touches a plane or a sphere with friction, not "
                f"{self.surface.words}; on that it rolls by a marble or rubber contact"
            )
        if self.field.potential != 0 and not self.surface.is_flat:
            raise InputError(
                "potential: with friction on a sphere there may be none, as it would act on the "
                "sliding body by a force too"
            )

    @property
    def setting(self) -> str:
        """A description of the friction laws."""
        return "; ".join(law.description for law in self.laws) or "no friction"

    @arguments_checked
    def law(self, kind: type[Law]) -> Law | None:
        """The law of this kind, or None."""
        return next((law for law in self.laws if isinstance(law, kind)), None)

    @property
    def never_slips(self) -> bool:
        """Whether dry friction is unlimited."""
        return any(law.static_mu == math.inf for law in self.laws)

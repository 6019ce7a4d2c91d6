"""Gauss–Legendre collocation as an integration method; what it needs is imported when it runs."""

from __future__ import annotations

from .integration_method import IntegrationMethod, MotionRequest
from .trajectory import Trajectory


class Collocation(IntegrationMethod):
    """Gauss–Legendre collocation to the last digit; it has no options of its own."""

    name = "gauss"

    def motion(self, request: MotionRequest) -> Trajectory:
        """The motion with 16 digits, or 30 at precision "quad"."""
        from .gauss_trajectory import collocate

        return collocate(
            request.system,
            request.start,
            request.times,
            request.parameters,
            precision=request.precision,
            on_liftoff=request.on_liftoff,
        )

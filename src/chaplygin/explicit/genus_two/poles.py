"""Products of differences of the poles of a separation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

__all__ = ["gaps"]


def gaps(poles: Sequence[Any]) -> tuple[Any, Any, Any]:
    """Πᵢ = ∏_{j≠i}(eᵢ − eⱼ) of three numbers eᵢ."""
    e, f, g = poles
    return (e - f) * (e - g), (f - e) * (f - g), (g - e) * (g - f)

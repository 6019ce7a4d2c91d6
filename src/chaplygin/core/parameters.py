"""Values of parameters."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

__all__ = ["Parameters"]

#: Values by symbol or name: numbers, or arrays with one for each motion.
Parameters: TypeAlias = Mapping[Any, Any]

"""The paper, claim by claim: modules ``section_*`` in reading order.

Each offers ``CLAIMS`` (what a computation decides) and ``REMARKS`` (what was not computed).
"""

from __future__ import annotations

import pkgutil
from importlib import import_module

from .claim import Case, Claim, Remark

__all__ = ["Case", "Claim", "Remark", "claims", "remarks"]


def _sections(number: int | None) -> list[str]:
    names = sorted(m.name for m in pkgutil.iter_modules(__path__) if m.name.startswith("section_"))
    wanted = "section_" if number is None else f"section_{number:02d}_"
    return [name for name in names if name.startswith(wanted)]


def claims(section: int | None = None) -> tuple[Claim, ...]:
    """The claims of one section, or of the whole paper, in reading order."""
    return tuple(
        claim for name in _sections(section) for claim in import_module(f".{name}", __name__).CLAIMS
    )


def remarks(section: int | None = None) -> tuple[Remark, ...]:
    """What was not computed, in reading order."""
    return tuple(
        remark
        for name in _sections(section)
        for remark in getattr(import_module(f".{name}", __name__), "REMARKS", ())
    )

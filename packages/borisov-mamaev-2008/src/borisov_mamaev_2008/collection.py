"""The claims and remarks of all modules ``section_*``, in the order of the paper."""

from __future__ import annotations

import pkgutil
from importlib import import_module
from pathlib import Path

from flowlanes.arguments import arguments_checked

from .claim import Claim, Remark


def _modules() -> dict[str, int]:
    """Modules of claims in reading order, each with its section of the paper."""
    folders = pkgutil.walk_packages([str(Path(__file__).parent)], f"{__package__}.")
    names = sorted(m.name for m in folders if not m.ispkg and ".section_" in m.name)
    return {name: int(name.split(".section_")[1][:2]) for name in names}


@arguments_checked
def claims(section: int | None = None) -> tuple[tuple[int, Claim], ...]:
    """The claims of one section, or of the whole paper, in reading order, with their section.

    Parameters
    ----------
    section : int, optional
        Number of a section; None for the whole paper.

    Returns
    -------
    tuple of (int, Claim)
        Section and claim.

    Raises
    ------
    InputError
        If there is no such section.

    Examples
    --------
    >>> import borisov_mamaev_2008
    >>> len(borisov_mamaev_2008.claims(6)) > 10
    True
    """
    return tuple(
        (number, claim)
        for name, number in _modules().items()
        if section in (None, number)
        for claim in import_module(name).CLAIMS
    )


@arguments_checked
def remarks(section: int | None = None) -> tuple[Remark, ...]:
    """The statements that were not computed, in reading order.

    Parameters
    ----------
    section : int, optional
        Number of a section; None for the whole paper.

    Returns
    -------
    tuple of Remark

    Raises
    ------
    InputError
        If there is no such section.

    Examples
    --------
    >>> import borisov_mamaev_2008
    >>> all(remark.statement for remark in borisov_mamaev_2008.remarks(6))
    True
    """
    return tuple(
        remark
        for name, number in _modules().items()
        if section in (None, number)
        for remark in getattr(import_module(name), "REMARKS", ())
    )

"""The section of a page on friction: laws, events, energy."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import xarray as xr

from flowlanes.printing.numerals import number, typographic_signs, unit
from nonholonomic.contact.friction.friction_law import FrictionLaw
from nonholonomic.contact.simulation.event_rules import EventRules

from ..experiment.contact.trajectory import ContactTrajectory
from ..experiment.subjects.contact_subject import ContactSubject
from .drawing.contact_values import FrictionLimits, event_impulses, friction_limits
from .drawing.modes import changes_mode
from .figures.contact_time import energy_parts

#: Number of events in the table of the page; the dataset has all of them.
MOST_EVENTS = 24


@dataclass(frozen=True)
class LawRow:
    """A law of friction, and its coefficients."""

    words: str
    coefficients: str


@dataclass(frozen=True)
class EventRow:
    """An event of the table."""

    time: str
    kind: str
    mode: str
    normal: str
    tangential: str
    couple: str


@dataclass(frozen=True)
class EnergyRow:
    """A form of energy at the start and at the end (J)."""

    words: str
    start: str
    end: str


@dataclass(frozen=True)
class ContactSection:
    """The texts of a page on a contact with friction.

    Attributes
    ----------
    laws : list of LawRow
    impacts : str
        Description of impacts; empty if there are none.
    summary : str
        Numbers of events by kind.
    events : list of EventRow
    more : int
        Number of events that are not among the rows.
    has_impulse, has_couple : bool
        Whether any of the rows has an impulse, and one of the couple.
    energy : list of EnergyRow
        The last one is the total.
    drift : str
        Largest change of the total energy, relative to the energies involved.
    reason : str
        Reason of an early end; empty if the motion is complete.
    """

    laws: list[LawRow]
    impacts: str
    summary: str
    events: list[EventRow]
    more: int
    has_impulse: bool
    has_couple: bool
    energy: list[EnergyRow]
    drift: str
    reason: str


def contact_section(
    subject: ContactSubject, trajectory: ContactTrajectory, dataset: xr.Dataset
) -> ContactSection:
    """The section for a motion with friction.

    Parameters
    ----------
    subject : ContactSubject
    trajectory : ContactTrajectory
    dataset : xarray.Dataset
        The same motion as a dataset.
    """
    rows = _event_rows(trajectory, dataset)
    parts = energy_parts(dataset, subject.contact.body)
    total = np.sum([part.values for part in parts], axis=0)
    return ContactSection(
        laws=[law_row(law) for law in subject.contact.laws],
        impacts=_impacts(trajectory),
        summary=_summary(trajectory),
        events=rows,
        more=len(trajectory.changes) - len(rows),
        has_impulse=any(row.normal for row in rows),
        has_couple=any(row.couple for row in rows),
        energy=[
            *(EnergyRow(p.words, _energy(p.values[0]), _energy(p.values[-1])) for p in parts),
            EnergyRow("together", _energy(total[0]), _energy(total[-1])),
        ],
        drift=number(trajectory.drift, 2),
        reason=typographic_signs(trajectory.reason),
    )


def contact_plates(
    subject: ContactSubject, trajectory: ContactTrajectory, dataset: xr.Dataset
) -> dict[str, tuple[str, str]]:
    """The figures of the page, in order, with heading and caption."""
    limits, surface = friction_limits(subject.contact), subject.contact.surface
    collides = any(np.any(event.impulse != 0.0) for event in trajectory.changes)
    turned = (
        ""
        if surface.is_flat
        else " The axes x and y of space are turned into the tangent plane by the shortest way."
    )
    # The laws that act against the slip.
    alone = all(law.has_constant_force or not law.resists_slip for law in subject.contact.laws)
    given = " What the moving support gives is below zero." if surface.turntable else ""
    jumps = " Broken lines are jumps in impacts." if collides else ""
    return {
        "slip_and_spin": (
            "Slip and spin",
            "Speed of the contact point over the support, and angular velocity about the normal; "
            "in flight, of the body's point nearest to the support. The bar has the modes of the "
            "contact and its events.",
        ),
        "slip_hodograph": (
            "Hodograph of the slip",
            "The curve of the slip velocity in the tangent plane, coloured by mode; the ring marks "
            f"the start, the dot the end.{jumps}{turned}",
        ),
        "friction_cone": ("Friction and its limit", _cone(limits, collides, alone) + turned),
        "friction_share": ("Friction over its limit", _share(limits, alone)),
        "normal_force": (
            "Normal force",
            "Zero in flight. The forces of impacts, which last for an instant, are not shown."
            if collides
            else "The pressure of the support on the body, zero in flight.",
        ),
        "contact_path": (
            "Path of the contact point",
            "On the support, coloured by mode; the large ring marks the start, the dot the end, "
            "small rings the events."
            if changes_mode(dataset)
            else "On the support, coloured by time; the ring marks the start, the dot the end.",
        ),
        "energy_stack": (
            "",
            "Kinetic and potential energy and the work lost (striped), each on top of the one "
            f"before. Their sum, the line named total, stays constant.{given}",
        ),
        "drift": ("", "Change of the energy with all work lost, relative to its initial value."),
    }


def _cone(limits: FrictionLimits, collides: bool, alone: bool) -> str:
    """The caption of the figure of friction relative to its limit."""
    if limits.mu is None:
        words = "The friction force over the normal force, seen from above and coloured by mode."
    else:
        words = (
            "The cone of friction seen from above: the force over μN, coloured by mode. The "
            "circle is the limit of what dry friction holds without slip"
        )
        words += "; sliding lies on it." if alone else "."
        if limits.coupled:
            words = (
                "Left, the force over μN, seen from above and coloured by mode; no friction leaves "
                "the circle. Right, force over μN and couple over μNa with their common limit: "
                "what slides or spins lies on the curve, what is held within."
            )
        elif limits.arm:
            words += (
                " Right, force and couple over their limits, which do not depend on each other."
            )
    if collides:
        words += " Diamonds are the impulses of impacts, tangential over normal, in the same unit."
    return words


def _share(limits: FrictionLimits, alone: bool) -> str:
    if limits.mu is None:
        return "The friction force over the normal force, at each instant of contact."
    if limits.coupled:
        return (
            "The force over μN and the couple over μNa. Under the law of a patch neither reaches "
            "one while the contact both slides and spins."
        )
    words = "One is the limit of what dry friction holds: reached where sliding begins"
    return f"{words}, and as long as the contact slides." if alone else f"{words}."


def law_row(law: FrictionLaw) -> LawRow:
    """A description of a friction law, with its coefficients."""
    words = law.summary
    if law.static_mu == math.inf:
        words = "Dry friction without limit: the contact never slips."
    coefficients = [
        f"{p.meaning or p.symbol} {number(float(p.default), 6)} {_unit(p.unit)}".strip()
        for p in law.parameters
    ]
    return LawRow(words, "; ".join(coefficients))


def _unit(text: str) -> str:
    """A unit in print notation; that of a fractional power in words."""
    if "^" in text and "." in text:
        return text.replace("^", " to the power ")
    return "" if text in ("1", "unknown") else unit(text)


def _impacts(trajectory: ContactTrajectory) -> str:
    if not any(event.kind == "landing" for event in trajectory.changes):
        return ""
    rules: EventRules = trajectory.rules
    e = number(rules.restitution, 6)
    if not rules.restitution:
        return "The body does not bounce: impacts end when their compression does."
    words = {
        "stronge": f"In restitution the normal force gives back {number(rules.restitution**2, 6)} "
        "of the work that it took in compression",
        "poisson": f"The impulse of restitution is {e} times that of compression",
        "newton": f"The normal velocity after an impact is {e} times that before it",
    }[rules.impact_law]
    return f"{words} (restitution {e}, {rules.impact_law.capitalize()}'s law)."


def _summary(trajectory: ContactTrajectory) -> str:
    count = len(trajectory.changes)
    if not count:
        return "The contact does not change during this motion."
    if count == 1:
        (event,) = trajectory.changes
        return f"One event, at t = {number(event.time, 9)} s: {event.kind}, then {event.mode}."
    kinds = ", ".join(f"{many} × {kind}" for kind, many in trajectory.kinds.items())
    return f"{count} events: {kinds}."


def _event_rows(trajectory: ContactTrajectory, dataset: xr.Dataset) -> list[EventRow]:
    """The first events; impulses by their components along and across the normal."""
    normal, across = event_impulses(dataset)
    rows = []
    for place, event in enumerate(trajectory.changes[:MOST_EVENTS]):
        struck = bool(np.any(event.impulse != 0.0))
        mode = event.mode if event.unique else f"{event.mode} (another motion is possible)"
        rows.append(
            EventRow(
                time=f"{event.time:.9f}".rstrip("0").rstrip("."),
                kind=event.kind,
                mode=mode,
                normal=number(normal[place], 5) if struck else "",
                tangential=number(float(np.linalg.norm(across[place])), 5) if struck else "",
                couple=number(event.couple_impulse, 5) if event.couple_impulse else "",
            )
        )
    return rows


def _energy(value: float) -> str:
    return number(float(value), 6)

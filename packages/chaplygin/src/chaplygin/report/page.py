"""The report of a study as one HTML page that needs no network."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import jinja2
import xarray as xr
from markupsafe import Markup

from flowlanes.errors import RunError
from flowlanes.flow.trajectory import Trajectory
from flowlanes.printing.equations import equations_html
from flowlanes.printing.formula import latex, text
from flowlanes.printing.mathml import mathml
from flowlanes.printing.numerals import number, typographic_signs, unit
from flowlanes.printing.system import claims_html, motion_html, system_html
from flowlanes.system.laws import Law
from flowlanes.system.vectors import Vector, real_symbol
from lawproof.proof.fields.budget import EFFORT
from lawproof.proof.verdict import Verdict
from nonholonomic.classification.classification import Classification, rows
from nonholonomic.classification.classifier import classify_laws
from nonholonomic.classification.facts import ProofBudget

from .._version import __version__
from ..experiment.contact.trajectory import ContactTrajectory
from ..experiment.study import Study
from ..experiment.subjects.contact_subject import ContactSubject
from ..page.element import element
from ..page.study_page import study_model
from .illustrations import Illustrations
from .summary import drift_text

#: Term operations allowed for the proof of one law by default, and the ratio of the total budget to
#: it.
EFFORT_PER_PROOF = EFFORT // 20
TIMES = 4

#: Figures whose colours are fixed: shading, and the colours of time.
PICTURES = ("scene", "plan_view", "contact_path", "normal_on_sphere", "bifurcation")

#: Figures in the order of the page, with heading and caption.
PLATES = {
    "plan_view": (
        "Path in the plane",
        "To scale, coloured by time; the ring marks the start. The mechanism is drawn at several "
        "instants, darkest at the end.",
    ),
    "contact_path": (
        "Path of the contact point",
        "On the surface, coloured by time; the ring marks the start, the dot the end.",
    ),
    "state": ("The state", "The variables of the state against time."),
    "recorded": (
        "Other recorded quantities",
        "Multipliers of the constraints and other quantities against time.",
    ),
    "normal_on_sphere": (
        "The unit vector γ on the sphere",
        "In body axes: the normal of the supporting surface at the contact.",
    ),
    "attitude": (
        "Attitude",
        "Three angles of the body axes relative to space, continued beyond full turns.",
    ),
    "angular_velocity": ("Angular velocity ω", "Components along the body axes."),
    "normal_force": (
        "Normal force",
        "Where it falls below zero, a body held by nothing but the surface would lift off.",
    ),
    "friction_ratio": (
        "Friction over normal force",
        "The coefficient of friction that rolling needs: where it is larger than that of the "
        "materials, a real body would slip.",
    ),
    "drift": (
        "Drift of the first integrals",
        "Deviation of each from its initial value, relative to that value.",
    ),
}


def render(
    study: Study,
    trajectory: Trajectory,
    dataset: xr.Dataset,
    illustrations: Callable[[], Illustrations],
    budget: ProofBudget,
    failure: RunError | None = None,
) -> str:
    """Render the page as text.

    Parameters
    ----------
    study : Study
    trajectory : Trajectory
        The computed trajectory.
    dataset : xarray.Dataset
        The same trajectory as a dataset.
    illustrations : callable
        Returns the figures and the closed form; it is called last.
    budget : ProofBudget
        Budget for the proofs of its laws and for its classification.
    failure : RunError, optional
        The error of a run that ended early.

    Returns
    -------
    str
        HTML with formulas in MathML and figures as inline SVG.
    """
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("chaplygin.report", "templates"),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )
    system = trajectory.system
    subject, contact, plates = study.subject, None, PLATES
    verdicts: dict[str, Verdict] = {}
    places: list[dict[str, object]] = []
    uncounted: tuple[tuple[str, tuple[str, ...]], ...] = ()
    # Laws of a single contact mode do not apply to a motion through several.
    if isinstance(subject, ContactSubject) and isinstance(trajectory, ContactTrajectory):
        from .contact_section import contact_plates, contact_section

        contact = contact_section(subject, trajectory, dataset)
        mine = contact_plates(subject, trajectory, dataset)
        plates = mine | {name: plate for name, plate in PLATES.items() if name not in mine}
    else:
        verdicts = budget.verdicts(study.system)
        stands = classify_laws(study.system, verdicts, budget, subject.model)
        places = [_section(part) for part in (stands, *stands.levels)]
        uncounted = stands.uncounted_by_reason
    live = study_model(study, dataset, verdicts, lambda: illustrations().diagram)
    shown = illustrations()
    drawn = {
        name: _figure_html("picture" if _is_picture(name, study, dataset) else "chart", *svgs)
        for name, svgs in shown.pairs.items()
    }
    lab = element(live, drawn.get("scene", ""))
    return environment.get_template("report.html").render(
        signed=typographic_signs,
        title=study.system.title,
        lead=study.subject.summary or study.subject.setting,
        setting=study.subject.setting if study.subject.summary else "",
        start=_start(study, dataset),
        letters=Markup(shown.letters),
        lab=lab.html,
        policy=lab.policy,
        scene=drawn.get("scene"),
        plates=[
            {
                "name": name,
                "heading": heading,
                "caption": f"{_caption(study, name, caption)} {_remark(study, name)}",
                "svg": drawn[name],
            }
            for name, (heading, caption) in plates.items()
            if name in drawn
        ],
        contact=contact,
        still=bool(system.integrals) and "drift" not in drawn,
        energy_changes="energy" in dataset and not system.integrals,
        equations=Markup(system_html(replace(study.system, laws=()))),
        legend=_legend(study.subject.legend),
        reconstruction=Markup(
            motion_html(study.system) if study.subject.has_own_reconstruction else ""
        ),
        notes=study.subject.derivation_notes,
        laws=[
            {
                "name": law.name,
                "meaning": law.meaning,
                "formula": Markup(equations_html([("", law.value)])),
                "source": law.source,
                "verdict": verdicts[law.name],
                "value": _value_text(float(trajectory.records[f"law_{law.name}"][0])),
                "unit": unit(law.unit),
                "drift": drift_text(trajectory, law.name),
            }
            for law in (() if contact else system.integrals)
        ],
        closed=shown.closed,
        closed_figure=drawn.get("closed_form"),
        diagram=drawn.get("bifurcation"),
        claims=Markup(claims_html(replace(study.system, laws=_unobserved_laws(study)))),
        proofs=[
            (law.name, _law_text(law), law.source, verdicts[law.name])
            for law in _unobserved_laws(study)
        ],
        places=places,
        uncounted=uncounted,
        linked={law.name for law in study.system.laws},
        undecided=[
            (name, typographic_signs(verdict.reason))
            for name, verdict in verdicts.items()
            if verdict.reason and not verdict.is_untried
        ],
        events=[] if contact else [typographic_signs(str(e)) for e in trajectory.events],
        warnings=[typographic_signs(warning) for warning in trajectory.warnings],
        remarks=[typographic_signs(remark) for remark in study.remarks],
        failure=typographic_signs(str(failure)) if failure else None,
        facts=_facts(study, trajectory),
        experiment=dataset.attrs["experiment"],
        versions=dataset.attrs["versions"],
        version=__version__,
    )


def _is_picture(name: str, study: Study, dataset: xr.Dataset) -> bool:
    """Whether the colours of a figure are fixed."""
    subject = study.subject
    flat = isinstance(subject, ContactSubject) and subject.surface.is_flat
    if name == "contact_path" and flat:
        from .drawing.modes import changes_mode

        # A path on a plane in the colours of modes has no shading.
        return not changes_mode(dataset)
    return name in PICTURES


def _figure_html(kind: str, wide: str, narrow: str) -> Markup:
    """A figure for wide and for narrow screens."""
    return Markup(
        f'<div class="{kind} on-wide">{wide}</div><div class="{kind} on-narrow">{narrow}</div>'
    )


def _start(study: Study, dataset: xr.Dataset) -> list[dict[str, object]]:
    """The start as given, by name: letter, value, unit and meaning."""
    rows: list[dict[str, object]] = []
    for name, value in study.start_values.items():
        listed = value if isinstance(value, (tuple, list)) else (value,)
        numbers = [x for row in listed for x in (row if isinstance(row, tuple | list) else (row,))]
        letter = Vector(name, len(numbers)) if len(numbers) > 1 else real_symbol(name)
        known = dataset[name].attrs if name in dataset else {}
        words_of = {**study.subject.start_words, **study.variables}
        meaning, units = words_of.get(name, ("", ""))
        units = units or str(known.get("units", ""))
        words = meaning or str(known.get("long_name", ""))
        shown = ", ".join(number(float(x), 9) for x in numbers)
        rows.append(
            {
                "symbol": Markup(mathml(latex(letter))),
                "value": f"({shown})" if len(numbers) > 1 else shown,
                "unit": "" if units in ("1", "unknown") else unit(units),
                "meaning": "" if words in (name, text(letter)) else words,
            }
        )
    return rows


def _value_text(value: float) -> str:
    return "–" if math.isnan(value) else number(value, 12)


def _legend(words: str) -> dict[str, object]:
    """The meaning of the letters, one per line if there are several."""
    head, colon, listed = words.partition(": ")
    letters = listed.removesuffix(".").split("; ")
    if len(letters) < 3:
        return {"words": words, "letters": []} if words else {}
    return {"words": head + colon, "letters": letters}


def _section(part: Classification) -> dict[str, object]:
    """A classification as shown on the page."""
    return {"level": part.level, "rows": [row for row in rows(part) if row[1]]}


def _law_text(law: Law) -> str:
    """Kind and meaning of a law."""
    kind, meaning = law.heading, str(getattr(law, "meaning", ""))
    if meaning.casefold().startswith(kind.casefold()):
        return kind + meaning[len(kind) :]
    return f"{kind}: {meaning}" if meaning else kind


def _unobserved_laws(study: Study) -> tuple[Law, ...]:
    """The laws that are not integrals observed along this motion."""
    return tuple(law for law in study.system.laws if law not in study.system_on_level.laws)


def _caption(study: Study, name: str, caption: str) -> str:
    """The caption of a figure; without a surface γ is a different vector."""
    if name == "normal_on_sphere" and not study.subject.gamma_is_normal:
        return "In body axes: the components of a unit vector fixed in space."
    return caption


def _remark(study: Study, name: str) -> str:
    """A remark on a figure that this study needs."""
    if name == "drift" and study.experiment.run.precision == "double":
        return "The unit roundoff of double precision is 1.1 × 10⁻¹⁶."
    if name == "normal_force" and study.subject.two_sided:
        return "Without gravity the contact is taken as two-sided, and the sign is not monitored."
    return ""


def _facts(study: Study, trajectory: Trajectory) -> list[tuple[str, str]]:
    run, statistics = study.experiment.run, trajectory.statistics
    first, last = float(trajectory.times[0]), float(trajectory.times[-1])
    corrections = statistics.corrections
    plural = "" if corrections == 1 else "s"
    facts = [
        ("time", f"{first:g} … {last:.10g} s, {len(trajectory.times)} samples"),
        ("method", statistics.integrator),
        ("tolerance", f"{number(statistics.tolerance, 3)}, {run.precision} precision"),
        ("corrections", f"{corrections} projection{plural} onto the phase space"),
        ("integrals", "enforced by projection" if run.keep_integrals else "free, as a check"),
    ]
    # With friction, projections belong to the events.
    return facts[:-2] if study.subject.changes_equations else facts

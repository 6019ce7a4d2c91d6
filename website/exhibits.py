"""What the gallery shows of a system: everything is asked of the program, nothing written here.

An exhibit is computed once for each text of the program, and kept in a folder until that changes.
"""

from __future__ import annotations

import base64
import contextlib
import gzip
import io
import json
import os
from collections.abc import Callable, Collection, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, replace
from multiprocessing import get_context
from pathlib import Path

ROOT = Path(__file__).parents[1]

#: Figures that show the most of a motion, the best first.
BEST = ("scene", "plan_view", "normal_on_sphere", "state", "attitude", "angular_velocity")


@dataclass(frozen=True)
class Exhibit:
    """A system or an example, as the gallery shows it.

    Attributes
    ----------
    name, what : str
        Its address in the gallery, and what names it on the command line.
    title, summary, setting, source : str
    contact, surface : str
        In a word.
    classes : tuple of str
        Its classes in the hierarchy, in a few words each; `known` what else is proven of it.
    equations : str
        HTML.
    laws : tuple of (name, verdict, HTML)
    place : tuple of (level, rows), rows of (heading, sentences)
    closed_form : str
        What is known of one.
    experiment : str
        Text of the experiment file.
    picture : str
        What the picture shows.
    """

    name: str
    what: str
    title: str
    summary: str
    setting: str
    source: str
    contact: str
    surface: str
    classes: tuple[str, ...]
    known: tuple[str, ...]
    equations: str
    laws: tuple[tuple[str, str, str], ...]
    place: tuple[tuple[str, tuple[tuple[str, tuple[str, ...]], ...]], ...]
    closed_form: str
    experiment: str
    picture: str


def exhibits(
    store: Path,
    most: int | None,
    needed: Collection[str] = (),
    report: Callable[[str], object] = print,
) -> Iterator[Exhibit]:
    """All exhibits: the systems of the catalogue, then the examples that are experiments.

    Parameters
    ----------
    store : Path
        Folder for a JSON file, a picture and a model for each.
    most : int, optional
        How many at most, spread over the whole.
    needed : collection of str
        Names of exhibits that there must be besides.
    report : callable
        Is told what is computed.
    """
    subjects = list(sources())
    sample = {name for name, _ in subjects[:: -(-len(subjects) // (most or len(subjects)))]}
    subjects = [(name, what) for name, what in subjects if name in sample | {*needed}]
    missing = [s for s in subjects if not (store / f"{s[0]}.json").exists()]
    store.mkdir(parents=True, exist_ok=True)
    with ProcessPoolExecutor(os.cpu_count() or 1, mp_context=get_context("spawn")) as pool:
        tasks = {name: pool.submit(compute, name, what, store) for name, what in missing}
        for name, task in tasks.items():
            task.result()
            report(f"gallery: {name}")
    for name, _ in subjects:
        record = json.loads((store / f"{name}.json").read_text(encoding="utf-8"))
        if record is not None:
            yield Exhibit(**record)


def sources() -> Iterator[tuple[str, str]]:
    """Names in the gallery, and what they are called on the command line."""
    from nonholonomic.catalogue import CATALOGUE

    for name in CATALOGUE:
        yield name, name
    for path in sorted((ROOT / "examples").rglob("*")):
        if path.suffix == ".toml" or (path.suffix == ".py" and defines_system(path)):
            inside = path.relative_to(ROOT / "examples").with_suffix("").as_posix()
            yield f"example-{inside.replace('/', '-')}", path.relative_to(ROOT).as_posix()


def defines_system(path: Path) -> bool:
    """Whether a Python file is one that the command line takes."""
    starts = ("system = ", "mechanism = ", "study = ")
    return any(line.startswith(starts) for line in path.read_text(encoding="utf-8").splitlines())


def compute(name: str, what: str, store: Path) -> None:
    """Study a system, and keep what is shown of it."""
    from chaplygin.cli.terminal.options import study_of
    from chaplygin.experiment.study import dataset_of
    from chaplygin.experiment.subjects.plan import plan_motion
    from chaplygin.page.study_page import study_model
    from chaplygin.report.page import EFFORT_PER_PROOF, TIMES
    from chaplygin.report.subject_figures import subject_figures
    from flowlanes.errors import RunError
    from flowlanes.printing.system import law_html, system_html
    from nonholonomic.classification.classifier import classify_laws
    from nonholonomic.classification.facts import ProofBudget

    os.chdir(ROOT)
    with contextlib.redirect_stderr(io.StringIO()):
        study = study_of(what, None)
    subject, system = study.subject, study.system
    try:
        trajectory, complete = study.trajectory(), True
    except RunError as error:
        if error.partial is None:
            raise
        trajectory, complete = error.partial, False
    dataset = dataset_of(study, trajectory, complete)
    verdicts, places = {}, ()
    if not subject.changes_equations:
        budget = ProofBudget(EFFORT_PER_PROOF, TIMES * EFFORT_PER_PROOF)
        verdicts = budget.verdicts(system)
        stands = classify_laws(system, verdicts, budget, subject.model)
        places = (stands, *stands.levels)
    closed, sentence = (False, "") if subject.changes_equations else closed_form(study)
    pictures = subject_figures(
        subject, dataset, None if subject.plan is None else plan_motion(subject.plan, trajectory)
    )
    best = next(kind for kind in BEST if kind in pictures)
    draw(pictures[best], store / f"{name}.png")
    model = study_model(study, dataset, verdicts)
    text = json.dumps(model, allow_nan=False)
    packed = base64.b64encode(gzip.compress(text.encode(), 9, mtime=0)).decode()
    (store / f"{name}.txt").write_text(packed, encoding="ascii")
    exhibit = Exhibit(
        name=name,
        what=what,
        title=system.title,
        summary=subject.summary,
        setting=subject.setting,
        source=system.source,
        contact=contact_of(study, name),
        surface=surface_of(study),
        classes=tuple(dict.fromkeys(c for place in places[:1] for c in classes(place))),
        known=(*known(places), *(("closed form",) if closed else ())),
        equations=system_html(replace(system, laws=(), summary="", source="")),
        laws=tuple(
            (
                law.name,
                verdicts[law.name].statement if verdicts else "",
                law_html(law, system),
            )
            for law in system.laws
        ),
        place=tuple((place.level, table(place)) for place in places),
        closed_form=sentence,
        experiment=study.complete_toml(),
        picture=best.replace("_", " "),
    )
    (store / f"{name}.json").write_text(json.dumps(asdict(exhibit)), encoding="utf-8")


def draw(figure: object, path: Path) -> None:
    """A figure for a card."""
    from matplotlib.figure import Figure

    assert isinstance(figure, Figure)
    width, _ = figure.get_size_inches()
    figure.savefig(path, dpi=640 / width, facecolor="white", metadata={"Software": None})


def closed_form(study: object) -> tuple[bool, str]:
    """Whether a closed form of the motion is known, and what is known in a sentence."""
    from chaplygin.experiment.closed_form import solution_of_study
    from flowlanes.errors import InputError, RunError

    try:
        form = solution_of_study(study).form
    except (InputError, RunError, ArithmeticError) as problem:
        sentence = str(problem)
        return False, f"{sentence[:1].upper()}{sentence[1:]}."
    return True, f"{form.title}: {form.motion}."


def contact_of(study: object, name: str) -> str:
    """Its contact in a word."""
    from chaplygin.experiment.subjects.subject import BallSubject
    from nonholonomic.catalogue.groups import GROUPS

    subject = study.subject
    if subject.changes_equations:
        return "friction"
    if study.rolling is not None:
        return study.rolling.contact
    if isinstance(subject, BallSubject):
        return "marble"
    return next((group.contact for group in GROUPS if name in group.names), "none")


def surface_of(study: object) -> str:
    """What it rolls on, in a word or two."""
    held = [
        study.rolling,
        getattr(study.subject, "ball", None),
        getattr(study.subject, "contact", None),
    ]
    surface = next((x.surface for x in held if hasattr(x, "surface")), None)
    if surface is None:
        return "none"
    word = type(surface).__name__.removesuffix("Surface")
    return {"Flat": "Plane", "Spherical": "Sphere", "Implicit": "Any surface"}.get(
        word, "".join(f" {c.lower()}" if c.isupper() and i else c for i, c in enumerate(word))
    ).lower()


def classes(place: object) -> Iterator[str]:
    """The classes of a place, without what they rest on."""
    for kind in place.kinds:
        yield kind.text.partition(":")[0].partition(",")[0]


def known(places: Sequence[object]) -> Iterator[str]:
    """What is proven of a system, in a few words each."""
    for place in places[:1]:
        if place.count:
            yield f"{place.count} integral{'s' if place.count > 1 else ''}"
        if place.measures:
            yield "invariant measure"
        if place.absence:
            yield "no measure of the configuration"
        if place.brackets:
            yield "Hamiltonian form"


def table(place: object) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Headings and statements of a place, each with the facts that it rests on."""
    from flowlanes.printing.numerals import typographic_signs
    from nonholonomic.classification.classification import rows

    def sentence(statement: object) -> str:
        facts = "; ".join(str(fact) for fact in statement.by)
        return typographic_signs(f"{statement.text} [{facts}]" if facts else statement.text)

    return tuple((name, tuple(map(sentence, listed))) for name, listed in rows(place) if listed)

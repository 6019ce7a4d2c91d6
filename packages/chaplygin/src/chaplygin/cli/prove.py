"""``chaplygin prove``: the laws of a system, each with its verdict."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import typer

from ..interruption import EXIT_CODE, print_interruption, results_on_interrupt
from .terminal.options import NO_LAWS, console, inform, operations, print_json, study_of
from .terminal.output_destination import beside, check_output, name_of, output_file
from .terminal.progress import progress

if TYPE_CHECKING:
    from flowlanes.system.laws import Law
    from flowlanes.system.system import System
    from lawproof.proof.verdict import Verdict

COLOURS = {
    "proven": "green",
    "proven where": "cyan",
    "refuted": "red",
    "undecided": "yellow",
    "refused": "magenta",
}


def command(
    what: str,
    overrides: list[str] | None = None,
    only: list[str] | None = None,
    effort: float = 1.0,
    certificate: Path | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Prove or refute the laws of a system; exit 1 unless all are proven without conditions.

    The exit status is 1 if any law is refuted, undecided, or proven only where a
    condition holds, and 2 if one is refused because it states nothing.
    """
    allowed = operations(effort)
    if certificate is not None:
        check_output("--certificate", certificate, force, json, what, binary=False)
    claims = _selected_laws(_claims(what, overrides), only or [], what)
    with results_on_interrupt("the verdicts reached so far are about to be printed"):
        done = _attempts(claims, allowed, certificate is not None)
        with beside(certificate):
            if json:
                print_json([_record(attempt, allowed) for attempt in done])
            else:
                _print(done)
        if certificate is not None:
            _write(certificate, [attempt.verdict for attempt in done])
    if len(done) < len(claims):
        print_interruption(
            f"{len(claims) - len(done)} of {len(claims)} laws have no verdict; verdicts are saved, "
            "and the same command resumes"
        )
        raise typer.Exit(EXIT_CODE)
    if any(attempt.verdict.decision == "refused" for attempt in done):
        raise typer.Exit(2)
    if not all(attempt.verdict for attempt in done):
        raise typer.Exit(1)


class _Attempt(NamedTuple):
    """Law with its verdict, and the verdict on its printed form if that is different."""

    system: System
    law: Law
    verdict: Verdict
    printed: Verdict | None


def _attempts(claims: list[tuple[System, Law]], effort: int, certificates: bool) -> list[_Attempt]:
    """Verdicts, or those obtained before an interruption."""
    from lawproof.proof.certificates.certificate import prove_with_certificate
    from lawproof.proof.prover import judgement_of, prove

    done: list[_Attempt] = []
    try:
        with progress("proving") as report:
            for count, (system, law) in enumerate(claims):
                report.say(f"proving {law.name}, {count + 1} of {len(claims)}")
                prover = prove_with_certificate if certificates else prove
                verdict = judgement_of(prover, system, law, effort)
                wrong = law.as_printed
                printed = None
                if wrong is not None:
                    printed = judgement_of(prove, system, wrong, effort)
                done.append(_Attempt(system, law, verdict, printed))
    except KeyboardInterrupt:
        pass
    return done


def _claims(what: str, overrides: list[str] | None) -> list[tuple[System, Law]]:
    """Laws of the system, and of its general form if it has one."""
    claims = list(study_of(what, overrides).claims)
    from nonholonomic.catalogue import CATALOGUE

    general = CATALOGUE[what].general if what in CATALOGUE else None
    if general is not None:
        wide = general()
        claims += [(wide, law) for law in wide.laws]
    return claims


def _selected_laws(
    claims: list[tuple[System, Law]], only: list[str], what: str
) -> list[tuple[System, Law]]:
    from flowlanes.errors import InputError

    names = [law.name for _, law in claims]
    for name in only:
        if name not in names:
            listed = ", ".join(dict.fromkeys(names)) or "none"
            raise InputError(f"no law {name!r} of {what}; its laws are {listed}")
    return [pair for pair in claims if not only or pair[1].name in only]


def _record(attempt: _Attempt, effort: int) -> dict[str, object]:
    from flowlanes.printing.formula import latex
    from flowlanes.printing.laws import condition_text
    from flowlanes.printing.system import law_latex

    system, law, verdict, printed = attempt
    record = {
        "source": law.source,
        "statement": _law_description(law),
        "printed": (verdict if printed is None else printed).decision,
        "corrected": law_latex(law, system),
        "verdict": verdict.decision,
        "conditions": list(verdict.conditions),
        "note": law.misprint,
        "seconds": round(verdict.seconds, 3),
        "effort": verdict.effort,
        "system": system.name,
        "law": law.name,
        "level": condition_text(law, system, latex),
        "shown": verdict.finding,
        "reason": verdict.reason,
        "terms": verdict.terms,
    }
    if verdict.witness is not None:
        record["witness"] = verdict.witness
    return record


def _law_description(law: Law) -> str:
    """Kind and meaning of a law, without repetition."""
    kind, meaning = law.heading, str(getattr(law, "meaning", ""))
    if kind.lower() in meaning.lower():
        return meaning[0].upper() + meaning[1:]
    return f"{kind}: {meaning}" if meaning else kind


def coloured_decision(decision: str) -> str:
    """Verdict in its terminal colour."""
    return f"[{COLOURS[decision]}]{decision}[/]"


def _print(attempts: list[_Attempt]) -> None:
    from rich import box
    from rich.markup import escape
    from rich.table import Table

    from flowlanes.printing.formula import text
    from flowlanes.printing.laws import condition_text

    shown = console()
    if not attempts:
        shown.print(NO_LAWS)
        return
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
    table.add_column("Law", style="bold", no_wrap=True)
    table.add_column("What it states")
    table.add_column("Source", style="dim")
    table.add_column("Verdict", no_wrap=True)
    table.add_column("Terms", justify="right")
    table.add_column("Time", justify="right", no_wrap=True)
    previous = None
    for system, law, verdict, printed in attempts:
        if previous is not None and system.title != previous:
            table.add_section()
            table.add_row("", f"[italic]{escape(system.title)}[/]")
        previous = system.title
        where = condition_text(law, system, text)
        table.add_row(
            escape(law.name),
            escape(f"{_law_description(law)} {where}".strip()),
            escape(law.source),
            coloured_decision(verdict.decision),
            f"{verdict.terms:,}" if verdict.terms else "",
            f"{verdict.seconds:.2f} s",
        )
        if printed is not None:
            table.add_row(
                "", escape(f"as printed: {law.misprint}"), "", coloured_decision(printed.decision)
            )
    shown.print(table)
    if len(attempts) > 1:
        shown.print(f"\n{_count_text([attempt.verdict for attempt in attempts])}")
    for _, law, verdict, _ in attempts:
        if verdict.witness is not None:
            point = ", ".join(f"{n} = {v}" for n, v in verdict.witness["point"].items())
            shown.print(
                f"\n{law.name}: {verdict.witness['what']} = {verdict.witness['residual']} at "
                f"{point}",
                markup=False,
            )
        elif verdict.conditions:
            shown.print(f"\n{law.name}: {verdict.statement}", markup=False)
        elif verdict.reason:
            shown.print(f"\n{law.name}: {verdict.reason}", markup=False)


def _count_text(verdicts: list[Verdict]) -> str:
    """Number of laws with each verdict."""
    decisions = [verdict.decision for verdict in verdicts]
    counts = (f"{decisions.count(d)} {d}" for d in COLOURS if d in decisions)
    return f"{len(verdicts)} laws: {', '.join(counts).replace('where', 'where a condition holds')}"


def _write(path: Path, verdicts: list[Verdict]) -> None:
    import json

    own = [verdict.certificate for verdict in verdicts if verdict.certificate is not None]
    by_theorem = [verdict for verdict in verdicts if verdict.identities]
    identities = [part for verdict in by_theorem for part in verdict.identities]
    # One identity may be used for several laws.
    further = [part for i, part in enumerate(identities) if part not in identities[:i]]
    with output_file(path) as place:
        place.write_text(json.dumps([*own, *further], ensure_ascii=False), encoding="utf-8")
    inform(f"certificates of {len(own)} of {len(verdicts)} laws: {name_of(path)}")
    for verdict in by_theorem:
        count = len(verdict.identities)
        if verdict.in_ranges:
            inform(f"{verdict.law} has {count} certificates, one for each range of its parameters")
            continue
        what = f"{count} identities are" if count > 1 else "1 identity is"
        inform(f"{verdict.law} follows from a theorem, of which {what} certified")
    for verdict in verdicts:
        if verdict.certificate is None and not verdict.identities:
            why = verdict.no_certificate or f"it is {verdict.decision}"
            inform(f"no certificate of {verdict.law}: {why}")

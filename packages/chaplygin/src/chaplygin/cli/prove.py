"""``chaplygin prove``: the laws of a system, each with its verdict."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import typer

from ..interruption import EXIT_CODE, print_interruption, results_on_interrupt
from .terminal.options import (
    NO_LAWS,
    console,
    inform,
    inform_remarks,
    is_name,
    operations,
    print_json,
    study_of,
)
from .terminal.output_destination import beside, check_output, name_of, output_file
from .terminal.progress import progress

if TYPE_CHECKING:
    from flowlanes.system.laws import Law
    from flowlanes.system.system import System
    from lawproof.proof.verdict import Verdict

    from ..answers.verdicts import LawVerdict

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
    again: bool = False,
) -> None:
    """Prove or refute the laws of a system; exit 1 unless all are proven without conditions.

    The exit status is 1 if any law is refuted, undecided, or proven only where a
    condition holds, and 2 if one is refused because it states nothing.
    """
    from ..answers.stored import Answer, Question, keep, stored

    allowed = operations(effort)
    if certificate is not None:
        check_output("--certificate", certificate, force, json, what, binary=False)
    question = Question(f"prove {allowed}", what, is_name(what), tuple(overrides or ()))
    answer = None if again or certificate is not None else stored(question)
    if answer is not None:
        inform_remarks(answer.remarks)
        known: list[LawVerdict] = answer.content
        chosen = _selected([each["record"]["law"] for each in known], only or [], what)
        verdicts = [known[index] for index in chosen]
        _print(verdicts, json)
        _end(verdicts)
        return
    study = study_of(what, overrides)
    from ..answers.verdicts import claims_of, law_report_record

    claims = claims_of(study, what)
    chosen = _selected([law.name for _, law in claims], only or [], what)
    with results_on_interrupt("the verdicts reached so far are about to be printed"):
        done = _attempts([claims[index] for index in chosen], allowed, certificate is not None)
        verdicts = [law_report_record(*attempt) for attempt in done]
        if len(done) == len(claims):
            keep(question, Answer(study.remarks, verdicts))
        with beside(certificate):
            _print(verdicts, json)
        if certificate is not None:
            _write(certificate, [attempt.verdict for attempt in done])
    if len(done) < len(chosen):
        print_interruption(
            f"{len(chosen) - len(done)} of {len(chosen)} laws have no verdict; verdicts are saved, "
            "and the same command resumes"
        )
        raise typer.Exit(EXIT_CODE)
    _end(verdicts)


def _end(verdicts: list[LawVerdict]) -> None:
    """End with the exit status of these verdicts."""
    decisions = {each["record"]["verdict"] for each in verdicts}
    if "refused" in decisions:
        raise typer.Exit(2)
    if decisions - {"proven"}:
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


def _selected(names: list[str], only: list[str], what: str) -> list[int]:
    """The places of the laws that are asked for, by name."""
    from flowlanes.errors import InputError

    for name in only:
        if name not in names:
            listed = ", ".join(dict.fromkeys(names)) or "none"
            raise InputError(f"no law {name!r} of {what}; its laws are {listed}")
    return [index for index, name in enumerate(names) if not only or name in only]


def coloured_decision(decision: str) -> str:
    """Verdict in its terminal colour."""
    return f"[{COLOURS[decision]}]{decision}[/]"


def _print(verdicts: list[LawVerdict], json: bool) -> None:
    if json:
        print_json([each["record"] for each in verdicts])
        return
    from rich import box
    from rich.markup import escape
    from rich.table import Table

    shown = console()
    if not verdicts:
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
    for each in verdicts:
        record = each["record"]
        if previous is not None and each["title"] != previous:
            table.add_section()
            table.add_row("", f"[italic]{escape(each['title'])}[/]")
        previous = each["title"]
        table.add_row(
            escape(record["law"]),
            escape(f"{record['statement']} {each['level']}".strip()),
            escape(record["source"]),
            coloured_decision(record["verdict"]),
            f"{record['terms']:,}" if record["terms"] else "",
            f"{record['seconds']:.2f} s",
        )
        if each["printed"] is not None:
            table.add_row(
                "", escape(f"as printed: {record['note']}"), "", coloured_decision(each["printed"])
            )
    shown.print(table)
    if len(verdicts) > 1:
        shown.print(f"\n{_count_text([each['record']['verdict'] for each in verdicts])}")
    for each in verdicts:
        record, said = each["record"], ""
        if "witness" in record:
            witness = record["witness"]
            point = ", ".join(f"{n} = {v}" for n, v in witness["point"].items())
            said = f"{witness['what']} = {witness['residual']} at {point}"
        elif record["conditions"]:
            said = each["sentence"]
        elif record["reason"]:
            said = record["reason"]
        if said:
            shown.print(f"\n{record['law']}: {said}", markup=False)


def _count_text(decisions: list[str]) -> str:
    """The number of laws with each verdict."""
    counts = (f"{decisions.count(d)} {d}" for d in COLOURS if d in decisions)
    return f"{len(decisions)} laws: {', '.join(counts).replace('where', 'where a condition holds')}"


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

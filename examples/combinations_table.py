"""Combinations of §12's first problem: what is proven, refuted, observed, undecided of each.

Every cell of the table is the outcome of one command; this script runs them all, keeps the outcomes
in examples/combinations/verdicts.json, and writes nonholonomic/docs/combinations.md.

    python examples/combinations_table.py                    missing outcomes, and the page
    python examples/combinations_table.py plane-11           the commands of a row, their outcomes
    python examples/combinations_table.py --multiplier rubber
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import shlex
import time
from collections.abc import Sequence
from dataclasses import replace
from math import comb
from pathlib import Path
from typing import Any

from combinations_rows import FAMILIES, ROWS, Row

HERE = Path(__file__).parent
FILE = HERE / "combinations" / "verdicts.json"
PAGE = HERE.parent / "packages/nonholonomic/docs/combinations.md"


# --- outcomes --------------------------------------------------------------------------------


def outcome(command: str) -> dict[str, Any]:
    """What a command answers: its verdict, words for the cell, seconds of processor time."""
    began = time.process_time()
    program, *arguments = shlex.split(command)
    if program == "python":
        answer = _script(arguments)
    else:
        kind = arguments[0]
        code, output, complaint = _chaplygin([*arguments, *([] if kind == "show" else ["--json"])])
        answer = _ANSWERS[kind](code, output, complaint)
    return {**answer, "seconds": round(time.process_time() - began, 1)}


def _chaplygin(arguments: Sequence[str]) -> tuple[int, str, str]:
    """Exit code, standard output and error of the program, in this process."""
    import typer

    from chaplygin import InputError
    from chaplygin.cli import app

    output, complaint = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(complaint):
        try:
            code = app(list(arguments), standalone_mode=False)
        except typer.Exit as left:
            code = left.exit_code
        except InputError as refused:
            code = 2
            complaint.write(f"error: {refused}")
    return int(code or 0), output.getvalue(), complaint.getvalue()


def _proven(code: int, output: str, complaint: str) -> dict[str, Any]:
    found = json.loads(output)
    decisions = {item["verdict"] for item in found}
    return {"verdict": decisions.pop() if len(decisions) == 1 else "undecided", "words": ""}


def _searched(code: int, output: str, complaint: str) -> dict[str, Any]:
    found = json.loads(output)
    proven = [item for item in found["found"] if item["verdict"] == "proven"]
    size = comb(len(found["momenta"]) + found["degree"], found["degree"]) * comb(
        len(found["coordinates"]) + found["gamma_degree"], found["gamma_degree"]
    )
    new = [item["formula"] for item in proven if not item["repeats"]]
    closed = found["complete"] and len(proven) == len(found["found"])
    return {
        "verdict": "proven" if closed else "undecided",
        "count": len(proven),
        "size": size,
        "divisors": len(found["factors"]),
        "new": new,
        "words": f"{len(proven)} proven",
    }


def _solved(code: int, output: str, complaint: str) -> dict[str, Any]:
    if code == 0:
        return {"verdict": "proven", "words": "solved"}
    message = " ".join(complaint.split())
    _, _, known = message.partition("solvable ")
    words = known.removeprefix("is ").removeprefix("are ")
    return {"verdict": "undecided", "words": f"solved: {words}" if words else "none known"}


def _followed(code: int, output: str, complaint: str) -> dict[str, Any]:
    (first, *_) = json.loads(output)["exponents"] or ({"value": 0.0, "error": 0.0},)
    value, error = first["value"], first["error"]
    words = f"λ = {value:.3f} ± {error:.3f}"
    return {"verdict": "observed", "words": words, "value": value, "error": error}


def _shown(code: int, output: str, complaint: str) -> dict[str, Any]:
    known = "no Hamiltonian form proven" not in output
    return {"verdict": "proven" if known else "undecided", "words": "" if known else "none known"}


_ANSWERS = {
    "prove": _proven,
    "find": _searched,
    "solve": _solved,
    "lyapunov": _followed,
    "show": _shown,
}


def _script(arguments: Sequence[str]) -> dict[str, Any]:
    if arguments[0].endswith("lifted_bracket.py"):
        import lifted_bracket

        refuted = not lifted_bracket.lifts(
            lifted_bracket.MOMENTS, lifted_bracket.WEIGHTS["two supporting balls, D = ½, ⅓"]
        )
        return {
            "verdict": "refuted" if refuted else "undecided",
            "words": "for brackets of cotangent type",
        }
    return multiplier_of(arguments[-1])[0]


def multiplier_of(key: str) -> tuple[dict[str, Any], str]:
    """The reducing multiplier of a rolling ball, derived and proven, and its description.

    Parameters
    ----------
    key : str
        ``"rubber"`` for every rubber ball on a sphere, or the key of a row.
    """
    import chaplygin as ch
    import nonholonomic
    from nonholonomic.catalogue import entry
    from nonholonomic.mechanics.lagrangian.substituted_parameters import with_parameters

    both = entry("ball-around-sphere-gyrostat-bruns").rolling()
    if both is None:
        raise LookupError("the ball is given without a Rolling")
    if key == "rubber":
        mechanism = nonholonomic.rolling_mechanism(replace(both, contact="rubber"))
    else:
        family, mark = key.rsplit("-", 1)
        ball = (
            both if mark[0] == "1" else replace(both, body=replace(both.body, gyrostat=(0, 0, 0)))
        )
        ball = ball if mark[1] == "1" else replace(ball, field=ch.Forces())
        mechanism = nonholonomic.rolling_mechanism(ball)
        if family == "around":
            numbers = {p.symbol: _fraction(p.default) for p in mechanism.parameters}
            mechanism = with_parameters(mechanism, numbers)
    try:
        form = nonholonomic.chaplygin_form(mechanism)
    except ch.InputError as refused:
        return {"verdict": "undecided", "words": "no linear integral"}, str(refused)
    decisions = {ch.prove(system, law).decision for system, law in form.claims()}
    verdict = "proven" if decisions == {"proven"} else "undecided"
    return {"verdict": verdict, "words": ""}, str(form)


def _fraction(number: float) -> Any:
    import sympy as sp

    return sp.Rational(str(number))


# --- the page --------------------------------------------------------------------------------


def read() -> dict[str, dict[str, Any]]:
    """Outcomes by command."""
    return json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}


def keep(outcomes: dict[str, dict[str, Any]]) -> None:
    """Write the outcomes to their file."""
    FILE.write_text(json.dumps(outcomes, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


def needed(outcomes: dict[str, dict[str, Any]]) -> dict[str, dict[str, Any]]:
    """The outcomes of commands of the table, in its order."""
    commands = [c for row in ROWS.values() for c in row.commands.values()]
    return {command: outcomes[command] for command in commands if command in outcomes}


def compute(rows: Sequence[Row], outcomes: dict[str, dict[str, Any]]) -> None:
    """Run the commands that have not been run, and keep each outcome as it comes."""
    for row in rows:
        for command in filter(None, row.commands.values()):
            if command in outcomes:
                continue
            outcomes[command] = outcome(command)
            FILE.write_text(
                json.dumps(outcomes, ensure_ascii=False, indent=1) + "\n", encoding="utf-8"
            )
            print(f"{row.key}: {command}: {outcomes[command]}", flush=True)


def cell(row: Row, column: str, outcomes: dict[str, dict[str, Any]]) -> str:
    """The words of one cell."""
    found = outcomes[row.commands[column]]
    if column == "integrals":
        if found["verdict"] != "proven":
            return "**undecided**"
        known = "one" if found["count"] == 1 else str(found["count"])
        over = f" over {found['divisors'] + 1} denominators" if found["divisors"] else ""
        return f"{known} **proven**, any other **refuted** ({found['size']} coefficients{over})"
    if column == "exponent":
        value, error = found["value"], found["error"]
        if value > 2 * error:
            words = "chaos"
        else:
            words = "zero within its error" if value <= error else "not settled by this length"
        return f"λ = {value:.3f} ± {error:.3f}, **observed**: {words}"
    words = f" ({found['words']})" if found["words"] not in ("", "solved") else ""
    return f"**{found['verdict']}**{words}"


def integrable(row: Row, outcomes: dict[str, dict[str, Any]]) -> str:
    """Whether enough laws are proven for the theorem of Euler and Jacobi."""
    count = outcomes[row.integrals]["count"]
    if outcomes[row.measure]["verdict"] != "proven":
        return "**undecided**"
    missing = row.dimension - 2 - count
    if missing <= 0:
        return "**proven**"
    return f"**undecided**, {'one integral' if missing == 1 else f'{missing} integrals'} short"


LABELS = {
    "measure": "measure",
    "Poisson": "Poisson structure",
    "integrals": "quadratic integrals",
    "closed form": "closed form",
    "exponent": "largest exponent",
}


def summary(outcomes: dict[str, dict[str, Any]]) -> str:
    """One line for every row: the verdicts alone."""
    lines = ["| row | measure | Poisson | integrable | λ |", "|---|---|---|---|---|"]
    for row in ROWS.values():
        exponent = outcomes[row.exponent]["value"] if row.exponent else None
        cells = (
            f"`{row.key}`",
            outcomes[row.measure]["verdict"],
            outcomes[row.poisson]["verdict"],
            integrable(row, outcomes).split("**")[1],
            "–" if exponent is None else f"{exponent:.3f}",
        )
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def page(outcomes: dict[str, dict[str, Any]]) -> str:
    """nonholonomic/docs/combinations.md."""
    parts = [(HERE / "combinations" / "preface.md").read_text(encoding="utf-8").rstrip()]
    parts.append(f"## Overview\n\n{summary(outcomes)}")
    for family in FAMILIES:
        parts.append(f"## {family.title}\n\n{family.text}")
        for row in family.rows:
            lines = [f"**{row.words[0].upper()}{row.words[1:]}**, `{row.key}`", ""]
            for column, command in row.commands.items():
                if command:
                    seconds = outcomes[command]["seconds"]
                    lines.append(
                        f"- {LABELS[column]}: {cell(row, column, outcomes)}  \n"
                        f"  `{command}` ({seconds:g} s)"
                    )
                if column == "integrals":
                    lines.append(f"- integrable by Euler and Jacobi: {integrable(row, outcomes)}")
            parts.append("\n".join(lines))
    return "\n\n".join(parts) + "\n"


def main(arguments: Sequence[str] | None = None) -> None:
    """Compute what is missing; write the page, or print a row or a multiplier."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("rows", nargs="*", metavar="ROW", help="such as plane-11; default: all")
    parser.add_argument("--multiplier", metavar="ROW", help="derive a multiplier and print it")
    asked = parser.parse_args(arguments)
    if asked.multiplier:
        found, words = multiplier_of(asked.multiplier)
        print(words)
        print(found["verdict"])
        return
    unknown = [key for key in asked.rows if key not in ROWS]
    if unknown:
        parser.error(f"ROW {unknown[0]}: it must be one of {', '.join(ROWS)}")
    outcomes = needed(read())
    compute([ROWS[key] for key in asked.rows or ROWS], outcomes)
    for key in asked.rows:
        for column, command in ROWS[key].commands.items():
            if command:
                print(f"{column}: {outcomes[command]['verdict']} {outcomes[command]['words']}")
                print(f"    {command}")
    if not asked.rows:
        keep(needed(outcomes))
        PAGE.write_text(page(outcomes), encoding="utf-8")
        print(f"wrote {PAGE}")


if __name__ == "__main__":
    main()

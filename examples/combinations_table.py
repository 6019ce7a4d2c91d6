"""Combinations of §12's first problem: what is proven, refuted, observed, undecided of each.

Every cell of the table is the outcome of one command; this script runs them all, keeps the outcomes
in examples/combinations/verdicts.json, and writes docs/combinations.md.

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
from dataclasses import dataclass, replace
from math import comb
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
FILE = HERE / "combinations" / "verdicts.json"
PAGE = HERE.parent / "docs" / "combinations.md"
SCRIPT = "python examples/combinations_table.py"
FILES = "examples/combinations"
COLUMNS = ("measure", "Poisson", "integrals", "closed form", "exponent")
NO_ROTORS = "--at k_1=0 --at k_2=0 --at k_3=0"
NO_FIELD = "--at K=0"
STILL = "--set k_1=0 --set k_2=0 --set k_3=0"
UNTIL = 2000


@dataclass(frozen=True)
class Row:
    """One combination and the commands of its cells.

    Attributes
    ----------
    key : str
        Family, then 1 or 0 for rotors and for Bruns' field: ``"plane-10"``.
    measure, poisson, integrals, solution, exponent : str
        Commands; empty where another cell has answered the question.
    dimension : int
        Of the phase space less the parameters that are constants by definition.
    """

    key: str
    measure: str
    poisson: str
    integrals: str
    solution: str = ""
    exponent: str = ""
    dimension: int = 5

    @property
    def commands(self) -> dict[str, str]:
        """The command of every column."""
        cells = (self.measure, self.poisson, self.integrals, self.solution, self.exponent)
        return dict(zip(COLUMNS, cells, strict=True))

    @property
    def words(self) -> str:
        """What is combined."""
        rotors, field = (mark == "1" for mark in self.key[-2:])
        return {
            (False, False): "free",
            (True, False): "rotors",
            (False, True): "Bruns' field",
            (True, True): "rotors and Bruns' field",
        }[rotors, field]


@dataclass(frozen=True)
class Family:
    """Combinations of one system with rotors and Bruns' field."""

    title: str
    text: str
    rows: tuple[Row, ...]


def prove(name: str, law: str) -> str:
    """The command that proves one law."""
    return f"chaplygin prove {name} --law {law}"


def search(name: str, *options: str) -> str:
    """The command that searches for integrals."""
    return " ".join(("chaplygin find integrals", name, *(options or ("--at none",))))


def solve(name: str, *options: str) -> str:
    """The command that asks for a closed form."""
    return " ".join(("chaplygin solve", name, "--at 1", *options))


def follow(name: str, *options: str) -> str:
    """The command that computes exponents."""
    return " ".join(("chaplygin lyapunov", name, *options, f"--until {UNTIL}"))


def multiplier(name: str) -> str:
    """The command that derives a reducing multiplier."""
    return f"{SCRIPT} --multiplier {name}"


def _plane() -> tuple[Row, ...]:
    names = {
        "00": "chaplygin-ball",
        "10": "chaplygin-ball-gyrostat",
        "01": "chaplygin-ball-bruns",
        "11": "chaplygin-ball-gyrostat-bruns",
    }
    return tuple(
        Row(
            f"plane-{mark}",
            prove(name, "measure"),
            prove(name, "hamiltonian"),
            search(name),
            solve(name) if mark != "11" else "",
            follow(f"{FILES}/ball_on_plane.toml") if mark == "11" else "",
        )
        for mark, name in names.items()
    )


def _sphere(key: str, ratio: str) -> tuple[Row, ...]:
    """Marble contact, for all ratios of the radii or for k = −1."""
    both = "ball-around-sphere-gyrostat-bruns"
    names = {
        "00": ("ball-around-sphere",),
        "10": (both, NO_FIELD),
        "01": ("ball-around-sphere-bruns",),
        "11": (both,),
    }
    around = key == "around"
    size = "" if around else "--set R=3"
    rows = []
    for mark, (name, *conditions) in names.items():
        options = [ratio, *conditions] if ratio else conditions or ["--at none"]
        if mark[0] == "1":
            file = f"{FILES}/ball_around_sphere.toml"
            motion = follow(file, size, "" if mark == "11" else "--set K=0")
        else:
            motion = follow(name, size, "--set I_2=1.6", "--set I_3=2.3")
        integrable = around and mark[0] == "0"
        rows.append(
            Row(
                f"{key}-{mark}",
                prove(name, "measure"),
                multiplier(f"{key}-{mark}"),
                search(name, *options),
                solve(name) if integrable else "",
                "" if integrable else " ".join(motion.split()),
            )
        )
    return tuple(rows)


def _veselova() -> tuple[Row, ...]:
    both, file = "veselova-gyrostat-bruns", f"{FILES}/veselova.toml"
    return (
        Row(
            "veselova-00",
            prove("veselova", "measure"),
            prove("veselova", "hamiltonian"),
            search("veselova"),
            solve("veselova"),
            dimension=4,
        ),
        Row(
            "veselova-10",
            prove(both, "measure"),
            prove(both, "hamiltonian"),
            search(both, NO_FIELD),
            solve(both, "--set K=0"),
            dimension=4,
        ),
        Row(
            "veselova-01",
            prove("veselova-bruns", "measure"),
            prove("veselova-bruns", "hamiltonian"),
            search("veselova-bruns"),
            solve("veselova-bruns"),
            dimension=4,
        ),
        Row(
            "veselova-11",
            prove(both, "measure"),
            prove(both, "hamiltonian"),
            search(both),
            "",
            follow(file),
            dimension=4,
        ),
    )


def _spinning() -> tuple[Row, ...]:
    both, file = "veselova-spinning-gyrostat-bruns", f"{FILES}/spinning_veselova.toml"
    cases = {
        "00": (("--at K=0", NO_ROTORS), ("--set K=0", STILL)),
        "10": ((NO_FIELD,), ("--set K=0",)),
        "01": ((NO_ROTORS,), (STILL,)),
        "11": ((), ()),
    }
    return tuple(
        Row(
            f"spinning-{mark}",
            prove(both, "measure"),
            f"chaplygin show {both}",
            search(both, *where),
            solve(both, *numbers) if mark != "11" else "",
            follow(file) if mark == "11" else "",
        )
        for mark, (where, numbers) in cases.items()
    )


def _rubber(key: str, ratio: str) -> tuple[Row, ...]:
    """Rubber contact on a sphere."""
    file = f"{FILES}/rubber_ball_around_sphere.toml"
    still = "--set body.gyrostat=[0,0,0]"
    free = "rubber-ball-around-sphere"
    size = "--set body.shape.radius=3" if not ratio else ""
    cases = {
        "00": (free, free, "", ""),
        "10": (file, file, NO_FIELD, "--set K=0"),
        "01": (file, file, still, still),
        "11": (file, file, "", ""),
    }
    rows = []
    for mark, (name, moving, where, numbers) in cases.items():
        options = [ratio, where] if ratio else [where if "--at" in where else f"--at none {where}"]
        integrable = bool(ratio) and mark == "00"
        radius = size.replace("body.shape.radius", "R") if mark == "00" else size
        rows.append(
            Row(
                f"{key}-{mark}",
                prove(name, "measure"),
                multiplier("rubber"),
                " ".join(search(name, *options).split()),
                solve(name) if integrable else "",
                "" if integrable else " ".join(follow(moving, numbers, radius).split()),
                dimension=4,
            )
        )
    return tuple(rows)


def _two_balls() -> tuple[Row, ...]:
    name, file = "ball-on-two-balls", f"{FILES}/ball_on_two_balls.toml"
    cases = {
        "00": (("--at K=0", NO_ROTORS), ("--set K=0", STILL)),
        "10": ((NO_FIELD,), ("--set K=0",)),
        "01": ((NO_ROTORS,), (STILL,)),
        "11": ((), ()),
    }
    return tuple(
        Row(
            f"two-balls-{mark}",
            prove(name, "measure"),
            prove(name, "hamiltonian"),
            search(name, *where),
            solve(name, *numbers) if mark != "11" else "",
            follow(file) if mark == "11" else "",
        )
        for mark, (where, numbers) in cases.items()
    )


def _bearing() -> tuple[Row, ...]:
    name, file = "ball-bearing-gyrostat-bruns", f"{FILES}/ball_bearing.toml"
    ansatz = "--denominator 1"
    cases = {
        "00": (("--at K=0", NO_ROTORS), ("--set K=0", STILL)),
        "10": ((NO_FIELD,), ("--set K=0",)),
        "01": ((NO_ROTORS,), (STILL,)),
        "11": ((), ()),
    }
    return tuple(
        Row(
            f"bearing-{mark}",
            prove(name, "measure"),
            "python examples/lifted_bracket.py",
            search(name, *(where or ("--at none",)), "--at D_3=0", ansatz),
            solve(name, *numbers) if mark[1] == "0" else "",
            follow(file, *numbers) if mark[1] == "1" else "",
            dimension=9,
        )
        for mark, (where, numbers) in cases.items()
    )


def _two_constraints() -> tuple[Row, ...]:
    name, file = "two-veselova-constraints", f"{FILES}/two_constraints.toml"
    cases = {
        "00": (("--at K=0", NO_ROTORS), ("--set K=0", STILL)),
        "10": ((NO_FIELD,), ("--set K=0",)),
        "01": ((NO_ROTORS,), (STILL,)),
        "11": ((), ()),
    }
    return tuple(
        Row(
            f"two-constraints-{mark}",
            prove(name, "measure"),
            f"chaplygin show {name}",
            search(name, *(where or ("--at none",)), "--momenta w"),
            "",
            follow(file, *numbers) if mark[1] == "1" else "",
        )
        for mark, (where, numbers) in cases.items()
    )


FAMILIES = (
    Family(
        "Chaplygin ball on a plane",
        "Any area constant (M + k, γ). The rotors add k to the momentum, Bruns' field is "
        "U = ½K(γ, Iγ). Each alone leaves the ball integrable; both together do not.\n\n"
        "![Sections: curves with rotors or with the field, scattered points with both]"
        "(pictures/combinations_sections.png)\n\n"
        "*Sections γ₃ = 0, rising, at energy 6 and area constant 1 "
        "([combinations_sections.py](../examples/combinations_sections.py)).*",
        _plane(),
    ),
    Family(
        "Ball on or in a sphere, any ratio of the radii",
        "Marble contact; k = a/(a ± R) is left a symbol in the search. Exponents: one motion for "
        "k = −½; many motions and ratios are in [charts.md](charts.md).",
        _sphere("sphere", ""),
    ),
    Family(
        "Hollow ball around a sphere, k = −1",
        "The problem of Borisov and Fedorov, on every level of its linear integral.",
        _sphere("around", "--at k=-1"),
    ),
    Family(
        "Veselova system, and rubber ball on a plane",
        "(ω, γ) = 0; the rubber ball has J = I + mR² for I, and the same field up to a constant.",
        _veselova(),
    ),
    Family(
        "Veselova constraint with (ω, γ) = d",
        "Remark 18; d ≠ 0 is the constant of the constraint.",
        _spinning(),
    ),
    Family(
        "Rubber ball on a sphere, any ratio of the radii",
        "k is left a symbol in the search. Exponents: k = −½.",
        _rubber("rubber-sphere", ""),
    ),
    Family(
        "Hollow rubber ball around a sphere, k = −1",
        "The free ball has the quadratic integral (9.4).",
        _rubber("rubber-around", "--at k=-1"),
    ),
    Family(
        "Ball on two equal balls at right angles",
        "A ball with fixed centre on two homogeneous supporting balls whose directions are "
        "orthogonal: the equations of the Chaplygin ball with −D for D.",
        _two_balls(),
    ),
    Family(
        "Ball on two different balls",
        "A ball bearing with two supporting balls in any directions; the field is that of the "
        "vector γ, fixed in space.",
        _bearing(),
    ),
    Family(
        "Two constraints of Veselova",
        "(ω, n₁) and (ω, n₂) are constant, ω = dα + wγ. For d = 0 the constraints are holonomic "
        "and the body turns about a fixed axis (`chaplygin prove two-veselova-constraints`): "
        "uniformly without a field, as a pendulum in one. The rows have d ≠ 0.",
        _two_constraints(),
    ),
)
ROWS = {row.key: row for family in FAMILIES for row in family.rows}


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

    from chaplygin.cli import app
    from chaplygin.errors import InputError

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
    from chaplygin.catalogue import entry
    from chaplygin.mechanics.lagrangian.substituted_parameters import with_parameters

    both = entry("ball-around-sphere-gyrostat-bruns").rolling()
    if both is None:
        raise LookupError("the ball is given without a Rolling")
    if key == "rubber":
        mechanism = ch.rolling_mechanism(replace(both, contact="rubber"))
    else:
        family, mark = key.rsplit("-", 1)
        ball = (
            both if mark[0] == "1" else replace(both, body=replace(both.body, gyrostat=(0, 0, 0)))
        )
        ball = ball if mark[1] == "1" else replace(ball, field=ch.Forces())
        mechanism = ch.rolling_mechanism(ball)
        if family == "around":
            numbers = {p.symbol: _fraction(p.default) for p in mechanism.parameters}
            mechanism = with_parameters(mechanism, numbers)
    try:
        form = ch.chaplygin_form(mechanism)
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
    """docs/combinations.md."""
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

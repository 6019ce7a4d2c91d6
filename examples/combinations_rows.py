"""The combinations of nonholonomic/docs/combinations.md, and the command of every cell."""

from __future__ import annotations

from dataclasses import dataclass

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
        "(../../../docs/pictures/combinations_sections.png)\n\n"
        "*Sections γ₃ = 0, rising, at energy 6 and area constant 1 "
        "([combinations_sections.py](../../../examples/combinations_sections.py)).*",
        _plane(),
    ),
    Family(
        "Ball on or in a sphere, any ratio of the radii",
        "Marble contact; k = a/(a ± R) is left a symbol in the search. Exponents: one motion for "
        "k = −½; many motions and ratios are in [charts.md](../../flowlanes/docs/charts.md).",
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

"""Options of all commands: help text, name of the value, and flags."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from typing import Annotated, Any, get_origin, get_type_hints

import typer

#: By the name of a parameter, or by command and parameter: help, metavar and flags.
OPTIONS: dict[str, tuple[str, ...]] = {
    # of several commands
    "what": ("A catalogue name, an experiment file, or a Python file.", "NAME|FILE"),
    "output": ("Zarr store to write, FILE.zarr.", "", "-o --output"),
    "overrides": (
        "Override a key of the experiment file, e.g. body.mass=2 or run.until=5; a parameter by "
        "its name alone, e.g. I_1=2.",
        "KEY=VALUE",
        "--set",
    ),
    "force": ("Replace files that exist already.",),
    "workers": ("Number of processes, or the address of a Dask scheduler.", "N|ADDRESS"),
    "json": ("Print JSON instead of a table.",),
    "figure": ("Figure to write; default: FILE.png.",),
    "device": (
        "Where to compute: the processors of this machine, or a graphics processor.",
        "cpu|gpu",
    ),
    "seed": ("Seed of the random starts.",),
    "record": ("Also record this observable or integral.", "NAME"),
    "tolerance": ("Error tolerance of one step.",),
    "on": ("Section QUANTITY = value: gamma_3, or a formula.", "QUANTITY"),
    "effort": (
        "Work allowed for the proof of one law before it is left undecided: 1 is two thousand "
        "million operations, some minutes on one core; 0.1 is a tenth of that. Operations are "
        "counted, so every machine reaches the same answer.",
        "FACTOR",
    ),
    "value": ("Value of QUANTITY on the section.",),
    "direction": ("Crossings to count: rising, falling or both.",),
    "angle": ("QUANTITY is an angle: take it modulo 2π.",),
    "precision": ("double (16 digits) or quad (34 digits); short for --set run.precision=….",),
    "again": ("Compute the answer again, even if it is stored.",),
    # chaplygin animate
    "animate output": ("Film to write: .mp4, .webm, .gif, or .glb.", "FILE", "-o --output"),
    "rate": ("Frames per second.",),
    "speed": ("Seconds of motion per second of film.",),
    "width": ("Width in pixels.",),
    "height": ("Height in pixels.",),
    # chaplygin audit
    "audit output": ("HTML page to write.", "FILE", "-o --output"),
    "audit section": ("Check only this section of the paper, 1 to 12.",),
    "audit workers": ("Number of processes; default: one for each processor.",),
    "remarks_alone": (
        "List the statements that are not computed; check no claims.",
        "",
        "--remarks",
    ),
    # chaplygin bifurcation
    "bifurcation what": (
        "A catalogue name, an experiment file, or a plane listed in "
        "nonholonomic/docs/bifurcations.md.",
        "NAME|FILE",
    ),
    "bifurcation figure": ("Figure to write: .png, .svg or .pdf.", "FILE.png", "-o --output"),
    # chaplygin chart
    "of": ("Number to compute, such as lyapunov or mean:FORMULA.", "NUMBER"),
    "x": ("Horizontal axis: N values from A to B.", "NAME=A:B:N"),
    "y": ("Vertical axis, likewise.", "NAME=A:B:N"),
    "chart until": ("Duration of each motion; default: as in the experiment.",),
    "let": (
        "Set a parameter, a variable of the start or a level by a formula in the axes.",
        "NAME=FORMULA",
    ),
    "chart hold": ("Hold this variable of the start fixed.", "NAME"),
    # chaplygin ensemble
    "ensemble starts": ("Number of starts to draw at random; needs --level or --draw.",),
    "ensemble level": ("Level of the integrals on which starts are drawn.", "NAME=VALUE,…"),
    "ensemble draw": (
        "With friction: draw a number of the file from A to B; gamma or attitude alone: any "
        "direction.",
        "NAME=A:B",
    ),
    "ensemble over": (
        "Vary a parameter, or with friction a number of the file: N values from A to B.",
        "NAME=A:B:N",
    ),
    # chaplygin find
    "kind": ("integrals, measure or symmetries.", "KIND"),
    "degree": ("Largest degree in the momenta.",),
    "gamma_degree": ("Largest degree in the coordinates.",),
    "momenta": ("Momenta, e.g. M; default: M, and also ω.", "NAMES"),
    "find coordinates": ("Coordinates, e.g. gamma; default: all other variables.", "NAMES"),
    "find at": (
        "A condition on the parameters, e.g. k=-1. Default: the coincidences of the present "
        "values (equal moments or semi-axes, zeros). none: no condition.",
        "CONDITION",
    ),
    "find on": ("Search on the level where this is 0, e.g. 'M·γ'.", "FORMULA"),
    "divisors": (
        "A denominator to try, e.g. '(γ, A γ)'; default: candidates from the equations. 1: none.",
        "FORMULA",
        "--denominator",
    ),
    "bases": (
        "A factor of the density, to a power to be found; default: candidates from the equations.",
        "FORMULA",
        "--base",
    ),
    "power": ("Largest power of a denominator.",),
    "parameter_degree": ("Largest degree of coefficients in the parameters.",),
    # chaplygin lab
    "lab what": ("A catalogue name, an experiment file, or a Python file of yours.", "[NAME|FILE]"),
    "port": ("Port of the address; 0 for any that is free.",),
    "show": ("Open the page in the browser.", "", "--open"),
    # chaplygin list
    "list section": ("Only systems from this section of Borisov and Mamaev (2008).", "N"),
    "contact": (
        "Only this contact: marble (no slipping; spinning allowed), rubber (neither slipping nor "
        "spinning) or none (nothing rolls).",
    ),
    "integrable": ("Only systems proven integrable at their default parameters.",),
    # chaplygin lyapunov
    "lyapunov output": ("NetCDF file to write.", "", "-o --output"),
    "lyapunov until": ("Duration of the motion; default: ten times that of the experiment.",),
    "lyapunov level": (
        "Draw the start at random on this level of the integrals; default: the start of the "
        "experiment.",
        "NAME=VALUE,…",
    ),
    "lyapunov seed": ("Seed of the random start.",),
    # chaplygin orbit
    "orbit output": ("File for one period: .nc, .zarr or .csv.", "FILE", "-o --output"),
    "orbit figure": ("Figure of one period or the branch: .png, .svg or .pdf.", "FILE.png"),
    "orbit hold": ("Hold the value of this integral fixed.", "NAME"),
    "after": ("Returns of the motion to the section before the search starts.",),
    "period": ("Number of returns after which it closes.",),
    "follow": ("Continue the orbit as this integral or parameter goes to VALUE.", "NAME=VALUE"),
    # chaplygin prove
    "only": ("Prove only the law of this name.", "LAW", "--law"),
    "certificate": ("Certificates to write (JSON), for an independent check.", "FILE"),
    # chaplygin run
    "run output": (
        "File to write: .nc, .zarr or .csv; - for NetCDF on standard output.",
        "FILE",
        "-o --output",
    ),
    # chaplygin section
    "section output": ("Zarr store to write, or its folder.", "FILE.zarr|DIR", "-o --output"),
    "section until": (
        "Time limit of a motion; default: the experiment's duration for each point.",
    ),
    "section starts": ("Number of motions; if several, they start at random on a level.",),
    "section level": (
        "Level of the integrals for the starts; default: that of the experiment.",
        "NAME=VALUE,…",
    ),
    "section coordinates": (
        "Two or three coordinates to draw: M_1,M_2, NAME=FORMULA, andoyer:l,L,H.",
        "A,B[,C]",
    ),
    "within": ("Count only points with |QUANTITY| < WIDTH.", "QUANTITY<WIDTH"),
    "points": ("Number of points of each motion.",),
    # chaplygin show
    "form": (
        "text, latex, julia, c, toml (the experiment file), javascript (a module that computes "
        "motions) or wasm (its machine code).",
        "",
        "--as",
    ),
    "laws": ("Print only the known laws of the system.",),
    # chaplygin solve
    "solve output": ("File to write: .nc, .zarr or .csv.", "", "-o --output"),
    "solve figure": ("Figure of the closed form: .png, .svg or .pdf.",),
    "solve at": ("Times, such as 0,1,1e6; default: those of the experiment.", "TIMES"),
    "digits": ("Evaluate rigorously to this many digits, with error bounds.",),
    # chaplygin study
    "study output": ("Folder to write; default: named after NAME|FILE.", "FOLDER", "-o --output"),
    "study effort": (
        "Work allowed for the proof of one law, in the units of prove --effort; default 0.05. All"
        " proofs together may take four times as much.",
        "FACTOR",
    ),
    "quick": ("Skip the proofs; laws are only observed.",),
    # chaplygin sweep
    "sweep output": ("Zarr store to write.", "FILE.zarr", "-o --output"),
    "sweep draw": ("Variable to draw: M_3, theta; default: the first of the state.", "NAME"),
    "sweep over": (
        "A parameter and its values: m=1,1.5,2, or m=1:2:5 for five from 1 to 2. Given several "
        "times: every combination.",
        "NAME=VALUES",
    ),
}

#: Parameters that are written without a flag.
_ARGUMENTS = ("what", "kind")
#: Allowed words of an option.
WORDS: dict[str, tuple[str, ...]] = {
    "kind": ("integrals", "measure", "symmetries"),
    "contact": ("marble", "rubber", "none"),
    "device": ("cpu", "gpu"),
    "direction": ("rising", "falling", "both"),
    "form": ("text", "latex", "julia", "c", "toml", "javascript", "wasm"),
    "precision": ("double", "quad"),
}
#: Smallest and largest value of an option.
BOUNDS: dict[str, tuple[float, float]] = {
    "tolerance": (1e-16, 0.1),
    "points": (1, inf),
    "starts": (1, inf),
    "after": (0, inf),
    "period": (1, inf),
    "degree": (0, inf),
    "gamma_degree": (0, inf),
    "power": (0, inf),
    "parameter_degree": (0, inf),
    "rate": (1, 120),
    "width": (64, 7680),
    "height": (64, 4320),
}
#: Options that are times.
TIMES = ("until",)


def with_options(name: str, command: Callable[..., None]) -> Callable[..., None]:
    """Function of a command, with its parameters annotated for Typer from the table."""
    hints = get_type_hints(command, include_extras=True)
    command.__annotations__ = {
        parameter: hint
        if parameter == "return" or get_origin(hint) is Annotated
        else Annotated[hint, _parameter(name, parameter)]
        for parameter, hint in hints.items()
    }
    return command


def _parameter(command: str, name: str) -> Any:
    words = OPTIONS.get(f"{command} {name}") or OPTIONS[name]
    text, metavar, flags = (*words, "", "")[:3]
    if name in _ARGUMENTS:
        return typer.Argument(metavar=metavar, help=text, callback=_check)
    flags = flags or f"--{name.replace('_', '-')}"
    return typer.Option(*flags.split(), metavar=metavar or None, help=text, callback=_check)


def _check(option: typer.CallbackParam, value: Any) -> Any:
    """Value of an option; InputError if it is not allowed, before other modules are imported."""
    name, wanted = str(option.name), ""
    words, (least, largest) = WORDS.get(name, ()), BOUNDS.get(name, (-inf, inf))
    if words and value is not None and value not in words:
        wanted = f"one of {', '.join(words)}" if len(words) > 2 else " or ".join(words)
    elif name in BOUNDS and not least <= value <= largest:
        wanted = f"at least {least:g}" if largest == inf else f"from {least:g} to {largest:g}"
    elif name in TIMES and value is not None and not 0 < value < inf:
        wanted = "positive and finite"
    if wanted:
        from flowlanes.errors import InputError

        place = option.metavar if option.param_type_name == "argument" else option.opts[-1]
        raise InputError(f"{place} {value}: it must be {wanted}")
    return value

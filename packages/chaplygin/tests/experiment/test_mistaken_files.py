"""Mistakes in experiment files: each is one clear sentence."""

# ruff: noqa: E501
from __future__ import annotations

from pathlib import Path

import pytest

from asking import Ask, ask

__all__ = ["ask"]

EXAMPLES = Path(__file__).parents[4] / "examples"
BALL = """\
[body]
mass = 1.0
inertia = [1.0, 1.2, 1.5]
[body.shape]
kind = "ball"
radius = 1.0
[start]
gamma = [0, 0, 1]
omega = [1, 0, 0]
"""
SYS = '[system]\nname = "chaplygin-ball"\n'
FREE = '[frame]\ncoordinates = ["x", "y"]\n[lagrangian]\nkinetic = "(xdot**2 + ydot**2)/2"\n'
DISK, SURF, TRAILER, SUS, VOLT = (
    (EXAMPLES / f"{name}.toml").read_text()
    for name in ("coin", "ball_on_waves", "trailer", "suslov_problem", "volterra")
)


def r(text: str, old: str, new: str) -> str:
    """The text with something else in one place."""
    assert old in text
    return text.replace(old, new, 1)


MISTAKES: list[tuple[str, str | bytes]] = [
    ("empty", ""),
    ("only comment", "# nothing\n"),
    ("binary", b"\x89PNG\r\n\x1a\n\x00\x00\xff\xfe"),
    ("binary zeros", b"\x00" * 100),
    ("json", '{"body": {"mass": 1}}'),
    ("yaml", "body:\n  mass: 1\n"),
    ("utf16", BALL.encode("utf-16")),
    ("nested array", r(BALL, "inertia = [1.0, 1.2, 1.5]", "inertia = [[1.0, 1.2, 1.5]]")),
    ("2x2 inertia", r(BALL, "[1.0, 1.2, 1.5]", "[[1.0, 0],[0, 1.5]]")),
    ("inertia string", r(BALL, "[1.0, 1.2, 1.5]", '"[1,2,3]"')),
    ("inertia mixed", r(BALL, "[1.0, 1.2, 1.5]", '[1, "2", true]')),
    ("inertia asymmetrical", r(BALL, "[1.0, 1.2, 1.5]", "[[1,0.1,0],[0,1,0],[0,0,1]]")),
    ("inertia triangle", r(BALL, "[1.0, 1.2, 1.5]", "[1,1,3]")),
    ("mass with unit", r(BALL, "mass = 1.0", 'mass = "1 kg"')),
    ("mass bare unit", r(BALL, "mass = 1.0", "mass = 1 kg")),
    ("comma number", r(BALL, "mass = 1.0", "mass = 1,0")),
    ("mass nan", r(BALL, "mass = 1.0", "mass = nan")),
    ("mass -0", r(BALL, "mass = 1.0", "mass = -0.0")),
    ("mass bool", r(BALL, "mass = 1.0", "mass = true")),
    ("mass date", r(BALL, "mass = 1.0", "mass = 2024-01-01")),
    ("mass table", r(BALL, "mass = 1.0", "mass = {value = 1.0}")),
    ("body twice", BALL + "[body]\nmass = 2\n"),
    ("key twice", r(BALL, "mass = 1.0", "mass = 1.0\nmass = 2.0")),
    ("body array of tables", r(BALL, "[body]", "[[body]]")),
    (
        "shape as string",
        '[body]\nmass=1\ninertia=[1,1,1]\nshape="ball"\n[start]\ngamma=[0,0,1]\nomega=[0,0,1]\n',
    ),
    ("shape cube", r(BALL, '"ball"', '"cube"')),
    ("shape kind missing", r(BALL, 'kind = "ball"\n', "")),
    ("shape Ball capital", r(BALL, '"ball"', '"Ball"')),
    ("radius negative", r(BALL, "radius = 1.0", "radius = -1")),
    ("no radius", r(BALL, "radius = 1.0\n", "")),
    ("no start", BALL.split("[start]", maxsplit=1)[0]),
    ("gamma zero", r(BALL, "gamma = [0, 0, 1]", "gamma = [0,0,0]")),
    ("gamma 2", r(BALL, "gamma = [0, 0, 1]", "gamma = [0,1]")),
    ("gamma dict", r(BALL, "gamma = [0, 0, 1]", "gamma = {x=0,y=0,z=1}")),
    ("omega nan", r(BALL, "omega = [1, 0, 0]", "omega = [nan,0,1]")),
    ("omega scalar", r(BALL, "omega = [1, 0, 0]", "omega = 3")),
    ("surface cube", BALL + '[surface]\nkind = "table"\n'),
    ("surface sphere no radius", BALL + '[surface]\nkind = "sphere"\n'),
    ("sphere radius negative", BALL + '[surface]\nkind = "sphere"\nradius=-2.0\n'),
    ("bowl too small", BALL + '[surface]\nkind = "sphere"\nradius=0.5\nside = "inside"\n'),
    ("bowl same size", BALL + '[surface]\nkind = "sphere"\nradius=1.0\nside = "inside"\n'),
    ("surface string", 'surface = "plane"\n' + BALL),
    ("contact string", 'contact = "marble"\n' + BALL),
    ("contact model", BALL + '[contact]\nmodel = "sliding"\n'),
    (
        "rubber spin",
        r(BALL, "omega = [1, 0, 0]", "omega = [1,0,1]") + '[contact]\nmodel="rubber"\n',
    ),
    ("gravity vector", BALL + "[field]\ngravity = [0,0,-9.81]\n"),
    ("gravity negative", BALL + "[field]\ngravity = -9.81\n"),
    ("potential unknown", BALL + '[field]\npotential = "k*gamma_3"\n'),
    ("potential syntax", BALL + '[field]\npotential = "gamma_3 +"\n'),
    ("potential python", BALL + "[field]\npotential = \"__import__('os')\"\n"),
    ("potential number", BALL + "[field]\npotential = 3\n"),
    ("potential caret", BALL + '[field]\npotential = "gamma_3^2"\n'),
    ("potential div0", BALL + '[field]\npotential = "1/(gamma_1 - gamma_1)"\n'),
    ("potential singular at start", BALL + '[field]\npotential = "log(gamma_1)"\n'),
    ("param str", BALL + '[field]\npotential = "a*gamma_3"\nparameters = {a = "x"}\n'),
    ("param name taken", BALL + '[field]\npotential = "m*gamma_3"\nparameters = {m = 3}\n'),
    ("param name pi", BALL + '[field]\npotential = "pi*gamma_3"\nparameters = {pi = 3}\n'),
    ("run until neg", BALL + "[run]\nuntil = -1\n"),
    ("run until inf", BALL + "[run]\nuntil = inf\n"),
    ("run until str", BALL + '[run]\nuntil = "10 s"\n'),
    ("samples 1", BALL + "[run]\nsamples = 1\n"),
    ("samples float", BALL + "[run]\nsamples = 10.5\n"),
    ("samples huge", BALL + "[run]\nsamples = 100000000000\n"),
    ("tolerance 0", BALL + "[run]\ntolerance = 0\n"),
    ("tolerance 1e-30", BALL + "[run]\ntolerance = 1e-30\n"),
    ("precision", BALL + '[run]\nprecision = "half"\n'),
    ("method rk4", BALL + '[run]\nmethod = "rk4"\n'),
    ("direction", BALL + '[run]\ndirection = "up"\n'),
    ("keep str", BALL + '[run]\nkeep_integrals = "yes"\n'),
    ("run typo", BALL + "[run]\nuntill = 3\n"),
    ("table typo", BALL + "[rnu]\nuntil = 3\n"),
    ("top level key", "mass = 3\n" + BALL),
    ("system and body", BALL + SYS),
    ("system unknown", '[system]\nname = "chaplygin-bal"\n'),
    ("system no name", "[system]\n"),
    ("system name num", "[system]\nname = 3\n"),
    ("system empty name", '[system]\nname = ""\n'),
    ("system param unknown", SYS + "parameters = {J = 3}\n"),
    ("system param str", SYS + 'parameters = {I_1 = "2"}\n'),
    ("system surface", SYS + '[surface]\nkind="plane"\n'),
    ("system start unknown", SYS + "[start]\nM=[1,2,3]\n"),
    ("state start unknown", '[system]\nname = "smooth-disk"\n[start]\nomega=[1,2,3]\n'),
    ("state start wrong length", '[system]\nname = "smooth-disk"\n[start]\nM=[1,2]\n'),
    ("state start scalar", '[system]\nname = "smooth-disk"\n[start]\nM=1\n'),
    ("system str", 'system = "chaplygin-ball"\n'),
    ("disk flat", r(DISK, "gamma = [0.9, 0.0, 0.435]", "gamma = [0,0,1]")),
    ("ellipsoid axes", r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="ellipsoid"\naxes=[1,2]')),
    ("ellipsoid neg", r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="ellipsoid"\naxes=[1,2,-1]')),
    (
        "torus tube too big",
        r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="torus"\nradius=1\ntube=-2'),
    ),
    ("revolution nothing", r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="revolution"')),
    (
        "revolution both",
        r(
            BALL,
            'kind = "ball"\nradius = 1.0',
            'kind="revolution"\nsupport="1"\nchi_1="1"\nchi_2="gamma_3"',
        ),
    ),
    (
        "revolution concave",
        r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="revolution"\nsupport="1+gamma_3**4*5"'),
    ),
    (
        "revolution misnamed",
        r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="revolution"\nsupport="1+x"'),
    ),
    ("implicit open", r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="implicit"\nsurface="x+y+z-1"')),
    (
        "implicit empty",
        r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="implicit"\nsurface="x**2+y**2+z**2+1"'),
    ),
    (
        "implicit equation =",
        r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="implicit"\nsurface="x**2+y**2+z**2=1"'),
    ),
    (
        "implicit inside out",
        r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="implicit"\nsurface="1-x**2-y**2-z**2"'),
    ),
    (
        "implicit centre outside",
        r(BALL, 'kind = "ball"\nradius = 1.0', 'kind="implicit"\nsurface="(x-5)**2+y**2+z**2-1"'),
    ),
    ("shape extra key", r(BALL, "radius = 1.0", "radius = 1.0\naxes=[1,1,1]")),
    ("surf not homogeneous", r(SURF, "[0.036, 0.036, 0.036]", "[0.036, 0.036, 0.037]")),
    ("surf off", r(SURF, "contact = [0.0, 0.0, 0.25]", "contact = [0.0,0.0,1.25]")),
    (
        "surf both",
        r(SURF, "contact = [0.0, 0.0, 0.25]", "contact = [0.0,0.0,0.25]\ncentre=[0,0,1]"),
    ),
    ("surf gamma", r(SURF, "contact = [0.0, 0.0, 0.25]", "gamma = [0.0,0.0,0.25]")),
    ("surf unknown param", r(SURF, "parameters = { h = 0.25 }", "")),
    ("surf not fit", r(SURF, "radius = 0.3", "radius = 30")),
    ("surf kind", r(SURF, '"implicit"', '"hyperboloid"')),
    ("surf disk", r(SURF, 'kind = "ball"', 'kind = "disk"')),
    ("surf direction zero", r(SURF, "gravity = 9.81", "gravity = 9.81\ndirection=[0,0,0]")),
    ("surf side", r(SURF, 'kind = "implicit"', 'kind = "implicit"\nside="left"')),
    ("surf axis", r(SURF, 'kind = "implicit"', 'kind = "implicit"\naxis="w"')),
    ("lagr no frame", '[lagrangian]\nkinetic="xdot**2/2"\n[start]\nx=1\n'),
    ("lagr empty", '[frame]\ncoordinates=["x"]\n[lagrangian]\n[start]\nx=0\nxdot=1\n'),
    (
        "kinetic quad missing",
        '[frame]\ncoordinates=["x"]\n[lagrangian]\nkinetic="x"\n[start]\nx=0\nxdot=1\n',
    ),
    (
        "kinetic neg",
        '[frame]\ncoordinates=["x"]\n[lagrangian]\nkinetic="-xdot**2/2"\n[start]\nx=0\nxdot=1\n',
    ),
    (
        "coord twice",
        '[frame]\ncoordinates=["x","x"]\n[lagrangian]\nkinetic="xdot**2/2"\n[start]\nx=0\nxdot=1\n',
    ),
    (
        "coord number",
        '[frame]\ncoordinates=[1]\n[lagrangian]\nkinetic="xdot**2/2"\n[start]\nx=0\nxdot=1\n',
    ),
    (
        "coord string",
        '[frame]\ncoordinates="x"\n[lagrangian]\nkinetic="xdot**2/2"\n[start]\nx=0\nxdot=1\n',
    ),
    (
        "coord reserved",
        '[frame]\ncoordinates=["sin"]\n[lagrangian]\nkinetic="sindot**2/2"\n[start]\nsin=0\nsindot=1\n',
    ),
    (
        "coord t",
        '[frame]\ncoordinates=["t"]\n[lagrangian]\nkinetic="tdot**2/2"\n[start]\nt=0\ntdot=1\n',
    ),
    (
        "coord lambda",
        '[frame]\ncoordinates=["lambda"]\n[lagrangian]\nkinetic="lambdadot**2/2"\n[start]\nlambda=0\nlambdadot=1\n',
    ),
    (
        "constraint constant",
        '[frame]\ncoordinates=["x"]\n[lagrangian]\nkinetic="xdot**2/2"\n[constraints]\nvelocity=["1"]\n[start]\nx=0\nxdot=1\n',
    ),
    (
        "constraint twice",
        '[frame]\ncoordinates=["x","y"]\n[lagrangian]\nkinetic="(xdot**2+ydot**2)/2"\n[constraints]\nvelocity=["xdot","2*xdot"]\n[start]\nx=0\ny=0\nydot=1\n',
    ),
    (
        "constraint all",
        '[frame]\ncoordinates=["x"]\n[lagrangian]\nkinetic="xdot**2/2"\n[constraints]\nvelocity=["xdot"]\n[start]\nx=0\n',
    ),
    (
        "constraint string",
        '[frame]\ncoordinates=["x","y"]\n[lagrangian]\nkinetic="(xdot**2+ydot**2)/2"\n[constraints]\nvelocity="xdot"\n[start]\nx=0\ny=0\nydot=1\n',
    ),
    (
        "plan 3 of 4",
        r(
            TRAILER,
            '[plan]\nlinks = [["x", "y", "x - l*cos(psi)", "y - l*sin(psi)"]]',
            '[plan]\nlinks = [["x", "y", "x - l*cos(psi)"]]',
        ),
    ),
    ("plan unknown key", r(TRAILER, "[plan]\n", '[plan]\nwheel = [["x","y","phi"]]\n')),
    ("plan numbers", r(TRAILER, "[plan]\n", "[plan]\nwheels = [[0, 0, 1]]\n")),
    ("plan flat", r(TRAILER, "[plan]\n", '[plan]\nwheels = ["x","y","phi"]\n')),
    ("plan path 3", r(TRAILER, "[plan]\n", '[plan]\npath = ["x","y","phi"]\n')),
    ("param nan", r(TRAILER, "m = { value = 1.0", "m = { value = nan")),
    ("param unused key", r(TRAILER, "m = { value = 1.0", "m = { valu = 1.0")),
    ("param unit number", r(TRAILER, 'unit = "kg"', "unit = 3")),
    ("frame rates cyclic", r(TRAILER, 'phi = "Omega"', 'phi = "Omega + phi_dot"')),
    ("frame rates nonlinear", r(TRAILER, 'phi = "Omega"', 'phi = "Omega**2"')),
    ("suslov structure", r(SUS, '"rotations(omega)"', '"rotation(omega)"')),
    ("suslov diag", r(SUS, "diagonal = [1.0, 1.6, 2.2]", "diagonal = [1.0, 1.6]")),
    ("suslov dot", r(SUS, '"dot(P, gamma)"', '"dot(P)"')),
    ("suslov vector lagr", r(SUS, '"dot(P, gamma)"', '"P"')),
    ("volterra rate missing", r(VOLT, 'state = ["x", "y", "z"]', 'state = ["x", "y", "z", "w"]')),
    ("volterra empty", "[equations]\nstate = []\nrates = {}\n[start]\n"),
    (
        "equations rate of unknown",
        '[equations]\nstate = ["x"]\nrates = {x = "x", y = "x"}\n[start]\nx=1\n',
    ),
    (
        "equations with start singular",
        '[equations]\nstate = ["x"]\nrates = {x = "1/x"}\n[start]\nx=0\n',
    ),
    ("equations start missing", '[equations]\nstate = ["x"]\nrates = {x = "x"}\n'),
    (
        "equations laws bad",
        '[equations]\nstate = ["x"]\nrates = {x = "x"}\n[laws.integrals]\ne = "q"\n[start]\nx=1\n',
    ),
    (
        "equations laws kind",
        '[equations]\nstate = ["x"]\nrates = {x = "x"}\n[laws.energy]\ne = "x"\n[start]\nx=1\n',
    ),
    ("guards", '[equations]\nstate = ["x"]\nrates = {x = "x"}\n[guards]\ne = "x"\n[start]\nx=1\n'),
    (
        "guard neg at start",
        '[equations]\nstate = ["x"]\nrates = {x = "x"}\n[guards.e]\nvalue = "x - 2"\nmessage = "it falls"\n[start]\nx=1\n',
    ),
    (
        "both equations and lagrangian",
        '[equations]\nstate = ["x"]\nrates = {x = "x"}\n[lagrangian]\nL="x"\n[start]\nx=1\n',
    ),
    (
        "L and kinetic",
        '[frame]\ncoordinates=["x"]\n[lagrangian]\nL="xdot**2"\nkinetic="xdot**2/2"\n[start]\nx=0\nxdot=1\n',
    ),
    ("deep nesting", "x = " + "[" * 500 + "]" * 500),
    ("only title", 'title = "hallo"\n'),
    ("title number", "title = 3\n" + BALL),
    ("mass in per cent", r(BALL, "mass = 1.0", "mass = 10%")),
    ("mass without zero", r(BALL, "mass = 1.0", "mass = .5")),
    ("mass fraction", r(BALL, "mass = 1.0", "mass = 1/2")),
    ("mass half exponent", r(BALL, "mass = 1.0", "mass = 1e")),
    ("inertia semicolons", r(BALL, "[1.0, 1.2, 1.5]", "[1,0; 1,2; 1,5]")),
    ("products of inertia", r(BALL, "[1.0, 1.2, 1.5]", "[1.0, 1.2, 1.5]\nproducts = [0, 0, 0]")),
    ("ragged inertia", r(BALL, "[1.0, 1.2, 1.5]", "[[1, 0, 0], [0, 1, 0], [0, 0]]")),
    ("quotes of a word processor", r(BALL, '"ball"', "“ball”")),
    ("lines of an old Macintosh", BALL.replace("\n", "\r")),
    ("until in minutes", BALL + '[run]\nuntil = "1 min"\n'),
    ("samples beyond memory", BALL + "[run]\nsamples = 100000000000\n"),
    ("precision misspelt", BALL + '[run]\nprecision = "quadruple"\n'),
    ("contact that sticks", BALL + '[contact]\nmodel = "sticky"\n'),
    ("friction below zero", BALL + '[contact]\nmodel = "friction"\nmu = -0.3\n'),
    ("friction in quotes", BALL + '[contact]\nmodel = "friction"\nmu = "0.3"\n'),
    ("sphere of radius below zero", BALL + '[surface]\nkind = "sphere"\nradius = -2\n'),
    ("sphere with inside", BALL + '[surface]\nkind = "sphere"\nradius = 2\ninside = true\n'),
    ("surface saddle", BALL + '[surface]\nkind = "saddle"\n'),
    ("gravity vector", BALL + "[field]\ngravity = [0, 0, -9.81]\n"),
    ("potential equation", BALL + '[field]\npotential = "U = gamma_3"\n'),
    ("potential program", BALL + '[field]\npotential = "lambda x: x"\n'),
    ("potential list", BALL + '[field]\npotential = ["gamma_3"]\n'),
    ("potential caret", BALL + '[field]\npotential = "gamma_3^2"\n'),
    ("potential in LaTeX", BALL + "[field]\npotential = '\\gamma_3'\n"),
    ("parameter pi", BALL + '[field]\npotential = "pi*gamma_3"\nparameters = {pi = 3}\n'),
    ("start attitude", BALL + "attitude = [1, 0, 0, 0]\n"),
    ("constraint on place", f'{FREE}[constraints]\nvelocity = ["x - y"]\n[start]\nx = 0\n'),
    ("constraint twice", f'{FREE}[constraints]\nvelocity = ["xdot", "2*xdot"]\n[start]\nx = 0\n'),
    ("kinetic energy linear", r(FREE, "(xdot**2 + ydot**2)/2", "xdot") + "[start]\nx = 0\n"),
    ("coordinate twice", r(FREE, '"x", "y"', '"x", "x"') + "[start]\nx = 0\n"),
    ("coordinate lambda", r(FREE, '"x", "y"', '"x", "y", "lambda"') + "[start]\nx = 0\n"),
    ("parameter without value", FREE + '[parameters]\nm = {unit = "kg"}\n[start]\nx = 0\n'),
    ("rate that is a number", '[equations]\nstate = ["x"]\nrates = {x = 1}\n[start]\nx = 1\n'),
    ("system list", 'system = ["veselova"]\n'),
    ("system parameter in words", SYS + "parameters = {I_1 = 'big'}\n"),
]


@pytest.mark.parametrize(("name", "text"), MISTAKES, ids=[name for name, _ in MISTAKES])
def test_one_sentence(name: str, text: str | bytes, ask: Ask) -> None:
    Path("mine.toml").write_bytes(text if isinstance(text, bytes) else text.encode())
    code, out, err = ask("run", "mine.toml", "-o", "mine.nc")
    said = [line for line in err.splitlines() if not line.endswith("…")]
    assert (code, out) == (2, "")
    assert said[0].startswith("error: mine.toml")
    # further mistakes have a line of their own, and a formula its excerpt
    assert all(line.startswith(("mine.toml", "    ")) for line in said[1:])
    assert not Path("mine.nc").exists()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (BALL + "[body]\nmass = 2\n", "Cannot declare body twice"),
        (r(BALL, "[body]", "[[body]]"), "not several tables, which [[...]] makes"),
        (
            r(BALL, "mass = 1.0", "mass = -1,5 # kg"),
            "line 2: not valid TOML: Expected newline or end of document after a statement "
            "(column 10); a decimal number has a point: -1.5",
        ),
        (
            BALL + '[field]\npotential = "K*gamma_1"\n',
            "sqrt, tan, tanh; [field.parameters] declares names of your own\n",
        ),
        (
            r(SURF, "h * cos(x)", "H * cos(x)"),
            "; [surface.parameters] declares names of your own\n",
        ),
        (
            r(DISK, 'kind = "disk"\nradius = 0.012875', 'kind = "revolution"\nsupport = "b"'),
            "; [body.shape.parameters] declares names of your own\n",
        ),
        (
            '[frame]\ncoordinates = ["x"]\n[lagrangian]\nkinetic = "M*xdot**2/2"\n[start]\nx = 0\n',
            "; [parameters] declares names of your own\n",
        ),
        (
            BALL + '[field]\npotential = "log(gamma_1)"\n',
            "normal_force is nan there; a formula divides by zero, or takes a root",
        ),
        (
            '[frame]\ncoordinates=["x"]\n[lagrangian]\nkinetic="-xdot**2/2"\n'
            "[start]\nx=0\nxdot=1\n",
            "line 3, lagrangian: the kinetic energy is negative",
        ),
        (
            '[frame]\ncoordinates=["x"]\n[lagrangian]\nkinetic="xdot**2/2"\n'
            '[constraints]\nvelocity=["xdot"]\n[start]\nx=0\n',
            "line 5, constraints: the constraints leave nothing free to move",
        ),
        (
            '[equations]\nstate = ["x"]\nrates = {x = "1/x"}\n[start]\nx=0\n',
            "line 4, start: the rate of the state is no number there; a formula div",
        ),
        (
            r(BALL, "omega = [1, 0, 0]", "omega = [1e30, 0, 0]"),
            "the rate of the state is no number there; M_1 = 2e+30 is too far from 1 to compute",
        ),
        (
            '[equations]\nstate = ["x"]\nrates = {x = "x"}\n[guards]\ne = "x"\n[start]\nx=1\n',
            'guards.e: must be a table with value and message, not the text "x"',
        ),
        (
            '[system]\nname = "suslov-nd"\ndimension = [4]\n',
            "line 3, system.dimension: must be a whole number from 3 to 9, not [4.0]",
        ),
        (
            '[system]\nname = "suslov-nd"\n[parameters]\ndimension = 2\n',
            "line 4, parameters.dimension: must be a whole number from 3 to 9, not 2",
        ),
        (
            '[system]\nname = "chaplygin-ball-nd"\nmass = -1\n',
            "line 3, system.mass: mass -1.0: it must be a positive finite number",
        ),
        (
            '[system]\nname = "suslov-nd"\n[start]\nM = [1, 2, 3]\n',
            "line 4, start.M: M_1: follows from the others",
        ),
    ],
)
def test_the_cause_and_its_place(text: str, words: str, ask: Ask) -> None:
    Path("mine.toml").write_text(text)
    code, _, err = ask("run", "mine.toml", "-o", "mine.nc")
    assert code == 2
    assert words in err
    assert not Path("mine.nc").exists()

"""Mistakes on the command line: each is one clear sentence, and changes nothing."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest

from asking import Ask, ask

__all__ = ["ask"]

MISTAKES = r"""
nosuch
--nosuch
-v
run
run chaplygin-ball
run chaplygin-ball -o
run -o a.nc
run chaplygin-ball a.nc
run chaplygin-ball -o a.nc extra
run chaplygin-bal -o a.nc
run Chaplygin-Ball -o a.nc
run "" -o a.nc
run none.toml -o a.nc
run none.py -o a.nc
run . -o a.nc
run chaplygin-ball -o ""
run chaplygin-ball -o .
run chaplygin-ball -o a
run chaplygin-ball -o a.txt
run chaplygin-ball -o no/a.nc
run chaplygin-ball -o exists.nc
run chaplygin-ball -o dir.nc
run chaplygin-ball -o dir.nc --force
run chaplygin-ball -o /dev/null/a.nc
run chaplygin-ball -o a.nc --precision triple
run chaplygin-ball -o a.nc --precision
run chaplygin-ball -o a.nc --set
run chaplygin-ball -o a.nc --set run.until
run chaplygin-ball -o a.nc --set =3
run chaplygin-ball -o a.nc --set run.until=
run chaplygin-ball -o a.nc --set run.until=[
run chaplygin-ball -o a.nc --set run.until=-3
run chaplygin-ball -o a.nc --set run..until=3
run chaplygin-ball -o a.nc --set I_7=3
run chaplygin-ball -o a.nc --set run=3
run chaplygin-ball -o a.nc --set start.gamma=[0,0]
run chaplygin-ball -o a.nc --set start.gamma=0,0,1
run chaplygin-ball -o a.nc --set start.omega=(1,2,3)
run chaplygin-ball -o a.nc --force=yes
run chaplygin-ball -o a.nc --tolerance 1e-3
run chaplygin-ball -o - --json
list chaplygin
list --contact sliding
list --section two
list --section 40
list --section -1
list --contact
show
show chaplygin-ball --as pdf
show chaplygin-ball --as
show chaplygin-ball veselova
show chaplygin-ball --json=1
show chaplygin-ball -o a.txt
show chaplygin-ball --laws --as c
study
study chaplygin-ball -o file.txt --quick
study chaplygin-ball -o s --effort 0
study chaplygin-ball -o s --effort much
study chaplygin-ball -o s --effort -1
study chaplygin-ball -o s --effort nan
study chaplygin-ball --quick --effort 1 -o s
solve chaplygin-ball --at
solve chaplygin-ball --at now
solve chaplygin-ball --at 1;2
solve chaplygin-ball --at 1,,2
solve chaplygin-ball --at nan
solve chaplygin-ball --at 1e400
solve chaplygin-ball --digits -3
solve chaplygin-ball --digits many
solve chaplygin-ball --digits 1000000000
solve chaplygin-ball -o a.txt
solve chaplygin-ball --figure a.txt
solve chaplygin-ball --figure no/a.png
find
find integrals
find chaplygin-ball
find integral chaplygin-ball
find all chaplygin-ball
find integrals chaplygin-ball --degree -1
find integrals chaplygin-ball --degree 1000
find integrals chaplygin-ball --degree two
find integrals chaplygin-ball --momenta q
find integrals chaplygin-ball --coordinates M
find integrals chaplygin-ball --at k
find integrals chaplygin-ball --at I_1=x
find integrals chaplygin-ball --on "M."
find integrals chaplygin-ball --denominator 0
find integrals chaplygin-ball --denominator "q"
find integrals chaplygin-ball --power -2
find integrals chaplygin-ball --effort 0
find measure chaplygin-ball --parameter-degree -1
prove chaplygin-ball --law enrgy
prove chaplygin-ball --law energy --effort -1
prove chaplygin-ball --law energy --certificate no/a.json
prove chaplygin-ball --law energy --certificate file.txt
prove none.toml
ensemble chaplygin-ball -o a.nc
ensemble chaplygin-ball -o a.zarr --starts 0
ensemble chaplygin-ball -o a.zarr --starts -5
ensemble chaplygin-ball -o a.zarr --starts 3
ensemble chaplygin-ball -o a.zarr --starts 3 --level energy
ensemble chaplygin-ball -o a.zarr --starts 3 --level energy=x
ensemble chaplygin-ball -o a.zarr --starts 3 --level enrgy=1
ensemble chaplygin-ball -o a.zarr --starts 3 --level energy=-1
ensemble chaplygin-ball -o a.zarr --over I_1
ensemble chaplygin-ball -o a.zarr --over I_1=1:2
ensemble chaplygin-ball -o a.zarr --over I_1=1:2:0
ensemble chaplygin-ball -o a.zarr --over I_1=1:2:2.5
ensemble chaplygin-ball -o a.zarr --over q=1:2:3
ensemble chaplygin-ball -o a.zarr --over I_1=-1:2:3
ensemble chaplygin-ball -o a.zarr --record q
ensemble chaplygin-ball -o a.zarr --tolerance 0
ensemble chaplygin-ball -o a.zarr --tolerance x
ensemble chaplygin-ball -o a.zarr --workers 0
ensemble chaplygin-ball -o a.zarr --workers many
ensemble chaplygin-ball -o a.zarr --workers -2
ensemble chaplygin-ball -o foreign.zarr
ensemble chaplygin-ball -o a.zarr --seed x
ensemble chaplygin-ball -o a.zarr --seed -1 --starts 2 --level energy=2
sweep chaplygin-ball -o a.zarr
sweep chaplygin-ball --over I_1=1,2
sweep chaplygin-ball --over I_1= -o a.zarr
sweep chaplygin-ball --over I_1=1,x -o a.zarr
sweep chaplygin-ball --over I_1=1,,2 -o a.zarr
sweep chaplygin-ball --over I_1=1:2:1 -o a.zarr
sweep chaplygin-ball --over I_1=1:2:1e9 -o a.zarr
sweep chaplygin-ball --over I_1=1,2 --over I_1=3,4 -o a.zarr
sweep chaplygin-ball --over I_1=1,2 --draw q -o a.zarr
sweep chaplygin-ball --over I_1=1,2 --figure a.txt -o a.zarr
sweep chaplygin-ball --over I_1=1,200 -o a.zarr
sweep chaplygin-ball --over I_1=1,1 -o a.zarr
sweep chaplygin-ball --over I_1=1,inf -o a.zarr
sweep chaplygin-ball-nd --over dimension=3,4 -o a.zarr
ensemble chaplygin-ball-nd --over dimension=3:4:2 -o a.zarr
ensemble chaplygin-ball --over I_1=1:1.1:3 --workers 100000 -o a.zarr
section chaplygin-ball -o a.zarr
section chaplygin-ball --on gama_3 -o a.zarr
section chaplygin-ball --on "gamma_3 +" -o a.zarr
section chaplygin-ball --on "m" -o a.zarr
section chaplygin-ball --on "3" -o a.zarr
section chaplygin-ball --on gamma_3 -o a.txt
section chaplygin-ball --on gamma_3 --direction up -o a.zarr
section chaplygin-ball --on gamma_3 --value x -o a.zarr
section chaplygin-ball --on gamma_3 --value nan -o a.zarr
section chaplygin-ball --on gamma_3 --within M_3 -o a.zarr
section chaplygin-ball --on gamma_3 --within "M_3<x" -o a.zarr
section chaplygin-ball --on gamma_3 --within "M_3<-1" -o a.zarr
section chaplygin-ball --on gamma_3 --points 0 -o a.zarr
section chaplygin-ball --on gamma_3 --points -5 -o a.zarr
section chaplygin-ball --on gamma_3 --starts 0 -o a.zarr
section chaplygin-ball --on gamma_3 --coordinates M_1 -o a.zarr
section chaplygin-ball --on gamma_3 --coordinates M_1,M_2,M_3,gamma_1 -o a.zarr
section chaplygin-ball --on gamma_3 --coordinates M_1,q -o a.zarr
section chaplygin-ball --on gamma_3 --coordinates andoyer -o a.zarr
section chaplygin-ball --on gamma_3 --coordinates andoyer:q,w -o a.zarr
section chaplygin-ball --on gamma_3 --until -1 -o a.zarr
section chaplygin-ball --on gamma_3 --level energy=x -o a.zarr
section chaplygin-ball --on gamma_3 --tolerance 2 -o a.zarr
orbit chaplygin-ball
orbit chaplygin-ball --on q
orbit chaplygin-ball --on gamma_3 --after -1
orbit chaplygin-ball --on gamma_3 --period 0
orbit chaplygin-ball --on gamma_3 --hold q
orbit chaplygin-ball --on gamma_3 --follow q=1
orbit chaplygin-ball --on gamma_3 --follow I_1
orbit chaplygin-ball --on gamma_3 --follow I_1=x
orbit chaplygin-ball --on gamma_3 -o a.txt
orbit chaplygin-ball --on gamma_3 --figure a.doc
orbit chaplygin-ball --on gamma_3 --tolerance 5
bifurcation
bifurcation rattleback
bifurcation nosuch
bifurcation veselova -o a.txt
bifurcation veselova -o no/a.png
bifurcation veselova --set I_1=-2
lyapunov chaplygin-ball --until 0
lyapunov chaplygin-ball --until -1
lyapunov chaplygin-ball --until x
lyapunov chaplygin-ball --until 1e300
lyapunov chaplygin-ball --level q=1
lyapunov chaplygin-ball --tolerance 0
lyapunov chaplygin-ball -o a.csv
lyapunov chaplygin-ball --until nan
chart chaplygin-ball --of lyapunov --x "I_1=1:0:5" -o a.zarr
chart chaplygin-ball --of lyapunov --x "a=1:2:2" --y "b=1:2:2" -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:2" --y "I_2=1:2:2" -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1" --y "I_2=1:2:2" -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:2:0" --y "I_2=1:2:2" -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:2:1.5" --y "I_2=1:2:2" -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:1:3" --y "I_2=1:2:2" -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:2:3" --y "I_1=1:2:2" -o a.zarr
chart chaplygin-ball --of lyapunv --x "I_1=1:2:3" --y "I_2=1:2:2" -o a.zarr
chart chaplygin-ball --of "mean:" --x "I_1=1:2:3" --y "I_2=1:2:2" -o a.zarr
chart chaplygin-ball --of "mean:q" --x "I_1=1:2:3" --y "I_2=1:2:2" -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:2:3" --y "I_2=1:2:2" -o a.nc
chart chaplygin-ball --of lyapunov --x "I_1=1:2:3" --y "I_2=1:2:2" --let x -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:2:3" --y "I_2=1:2:2" --let "q=1" -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:2:3" --y "I_2=1:2:2" --hold q -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:2:3" --y "I_2=1:2:2" --until 0 -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=1:2:3" --y "I_2=1:2:2" --figure a.txt -o a.zarr
chart chaplygin-ball --of lyapunov --x "I_1=nan:2:3" --y "I_2=1:2:2" -o a.zarr
audit --section 40
audit --section two
audit --workers 0
audit --workers 100000
audit --workers 1.5
show rattleback --as wasm --json
show rattleback --as julia --json
show suslov-nd --as WASM
study chaplygin-ball -o ""
animate
animate rattleback
animate rattleback -o a.avi
animate rattleback -o -
animate rattleback -o no/a.gif
animate rattleback -o a.gif --rate 0
animate rattleback -o a.gif --rate 2.5
animate rattleback -o a.gif --speed 0
animate rattleback -o a.gif --speed nan
animate rattleback -o a.gif --speed 1e-300
animate rattleback -o a.gif --speed 1e300
animate rattleback -o a.gif --width 10
animate rattleback -o a.gif --height 100000
animate chaplygin-bracket -o a.glb
lab --port x
lab --port -1
lab --port 70000
lab nosuch
lab none.toml
lab rattleback extra
lab rattleback --set m=-1
lab suslov-nd --set dimension=40
audit --section 2 -o no/a.html
audit extra
list veselova
list --contact glue
list --section one
run chaplygin-ball -o a.nc --set run.until==1
run chaplygin-ball -o a.nc --set run.until=1,5
run chaplygin-ball -o a.nc --sett run.until=1
run chaplygin-ball -o a.NC --set run.until=ten
find integrals veselova --momenta Q
find integrals veselova --on (
find measure veselova --base 0
find integrals veselova --degree 99
solve veselova --at inf
solve veselova --digits 1e5
prove veselova --effort nan
section veselova --on gamma_3 -o s.zarr --within gamma_1
section veselova --on gamma_3 -o s.zarr --coordinates gamma_1
section veselova --on gamma_3 -o s.zarr --coordinates a,b
section veselova --on gamma_3 -o s.zarr --value nan
section veselova --on gamma_3 -o s.zarr --coordinates andoyer:q
section veselova --on gamma_3 -o s.zarr --level energy=-1 --starts 2
chart veselova --of lyapunov --x I_1=1:2:3 --y I_1=1:2:3 -o c.zarr
chart veselova --of lyapunov --x q=1:2:3 --y I_1=1:2:3 -o c.zarr
chart veselova --of mean --x I_2=1:2:3 --y I_1=1:2:3 -o c.zarr
chart veselova --of lyapunov --x I_2=1:2:3 --y I_1=1:2:3 -o c.zarr --let I_2=3
chart veselova --of lyapunov --x I_2=1:2:3 --y I_1=1:2:3 -o c.zarr --hold q
orbit veselova --on gamma_3 --period 0
orbit veselova --on gamma_3 --follow q=2
orbit veselova --on gamma_3 --tolerance 0
orbit veselova --on gamma_3 --hold q
sweep veselova --over I_1=a,b -o w.zarr
sweep veselova --over I_1=1,2 --draw q -o w.zarr
sweep veselova --over I_1=1,2 --record q -o w.zarr
lyapunov veselova --level q=1
lyapunov veselova --device tpu
lyapunov veselova --tolerance 1e-40
animate veselova -o v.gif --width 10
bifurcation veselova --set I_1=I_2
bifurcation chaplygin-ball-area --set I_2=-1
ensemble veselova -o e.zarr --draw I_1=1:2
ensemble veselova -o e.zarr --starts 5
ensemble veselova -o e.zarr --seed -1 --starts 3 --level energy=1
audit --section x
run --help=3
run veselova -o a.nc -o b.nc
run veselova -o a.nc --output=b.nc
run veselova -o a.nc --set run.until=1 --set run.until=2
run veselova -o a.nc --set run.precision=double --precision quad
section veselova --on gamma_3 --on M_1 -o s.zarr
lyapunov veselova --level energy=1,energy=2
ensemble rattleback -o e.zarr --starts 10 --level energy=1e300
""".strip().splitlines()


#: Commands that first make a system ready: of these a tenth is tried unless all are asked for.
SLOW = ("find", "ensemble", "sweep", "section", "orbit", "lyapunov", "chart")


@pytest.mark.parametrize(
    "line",
    [
        pytest.param(line, marks=[pytest.mark.slow] if line.startswith(SLOW) else [])
        for line in MISTAKES
    ],
)
def test_one_sentence(line: str, ask: Ask) -> None:
    Path("exists.nc").write_bytes(b"mine")
    Path("file.txt").write_text("mine")
    Path("dir.nc").mkdir()
    Path("foreign.zarr").mkdir()
    Path("foreign.zarr/mine.txt").write_text("mine")
    before = sorted(Path().rglob("*"))
    code, out, err = ask(*shlex.split(line))
    progress = [text for text in err.splitlines() if text.endswith(" …") and "error" not in text]
    said = err.splitlines()[len(progress) :]
    assert (code, out) == (2, "")
    assert said[0].startswith("error: ")
    # a formula has its excerpt
    assert all(text.startswith("    ") for text in said[1:])
    assert sorted(Path().rglob("*")) == before
    assert Path("exists.nc").read_bytes() == b"mine"


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("nosuch", "nosuch: there is no such command; allowed: list, show, run"),
        ("sho veselova", "sho: there is no such command, did you mean 'show'? allowed: list"),
        (
            "run veselova -o a.nc --forse",
            "run --forse: there is no such option, did you mean '--fo",
        ),
        ("run veselova", "run: -o/--output is missing (File to write: .nc, .zarr or .csv"),
        ("run", "run: NAME|FILE is missing (A catalogue name, an experiment file, or a Python f"),
        ("run veselova -o", "-o: a value is missing"),
        ("run veselova -o a.nc --output b.nc", "--output is given twice: leave out one of them"),
        (
            "run veselova -o a.nc --set run.until=1 --set run.until=2",
            "run.until is set twice: leave out one of them",
        ),
        ("run veselova -o a.nc --force=yes", "--force: it takes no value"),
        ("show veselova two", "show two: one word too many; chaplygin show --help shows which fit"),
        ("study veselova --effort much", "--effort much: it must be a number"),
        ("section veselova --on M_1 --points=2.5 -o a", "--points 2.5: it must be a whole number"),
        ("find integrals veselova --power -1", "--power -1: it must be at least 0"),
        ("find integrals veselova --denominator 0", "denominator: 0 is zero, which divides nothi"),
        ("solve veselova -o a.txt", "a.txt: the name of a trajectory must end in .nc"),
        ("show ' '", "NAME|FILE is empty: a catalogue name or a file is needed"),
        ("ensemble veselova -o a.zarr --starts 0", "--starts 0: it must be at least 1"),
        (
            "sweep chaplygin-ball-nd --over dimension=3,4 -o a.zarr",
            "--over dimension: the equations depend on it, so that all motions have the same",
        ),
        ("sweep veselova --over I_1=1,1 -o a.zarr", "--over I_1=1,1: its values must be finite a"),
        ("audit --workers 99999", "--workers 99999: it must be a whole number from 1 to"),
        ("show rattleback --as c --json", "--as c and --json both print the system: choose one"),
        ("study veselova -o ''", "--output is empty: the name of a folder is needed"),
        ("animate coin -o a.gif --speed 0", "--speed 0: it must be a positive number"),
        ("animate rattleback -o a.gif --speed 1e-300", "the film would have 2e+302 frames, and at"),
        (
            "animate rattleback -o a.gif --speed 1e300",
            "--speed 1e+300: the motion of 8 s would be over before the second frame; it must be "
            "at most 200",
        ),
    ],
)
def test_what_is_wrong_where_and_what_is_allowed(line: str, words: str, ask: Ask) -> None:
    code, out, err = ask(*shlex.split(line))
    assert (code, out) == (2, "")
    assert err.startswith(f"error: {words}")
    assert len(err.splitlines()) == 1


def test_a_store_that_cannot_be_computed_is_not_left(ask: Ask) -> None:
    code, _, err = ask("sweep", "chaplygin-ball", "--over", "I_1=1,200", "-o", "a.zarr")
    assert code == 2
    assert "I_1 = 200 is not admissible; I_1 <= I_2 + I_3 must hold" in err
    assert not Path("a.zarr").exists()


def test_nothing_at_all_is_asked_for(ask: Ask) -> None:
    code, out, err = ask()
    assert code == 2
    assert "Usage" in out + err
    assert "error:" not in err

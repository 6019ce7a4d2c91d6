"""``chaplygin lyapunov`` as a user meets it."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from chaplygin.cli import main
from chaplygin.experiment.dataset import open_dataset

Answer = tuple[int, str, str]
Ask = Callable[..., Answer]


@pytest.fixture
def ask(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Ask:
    """Run `chaplygin lyapunov` in an empty folder; exit code, standard output and error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> Answer:
        monkeypatch.setattr(sys, "argv", ["chaplygin", "lyapunov", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            main()
        output = capsys.readouterr()
        return int(end.value.code or 0), output.out, output.err

    return run


@pytest.mark.slow
def test_the_table(ask: Ask) -> None:
    code, out, err = ask("unbalanced-ball", "--until", 200)
    # a slow machine is told what it is waiting for
    assert code == 0
    assert all(line.endswith("…") for line in err.splitlines())
    for part in ("λ1", "λ2", "sum", "divergence", "γ² = 1", "energy", "quadratic", "flow"):
        assert any(line.startswith(part) for line in out.splitlines())
    assert "exponents in 1/s" in out
    assert "zero within its error" in out
    assert "M changes sign" in out
    assert "(proven)" in out
    assert all(len(line) <= 80 for line in out.splitlines() if not line.endswith("."))
    assert "-0.000 " not in out


@pytest.mark.slow
def test_nothing_left(ask: Ask) -> None:
    code, out, _ = ask("lagrange-top", "--until", 20)
    assert code == 0
    assert any(re.match(r"λ1 +0 +trivial: ", line) for line in out.splitlines())
    assert "make all exponents trivial" in out


@pytest.mark.slow
def test_motions_that_come_to_rest(ask: Ask) -> None:
    code, out, _ = ask("chaplygin-sleigh")
    assert code == 0
    assert "λ5             -0.382" in out
    assert "All exponents but the trivial ones are negative" in out
    assert "No exponent is made trivial by flow on this motion" in out


@pytest.mark.slow
def test_plain_values(ask: Ask) -> None:
    code, out, _ = ask("rattleback", "--until", 2, "--json", "--set", "system.parameters.g=9.5")
    assert code == 0
    plain = json.loads(out)
    assert plain["parameters"]["g"] == 9.5
    assert plain["until"] == 2
    assert plain["units"]["exponents"] == "1/s"
    assert plain["units"]["until"] == "s"
    assert len(plain["exponents"]) == 3
    assert [item["name"] for item in plain["removed"]] == ["γ² = 1", "energy", "flow"]
    holding = {" ".join(r["odd"]): r["holds"] for r in plain["reversors"]}
    assert holding["M_1 M_2 M_3"]
    assert not holding["M_1 gamma_1"]


@pytest.mark.slow
def test_a_file_with_the_way_it_settled(ask: Ask, tmp_path: Path) -> None:
    code, _, err = ask("suslov", "--until", 50, "-o", "found.nc")
    assert code == 0
    assert "written to found.nc" in err
    data = open_dataset(tmp_path / "found.nc")
    assert data.sizes["exponent"] == 2
    assert list(data.removed.values) == ["γ² = 1", "(ω, e₃) = 0", "energy", "flow"]
    assert ask("suslov", "--until", 50, "-o", "found.nc")[0] == 2


@pytest.mark.slow
def test_starts_on_a_level(ask: Ask) -> None:
    def start(seed: int) -> list[float]:
        level = ("--level", "energy=0.3", "--seed", seed)
        found: list[float] = json.loads(ask("suslov", "--until", 1, *level, "--json")[1])["start"]
        return found

    assert start(1) == start(1) != start(2)


@pytest.mark.slow
def test_a_motion_that_ends_early(ask: Ask) -> None:
    fallen = ("--set", "start.gamma=[1,0,1e-9]", "--set", "start.omega=[0,0.1,0]")
    code, _, err = ask("heavy-disk", *fallen)
    assert code == 1
    assert "error: heavy-disk: the motion ends at t = " in err
    assert err.endswith(" s: the normal force changes sign\n")


@pytest.mark.slow
def test_errors_as_large_as_the_rates_decide_nothing(ask: Ask) -> None:
    code, out, _ = ask("rattleback")
    assert code == 0
    assert "concluded yet; integrate for longer (--until)" in out
    assert "regular" not in out
    assert "come in pairs" not in out


@pytest.mark.slow
def test_a_density_without_bounds_forbids_nothing(ask: Ask) -> None:
    code, out, _ = ask(Path(__file__).parents[4] / "examples" / "sleigh.toml")
    assert code == 0
    assert "it grows beyond all bounds along this motion, and so excludes nothing" in out
    assert "near its limit set there is no invariant measure" in out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("nothing",), "nothing"),
        (("suslov", "--until", "-1"), "must be positive"),
        (("suslov", "--tolerance", "1e-30"), "tolerance"),
        (("suslov", "--level", "energy"), "NAME=VALUE"),
        (("suslov", "--level", "spin=1"), "spin"),
        (("suslov", "-o", "found.zarr"), "--output found.zarr: its name must end in .nc"),
    ],
)
def test_mistakes(ask: Ask, arguments: tuple[str, ...], message: str) -> None:
    code, out, err = ask(*arguments)
    assert (code, out) == (2, "")
    assert message in err
    assert err.count("\n") == 1


@pytest.mark.slow
def test_ctrl_c_gives_the_spectrum_until_then(
    ask: Ask, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    followed = import_module("flowlanes.lyapunov.spectrum")
    original = followed.propagate

    def stopped(count: int) -> Callable[..., Iterator[Any]]:
        def stretches(*arguments: Any, **options: Any) -> Iterator[Any]:
            for number, stretch in enumerate(original(*arguments, **options)):
                if number == count:
                    raise KeyboardInterrupt
                yield stretch

        return stretches

    monkeypatch.setattr(followed, "propagate", stopped(200))
    code, out, err = ask("unbalanced-ball", "--until", 200, "-o", "half.nc")
    assert code == 130
    assert "integrated to t = 100 s" in out
    assert err.endswith(
        "interrupted: at t = 100 of 200; the spectrum up to then is in half.nc; the same command "
        "with --force starts from the beginning\n"
    )
    assert (tmp_path / "half.nc").exists()
    monkeypatch.setattr(followed, "propagate", stopped(50))
    code, out, err = ask("unbalanced-ball", "--until", 200, "-o", "none.nc")
    assert (code, out) == (130, "")
    assert err.endswith(
        "interrupted: nothing was saved; the same command starts from the beginning\n"
    )
    assert not (tmp_path / "none.nc").exists()

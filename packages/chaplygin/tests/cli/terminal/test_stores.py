"""Options that the commands for many motions share."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from chaplygin.cli import main

CHART = ("--of", "fli", "--x", "m=1:2:3", "--y", "R=1:2:3", "-o", "c.zarr")


@pytest.mark.parametrize("device", ["gpu", "tpu"])
@pytest.mark.parametrize(
    "command",
    [
        ("ensemble", "chaplygin-ball", "-o", "b.zarr"),
        ("section", "rattleback", "--on", "omega_3", "-o", "s.zarr"),
        ("chart", "chaplygin-ball", *CHART),
        ("lyapunov", "chaplygin-ball"),
    ],
)
def test_a_device_that_is_not_there(
    command: tuple[str, ...],
    device: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, "cuda.core", None)
    monkeypatch.setattr(sys, "argv", ["chaplygin", *command, "--device", device])
    with pytest.raises(SystemExit) as end:
        main()
    assert end.value.code
    said = {"gpu": "needs the library cuda-core", "tpu": "it must be cpu or gpu"}[device]
    output = capsys.readouterr()
    assert said in output.err
    assert output.err.count("\n") == 1
    assert not output.out
    assert not list(tmp_path.iterdir())

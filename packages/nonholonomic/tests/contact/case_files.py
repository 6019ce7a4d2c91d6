"""The reference cases as experiment files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import tomli_w

CASES: dict[str, dict[str, Any]] = {
    case["name"]: case
    for case in json.loads((Path(__file__).parent / "reference_cases.json").read_text())
}


def experiment_text(case: dict[str, Any], samples: int = 2) -> str:
    """The experiment file of a case."""
    return tomli_w.dumps(
        {
            "body": case["body"],
            "surface": case["surface"],
            "contact": {"model": "friction", **case["contact"]},
            "field": {"gravity": case["gravity"]},
            "start": case["start"],
            "run": {"until": case["until"], "samples": samples},
        }
    )

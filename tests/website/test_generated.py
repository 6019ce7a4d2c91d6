"""Pages that the program writes: an exhibit, claims of the paper, names, commands, keys."""

from __future__ import annotations

import json
import re
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

import borisov_mamaev_2008.audit
import chaplygin
import nonholonomic
from borisov_mamaev_2008 import Claim
from borisov_mamaev_2008.audit import Judgement
from chaplygin.experiment.models.schema import experiment_schema
from lawproof.proof.verdict import Verdict

WEBSITE = Path(__file__).parents[2] / "website"


@pytest.fixture(autouse=True)
def website(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(WEBSITE))


@pytest.mark.slow
def test_an_exhibit_has_laws_file_and_live_page(tmp_path: Path) -> None:
    exhibits, gallery = import_module("exhibits"), import_module("gallery")
    store, live = tmp_path / "store", tmp_path / "live"
    store.mkdir()
    exhibits.compute("example-volterra", "examples/volterra.toml", store)
    record = json.loads((store / "example-volterra.json").read_text(encoding="utf-8"))
    written = dict(gallery.pages([exhibits.Exhibit(**record)], store, live))
    page = written["gallery/experiments/example-volterra.md"]
    assert page.count('class="verdict proven"') == 3
    assert "<!-- live: example-volterra -->" in page
    assert chaplygin.parse_experiment((live / "example-volterra.toml").read_text(encoding="utf-8"))
    assert 'src="lab.js"' in (live / "example-volterra.html").read_text(encoding="utf-8")
    assert 'href="experiments/example-volterra.html"' in written["gallery/index.md"]


def test_every_system_and_every_experiment_is_an_exhibit() -> None:
    names = [what for _, what in import_module("exhibits").sources()]
    assert set(nonholonomic.CATALOGUE) <= set(names)
    files = {
        p.relative_to(WEBSITE.parent).as_posix() for p in WEBSITE.parent.glob("examples/**/*.toml")
    }
    assert files <= set(names)


@pytest.mark.slow
def test_every_claim_has_an_anchor_of_its_own() -> None:
    claims = import_module("claims")
    judgements = borisov_mamaev_2008.audit.audit(section=11, workers=1).judgements
    written = dict(claims.pages(judgements))
    anchors = re.findall(r'<li id="([^"]+)" class="claim"', written["audit/index.md"])
    assert len(set(anchors)) == len(judgements)
    wrong = re.findall(r'<li id="([^"]+)" class="claim"', written["audit/misprints.md"])
    assert wrong and set(wrong) <= set(anchors)


def test_a_claim_that_is_proven_where_conditions_hold_is_no_misprint() -> None:
    partly = Verdict("part", "proven where", finding="a part", conditions=("x > 0",))
    refuted = Verdict("wrong", "refuted", finding="a point")
    judgements = [
        Judgement(1, Claim(f"({n})", "$x$", lambda: partly), verdict, None, 0.1)
        for n, verdict in enumerate((partly, refuted), 1)
    ]
    written = dict(import_module("claims").pages(judgements))
    assert 'data-corrected="none needed"' in written["audit/index.md"]
    assert "Proven where x &gt; 0." in written["audit/index.md"]
    assert "claim-1-2" in written["audit/misprints.md"]
    assert "claim-1-1" not in written["audit/misprints.md"]


def test_the_reference_has_every_name_once() -> None:
    written: dict[str, Any] = dict(import_module("reference_pages").pages(experiment_schema()))
    for name in (
        "nonholonomic/rolling_system",
        "nonholonomic/Body",
        "flowlanes/integrate",
        "flowlanes/InputError",
        "lawproof/prove_all",
        "certificate_checker/check",
        "borisov_mamaev_2008/claims",
        "chaplygin/Study",
    ):
        assert f"reference/{name}.md" in written
    # the door leads to the pages of the packages that it opens
    assert "](lawproof/prove.md)" in written["reference/chaplygin.md"]
    assert "reference/chaplygin/prove.md" not in written


def test_every_name_of_the_reference_is_in_a_group() -> None:
    reference_pages, names = import_module("reference_pages"), import_module("names")
    for package in names.PACKAGES:
        page = reference_pages.names_page(package)
        for name in reference_pages.public_names(package):
            assert f"| [{name}](" in page, f"{package}.{name}"


def test_the_reference_has_commands_and_keys() -> None:
    written: dict[str, Any] = dict(import_module("reference_pages").pages(experiment_schema()))
    assert "## chaplygin section" in written["reference/command-line.md"]
    assert "<code>keep_integrals</code>" in written["reference/experiment-keys.md"]

"""The audit of the paper as pages: every claim with an anchor; the misprints, corrected."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

import jinja2

from borisov_mamaev_2008 import remarks
from borisov_mamaev_2008.audit import DECISIONS, TITLES, Judgement, counts, judged_findings, typeset
from chaplygin._version import __version__

HOME = Path(__file__).parent


def pages(judgements: Sequence[Judgement]) -> Iterator[tuple[str, str]]:
    """The page of all claims, and that of the misprints, by their places."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HOME / "templates"),
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )
    environment.filters["typeset"] = typeset
    environment.filters["findings"] = judged_findings
    claims = list(zip(anchors(judgements), judgements, strict=True))
    wrong = [(anchor, j) for anchor, j in claims if j.printed.decision == "refuted"]
    totals = counts(judgements)
    shared = {
        "version": __version__,
        "titles": TITLES,
        "decisions": DECISIONS,
        "counts": totals,
        # what no claim is has no column
        "columns": {
            form: [decision for decision in DECISIONS if by_decision[decision]]
            for form, by_decision in totals.items()
        },
        "sections": sorted({j.section for j in judgements}),
        "by_section": {
            n: counts(j for j in judgements if j.section == n)
            for n in {j.section for j in judgements}
        },
        "remarks": {n: remarks(n) for n in TITLES},
    }
    for name, listed in (("index", claims), ("misprints", wrong)):
        page = environment.get_template(f"audit_{name}.md")
        yield f"audit/{name}.md", page.render(claims=listed, **shared)


def anchors(judgements: Sequence[Judgement]) -> Iterator[str]:
    """An address for each claim: its section and its place in the paper, in plain letters."""
    used: dict[str, int] = {}
    for judgement in judgements:
        place = re.sub(r"[^a-z0-9]+", "-", judgement.claim.source.lower()).strip("-")
        anchor = f"claim-{judgement.section}-{place}"
        used[anchor] = used.get(anchor, 0) + 1
        yield anchor if used[anchor] == 1 else f"{anchor}-{used[anchor]}"

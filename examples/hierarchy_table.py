"""The whole catalogue in the hierarchy of dynamics, as a Markdown table.

python examples/hierarchy_table.py                  all systems (a few minutes)
python examples/hierarchy_table.py veselova suslov  some of them
"""

from __future__ import annotations

import argparse

from chaplygin import classify
from lawproof.proof.fields.budget import EFFORT
from nonholonomic import CATALOGUE
from nonholonomic.catalogue import entry
from nonholonomic.classification import Classification

HEAD = ("system", "dim", "integrals", "left", "measure", "Poisson", "symmetry", "class")

SIGNS = {"kept": "positive", "changes": "singular", "unknown": "sign undecided"}


def classification(name: str) -> Classification:
    """The place of a system of the catalogue, with its suggested parameters."""
    system = entry(name).system()
    return classify(system, source=entry(name).rolling(), effort=EFFORT, total_budget=None)


def rows(name: str) -> list[str]:
    """The lines of a system: one for its phase space, one for each level with laws of its own."""
    whole = classification(name)
    return [line(f"`{name}`", whole), *(line(f"… {part.level}", part) for part in whole.levels)]


def line(name: str, part: Classification) -> str:
    """One line of the table."""
    brackets = [("conformal, " if b.conformal else "") + f"rank {b.rank}" for b in part.brackets]
    measure = "no density on γ" if part.absence else "of the form" if brackets else "–"
    cells = (
        name,
        str(part.dimension),
        str(part.count),
        str(part.remaining),
        SIGNS[part.measures[0].sign] if part.measures else measure,
        brackets[0] if brackets else "–",
        str(len(part.symmetries) or "–"),
        ", ".join(kind.name for kind in part.kinds),
    )
    return f"| {' | '.join(cells)} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("names", nargs="*", default=list(CATALOGUE), metavar="NAME")
    print(f"| {' | '.join(HEAD)} |")
    print(f"|{'|'.join('---' for _ in HEAD)}|")
    for name in parser.parse_args().names:
        print("\n".join(rows(name)), flush=True)


if __name__ == "__main__":
    main()

"""Bifurcation diagrams of the systems that are solved in closed form: the pictures of the docs.

    python examples/bifurcation_diagrams.py [FOLDER]

writes one picture for each of four systems and prints what is known of each: regions, tori, and
the motions on the boundaries.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path

from chaplygin.report.figures import save
from chaplygin.report.figures.bifurcation import draw_bifurcation_diagram
from nonholonomic.closed_form import bifurcation_diagram, locate
from nonholonomic.closed_form.bifurcation import Diagram

#: Systems and a state of a motion to be marked, by the names of the pictures.
SHOWN: Mapping[str, tuple[str, tuple[str, ...]]] = {
    "bifurcation_veselova": ("veselova", ("0.9", "-0.3", "-1.04", "0.48", "-0.64", "0.6")),
    "bifurcation_neumann": ("neumann", ("0.3", "0.6", "0.4", "0.48", "-0.64", "0.6")),
    "bifurcation_in_a_field": (
        "veselova-bruns",
        ("-0.21", "0.3", "0.72", "0.96", "0", "0.28"),
    ),
    "bifurcation_ball": ("chaplygin-ball-area", ("0.48", "0.6", "0.64", "0.6", "-0.8", "0")),
}


def table(diagram: Diagram) -> str:
    """Regions and boundaries of a diagram, a line each."""
    lines = [diagram.plane.title]
    for region in diagram.regions:
        for family in region.families:
            components = ", ".join(f"ν_{i}" for i in family.nonvanishing) or "no component"
            lines.append(
                f"  region {region.number}: {family.tori} tori, z_1 in {family.first.text}, "
                f"z_2 in {family.second.text}; {components} keeps its sign"
            )
    for boundary in diagram.boundaries:
        fate = "stable" if boundary.stable else "unstable"
        lines.append(f"  {boundary.curve} = 0: {boundary.words}, {boundary.circles}, {fate}")
    for corner in diagram.equilibria:
        place = ", ".join(f"{float(value):.6g}" for value in corner.place)
        lines.append(f"  ({place}): ν rests at axis {corner.axis}, {corner.words}")
    return "\n".join(lines)


def main(folder: Path) -> None:
    """Write the pictures, print the tables."""
    for picture, (name, state) in SHOWN.items():
        diagram = bifurcation_diagram(name)
        print(table(diagram))
        symbols = diagram.plane.system.symbols
        mark = locate(diagram, dict(zip(symbols, state, strict=True)))
        save(draw_bifurcation_diagram(diagram, mark), folder / f"{picture}.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path())

"""Whether the Poisson bracket of a rolling ball can be lifted to its whole attitude: exactly.

At an attitude with rational numbers the equations for a bracket of cotangent type are solved, or
shown to have no solution; borisov-mamaev-2008/docs/open-problems.md has the proof for every
attitude and body.

    python examples/lifted_bracket.py
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from borisov_mamaev_2008.open_problems.lifted_bracket import ATTITUDE, MOMENTS, WEIGHTS, lifts


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the verdicts."""
    argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0]).parse_args(arguments)
    print(f"I = {', '.join(map(str, MOMENTS))}; α, β, γ = the rows of {ATTITUDE * 7} / 7")
    for name, weights in WEIGHTS.items():
        verdict = "solvable" if lifts(MOMENTS, weights) else "no solution: refuted"
        print(f"  {name}: {verdict}")


if __name__ == "__main__":
    main()

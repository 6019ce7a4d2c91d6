"""The quadratic integral that rotors and Bruns' field keep apart and lose together.

python examples/lost_integral.py
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from borisov_mamaev_2008.open_problems.lost_integral import cases
from chaplygin import Integral, prove
from flowlanes import Identity, Rate


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the verdicts."""
    argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0]).parse_args(arguments)
    for name, (system, lost, rate) in cases().items():
        integral = prove(system, Integral("lost", lost))
        identity = prove(system, Identity("rate", Rate(lost) - rate))
        print(f"{name}: integral {integral.decision}, its rate {identity.decision}")


if __name__ == "__main__":
    main()

"""Maps about which everything asked here is known in closed form."""

from __future__ import annotations

import numpy as np

from flowlanes.orbits.maps import ExplicitMap

TURN = 2 * np.pi


def henon_step(z):
    """(x, y, a) ↦ (1 − a x² + y, 0.3 x, a)."""
    return np.stack([1 - z[:, 2] * z[:, 0] ** 2 + z[:, 1], 0.3 * z[:, 0], z[:, 2]], axis=1)


def standard_step(z):
    """(x, p, K) ↦ (x + p′, p′ = p + K sin x, K)."""
    p = z[:, 1] + z[:, 2] * np.sin(z[:, 0])
    return np.stack([z[:, 0] + p, p, z[:, 2]], axis=1)


def delayed_step(z):
    """The delayed logistic map (x, y, a) ↦ (a x (1 − y), x, a)."""
    return np.stack([z[:, 2] * z[:, 0] * (1 - z[:, 1]), z[:, 0], z[:, 2]], axis=1)


def last(z):
    return z[:, 2]


HENON = ExplicitMap(("x", "y", "a"), henon_step, keeps={"a": last})
STANDARD = ExplicitMap(("x", "p", "K"), standard_step, {"x": TURN, "p": TURN}, {"K": last})
DELAYED = ExplicitMap(("x", "y", "a"), delayed_step, keeps={"a": last})
TWIST = ExplicitMap(
    ("x", "p"),
    lambda z: np.stack([z[:, 0] + z[:, 1], z[:, 1]], axis=1),
    {"x": TURN},
    {"p": lambda z: z[:, 1]},
)
TWICE = ExplicitMap(
    ("x", "p", "q"),
    lambda z: np.stack([z[:, 0] + z[:, 1] + z[:, 2], z[:, 1], z[:, 2]], axis=1),
    {"x": TURN},
    {"p": lambda z: z[:, 1], "q": last},
)


def arnold(coupling):
    """x ↦ x + w − K/(2π) sin 2πx, turns, as a family in w."""

    def orbits(turns, values, count):
        found = [turns]
        for _ in range(count):
            x = found[-1]
            found.append(x + values - coupling / TURN * np.sin(TURN * x))
        return np.stack(found, axis=1)

    return orbits

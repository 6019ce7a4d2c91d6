"""Random motions of the systems with special operators."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nonholonomic.catalogue import from_catalogue


def random_motion(name, seed, dimension=4, still=(), **given):
    """A reduced system and a random state; on the axes `still` nothing moves."""
    rng = np.random.default_rng(seed)
    system = replace(from_catalogue(name, dimension=dimension, **given), reconstruction=None)
    p, gamma = rng.normal(size=(2, dimension))
    p[list(still)] = gamma[list(still)] = 0
    gamma /= np.linalg.norm(gamma)
    p -= (p @ gamma) * gamma
    return system, state_of(system, p, gamma)


def state_of(system, p, gamma):
    """The state with p and γ, k = p∧γ."""
    if str(system.state[0]) != "k":
        return [*p.tolist(), *gamma.tolist()]
    k = np.outer(p, gamma) - np.outer(gamma, p)
    return [*k[np.triu_indices(len(p), 1)].tolist(), *gamma.tolist()]

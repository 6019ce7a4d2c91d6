"""Systems of the catalogue, each built once for all tests."""

from __future__ import annotations

from functools import cache

from chaplygin.experiment.models.experiment import catalogue_experiment
from chaplygin.experiment.study import Study
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.mechanics.rolling.equations import RollingBody

NAMES = tuple(CATALOGUE)


@cache
def made(name: str) -> RollingBody | System:
    """What an entry builds with its defaults."""
    item = CATALOGUE[name]
    return item.build(item.numbers())


@cache
def system(name: str) -> System:
    """The System, with the laws that the paper names."""
    found = made(name)
    return found if isinstance(found, System) else CATALOGUE[name].system()


@cache
def study(name: str) -> Study:
    """The example of the catalogue, ready to be followed."""
    return Study.from_experiment(catalogue_experiment(name))


#: Bodies on a surface, which ``test_catalogue`` compares with the catalogue.
ROLLING = tuple(
    [
        "marble-body",
        "marble-body-on-sphere",
        "rattleback",
        "rubber-body",
        "rubber-body-on-sphere",
        "unbalanced-rubber-ball-on-sphere",
        "rubber-chaplygin-ball",
        "rubber-chaplygin-ball-bruns",
        "heavy-disk",
        "rubber-body-of-revolution",
        "rubber-disk",
        "rubber-routh-sphere",
        "chaplygin-ball",
        "chaplygin-ball-bruns",
        "chaplygin-ball-gyrostat",
        "ball-on-sphere",
        "ball-around-sphere",
        "rubber-ball-on-sphere",
        "rubber-ball-around-sphere",
        "unbalanced-ball",
        "unbalanced-ball-on-sphere",
        "unbalanced-rubber-ball",
        "ball-around-sphere-gyrostat-bruns",
        "chaplygin-ball-gyrostat-bruns",
        "ball-around-sphere-bruns",
    ]
)

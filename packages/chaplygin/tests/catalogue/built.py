"""Systems of the catalogue, each built once for all tests."""

from __future__ import annotations

from functools import cache

from chaplygin.experiment.models.experiment import catalogue_experiment
from chaplygin.experiment.study import Study, prepare
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.mechanics.rolling.equations import Rolling

NAMES = tuple(CATALOGUE)


@cache
def made(name: str) -> Rolling | System:
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
    return prepare(catalogue_experiment(name))


#: Bodies on a surface.
ROLLING = tuple(name for name in NAMES if isinstance(made(name), Rolling))

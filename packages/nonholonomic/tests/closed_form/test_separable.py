"""Systems that separate, by the catalogue's systems with their fields."""

import pytest

from nonholonomic.closed_form.separable import (
    SEPARABLE,
    SeparationEntry,
    catalogue_system,
    separated_system,
)


@pytest.mark.parametrize("place", SEPARABLE, ids=lambda place: place.function)
def test_the_catalogue_has_the_field_of_what_separates(place: SeparationEntry) -> None:
    target, system = catalogue_system(place), separated_system(place).system
    # the name chooses the points at which fields are compared
    assert (target.name, target.symbols) == (system.name, system.symbols)
    assert (target.field, target.scalar_definitions) == (system.field, system.scalar_definitions)
    assert target.relations == system.relations
    assert [p.symbol for p in target.parameters] == [p.symbol for p in system.parameters]

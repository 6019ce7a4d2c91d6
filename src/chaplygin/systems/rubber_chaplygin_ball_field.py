"""The Chaplygin ball with rubber contact in a potential (§2.4): the Veselova system with I → J."""

from __future__ import annotations

from dataclasses import replace

from ..mechanics.rolling import Field, Rolling
from ..statements import Isomorphism, Law
from ..system import System
from ..vectors import Diagonal, vectors
from . import chaplygin_ball, rubber_chaplygin_ball, veselova
from .entry import Entry, Numbers, Start, bruns_factor

__all__ = ["ENTRIES", "onto_veselova", "unspecified"]

omega, gamma = vectors("omega gamma")
I, J = Diagonal("I"), Diagonal("J")


def onto_veselova(target: System) -> Isomorphism:
    """The ball moves as the body with a fixed point whose tensor is J = I + mR²E."""
    return Isomorphism(
        "veselova",
        target,
        {omega: omega, gamma: gamma},
        constants=dict(zip(I.symbols, J.symbols, strict=True)),
        meaning="Veselova system with J = I + mR² in place of I",
        source="§2.4",
    )


def build(p: Numbers) -> Rolling:
    """The ball in the potential U = ½K(γ, Iγ)."""
    values = ((veselova.K, p["K"]),)
    return replace(
        rubber_chaplygin_ball.build(p), field=Field(potential=chaplygin_ball.BRUNS, values=values)
    )


def laws(rolling: Rolling, system: System) -> tuple[Law, ...]:
    """The isomorphism onto the Veselova system in Bruns' field."""
    known = rubber_chaplygin_ball.laws(rolling, system)
    if not known or bruns_factor(rolling.field.potential) != veselova.K:
        return known
    numbers = {**veselova.NUMBERS, "K": 2.0}
    return (*known, onto_veselova(veselova.in_bruns_field(numbers)))


def unspecified() -> System:
    """The ball in an arbitrary potential U(γ)."""
    rolling = replace(
        rubber_chaplygin_ball.build(chaplygin_ball.NUMBERS), field=Field(potential=veselova.ANY)
    )
    made = rolling.system("rubber-chaplygin-ball-bruns")
    return made.with_laws(onto_veselova(veselova.general()))


ENTRIES = (
    Entry(
        name="rubber-chaplygin-ball-bruns",
        title="Chaplygin ball with rubber contact in Bruns' field",
        summary="A balanced, dynamically asymmetric ball rolls on a horizontal plane with neither "
        "slipping nor spinning in the potential U = ½K(γ, Iγ); it moves as the Veselova system.",
        source="§2.4, Remark 15",
        defaults={**chaplygin_ball.NUMBERS, "K": 0.7},
        build=build,
        start=Start(omega=(0.9, -0.5, -0.35483870967741937), gamma=(0.2, -0.3, 0.93), until=60.0),
        laws=laws,
        general=unspecified,
    ),
)

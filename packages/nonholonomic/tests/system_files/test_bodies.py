"""Files with a body whose numbers are formulas in parameters."""

from __future__ import annotations

import tomllib

import pytest

from flowlanes.errors import InputError
from nonholonomic.system_files.ball_objects import rolling_ball
from nonholonomic.system_files.bodies import BallFile, RollingFile, is_ball_file
from nonholonomic.system_files.body_objects import rolling_body
from nonholonomic.system_files.source import Source
from nonholonomic.system_files.sourced import validated

BODY = """
[parameters]
m = 2.0
R = 0.5
h = 0.1

[body]
mass = "m"
inertia = ["2*m*R**2/5", "2*m*R**2/5", "m*R**2/2"]

[body.shape]
kind = "ball"
radius = "R"
centre = [0.0, 0.0, "h"]

[surface]
kind = "sphere"
radius = "4*R"

[field]
gravity = "9.81/2"
potential = "k*gamma_3"
parameters = { k = "m*h" }
"""

BALL = """
[parameters]
b = 0.5

[body]
mass = 1.0
inertia = ["b**2/2", "b**2/2", "b**2/2"]

[body.shape]
kind = "ball"
radius = "b"

[surface]
kind = "cylinder"
radius = "3*b"
side = "inside"
"""


def read(text: str) -> RollingFile:
    source = Source("body.toml", text)
    return validated(RollingFile, source.tables(), source)


def test_numbers_are_formulas_in_the_parameters() -> None:
    rolling = rolling_body(read(BODY))
    body, field = rolling.body, rolling.field
    assert (body.mass, body.inertia) == (2.0, (0.2, 0.2, 0.25))
    assert (body.shape.radius, body.shape.centre) == (0.5, (0.0, 0.0, 0.1))
    assert rolling.surface.signed_radius == 2.0
    assert field.gravity == 4.905
    assert [p.default for p in field.parameters] == [0.2]


def test_a_number_by_itself_keeps_all_its_digits() -> None:
    text = BODY.replace("h = 0.1", "h = 0.30000000000000004")
    assert rolling_body(read(text)).body.shape.centre[2] == 0.30000000000000004


def test_a_ball_has_parameters_too() -> None:
    tables = tomllib.loads(BALL)
    assert is_ball_file(tables)
    assert not is_ball_file(tomllib.loads(BODY))
    ball = rolling_ball(BallFile.of_tables(tables))
    assert (ball.radius, ball.inertia, ball.surface.parameters[0].default) == (0.5, 0.125, 1.5)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "m = 2.0",
            "m = -2.0",
            "line 8, body.mass: must be a positive finite number, not m = -2.0",
        ),
        ("m = 2.0", 'm = "R"', 'line 3, parameters.m: must be a finite number, not the text "R"'),
        ("m = 2.0", '"2m" = 2.0', "line 2, parameters: '2m' cannot be used in a formula;"),
        ('"4*R"', '"4*k"', "line 18, surface.radius: unknown name 'k'; allowed: m, R, h,"),
        ('"4*R"', '"1/(m - 2)"', "surface.radius: '1/(m - 2)' has no finite value for these"),
        ('"4*R"', '"sqrt(-m)"', "surface.radius: 'sqrt(-m)' has no finite value for these"),
        ('"h"]', '"h", 1]', "line 14, body.shape.centre: must be 3 finite numbers, not "),
        ("[parameters]", "[numbers]", "line 2, numbers: unknown key"),
    ],
)
def test_mistakes_are_told_in_one_sentence(old: str, new: str, said: str) -> None:
    assert BODY.count(old) == 1
    with pytest.raises(InputError) as caught:
        read(BODY.replace(old, new))
    assert said in str(caught.value)


def test_without_parameters_a_text_is_no_number() -> None:
    with pytest.raises(InputError, match=r'body.mass: must be a positive .* not the text "m"'):
        read(BODY.partition("[body]")[1] + BODY.partition("[body]")[2])

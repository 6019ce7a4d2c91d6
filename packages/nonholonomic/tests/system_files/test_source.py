"""Overrides of a file's keys, and the names of places in both."""

import re

import pytest
from hypothesis import given, settings, strategies as st

from flowlanes.errors import InputError
from nonholonomic.system_files.source import Source

TEXT = '[body]\nmass = 1.0\ninertia = [\n  1, 1, 1]\n\n[contact]\nmodel = "marble"\n'


def source(*overrides: str) -> Source:
    return Source("body.toml", TEXT, overrides)


@pytest.mark.parametrize(
    ("option", "path", "value"),
    [
        ("body.mass=2", ("body", "mass"), 2),
        (" body.mass = 2.5 ", ("body", "mass"), 2.5),
        ("start.omega=[1,0,0]", ("start", "omega"), [1, 0, 0]),
        ("contact.model=rubber", ("contact", "model"), "rubber"),
        ('contact.model="rubber"', ("contact", "model"), "rubber"),
        ("field.potential=gamma_3**2 + a", ("field", "potential"), "gamma_3**2 + a"),
        ("body.shape.hollow=true", ("body", "shape", "hollow"), True),
        ("top=1e-3", ("top",), 1e-3),
        ("name=a=b", ("name",), "a=b"),
    ],
)
def test_override(option: str, path: tuple[str, ...], value: object) -> None:
    found: object = source(option).tables()
    for part in path:
        assert isinstance(found, dict)
        found = found[part]
    assert found == value


def test_overrides_leave_other_keys_and_the_last_one_wins() -> None:
    tables = source("body.mass=2", "body.mass=3").tables()
    assert tables == {
        "body": {"mass": 3, "inertia": [1, 1, 1]},
        "contact": {"model": "marble"},
    }


@pytest.mark.parametrize(
    ("option", "message"),
    [
        ("body.mass", "--set body.mass: an override has the form KEY=VALUE"),
        ("=2", "--set =2: an override has the form KEY=VALUE"),
        ("body..mass=2", "--set body..mass=2: an override has the form KEY=VALUE"),
        ("body mass=2", "an override has the form KEY=VALUE"),
        ("body.mass.x=1", "--set body.mass.x: body.mass is a value, not a table"),
        ("body.inertia=[1,2", "--set body.inertia: [1,2 is not a value; write 2.5, [1, 2, 3]"),
        ("body.mass=", "--set body.mass: nothing is not a value"),
        ("body.mass=1\nother = 2", "--set body.mass: one option sets one key"),
        ("body.mass=" + "[" * 3000, "is not a value"),
    ],
)
def test_wrong_override(option: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        source(option).tables()
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("text", "where", "message"),
    [
        ("[body]\nmass 1\n", "body.toml, line 2", "not valid TOML: Expected '='"),
        ("a = 1\na = 2\n", "body.toml, line 2", "not valid TOML: Cannot overwrite a value"),
        ("[body", "body.toml", "not valid TOML: "),
        ("a = " + "[" * 5000, "body.toml", "not valid TOML: too deeply nested"),
        ("[" + "a." * 5000 + "a]", "body.toml", "not valid TOML: too deeply nested"),
        ("a = " + "1" * 5000, "body.toml", "not valid TOML: Exceeds the limit"),
        ("a = 2026-02-30", "body.toml, line 1", "not valid TOML: Invalid date"),
    ],
)
def test_text_that_is_not_toml(text: str, where: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        Source("body.toml", text).tables()
    assert caught.value.where == where
    assert caught.value.message.startswith(message)


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        (
            "omega = [\u22121, 0, 0]",
            "the minus sign (U+2212) is allowed in texts and comments alone",
        ),
        ("mass =\u00a01.0", "the no-break space (U+00A0) is allowed in texts and comments alone"),
        (
            "kind = \u201cball\u201d",
            "(column 8); the left double quotation mark (U+201C) is allowed in",
        ),
        ("% a ball", "a comment begins with #"),
        ("// a ball", "a comment begins with #"),
        ("mass = 1,5", "a decimal number has a point: 1.5"),
    ],
)
def test_what_is_meant_by_what_is_not_toml(text: str, hint: str) -> None:
    with pytest.raises(InputError, match=re.escape(hint)):
        Source("body.toml", text).tables()


@pytest.mark.parametrize(
    ("key", "where"),
    [
        (("body", "inertia"), "body.toml, line 3, body.inertia"),
        (("body", "shape", "kind"), "body.toml, line 1, body.shape.kind"),
        (("contact",), "body.toml, line 6, contact"),
        (("start",), "body.toml, start"),
        (("run", "until"), "--set run.until"),
        (("run",), "--set run.until"),
        (("surface", "radius"), "--set surface, surface.radius"),
        (("body", "mass"), "--set body.mass"),
        (("body",), "body.toml, line 1, body"),
        (("odd key",), 'body.toml, "odd key"'),
        ((), "body.toml"),
    ],
)
def test_where(key: tuple[str, ...], where: str) -> None:
    options = ("run.until=1", 'surface={kind="plane"}', "body.mass=2")
    assert source(*options).where(key) == where


@settings(max_examples=30)
@given(st.lists(st.text(), max_size=3))
def test_any_override_is_put_or_refused(options: list[str]) -> None:
    try:
        tables = source(*options).tables()
    except InputError as error:
        assert "--set" in str(error)
    else:
        assert tables["body"] or options


def test_a_name_that_stands_for_a_longer_path() -> None:
    short = {"I_1": ("system", "parameters", "I_1"), "I_2": ("system", "parameters", "I_2")}
    made = Source("ball", "", ("I_1=2", "I_2=3"), {"system": {"name": "ball"}}, short)
    assert made.tables() == {"system": {"name": "ball", "parameters": {"I_1": 2, "I_2": 3}}}
    assert made.tables_given == {"system": {"name": "ball"}}
    assert made.where(("system", "parameters", "I_1")) == "--set I_1"
    assert made.where(("system", "parameters")) == "--set I_1 --set I_2"
    assert made.where(("system", "name")) == "ball, system.name"

"""Lines of keys in a TOML text, and tables written for people to read."""

import tomllib
from collections.abc import Iterator, Mapping
from typing import Any

import pytest
import tomli_w
from hypothesis import given, strategies as st

from nonholonomic.system_files.toml import Key, dotted_key, dumps, key_lines

TRICKY = '''# [not.a.table]
top = 1
[body]   # a comment with [brackets] and = signs
mass = 1.0 # = 2
"in.ert" = [
  [1, 0], # ]
  [0, 1],
]
'quo"ted' = """
[fake]
fake = 1 \\""" still = inside
"""
literal = \'\'\'
also = 'fake'
\'\'\'\r
  [ body . shape ]
kind="ball" # "
inline = { a = 1, b = { c = 2 } }
dotted.key = "x = [1"
after = 1
["a]b".c]
d = []
[[list]]
last = 1'''


def test_lines_of_a_tricky_text() -> None:
    assert key_lines(TRICKY) == {
        ("top",): 2,
        ("body",): 3,
        ("body", "mass"): 4,
        ("body", "in.ert"): 5,
        ("body", 'quo"ted'): 9,
        ("body", "literal"): 13,
        ("body", "shape"): 16,
        ("body", "shape", "kind"): 17,
        ("body", "shape", "inline"): 18,
        ("body", "shape", "dotted"): 19,
        ("body", "shape", "dotted", "key"): 19,
        ("body", "shape", "after"): 20,
        ("a]b",): 21,
        ("a]b", "c"): 21,
        ("a]b", "c", "d"): 22,
        ("list",): 23,
        ("list", "last"): 24,
    }
    read = tomllib.loads(TRICKY)
    assert read["body"]["shape"]["after"] == 1  # the text above is TOML indeed


def test_windows_line_ends() -> None:
    assert key_lines("[a]\r\nb = 1\r\n\r\nc = 2\r\n") == {
        ("a",): 1,
        ("a", "b"): 2,
        ("a", "c"): 4,
    }


@given(st.text(alphabet="[]{}=\"'#\n\\ab1., "))
def test_any_text_has_lines(text: str) -> None:
    count = text.count("\n") + 1
    assert all(1 <= line <= count for line in key_lines(text).values())


numbers = st.one_of(st.integers(-(2**60), 2**60), st.floats(allow_nan=False, allow_infinity=False))
leaves = st.one_of(
    numbers,
    st.booleans(),
    st.text(alphabet=st.characters(codec="utf-8")),
    st.lists(numbers, max_size=3),
    st.lists(st.text(alphabet=st.characters(codec="utf-8")), max_size=3),
    st.lists(st.lists(numbers, max_size=3), max_size=3),
)
keys = st.one_of(
    st.sampled_from(["a", "b", "c-d"]), st.text(alphabet=st.characters(codec="utf-8"), max_size=4)
)
nested = st.recursive(
    st.dictionaries(keys, leaves, min_size=1, max_size=3),
    lambda tables: st.dictionaries(keys, st.one_of(leaves, tables), min_size=1, max_size=3),
    max_leaves=4,
)


def paths(tables: Mapping[str, Any], above: Key = ()) -> Iterator[Key]:
    for key, value in tables.items():
        if isinstance(value, dict):
            yield from paths(value, (*above, key))
        else:
            yield (*above, key)


@given(nested)
def test_every_key_is_found_on_its_line(tables: dict[str, Any]) -> None:
    for text in (dumps(tables), tomli_w.dumps(tables)):
        found = key_lines(text)
        lines = text.split("\n")
        for path in paths(tables):
            assert lines[found[path] - 1].startswith(f"{dotted_key(path[-1:])} = ")


@given(nested)
def test_what_is_written_reads_back(tables: dict[str, Any]) -> None:
    assert tomllib.loads(dumps(tables)) == tables


def test_vectors_and_matrices_stand_on_one_line() -> None:
    text = dumps({"body": {"inertia": ((1.0, 0.5), (0.5, 2.0)), "shape": {"kind": "b"}, "no": {}}})
    assert text == ('[body]\ninertia = [[1.0, 0.5], [0.5, 2.0]]\n\n[body.shape]\nkind = "b"\n')


@pytest.mark.parametrize(
    ("key", "text"), [(("body", "mass"), "body.mass"), (("a b", "c"), '"a b".c'), ((), "")]
)
def test_dotted(key: Key, text: str) -> None:
    assert dotted_key(key) == text

"""Hostile and mistaken messages: each is refused in one sentence, and none does anything."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, strategies as st

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.server.requests import Chart, Proof, Subject, request_of
from flowlanes.errors import InputError

SUBJECT = {"what": "veselova"}


def refusal(message: object) -> str:
    body = message if isinstance(message, bytes) else json.dumps(message).encode()
    with pytest.raises(InputError) as caught:
        request_of(body)
    sentence = str(caught.value)
    assert "\n" not in sentence
    assert len(sentence) < 600
    return sentence


def test_requests_are_read() -> None:
    proof = request_of(json.dumps({"do": "prove", "subject": SUBJECT, "law": "energy"}).encode())
    assert proof == Proof(do="prove", subject=Subject(what="veselova"), law="energy")
    chart = {"do": "chart", "subject": SUBJECT, "of": "megno", "x": "a=0:1:2", "y": "b=0:1:2"}
    assert isinstance(request_of(json.dumps(chart).encode()), Chart)


@pytest.mark.parametrize(
    "message",
    [
        b"",
        b"\xff\xfe",
        b"[1, 2]",
        b'"prove"',
        b"[" * 100_000,
        b'{"do": "prove", "subject": {"what": "x"}, "effort": NaN}',
        b'{"do": "prove", "subject": {"what": "x"}, "effort": 1e999}',
        {"do": "run", "subject": SUBJECT},
        {"do": "__class__"},
        {"subject": SUBJECT},
        {"do": "prove"},
        {"do": "prove", "subject": "veselova"},
        {"do": "prove", "subject": {"what": 3}},
        {"do": "prove", "subject": {"what": "x" * 1000}},
        {"do": "prove", "subject": SUBJECT, "effort": "1"},
        {"do": "prove", "subject": SUBJECT, "effort": 1000},
        {"do": "prove", "subject": SUBJECT, "more": 1},
        {"do": "find", "subject": SUBJECT, "kind": "integrals", "degree": 60},
        {"do": "find", "subject": SUBJECT, "kind": "anything"},
        {"do": "orbit", "subject": SUBJECT, "on": "gamma_3", "period": 0},
        {"do": "motion", "subject": {"what": "veselova", "set": {"run.until": {"a": 1}}}},
        {"do": "motion", "subject": {"what": "veselova", "set": {"run.until=1\nx": 1}}},
        {"do": "motion", "subject": {"what": "veselova", "set": {"I_1": [[[[[1]]]]]}}},
        {"do": "motion", "subject": {"what": "veselova", "set": {"I_1": None}}},
        {"do": "motion", "subject": {"what": "veselova", "set": {"title": "a\nb"}}},
        {"do": "motion", "subject": {"what": "veselova", "set": {"title": "\ud800"}}},
        {"do": "motion", "subject": {"what": "veselova", "set": {"I_1": 10**400}}},
        {"do": "save", "file": "a.toml"},
    ],
)
def test_what_is_no_request_is_refused(message: object) -> None:
    refusal(message)


values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner),
    max_leaves=20,
)
names = st.sampled_from(
    ["do", "subject", "what", "set", "law", "effort", "kind", "of", "x", "y", "file", "replace"]
)


@given(st.dictionaries(names | st.text(max_size=5), values | st.sampled_from(["prove", "save"])))
def test_any_object_is_read_or_refused(message: dict[str, object]) -> None:
    try:
        request_of(json.dumps(message).encode())
    except InputError as refused:
        assert "\n" not in str(refused)


@given(
    st.floats(allow_nan=False, allow_infinity=False),
    st.text(max_size=30).filter(str.isprintable),
    st.lists(st.floats(-1e9, 1e9), max_size=5),
)
def test_options_say_in_toml_what_json_said(number: float, text: str, numbers: list[float]) -> None:
    subject = Subject(what="x", set={"a.b": number, "c": text, "d": numbers, "e": True})
    import tomllib

    read = tomllib.loads("\n".join(option for option in subject.options))
    assert read == {"a": {"b": number}, "c": text, "d": numbers, "e": True}


def test_options_change_an_experiment_as_on_the_command_line() -> None:
    subject = Subject(what="veselova", set={"run.until": 5.0, "start.omega": [1.0, 0.0, 2.0]})
    experiment = parse_experiment('system = {name = "veselova"}', "x", subject.options)
    assert experiment.run.until == 5.0
    assert experiment.complete_tables()["start"]["omega"] == (1.0, 0.0, 2.0)

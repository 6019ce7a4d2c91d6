"""The widget of notebooks: its module, and the conversation between page and kernel."""

from __future__ import annotations

import json
import queue
from typing import Any

import pytest

import chaplygin as ch
from chaplygin import server
from needs import needs

pytestmark = needs("anywidget")


@pytest.fixture(scope="module")
def study() -> ch.Study:
    return ch.Study.from_experiment(
        ch.parse_experiment('system = {name = "veselova"}\nrun = {until = 1.0, samples = 5}\n')
    )


@pytest.fixture
def shown(study: ch.Study, monkeypatch: pytest.MonkeyPatch) -> tuple[Any, queue.Queue[Any]]:
    """A widget, and what it sends to its page."""
    sent: queue.Queue[Any] = queue.Queue()
    made = server.widget(study)
    monkeypatch.setattr(made, "send", lambda content, buffers=None: sent.put(content))
    return made, sent


def ask(made: Any, sent: queue.Queue[Any], number: int, request: object) -> list[Any]:
    made._handle_custom_msg({"id": number, "request": request}, [])
    parts = []
    while True:
        message = sent.get(timeout=120)
        assert message["id"] == number
        parts.append(message["answer"])
        if {"done", "error"} & parts[-1].keys():
            return parts


def test_the_module_brings_the_front_end_and_a_renderer(study: ch.Study) -> None:
    made: Any = server.widget(study)
    assert "ChaplyginLab" in made._esm
    assert made._esm.rstrip().endswith("};")
    assert "export default" in made._esm
    model = json.loads(made.page)
    assert model["title"] == made.title == "Veselova system"
    assert model["wasm"]


def test_the_kernel_answers(shown: tuple[Any, queue.Queue[Any]]) -> None:
    subject = {"what": "veselova", "set": {"run.samples": 3}}
    *_, motion, done = ask(*shown, 1, {"do": "motion", "subject": subject})
    assert motion["motion"]["times"] == [0.0, 0.5, 1.0]
    assert done == {"done": True}
    *verdicts, done = ask(*shown, 2, {"do": "prove", "subject": subject, "law": "energy"})
    assert verdicts[-1]["verdict"]["verdict"] == "proven"


@pytest.mark.parametrize(
    "request_", [None, {"do": "list"}, {"do": "save", "file": "x.toml", "experiment": ""}, "x"]
)
def test_what_a_notebook_cannot_answer_is_refused(
    shown: tuple[Any, queue.Queue[Any]], request_: object
) -> None:
    (answer,) = ask(*shown, 3, request_)
    assert set(answer) == {"error"}


def test_a_system_of_the_catalogue_has_a_start_and_others_need_a_study() -> None:
    made: Any = server.widget(ch.from_catalogue("veselova", I_1=1.7))
    parameters = {p["name"]: p["value"] for p in json.loads(made.page)["parameters"]}
    assert parameters["I_1"] == 1.7
    ball = ch.Body(1.0, (1.0, 1.5, 2.1), ch.Ball(1.0))
    with pytest.raises(ch.InputError, match="give a Study"):
        server.widget(ch.rolling_system(ball, ch.Plane(), "marble"))

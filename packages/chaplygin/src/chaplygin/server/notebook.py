"""The laboratory in a notebook: Jupyter, JupyterLab, VS Code, marimo.

Requires the extra: ``pip install 'chaplygin[lab]'``.
"""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError, RunError
from flowlanes.system.system import System

from ..experiment.study import Study

if TYPE_CHECKING:
    from anywidget import AnyWidget

#: Turns the front end into a module that a notebook can import and that exchanges messages with the
#: kernel.
_BRIDGE = """
function ask(model) {
  let last = 0;
  const waiting = new Map();
  model.on("msg:custom", ({ id, answer }) => waiting.get(id)?.(answer));
  return (request, heard, signal) => new Promise((resolve, reject) => {
    const id = ++last;
    const over = (act) => { waiting.delete(id); act(); };
    waiting.set(id, (answer) => {
      if (answer.done) over(resolve);
      else {
        heard(answer);
        if (answer.error !== undefined) over(resolve);
      }
    });
    signal?.addEventListener("abort", () => {
      model.send({ id, cancel: true });
      over(() => reject(signal.reason));
    });
    model.send({ id, request });
  });
}
export default {
  render({ model, el }) {
    const place = document.createElement("div");
    place.className = "chaplygin-lab";
    el.append(place);
    const page = JSON.parse(model.get("page"));
    ChaplyginLab.mount(place, { kind: "widget", model: page, ask: ask(model) });
  },
};
"""


@arguments_checked
def widget(what: Study | System) -> AnyWidget:
    """The laboratory of a study, or of a catalogue system, for display in a notebook.

    Motions are computed in the page; the kernel answers requests that need Python.

    Parameters
    ----------
    what : Study or System
        A system must be one of the catalogue, since it comes without a start.

    Returns
    -------
    anywidget.AnyWidget
        It is displayed as the last expression of a cell; in marimo, by ``mo.ui.anywidget(…)``.

    Raises
    ------
    InputError
        If anywidget is not installed, or the system is not of the catalogue.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import server
    >>> study = ch.Study.from_experiment(ch.parse_experiment('system = {name = "veselova"}'))
    >>> shown = server.widget(study)
    >>> shown.title
    'Veselova system'
    """
    import json

    try:
        import anywidget
        import traitlets
    except ImportError:
        raise InputError("a widget needs anywidget: pip install 'chaplygin[lab]'") from None
    from ..page.element import front_end
    from ..page.study_page import laboratory_model

    study = what if isinstance(what, Study) else _study_of(what)

    class Laboratory(anywidget.AnyWidget):
        """The laboratory of a study in a notebook."""

        _esm = f"{front_end()}\n{_BRIDGE}"
        page = traitlets.Unicode().tag(sync=True)
        title = traitlets.Unicode().tag(sync=True)

    model = laboratory_model(study, {"what": study.system.name, "set": {}})
    shown = Laboratory(page=json.dumps(model, allow_nan=False), title=study.system.title)
    shown.on_msg(_Kernel(study).hear)
    return shown


def _study_of(system: System) -> Study:
    """The default study of the catalogue for a system."""
    from nonholonomic.catalogue import CATALOGUE

    from ..experiment.models.experiment import catalogue_experiment
    from ..experiment.study import Study

    if system.name not in CATALOGUE:
        raise InputError(
            f"{system.title} is no system of the catalogue, and comes without a start: give a "
            "Study, as chaplygin.Study.from_experiment makes it"
        )
    values = [f"{symbol}={value!r}" for symbol, value in system.default_values]
    return Study.from_experiment(catalogue_experiment(system.name, values))


class _Kernel:
    """The kernel's side of a widget: it answers messages one after another."""

    def __init__(self, study: Study) -> None:
        self._experiment = study.complete_toml()
        self._cancellations: set[int] = set()
        self._turn = threading.Lock()

    def hear(self, widget: Any, content: object, buffers: object) -> None:
        """Start the computation requested by a message."""
        if not isinstance(content, dict) or not isinstance(content.get("id"), int):
            return
        if content.get("cancel"):
            self._cancellations.add(content["id"])
            return
        task = (widget, content["id"], content.get("request"))
        threading.Thread(target=self._answer, args=task, daemon=True).start()

    def _answer(self, widget: Any, number: int, request: object) -> None:
        import json

        from .answers import Assignment, answer
        from .requests import Chart, Listing, Saving, request_of

        def say(part: object) -> None:
            widget.send({"id": number, "answer": part})

        try:
            asked = request_of(json.dumps(request).encode())
            if isinstance(asked, Listing | Saving | Chart):
                raise InputError("a notebook has no folder: chaplygin lab has")
            with self._turn:
                for part in answer(Assignment(asked, asked.subject.experiment or self._experiment)):
                    if number in self._cancellations:
                        return
                    say(part)
        except (InputError, RunError, ValueError) as error:
            say({"error": str(error)})

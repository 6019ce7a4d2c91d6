"""A system as a JavaScript module: the engine of a page together with the model of the system."""

from __future__ import annotations

import json
from importlib.resources import files

from ..experiment.study import Study
from .page_model import live_page_model

_ENGINE = files(__package__) / "static" / "engine.js"

_WRAPPER = """
/** The system: its names, parameters, start and module. */
export const model = {model};

/** The engine of this system. */
export default () => WasmEngine.create(model);
"""


def javascript_module(study: Study) -> str:
    """The text of a self-contained module that computes motions of a study.

    Its default export is a function that returns a promise of the engine; see docs/laboratory.md.

    Raises
    ------
    InputError
        If the page cannot compute; see :func:`chaplygin.page.wasm_module.page_module`.

    Examples
    --------
    >>> import chaplygin as ch
    >>> study = ch.Study.from_experiment(ch.parse_experiment('system = {name = "veselova"}'))
    >>> "export default" in javascript_module(study)
    True
    """
    model = json.dumps(live_page_model(study), ensure_ascii=False, allow_nan=False)
    heading = f"// {study.system.title}: equations of motion and their solution.\n"
    return heading + _ENGINE.read_text(encoding="utf-8") + _WRAPPER.replace("{model}", model)

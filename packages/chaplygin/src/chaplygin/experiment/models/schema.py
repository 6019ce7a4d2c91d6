"""The experiment file as a JSON Schema, by which editors complete keys and mark mistakes."""

from __future__ import annotations

from typing import Any

from pydantic import TypeAdapter

from .experiment import Experiment


def experiment_schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of experiment files of every kind.

    What depends on several keys at once (whether a start is admissible, whether a formula can be
    read) cannot be stated in a schema: `load` checks it.

    Returns
    -------
    dict
        For :func:`json.dumps`.

    Examples
    --------
    >>> schema = experiment_schema()
    >>> schema["$defs"]["RunTable"]["properties"]["samples"]["minimum"]
    2
    """
    schema: dict[str, Any] = TypeAdapter(Experiment).json_schema()
    tables = schema["$defs"]
    for table in tables.values():
        # what a caller of Python may see raised is of no use to an editor
        table["description"] = table.get("description", "").partition("\n\nRaises\n")[0]
        cavities = table["properties"].get("cavity") if "properties" in table else None
        if cavities:
            several = next(form for form in cavities["anyOf"] if form.get("type") == "array")
            cavities["anyOf"].insert(0, several["items"])
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "An experiment of chaplygin",
        **schema,
    }

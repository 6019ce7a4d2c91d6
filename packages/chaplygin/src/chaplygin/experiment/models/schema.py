"""The experiment file as a JSON Schema, for completion and validation in editors."""

from __future__ import annotations

from typing import Any

from pydantic import TypeAdapter

from .experiment import Experiment


def experiment_schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of experiment files of every kind.

    Conditions that involve several keys (whether a start is admissible, whether a formula can be
    parsed) cannot be stated in a schema: `load` checks them.

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
        # The exceptions documented for Python callers are of no use in an editor.
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

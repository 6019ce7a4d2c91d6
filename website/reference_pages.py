"""Reference pages: public names, the command line, the keys of the experiment file."""

from __future__ import annotations

import html
import inspect
from collections.abc import Iterator, Mapping
from types import ModuleType
from typing import Any

import chaplygin
import flowlanes
import lawproof
import nonholonomic

#: The folders of the packages by what their names are for, in the order of a study.
SUBJECTS = {
    "nonholonomic.mechanics": "Bodies, surfaces, mechanisms",
    "nonholonomic.catalogue": "The catalogue",
    "flowlanes.system": "Systems and laws",
    "lawproof.proof": "Proofs",
    "lawproof.search": "Laws found",
    "nonholonomic.classification": "The hierarchy of dynamics",
    "nonholonomic.invariant_measures": "Invariant measures",
    "nonholonomic.closed_form": "Closed forms",
    "flowlanes.flow": "Motions",
    "flowlanes.lyapunov": "Lyapunov exponents",
    "flowlanes.orbits": "Orbits",
    "chaplygin.experiment": "Experiments and files",
    "flowlanes.printing": "Formulas as code",
    "flowlanes.errors": "Errors",
}


#: The package of each public name: the laboratory for the names of everyday work.
HOMES: dict[str, ModuleType] = {
    name: package
    for package in (nonholonomic, lawproof, flowlanes, chaplygin)
    for name in package.__all__
    if name not in ("__version__", "CATALOGUE") and not inspect.ismodule(getattr(package, name))
}


def pages(schema: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """The pages by their places.

    Parameters
    ----------
    schema : mapping
        That of experiment files.
    """
    groups = names_by_subject()
    yield "reference/names.md", names_page(groups)
    for name in (name for listed in groups.values() for name in listed):
        yield f"reference/names/{name}.md", name_page(name)
    yield "reference/command-line.md", commands_page()
    yield "reference/experiment-keys.md", keys_page(schema)


def names_by_subject() -> dict[str, list[str]]:
    """The public names by the folder that they come from."""
    groups: dict[str, list[str]] = {folder: [] for folder in SUBJECTS}
    for name in sorted(HOMES, key=str.lower):
        folder = ".".join(inspect.unwrap(public(name)).__module__.split(".")[:2])
        groups[folder].append(name)
    return groups


def public(name: str) -> Any:
    """What a public name means."""
    return getattr(HOMES[name], name)


def title(name: str) -> str:
    """A public name with that of the package from which it is imported."""
    return f"{HOMES[name].__name__}.{name}"


def names_page(groups: Mapping[str, list[str]]) -> str:
    """The public names in groups, each with the first line of its docstring."""
    parts = [
        "# Public names\n",
        "`import chaplygin as ch` has those of everyday work as `ch.NAME`; the others are "
        "imported from the package before their name. `nonholonomic.CATALOGUE` is the dictionary "
        "of the catalogue's entries by name; the [gallery](/gallery/index.md) shows them.\n",
    ]
    for folder, listed in groups.items():
        if listed:
            rows = "\n".join(
                f"| [{title(name)}](names/{name}.md) | {first_line(name)} |" for name in listed
            )
            parts.append(f"## {SUBJECTS[folder]}\n\n| | |\n|---|---|\n{rows}\n")
    parts.append("```{toctree}\n:hidden:\n:glob:\n\nnames/*\n```\n")
    return "\n".join(parts)


def first_line(name: str) -> str:
    """The first line of the docstring of a public name."""
    return (inspect.getdoc(inspect.unwrap(public(name))) or "").partition("\n")[0]


def name_page(name: str) -> str:
    """The docstring of a public name, and of its public methods."""
    thing = inspect.unwrap(public(name))
    if inspect.isclass(thing):
        members = "\n   :members:\n   :undoc-members:" if not issubclass(thing, Exception) else ""
        directive = f".. autoclass:: {name}{members}"
    else:
        directive = f".. autofunction:: {name}"
    module = f".. currentmodule:: {HOMES[name].__name__}"
    return f"# {name}\n\n```{{eval-rst}}\n{module}\n\n{directive}\n```\n"


def commands_page() -> str:
    """The command line, from what the program says of itself."""
    import typer

    from chaplygin.cli import app

    group: Any = typer.main.get_command(app)
    parts = ["# The command line\n", group.help + "\n"]
    for name, command in group.commands.items():
        context = command.make_context(f"chaplygin {name}", [], resilient_parsing=True)
        parts.append(f"## chaplygin {name}\n\n{command.help}\n")
        parts.append(f"```text\n{command.get_usage(context).removeprefix('Usage: ')}\n```\n")
        records = [parameter.get_help_record(context) for parameter in command.params]
        rows = "\n".join(
            f"<tr><td><code>{html.escape(left)}</code></td><td>{html.escape(right)}</td></tr>"
            for left, right in filter(None, records)
        )
        parts.append(
            f"```{{raw}} html\n<div class='wide'><table class='keys'>{rows}</table></div>\n```\n"
        )
    return "\n".join(parts)


def keys_page(schema: Mapping[str, Any]) -> str:
    """The tables of the experiment file with their keys."""
    tables: Mapping[str, Any] = schema["$defs"]
    kinds = [form["$ref"].split("/")[-1] for form in schema["anyOf"]]
    parts = [
        "# Keys of the experiment file\n",
        "From the schema by which files are checked; "
        "[The experiment file](/docs/experiment-file.md) "
        "explains them. An editor completes keys and marks mistakes if the schema lies beside the "
        "file and the file begins with its name, where the editor reads such a line (Even Better "
        "TOML, Taplo):\n",
        "```sh\nchaplygin show --schema > experiment.schema.json\n```\n",
        "```toml\n#:schema experiment.schema.json\n```\n",
        "```{raw} html\n<p><a href='../schema/experiment.schema.json' download>"
        "Download the schema</a></p>\n```\n",
    ]
    for heading, chosen in (
        ("Kinds of experiments", kinds),
        ("Tables", sorted(set(tables) - set(kinds))),
    ):
        parts.append(f"## {heading}\n")
        for name in chosen:
            table = next(
                (t for t in tables[name].get("anyOf", ()) if "properties" in t), tables[name]
            )
            if "properties" not in table:
                continue
            rows = "\n".join(
                f"<tr><td><code>{key}</code></td><td>{html.escape(_words(value))}</td>"
                f"<td>{html.escape(_default(key, value, table))}</td></tr>"
                for key, value in table["properties"].items()
            )
            parts.append(
                f"### {name}\n\n{table.get('description', '')}\n\n"
                "```{raw} html\n<div class='wide'>"
                f"<table class='keys'><tr><th>key</th><th>is</th><th>default</th></tr>{rows}"
                "</table></div>\n```\n"
            )
    return "\n".join(parts)


def _words(value: Mapping[str, Any]) -> str:
    """What a key is: its description, or its one value."""
    return str(value.get("description") or value.get("const") or value.get("type", ""))


def _default(key: str, value: Mapping[str, Any], table: Mapping[str, Any]) -> str:
    """The default of a key."""
    import json

    if key in table.get("required", ()):
        return "required"
    default = value.get("default")
    return "" if default in (None, "", {}, []) else json.dumps(default, ensure_ascii=False)

"""Reference pages: names of each package, the command line, the keys of the experiment file."""

from __future__ import annotations

import html
import inspect
import re
from collections.abc import Iterable, Iterator, Mapping
from importlib import import_module
from typing import Any

from names import PACKAGES, home_of

#: The folders of the packages by what their names are for, in the order of a study.
SUBJECTS = {
    "nonholonomic.mechanics": "Bodies, surfaces, mechanisms",
    "nonholonomic.starts": "Starts",
    "nonholonomic.catalogue": "The catalogue",
    "nonholonomic.classification": "The hierarchy of dynamics",
    "nonholonomic.invariant_measures": "Invariant measures",
    "nonholonomic.closed_form": "Closed forms",
    "flowlanes.system": "Systems and laws",
    "flowlanes.flow": "Motions",
    "flowlanes.lyapunov": "Lyapunov exponents",
    "flowlanes.orbits": "Orbits",
    "flowlanes.printing": "Formulas as code",
    "flowlanes.errors": "Errors",
    "lawproof.proof": "Proofs",
    "lawproof.search": "The search for laws",
    "chaplygin.experiment": "Experiments and files",
    "certificate_checker.certificate": "The check",
    "certificate_checker.claim": "Errors",
    "borisov_mamaev_2008.claim": "Claims and remarks",
    "borisov_mamaev_2008.collection": "The claims of a section",
}


def pages(schema: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """The pages by their places.

    Parameters
    ----------
    schema : mapping
        That of experiment files.
    """
    for package in PACKAGES:
        yield f"reference/{package}.md", names_page(package)
        for name in own_names(package):
            yield f"reference/{package}/{name}.md", name_page(package, name)
    yield "reference/command-line.md", commands_page()
    yield "reference/experiment-keys.md", keys_page(schema)


def public_names(package: str) -> list[str]:
    """The public functions and classes of a package, in alphabetical order."""
    module = import_module(package)
    found = (name for name in module.__all__ if is_documented(getattr(module, name)))
    return sorted(found, key=str.lower)


def is_documented(thing: object) -> bool:
    """Whether something is a function or a class of the workspace, which has a page."""
    return inspect.isroutine(inspect.unwrap(thing)) or inspect.isclass(thing)  # type: ignore[arg-type]


def own_names(package: str) -> list[str]:
    """The public names of a package that no package below it has made."""
    module = import_module(package)
    return [name for name in public_names(package) if home_of(getattr(module, name)) == package]


def names_page(package: str) -> str:
    """The public names of a package in groups, each with the first line of its docstring."""
    module = import_module(package)
    own = own_names(package)
    parts = [f"# Names of {package}\n", f"`import {package}` makes them available.\n"]
    for folder, title in SUBJECTS.items():
        listed = [name for name in own if folder_of(getattr(module, name)) == folder]
        if listed:
            parts.append(f"## {title}\n\n{table(package, listed)}\n")
    for other in PACKAGES:
        listed = [
            name
            for name in public_names(package)
            if other != package and home_of(getattr(module, name)) == other
        ]
        if listed:
            parts.append(f"## From {other}\n\n{table(other, listed)}\n")
    parts.append(f"```{{toctree}}\n:hidden:\n:glob:\n\n{package}/*\n```\n")
    return "\n".join(parts)


def folder_of(thing: object) -> str:
    """The folder of a package in which something is defined."""
    return ".".join(inspect.unwrap(thing).__module__.split(".")[:2])  # type: ignore[arg-type]


def table(package: str, names: Iterable[str]) -> str:
    """Names of a package with the first lines of their docstrings."""
    rows = "\n".join(
        f"| [{name}]({package}/{name}.md) | {first_line(package, name)} |" for name in names
    )
    return f"| name | |\n|---|---|\n{rows}"


def first_line(package: str, name: str) -> str:
    """The first line of the docstring of a public name, references as plain code."""
    thing = inspect.unwrap(getattr(import_module(package), name))
    line = (inspect.getdoc(thing) or "").partition("\n")[0]
    return re.sub(r":\w+:`~?([^`]*)`", r"`\1`", line)


def name_page(package: str, name: str) -> str:
    """The docstring of a public name, and of its public methods."""
    thing = inspect.unwrap(getattr(import_module(package), name))
    if inspect.isclass(thing):
        members = "\n   :members:\n   :undoc-members:" if not issubclass(thing, Exception) else ""
        directive = f".. autoclass:: {name}{members}"
    else:
        directive = f".. autofunction:: {name}"
    return f"# {name}\n\n```{{eval-rst}}\n.. currentmodule:: {package}\n\n{directive}\n```\n"


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
        "[The experiment file](/packages/chaplygin/docs/experiment-file.md) "
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

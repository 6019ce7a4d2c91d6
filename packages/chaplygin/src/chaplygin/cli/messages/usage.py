"""Mistakes on a command line, as one sentence each."""

from __future__ import annotations

import re
import sys
from typing import Any, Protocol

from typer import TyperException

from flowlanes.errors import nearest


class CommandParameter(Protocol):
    """Option or argument of a command."""

    param_type_name: str
    name: str | None
    metavar: str | None
    opts: list[str]


#: Descriptions by pydantic, and the allowed values.
_DESCRIPTIONS = {"valid integer": "a whole number", "valid number": "a number"}


def sentence(error: TyperException) -> str:
    """Sentence with the mistake, its location, and the allowed values.

    Parameters
    ----------
    error
        Error from Typer: an unknown command or option, a missing or additional argument, or a
        value of the wrong kind.
    """
    context: Any = getattr(error, "ctx", None)
    command = str(context.info_name) if context and context.parent else ""
    option, parameter = getattr(error, "option_name", ""), getattr(error, "param", None)
    if hasattr(error, "possibilities"):
        known = [max(p.opts, key=len) for p in context.command.params if p.opts[0][0] == "-"]
        place = f"{command} {option}".strip()
        return f"{place}: there is no such option{nearest(option, known)}"
    if option:
        takes = "it takes no value" if "not take" in error.message else "a value is missing"
        return f"{option}: {takes}"
    if parameter is not None and hasattr(error, "param_type"):
        return f"{command}: {_names(parameter)} is missing{_meaning(parameter)}"
    if parameter is not None:
        wrong = error.message
        for words, allowed in _DESCRIPTIONS.items():
            wrong = f"it must be {allowed}" if words in wrong else wrong
        return f"{_option_text(parameter)}: {wrong}"
    if match := re.match(r"No such command '(.*)'\.", error.message, re.DOTALL):
        known = list(context.command.commands)
        return f"{match[1]}: there is no such command{nearest(match[1], known)}"
    if match := re.fullmatch(r"Got unexpected extra .*\((.*)\)", error.message, re.DOTALL):
        return (
            f"{command} {match[1]}: one word too many; chaplygin {command} --help shows which fit"
        )
    return error.format_message()


def _names(parameter: CommandParameter) -> str:
    if parameter.param_type_name == "argument":
        return str(parameter.metavar or parameter.name)
    return "/".join(parameter.opts)


def _meaning(parameter: CommandParameter) -> str:
    words = str(getattr(parameter, "help", "") or "").rstrip(".")
    return f" ({words})" if words else ""


def _option_text(parameter: CommandParameter) -> str:
    """Option with its value on the command line."""
    for name in parameter.opts:
        for place, word in enumerate(sys.argv):
            if word == name and place + 1 < len(sys.argv):
                return f"{name} {sys.argv[place + 1]}"
            if word.startswith(f"{name}="):
                return f"{name} {word.removeprefix(f'{name}=')}"
    return _names(parameter)

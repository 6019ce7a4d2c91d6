"""Paths and marks of an SVG, written with as few characters as possible."""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping
from functools import lru_cache

#: Number of values after each command of a path with absolute coordinates.
_NUMBERS = {"M": 2, "L": 2, "Q": 4, "C": 6, "z": 0}

_PARTS = re.compile(r"[MLQCz]|-?\d+(?:\.\d+)?(?:e-?\d+)?")


def short_path(path: str) -> str:
    """The data of a path in relative steps, to a hundredth of a point.

    Finer steps are not visible in print.  Steps are differences of rounded positions, so errors do
    not accumulate.

    Parameters
    ----------
    path : str
        Commands M, L, Q, C and z with absolute coordinates, as matplotlib writes them; a path with
        others is returned as it is.

    Examples
    --------
    >>> short_path("M 1.004 2 L 11.5 2.25 L 11.5 7 z")
    'm1 2 10.5.25 0 4.75z'
    """
    parts = _PARTS.findall(path)
    if "".join(parts) != "".join(path.split()):
        return path
    written: list[str] = []
    here, first = (0, 0), (0, 0)
    place, last = 0, ""
    while place < len(parts):
        command = parts[place]
        place += 1
        if command not in _NUMBERS:
            return path
        count = _NUMBERS[command]
        if not count:
            written.append("z")
            here, last = first, "z"
            continue
        places = [round(100 * float(number)) for number in parts[place : place + count]]
        place += count
        if command == last == "L" and places == list(here):
            continue
        steps = [value - here[index % 2] for index, value in enumerate(places)]
        here = places[-2], places[-1]
        if command == "M":
            first = here
        numbers = _number_list([_decimal(step) for step in steps])
        # After a move, line steps need no command.
        same = command != "M" and (command == last or (command, last) == ("L", "M"))
        if same and numbers[0] != "-":
            numbers = f" {numbers}"
        written.append(numbers if same else f"{command.lower()}{numbers}")
        last = command
    return "".join(written)


@lru_cache(maxsize=100_000)
def _decimal(hundredths: int) -> str:
    """A number of hundredths as the shortest decimal."""
    sign, size = "-" if hundredths < 0 else "", abs(hundredths)
    whole, part = divmod(size, 100)
    fraction = f".{part:02d}".rstrip("0") if part else ""
    return f"{sign}{whole or (0 if not fraction else '')}{fraction}"


def _number_list(numbers: list[str]) -> str:
    """Numbers separated by spaces only where they would run together."""
    text = numbers[0]
    for before, number in itertools.pairwise(numbers):
        apart = number[0] != "-" and not (number[0] == "." and "." in before)
        text += f" {number}" if apart else number
    return text


#: A mark drawn at a point.
_MARK = re.compile(r'<use xlink:href="([^"]*)" x="([^"]*)" y="([^"]*)" style="([^"]*)"/>')


def grouped_marks(svg: str) -> str:
    r"""r"An SVG in which consecutive marks share their style, in lines separated by line breaks.

    Examples
    --------
    >>> mark = '<use xlink:href="#a" x="{}" y="2.0005" style="fill: red"/>'
    >>> print(grouped_marks(mark.format(1) + "\n" + mark.format(3)))
    <g style="fill: red">
    <use xlink:href="#a" x="1" y="2"/>
    <use xlink:href="#a" x="3" y="2"/>
    </g>
    """
    lines: list[str] = []
    open_style = ""
    for line in svg.split("\n"):
        mark = _MARK.fullmatch(line)
        style = mark[4] if mark else ""
        if open_style and style != open_style:
            lines.append("</g>")
        if style and style != open_style:
            lines.append(f'<g style="{style}">')
        open_style = style
        if mark:
            x, y = (_decimal(round(100 * float(place))) for place in (mark[2], mark[3]))
            lines.append(f'<use xlink:href="{mark[1]}" x="{x}" y="{y}"/>')
        else:
            lines.append(line)
    return "\n".join([*lines, "</g>"] if open_style else lines)


#: A path with its own style, by parts: data, clipping and style.
_PATH = re.compile(r'<path d="([^"]*)"( clip-path="[^"]*")? style="([^"]*)"/>')

#: Length of a path in characters above which it is worth naming.
_LONG = 200


def with_shared_paths(first: str, second: str, name: str) -> tuple[str, str]:
    """Two SVGs of one page, where the second refers to long paths of the first by name.

    Parameters
    ----------
    first, second : str
        SVG texts with line breaks.
    name : str
        Prefix of the names.

    Examples
    --------
    >>> wide = '<path d="m{0}" style="fill: red"/>'.format("1 1 " * 60)
    >>> with_shared_paths(wide, wide, "a")[1]
    '<use xlink:href="#a-p0"/>'
    """
    known: dict[tuple[str, str], str] = {}
    for path in _PATH.finditer(second):
        if len(path[0]) > _LONG:
            known.setdefault((path[1], path[3]), f"{name}-p{len(known)}")
    named: set[str] = set()

    def with_name(path: re.Match[str]) -> str:
        identifier = known.get((path[1], path[3]))
        if identifier is None or identifier in named:
            return path[0]
        named.add(identifier)
        drawn = f'<path id="{identifier}" d="{path[1]}" style="{path[3]}"/>'
        # A path referenced elsewhere must not be clipped as it is here.
        return f"<g{path[2]}>{drawn}</g>" if path[2] else drawn

    def by_name(path: re.Match[str]) -> str:
        identifier = known.get((path[1], path[3]))
        if identifier not in named:
            return path[0]
        return f'<use xlink:href="#{identifier}"{path[2] or ""}/>'

    first = _PATH.sub(with_name, first)
    return first, _PATH.sub(by_name, second)


#: The shape of a letter.
_LETTER = re.compile(r'<path id="([^"]*)" d="([^"]*)"( transform="[^"]*")?/>\n?')


def with_shared_letters(texts: Mapping[str, str]) -> tuple[dict[str, str], str]:
    """Move the letter shapes of several SVGs into one element that all of them share.

    Parameters
    ----------
    texts : mapping of str to str

    Returns
    -------
    dict of str to str
        The same SVGs without shapes of letters.
    str
        An invisible SVG with the shapes, which must be in the page.

    Examples
    --------
    >>> svg = '<path id="{0}" d="m1 1z"/><use xlink:href="#{0}"/>'
    >>> texts, letters = with_shared_letters({"a": svg.format("a-1"), "b": svg.format("b-1")})
    >>> texts["b"]
    '<use xlink:href="#letter-0"/>'
    """
    shapes: dict[tuple[str, str], str] = {}
    shared = {}
    for key, whole in texts.items():
        names: dict[str, str] = {}
        for name, data, change in _LETTER.findall(whole):
            names[name] = shapes.setdefault((data, change), f"letter-{len(shapes)}")
        text = _LETTER.sub("", whole)
        for name, shape in names.items():
            text = text.replace(f'href="#{name}"', f'href="#{shape}"')
        shared[key] = text
    paths = "\n".join(
        f'<path id="{name}" d="{data}"{change}/>' for (data, change), name in shapes.items()
    )
    hidden = 'width="0" height="0" aria-hidden="true" style="position: absolute"'
    return shared, f"<svg {hidden}>\n<defs>\n{paths}\n</defs>\n</svg>"

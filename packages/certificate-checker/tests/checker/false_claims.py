"""Certificates of claims, or with proofs, that differ from genuine ones by very little.

Every change is one of a kind that a forger might try: a term 10^−400 somewhere, a name that means a
number, a sign left out, a component lost.  What is forged is sometimes true all the same, such as a
rate on which nothing depends; the test says when.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from copy import deepcopy
from fractions import Fraction
from typing import Any

from checker.corrupted import Path, put

#: Names that mean something else in formulas.
TAKEN = ("pi", "sin", "exp", "sqrt", "Rate", "Derivative", "nan")

#: Exponents of ten of the smallest changes.
SMALL = (3, 50, 195, 200, 400, 1000, 3000)


def forgeries(
    certificate: dict[str, Any], generator: random.Random
) -> Iterator[tuple[str, dict[str, Any]]]:
    """Forged certificates without end, each with its kind and place."""
    makers = [_formula, _formula, _coefficient, _coefficient, _name, _loss, _power, _sign, _point]
    while True:
        made = generator.choice(makers)(certificate, generator)
        if made is not None and made[1] != certificate:
            yield made


def _leaves(data: Any, path: Path = ()) -> Iterator[tuple[Path, Any]]:
    if isinstance(data, dict):
        for key, part in data.items():
            yield from _leaves(part, (*path, key))
    elif isinstance(data, list):
        for i, part in enumerate(data):
            yield from _leaves(part, (*path, i))
    yield path, data


def _label(kind: str, path: Path) -> str:
    return f"{kind} {'.'.join(map(str, path))}"


def _formula_places(certificate: dict[str, Any]) -> list[Path]:
    """Where formulas of the claim stand."""
    places = []
    for path, value in _leaves(certificate["claim"], ("claim",)):
        named = {"name", "kind", "state", "parameters", "admissible"} & {*path}
        pairs = {"definitions", "map", "constants", "quantities", "field"} & {*path}
        if isinstance(value, str) and not named and not (pairs and path[-1] == 0):
            places.append(path)
    return places


def _at(data: Any, path: Path) -> Any:
    for step in path:
        data = data[step]
    return data


def _formula(certificate: dict[str, Any], generator: random.Random) -> Any:
    """A formula of the claim with a small term more."""
    path = generator.choice(_formula_places(certificate))
    system = certificate["claim"]["system"]
    if "target" in path:
        system = certificate["claim"]["law"]["target"]
    words = [*system["state"], *system["parameters"]]
    words = [w for w in words if "parameters" not in path or w in system["parameters"]]
    term = "*".join(generator.choices(words, k=generator.randint(1, 2)))
    text = f"{_at(certificate, path)} + {term}/10**{generator.choice(SMALL)}"
    return _label("formula", path), put(certificate, path, "replaced", text)


def _coefficient(certificate: dict[str, Any], generator: random.Random) -> Any:
    """A coefficient of a polynomial of the proof with a small number more."""
    places = [
        path
        for path, value in _leaves(certificate.get("proofs", []), ("proofs",))
        if isinstance(value, str) and _number(value) is not None
    ]
    if not places:
        return None
    path = generator.choice(places)
    value = Fraction(_at(certificate, path)) + Fraction(1, 10 ** generator.choice(SMALL))
    text = f"{value.numerator}/{value.denominator}"
    return _label("coefficient", path), put(certificate, path, "replaced", text)


def _number(text: str) -> Fraction | None:
    try:
        return Fraction(text)
    except ValueError:
        return None


def _name(certificate: dict[str, Any], generator: random.Random) -> Any:
    """A definition, a parameter or a state variable with the name of a number or function."""
    made = deepcopy(certificate)
    system = made["claim"]["system"]
    word = generator.choice(TAKEN)
    where = generator.choice(("definition", "parameter", "state"))
    if where == "definition":
        system["definitions"].insert(0, [word, str(generator.randint(2, 4))])
    elif where == "parameter":
        system["parameters"].append(word)
        _whole_sample(made)[word] = "3"
    else:
        system["state"].append(word)
        system["rates"].append("0")
        _whole_sample(made)[word] = "3"
    return f"name {word} as {where}", made


def _whole_sample(certificate: dict[str, Any]) -> dict[str, Any]:
    point: dict[str, Any]
    point = certificate["sample"] if "sample" in certificate else certificate["witness"]["point"]
    return point


def _loss(certificate: dict[str, Any], generator: random.Random) -> Any:
    """A proof, a case, an identity, a residual or an equation is lost."""
    lists = ("proofs", "children", "identities", "residuals", "equations", "terms", "divisors")
    places = [
        path
        for path, value in _leaves(certificate.get("proofs", []), ("proofs",))
        if isinstance(value, list) and path[-1] in lists and value
    ]
    if not places:
        return None
    path = generator.choice(places)
    at = generator.randrange(len(_at(certificate, path)))
    items = [item for i, item in enumerate(_at(certificate, path)) if i != at]
    return _label("loss", (*path, at)), put(certificate, path, "replaced", items)


def _power(certificate: dict[str, Any], generator: random.Random) -> Any:
    """A symbol b of the claim as the root or a symbolic power of b², which is |b|."""
    path = generator.choice(_formula_places(certificate))
    system = certificate["claim"]["system"]
    words = [*system["state"], *system["parameters"]]
    word, exponent = generator.choice(words), generator.choice(("1/2", "n/(2*n)", "1/4"))
    text = _at(certificate, path)
    base = f"({word}**4)" if exponent == "1/4" else f"({word}**2)"
    exponent = exponent.replace("n", words[-1]) if "n" in exponent else exponent
    spread = _substituted(text, word, f"({base}**({exponent}))")
    return _label(f"power of {word} in", path), put(certificate, path, "replaced", spread)


def _substituted(text: str, word: str, by: str) -> str:
    import re

    return re.sub(rf"\b{re.escape(word)}\b", by, text)


def _sign(certificate: dict[str, Any], generator: random.Random) -> Any:
    """A guard, an admissible set or an assumed sign turned round or left out."""
    places = [
        path
        for path, value in _leaves(certificate)
        if path and path[-1] in ("guards", "admissible", "signs", "positive") and value
    ]
    if not places:
        return None
    path = generator.choice(places)
    items = deepcopy(_at(certificate, path))
    at = generator.randrange(len(items))
    if path[-1] == "signs" and generator.random() < 0.5:
        items[at][1] = -items[at][1]
    elif path[-1] == "guards" and generator.random() < 0.5:
        items[at] = f"-({items[at]})"
    elif path[-1] == "admissible" and ">" in items[at] and generator.random() < 0.5:
        items[at] = items[at].replace(">", "<", 1)
    else:
        del items[at]
    return _label("sign", (*path, at)), put(certificate, path, "replaced", items)


def _point(certificate: dict[str, Any], generator: random.Random) -> Any:
    """A coordinate of the sample or the witness moved by very little."""
    key: Path = ("sample",) if "sample" in certificate else ("witness", "point")
    words = [w for w, v in _at(certificate, key).items() if isinstance(v, str)]
    if not words:
        return None
    path: Path = (*key, generator.choice(words))
    value = Fraction(_at(certificate, path)) + Fraction(1, 10 ** generator.choice(SMALL))
    return _label("point", path), put(certificate, path, "replaced", str(value))

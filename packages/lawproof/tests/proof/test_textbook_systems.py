"""Laws of five textbook systems: proven, refuted at a point, found; and certificates that check."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import pytest
import sympy as sp

import certificate_checker
from flowlanes.system.laws import Integral, Measure
from flowlanes.system.system import System
from lawproof.proof.certificates.certificate import prove_with_certificate
from lawproof.search.integrals import integrals
from lawproof.search.measures import measures
from lawproof.search.request import search_space


@dataclass(frozen=True)
class Textbook:
    """A system with laws that hold and one with a planted error."""

    system: System
    laws: tuple[Integral | Measure, ...]
    wrong: Integral


def kepler() -> Textbook:
    x, y, u, v = sp.symbols("x y u v", real=True)
    r = sp.sqrt(x**2 + y**2)
    system = System("kepler", "Kepler", {x: u, y: v, u: -x / r**3, v: -y / r**3})
    moment = x * v - y * u
    laws = (
        Integral("energy", (u**2 + v**2) / 2 - 1 / r),
        Integral("moment", moment),
        Integral("laplace", v * moment - x / r),
    )
    return Textbook(system, laws, Integral("laplace", v * moment + x / r))


def euler() -> Textbook:
    a, b, c = sp.symbols("a b c", real=True)
    # moments of inertia 1, 2, 3, and six times the rates
    system = System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    energy, momentum = a**2 + b**2 / 2 + c**2 / 3, a**2 + b**2 + c**2
    laws = (Integral("energy", energy), Integral("momentum", momentum))
    return Textbook(system, laws, Integral("energy", a**2 + b**2 / 2 + c**2 / 4))


def lotka_volterra() -> Textbook:
    x, y = sp.symbols("x y", positive=True)
    system = System("lotka-volterra", "Lotka and Volterra", {x: x * (1 - y), y: y * (x - 1)})
    value = x - sp.log(x) + y - sp.log(y)
    laws = (Integral("volterra", value), Measure("density", {x: -1, y: -1}))
    return Textbook(system, laws, Integral("volterra", value + sp.log(x) / 2))


def kovalevskaya() -> Textbook:
    p, q, r = sp.symbols("p q r", real=True)
    k, m, n = sp.symbols("k m n", real=True)
    # moments of inertia 2, 2, 1 and the weight along the first axis
    field = {
        p: q * r / 2,
        q: (n - p * r) / 2,
        r: -m,
        k: m * r - n * q,
        m: n * p - k * r,
        n: k * q - m * p,
    }
    vertical = k**2 + m**2 + n**2 - 1
    system = System("kovalevskaya", "Kovalevskaya's top", field, relations=(vertical,))
    laws = (
        Integral("energy", p**2 + q**2 + r**2 / 2 + k),
        Integral("area", 2 * p * k + 2 * q * m + r * n),
        Integral("kovalevskaya", (p**2 - q**2 - k) ** 2 + (2 * p * q - m) ** 2),
    )
    return Textbook(
        system, laws, Integral("kovalevskaya", (p**2 - q**2 + k) ** 2 + (2 * p * q - m) ** 2)
    )


def toda() -> Textbook:
    a, b = sp.symbols("a_1:4", real=True), sp.symbols("b_1:4", real=True)
    # Flaschka's variables of the periodic lattice: the spectrum of L is constant
    field = {a[i]: a[i] * (b[(i + 1) % 3] - b[i]) for i in range(3)}
    field |= {b[i]: 2 * (a[i] ** 2 - a[i - 1] ** 2) for i in range(3)}
    L = sp.Matrix([[b[0], a[0], a[2]], [a[0], b[1], a[1]], [a[2], a[1], b[2]]])
    traces = [sp.expand((L**power).trace()) for power in (1, 2, 3)]
    laws = tuple(Integral(f"trace_{i}", trace) for i, trace in enumerate(traces, 1))
    return Textbook(
        System("toda", "Toda lattice", field),
        laws,
        Integral("trace_3", traces[2] + a[0] ** 2 * b[0]),
    )


EVERY = [kepler, euler, lotka_volterra, kovalevskaya, toda]


@pytest.mark.parametrize("make", EVERY)
def test_laws_are_proven_with_certificates_that_check(make: Callable[[], Textbook]) -> None:
    book = make()
    for law in book.laws:
        verdict = prove_with_certificate(book.system, law)
        assert verdict.decision == "proven", law.name
        certificate_checker.check(verdict.certificate)


@pytest.mark.parametrize("make", EVERY)
def test_a_planted_error_is_refuted_at_a_point(make: Callable[[], Textbook]) -> None:
    book = make()
    verdict = prove_with_certificate(book.system, book.wrong)
    assert verdict.decision == "refuted"
    assert set(verdict.witness["point"]) == set(map(str, book.system.symbols))
    certificate_checker.check(verdict.certificate)


@pytest.mark.parametrize("make", EVERY)
def test_a_certificate_does_not_pass_for_another_law(make: Callable[[], Textbook]) -> None:
    book = make()
    for law in book.laws:
        if law.name == book.wrong.name:
            certificate = dict(prove_with_certificate(book.system, law).certificate)
            refuted = prove_with_certificate(book.system, book.wrong).certificate
            certificate["claim"] = refuted["claim"]
            with pytest.raises(certificate_checker.CheckError):
                certificate_checker.check(certificate)


@pytest.mark.parametrize(
    ("make", "options", "formulas"),
    [
        (kepler, {"momenta": "u, v", "coordinates": "x, y", "gamma_degree": 1}, {"u*y - v*x"}),
        (euler, {}, {"4*a**2 + b**2", "3*a**2 - c**2"}),
        (
            lotka_volterra,
            {"degree": 1, "gamma_degree": 1, "coordinates": "x, y, log(x), log(y)"},
            {"x + y - log(x) - log(y)"},
        ),
        (
            kovalevskaya,
            {"momenta": "p, q, r", "coordinates": "k, m, n", "gamma_degree": 1},
            {"2*k*p + 2*m*q + n*r", "2*k + 2*p**2 + 2*q**2 + r**2"},
        ),
        (
            toda,
            {},
            {"b_1 + b_2 + b_3", "a_1**2 + a_2**2 + a_3**2 - b_1*b_2 - b_1*b_3 - b_2*b_3"},
        ),
    ],
)
def test_integrals_are_found(
    make: Callable[[], Textbook], options: dict[str, object], formulas: set[str]
) -> None:
    found = list(integrals(search_space(make().system, **options)))
    assert {str(result.law.value) for result in found} == formulas
    assert all(result.verdict.decision == "proven" for result in found)


def test_the_measure_of_prey_and_predators_is_found() -> None:
    found = list(measures(search_space(lotka_volterra().system)))
    x, y = lotka_volterra().system.symbols
    assert any(sp.simplify(result.law.value * x * y).is_number for result in found)
    assert all(result.verdict.decision == "proven" for result in found)

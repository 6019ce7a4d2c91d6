"""§12: open problems, as far as something is claimed of them."""

from __future__ import annotations

from ..statements import ConformallyHamiltonian, Integral, Measure
from ..systems import from_catalogue
from .claim import Case, Claim, Remark
from .printed import law_named


def conformally_hamiltonian(name: str) -> Case:
    """The conformally Hamiltonian form of a system of the catalogue, with its integrals."""
    system = from_catalogue(name)
    kinds = (ConformallyHamiltonian, Integral)
    return tuple((system, law) for law in system.laws if isinstance(law, kinds))


def with_rotors() -> Case:
    """Markeev's generalisation."""
    return conformally_hamiltonian("chaplygin-ball-gyrostat")


def in_bruns_field() -> Case:
    """Kozlov's generalisation."""
    return conformally_hamiltonian("chaplygin-ball-bruns")


def around_a_sphere() -> Case:
    """The problem of Borisov and Fedorov with a Bruns field keeps its integrals and measure."""
    system = from_catalogue("ball-around-sphere-bruns")
    names = ("energy", "momentum", "linear", "measure")
    return tuple((system, law_named(system, name)) for name in names)


def euler_jacobi(name: str) -> Case:
    """All integrals of a system, and its invariant measure."""
    system = from_catalogue(name)
    kinds = (Integral, Measure)
    return tuple((system, law) for law in system.laws if isinstance(law, kinds))


def fedorov() -> Case:
    """A ball in a ball bearing."""
    return euler_jacobi("ball-bearing")


def straight_line() -> Case:
    """A Chaplygin ball along a straight line; the measure is stated in its momenta."""
    plain = from_catalogue("straight-line-ball")
    by_momenta = from_catalogue("straight-line-ball-momenta")
    return (
        *((plain, law) for law in plain.laws),
        (by_momenta, law_named(by_momenta, "energy")),
        (by_momenta, law_named(by_momenta, "measure")),
    )


def four_dimensions() -> Case:
    """Measures in four dimensions."""
    systems = tuple(from_catalogue(name) for name in ("chaplygin-ball-4d", "veselova-4d"))
    return tuple((system, law_named(system, "measure")) for system in systems)


CLAIMS = (
    Claim(
        "§12, problem 1",
        "The generalisation of the Chaplygin ball due to Markeev, with a gyrostat, is conformally "
        "Hamiltonian, and has a quadratic integral.",
        with_rotors,
    ),
    Claim(
        "§12, problem 1",
        "The generalisation of the Chaplygin ball due to Kozlov, in a potential Bruns field, is "
        "conformally Hamiltonian, and has a quadratic integral.",
        in_bruns_field,
    ),
    Claim(
        "§12, problem 1",
        "The Borisov–Fedorov problem of a Chaplygin ball that rolls over a sphere can be "
        "generalised by adding a Bruns field.",
        around_a_sphere,
        note="read as: energy, the momentum integral, the linear integral of $k = -1$ and the "
        "invariant measure have counterparts in the field",
    ),
    Claim(
        "§12, problem 2",
        "Fedorov's system, a ball in a ball-type suspension, is integrable by the Euler–Jacobi "
        "theorem.",
        fedorov,
        note="equations derived here; in space the momentum is constant, so that with the energy "
        "four integrals and a measure are left for a motion in six dimensions",
    ),
    Claim(
        "§12, problem 2",
        "The motion of a Chaplygin ball along a straight line is integrable by the Euler–Jacobi "
        "theorem.",
        straight_line,
        note="equations derived here; two momenta and the energy are constant and a measure is "
        "invariant for a motion in five dimensions",
    ),
    Claim(
        "§12, problem 3",
        "Invariant measures for the multidimensional Chaplygin and Veselova systems are found.",
        four_dimensions,
        note="decided in four dimensions, for arbitrary moments $I_{ij}$; equations derived here",
    ),
)

REMARKS = (
    Remark(
        "§12, problem 1",
        "No general methods exist for integrable systems on a sphere whose quadratic integral "
        "contains terms linear in velocities.",
        "a judgement on the state of the field",
    ),
    Remark(
        "§12, problem 1",
        "Kozlov's problem and the Borisov–Fedorov problem are solved in quadratures where the "
        "linear integral vanishes.",
        "literature [68, 106]; the quadratures are not printed",
    ),
    Remark(
        "§12, problem 2",
        "No conformally Hamiltonian representation is known of either system.",
        "a statement about what is not known",
    ),
    Remark("Remark 25", "Explicit integration is a matter of tradition.", "a judgement"),
    Remark(
        "§12, after Remark 25",
        "It is open whether the Poisson structure can be lifted to the unreduced system.",
        "an open question",
    ),
    Remark(
        "§12, problem 3",
        "Existence of a Poisson structure and integrability of the four-dimensional Chaplygin ball "
        "cannot be stated with assurance.",
        "a statement about what is not known",
    ),
    Remark(
        "§12, problem 4",
        "Nothing is known of tensor invariants of a rolling body with a cavity filled with fluid.",
        "a statement about what is not known",
    ),
)

"""The class of a system and the kind of its motions, from its proven laws (§3.3, §4).

The theorems of Lie (Theorem 3), Euler and Jacobi (Theorem 5), Liouville and Arnold, Poincaré and
Bendixson are applied as stated; every statement follows from the listed facts.
"""

from __future__ import annotations

from dataclasses import dataclass

from .facts import Fact
from .statements import Bracket, Density, IntegrabilityClass, Statement


@dataclass(frozen=True)
class DynamicalStructure:
    """The proven structure of a phase space.

    Attributes
    ----------
    dimension : int
    count : int
        Number of independent first integrals.
    integrals : tuple of Fact
        The facts that prove them.
    measures : tuple of Density
    absence : str
        Reason why no measure has a density on the configuration space, if this is proven.
    brackets : tuple of Bracket
    symmetries : tuple of Fact
        Symmetry fields independent of the flow and of one another.
    lie : tuple of Fact
        Symmetry fields that fulfil Theorem 3, if they do.
    liouville : tuple of Fact
        A Hamiltonian form and sufficiently many integrals in involution, if there are any.
    reversal : tuple of str
        Variables whose change of sign reverses the motion.
    reductions : tuple of Fact
        Proven reductions and separations of variables.
    shifts : tuple of Fact
        Shifts of cyclic variables, if Theorem 5 applies to the system without these variables.
    open : tuple of str
        Laws that would give a measure but are not proven without conditions, with their verdicts.
    """

    dimension: int
    count: int
    integrals: tuple[Fact, ...]
    measures: tuple[Density, ...]
    absence: str
    brackets: tuple[Bracket, ...]
    symmetries: tuple[Fact, ...]
    lie: tuple[Fact, ...]
    liouville: tuple[Fact, ...]
    reversal: tuple[str, ...]
    reductions: tuple[Fact, ...]
    open: tuple[str, ...] = ()
    shifts: tuple[Fact, ...] = ()

    @property
    def remaining(self) -> int:
        """Dimension of a common level of the integrals."""
        return self.dimension - self.count

    @property
    def volume(self) -> Density | None:
        """The best of the measures, or that of a Hamiltonian form (§3.3)."""
        forms = tuple(Density(b.law, b.sign) for b in self.brackets)
        known = self.measures or forms
        return min(known, key=lambda m: _ORDER[m.sign]) if known else None

    @property
    def lasting(self) -> bool:
        """Whether a measure with positive, finite density excludes attracting sets."""
        return self.volume is not None and self.volume.sign == "kept"

    @property
    def form(self) -> Bracket | None:
        """The best of the Hamiltonian forms."""
        known = self.brackets
        return min(known, key=lambda b: (b.conformal, _ORDER[b.sign])) if known else None

    @property
    def euler_jacobi(self) -> bool:
        """Whether Theorem 5 applies."""
        return self.remaining == 2 and self.volume is not None

    @property
    def complete(self) -> tuple[Fact, ...]:
        """A Hamiltonian form with enough integrals in involution for Liouville's theorem.

        Up to rank four it suffices to count integrals: every integral is in involution with H.
        """
        best = self.form
        if best is not None and best.closed and best.rank <= 4 and 2 * self.remaining == best.rank:
            return (best.law, *self.integrals)
        return self.liouville


_ORDER = {"kept": 0, "unknown": 1, "changes": 2}


def classes_and_dynamics(
    facts: DynamicalStructure,
) -> tuple[tuple[IntegrabilityClass, ...], tuple[Statement, ...]]:
    """The classes of a system, and the possible kinds of its motions."""
    return _kinds(facts), (*_motions(facts), *_attraction(facts), *_pairing(facts))


def _pairing(facts: DynamicalStructure) -> list[Statement]:
    """Consequences of reversibility if attraction is not excluded."""
    if not facts.reversal:
        return []
    changed = ", ".join(f"{name} ↦ −{name}" for name in facts.reversal)
    return [
        Statement(
            f"The motion is reversible ({changed}): to every attracting set there belongs a "
            "repelling one, its mirror image."
        )
    ]


# --- classes -------------------------------------------------------------------------------


def _kinds(facts: DynamicalStructure) -> tuple[IntegrabilityClass, ...]:
    kinds: list[IntegrabilityClass] = []
    if facts.remaining <= 1:
        kinds.append(
            IntegrabilityClass(
                "curves",
                "integrable by its integrals alone: a common level is a curve, and the motion on "
                "it a quadrature",
                facts.integrals,
            )
        )
    if facts.lie:
        kinds.append(
            IntegrabilityClass(
                "lie",
                f"integrable by Lie's theorem: {_number(facts.count, 'integral')} and "
                f"{_number(len(facts.lie), 'symmetry field')} that leave them alone and span a "
                "solvable algebra",
                (*facts.integrals, *facts.lie),
            )
        )
    if facts.euler_jacobi and facts.volume is not None:
        kinds.append(
            IntegrabilityClass(
                "euler-jacobi",
                f"integrable by Euler and Jacobi: {_number(facts.count, 'integral')} in "
                f"{facts.dimension} dimensions and an invariant measure, whose density is the last "
                "multiplier",
                (*facts.integrals, facts.volume.law),
            )
        )
    if facts.shifts and facts.volume is not None:
        kinds.append(
            IntegrabilityClass(
                "euler-jacobi",
                "integrable by Euler and Jacobi without what is shifted, on which nothing else "
                f"depends: {_number(facts.count, 'integral')} in "
                f"{facts.dimension - len(facts.shifts)} dimensions and an invariant measure; it "
                "follows by a quadrature",
                (*facts.integrals, facts.volume.law, *facts.shifts),
            )
        )
    kinds += _hamiltonian(facts)
    return tuple(kinds) or (IntegrabilityClass("none known", _lacking(facts), facts.reductions),)


def _hamiltonian(facts: DynamicalStructure) -> list[IntegrabilityClass]:
    best = facts.form
    if best is None:
        return []
    rank = f"the Poisson structure has rank {best.rank}"
    if not best.closed:
        rank += ", its leaves are no levels of single-valued functions"
    kinds = []
    if best.conformal:
        where = {
            "kept": "",
            "unknown": ", wherever the multiplier does not vanish",
            "changes": ", except where the multiplier vanishes or is infinite",
        }[best.sign]
        kinds.append(
            IntegrabilityClass(
                "conformally hamiltonian",
                f"conformally Hamiltonian: Hamiltonian in a new time{where}; {rank}",
                (best.law,),
            )
        )
    else:
        kinds.append(IntegrabilityClass("hamiltonian", f"Hamiltonian; {rank}", (best.law,)))
    if facts.complete:
        kinds.append(
            IntegrabilityClass(
                "liouville",
                "integrable in the sense of Liouville"
                + (", in the new time" if best.conformal else "")
                + ": as many integrals in involution as half the rank",
                facts.complete,
            )
        )
    return kinds


def _lacking(facts: DynamicalStructure) -> str:
    """The missing conditions of the theorem of Euler and Jacobi."""
    missing = []
    if facts.remaining > 2:
        missing.append(f"{_number(facts.remaining - 2, 'further integral')}")
    if facts.volume is None:
        missing.append("an invariant measure")
    text = (
        "none known: the laws proven here fulfil no theorem of integrability; that of Euler and "
        f"Jacobi lacks {' and '.join(missing)}"
    )
    if facts.reductions:
        text += "; proven reductions may lead further"
    return text


def _number(count: int, what: str) -> str:
    words = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight")
    word = words[count] if count < len(words) else str(count)
    plural = what[:-1] + "ies" if what.endswith("y") else what + "s"
    return f"{word} {what if count == 1 else plural}"


# --- motions -------------------------------------------------------------------------------


def _motions(facts: DynamicalStructure) -> list[Statement]:
    if facts.remaining <= 1:
        return [
            Statement(
                "Every motion runs along a curve: periodic where the curve is closed and free of "
                "equilibria, towards or away from an equilibrium where it is not. No chaos.",
                facts.integrals,
            )
        ]
    if facts.complete and facts.form is not None:
        form = facts.form
        time = "new time" if form.conformal else "time"
        half = form.rank // 2
        text = [
            f"On compact common levels without equilibria: straight, uniform windings of "
            f"{half}-dimensional tori in the {time}, quasi-periodic or periodic. No chaos."
        ]
        if form.conformal and facts.euler_jacobi:
            text.append(
                "In the time itself the windings are not uniform: on a resonant torus the periods "
                "may differ from one trajectory to the next."
            )
        return [Statement(" ".join(text), facts.complete)]
    if facts.euler_jacobi and facts.volume is not None:
        return [
            Statement(
                "On compact common levels without equilibria on which the measure is regular: tori "
                "wound by straight lines after a change of time (θ̇ = λ/Φ), not uniformly in the "
                "time itself; on a resonant torus the periods may differ. No chaos.",
                (*facts.integrals, facts.volume.law),
            )
        ]
    if facts.shifts and facts.volume is not None:
        return [
            Statement(
                "But for what is shifted: on compact common levels without equilibria on which the "
                "measure is regular, tori wound by straight lines after a change of time "
                "(θ̇ = λ/Φ). No chaos.",
                (*facts.integrals, facts.volume.law, *facts.shifts),
            )
        ]
    if facts.lie:
        return [
            Statement(
                "Every motion is given by quadratures. No chaos.",
                (*facts.integrals, *facts.lie),
            )
        ]
    if facts.remaining == 2:
        return [
            Statement(
                "Motions on surfaces: equilibria, closed orbits, limit cycles and windings, but "
                "no chaos.",
                facts.integrals,
            )
        ]
    levels = f"{facts.remaining}-dimensional levels" if facts.count else "the whole phase space"
    if facts.volume is not None and facts.volume.sign != "changes":
        best = facts.volume
        manner = "Hamiltonian" if facts.brackets else "volume-preserving"
        return [
            Statement(
                f"Chaos is not excluded: {manner} motion on {levels}, where regular and chaotic "
                "motions can lie side by side.",
                (*facts.integrals, best.law),
            )
        ]
    return [
        Statement(
            f"Nothing proven bounds the complexity of the motion on {levels}: chaos is not "
            "excluded.",
            facts.integrals,
        )
    ]


def _attraction(facts: DynamicalStructure) -> list[Statement]:
    best = facts.volume
    if best is None:
        if facts.remaining <= 1:
            return []
        kinds = "attracting equilibria and limit cycles"
        if facts.remaining > 2:
            kinds = "attracting equilibria, limit cycles, attracting tori"
            kinds += "" if facts.lie else " and strange attractors"
        known = "No invariant measure is proven"
        if facts.absence:
            known += ", and none has a density that depends on the configuration alone"
        if facts.open:
            known += f" ({'; '.join(facts.open)})"
        return [Statement(f"{known}: {kinds} are not excluded.")]
    if best.sign == "kept":
        return [
            Statement(
                "No attracting sets: a measure with positive, finite density is invariant."
                if facts.measures
                else "No attracting sets: on symplectic leaves of full rank the measure of the "
                "Hamiltonian form is invariant.",
                (best.law,),
            )
        ]
    if best.sign == "changes":
        return [
            Statement(
                "The density vanishes or is infinite somewhere: motions may tend to that set, and "
                "every attracting set meets it.",
                (best.law,),
            )
        ]
    return [
        Statement(
            "No attracting sets, wherever the density of the measure is positive and finite (not "
            "shown for every point).",
            (best.law,),
        )
    ]

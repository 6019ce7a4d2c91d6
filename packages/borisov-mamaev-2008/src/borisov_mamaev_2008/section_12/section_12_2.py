"""§12: statements on the open problems that were not computed."""

from __future__ import annotations

from ..claim import Claim, Remark
from ..open_problems.findings import findings_of

CLAIMS: tuple[Claim, ...] = ()

REMARKS = (
    Remark(
        "§12, problem 1, Clebsch",
        "Explicit integration of such systems is connected with explicit integration of the "
        "Clebsch-type systems with nonzero integral of areas.",
        "a programme; which connection is not said. Known is: for the free ball with a zero "
        "constant of areas the isomorphism with the Clebsch case is proven (Theorem 10); for "
        "Markeev's and Kozlov's balls, and for a constant that is not zero, neither an isomorphism "
        "nor quadratures are known here (docs/open-problems.md, 1a)",
    ),
    Remark(
        "§12, problem 1, Clebsch",
        "The problem remains unsolved in spite of [107–109]; no attempts are reported of using the "
        "formulas to obtain any characteristics of motion.",
        "a statement about the literature",
    ),
    Remark(
        "§12, problem 1",
        "The Borisov–Fedorov problem in a Bruns field is still not solved in terms of quadratures.",
        "a statement about what is not known. Here it is solved for a zero linear integral and put "
        "in conformally Hamiltonian form on every level of it; other quadratures are not known "
        "(docs/open-problems.md, 1d)",
    ),
    Remark(
        "§12, problem 2",
        "Both systems are very close to generalized Chaplygin systems with two degrees of freedom.",
        "what is close is not said. Known is: a ball in a ball bearing with two equal eigenvalues "
        "of its tensor is the Chaplygin ball with another D, hence such a system: proven; for "
        "three different ones, and for the ball along a line, no such form is known here "
        "(docs/open-problems.md, 2a, 2b)",
        findings=findings_of("2a"),
    ),
    Remark(
        "§12, problem 2",
        "Attempts to obtain a Poisson structure or perform reduction of order have not been "
        "successful.",
        "a statement about what is not known. For a ball bearing brackets of cotangent type on the "
        "unreduced system are refuted (docs/open-problems.md)",
        findings=findings_of("lift"),
    ),
    Remark(
        "Remark 25, end",
        "Methods of topological analysis [48, 111] have never been applied to nonholonomic "
        "problems; their extension does not seem to encounter any fundamental difficulties.",
        "a statement about the literature of 2008. They can be applied: bifurcation diagrams of "
        "the nonholonomic systems that are solved here in closed form are computed exactly "
        "(nonholonomic/docs/bifurcations.md)",
    ),
    Remark(
        "§12, after Remark 25",
        "A conformally Hamiltonian representation has been obtained only for reduced systems.",
        "a statement about this paper",
    ),
    Remark(
        "§12, problem 3",
        "Integrability of the multidimensional systems is not studied, and there is no strategy; "
        "it seems natural to represent each in conformally Hamiltonian form and use the Liouville "
        "theorem.",
        "literature and a programme; for rigid bodies of four dimensions no such form exists with "
        "the known integrals near certain levels (docs/open-problems.md, 3)",
        findings=findings_of("3", "3, level"),
    ),
    Remark(
        "§12, problem 4",
        "The problem is classical and seldom discussed; there is nothing but a stability analysis "
        "of partial solutions [116].",
        "literature",
    ),
)

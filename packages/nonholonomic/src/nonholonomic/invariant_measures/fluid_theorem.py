"""A rolling body with fluid has an invariant measure ρ(γ) exactly if its equivalent body does.

At every normal γ the field of the body with fluid differs from that of the equivalent rigid body,
in the variables ω (or M − CN), γ, N, by a field u that leaves γ fixed:

    ω′ = S(CN×ω − C(ξ×N)),      N′ = ξ×N,      ξ = K⁻¹N − Cω,

with a symmetric S: the inverse Ĩ⁻¹ of the tensor of inertia about the contact point for a marble
contact, and Ĩ⁻¹ − Ĩ⁻¹γ⊗Ĩ⁻¹γ/(γ, Ĩ⁻¹γ) for a rubber one.  The lemma is that u has no divergence,
whatever the symmetric tensors S, C and K are; docs/fluid.md has the proof of the theorem from it.
"""

from __future__ import annotations

from functools import cache

from flowlanes.system.laws import Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Symmetric, Vector, cross
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict

omega, N, xi = Vector("omega"), Vector("N"), Vector("xi")
S, C, W = Symmetric("S"), Symmetric("C"), Symmetric("W")

THEOREM = (
    "a body with fluid in ellipsoidal cavities has such a measure if and only if the rigid body "
    "with Zhukovsky's equivalent inertia has one, with the same density"
)


def action_of_fluid() -> System:
    """The field u by which fluid changes the motion of its equivalent body, at a fixed normal."""
    units = {S: "1/(kg m^2)", C: "1", W: "1/(kg m^2)"}
    return System(
        name="action-of-fluid",
        title="The action of a fluid on the body that holds it",
        field={omega: S * (cross(C * N, omega) - C * cross(xi, N)), N: cross(xi, N)},
        definitions={xi: W * N - C * omega},
        parameters=tuple(
            Parameter(s, "entry of a symmetric tensor", 1.0, unit)
            for tensor, unit in units.items()
            for s in tensor.symbols
        ),
    )


@cache
def lemma() -> Verdict:
    """The verdict on the lemma: u preserves the volume, for all symmetric S, C and K."""
    return prove(action_of_fluid(), Measure("volume", (), "the fluid keeps the volume"))

"""Decomposition of the zero set of the conditions into components.

The real points at which the conditions vanish are a union of *components*, each with a triangular
chain of polynomials. The initials (leading coefficients in the main variables) of a chain vanish
on no part of its component that would be a component itself. A polynomial whose pseudo-remainder
by the chain is zero therefore vanishes on the whole component: times a product of initials it lies
in the ideal of the chain, and the component is the closure of its points at which no initial
vanishes.

All steps are exact. A condition that factors gives one branch for each factor; a factor that
cannot vanish on the domain is dropped; a sum of terms of one sign vanishes only if all terms do.
If the zeros of an initial could contain a component, as the dimensions show, they are decomposed
as well.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

from flowlanes.formulas.errors import EmptyLevelError, OutOfReachError

from ..fields.function_field import FunctionField
from ..fields.quotient_ring import Poly, initial_of
from ..fields.signs import Signs
from .triangular_set import chain

Polys: TypeAlias = tuple[Poly, ...]

MOST_STEPS = 600
"""Maximum number of systems of conditions that a decomposition may visit."""


@dataclass(frozen=True)
class Component:
    """A component of a level.

    Attributes
    ----------
    equations : tuple of polynomials
        Polynomials whose common zero set is the component.
    defining_factors : tuple of polynomials
        The factors and initials whose vanishing distinguishes it from the other components.
    parent : Component, optional
        For a part where an initial vanishes, the component with this initial.
    inner : bool
        Whether the part lies in the closure of other components, because its dimension is below
        the lower bound for components of the whole.
    """

    equations: Polys
    defining_factors: Polys = ()
    parent: Component | None = None
    inner: bool = False


@dataclass(frozen=True)
class _Part:
    """Intermediate equations; `squared` if complex zeros were dropped."""

    equations: Polys
    defining_factors: Polys = ()
    parent: Component | None = None
    squared: bool = False


@dataclass
class Decomposition:
    """The decomposition of conditions into components.

    Parameters
    ----------
    draft : FunctionField
        The field to which the conditions belong.
    names : sequence of str
        Variables that may be main variables.
    moving : set of str
        Names of the state variables.
    signs : Signs
        Known signs on the domain.
    """

    draft: FunctionField
    names: Sequence[str]
    moving: set[str]
    signs: Signs
    _steps: int = field(default=0, init=False)

    def components(self, conditions: Sequence[Poly]) -> tuple[Component, ...]:
        """The components; those that restrict the state precede those that restrict parameters.

        Raises
        ------
        OutOfReachError
            If there are too many, or a condition cannot be made triangular.
        """
        # By Krull's height theorem every component has at least this dimension.
        least = len(self.names) - len(conditions)
        waiting = [_Part(tuple(conditions))]
        components: list[Component] = []
        while waiting:
            part = waiting.pop(0)
            forks = self._forks(part.equations, self._real)
            if forks is not None:
                waiting = [
                    _Part(
                        fork.equations,
                        (*part.defining_factors, *fork.defining_factors),
                        part.parent,
                        part.squared or fork.squared,
                    )
                    for fork in forks
                ] + waiting
                continue
            triangular = self._chain(part.equations)
            dimension = len(self.names) - len(triangular)
            inner = part.parent is not None and not part.squared and dimension < least
            component = Component(part.equations, part.defining_factors, part.parent, inner)
            components.append(component)
            for initial in self._initials(triangular):
                if not self._thin(part.equations, triangular, initial):
                    further = (*part.equations, initial)
                    chosen = (*part.defining_factors, initial)
                    waiting.append(_Part(further, chosen, part.parent or component, part.squared))
        return self._without_repeated(components)

    def _without_repeated(self, components: Sequence[Component]) -> tuple[Component, ...]:
        """The components that are contained in no other; parts of a kept component stay."""
        own = [part for part in components if part.parent is None]
        distinct: list[Component] = []
        for index, part in enumerate(own):
            others = [*distinct, *own[index + 1 :]]
            if not any(self._within(part, other) for other in others):
                distinct.append(part)
        return tuple(
            part
            for part in components
            if any(part is one or part.parent is one for one in distinct)
        )

    def _within(self, part: Component, other: Component) -> bool:
        """True if the equations of `other` vanish on a component, by its chain."""
        triangular = self._chain(part.equations)
        return all(not self._remainder(poly, triangular) for poly in other.equations)

    def _remainder(self, poly: Poly, triangular: Sequence[tuple[str, Poly]]) -> Poly:
        for main, relation in reversed(triangular):
            poly = self.draft.pseudo_remainder(poly, relation, main)
        return poly

    # --- one step --------------------------------------------------------------------------

    def _forks(
        self, equations: Polys, alternatives: Callable[[Poly], list[Polys]]
    ) -> list[_Part] | None:
        """Systems whose zeros together are those of the equations; None if nothing factors."""
        self._steps += 1
        if self._steps > MOST_STEPS:
            raise OutOfReachError(
                f"the level falls into components in more than {MOST_STEPS} steps"
            )
        for index, equation in enumerate(equations):
            choices = alternatives(equation)
            if choices != [(equation,)]:
                others = (*equations[:index], *equations[index + 1 :])
                return self._parts_of_fork(others, choices)
        try:
            triangular = self._chain(equations)
        except EmptyLevelError:
            return []
        known = {str(poly) for poly in equations}
        for _, poly in triangular:
            choices = alternatives(poly)
            # A factor that is among the equations already would lead back to the same system.
            if choices != [(poly,)] and not any({*map(str, polys)} <= known for polys in choices):
                return self._parts_of_fork(equations, choices)
        return None

    def _parts_of_fork(self, others: Polys, choices: list[Polys]) -> list[_Part]:
        choices = sorted(choices, key=lambda polys: not any(map(self._moves, polys)))
        known = {str(poly) for poly in others}
        return [
            _Part(
                (
                    *others,
                    *(
                        p
                        for p in dict(zip(map(str, polys), polys, strict=True)).values()
                        if str(p) not in known
                    ),
                ),
                polys if len(choices) > 1 else (),
                squared=len(polys) > 1,
            )
            for polys in choices
        ]

    def _complex(self, poly: Poly) -> list[Polys]:
        """The factors that can vanish on the domain; [(poly,)] if poly is irreducible."""
        if not poly:
            return [()]
        if poly.is_constant():
            return []
        _, parts = poly.factor()
        real = [part for part, _ in parts if not self.signs.never_zero(part)]
        if len(real) == 1 and _alike(real[0], poly):
            return [(poly,)]
        return [(part,) for part in real]

    def _real(self, poly: Poly) -> list[Polys]:
        """Alternatives over the reals: a sum of squares becomes several equations."""
        real: list[Polys] = []
        for polys in self._complex(poly):
            squares = self.signs.squares(polys[0]) if polys else None
            if squares is None or (len(squares) == 1 and _alike(squares[0], polys[0])):
                real.append(polys)
            elif not any(base.is_constant() for base in squares):
                real.append(tuple(squares))
        return real

    def _chain(self, equations: Polys) -> list[tuple[str, Poly]]:
        return chain(self.draft, self.names, equations, self.moving)

    def _moves(self, poly: Poly) -> bool:
        degrees = zip(self.draft.names, poly.degrees(), strict=True)
        return bool(self.moving & {name for name, degree in degrees if degree})

    # --- where initials vanish -------------------------------------------------------------

    def _initials(self, triangular: Sequence[tuple[str, Poly]]) -> list[Poly]:
        """Irreducible factors of the initials that are not known to be non-zero."""
        initials: dict[str, Poly] = {}
        for main, poly in triangular:
            position = self.draft.names.index(main)
            lead = initial_of(poly, position)
            if not lead.is_constant():
                for part, _ in lead.factor()[1]:
                    if not self.signs.never_zero(part):
                        initials.setdefault(str(part), part)
        return list(initials.values())

    def _thin(
        self, equations: Polys, triangular: Sequence[tuple[str, Poly]], initial: Poly
    ) -> bool:
        """True if the zeros of an initial contain no component.

        If the chain has m polynomials, all components of its zero set have dimension n − m or
        more; likewise for the equations if there are m of them. A set of codimension m + 1 or more
        therefore contains none.
        """
        bound = len(triangular) + 1
        bases = [tuple(poly for _, poly in triangular)]
        if len(equations) == len(triangular):
            bases.append(equations)
        return any(self.within((*base, initial), bound) for base in bases)

    def within(self, equations: Sequence[Poly], codimension: int) -> bool:
        """True if the zero set has at least the given codimension everywhere."""
        waiting = [tuple(equations)]
        budget = MOST_STEPS // 4
        while waiting:
            budget -= 1
            if not budget:
                return False
            current = waiting.pop()
            try:
                forks = self._forks(current, self._complex)
                if forks is not None:
                    waiting += [fork.equations for fork in forks]
                    continue
                triangular = self._chain(current)
            except OutOfReachError:
                return False
            if len(triangular) < codimension:
                return False
            waiting += [(*current, initial) for initial in self._initials(triangular)]
        return True


def _alike(first: Poly, second: Poly) -> bool:
    """True if two polynomials are proportional."""
    ratio = first.leading_coefficient() / second.leading_coefficient()
    return bool(first == ratio * second)

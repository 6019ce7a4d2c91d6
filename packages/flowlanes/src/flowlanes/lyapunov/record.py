"""Description of a Lyapunov spectrum in sentences, and its plain data."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..orbits.reversor import Reversor
from .averages import Average
from .report import CAREFUL, Spectrum, sign_word, significant_digits


def remarks(spectrum: Spectrum, reversors: Sequence[Reversor] = ()) -> Iterator[str]:
    """Sentences about the results of a spectrum; observed unless they say proven.

    Parameters
    ----------
    spectrum : Spectrum
    reversors : sequence of Reversor
        Reversing symmetries of the system; those that hold for these parameters are used.
    """
    yield from _convergence(spectrum)
    for name in spectrum.fading:
        yield (
            f"no exponent is made trivial by {name} on this motion, because its size does not "
            "last: the motion comes to rest, or runs away"
        )
    yield from _kind(spectrum)
    yield from _volumes(spectrum)
    holding = [reversor for reversor in reversors if reversor.holds(spectrum.parameters)]
    if holding:
        yield from _pairs(spectrum, holding[0])


def _is_undecided(spectrum: Spectrum) -> bool:
    """True if an error is not smaller than the fluctuations of the growth."""
    counted = spectrum.growth[round(spectrum.began / spectrum.interval) :]
    rates = counted.std(axis=0) / spectrum.interval
    return any(
        item.error > max(2 * item.resolution, CAREFUL * rate)
        for item, rate in zip(spectrum.exponents, rates, strict=True)
    )


def _convergence(spectrum: Spectrum) -> Iterator[str]:
    for number, item in zip(spectrum.numbers, spectrum.exponents, strict=True):
        if not item.halves_agree:
            first, second = item.halves
            yield (
                f"λ{number} has not converged: {first:.3g} over the first half of the time, "
                f"{second:.3g} over the second; integrate for longer (--until)"
            )
    if abs(spectrum.volume.balance) > CAREFUL * spectrum.total.error:
        yield (
            f"the mean of the divergence has a further uncertainty of "
            f"{abs(spectrum.volume.balance):.2g}: it varies faster than it is sampled"
        )


def _kind(spectrum: Spectrum) -> Iterator[str]:
    if not spectrum.exponents:
        yield "integrals, relations and symmetries make all exponents trivial"
    elif spectrum.chaotic:
        yield "the largest exponent is positive: the motion is chaotic (observed)"
    elif all(item.zero for item in spectrum.exponents) and _is_undecided(spectrum):
        yield (
            "no exponent differs from zero beyond its error, but the errors are not small beside "
            "the rates at which deviations grow and shrink along the motion: nothing can be "
            "concluded yet; integrate for longer (--until)"
        )
    elif all(item.zero for item in spectrum.exponents) and spectrum.halves_agree:
        yield (
            "no exponent differs from zero beyond its error: the motion is regular as far as this "
            "time shows (observed)"
        )
    elif spectrum.halves_agree and spectrum.exponents[0].value < -spectrum.exponents[0].error:
        yield (
            "all exponents but the trivial ones are negative: a periodic or steady motion attracts "
            "this one (observed)"
        )


def _volumes(spectrum: Spectrum) -> Iterator[str]:
    total = spectrum.total
    changing = bool(spectrum.exponents) and total.halves_agree and not total.zero
    for name, defect in spectrum.volume.measures.items():
        if abs(defect) <= CAREFUL * total.error:
            limit = "grows beyond all bounds" if total.value < 0 else "goes to zero"
            yield (
                f"the density of the invariant measure {name!r} accounts for the mean of the "
                f"divergence, to {abs(defect):.1g}"
                + (f": it {limit} along this motion, and so excludes nothing" if changing else "")
            )
        else:
            yield (
                f"the density of the invariant measure {name!r} does not account for the mean of "
                f"the divergence, by {abs(defect):.1g}: the motion runs where it is not defined"
            )
    if not changing:
        return
    way, end = ("contracts", "attracts") if total.value < 0 else ("expands", "repels")
    yield (
        f"phase volume {way} along this motion: near its limit set there is no invariant measure "
        "with a smooth positive density (observed, not proven)"
    )
    if spectrum.chaotic and total.value < 0:
        value, error = significant_digits(*spectrum.dimension)
        level = any(item.kind == "integral" for item, _ in spectrum.trivial)
        place = " on the level of the integrals" if level else ""
        yield f"a chaotic set {end} it, of Kaplan–Yorke dimension {value} ± {error}{place}"


def _pairs(spectrum: Spectrum, reversor: Reversor) -> Iterator[str]:
    yield (
        f"the equations are reversible (proven): {reversor.words(spectrum.system)} with the time"
    )
    if spectrum.exponents and spectrum.halves_agree and not _is_undecided(spectrum):
        yield (
            "the exponents form pairs of opposite sign within their errors"
            if spectrum.symmetric
            else "the exponents do not form pairs of opposite sign: the reversed motion has the "
            "opposite exponents and is a different motion"
        )


def record(spectrum: Spectrum, reversors: Sequence[Reversor] = ()) -> dict[str, object]:
    """A spectrum as numbers, strings and lists of these."""
    return {
        "system": spectrum.system.name,
        "parameters": spectrum.parameters,
        "start": spectrum.start.tolist(),
        "units": dict.fromkeys(("exponents", "seen", "sum", "mean_divergence"), "1/s")
        | dict.fromkeys(("until", "counted_from", "interval"), "s"),
        "until": spectrum.t_end,
        "counted_from": spectrum.began,
        "interval": spectrum.interval,
        "exponents": [
            {"number": number} | _average(item) | {"word": sign_word(item)}
            for number, item in zip(spectrum.numbers, spectrum.exponents, strict=True)
        ],
        "removed": [
            {"number": number, "name": item.name, "kind": item.kind, "seen": rate}
            for number, (item, rate) in zip(spectrum.trivial_numbers, spectrum.trivial, strict=True)
        ],
        "dependent": list(spectrum.dependent),
        "fading": list(spectrum.fading),
        "sum": _average(spectrum.total),
        "mean_divergence": _average(spectrum.volume.divergence),
        "balance": spectrum.volume.balance,
        "measures": spectrum.volume.measures,
        "dimension": dict(zip(("value", "error"), spectrum.dimension, strict=True)),
        "settled": spectrum.halves_agree,
        "symmetric": spectrum.symmetric,
        "reversors": [
            {
                "odd": [str(s) for s in item.odd],
                "needs_zero": [str(s) for s in item.vanishing],
                "holds": item.holds(spectrum.parameters),
            }
            for item in reversors
        ],
        "remarks": list(remarks(spectrum, reversors)),
    }


def _average(item: Average) -> dict[str, object]:
    return {
        "value": item.value,
        "error": item.error,
        "statistical": item.statistical,
        "wandering": item.wandering,
        "resolution": item.resolution,
        "halves": list(item.halves),
        "settled": item.halves_agree,
    }

"""``chaplygin lyapunov``: the Lyapunov spectrum of a motion."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from flowlanes.system.tolerance import ENSEMBLE_TOLERANCE

from ..interruption import EXIT_CODE, NOTHING_SAVED, message_on_interrupt, print_interruption
from .terminal.options import console, inform, print_json, study_of
from .terminal.output_destination import STANDARD_OUTPUT, beside, check_output, deliver, name_of
from .terminal.progress import progress
from .terminal.stores import device_of, level_of

if TYPE_CHECKING:
    from flowlanes.lyapunov.averages import Average
    from flowlanes.lyapunov.report import Spectrum

#: Default duration of the motion, in units of that of the experiment.
TIMES_LONGER = 10.0


def command(
    what: str,
    until: float | None = None,
    level: str | None = None,
    seed: int = 0,
    tolerance: float = ENSEMBLE_TOLERANCE,
    device: str = "cpu",
    output: Path | None = None,
    overrides: list[str] | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Compute the Lyapunov exponents of a motion, with errors and the trivial ones named.

    A trivial exponent is zero for a known reason: an integral, a symmetry, the
    flow.
    """
    from flowlanes.errors import InputError, InterruptionError

    if output is not None:
        if output.suffix != ".nc" and output != STANDARD_OUTPUT:
            raise InputError(f"--output {output}: its name must end in .nc")
        check_output("--output", output, force, json, what)
    numbers, chosen = None if level is None else level_of(level), device_of(device)
    study = study_of(what, overrides)
    from flowlanes.flow.sampling.resampling import resampled_level
    from flowlanes.lyapunov.record import record
    from flowlanes.lyapunov.report import Spectrum
    from flowlanes.lyapunov.spectrum import lyapunov_spectrum
    from flowlanes.orbits.reversor import reversing_symmetries

    from ..experiment.single_system import without_reconstruction

    system = without_reconstruction(study)
    if numbers is None:
        start = [float(x) for x in study.start[: len(system.symbols)]]
    else:
        start = resampled_level(system, numbers).draw(1, seed=seed)[0].tolist()
    length = TIMES_LONGER * study.until if until is None else until
    interrupted = ""
    with message_on_interrupt(
        NOTHING_SAVED, "the spectrum of the motion so far is being evaluated"
    ):
        try:
            with progress(study.system.title) as report:
                spectrum = lyapunov_spectrum(
                    system,
                    start,
                    t_end=length,
                    tolerance=tolerance,
                    device=chosen,
                    progress=report,
                )
        except InterruptionError as stop:
            if not isinstance(stop.partial, Spectrum):
                raise KeyboardInterrupt from stop
            spectrum = stop.partial
            kept, again = (
                ("printed", "the same command")
                if output is None or output == STANDARD_OUTPUT
                else (f"in {output}", "the same command with --force")
            )
            interrupted = (
                f"at t = {spectrum.t_end:g} of {length:g}; the spectrum up to then is {kept}; "
                f"{again} starts from the beginning"
            )
        turned = reversing_symmetries(system)
        if output is not None:
            deliver(spectrum.dataset(), output, force)
        with beside(output):
            if json:
                print_json(record(spectrum, turned))
            else:
                _print(spectrum, turned)
        if output is not None:
            inform(f"written to {name_of(output)}")
    if interrupted:
        print_interruption(interrupted)
        raise typer.Exit(EXIT_CODE)


def _print(spectrum: Spectrum, reversors: Any) -> None:
    from rich import box
    from rich.markup import escape
    from rich.table import Table

    from flowlanes.lyapunov.averages import Average
    from flowlanes.lyapunov.record import remarks
    from flowlanes.lyapunov.report import sign_word, significant_digits

    typer.echo(spectrum.system.title)
    typer.echo(
        f"integrated to t = {spectrum.t_end:g} s, averaged from {spectrum.began:g} s, "
        f"{len(spectrum.growth)} intervals; exponents in 1/s"
    )
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
    table.add_column("", style="bold", no_wrap=True)
    table.add_column("exponent", justify="right", no_wrap=True)
    table.add_column("error", justify="right", no_wrap=True)
    table.add_column("")
    for number, item in enumerate(spectrum.in_order, 1):
        row = (
            (*significant_digits(item.value, item.error), sign_word(item))
            if isinstance(item, Average)
            else ("0", "", f"trivial: {escape(item.name)}")
        )
        table.add_row(f"λ{number}", *row)
    total, mean = spectrum.total, spectrum.volume.divergence
    if spectrum.exponents:
        table.add_row("sum", *significant_digits(total.value, total.error), word_of_sum(total))
    table.add_row(
        "divergence", *significant_digits(mean.value, mean.error), "mean along the motion"
    )
    zeros = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
    zeros.add_column("trivial", style="bold", no_wrap=True)
    zeros.add_column("exponent", justify="right", no_wrap=True)
    zeros.add_column("measured", justify="right", no_wrap=True)
    zeros.add_column("")
    for forced, rate in spectrum.trivial:
        shown = ("", "") if rate is None else ("0", f"{rate:.1e}" if rate else "0")
        kind = "" if forced.name == forced.kind else f"{forced.kind}: "
        zeros.add_row(escape(forced.name), *shown, f"{kind}{forced.reason}")
    terminal = console()
    typer.echo()
    terminal.print(table)
    if spectrum.trivial:
        typer.echo()
        terminal.print(zeros)
    typer.echo()
    if spectrum.dependent:
        typer.echo(
            f"No further exponent is made trivial by {', '.join(spectrum.dependent)} at this start."
        )
    for text in remarks(spectrum, reversors):
        first = text[0].upper() if text[0].isascii() else text[0]
        typer.echo(f"{first}{text[1:]}.")


def word_of_sum(total: Average) -> str:
    """The meaning of the sum of the exponents."""
    if not total.halves_agree:
        return "not converged"
    if total.zero:
        return "phase volume preserved within the error"
    return "phase volume expands" if total.value > 0 else "phase volume contracts"

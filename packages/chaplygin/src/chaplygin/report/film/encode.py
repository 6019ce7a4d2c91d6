"""Encode frames as a film, written atomically."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import chain, islice
from pathlib import Path

import numpy as np

from ...experiment.files import atomic_file
from ..drawing.style import TIME_COLOURS
from .encoders import ENCODERS
from .frames import Picture, Size

#: Number of colours from the first frames of a GIF, and the number of these frames; the remaining
#: colours are those of paths.
_COLOURS, _FIRST = 160, 24


def write_film(frames: Iterable[Picture], path: Path, rate: int, size: Size) -> None:
    """Encode frames in the format of the file name.

    Parameters
    ----------
    frames : iterable of array (height, width, 3)
    path : Path
        Ending in .mp4, .webm or .gif.
    rate : int
        Frames per second.
    size : (int, int)
        Width and height in pixels, even numbers.
    """
    suffix = path.suffix.lower()
    with atomic_file(path) as place:
        if suffix == ".gif":
            _write_gif(iter(frames), place, rate)
        else:
            _write_video(frames, place, suffix, rate, size)


def _write_video(
    frames: Iterable[Picture], place: Path, suffix: str, rate: int, size: Size
) -> None:
    import av

    encoder, settings = ENCODERS[suffix]
    with av.open(str(place), "w", format=suffix[1:]) as film:
        stream = film.add_stream(encoder, rate=Fraction(rate), options=settings)
        assert isinstance(stream, av.VideoStream)
        stream.width, stream.height = size
        stream.pix_fmt = "yuv420p"
        for frame in frames:
            film.mux(stream.encode(av.VideoFrame.from_ndarray(frame, format="rgb24")))
        film.mux(stream.encode(None))


def _write_gif(frames: Iterator[Picture], place: Path, rate: int) -> None:
    """Write frames with a common palette, which avoids flicker."""
    from PIL import Image

    first = list(islice(frames, _FIRST))
    # Together they show light and shade on all moving parts.
    together = Image.fromarray(np.concatenate([frame[::2, ::2] for frame in first]))
    own = together.quantize(_COLOURS, dither=Image.Dither.NONE).getpalette() or []
    # The colours of paths, which the first frames do not contain yet.
    later = TIME_COLOURS(np.linspace(0.0, 1.0, 256 - _COLOURS), bytes=True)[:, :3]
    palette = Image.new("P", (1, 1))
    palette.putpalette([*own[: 3 * _COLOURS], *later.ravel().tolist()])
    pictures = (
        Image.fromarray(frame).quantize(palette=palette, dither=Image.Dither.NONE)
        for frame in chain(first, frames)
    )
    next(pictures).save(
        place,
        format="GIF",
        save_all=True,
        append_images=pictures,
        duration=round(1000 / rate),
        loop=0,
        optimize=False,
    )

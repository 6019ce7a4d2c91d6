"""Frames as a film, written completely or not at all."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np

from ...experiment.files import atomic_file
from ..drawing.style import TIME_COLOURS
from .encoders import ENCODERS
from .frames import Picture, Size

#: Colours of the first frame in a film of type GIF; the others are those of paths.
_COLOURS = 160


def write_film(frames: Iterable[Picture], path: Path, rate: int, size: Size) -> None:
    """Encode frames in the format of the file name.

    Parameters
    ----------
    frames : iterable of array (height, width, 3)
    path : Path
        Ending in .mp4, .webm or .gif.
    rate : int
        Frames in a second.
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
    """Write frames with the same colours, so that nothing flickers."""
    from PIL import Image

    first = Image.fromarray(next(frames))
    own = first.quantize(_COLOURS, dither=Image.Dither.NONE).getpalette() or []
    # those of paths, which the first frame has not yet
    later = TIME_COLOURS(np.linspace(0.0, 1.0, 256 - _COLOURS), bytes=True)[:, :3]
    palette = Image.new("P", (1, 1))
    palette.putpalette([*own[: 3 * _COLOURS], *later.ravel().tolist()])
    beginning = first.quantize(palette=palette, dither=Image.Dither.NONE)
    others = (
        Image.fromarray(frame).quantize(palette=palette, dither=Image.Dither.NONE)
        for frame in frames
    )
    beginning.save(
        place,
        format="GIF",
        save_all=True,
        append_images=others,
        duration=round(1000 / rate),
        loop=0,
        optimize=False,
    )

"""The encoders of films, and their availability; does not import any drawing code."""

from __future__ import annotations

from flowlanes.errors import InputError

#: The encoder of each film type, its pixel format and its settings.
ENCODERS = {
    ".mp4": ("libx264", {"crf": "20", "preset": "medium", "movflags": "+faststart"}),
    ".webm": ("libvpx-vp9", {"crf": "32", "b": "0", "row-mt": "1", "cpu-used": "2"}),
}


def require_encoder(suffix: str) -> None:
    """Raise InputError unless films of this type can be encoded here."""
    if suffix == ".gif":
        return
    name, _ = ENCODERS[suffix]
    try:
        import av
    except ImportError:
        raise InputError(
            f"a film of type {suffix} needs PyAV: pip install 'chaplygin[film]'; .gif and .glb "
            "need nothing further"
        ) from None
    if name not in av.codecs_available:
        raise InputError(
            f"this copy of PyAV has no encoder {name} for {suffix}: .gif and .glb need none"
        )

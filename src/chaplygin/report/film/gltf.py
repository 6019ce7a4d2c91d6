"""A moving body as a glTF file, as programs for scenes in space read it (.glb).

The axis z of space, which points upwards here, becomes the axis y of glTF.
"""

from __future__ import annotations

import json
import struct
from pathlib import Path

import numpy as np
import numpy.typing as npt
import xarray as xr

from ..._version import __version__
from ...core.arrays import FloatArray
from ...experiment.files import atomic_file
from ...geometry.mesh import BodyMesh
from ..drawing.dataset_access import require, times_of, title_of, values_of

#: Colours of the octants of a body in linear light: red, green, blue, opacity.
_COLOURS = ((0.105, 0.228, 0.413, 1.0), (0.863, 0.831, 0.791, 1.0))

_FLOAT, _UNSIGNED = 5126, 5125
_VERTICES, _CORNERS = 34962, 34963


class _Buffer:
    """Numbers in one block of bytes, and where each lot of them is."""

    def __init__(self) -> None:
        self.content = bytearray()
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, object]] = []

    def add(self, numbers: npt.NDArray[np.generic], kind: str, target: int | None = None) -> int:
        """Add rows of numbers; their index."""
        whole = numbers.dtype.kind in "iu"
        rows = np.ascontiguousarray(numbers, dtype="<u4" if whole else "<f4")
        view = {"buffer": 0, "byteOffset": len(self.content), "byteLength": rows.nbytes}
        self.views.append(view if target is None else {**view, "target": target})
        self.content += rows.tobytes()
        flat = rows.reshape(len(rows), -1)
        self.accessors.append(
            {
                "bufferView": len(self.views) - 1,
                "componentType": _UNSIGNED if whole else _FLOAT,
                "count": len(rows),
                "type": kind,
                "min": flat.min(axis=0).tolist(),
                "max": flat.max(axis=0).tolist(),
            }
        )
        return len(self.accessors) - 1


def write_gltf(dataset: xr.Dataset, outline: BodyMesh, path: Path) -> None:
    """Write the motion of a body.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `contact`, `centre`, `attitude` and `gamma`.
    outline : BodyMesh
        The body, body axes.
    path : Path
        Ending in .glb.

    Raises
    ------
    InputError
        If the dataset lacks a variable, or the file cannot be written.
    """
    require(dataset, "scene")
    content = gltf(
        times_of(dataset),
        values_of(dataset, "centre"),
        values_of(dataset, "attitude"),
        outline,
        title_of(dataset),
    )
    with atomic_file(path) as place:
        place.write_bytes(content)


def gltf(
    times: FloatArray, centre: FloatArray, attitude: FloatArray, outline: BodyMesh, title: str
) -> bytes:
    """The content of a glTF file (binary): a body, its path and its motion.

    Parameters
    ----------
    times : array (n,)
        In seconds, increasing.
    centre : array (n, 3)
        Space axes.
    attitude : array (n, 4)
        Unit quaternions (w, x, y, z).
    outline : BodyMesh
        The body, body axes.
    title : str
    """
    buffer = _Buffer()
    good = np.isfinite(centre).all(axis=1) & np.isfinite(attitude).all(axis=1)
    turns = attitude[good][:, [1, 2, 3, 0]]
    # neighbours on the same side of the sphere, so that the way between them is the short one
    signs = np.where(np.sum(turns[1:] * turns[:-1], axis=1) < 0.0, -1.0, 1.0)
    turns = turns * np.concatenate([[1.0], np.cumprod(signs)])[:, None]
    instants = buffer.add(times[good] - times[good][0], "SCALAR")
    places = buffer.add(centre[good], "VEC3")
    rotations = buffer.add(turns, "VEC4")
    document = {
        "asset": {"version": "2.0", "generator": f"chaplygin {__version__}"},
        "scene": 0,
        "scenes": [{"name": title, "nodes": [0]}],
        "nodes": [
            {"name": "space", "rotation": [-np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)], "children": [1]},
            {
                "name": "body",
                "mesh": 0,
                "translation": centre[good][0].tolist(),
                "rotation": turns[0].tolist(),
            },
        ],
        "meshes": [{"name": "body", "primitives": _primitives(buffer, outline)}],
        "materials": [
            {
                "name": f"octants {number}",
                "doubleSided": True,
                "pbrMetallicRoughness": {
                    "baseColorFactor": list(colour),
                    "metallicFactor": 0.0,
                    "roughnessFactor": 0.55,
                },
            }
            for number, colour in enumerate(_COLOURS, 1)
        ],
        "animations": [
            {
                "name": "motion",
                "samplers": [{"input": instants, "output": o} for o in (places, rotations)],
                "channels": [
                    {"sampler": 0, "target": {"node": 1, "path": "translation"}},
                    {"sampler": 1, "target": {"node": 1, "path": "rotation"}},
                ],
            }
        ],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.content)}],
    }
    return _binary(document, bytes(buffer.content))


def _primitives(buffer: _Buffer, outline: BodyMesh) -> list[dict[str, object]]:
    """The facets of each colour as triangles, with the normals of the smooth surface."""
    primitives: list[dict[str, object]] = []
    for tone in range(len(_COLOURS)):
        chosen = outline.tones == tone
        faces = outline.faces[chosen]
        if not len(faces):
            continue
        corners = np.concatenate([faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]])
        normals = np.concatenate([outline.normals[chosen]] * 2)
        # a triangle repeats its last corner
        proper = corners[:, 1] != corners[:, 2]
        triangles = outline.vertices[corners[proper]].reshape(-1, 3)
        primitives.append(
            {
                "attributes": {
                    "POSITION": buffer.add(triangles, "VEC3", _VERTICES),
                    "NORMAL": buffer.add(np.repeat(normals[proper], 3, axis=0), "VEC3", _VERTICES),
                },
                "indices": buffer.add(np.arange(len(triangles)), "SCALAR", _CORNERS),
                "material": tone,
            }
        )
    return primitives


def _binary(document: dict[str, object], content: bytes) -> bytes:
    """The two parts of a binary file, each filled up to four bytes."""
    text = json.dumps(document, allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    content += b"\0" * (-len(content) % 4)
    length = 12 + 8 + len(text) + 8 + len(content)
    return b"".join(
        [
            struct.pack("<4sII", b"glTF", 2, length),
            struct.pack("<I4s", len(text), b"JSON"),
            text,
            struct.pack("<I4s", len(content), b"BIN\0"),
            content,
        ]
    )

"""Moving solids as a glTF file (.glb), as read by 3D programs.

The z axis of space, which points upwards here, becomes the y axis of glTF.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt
import xarray as xr

from flowlanes.system.arrays import BoolArray, FloatArray

from ..._version import __version__
from ...experiment.files import atomic_file
from ...geometry.mesh import BodyMesh, Facets
from ..drawing.dataset_access import require, times_of, title_of, values_of

#: Colours by tone, in linear light: red, green, blue, opacity.
_COLOURS = {
    "octants 1": (0.105, 0.228, 0.413, 1.0),
    "octants 2": (0.863, 0.831, 0.791, 1.0),
    "wheels": (0.033, 0.054, 0.078, 1.0),
}

_FLOAT, _UNSIGNED = 5126, 5125
_VERTICES, _CORNERS = 34962, 34963


class _Buffer:
    """Arrays in one block of bytes, with their positions."""

    def __init__(self) -> None:
        self.content = bytearray()
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, object]] = []

    def add(self, numbers: npt.NDArray[np.generic], kind: str, target: int | None = None) -> int:
        """Add rows of numbers; return their index."""
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


@dataclass(frozen=True, eq=False)
class Solid:
    """A solid and its motion at n times.

    Attributes
    ----------
    name : str
    facets : Facets
        The surface, in axes of the solid; tone 2 is that of wheels.
    centre : (n, 3) array
        Position of the origin, space axes.
    attitude : (n, 4) array
        Unit quaternions (w, x, y, z).
    scale : (n, 3) array, optional
        Scale factors along its axes.
    """

    name: str
    facets: Facets
    centre: FloatArray
    attitude: FloatArray
    scale: FloatArray | None = None

    @property
    def presence(self) -> BoolArray:
        """Whether it has a position at each time."""
        numbers = np.column_stack([self.centre, self.attitude])
        return np.asarray(np.isfinite(numbers).all(axis=1))


def body_solid(dataset: xr.Dataset, outline: BodyMesh) -> Solid:
    """A body that moves as in a dataset.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `contact`, `centre`, `attitude` and `gamma`.
    outline : BodyMesh
        The body, body axes.

    Raises
    ------
    InputError
        If the dataset lacks a variable.
    """
    require(dataset, "scene")
    return Solid(
        "body", outline.facets, values_of(dataset, "centre"), values_of(dataset, "attitude")
    )


def write_gltf(dataset: xr.Dataset, solids: Sequence[Solid], path: Path) -> None:
    """Write the motion of solids.

    Parameters
    ----------
    dataset : xarray.Dataset
        Dataset with times and title.
    solids : sequence of Solid
        Solids at the times of the dataset.
    path : Path
        Path with the ending .glb.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    content = gltf(times_of(dataset), solids, title_of(dataset))
    with atomic_file(path) as place:
        place.write_bytes(content)


def gltf(times: FloatArray, solids: Sequence[Solid], title: str) -> bytes:
    """The content of a binary glTF file: solids and their motion.

    Parameters
    ----------
    times : array (n,)
        In seconds, increasing.
    solids : sequence of Solid
    title : str
    """
    buffer = _Buffer()
    good = np.logical_and.reduce([solid.presence for solid in solids])
    instants = buffer.add(times[good] - times[good][0], "SCALAR")
    nodes: list[dict[str, object]] = [
        {
            "name": "space",
            "rotation": [-np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)],
            "children": list(range(1, len(solids) + 1)),
        }
    ]
    meshes: list[dict[str, object]] = []
    samplers: list[dict[str, int]] = []
    channels: list[dict[str, object]] = []
    for number, solid in enumerate(solids):
        turns = solid.attitude[good][:, [1, 2, 3, 0]]
        # Neighbouring quaternions with the same sign, so that interpolation takes the short way.
        signs = np.where(np.sum(turns[1:] * turns[:-1], axis=1) < 0.0, -1.0, 1.0)
        turns = turns * np.concatenate([[1.0], np.cumprod(signs)])[:, None]
        moves = {"translation": solid.centre[good], "rotation": turns}
        if solid.scale is not None:
            moves["scale"] = solid.scale[good]
        meshes.append({"name": solid.name, "primitives": _primitives(buffer, solid.facets)})
        first = {path: rows[0].tolist() for path, rows in moves.items()}
        nodes.append({"name": solid.name, "mesh": number, **first})
        for path, rows in moves.items():
            target = {"node": number + 1, "path": path}
            channels.append({"sampler": len(samplers), "target": target})
            kind = "VEC4" if path == "rotation" else "VEC3"
            samplers.append({"input": instants, "output": buffer.add(rows, kind)})
    document = {
        "asset": {"version": "2.0", "generator": f"chaplygin {__version__}"},
        "scene": 0,
        "scenes": [{"name": title, "nodes": [0]}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": [
            {
                "name": name,
                "doubleSided": True,
                "pbrMetallicRoughness": {
                    "baseColorFactor": list(colour),
                    "metallicFactor": 0.0,
                    "roughnessFactor": 0.55,
                },
            }
            for name, colour in _COLOURS.items()
        ],
        "animations": [{"name": "motion", "samplers": samplers, "channels": channels}],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.content)}],
    }
    return _binary(document, bytes(buffer.content))


def _primitives(buffer: _Buffer, facets: Facets) -> list[dict[str, object]]:
    """The facets of each colour as triangles, with the normals of the smooth surface."""
    primitives: list[dict[str, object]] = []
    for tone in range(len(_COLOURS)):
        chosen = facets.select(facets.tones == tone)
        if not len(chosen):
            continue
        corners = np.concatenate([chosen.polygons[:, [0, 1, 2]], chosen.polygons[:, [0, 2, 3]]])
        normals = np.concatenate([chosen.normals] * 2)
        # A triangle repeats its last corner.
        proper = (corners[:, 1] != corners[:, 2]).any(axis=1)
        triangles = corners[proper].reshape(-1, 3)
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
    """The two chunks of a binary file, each padded to four bytes."""
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

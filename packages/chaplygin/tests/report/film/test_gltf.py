"""The model in space: read back by a reader of its own, its motion is that of the body."""

from __future__ import annotations

import json
import struct

import numpy as np
from scipy.spatial.transform import Rotation

from chaplygin.geometry.mesh import outline_from_contact
from chaplygin.report.film.gltf import Solid, gltf

OUTLINE = outline_from_contact(lambda gamma: -0.5 * gamma, 8, 12)


def read(content: bytes) -> tuple[dict[str, object], list[np.ndarray]]:
    """The document, and the numbers of every accessor."""
    magic, version, length = struct.unpack("<4sII", content[:12])
    assert (magic, version, length) == (b"glTF", 2, len(content))
    size, kind = struct.unpack("<I4s", content[12:20])
    assert kind == b"JSON" and size % 4 == 0
    document = json.loads(content[20 : 20 + size])
    rest = content[20 + size :]
    binary_size, kind = struct.unpack("<I4s", rest[:8])
    assert kind == b"BIN\0" and binary_size == len(rest) - 8
    assert document["buffers"][0]["byteLength"] <= binary_size
    arrays = []
    for accessor in document["accessors"]:
        view = document["bufferViews"][accessor["bufferView"]]
        dtype = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        start = 8 + view["byteOffset"]
        numbers = np.frombuffer(rest[start : start + view["byteLength"]], dtype)
        arrays.append(numbers.reshape(accessor["count"], width))
        assert np.allclose(arrays[-1].min(axis=0), accessor["min"])
        assert np.allclose(arrays[-1].max(axis=0), accessor["max"])
    return document, arrays


def test_the_body_moves_as_it_did() -> None:
    times = np.linspace(2.0, 5.0, 40)
    turns = Rotation.from_euler("zxz", np.outer(times, [3.0, 1.0, -2.0]))
    attitude = turns.as_quat(canonical=True)[:, [3, 0, 1, 2]]
    centre = np.column_stack([times, np.sin(times), 0.5 + 0 * times])
    document, arrays = read(
        gltf(times, [Solid("body", OUTLINE.facets, centre, attitude)], "a ball")
    )
    animation = document["animations"][0]  # type: ignore[index]
    for channel in animation["channels"]:
        sampler = animation["samplers"][channel["sampler"]]
        assert np.allclose(arrays[sampler["input"]][:, 0], times - 2.0, atol=1e-6)
        moved = arrays[sampler["output"]]
        if channel["target"]["path"] == "translation":
            assert np.allclose(moved, centre, atol=1e-6)
        else:
            assert np.all((Rotation.from_quat(moved) * turns.inv()).magnitude() < 1e-6)
            # no jump to the other quaternion of the same rotation
            assert np.all(np.sum(moved[1:] * moved[:-1], axis=1) > 0.0)
    # what is up here is up there
    space = document["nodes"][0]  # type: ignore[index]
    assert np.allclose(Rotation.from_quat(space["rotation"]).apply([0, 0, 1]), [0, 1, 0])


def test_the_triangles_are_the_surface_seen_from_outside() -> None:
    attitude, centre = np.tile([1.0, 0, 0, 0], (2, 1)), np.zeros((2, 3))
    body = Solid("body", OUTLINE.facets, centre, attitude)
    document, arrays = read(gltf(np.array([0.0, 1.0]), [body], "a ball"))
    area = 0.0
    for primitive in document["meshes"][0]["primitives"]:  # type: ignore[index]
        points = arrays[primitive["attributes"]["POSITION"]]
        corners = points[arrays[primitive["indices"]][:, 0]].reshape(-1, 3, 3)
        assert np.allclose(np.linalg.norm(points, axis=1), 0.5, atol=1e-6)
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert np.all(np.sum(across * corners.mean(axis=1), axis=1) >= -1e-9)
        area += float(np.linalg.norm(across, axis=1).sum() / 2)
    assert 0.85 * np.pi < area < np.pi

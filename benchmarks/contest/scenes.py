"""Scene of viser or NiceGUI with an ellipsoid in motion; arguments PEER POSES PORT.

The interpreter must have the chosen program.
"""

from __future__ import annotations

import sys
import time

import numpy as np

SEMI_AXES = np.array([0.2, 0.04, 0.03])
RATE = 60


def mesh() -> tuple[np.ndarray, np.ndarray]:
    """Ellipsoid with about as many triangles as a body in our pages."""
    rows, columns = 48, 96
    theta, phi = np.meshgrid(
        np.linspace(0, np.pi, rows + 1), 2 * np.pi * np.arange(columns) / columns, indexing="ij"
    )
    sphere = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1)
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    a, b = i * columns + j, i * columns + (j + 1) % columns
    faces = np.concatenate(
        [np.stack([a, a + columns, b], -1), np.stack([b, a + columns, b + columns], -1)]
    )
    return (sphere * SEMI_AXES).reshape(-1, 3), faces.reshape(-1, 3)


def play_in_viser(attitude: np.ndarray, centre: np.ndarray, port: int) -> None:
    import viser

    server = viser.ViserServer(host="127.0.0.1", port=port, verbose=False)
    server.scene.add_grid("ground", width=2.0, height=2.0)
    body = server.scene.add_mesh_simple("body", *mesh(), color=(80, 120, 200))
    for k in range(10**9):
        with server.atomic():
            body.wxyz = attitude[k % len(attitude)]
            body.position = centre[k % len(attitude)]
        time.sleep(1 / RATE)


def play_in_nicegui(attitude: np.ndarray, centre: np.ndarray, port: int) -> None:
    from nicegui import ui

    @ui.page("/")
    def page() -> None:
        with ui.scene(width=1200, height=800) as scene:
            body = scene.sphere(1.0, width_segments=96, height_segments=48).scale(*SEMI_AXES)
        step = iter(range(10**9))

        def turn() -> None:
            k = next(step) % len(attitude)
            w, x, y, z = attitude[k]
            body.move(*centre[k])
            body.rotate_R(
                [
                    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
                ]
            )

        ui.timer(1 / RATE, turn)

    ui.run(host="127.0.0.1", port=port, show=False, reload=False)


if __name__ in ("__main__", "__mp_main__"):
    peer, poses, port = sys.argv[1:]
    with np.load(poses) as file:
        motion = file["attitude"], file["centre"]
    {"viser": play_in_viser, "nicegui": play_in_nicegui}[peer](*motion, int(port))

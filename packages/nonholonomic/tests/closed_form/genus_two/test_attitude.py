import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from nonholonomic.closed_form.genus_two.attitude import Triad, cover

RNG = np.random.default_rng(2)


def as_quaternion(turn: Rotation) -> np.ndarray:
    return np.roll(turn.as_quat(), 1, axis=-1)


def test_two_vectors_give_the_attitude() -> None:
    space = RNG.normal(size=(2, 3))
    turns = Rotation.random(5, random_state=3)
    body = [turns.inv().apply(vector).T for vector in space]
    triad = Triad.through(body[0][:, 0], body[1][:, 0], as_quaternion(turns[0]))
    found = triad.attitude(*body)
    assert np.abs(np.sum(found * as_quaternion(turns), axis=1)) == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("turns", [(1, 0), (0, 1), (1, 2)], ids=str)
def test_signs_are_continuous_over_many_turns(turns: tuple[int, int]) -> None:
    axis = np.array([0.6, 0.0, 0.8])

    def angles(v: np.ndarray) -> np.ndarray:
        # whole turns when a phase grows by 2
        return np.pi * (v @ np.array(turns)) + 0.7 * np.sin(np.pi * v[:, 0])

    def attitude(v: np.ndarray) -> np.ndarray:
        found = as_quaternion(Rotation.from_rotvec(angles(v)[:, None] * axis))
        return found * np.where(found[:, 3:] < 0, -1.0, 1.0)

    covered = cover(attitude, (16, 16))
    line = np.stack([np.linspace(0, 3.99, 400), np.linspace(0.3, -3.6, 400)], axis=1)
    signed = covered.with_signs(line, attitude(line))
    assert np.min(np.sum(signed[1:] * signed[:-1], axis=1)) > 0.9

"""PHYRE as a Gymnasium environment."""

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")
from gymnasium.utils.env_checker import check_env  # noqa: E402

import pathlight_phyre.environment  # noqa: E402, F401


def test_gymnasiums_checks_pass():
    env = gymnasium.make("pathlight_phyre/Phyre-v0", render_mode="rgb_array")
    check_env(env.unwrapped)


def test_a_solution_ends_an_episode():
    env = gymnasium.make("pathlight_phyre/Phyre-v0", task_ids=["00007:008"])
    observation, info = env.reset(seed=1)
    assert (observation.shape, info) == ((256, 256), {"task_id": "00007:008", "attempts": 0})
    _, reward, terminated, truncated, info = env.step(np.zeros(3, np.float32))
    assert (reward, terminated, truncated, info["attempts"]) == (0.0, False, False, 0) and info["status"].is_invalid()
    _, reward, terminated, _, info = env.step(np.array([178 / 255, 218 / 255, 17 / 30]))
    assert (reward, terminated, info["attempts"]) == (1.0, True, 1) and info["status"].is_solved()


def test_an_episode_is_of_the_task_that_is_asked_for():
    env = gymnasium.make("pathlight_phyre/Phyre-v0")
    assert env.reset(options={"task_id": "00002:007"})[1]["task_id"] == "00002:007"
    with pytest.raises(ValueError, match="no ball task"):
        env.reset(options={"task_id": "nonsense"})

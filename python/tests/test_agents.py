"""The nets in the wheel, and the agent that plays with them."""

import numpy as np
import pytest

import pathlight_phyre as phyre
from pathlight_phyre.agents import Model

TASK = "00007:008"


@pytest.fixture(scope="module")
def model():
    return Model()


def test_it_imagines_maps(model):
    maps = model.imagine(TASK)
    assert set(maps) == {"base", "target", "action", "placement"}
    for values in maps.values():
        assert (values.dtype, values.shape) == (np.float32, (64, 64))
        assert 0 <= values.min() and values.max() <= 1


def test_it_proposes_valid_balls(model):
    proposals = model.propose(TASK, 20)
    assert proposals.actions.shape == (20, 3) and proposals.chances.shape == (20,)
    assert (np.diff(proposals.chances) <= 0).sum() > 10, "the most promising come first"
    statuses = phyre.initialize_simulator([TASK], "ball").simulate_actions(0, proposals.actions)
    assert (statuses != 0).all() and (statuses == 1).any()


def test_a_turn_ends_with_a_solution(model):
    attempts = model.turn(TASK)
    statuses = [status for _, status in attempts]
    assert statuses[-1].is_solved() and all(status.is_not_solved() for status in statuses[:-1])
    agent = model.agent(TASK)
    assert (agent.propose() == attempts[0][0]).all()


def test_bad_weights_and_setups_are_refused(tmp_path):
    (tmp_path / "weights").write_bytes(b"nonsense")
    with pytest.raises(ValueError):
        Model(weights=tmp_path / "weights")
    with pytest.raises(OSError):
        Model(weights=tmp_path / "missing")
    with pytest.raises(ValueError, match="two_balls"):
        Model("two_balls_cross_template")

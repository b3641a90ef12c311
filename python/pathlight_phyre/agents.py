"""The nets in the wheel, and the agent that proposes balls with them.

This module is an addition to phyre. Actions are float64: x, y and radius in 0..1.
"""

import pathlib
from typing import Dict, List, NamedTuple, Optional, Tuple, Union

import numpy as np

from pathlight_phyre import _native
from pathlight_phyre.action_simulator import SimulationStatus
from pathlight_phyre.metrics import MAIN_EVAL_SETUPS, MAX_TEST_ATTEMPTS

SMALLEST, LARGEST = 2, 32
"""Minimum and maximum radius of a ball, px."""


class Proposals(NamedTuple):
    """Balls that a model proposes, the most promising first."""

    actions: np.ndarray
    """(balls, 3)"""
    chances: np.ndarray
    """The chance of each ball to solve the task, 0..1, or NaN if the nets predict none; (balls,)."""


class Model:
    """Nets that imagine paths in a task, and an agent that plays with them."""

    def __init__(self, eval_setup: str = "ball_within_template", weights: Union[str, pathlib.Path, None] = None):
        """Loads the shipped nets, which were trained on fold 0 of a setup, or a weights file of Pathlight.

        Raises:
            ValueError: If the setup is unknown, or the file does not contain such nets.
            OSError: If the file cannot be read.
        """
        if eval_setup not in MAIN_EVAL_SETUPS:
            raise ValueError(f"there are no nets for {eval_setup!r}: use one of {MAIN_EVAL_SETUPS}")
        read = None if weights is None else pathlib.Path(weights).read_bytes()
        self._native = _native.Model(eval_setup == "ball_cross_template", read)

    def imagine(self, task_id: str) -> Dict[str, np.ndarray]:
        """Returns the maps that the nets predict for a task.

        Returns:
            ``base``: the path of the green object without a ball; ``target``: the path that it should take; ``action``:
            the path of the red ball; ``placement``: where the ball should start. Each float32, (64, 64), 0..1, row 0
            at the bottom.

        Raises:
            ValueError: If the task is unknown.
        """
        return self._native.imagine(_native.Scene(task_id))

    def propose(self, task_id: str, count: int = MAX_TEST_ATTEMPTS, seed: int = 0) -> Proposals:
        """Returns up to ``count`` valid balls for a task, without learning from attempts.

        Raises:
            ValueError: If the task is unknown.
        """
        balls = self._native.propose(_native.Scene(task_id), seed, count)
        return Proposals(actions_of_balls(balls[:, :3]), balls[:, 3])

    def agent(self, task_id: str, seed: int = 0) -> "Agent":
        """Returns an agent for a task, which learns from its attempts.

        Raises:
            ValueError: If the task is unknown.
        """
        return Agent(self._native.agent(_native.Scene(task_id), seed))

    def turn(self, task_id: str, seed: int = 0) -> List[Tuple[np.ndarray, SimulationStatus]]:
        """Plays a task with the agent until it is solved, or for 100 attempts.

        Returns:
            Action and status of each attempt.

        Raises:
            ValueError: If the task is unknown.
        """
        scene, agent = _native.Scene(task_id), self.agent(task_id, seed)
        attempts: List[Tuple[np.ndarray, SimulationStatus]] = []
        while len(attempts) < MAX_TEST_ATTEMPTS:
            action = agent.propose()
            if action is None:
                break
            status = SimulationStatus(int(scene.statuses(action[None], False)[0]))
            attempts.append((action, status))
            if status.is_solved():
                break
            agent.observe(status)
        return attempts


class Agent:
    """An agent for one task. It proposes balls and observes their outcomes."""

    def __init__(self, native: "_native.Agent"):
        self._native = native

    def propose(self) -> Optional[np.ndarray]:
        """Returns the next action, (3,), whose ball is valid; None if there are no more."""
        ball = self._native.propose()
        return None if ball is None else actions_of_balls(np.array(ball))

    def observe(self, status: SimulationStatus) -> None:
        """Reports the outcome of the last proposed action to the agent."""
        self._native.observe(SimulationStatus(status).is_solved())


def actions_of_balls(balls: np.ndarray) -> np.ndarray:
    """Converts balls, px, to actions."""
    return (balls - [0, 0, SMALLEST]) / [255, 255, LARGEST - SMALLEST]

"""PHYRE as a Gymnasium environment, ``pathlight_phyre/Phyre-v0``. Importing this module registers it.

An episode is a task, and a step is an attempt. Needs gymnasium: ``pip install 'pathlight-phyre[gymnasium]'``.
"""

from typing import Any, Dict, Optional, Sequence, Tuple

import gymnasium
import numpy as np
from gymnasium import spaces

from pathlight_phyre.action_simulator import SimulationStatus, initialize_simulator
from pathlight_phyre.metrics import MAX_TEST_ATTEMPTS, get_task_ids_in_tier
from pathlight_phyre.vis import observations_to_uint8_rgb


class PhyreEnv(gymnasium.Env):
    """Attempts at tasks.

    Observation: the scene before the attempt, uint8 colour codes 0..6, (256, 256), row 0 at the bottom.
    Action: x, y and radius of the ball, float32, 0..1.
    Reward: 1 for a solution, else 0. A solution terminates the episode; 100 valid attempts, or 1,000 including invalid
    ones, truncate it. ``info`` has ``task_id``, ``status`` (a ``SimulationStatus``) and ``attempts`` (the valid ones).
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 1}

    def __init__(self, task_ids: Optional[Sequence[str]] = None, render_mode: Optional[str] = None):
        """Makes an environment of tasks, given by their ids; by default all of the benchmark.

        Raises:
            ValueError: If there are no tasks, or a task or the render mode is unknown.
        """
        self.task_ids = list(get_task_ids_in_tier("ball") if task_ids is None else task_ids)
        if not self.task_ids:
            raise ValueError("an environment needs at least one task id")
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"there is no render mode {render_mode!r}: use 'rgb_array'")
        self.render_mode = render_mode
        self.observation_space = spaces.Box(0, 6, (256, 256), np.uint8)
        self.action_space = spaces.Box(0.0, 1.0, (3,), np.float32)
        self._simulator = initialize_simulator(self.task_ids[:1], "ball")
        self._shown = self._simulator.initial_scenes[0]
        self._attempts = self._steps = 0

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[np.ndarray, Dict[str, Any]]:
        """Starts a task: ``options={"task_id": ...}``, or a random one.

        Raises:
            ValueError: If the task is unknown.
        """
        super().reset(seed=seed)
        chosen = (options or {}).get("task_id")
        if chosen is None:
            chosen = self.task_ids[int(self.np_random.integers(len(self.task_ids)))]
        self._simulator = initialize_simulator([chosen], "ball")
        self._attempts = self._steps = 0
        self._shown = self._simulator.initial_scenes[0]
        return self._observation(), {"task_id": chosen, "attempts": 0}

    def step(self, action: np.ndarray) -> Tuple[np.ndarray, float, bool, bool, Dict[str, Any]]:
        """Attempts an action."""
        rendered = self.render_mode is not None
        simulated = self._simulator.simulate_action(0, action, need_images=rendered)
        status: SimulationStatus = simulated.status
        self._steps += 1
        self._attempts += not status.is_invalid()
        if simulated.images is not None:
            self._shown = simulated.images[-1]
        solved = status.is_solved()
        ended = self._attempts >= MAX_TEST_ATTEMPTS or self._steps >= 10 * MAX_TEST_ATTEMPTS
        info = {"task_id": self._simulator.task_ids[0], "status": status, "attempts": self._attempts}
        return self._observation(), float(solved), solved, ended and not solved, info

    def render(self) -> Optional[np.ndarray]:
        """Returns the end of the last attempt, or else the scene, as uint8 RGB, (256, 256, 3)."""
        return observations_to_uint8_rgb(self._shown) if self.render_mode else None

    def _observation(self) -> np.ndarray:
        return self._simulator.initial_scenes[0].copy()


gymnasium.register(id="pathlight_phyre/Phyre-v0", entry_point="pathlight_phyre.environment:PhyreEnv")

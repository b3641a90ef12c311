"""Simulates actions in tasks."""

import enum
from typing import Any, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from pathlight_phyre import _native, simulation
from pathlight_phyre._checks import action_of, actions_of, check_tier, stride_of
from pathlight_phyre.loader import Task, load_compiled_task_list
from pathlight_phyre.simulator import DEFAULT_STRIDE

ActionLike = Union[Sequence[float], np.ndarray]


class SimulationStatus(enum.IntEnum):
    """The outcome of an action."""

    NOT_SOLVED = -1
    INVALID_INPUT = 0
    SOLVED = 1
    UNSTABLY_SOLVED = 2
    STABLY_SOLVED = 3

    def __str__(self) -> str:
        """Returns the name in every version of Python; from 3.11 on, an IntEnum returns its number."""
        return enum.Enum.__str__(self)

    def __format__(self, spec: str) -> str:
        """Formats the number."""
        return format(int(self), spec)

    def is_solved(self) -> bool:
        """Whether the action solved the task, stably or not."""
        return self > 0

    def is_stably_solved(self) -> bool:
        """Whether the action is a stable solution; only simulations with ``stable=True`` check that."""
        return self is SimulationStatus.STABLY_SOLVED

    def is_not_solved(self) -> bool:
        """Whether the action is valid and did not solve the task."""
        return self is SimulationStatus.NOT_SOLVED

    def is_invalid(self) -> bool:
        """Whether the action was invalid, so that nothing was simulated."""
        return self is SimulationStatus.INVALID_INPUT


class ActionSimulator:
    """Simulates actions in tasks. A task is named by its index in ``task_ids``."""

    def __init__(
        self,
        tasks: Union[Sequence[Union[str, Task]], Mapping[str, Task]],
        action_mapper: str = "ball",
        no_goals: bool = True,
    ):
        """Loads tasks, given by their ids or as returned by ``loader``.

        Raises:
            ValueError: If a task or the action tier is unknown.
        """
        check_tier(action_mapper)
        self.tier = action_mapper
        listed = tasks.values() if isinstance(tasks, Mapping) else tasks
        self._tasks = tuple(Task(task) if isinstance(task, str) else task for task in listed)
        self._task_ids = tuple(task.taskId for task in self._tasks)
        self._scenes = tuple(_native.Scene(task_id) for task_id in self._task_ids)
        images = [scene.image() for scene in self._scenes]
        self._initial_scenes = np.stack(images) if images else np.empty((0, 256, 256), np.uint8)
        self._initial_featurized_objects = [simulation.FeaturizedObjects(scene.features()) for scene in self._scenes]
        self._goals = None if no_goals else np.array([task.goal for task in self._tasks], np.uint8).reshape(-1, 3)

    @property
    def task_ids(self) -> Tuple[str, ...]:
        """The ids of the tasks."""
        return self._task_ids

    @property
    def initial_scenes(self) -> np.ndarray:
        """The scenes before an action: uint8 colour codes, (tasks, 256, 256)."""
        return self._initial_scenes

    @property
    def initial_featurized_objects(self) -> List[simulation.FeaturizedObjects]:
        """The objects of each scene before an action: features float32, (1, objects, 14)."""
        return self._initial_featurized_objects

    @property
    def goals(self) -> Optional[np.ndarray]:
        """The goals, uint8 (tasks, 3): object, relation (6, touching), object, with 4 for every object from the fifth
        body on; None unless asked for by ``no_goals=False``."""
        return self._goals

    @property
    def action_space_dim(self) -> int:
        """The number of dimensions of an action: x, y and radius."""
        return 3

    def sample(self, valid_only: bool = True, rng: Optional[np.random.RandomState] = None) -> np.ndarray:
        """Draws an action uniformly, float64 (3,).

        Args:
            valid_only: Draws until the ball is inside the scene. It may still overlap bodies.
            rng: The generator; by default a new one with an arbitrary seed.
        """
        rng = np.random.RandomState() if rng is None else rng
        while True:
            action = rng.uniform(size=self.action_space_dim)
            if not valid_only or _native.Scene.is_inside(tuple(action)):
                return action

    def build_discrete_action_space(self, max_actions: int, seed: int = 1) -> List[np.ndarray]:
        """Draws ``max_actions`` actions from a seed."""
        rng = np.random.RandomState(seed=seed)
        return [self.sample(rng=rng) for _ in range(max_actions)]

    def simulate_action(
        self,
        task_index: int,
        action: Optional[ActionLike],
        *,
        need_images: bool = True,
        need_featurized_objects: bool = False,
        stride: int = DEFAULT_STRIDE,
        stable: bool = False,
        need_velocities: bool = False,
        need_masks: bool = False,
        need_contacts: bool = False,
    ) -> "simulation.Simulation":
        """Simulates an action in a task.

        Args:
            task_index: Index in ``task_ids``.
            action: x, y and radius in 0..1. None simulates the scene without a ball, which phyre cannot.
            need_images, need_featurized_objects: What to return in addition to the status.
            stride: Steps between observations, the first after step 1. A second has 60 steps.
            stable: Also simulates a solution at the eight positions half a px away. The status is UNSTABLY_SOLVED if
                one of them is valid and fails, else STABLY_SOLVED.
            need_velocities, need_masks, need_contacts: Additions to phyre. Contacts take a second simulation.

        Raises:
            ValueError: If the action is not three numbers.
            IndexError: If there is no task with this index.
        """
        observed = self._scenes[task_index].simulate(
            None if action is None else tuple(action_of(action)),
            stride_of(stride),
            stable,
            {
                "images": need_images,
                "features": need_featurized_objects,
                "velocities": need_velocities,
                "masks": need_masks,
                "contacts": need_contacts,
            },
        )
        return simulation.Simulation(
            status=SimulationStatus(observed.status),
            images=observed.images,
            featurized_objects=observed.features,
            velocities=observed.velocities,
            masks=observed.masks,
            contacts=observed.contacts,
            steps=observed.steps,
            touching=observed.touching,
        )

    def simulate_single(
        self,
        task_index: int,
        action: ActionLike,
        need_images: bool = True,
        stride: int = DEFAULT_STRIDE,
        stable: bool = False,
    ) -> Tuple[SimulationStatus, Optional[np.ndarray]]:
        """Returns the status and images of ``simulate_action``. Deprecated in phyre 0.2.0."""
        simulated = self.simulate_action(task_index, action, need_images=need_images, stride=stride, stable=stable)
        return simulated.status, simulated.images

    def simulate_actions(self, task_index: int, actions: Any, *, stable: bool = False) -> np.ndarray:
        """Simulates many actions in a task, on all cores and without the GIL.

        Args:
            task_index: Index in ``task_ids``.
            actions: (actions, 3), each as in ``simulate_action``.
            stable: As in ``simulate_action``.

        Returns:
            The status numbers, int8 (actions,).

        Raises:
            ValueError: If the actions have another shape or are not numbers.
            IndexError: If there is no task with this index.
        """
        return self._scenes[task_index].statuses(actions_of(actions), stable)


def initialize_simulator(task_ids: Sequence[str], action_tier: str) -> ActionSimulator:
    """Returns a simulator of these tasks.

    Raises:
        ValueError: If a task or the action tier is unknown.
    """
    return ActionSimulator(load_compiled_task_list(task_ids), action_tier)

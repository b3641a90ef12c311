"""The tasks of the benchmark."""

import json
from typing import Any, Dict, List, Sequence, Tuple

from pathlight_phyre import _native

TOUCHING = 6
"""PHYRE's number of the relation that every ball task asks for."""

WALLS = 4
"""Bodies of a task before those of its scene."""


class Task:
    """A task.

    Attributes:
        taskId: Its id, such as ``'00007:008'``.
        tier: ``'BALL'``.
        bodyId1, bodyId2: The object and its goal, counted from the four walls on.
        relationships: What the object has to do: ``[6]``, touching.
        goal_text: The goal as a sentence.
        bodies: The bodies without the walls, as plain data: position (px), angle (radians), role, parts.
    """

    def __init__(self, task_id: str):
        """Lays out the task of this id.

        Raises:
            ValueError: If there is none.
        """
        data: Dict[str, Any] = json.loads(_native.Scene(task_id).json())
        self.taskId = task_id
        self.tier = "BALL"
        self.bodyId1 = data["body1"] + WALLS
        self.bodyId2 = data["body2"] + WALLS
        self.relationships = [TOUCHING]
        self.goal_text: str = data["goal"]
        self.bodies: List[Dict[str, Any]] = data["bodies"]

    @property
    def goal(self) -> Tuple[int, int, int]:
        """PHYRE's code of the goal."""
        last = WALLS
        return min(self.bodyId1, last), self.relationships[0], min(self.bodyId2, last)

    def __repr__(self) -> str:
        return f"Task({self.taskId!r})"


def load_compiled_task_list(task_ids: Sequence[str]) -> List[Task]:
    """Returns the tasks of these ids, in their order.

    Raises:
        ValueError: If one is unknown, or if the ids are one text.
    """
    if isinstance(task_ids, str):
        raise ValueError(f"task_ids are a list of ids, not one text: write [{task_ids!r}]")
    return [Task(task_id) for task_id in task_ids]


def load_compiled_task_dict() -> Dict[str, Task]:
    """Returns all tasks by their ids."""
    return {task_id: Task(task_id) for task_id in _native.task_ids()}

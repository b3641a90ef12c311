"""The tasks of the benchmark."""

import json
from types import SimpleNamespace
from typing import Any, Dict, List, Optional, Sequence, Tuple

from pathlight_phyre import _native
from pathlight_phyre.creator.constants import SCENE_HEIGHT, SCENE_WIDTH
from pathlight_phyre.simulation import COLORS, SHAPES

TOUCHING = 6
"""PHYRE's number of the relation "touching", the goal of every ball task."""

WALLS = 4
"""Number of walls, which precede the objects in the bodies of a scene."""

WALL_WIDTH = 5
"""Width of a wall, px."""

UNDEFINED = "UNDEFINED"
"""PHYRE's shape type of a wall, which is none of ``SHAPES``."""


class Task:
    """A task.

    Attributes:
        taskId: Its id, such as ``'00007:008'``.
        tier: ``'BALL'``.
        bodyId1, bodyId2: Indices of the object and its goal in the scene's bodies.
        relationships: The relation that solves the task: ``[6]``, touching.
        goal_text: The goal in one sentence.
        scene: The scene: width and height (px), and bodies. The walls come first: bottom, left, top, right. A body has
            PHYRE's attributes: position.x and .y (px), angle (radians), bodyType (1 static, 2 dynamic), color (its
            code), shapeType (0 for a wall, then the order of ``SHAPES``), and shapes relative to its position. A shape
            has either a circle (radius, px) or a polygon (vertices with x and y, px); the other is None.
    """

    def __init__(self, task_id: str):
        """Lays out the task with this id.

        Raises:
            ValueError: If there is no such task.
        """
        data: Dict[str, Any] = json.loads(_native.Scene(task_id).json())
        self.taskId = task_id
        self.tier = "BALL"
        self.bodyId1 = data["body1"] + WALLS
        self.bodyId2 = data["body2"] + WALLS
        self.relationships = [TOUCHING]
        self.goal_text: str = data["goal"]
        bodies = [*map(_wall, range(WALLS)), *map(_body, data["bodies"])]
        self.scene = SimpleNamespace(width=SCENE_WIDTH, height=SCENE_HEIGHT, bodies=bodies)

    @property
    def goal(self) -> Tuple[int, int, int]:
        """PHYRE's code of the goal."""
        last = WALLS
        return min(self.bodyId1, last), self.relationships[0], min(self.bodyId2, last)

    def __repr__(self) -> str:
        return f"Task({self.taskId!r})"


def load_compiled_task_list(task_ids: Sequence[str]) -> List[Task]:
    """Returns the tasks with these ids, in the same order.

    Raises:
        ValueError: If an id is unknown, or ``task_ids`` is a single string.
    """
    if isinstance(task_ids, str):
        raise ValueError(f"task_ids is a list of ids, not a string: write [{task_ids!r}]")
    return [Task(task_id) for task_id in task_ids]


def load_compiled_task_dict() -> Dict[str, Task]:
    """Returns all tasks by id."""
    return {task_id: Task(task_id) for task_id in _native.task_ids()}


def _wall(side: int) -> SimpleNamespace:
    outside = WALL_WIDTH / 2
    x, y = SCENE_WIDTH / 2, SCENE_HEIGHT / 2
    x, y = [(x, -outside), (-outside, y), (x, SCENE_HEIGHT + outside), (SCENE_WIDTH + outside, y)][side]
    half_width, half_height = [(SCENE_WIDTH / 2, outside), (outside, SCENE_HEIGHT / 2)][side % 2]
    corners = [(half_width * i, half_height * j) for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    parts = [{"polygon": corners}]
    return _body(dict(x=x, y=y, angle=0.0, dynamic=False, role="black", shape=UNDEFINED, parts=parts))


def _body(body: Dict[str, Any]) -> SimpleNamespace:
    return SimpleNamespace(
        position=SimpleNamespace(x=body["x"], y=body["y"]),
        angle=body["angle"],
        bodyType=2 if body["dynamic"] else 1,
        color=1 + COLORS.index(body["role"].upper()),
        shapeType=(UNDEFINED, *SHAPES).index(body["shape"].upper().replace("_", "")),
        shapes=[_shape(**part) for part in body["parts"]],
    )


def _shape(circle: Optional[float] = None, polygon: Sequence[Tuple[float, float]] = ()) -> SimpleNamespace:
    vertices = [SimpleNamespace(x=x, y=y) for x, y in polygon]
    return SimpleNamespace(
        circle=None if circle is None else SimpleNamespace(radius=circle),
        polygon=SimpleNamespace(vertices=vertices) if vertices else None,
    )

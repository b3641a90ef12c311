"""A puzzle to play in a notebook, with the paths and maps that the model imagines.

Needs anywidget: ``pip install 'pathlight-phyre[widget]'``. Everything that the browser loads comes from this package,
so it works without a network.
"""

import pathlib
from typing import Any, Dict, List, Optional

import anywidget
import numpy as np
import traitlets

from pathlight_phyre import _native
from pathlight_phyre.agents import actions_of_balls

_PAGE = pathlib.Path(__file__).parent / "page"
_FILES = ("worker.js", "pkg/page/pathlight_bg.wasm", "pkg/worker/pathlight_bg.wasm")
_WEIGHTS = "assets/within-0.safetensors"

if not (_PAGE / "widget.js").exists():
    raise ImportError("this build of pathlight_phyre has no widget: build a wheel with `make python`")


class Puzzle(anywidget.AnyWidget):
    """A puzzle. Its traits follow the player, and the puzzle follows its traits.

    Attributes:
        task: The id of the task.
        ball: The ball being placed: x, y, radius in whole px; None if there is none.
        panel: The panel next to the scene: ``'play'``, ``'imagine'``, ``'predict'`` or ``'data'``.
        attempts: The player's attempts, each with ``task``, ``ball`` (px) and ``solved``.
    """

    _esm = _PAGE / "widget.js"

    task = traitlets.Unicode("00007:008").tag(sync=True)
    ball = traitlets.Tuple(traitlets.Int(), traitlets.Int(), traitlets.Int(), allow_none=True, default_value=None).tag(
        sync=True
    )
    panel = traitlets.Enum(["play", "imagine", "predict", "data"], "play").tag(sync=True)
    attempts: "traitlets.List[Dict[str, Any]]" = traitlets.List().tag(sync=True)

    def __init__(self, task: str = "00007:008", **traits: Any):
        """Shows a task.

        Raises:
            ValueError: If the task is unknown.
        """
        super().__init__(task=task, **traits)
        self.on_msg(self._send_files)

    @property
    def action(self) -> Optional[np.ndarray]:
        """``ball`` as an action for ``simulate_action``, float64, (3,); None if there is none."""
        return None if self.ball is None else actions_of_balls(np.array([self.ball], np.float64))[0]

    @traitlets.validate("task")
    def _check_task(self, proposal: Dict[str, Any]) -> str:
        _native.Scene(proposal["value"])
        return proposal["value"]

    def _send_files(self, _: Any, message: Any, __: List[Any]) -> None:
        if message == {"wants": "files"}:
            files = [*((name, (_PAGE / name).read_bytes()) for name in _FILES), (_WEIGHTS, _native.weights(False))]
            self.send({"files": [name for name, _ in files]}, [data for _, data in files])

"""The statuses of PHYRE's 100,000 actions in every task, simulated on demand.

PHYRE offers these statuses as a download, 'the 100k cache'. Here a task is simulated when it is first requested, on all
cores, and its statuses are stored in the user's cache folder. Only the requested number of actions is simulated. An
interrupted simulation continues where it stopped. PHYRE's own file is used if it exists.
"""

import logging
import os
import pathlib
import sys
import warnings
from typing import Any, Callable, Dict, FrozenSet, Optional, Sequence, Union

import numpy as np

from pathlight_phyre import _native
from pathlight_phyre._checks import check_tier
from pathlight_phyre.action_simulator import SimulationStatus

ACTION_SEED = 42
DEFAULT_NUM_ACTIONS = 100000
CACHE_FILE_NAME = "simulation_cache.gz"

PHYRE_CACHE_ENV = "PHYRE_CACHE_DIR"
"""Environment variable: the folder of PHYRE's caches, ~/.cache/phyre by default."""

PATHLIGHT_CACHE_ENV = "PATHLIGHT_PHYRE_CACHE_DIR"
"""Environment variable: the folder of the statuses simulated here, ~/.cache/pathlight-phyre by default."""

SOLVED = int(SimulationStatus.SOLVED)
INVALID = int(SimulationStatus.INVALID_INPUT)
NOT_SOLVED = int(SimulationStatus.NOT_SOLVED)

CHUNK = 2000
"""Number of actions between progress updates."""

KEPT_EVERY = 10
"""Number of chunks between writes to the file."""

logger = logging.getLogger("phyre.simulation_cache")


def get_cache_folder(action_size: int) -> pathlib.Path:
    """Returns the folder of PHYRE's own files for lists of this many actions."""
    return _phyre_folder() / "offline_simulation" / str(action_size)


def get_partial_cache_folder(action_size: int) -> pathlib.Path:
    """Returns the folder of PHYRE's unfinished files."""
    return _phyre_folder() / "partial" / str(action_size)


def get_default_100k_cache(tier: str) -> "SimulationCache":
    """Returns the statuses of PHYRE's 100,000 actions: PHYRE's own file if it is in ``get_cache_folder(100000)``, else
    statuses simulated on demand.

    Raises:
        ValueError: If the tier is not ``'ball'``.
    """
    check_tier(tier)
    folder = get_cache_folder(DEFAULT_NUM_ACTIONS) / tier
    return SimulationCache(folder) if (folder / CACHE_FILE_NAME).exists() else _SimulatedCache()


class SimulationCache:
    """Statuses of a list of actions in tasks, from a phyre file."""

    def __init__(self, cache_dir: Union[str, pathlib.Path]):
        """Reads the file in a folder. Needs joblib.

        Raises:
            ValueError: If the file does not exist.
            ImportError: If joblib is not installed.
        """
        path = pathlib.Path(cache_dir) / CACHE_FILE_NAME
        if not path.exists():
            raise ValueError(f"there is no {path}: get_default_100k_cache('ball') simulates the statuses instead")
        try:
            import joblib
        except ImportError:
            raise ImportError(f"reading {path} needs joblib: install it, or move the file away") from None
        cache = joblib.load(path)
        self._action_array = cache["actions"]
        self._statuses_per_task = cache["statuses_per_task"]

    def __len__(self) -> int:
        """Returns the number of actions."""
        return len(self._action_array)

    @property
    def action_array(self) -> np.ndarray:
        """The actions, float32 (actions, 3)."""
        return self._action_array

    @property
    def task_ids(self) -> FrozenSet[str]:
        """The ids of the tasks."""
        return frozenset(self._statuses_per_task)

    def load_simulation_states(self, task_id: str) -> np.ndarray:
        """Returns the status numbers of all actions in a task, int8 (actions,)."""
        return self._first_statuses(task_id, len(self))

    def get_sample(self, task_ids: Optional[Sequence[str]] = None, num_actions: Optional[int] = None) -> Dict[str, Any]:
        """Returns the statuses of the first actions in some tasks.

        Args:
            task_ids: The tasks; by default all.
            num_actions: The number of actions; by default all.

        Returns:
            ``task_ids`` as given, ``actions`` float32 (num_actions, 3), ``simulation_statuses`` int8 (tasks,
            num_actions).

        Raises:
            ValueError: If there are fewer actions, or a task is unknown.
        """
        task_ids = sorted(self.task_ids) if task_ids is None else task_ids
        num_actions = len(self) if num_actions is None else num_actions
        if not 0 <= num_actions <= len(self):
            raise ValueError(f"there are {len(self)} actions, not {num_actions}: ask for fewer")
        statuses = np.empty((len(task_ids), num_actions), np.int8)
        with _Progress(len(task_ids)) as progress:
            for row, task_id in enumerate(task_ids):
                statuses[row] = self._first_statuses(task_id, num_actions, progress)
        return {"task_ids": task_ids, "actions": self.action_array[:num_actions], "simulation_statuses": statuses}

    def _first_statuses(self, task_id: str, count: int, progress: "Optional[_Progress]" = None) -> np.ndarray:
        return self._statuses_per_task[task_id][:count]


class _SimulatedCache(SimulationCache):
    """Statuses that are simulated on demand and stored in files."""

    def __init__(self) -> None:
        self._action_array = _native.actions()
        self._task_ids = frozenset(_native.task_ids())
        self._folder = _own_folder() / f"statuses-{_native.SIMULATOR_VERSION}"

    @property
    def task_ids(self) -> FrozenSet[str]:
        """The ids of the tasks."""
        return self._task_ids

    def _first_statuses(self, task_id: str, count: int, progress: "Optional[_Progress]" = None) -> np.ndarray:
        scene = _native.Scene(task_id)
        path = self._folder / f"{task_id.replace(':', '-')}.npy"
        statuses = _read(path, len(self))
        if len(statuses) >= count:
            return statuses[:count]
        own = progress is None
        progress = _Progress(1) if progress is None else progress
        kept = len(statuses)
        try:
            progress.begin(task_id, len(statuses), count)
            for number, start in enumerate(range(len(statuses), count, CHUNK), 1):
                actions = self._action_array[start : min(start + CHUNK, count)].astype(np.float64)
                statuses = np.concatenate([statuses, scene.statuses(actions, False)])
                progress.advance(len(statuses))
                if number % KEPT_EVERY == 0:
                    _write(path, statuses)
                    kept = len(statuses)
        finally:
            if len(statuses) > kept:
                _write(path, statuses)
            if own:
                progress.end()
        return statuses


def _phyre_folder() -> pathlib.Path:
    folder = os.environ.get(PHYRE_CACHE_ENV)
    return pathlib.Path(folder) if folder else _cache_root() / "phyre"


def _own_folder() -> pathlib.Path:
    folder = os.environ.get(PATHLIGHT_CACHE_ENV)
    return pathlib.Path(folder) if folder else _cache_root() / "pathlight-phyre"


def _cache_root() -> pathlib.Path:
    return pathlib.Path(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"))


def _read(path: pathlib.Path, most: int) -> np.ndarray:
    """Returns the statuses in a file; empty if there is no usable file."""
    none = np.empty(0, np.int8)
    try:
        statuses = np.load(path, allow_pickle=False)
    except FileNotFoundError:
        return none
    except (OSError, ValueError, EOFError) as error:
        logger.warning("%s is damaged and will be simulated again: %s", path, error)
        return none
    if statuses.dtype != np.int8 or statuses.ndim != 1 or len(statuses) > most:
        logger.warning("%s does not contain statuses and will be simulated again", path)
        return none
    return statuses


def _write(path: pathlib.Path, statuses: np.ndarray) -> None:
    """Writes statuses to a file atomically."""
    draft = path.with_name(f"{path.name}.{os.getpid()}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with open(draft, "wb") as file:
            np.save(file, statuses)
        os.replace(draft, path)
    except OSError as error:
        warnings.warn(
            f"the statuses cannot be stored ({error}): set {PATHLIGHT_CACHE_ENV} to a writable folder",
            stacklevel=2,
        )


class _Progress:
    """Shows the progress of a simulation on standard error, if it is a terminal or a notebook."""

    def __init__(self, tasks: int):
        self._tasks = tasks
        self._task = 0
        self._words: Callable[[int], str] = str
        self._shown = sys.stderr.isatty() or "ipykernel" in sys.modules
        self._is_open = False

    def __enter__(self) -> "_Progress":
        return self

    def __exit__(self, *_: object) -> None:
        self.end()

    def begin(self, task_id: str, done: int, count: int) -> None:
        self._task += 1
        task = self._task
        self._words = lambda done: f"{task_id} ({task} of at most {self._tasks}): {done:,} of {count:,} actions"
        logger.info("simulating %s", self._words(done))
        self.advance(done)

    def advance(self, done: int) -> None:
        if self._shown:
            self._is_open = True
            print(f"\r\x1b[K{self._words(done)}", end="", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._is_open:
            print(file=sys.stderr)
        self._is_open = False

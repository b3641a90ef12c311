"""The folds of the benchmark and its metric, AUCCESS."""

import logging
import math
from collections import defaultdict
from typing import Any, Dict, List, Sequence, Tuple, Union

from pathlight_phyre import _native
from pathlight_phyre._checks import BALL_TIER
from pathlight_phyre.action_simulator import SimulationStatus
from pathlight_phyre.util import stable_shuffle

MAIN_EVAL_SETUPS: Tuple[str, ...] = ("ball_cross_template", "ball_within_template")
"""The evaluation setups: tests on new templates, and on new tasks of known templates."""

MAX_TEST_ATTEMPTS: int = _native.MAX_ATTEMPTS
"""Maximum number of attempts per task."""

TRAIN_SHARE = 0.8
AUCCESS_METRIC = "independent_solved_by_aucs"

SimulationStatusLike = Union[int, str, SimulationStatus]
Metrics = Dict[str, Any]
EvalSetup = List[Tuple[Sequence[str], Sequence[Sequence[str]]]]

# phyre's logger name, so that filters of its warnings keep working.
logger = logging.getLogger("phyre.metrics")


def list_eval_setups() -> Tuple[str, ...]:
    """Returns the names of the evaluation setups."""
    return MAIN_EVAL_SETUPS


def eval_setup_to_action_tier(eval_setup_name: str) -> str:
    """Returns the action tier of an evaluation setup.

    Raises:
        ValueError: If the setup is not in the ball tier.
    """
    if not eval_setup_name.startswith(BALL_TIER):
        raise ValueError(f"there is no evaluation setup {eval_setup_name!r}: use one of {MAIN_EVAL_SETUPS}")
    return BALL_TIER


def get_fold(eval_setup: str, seed: int) -> Tuple[Tuple[str, ...], Tuple[str, ...], Tuple[str, ...]]:
    """Returns the ids of a fold: train, dev, test, each sorted.

    Args:
        eval_setup: One of ``MAIN_EVAL_SETUPS``.
        seed: Number of the fold. The benchmark has 0..9; values up to 255 give further folds.

    Raises:
        ValueError: If there is no such fold.
    """
    if eval_setup not in MAIN_EVAL_SETUPS:
        raise ValueError(f"there is no evaluation setup {eval_setup!r}: use one of {MAIN_EVAL_SETUPS}")
    if seed not in range(256):
        raise ValueError(f"there is no fold {seed!r}: the folds of the benchmark are 0 to 9")
    train, dev, test = _native.fold(eval_setup == "ball_cross_template", int(seed))
    return tuple(train), tuple(dev), tuple(test)


def get_task_ids_in_tier(tier_name: str) -> List[str]:
    """Returns the ids of all tasks of a tier, sorted; empty for any tier but ``'ball'``."""
    return _native.task_ids() if tier_name.lower() == BALL_TIER else []


def ball_single_instance(max_per_tpl: int = 10) -> EvalSetup:
    """Returns one group, without training tasks, for each of up to ``max_per_tpl`` tasks per template."""
    of_template: Dict[str, List[str]] = defaultdict(list)
    for task_id in _native.task_ids():
        of_template[task_id.split(":")[0]].append(task_id)
    return [
        ((), ((task_id,),))
        for _, task_ids in sorted(of_template.items())
        for task_id in stable_shuffle(task_ids, "ball_online_ind_tasks")[:max_per_tpl]
    ]


def ball_single_instance_tiny() -> EvalSetup:
    """Returns ``ball_single_instance`` with one task per template."""
    return ball_single_instance(1)


def create_dev_set(eval_setup: EvalSetup, train_share: float = TRAIN_SHARE, seed: int = 0) -> EvalSetup:
    """Splits the training part of each group of a setup into train and dev."""
    groups: EvalSetup = []
    for train_ids, _ in eval_setup:
        shuffled = stable_shuffle(train_ids, f"make_dev{seed}")
        count = int(len(shuffled) * train_share)
        groups.append((shuffled[:count], [shuffled[count:]]))
    return groups


def compute_metrics(raw_simulation_log: Sequence[Tuple[str, SimulationStatusLike]]) -> Metrics:
    """Returns the metrics of attempts as counts of tasks.

    Args:
        raw_simulation_log: Task and status of each attempt, in order. Invalid actions do not count.

    Returns:
        ``independent_solved_by[k]``: tasks solved within k attempts, k in 0..100.
        ``independent_solved_by_aucs[k]``: AUCCESS up to k attempts.
        ``global_solved_by[n]``: tasks solved within the first n attempts at any task.
        ``total_attempts``, ``total_solved``.
    """
    if not raw_simulation_log:
        logger.warning("Computing metrics for empty evaluation log!")
    attempts: Dict[str, int] = defaultdict(int)
    first_solved: Dict[str, int] = {}
    solved_at: List[int] = []
    for task, status in raw_simulation_log:
        status = _status(status)
        if status.is_invalid():
            continue
        attempts[task] += 1
        if status.is_solved() and task not in first_solved:
            first_solved[task] = attempts[task]
            solved_at.append(sum(attempts.values()))
    if any(first > MAX_TEST_ATTEMPTS for first in first_solved.values()):
        logger.warning("Some tasks were solved after more than %d attempts; these do not count.", MAX_TEST_ATTEMPTS)
    solved_by = [sum(first <= k for first in first_solved.values()) for k in range(MAX_TEST_ATTEMPTS + 1)]
    aucs, area, whole = [0.0], 0.0, 0.0
    for k in range(1, MAX_TEST_ATTEMPTS + 1):
        weight = math.log(k + 1) - math.log(k)
        area += weight * solved_by[k]
        whole += weight
        aucs.append(area / whole)
    return {
        "independent_solved_by": solved_by,
        AUCCESS_METRIC: aucs,
        "global_solved_by": {n: sum(at <= n for at in solved_at) for n in (100, 1000, 100000)},
        "total_attempts": sum(attempts.values()),
        "total_solved": len(first_solved),
    }


def normalize_metrics(metrics: Any, num_tasks: int) -> Any:
    """Divides every number in metrics by the number of tasks."""
    if isinstance(metrics, dict):
        return {name: normalize_metrics(value, num_tasks) for name, value in metrics.items()}
    if isinstance(metrics, list):
        return [normalize_metrics(value, num_tasks) for value in metrics]
    return metrics / num_tasks


def compute_metrics_normalized(simulation_log: Sequence[Tuple[str, SimulationStatusLike]], num_tasks: int) -> Metrics:
    """Returns the metrics of attempts as shares of tasks."""
    metrics = compute_metrics(simulation_log)
    if metrics["total_attempts"] < MAX_TEST_ATTEMPTS * num_tasks:
        logger.warning(
            "Used %f attempts per task instead of maximum allowed %f. That probably indicate a bug in evaluation loop.",
            metrics["total_attempts"] / num_tasks,
            MAX_TEST_ATTEMPTS,
        )
    return normalize_metrics(metrics, num_tasks)


class Evaluator:
    """Counts and scores attempts at tasks.

    Attributes:
        attempts_per_task_index: Number of attempts at each task so far.
    """

    def __init__(self, task_ids: Sequence[str]):
        self._task_ids = task_ids
        self._log: List[Tuple[str, SimulationStatus]] = []
        self.attempts_per_task_index: List[int] = [0] * len(task_ids)

    @property
    def task_ids(self) -> Sequence[str]:
        """The ids of the tasks."""
        return self._task_ids

    def __len__(self) -> int:
        """Returns the number of attempts at all tasks."""
        return len(self._log)

    def maybe_log_attempt(self, task_index: int, status: SimulationStatusLike) -> bool:
        """Counts an attempt, unless the action was invalid. Returns whether it counted.

        Raises:
            AssertionError: If the task has no attempts left.
        """
        status = _status(status)
        if status.is_invalid():
            return False
        task_id, made = self._task_ids[task_index], self.attempts_per_task_index[task_index]
        if made >= MAX_TEST_ATTEMPTS:
            raise AssertionError(f"task {task_id} has had {MAX_TEST_ATTEMPTS} attempts: continue with the next task")
        self._log.append((task_id, status))
        self.attempts_per_task_index[task_index] = made + 1
        return True

    def get_attempts_for_task(self, task_index: int) -> int:
        """Returns the number of attempts at a task so far."""
        return self.attempts_per_task_index[task_index]

    def compute_all_metrics(self) -> Metrics:
        """Returns the metrics of ``compute_metrics`` as shares of the tasks."""
        return compute_metrics_normalized(self._log, len(self._task_ids))

    def get_auccess(self, attempts: int = MAX_TEST_ATTEMPTS) -> float:
        """Returns AUCCESS up to this many attempts, 0..1."""
        return self.compute_all_metrics()[AUCCESS_METRIC][attempts]

    def get_aucess(self, attempts: int = MAX_TEST_ATTEMPTS) -> float:
        """Returns ``get_auccess``, under the misspelt name that phyre once used."""
        return self.get_auccess(attempts)


def _status(status: SimulationStatusLike) -> SimulationStatus:
    return SimulationStatus(int(status))

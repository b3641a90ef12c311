"""Checks of arguments, with errors that name the remedy."""

from typing import Any

import numpy as np

BALL_TIER = "ball"


def check_tier(tier: str) -> None:
    """Raises ValueError unless the tier is the ball tier."""
    if tier != BALL_TIER:
        raise ValueError(f"there is no action tier {tier!r}: pathlight_phyre only has PHYRE's ball tier, 'ball'")


def action_of(action: Any) -> np.ndarray:
    """Returns an action as float64, (3,)."""
    array = _numbers(action, "an action")
    if array.shape != (3,):
        raise ValueError(f"an action is three numbers, x, y and radius in 0..1, not an array of shape {array.shape}")
    return array


def actions_of(actions: Any) -> np.ndarray:
    """Returns actions as contiguous float64, (actions, 3)."""
    array = _numbers(actions, "actions")
    if array.size == 0:
        return np.empty((0, 3))
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"actions are an array of shape (actions, 3), not {array.shape}")
    return np.ascontiguousarray(array)


def stride_of(stride: Any) -> int:
    """Returns a stride as an int."""
    if int(stride) != stride or stride < 1:
        raise ValueError(f"a stride is a whole number of steps, at least 1, not {stride!r}: 60 steps are one second")
    return min(int(stride), 1_000_000)


def _numbers(values: Any, name: str) -> np.ndarray:
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} must be numbers: {error}") from None
    if np.isnan(array).any():
        raise ValueError(f"{name} must be numbers, but there is a NaN: find out where it was computed")
    return array

"""Constants of a simulation."""

from pathlight_phyre import _native

DEFAULT_MAX_STEPS: int = _native.MAX_STEPS
"""Steps of a simulation, unless the task is solved before."""

STEPS_FOR_SOLUTION: int = _native.GOAL_STEPS
"""Steps for which the object has to touch its goal: three seconds."""

DEFAULT_STRIDE: int = _native.DEFAULT_STRIDE
"""Steps between two observations: one second."""

OBJECT_FEATURE_SIZE: int = _native.FEATURES
"""Features of an object."""

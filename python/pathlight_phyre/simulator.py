"""Constants of a simulation."""

from pathlight_phyre import _native

DEFAULT_MAX_STEPS: int = _native.MAX_STEPS
"""Number of steps of a simulation, unless the task is solved earlier."""

STEPS_FOR_SOLUTION: int = _native.GOAL_STEPS
"""Number of steps for which the object must touch its goal: three seconds."""

DEFAULT_STRIDE: int = _native.DEFAULT_STRIDE
"""Number of steps between observations: one second."""

OBJECT_FEATURE_SIZE: int = _native.FEATURES
"""Number of features of an object."""

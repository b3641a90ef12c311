"""Constants of a simulation."""

from pathlight_phyre import _native

DEFAULT_MAX_STEPS: int = 1000
"""Steps of a simulation, unless the task is solved before."""

STEPS_FOR_SOLUTION: int = 180
"""Steps for which the object has to touch its goal: three seconds."""

DEFAULT_STRIDE: int = _native.DEFAULT_STRIDE
"""Steps between two observations: one second."""

OBJECT_FEATURE_SIZE: int = 14
"""Features of an object."""

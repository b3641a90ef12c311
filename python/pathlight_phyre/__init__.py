"""The PHYRE benchmark for current versions of Python.

``import pathlight_phyre as phyre`` provides the API of phyre 0.2.2 for the ball tier: its 2,500 tasks, its folds and
metric, and its physics, reproduced to the bit. ``install()`` makes ``import phyre`` itself find this package.
``ActionSimulator.simulate_actions``, ``.agents`` and ``.environment`` are additions to phyre.

Lengths are in px of a scene of 256 x 256 px, y up; row 0 of an image is the bottom of the scene.
"""

from typing import Tuple

from pathlight_phyre import objects_util, simulation_cache, vis
from pathlight_phyre._drop_in import install
from pathlight_phyre.action_simulator import ActionSimulator, SimulationStatus, initialize_simulator
from pathlight_phyre.creator.constants import NUM_COLORS, SCENE_HEIGHT, SCENE_WIDTH
from pathlight_phyre.metrics import (
    MAIN_EVAL_SETUPS,
    MAX_TEST_ATTEMPTS,
    Evaluator,
    eval_setup_to_action_tier,
    get_fold,
    list_eval_setups,
)
from pathlight_phyre.objects_util import featurized_objects_vector_to_raster
from pathlight_phyre.simulation import FeaturizedObjects, Simulation
from pathlight_phyre.simulation_cache import SimulationCache, get_default_100k_cache
from pathlight_phyre.vis import observations_to_float_rgb, observations_to_uint8_rgb

ACTION_TIERS: Tuple[str, ...] = ("ball",)
"""The action tiers of this package."""

__all__ = [
    "ACTION_TIERS",
    "MAIN_EVAL_SETUPS",
    "MAX_TEST_ATTEMPTS",
    "NUM_COLORS",
    "SCENE_HEIGHT",
    "SCENE_WIDTH",
    "ActionSimulator",
    "Evaluator",
    "FeaturizedObjects",
    "Simulation",
    "SimulationCache",
    "SimulationStatus",
    "eval_setup_to_action_tier",
    "featurized_objects_vector_to_raster",
    "get_default_100k_cache",
    "get_fold",
    "initialize_simulator",
    "install",
    "list_eval_setups",
    "objects_util",
    "observations_to_float_rgb",
    "observations_to_uint8_rgb",
    "simulation_cache",
    "vis",
]

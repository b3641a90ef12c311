"""PHYRE's API, and how code that imports phyre finds it."""

import subprocess
import sys

import pytest

import pathlight_phyre as phyre

NAMES = """ACTION_TIERS ActionSimulator Evaluator FeaturizedObjects MAIN_EVAL_SETUPS MAX_TEST_ATTEMPTS NUM_COLORS
SCENE_HEIGHT SCENE_WIDTH Simulation SimulationCache SimulationStatus eval_setup_to_action_tier
featurized_objects_vector_to_raster get_default_100k_cache get_fold initialize_simulator list_eval_setups
observations_to_float_rgb observations_to_uint8_rgb"""


def run(code):
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)


def test_the_names_of_phyre_are_there():
    assert [name for name in NAMES.split() if not hasattr(phyre, name)] == []


def test_installed_it_is_found_as_phyre():
    done = run(
        "import pathlight_phyre; pathlight_phyre.install(); pathlight_phyre.install()\n"
        "import phyre, phyre.objects_util, phyre.simulation_cache as cache\n"
        "from phyre.creator.constants import SCENE_WIDTH\n"
        "assert phyre is pathlight_phyre and cache.INVALID == 0 and SCENE_WIDTH == 256\n"
        "assert cache.SimulationCache is phyre.SimulationCache"
    )
    assert done.returncode == 0, done.stderr


def test_it_does_not_replace_phyre_itself():
    done = run(
        "import sys, types; sys.modules['phyre'] = types.ModuleType('phyre')\nimport pathlight_phyre as p; p.install()"
    )
    assert "phyre itself is already imported" in done.stderr


@pytest.mark.parametrize(
    "call",
    [
        lambda: phyre.eval_setup_to_action_tier("two_balls_cross_template"),
        lambda: phyre.get_fold("two_balls_within_template", 0),
        lambda: phyre.initialize_simulator(["00000:000"], "two_balls"),
        lambda: phyre.get_default_100k_cache("two_balls"),
    ],
)
def test_another_tier_is_refused(call):
    with pytest.raises(ValueError, match=r"two_balls.*ball"):
        call()


INSTALLED = """
import sys
def installed():
    files = {name.split('.')[0]: str(getattr(module, '__file__', '')) for name, module in list(sys.modules.items())}
    return {name for name, file in files.items() if 'site-packages' in file} - {'pathlight_phyre'}
before = installed()
import pathlight_phyre.agents
print(*sorted(installed() - before))
"""


def test_it_needs_numpy_alone():
    done = run(INSTALLED)
    assert done.stdout.split() == ["numpy"], done.stdout + done.stderr

"""Makes ``import phyre`` find this package, for code that must not change."""

import importlib
import sys

MODULES = (
    "action_simulator",
    "creator",
    "creator.constants",
    "loader",
    "metrics",
    "objects_util",
    "simulation",
    "simulation_cache",
    "simulator",
    "util",
    "vis",
)
"""The modules of phyre that this package provides."""


def install() -> None:
    """Makes ``import phyre``, ``phyre.objects_util`` and its other modules find this package, in this process.

    Raises:
        RuntimeError: If phyre itself has been imported already.
    """
    own = importlib.import_module("pathlight_phyre")
    if sys.modules.get("phyre", own) is not own:
        raise RuntimeError("phyre itself is already imported: call pathlight_phyre.install() before importing it")
    sys.modules["phyre"] = own
    for name in MODULES:
        sys.modules[f"phyre.{name}"] = importlib.import_module(f"pathlight_phyre.{name}")

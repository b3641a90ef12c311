"""PHYRE's scene constants. This package cannot create tasks."""

from pathlight_phyre.creator.constants import SCENE_HEIGHT, SCENE_WIDTH

__all__ = ["SCENE_HEIGHT", "SCENE_WIDTH"]

"""PHYRE's constants of a scene. Tasks cannot be created here."""

from pathlight_phyre.creator.constants import SCENE_HEIGHT, SCENE_WIDTH

__all__ = ["SCENE_HEIGHT", "SCENE_WIDTH"]

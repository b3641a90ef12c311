"""The size of a scene and its colours."""

SCENE_WIDTH: int = 256
"""Width of a scene, px."""

SCENE_HEIGHT: int = 256
"""Height of a scene, px."""

NUM_COLORS: int = 7
"""Colour codes of an image: white (the background), red, green, blue, purple, gray, black."""

"""Converts colour codes to pictures."""

from typing import Optional, Sequence, Tuple

import numpy as np

WAD_COLORS = np.array(
    [
        [255, 255, 255],  # white
        [243, 79, 70],  # red
        [107, 206, 187],  # green
        [24, 119, 242],  # blue
        [75, 74, 164],  # purple
        [185, 202, 210],  # gray
        [0, 0, 0],  # black
        [252, 223, 227],  # light red
    ],
    dtype=np.uint8,
)
"""PHYRE's colour of each code, RGB."""

SOLVE_STATUS_COLORS = np.array([[121, 6, 4], [11, 102, 35]], dtype=np.uint8)
"""Colours of the line above a picture: not solved, solved."""

LINE = 5
"""Height and margins of that line, px."""


def observations_to_uint8_rgb(
    scene: np.ndarray, user_input: Sequence[Tuple[int, int]] = (), is_solved: Optional[bool] = None
) -> np.ndarray:
    """Returns an image of colour codes as a picture, uint8 RGB (height, width, 3), row 0 at the top.

    Args:
        scene: Colour codes, (height, width), row 0 at the bottom.
        user_input: Pixels to draw red: column, row from the bottom.
        is_solved: If given, a line of 5 px above the picture shows it.
    """
    picture = WAD_COLORS[np.asarray(scene).astype(np.intp)]
    height, width = picture.shape[:2]
    for column, row in user_input:
        if 0 <= column < width and 0 <= row < height:
            picture[row, column] = (255, 0, 0)
    picture = picture[::-1]
    if is_solved is None:
        return picture
    line = np.broadcast_to(WAD_COLORS[0], (LINE, width, 3)).copy()
    line[:, LINE:-LINE] = SOLVE_STATUS_COLORS[int(is_solved)]
    return np.concatenate([line, picture])


def observations_to_float_rgb(
    scene: np.ndarray, user_input: Sequence[Tuple[int, int]] = (), is_solved: Optional[bool] = None
) -> np.ndarray:
    """Returns the picture of ``observations_to_uint8_rgb`` as float64, 0..1."""
    return observations_to_uint8_rgb(scene, user_input, is_solved).astype(float) / 255.0

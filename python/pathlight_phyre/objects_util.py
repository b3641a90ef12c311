"""Images of featurized objects."""

from typing import Any

import numpy as np

from pathlight_phyre import _native


def featurized_objects_vector_to_raster(featurized_objects: Any) -> np.ndarray:
    """Draws objects by their features.

    Args:
        featurized_objects: (objects, 14), as one time of ``FeaturizedObjects.features``.

    Returns:
        uint8 colour codes, (256, 256).

    Raises:
        ValueError: If no objects have these features.
    """
    return _native.raster(np.ascontiguousarray(featurized_objects, np.float32))

"""Images of featurized objects."""

from typing import Any

import numpy as np

from pathlight_phyre import _native


def featurized_objects_vector_to_raster(featurized_objects: Any) -> np.ndarray:
    """Draws objects from their features.

    Args:
        featurized_objects: (objects, 14), one time step of ``FeaturizedObjects.features``.

    Returns:
        uint8 colour codes, (256, 256).

    Raises:
        ValueError: If the features do not describe objects.
    """
    return _native.raster(np.ascontiguousarray(featurized_objects, np.float32))

"""The results of a simulation."""

from typing import Any, List, Optional

import numpy as np

SHAPES = ("BALL", "BAR", "JAR", "STANDINGSTICKS")
COLORS = ("RED", "GREEN", "BLUE", "PURPLE", "GRAY", "BLACK")


class FeaturizedObjects:
    """Features of objects over time: first the objects of the scene, last the ball of the action.

    Attributes:
        features: (times, objects, 14). By index: 0, 1 the centre of mass in scene widths; 2 the angle in turns;
            3 the diameter in scene widths; 4..8 the shape, one-hot in the order of ``SHAPES``; 8..14 the colour,
            one-hot in the order of ``COLORS``.
        xs, ys, angles: (times, objects).
        diameters: (objects,).
        shapes_one_hot, colors_one_hot: (objects, 4) and (objects, 6).
        states: (times, objects, 3): x, y, angle.
    """

    _NUM_FEATURES = 14
    _X_INDEX = 0
    _Y_INDEX = 1
    _ANGLE_INDEX = 2
    _DIAMETER_INDEX = 3
    _SHAPE_START_INDEX = 4
    _SHAPE_END_INDEX = 8
    _COLOR_START_INDEX = _SHAPE_END_INDEX
    _COLOR_END_INDEX = _NUM_FEATURES
    _STATE_START_INDEX = 0
    _STATE_END_INDEX = _DIAMETER_INDEX

    def __init__(self, featurized_objects: np.ndarray):
        """Wraps features.

        Raises:
            ValueError: If the features have another shape.
        """
        shape = np.shape(featurized_objects)
        if len(shape) != 3 or shape[-1] != self._NUM_FEATURES:
            raise ValueError(f"features are an array of shape (times, objects, {self._NUM_FEATURES}), not {shape}")
        self.features = featurized_objects
        self.xs = featurized_objects[:, :, self._X_INDEX]
        self.ys = featurized_objects[:, :, self._Y_INDEX]
        self.angles = featurized_objects[:, :, self._ANGLE_INDEX]
        self.diameters = featurized_objects[0, :, self._DIAMETER_INDEX]
        self.shapes_one_hot = featurized_objects[0, :, self._SHAPE_START_INDEX : self._SHAPE_END_INDEX]
        self.colors_one_hot = featurized_objects[0, :, self._COLOR_START_INDEX : self._COLOR_END_INDEX]
        self.states = featurized_objects[:, :, self._STATE_START_INDEX : self._STATE_END_INDEX]

    @property
    def shapes(self) -> List[str]:
        """The shape of each object, one of ``SHAPES``."""
        return [SHAPES[index] for index in np.argmax(self.shapes_one_hot, axis=1)]

    @property
    def colors(self) -> List[str]:
        """The colour of each object, one of ``COLORS``."""
        return [COLORS[index] for index in np.argmax(self.colors_one_hot, axis=1)]

    @property
    def num_objects(self) -> int:
        """Number of objects, including the ball of the action."""
        return self.features.shape[1]

    @property
    def num_user_inputs(self) -> int:
        """Number of balls of the action: 0 or 1."""
        return self.colors.count("RED")

    @property
    def num_scene_objects(self) -> int:
        """Number of objects, excluding the ball of the action."""
        return self.num_objects - self.num_user_inputs


class Simulation:
    """The result of an action. Values not requested are None; for an invalid action, all but the status are None.

    Attributes:
        status: The ``SimulationStatus``.
        images: uint8 colour codes, (times, 256, 256), row 0 at the bottom: 0 white (the background), 1 red, 2 green,
            3 blue, 4 purple, 5 gray, 6 black.
        featurized_objects: The ``FeaturizedObjects`` at the same times.

    Additions to phyre:
        velocities: float32, (times, objects, 3): of the centre of mass, px/s, and angular, rad/s, in the last step.
        masks: uint8, (times, objects, 256, 256): 1 where the object is, even if another object hides it.
        contacts: int64, (contacts, 4): two bodies, the first step in which they touch, and the first step after it in
            which they do not. If they touch to the end, that is one more than the number of steps. Bodies are numbered:
            first the objects, then the walls (bottom, left, top, right). Rows are in order of the first step.
        steps: int64, (times,): the step after which each observation is made, from 1.
        touching: bool, (times,): whether the object touches its goal.
    """

    def __init__(
        self,
        *,
        status: Any = None,
        images: Optional[np.ndarray] = None,
        featurized_objects: Optional[np.ndarray] = None,
        velocities: Optional[np.ndarray] = None,
        masks: Optional[np.ndarray] = None,
        contacts: Optional[np.ndarray] = None,
        steps: Optional[np.ndarray] = None,
        touching: Optional[np.ndarray] = None,
    ):
        self.status = status
        self.images = images
        self.featurized_objects = None if featurized_objects is None else FeaturizedObjects(featurized_objects)
        self.velocities = velocities
        self.masks = masks
        self.contacts = contacts
        self.steps = steps
        self.touching = touching

"""What an optimiser varies of a scene, and what it looks at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lemnis.scene import Scene
from lemnis.table import Column


@dataclass(frozen=True)
class Design:
    """Keys of a scene with their least and greatest values (SI), and results that follow from them.

    `at` has places at which the results are wanted, as inputs of `Scene.evaluate` of one shape (positions,): results are
    then vectors, otherwise numbers, such as the extremes of the whole range.
    """

    scene: Scene
    vary: Mapping[str, tuple[float, float]]
    outputs: Sequence[str]
    at: Mapping[str, ArrayLike] = field(default_factory=dict)

    @property
    def bounds(self) -> NDArray[np.float64]:
        """Least and greatest values, of shape (2, varied)."""
        return np.array(list(self.vary.values()), float).reshape(-1, 2).T

    @property
    def start(self) -> Column:
        """The values of the scene, of shape (varied,)."""
        return np.array([self.scene.quantities[key].value for key in self.vary])

    @property
    def positions(self) -> int:
        """How many places there are."""
        return int(np.prod(np.broadcast_shapes(*(np.shape(values) for values in self.at.values()))))

    def values(self, points: ArrayLike) -> NDArray[np.float64]:
        """The results at some points, of shape (points, outputs, positions); NaN for a design that does not exist.

        `points` has the shape (points, varied). All are computed at once, by all cores.
        """
        rows = np.asarray(points, float).reshape(-1, len(self.vary), 1)
        inputs = {key: rows[:, place] for place, key in enumerate(self.vary)}
        places = {name: np.reshape(values, (1, -1)) for name, values in self.at.items()}
        table = self.scene.evaluate({**inputs, **places}, outputs=list(self.outputs), faults="nan")
        return np.stack([table[name] for name in self.outputs], axis=1)

    def slopes(self, point: ArrayLike) -> NDArray[np.float64]:
        """Exact derivatives at one point, of shape (outputs, positions, varied). Raises `ModelError` where there are none."""
        inputs = dict(zip(self.vary, np.asarray(point, float)))
        places = {name: np.reshape(values, -1) for name, values in self.at.items()}
        found = self.scene.jacobian(list(self.outputs), list(self.vary), {**inputs, **places})
        return np.moveaxis(found.reshape(self.positions, len(self.outputs), len(self.vary)), 0, 1)

"""A design as a function of JAX, with its exact derivatives."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax  # type: ignore[import-not-found, unused-ignore]
import jax.numpy as jnp  # type: ignore[import-not-found, unused-ignore]
import numpy as np

from lemnis.adapters.design import Design


def function(design: Design) -> Callable[[Any], Any]:
    """Results of shape (outputs, positions) from values of shape (varied,); `jax.jit`, `grad`, `jacfwd` and `vmap` take it.

    JAX must have double precision: `jax.config.update("jax_enable_x64", True)`. A design that does not exist is NaN, and
    its derivative an error of JAX.
    """
    shape = (len(design.outputs), design.positions)
    value = jax.ShapeDtypeStruct(shape, jnp.float64)
    slope = jax.ShapeDtypeStruct((*shape, len(design.vary)), jnp.float64)

    @jax.custom_jvp  # type: ignore[untyped-decorator, unused-ignore]
    def results(point: Any) -> Any:
        return jax.pure_callback(lambda x: design.values([np.asarray(x)])[0], value, point, vmap_method="sequential")

    def along(points: Any, directions: Any) -> Any:
        (point,), (direction,) = points, directions
        found = jax.pure_callback(lambda x: design.slopes(np.asarray(x)), slope, point, vmap_method="sequential")
        return results(point), found @ direction

    results.defjvp(along)
    return results  # type: ignore[no-any-return, unused-ignore]

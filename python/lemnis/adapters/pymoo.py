"""A design as a problem of pymoo, a whole population at once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from pymoo.core.problem import Problem  # type: ignore[import-untyped]

from lemnis.adapters.design import Design

BAD = 1e30
"""What stands for a result of a design that does not exist."""


class CraneProblem(Problem):  # type: ignore[misc]
    """The least of some results under limits of others.

    `least` names the objectives, `limits` has for other results what they must keep to: `(None, 3.5e6)` at most,
    `(0.6, None)` at least. Objectives and limits are in SI; both are divided by their size in the scene. A design
    that does not exist keeps to no limit.
    """

    def __init__(self, design: Design, least: list[str], limits: Mapping[str, tuple[float | None, float | None]]) -> None:
        self.design, self.limits = design, dict(limits)
        self.columns = [list(design.outputs).index(name) for name in least]
        ends = [(name, sign, end) for name, ends in limits.items() for sign, end in zip((-1.0, 1.0), ends) if end is not None]
        self.ends = [(list(design.outputs).index(name), sign, end) for name, sign, end in ends]
        low, high = design.bounds
        super().__init__(n_var=len(design.vary), n_obj=len(least), n_ieq_constr=len(self.ends) + 1, xl=low, xu=high)

    def _evaluate(self, x: Any, out: dict[str, Any], *_: Any, **__: Any) -> None:
        found = self.design.values(x)[:, :, 0]
        exists = np.isfinite(found).all(axis=1, keepdims=True)
        beyond = [sign * (found[:, column] - end) / (abs(end) or 1.0) for column, sign, end in self.ends]
        limits = np.stack([*beyond, np.full(len(found), -1.0)], axis=1)
        out["F"] = np.where(exists, found[:, self.columns], BAD)
        out["G"] = np.where(exists, limits, BAD)

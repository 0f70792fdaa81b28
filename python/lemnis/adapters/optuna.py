"""A design for Optuna, which is asked for some trials, told their results, and asked again."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import optuna

from lemnis.adapters.design import Design


def search(
    study: optuna.Study,
    design: Design,
    least: str,
    limits: Mapping[str, tuple[float | None, float | None]],
    trials: int,
    batch: int = 32,
) -> None:
    """Asks a study for trials, computes each batch at once, and tells it the result that is to be `least`.

    The first trial is the scene's own design. `limits` has least and greatest values of other results, in SI; they are
    constraints of the trials, as parts of the limits. A design that does not exist is a failed trial.
    """
    names = list(design.outputs)
    ends = [(name, sign, end) for name, two in limits.items() for sign, end in zip((-1.0, 1.0), two) if end is not None]
    study.enqueue_trial(dict(zip(design.vary, design.start.tolist())))
    for done in range(0, trials, batch):
        asked = [study.ask() for _ in range(min(batch, trials - done))]
        points = [[trial.suggest_float(key, low, high) for key, (low, high) in design.vary.items()] for trial in asked]
        for trial, found in zip(asked, design.values(points)[:, :, 0]):
            if np.isnan(found).any():
                study.tell(trial, state=optuna.trial.TrialState.FAIL)
                continue
            for name, sign, end in ends:
                beyond = sign * (found[names.index(name)] - end) / (abs(end) or 1.0)
                trial.set_constraint(f"{name} {'<' if sign > 0 else '>'} {end}", float(beyond))
            study.tell(trial, float(found[names.index(least)]))

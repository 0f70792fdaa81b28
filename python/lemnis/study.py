"""Studies: many values of a scene's quantities, on threads of this process or on whatever an executor runs."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any, Protocol, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lemnis import _lemnis
from lemnis.table import Column, Table, Variable

Vary = Mapping[str, Union[str, ArrayLike]]
Rows = tuple[list[Column], list[NDArray[np.bool_]], list[tuple[int, str]]]

CHUNK = 512
"""Rows of a task for an executor: half a second of work, beside which a few milliseconds for sending it are nothing."""


class Task(Protocol):
    """Rows that an executor computes."""

    def result(self) -> Any:
        """Waits for the rows, and raises what they raised."""

    def cancel(self) -> Any:
        """Lets the rows be."""


class Executor(Protocol):
    """What computes elsewhere: `concurrent.futures.Executor`, or a `dask.distributed.Client`."""

    def submit(self, task: Callable[..., Any], /, *values: Any) -> Task:
        """Begins with `task(*values)`."""
        ...


class Study(Table):
    """The rows of a study, one for each design: columns of what varies, then of what is looked at, in SI.

    A design that cannot be is a row with NaN in its results; `faults` says why, by its number. `fails` has for each
    requirement of the scene, by its id, the rows that fail it; what is refused is not judged and fails nothing. What reads
    Arrow has both as columns of texts, `fails` and `refused`.
    """

    def __init__(
        self,
        columns: Mapping[str, Column],
        variables: Mapping[str, Variable],
        fails: Mapping[str, NDArray[np.bool_]],
        faults: Mapping[int, str],
    ) -> None:
        super().__init__(columns, variables, faults)
        self.fails = dict(fails)

    def _texts(self) -> list[tuple[str, list[str | None]]]:
        """What each design fails, and why it is refused, as `lemnis sweep --csv` writes it."""
        rows = range(self.shape[0])
        failed = [[name for name, fails in self.fails.items() if fails[row]] for row in rows]
        return [("fails", ["; ".join(names) or None for names in failed]), ("refused", [self.faults.get(row) for row in rows])]


class Studies:
    """What a scene has of studies."""

    _core: _lemnis.Scene
    _name: str

    def __init__(self, text: str, name: str = "scene") -> None:
        raise NotImplementedError

    def sweep(
        self,
        vary: Vary | None = None,
        outputs: str | Sequence[str] | None = None,
        *,
        executor: Executor | None = None,
        threads: int | None = None,
    ) -> Study:
        """Every combination of some values; without `vary` the designs that the scene's table `[study]` asks for.

        `vary` maps keys of the scene to arrays of numbers in SI, or to values as a scene has them, such as
        "18 m, 19 m or 20 m"; the last one changes fastest. `outputs` names results of the whole range, such as "R_max", or
        at a position, such as "R at theta_1 = 60 deg"; without it those of the scene's study. Each design is read as a scene
        of its own. The rows are shared by `threads` (one for each core), or by an `executor`, any of
        `concurrent.futures`, or a `dask.distributed.Client`: they have the same bits whoever computes them. Raises
        `SceneError` for what is no study, and what the executor raises where its workers are lost.

        >>> import lemnis
        >>> study = lemnis.Scene.default().sweep({"luffing.X_1": [19.3, 19.5]}, ["R_max", "R at theta_1 = 60 deg"])
        >>> [round(float(R), 4) for R in study["R_max"]]
        [29.9766, 29.8434]
        """
        return self._study(vary, outputs, vary is None, None, None, executor, threads)

    def monte_carlo(
        self,
        n: int | None = None,
        seed: int | None = None,
        vary: Vary | None = None,
        outputs: str | Sequence[str] | None = None,
        *,
        executor: Executor | None = None,
        threads: int | None = None,
    ) -> Study:
        """So many designs, drawn from how quantities vary; what is not given is as in the scene's table `[study]`.

        `vary` maps keys of the scene to texts as a scene has them: "18 m to 20 m", "± 1 mm", "normal, sd 1 mm"; all else is
        as in `sweep`. Design i is a function of `seed` and i alone: the first rows of a longer study are the shorter one.

        >>> import lemnis
        >>> study = lemnis.Scene.default().monte_carlo(4, vary={"luffing.X_1": "± 1 mm"}, outputs="R_max")
        >>> study.shape, bool(abs(study["luffing.X_1"] - 19.3).max() <= 1e-3)
        ((4,), True)
        """
        return self._study(vary, outputs, True, n, seed, executor, threads)

    def _study(
        self,
        vary: Vary | None,
        outputs: str | Sequence[str] | None,
        draws: bool,
        n: int | None,
        seed: int | None,
        executor: Executor | None,
        threads: int | None,
    ) -> Study:
        laws = None if vary is None else [(key, self._law(key, how)) for key, how in vary.items()]
        names = [outputs] if isinstance(outputs, str) else outputs if outputs is None else list(outputs)
        text = _lemnis.studied(self._core, laws, names, draws, n, seed)
        # Of the same class, which reads it and says what is wrong with it.
        scene = type(self)(text, self._name)
        count, varied, looked, requirements = _lemnis.study(scene._core)
        if executor is None:
            parts = [_lemnis.study_rows(scene._core, 0, count, cores(threads))]
        else:
            parts = spread(executor, text, count)
        numbers, fails = ([np.concatenate(columns) for columns in zip(*(part[i] for part in parts))] for i in (0, 1))
        variables = {
            name: Variable(name, role, unit, display, factor, symbol, meaning, source, ())
            for role, columns in (("parameter", varied), ("output", looked))
            for name, unit, display, factor, symbol, meaning, source in columns
        }
        faults = {design: reason for part in parts for design, reason in part[2]}
        return Study(dict(zip(variables, numbers)), variables, dict(zip(requirements, fails)), faults)

    def _law(self, key: str, how: str | ArrayLike) -> str:
        """How a quantity varies, as a scene says it."""
        if isinstance(how, str):
            return how
        values = np.asarray(how)
        if values.dtype.kind not in "fiu" or values.ndim != 1:
            raise TypeError(f"{key} varies by a text or by an array of real numbers in one dimension, not by {how!r}")
        known = {name: unit for name, _, _, unit, *_ in self._core.quantities()}
        unit = known.get(key, "")
        return ", ".join(f"{float(value)!r} {unit}".removesuffix(" 1").strip() for value in values)


@lru_cache(maxsize=8)
def parsed(text: str) -> _lemnis.Scene:
    """The scene of a text that was read before, elsewhere."""
    core, _ = _lemnis.parse(text)
    if core is None:
        raise RuntimeError("another version of lemnis has read this scene: the workers need the same one")
    return core


def chunk(text: str, start: int, stop: int) -> Rows:
    """Some rows of the study of a scene, computed by one thread: a task for an executor."""
    return _lemnis.study_rows(parsed(text), start, stop, 1)


def spread(executor: Executor, text: str, count: int) -> list[Rows]:
    """All rows, by tasks of an executor, in their order."""
    tasks = [executor.submit(chunk, text, start, min(start + CHUNK, count)) for start in range(0, count, CHUNK)]
    try:
        return [task.result() for task in tasks]
    except BaseException:
        for task in tasks:
            task.cancel()
        raise


CORES = os.cpu_count() or 1


def cores(threads: int | None) -> int:
    """How many threads share the rows."""
    if threads is None:
        return CORES
    if threads < 1:
        raise ValueError(f"threads must be at least 1, not {threads}")
    return int(threads)

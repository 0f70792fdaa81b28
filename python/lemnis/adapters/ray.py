"""The machines of Ray as an executor for studies."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor, Future
from typing import Any

import ray  # type: ignore[import-not-found, unused-ignore]


class RayExecutor(Executor):
    """What `executor` of a study takes, over the cluster that `ray.init` has joined. Rows of a lost worker are computed again."""

    def submit(self, task: Callable[..., Any], /, *values: Any, **named: Any) -> Future[Any]:
        return ray.remote(task).remote(*values, **named).future()  # type: ignore[no-any-return, unused-ignore]

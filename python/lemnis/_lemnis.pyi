from typing import Any, final

import numpy as np
from numpy.typing import NDArray

__all__ = ["DEFAULT", "VERSION", "ModelError", "stream", "Scene", "parse", "schema", "studied", "study", "study_rows"]

DEFAULT: str
VERSION: str

class ModelError(ValueError):
    """A value that the model refuses, or a configuration that does not exist."""

def parse(text: str) -> tuple[Scene | None, list[tuple[str, str, str | None, int, int]]]: ...
def schema() -> str: ...
def stream(
    fields: list[tuple[str, dict[str, str]]],
    columns: list[NDArray[np.float64]],
    texts: list[tuple[str, list[str | None]]],
) -> Any: ...
def study(
    scene: Scene,
) -> tuple[int, list[tuple[str, str, str, float, str, str, str]], list[tuple[str, str, str, float, str, str, str]], list[str]]: ...
def studied(
    scene: Scene,
    vary: list[tuple[str, str]] | None,
    outputs: list[str] | None,
    draws: bool,
    n: int | None,
    seed: int | None,
) -> str: ...
def study_rows(
    scene: Scene, start: int, stop: int, threads: int
) -> tuple[list[NDArray[np.float64]], list[NDArray[np.bool_]], list[tuple[int, str]]]: ...
@final
class Scene:
    @property
    def text(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def level(self) -> str: ...
    @property
    def levels(self) -> list[str]: ...
    @property
    def is_auto(self) -> bool: ...
    @property
    def experiment(self) -> tuple[float, float]: ...
    @property
    def states(self) -> int: ...
    def quantities(self) -> list[tuple[str, str, float, str, str, float, bool, str]]: ...
    def variables(self) -> list[tuple[str, str, str, tuple[str, float], str, str, str, list[str]]]: ...
    def replaced(self, changes: list[tuple[str, str | int | float]]) -> str: ...
    def rows(self) -> tuple[list[str], list[NDArray[np.float64]]]: ...
    def evaluate(
        self,
        names: list[str],
        columns: list[NDArray[np.float64]],
        count: int,
        outputs: list[str],
        threads: int,
        every: bool,
    ) -> tuple[list[NDArray[np.float64]], list[tuple[int, str]]]: ...
    def jacobian(
        self,
        names: list[str],
        columns: list[NDArray[np.float64]],
        count: int,
        of: list[str],
        wrt: list[str],
        threads: int,
    ) -> tuple[NDArray[np.float64], list[tuple[int, str]]]: ...
    def simulate(
        self,
        start: list[tuple[str, float]],
        inputs: list[str],
        columns: list[NDArray[np.float64]],
        times: NDArray[np.float64],
        outputs: list[str],
    ) -> tuple[list[NDArray[np.float64]], list[tuple[float, str]], str | None]: ...
    def told(self) -> dict[str, Any]: ...

"""A scene: what its text says, and all that follows from it."""

from __future__ import annotations

import csv
import json
import math
import os
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from pathlib import Path
from typing import Any, Literal, Union
from zipfile import ZipFile

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lemnis import _lemnis, program
from lemnis.errors import Diagnostic, SceneError, placed
from lemnis.study import Studies, cores
from lemnis.table import Column, RunEnded, Table, Variable

Numbers = Mapping[str, ArrayLike]
Signal = Union[float, Callable[[float], float], "tuple[ArrayLike, ArrayLike]"]
PathLike = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class Quantity:
    """A quantity of a scene: `value` in the SI `unit`; people write it in `display`, of which one is `factor` in SI."""

    key: str
    id: str
    value: float
    unit: str
    display: str
    factor: float
    given: bool
    """Whether the scene gives it, or it is what is usual."""
    text: str


@dataclass(frozen=True)
class Result:
    """A result of the whole range: `value` in `unit`, and where it occurs, as the coordinate's name and value in SI."""

    value: float
    unit: str
    at: tuple[str, float] | None
    text: str


@dataclass(frozen=True)
class Check:
    """A limit of the scene, or an identity that must hold: `value` beside `limit`, both in `unit`."""

    id: str
    symbol: str
    value: float
    limit: float
    at_most: bool
    passed: bool
    unit: str


@dataclass(frozen=True)
class Synthesis:
    """What a search found: a scene with it, and the words of `lemnis synth`."""

    scene: Scene
    report: str
    front: tuple[dict[str, float], ...] = ()
    """Of two aims, designs than which none is better in both: aims, quantities and limited results of each, by their names
    with units, in these units."""


def diagnostics(text: str) -> tuple[Diagnostic, ...]:
    """Everything that is wrong in a scene's text, in its order; nothing for a sound one.

    >>> import lemnis
    >>> [one.message for one in lemnis.diagnostics("name = 'Crane'")]
    ['`title` is missing at the top of the scene', 'the scene has no mechanism']
    """
    return placed(text, _lemnis.parse(text)[1])


def schema() -> dict[str, Any]:
    """The JSON Schema of scenes, for editors."""
    return dict(json.loads(_lemnis.schema()))


def listed(names: str | Sequence[str] | None, usual: Sequence[str]) -> list[str]:
    """Names as a list."""
    if names is None:
        return list(usual)
    return [names] if isinstance(names, str) else list(names)


def numbers(name: str, value: ArrayLike) -> Column:
    """An array of float64 from whatever holds real numbers."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise TypeError(f"{name} is no array of numbers: {error}") from None
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} must hold real numbers, and has {array.dtype}")
    return array.astype(np.float64, copy=False)


def together(inputs: Numbers | None, named: Numbers) -> tuple[list[str], list[Column], tuple[int, ...]]:
    """Names, flat columns (of one number where they have one) and the shape that all come to."""
    given = {**(inputs or {}), **named}
    if len(given) < len(inputs or {}) + len(named):
        raise TypeError(f"{', '.join(sorted(set(inputs or {}) & set(named)))} given twice")
    columns = {name: numbers(name, value) for name, value in given.items()}
    shapes = {column.shape for column in columns.values()}
    if len(shapes) == 1:
        (shape,) = shapes
        return list(columns), [column.reshape(-1) for column in columns.values()], shape
    try:
        shape = np.broadcast_shapes(*shapes)
    except ValueError:
        told = ", ".join(f"{name} {column.shape}" for name, column in columns.items())
        raise ValueError(f"shapes that do not fit together: {told}") from None
    flat = [
        column.reshape(-1) if column.size == 1 else np.broadcast_to(column, shape).reshape(-1)
        for column in columns.values()
    ]
    return list(columns), flat, shape


def failed(faults: list[tuple[int, str]], shape: tuple[int, ...]) -> None:
    """Raises the first of some faults."""
    for row, message in faults[:1]:
        place = f" at {[int(i) for i in np.unravel_index(row, shape)]}" if shape else ""
        raise _lemnis.ModelError(f"{message}{place}")


class Scene(Studies):
    """A crane as its text describes it. A scene never changes; `replace` makes another one.

    Scenes with the same text are equal, and pickle as their text, so that any executor takes them. All methods may be
    called from several threads at once.
    """

    def __init__(self, text: str, name: str = "scene") -> None:
        core, found = _lemnis.parse(text)
        if core is None:
            raise SceneError(name, text, placed(text, found))
        self._core = core
        self._name = name

    @classmethod
    def read(cls, path: PathLike) -> Scene:
        """The scene of a file. Raises `SceneError` where it is wrong, `OSError` where it cannot be read."""
        data = Path(path).read_bytes()
        try:
            text = data.decode()
        except UnicodeDecodeError as error:
            message = f"{path} is not text in UTF-8: byte {error.start} is the first that is not; save it as UTF-8"
            raise SceneError(str(path), "", (), message) from None
        return cls(text, str(path))

    @classmethod
    def parse(cls, text: str) -> Scene:
        """The scene of a text. Raises `SceneError` where it is wrong."""
        return cls(text)

    @classmethod
    def default(cls) -> Scene:
        """The lemniscate crane of Li and Jiang, with comments: a scene to start from."""
        return cls(_lemnis.DEFAULT, "default scene")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)

    def __reduce__(self) -> tuple[Any, ...]:
        return (Scene, (self.text, self._name))

    def __repr__(self) -> str:
        return f"<lemnis.Scene {self.name}: {self.title}, level {self.level}>"

    def _repr_html_(self) -> str:
        told = self._core.told()
        rows = "".join(
            f"<tr><td>{escape(name)}</td><td>{value:.6g} {escape(unit)}</td><td>{escape(text)}</td></tr>"
            for name, value, unit, _, text in told["summary"]
        )
        return f"<h4>{escape(self.title)}</h4>{told['drawing']}<table>{rows}</table>"

    @property
    def text(self) -> str:
        """As it was read, to the character."""
        return self._core.text

    @property
    def name(self) -> str:
        """Name of the model and of its files."""
        return self._core.name

    @property
    def title(self) -> str:
        """Title of the book, in English where it has several languages."""
        return self._core.title

    @property
    def level(self) -> str:
        """How deep it is modelled; where the scene leaves that open, the deepest level."""
        return self._core.level

    @property
    def levels(self) -> list[str]:
        """Levels that its tables allow, from cheap to deep."""
        return self._core.levels

    @cached_property
    def variables(self) -> dict[str, Variable]:
        """The variables of its model by their names, in the order of the FMU; the first one is the coordinate."""
        return {
            name: Variable(name, role, unit, display, factor, symbol, text, source, tuple(meanings))
            for name, role, unit, (display, factor), symbol, text, source, meanings in self._core.variables()
        }

    @cached_property
    def quantities(self) -> dict[str, Quantity]:
        """Its quantities by their keys, with what is usual where the scene gives nothing.

        >>> import lemnis
        >>> lemnis.Scene.default().quantities["luffing.X_1"].value
        19.3
        """
        return {one[0]: Quantity(*one) for one in self._core.quantities()}

    def replace(self, changes: Mapping[str, str | float]) -> Scene:
        """The scene with other values; comments and all else stay.

        `changes` maps keys such as `luffing.X_1` or `steering.groups[2].x` to texts with units, or to numbers in the SI unit
        of the quantity (of weights N, however the scene gives them). A note where a value comes from goes with it. Raises
        `SceneError` where the changed scene is wrong, `ModelError` for a number that is no quantity.

        >>> import lemnis
        >>> scene = lemnis.Scene.default().replace({"luffing.X_1": 19.5, "luffing.Q": "16 t"})
        >>> [line for line in scene.text.splitlines() if line.startswith(("X_1", "Q"))]
        ['X_1 = "19.5 m"                # boom O1-B', 'Q = "16 t"              # weight of the load; without it no forces are modelled']
        """
        for key, value in changes.items():
            if isinstance(value, bool) or not isinstance(value, (str, int, float, np.integer, np.floating)):
                raise TypeError(f"{key} must be a text or a number, not {type(value).__name__}")
        plain = [(key, value.item() if isinstance(value, np.generic) else value) for key, value in changes.items()]
        return Scene(self._core.replaced(plain), self._name)

    def _decided(self) -> _lemnis.Scene:
        """The core of a scene that leaves nothing open."""
        if self._core.is_auto:
            raise _lemnis.ModelError('fidelity = "auto" leaves the level open: `Scene.decided()` chooses it by the accuracy asked for')
        return self._core

    @cached_property
    def _outputs(self) -> list[str]:
        return [name for name, variable in self.variables.items() if variable.role == "output"]

    def results(self) -> Table:
        """All that changes over the working range: inputs, states and outputs at each position of the scene's table, at rest.

        Columns have the shape (positions,) and the numbers of `lemnis check --json`. Raises `ModelError` where a position
        does not exist.

        >>> import lemnis
        >>> round(float(lemnis.Scene.default().results()["R"].max()), 6)
        29.976575
        """
        names, columns = self._decided().rows()
        return Table(dict(zip(names, columns)), self.variables)

    def evaluate(
        self,
        inputs: Numbers | None = None,
        /,
        *,
        outputs: str | Sequence[str] | None = None,
        faults: Literal["raise", "nan"] = "raise",
        threads: int | None = None,
        **named: ArrayLike,
    ) -> Table:
        """Outputs at any inputs and dimensions, at rest.

        Inputs are given by keyword, or in a mapping where their names are no identifiers: variables such as `theta_1` or
        `Q`, or keys of the scene that stand by themselves, such as `luffing.X_1`. Numbers and arrays of any shapes that
        broadcast, in SI; what is not given is as in the scene. Without `outputs` all variables with that role come back.
        Columns have the shape of the inputs together. The interpreter runs on meanwhile; many rows are shared by
        `threads` (one for each core), and every row has the same bits whatever their number.

        Raises `ModelError` at the first row that does not exist; with `faults="nan"` such rows are NaN, and
        `Table.faults` says why. Raises `TypeError` for what is no real number.

        >>> import lemnis
        >>> scene = lemnis.Scene.default()
        >>> R = scene.evaluate({"luffing.X_1": [19.3, 19.5]}, theta_1=1.2, outputs="R")["R"]
        >>> [round(float(value), 6) for value in R]
        [27.697316, 27.62576]
        """
        if faults not in ("raise", "nan"):
            raise ValueError(f'faults must be "raise" or "nan", not {faults!r}')
        names, columns, shape = together(inputs, named)
        wanted = listed(outputs, self._outputs)
        count = math.prod(shape)
        found, wrong = self._decided().evaluate(names, columns, count, wanted, cores(threads), faults == "nan")
        if faults == "raise":
            failed(wrong, shape)
        return Table({name: column.reshape(shape) for name, column in zip(wanted, found)}, self.variables, dict(wrong))

    def jacobian(
        self,
        of: str | Sequence[str],
        wrt: str | Sequence[str],
        at: Numbers | None = None,
        /,
        *,
        threads: int | None = None,
        **named: ArrayLike,
    ) -> NDArray[np.float64]:
        """Exact derivatives of results by inputs and dimensions, from dual numbers, in SI.

        `of` names outputs or rates, `wrt` inputs, parameters, states or keys as in `evaluate`; the place is given as the
        inputs there. The shape is that of the inputs together, then of `of`, then of `wrt`. Raises `ModelError` where
        there is no derivative.

        >>> import lemnis
        >>> lemnis.Scene.default().jacobian(["R"], ["theta_1", "luffing.X_1"], theta_1=1.2).round(6)
        array([[-16.46064 ,  -0.306458]])
        """
        names, columns, shape = together(at, named)
        of, wrt = listed(of, ()), listed(wrt, ())
        found, wrong = self._decided().jacobian(names, columns, math.prod(shape), of, wrt, cores(threads))
        failed(wrong, shape)
        return found.reshape((*shape, len(of), len(wrt)))

    def simulate(
        self,
        stop: float | None = None,
        *,
        step: float | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, Signal] | None = None,
        outputs: str | Sequence[str] | None = None,
    ) -> Table:
        """A run from 0 to `stop` (s), as an importer steps the FMU: outputs, and states, after every `step` (s).

        Without them the default experiment of the scene counts. `start` has values of parameters, states and inputs,
        `inputs` what changes: a function of time, or times and values, between which real inputs are linear and others
        hold; each acts from the beginning of a step. The first column is `time`. The table's `events` tell which event
        indicators fell below zero between these times, and when: a bar that comes to rest, a rope that goes slack, a load
        that touches the ground. Raises `RunEnded` where the motion ends on the way: its `table` has what came before.

        >>> import lemnis
        >>> table = lemnis.Scene.default().simulate(2.0, step=1.0, outputs="R")
        >>> [round(float(R), 4) for R in table["R"]]
        [29.9766, 29.7468, 29.5071]
        """
        lasts, usual = self._decided().experiment
        stop, step = (float(usual if given is None else given) for given, usual in ((stop, lasts), (step, usual)))
        if not (0 < step < np.inf and 0 < stop < np.inf):
            raise ValueError(f"stop and step must be positive, not {stop} s and {step} s")
        count = int(np.ceil(stop / step * (1 - 1e-12)))
        times = np.minimum(np.arange(count + 1) * step, stop)
        usual_outputs = [name for name, variable in self.variables.items() if variable.role in ("state", "output")]
        wanted = listed(outputs, usual_outputs)
        signals = {name: self._signal(name, signal, times) for name, signal in (inputs or {}).items()}
        begin = [(name, float(numbers(name, value))) for name, value in (start or {}).items()]
        columns, events, ended = self._core.simulate(begin, list(signals), list(signals.values()), times, wanted)
        done = len(columns[0]) if columns else len(times)
        table = Table({"time": times[:done], **dict(zip(wanted, columns))}, {"time": TIME, **self.variables}, events=events)
        if ended is not None:
            raise RunEnded(ended, table)
        return table

    def _signal(self, name: str, signal: Signal, times: Column) -> Column:
        """An input at all times."""
        if callable(signal):
            return numbers(name, [signal(float(time)) for time in times])
        if not isinstance(signal, tuple):
            return np.full(len(times), float(numbers(name, signal)))
        at, values = (numbers(name, one) for one in signal)
        if at.ndim != 1 or at.shape != values.shape or at.size == 0 or np.any(np.diff(at) < 0):
            raise ValueError(f"{name} must have as many values as rising times, not {at.shape} and {values.shape}")
        if name in self.variables and self.variables[name].meanings:
            return values[np.maximum(np.searchsorted(at, times, side="right") - 1, 0)]
        return np.interp(times, at, values)

    def summary(self) -> dict[str, Result]:
        """Results of the whole range by their ids: extremes with their places, level error, work. In motion, manoeuvres of
        the book are run for it."""
        self._decided()
        return {one[0]: Result(*one[1:]) for one in self._core.told()["summary"]}

    def checks(self) -> list[Check]:
        """The scene's limits, whether they are kept, then identities of the calculation that must hold.

        >>> import lemnis
        >>> all(check.passed for check in lemnis.Scene.default().checks())
        True
        """
        self._decided()
        return [Check(*one) for one in self._core.told()["checks"]]

    def decided(self) -> Scene:
        """The scene with all decided that it leaves open, as its FMU has it: level, inner step."""
        with tempfile.TemporaryDirectory() as folder:
            path = self.fmu(Path(folder) / "decided.fmu")
            with ZipFile(path) as fmu:
                return Scene(fmu.read("resources/scene.toml").decode(), self._name)

    def synth(self, *, seed: int | None = None) -> Synthesis:
        """What `[synthesis]` or `[luffing.synthesis]` asks for, searched by a child process with all cores. The scene that
        comes back keeps its comments."""
        with tempfile.TemporaryDirectory() as folder:
            options = [] if seed is None else ["--seed", str(int(seed))]
            report = program.run("synth", self.text, "--output", folder, *options)
            (found,) = Path(folder).glob("*.toml")
            told = [line for line in report.splitlines() if folder not in line]
            front = []
            for file in Path(folder).glob("*_front.csv"):
                with file.open(encoding="utf-8", newline="") as rows:
                    front += [{name: float(value) for name, value in row.items()} for row in csv.DictReader(rows)]
            return Synthesis(Scene(found.read_bytes().decode(), self._name), "\n".join(told), tuple(front))

    def trade(self, *, step: float | None = None, rounds: int | None = None) -> dict[str, Any]:
        """What every level, solver and step costs, and how far it is off: the JSON of `lemnis trade`, in SI. `step` is that
        of communication (s), `rounds` how often the clock is asked."""
        options = [[] if value is None else [f"--{name}", str(value)] for name, value in (("step", step), ("rounds", rounds))]
        with tempfile.TemporaryDirectory() as folder:
            program.run("trade", self.text, "--output", folder, *sum(options, []))
            (found,) = Path(folder).glob("*.json")
            return dict(json.loads(found.read_bytes()))

    def book(
        self,
        path: PathLike,
        *,
        language: Literal["en", "zh", "bg"] | None = None,
        level: str | None = None,
        templates: PathLike | None = None,
    ) -> Path:
        """The calculation book as a file, .pdf or .html, typeset by a child process. Without `language` and `level` those of
        the scene count; the files of the folder `templates` override the built-in ones."""
        path = Path(path)
        if path.suffix not in (".pdf", ".html"):
            raise ValueError(f"{path} must end in .pdf or .html")
        given = (("language", language), ("level", level), ("templates", templates))
        options = [["--" + name, os.fspath(value)] for name, value in given if value is not None]
        return self._made("book", path, path.suffix, "--format", path.suffix[1:], *sum(options, []))

    def fmu(self, path: PathLike, *, fmi: Literal[2, 3] = 3, platforms: PathLike | None = None) -> Path:
        """The FMU as a file, of FMI 3.0 or 2.0; for this platform, or for all of a folder that `fmu/platforms.py` made."""
        if fmi not in (2, 3):
            raise ValueError(f"fmi must be 2 or 3, not {fmi!r}")
        options = [] if platforms is None else ["--platforms", os.fspath(platforms)]
        return self._made("fmu", Path(path), ".fmi2.fmu" if fmi == 2 else ".fmu", *options)

    def _made(self, command: str, path: Path, suffix: str, *options: str) -> Path:
        """A file that a command makes, at its place when it is whole."""
        if path.is_dir():
            raise IsADirectoryError(f"{path} is a folder: give the file too, such as {path / (self.name + suffix)}")
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=path.parent, prefix=".lemnis") as folder:
            program.run(command, self.text, "--output", folder, *options)
            os.replace(Path(folder) / f"{self.name}{suffix}", path)
        return path


TIME = Variable("time", "independent", "s", "s", 1.0, "t", "Simulation time.", "given", ())

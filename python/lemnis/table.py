"""Columns with their units."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lemnis import _lemnis

Column = NDArray[np.float64]


@dataclass(frozen=True)
class Variable:
    """A variable of a scene's model, as the FMU has it.

    `role` is "input", "parameter" (set before a run), "tunable" (a parameter that may change in a run), "output",
    "calculated" (follows from parameters), "state", "rate" or "indicator".
    """

    name: str
    role: str
    unit: str
    display: str
    factor: float
    symbol: str
    text: str
    source: str
    meanings: tuple[str, ...]
    """Of truth values, which are 0 and 1, and of enumerations, which count from 1; empty for real numbers."""


class Event(NamedTuple):
    """An event that a run met: when, in s, and which event indicator fell below zero."""

    time: float
    indicator: str


class Table(Mapping[str, Column]):
    """Values of variables: a mapping from names to arrays of float64 of one shape, in SI.

    It speaks Arrow (`__arrow_c_stream__`), so that `pandas.DataFrame.from_arrow(table)`, `polars.DataFrame(table)` and
    `pyarrow.table(table)` read it; unit, symbol and meaning of each column are in the metadata of its field.

    >>> import lemnis
    >>> table = lemnis.Scene.default().results()
    >>> table.shape, table.units["theta_1"], table.symbols["theta_1"]
    ((61,), 'rad', 'theta_1')
    """

    def __init__(
        self,
        columns: Mapping[str, Column],
        variables: Mapping[str, Variable],
        faults: Mapping[int, str] | None = None,
        events: Sequence[tuple[float, str]] = (),
    ) -> None:
        self._columns = dict(columns)
        self.variables = {name: variables[name] for name in columns}
        self.faults: dict[int, str] = dict(faults or {})
        """Of rows that do not exist, by their place in the flattened columns: why. Their values are NaN."""
        self.events = tuple(map(Event._make, events))
        """What was located on the way of a run, in the order of time."""

    def __getitem__(self, name: str) -> Column:
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"{name} is not in this table: {', '.join(self._columns)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def shape(self) -> tuple[int, ...]:
        """Of every column."""
        return next(iter(self._columns.values())).shape if self._columns else ()

    @property
    def units(self) -> dict[str, str]:
        """The SI unit of each column."""
        return {name: variable.unit for name, variable in self.variables.items()}

    @property
    def symbols(self) -> dict[str, str]:
        """Of each column what stands for it in formulas, in Typst's mathematics."""
        return {name: variable.symbol for name, variable in self.variables.items()}

    def __arrow_c_stream__(self, requested_schema: object = None) -> Any:
        """A stream of Arrow with one batch; columns of more dimensions are flattened."""
        fields = [
            (name, {"unit": variable.unit, "symbol": variable.symbol, "text": variable.text})
            for name, variable in self.variables.items()
        ]
        return _lemnis.stream(fields, [column.reshape(-1) for column in self._columns.values()], self._texts())

    def _texts(self) -> list[tuple[str, list[str | None]]]:
        """Columns of texts, which only Arrow has."""
        return []

    def __repr__(self) -> str:
        return f"<lemnis.Table {self.shape}: {', '.join(self._columns)}>"

    def _repr_html_(self) -> str:
        most = 12
        rows = min(most, int(np.prod(self.shape)))
        heads = "".join(f"<th>{escape(name)} [{escape(v.display)}]</th>" for name, v in self.variables.items())
        shown = [self._columns[name].reshape(-1)[:rows] / v.factor for name, v in self.variables.items()]
        body = "".join("<tr>" + "".join(f"<td>{column[row]:.6g}</td>" for column in shown) + "</tr>" for row in range(rows))
        more = "" if rows == int(np.prod(self.shape)) else f"<p>{int(np.prod(self.shape)) - rows} more rows</p>"
        return f"<table><thead><tr>{heads}</tr></thead><tbody>{body}</tbody></table>{more}"


class RunEnded(_lemnis.ModelError):
    """A run that ended before its time: `table` has what came before."""

    def __init__(self, message: str, table: Table) -> None:
        super().__init__(message, table)
        self.table = table

    def __str__(self) -> str:
        return str(self.args[0])

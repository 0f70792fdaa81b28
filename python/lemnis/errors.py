"""What is wrong with a scene, and where."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any
from unicodedata import east_asian_width


@dataclass(frozen=True)
class Diagnostic:
    """One thing that is wrong in a scene's text.

    `message` names the quantity, its value and what is allowed, `label` says what stands at the place, `help` what to do.
    `text[start:end]` is the place; `line` and `column` count from 1.
    """

    message: str
    label: str
    help: str | None
    start: int
    end: int
    line: int
    column: int


def placed(text: str, found: list[tuple[str, str, str | None, int, int]]) -> tuple[Diagnostic, ...]:
    """Diagnostics with their lines."""
    return tuple(
        Diagnostic(*one, text.count("\n", 0, one[3]) + 1, one[3] - text.rfind("\n", 0, one[3])) for one in found
    )


def width(text: str) -> int:
    """Columns of a terminal that a text takes."""
    return sum(2 if east_asian_width(char) in "WF" else 1 for char in text)


def shown(name: str, text: str, one: Diagnostic) -> str:
    """A diagnostic with its line, as a compiler shows it."""
    line = text.split("\n")[one.line - 1].rstrip("\r")
    number, margin = str(one.line), " " * len(str(one.line))
    before, marked = line[: one.column - 1], line[one.column - 1 : one.column - 1 + one.end - one.start]
    lines = [
        f"error: {one.message}",
        f"{margin}--> {name}:{one.line}:{one.column}",
        f"{margin} |",
        f"{number} | {line}",
        f"{margin} | {' ' * width(before)}{'^' * max(1, width(marked))} {one.label}".rstrip(),
    ]
    return "\n".join(lines + [f"{margin} = help: {one.help}"] * (one.help is not None))


class SceneError(ValueError):
    """A scene that is wrong: `diagnostics` has every mistake, in the order of the text; `line`, `column` and `help` are
    those of the first, or `None`.

    >>> import lemnis
    >>> try:
    ...     lemnis.Scene.parse(lemnis.Scene.default().text.replace('"19.3 m"', '"19.3 kN"'))
    ... except lemnis.SceneError as error:
    ...     print(error.line, error.column, error.help)
    23 7 units for it: m, mm, cm, km
    """

    diagnostics: tuple[Diagnostic, ...]

    def __init__(self, name: str, text: str, diagnostics: tuple[Diagnostic, ...], message: str | None = None) -> None:
        super().__init__(message or "\n\n".join(shown(name, text, one) for one in diagnostics))
        self.diagnostics = diagnostics
        self._made = (name, text, diagnostics, message)

    def __reduce__(self) -> tuple[Any, ...]:
        return (SceneError, self._made)

    @property
    def line(self) -> int | None:
        """Of the first mistake, counted from 1."""
        return self.diagnostics[0].line if self.diagnostics else None

    @property
    def column(self) -> int | None:
        """Of the first mistake, counted from 1."""
        return self.diagnostics[0].column if self.diagnostics else None

    @property
    def help(self) -> str | None:
        """What to do about the first mistake."""
        return self.diagnostics[0].help if self.diagnostics else None

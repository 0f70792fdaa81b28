"""A design as a component of OpenMDAO, with exact partial derivatives."""

from __future__ import annotations

from typing import Any

import numpy as np
import openmdao.api as om  # type: ignore[import-untyped]

from lemnis import ModelError
from lemnis.adapters.design import Design


def plain(name: str) -> str:
    """A key or a result as OpenMDAO may call it: `luffing.X_1` is `luffing:X_1`."""
    return name.replace(".", ":").replace("[", "_").replace("]", "")


class Crane(om.ExplicitComponent):  # type: ignore[misc]
    """Inputs are the keys that vary, in SI; outputs the results, one number for each position.

    A design that does not exist is an `AnalysisError`, from which drivers step back.
    """

    def initialize(self) -> None:
        self.options.declare("design", types=Design, desc="what varies, and what follows")

    @property
    def design(self) -> Design:
        return self.options["design"]  # type: ignore[no-any-return]

    def setup(self) -> None:
        for key, value in zip(self.design.vary, self.design.start):
            self.add_input(plain(key), value)
        for name in self.design.outputs:
            self.add_output(plain(name), shape=(self.design.positions,))

    def setup_partials(self) -> None:
        self.declare_partials("*", "*")

    def point(self, inputs: Any) -> list[float]:
        return [inputs[plain(key)].item() for key in self.design.vary]

    def compute(self, inputs: Any, outputs: Any) -> None:
        found = self.design.values([self.point(inputs)])[0]
        if np.isnan(found).any():
            raise om.AnalysisError(f"no such design: {dict(zip(self.design.vary, self.point(inputs)))}")
        for name, values in zip(self.design.outputs, found):
            outputs[plain(name)] = values

    def slopes(self, inputs: Any) -> Any:
        try:
            return self.design.slopes(self.point(inputs))
        except ModelError as error:
            raise om.AnalysisError(str(error)) from None

    def compute_partials(self, inputs: Any, partials: Any) -> None:
        for name, rows in zip(self.design.outputs, self.slopes(inputs)):
            for key, column in zip(self.design.vary, rows.T):
                partials[plain(name), plain(key)] = column[:, None]


class MatrixFreeCrane(Crane):
    """The same by products of the Jacobian with a vector: no matrix of partial derivatives is kept."""

    def setup_partials(self) -> None:
        pass

    def compute_partials(self, inputs: Any, partials: Any) -> None:
        raise NotImplementedError

    def compute_jacvec_product(self, inputs: Any, d_inputs: Any, d_outputs: Any, mode: str) -> None:
        for name, rows in zip(self.design.outputs, self.slopes(inputs)):
            for key, column in zip(self.design.vary, rows.T):
                if plain(name) in d_outputs and plain(key) in d_inputs:
                    if mode == "fwd":
                        d_outputs[plain(name)] += column * d_inputs[plain(key)]
                    else:
                        d_inputs[plain(key)] += column @ d_outputs[plain(name)]

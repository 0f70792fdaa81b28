"""Crane mechanisms from one scene file: models with exact derivatives, FMUs and calculation books.

A scene is a TOML file that describes a crane. Numbers are SI throughout: m, rad, N, s; in the text of a scene they have
their units. All results have the bits that the FMU and the book have.

>>> import lemnis
>>> scene = lemnis.Scene.default()
>>> table = scene.evaluate(theta_1=[1.2, 1.6], Q=160e3, outputs=["R", "M_Q"])
>>> [round(float(R), 4) for R in table["R"]]
[27.6973, 20.3561]
>>> table.units["M_Q"]
'N.m'
"""

from lemnis._lemnis import VERSION as __version__
from lemnis._lemnis import ModelError
from lemnis.errors import Diagnostic, SceneError
from lemnis.scene import Check, Quantity, Result, Scene, Synthesis, diagnostics, schema
from lemnis.study import Study
from lemnis.table import Event, RunEnded, Table, Variable

__all__ = [
    "Check",
    "Diagnostic",
    "Event",
    "ModelError",
    "Quantity",
    "Result",
    "RunEnded",
    "Scene",
    "SceneError",
    "Study",
    "Synthesis",
    "Table",
    "Variable",
    "__version__",
    "diagnostics",
    "schema",
]

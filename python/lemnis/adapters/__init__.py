"""Adapters to optimisers: what they vary, what they look at, and whose derivatives they take.

Each module needs the library of its name, which the package itself does not: `lemnis.adapters.openmdao`,
`lemnis.adapters.pymoo`, `lemnis.adapters.optuna`, `lemnis.adapters.jax`.
"""

from lemnis.adapters.design import Design

__all__ = ["Design"]

"""The balance of the portal crane by other optimisers, beside what `lemnis synth` finds.

    python python/examples/balance.py openmdao    (or pymoo, optuna, jax)

The lever, the rod and the counterweight may change as the scene's `[luffing.synthesis]` has it, for the least of the greatest
residual moment with a transmission angle of 34.6 deg or more.
"""

import sys
import time
from pathlib import Path

import numpy as np

import lemnis
from lemnis.adapters import Design

SCENES = Path(__file__).resolve().parents[2] / "models/scenes"
BOUNDS = {
    "r_1": (0.3, 12.0),
    "alpha_K": np.radians((-60.0, 60.0)),
    "l_1": (1.0, 20.0),
    "R_1": (0.3, 6.0),
    "chi_5": np.radians((-180.0, 180.0)),
    "M_5": (100e3, 984.8e3),
}
ANGLE = np.radians(34.6)


def design(outputs=("dM_max", "gamma_min"), at=None, region=1.0):
    """With bounds no further from the published balance than a part of their width."""
    scene, vary = lemnis.Scene.read(SCENES / "portal_004_new.toml"), {}
    for name, (low, high) in BOUNDS.items():
        key, reach = f"luffing.balance.{name}", region * (high - low)
        start = scene.quantities[key].value
        vary[key] = (float(max(low, start - reach)), float(min(high, start + reach)))
    return Design(scene, vary, outputs, at or {})


def by_openmdao():
    """SLSQP on the moments at all positions, by their exact derivatives: the least bound that none of them exceeds, within a
    region of trust about the last design, which shrinks where the search leaves all that exists."""
    import openmdao.api as om

    from lemnis.adapters.openmdao import Crane, plain

    moments = design(("dM",), {"theta_1": np.radians(np.arange(44.0, 82.5, 0.5))})
    keys, (low, high) = [plain(key) for key in moments.vary], moments.bounds
    best, region = moments.start, 0.05
    while region > 1e-4:
        least = np.abs(moments.values([best])).max()
        problem = om.Problem(reports=None)
        model, driver = problem.model, om.ScipyOptimizeDriver(optimizer="SLSQP", maxiter=100, tol=1e-10, disp=False)
        problem.driver = driver
        model.add_subsystem("moments", Crane(design=moments), promotes=["*"])
        model.add_subsystem("angle", Crane(design=design(("gamma_min",))), promotes=["*"])
        shapes = {name: {"shape": moments.positions} for name in ("above", "below", "dM")}
        sides = om.ExecComp(["above = dM - bound", "below = -dM - bound"], **shapes)
        model.add_subsystem("sides", sides, promotes=["*"])
        for key, start, least_end, most_end, size in zip(keys, best, low, high, high - low):
            model.set_input_defaults(key, start)
            model.add_design_var(key, max(least_end, start - region * size), min(most_end, start + region * size), ref=size)
        model.set_input_defaults("bound", least)
        model.add_design_var("bound", 0.0, ref=100e3)
        model.add_objective("bound", ref=100e3)
        for side in ("above", "below"):
            model.add_constraint(side, upper=0.0, ref=100e3)
        model.add_constraint("gamma_min", lower=ANGLE)
        problem.setup()
        try:
            problem.run_driver()
        except om.AnalysisError:
            region /= 2
            continue
        found = np.array([problem.get_val(key).item() for key in keys])
        gained = least - np.abs(moments.values([found])).max()
        region = region if gained > 1e-3 * least else region / 2
        best = found if gained > 0 else best
    return best


def by_pymoo():
    """Differential evolution near the published balance, a population of 60 at once."""
    from pymoo.algorithms.soo.nonconvex.de import DE
    from pymoo.optimize import minimize

    from lemnis.adapters.pymoo import CraneProblem

    problem = CraneProblem(design(region=0.1), ["dM_max"], {"gamma_min": (float(ANGLE), None)})
    return minimize(problem, DE(pop_size=60), ("n_gen", 150), seed=1).X


def by_optuna():
    """The tree-structured Parzen estimator near the published balance, in batches of 32."""
    import optuna

    from lemnis.adapters.optuna import search

    optuna.logging.set_verbosity(optuna.logging.WARNING)
    study = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=1))
    search(study, design(region=0.1), "dM_max", {"gamma_min": (float(ANGLE), None)}, 640)
    return list(study.best_trial.params.values())


def by_jax():
    """SLSQP of scipy with the gradients of JAX."""
    import jax
    from scipy.optimize import minimize

    from lemnis.adapters.jax import function

    jax.config.update("jax_enable_x64", True)
    problem = design()
    results, (low, high) = jax.jit(function(problem)), problem.bounds
    slopes = jax.jit(jax.jacfwd(function(problem)))
    point = lambda part: low + np.asarray(part) * (high - low)
    found = minimize(
        lambda part: float(results(point(part))[0, 0]) / 1e5, (problem.start - low) / (high - low),
        jac=lambda part: np.asarray(slopes(point(part))[0, 0]) * (high - low) / 1e5, method="SLSQP", bounds=[(0, 1)] * len(low),
        constraints={"type": "ineq", "fun": lambda part: float(results(point(part))[1, 0]) - ANGLE,
                     "jac": lambda part: np.asarray(slopes(point(part))[1, 0]) * (high - low)})
    return point(found.x)


def main(name):
    started = time.monotonic()
    found = {"openmdao": by_openmdao, "pymoo": by_pymoo, "optuna": by_optuna, "jax": by_jax}[name]()
    took = time.monotonic() - started
    problem = design()
    moment, angle = problem.values([found])[0, :, 0]
    print(f"{name}: |dM|max = {moment / 1e3:.4g} kN.m, gamma_min = {np.degrees(angle):.4g} deg in {took:.1f} s")
    print(f"the publication's balance, from which they begin: {problem.values([problem.start])[0, 0, 0] / 1e3:.4g} kN.m")
    started = time.monotonic()
    best = lemnis.Scene.read(SCENES / "portal_004_synthesis.toml").synth().scene.summary()["dM_max"].value
    print(f"lemnis synth: |dM|max = {abs(best) / 1e3:.4g} kN.m in {time.monotonic() - started:.1f} s")
    return moment, angle, abs(best)


if __name__ == "__main__":
    main(sys.argv[1])

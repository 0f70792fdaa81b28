"""Optimisers and clusters of others over the Python package: the same numbers, exact derivatives, and how far they come."""

import importlib.util
import threading

import lemnis
import numpy as np
import openmdao.api as om
import optuna
import pytest
from conftest import ROOT
from distributed import Client, LocalCluster
from lemnis.adapters import Design
from lemnis.adapters.openmdao import Crane, MatrixFreeCrane, plain
from lemnis.adapters.optuna import search
from lemnis.adapters.pymoo import BAD, CraneProblem

SCENES = ROOT / "models/scenes"


@pytest.fixture(scope="module")
def example():
    found = importlib.util.spec_from_file_location("balance", ROOT / "python/examples/balance.py")
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def least():
    """What `lemnis synth` finds, in N.m."""
    return lemnis.Scene.read(SCENES / "portal_004_synthesis.toml").synth().scene.summary()["dM_max"].value


def published(design):
    return float(design.values([design.start])[0, 0, 0])


@pytest.fixture(scope="module")
def moments(example):
    return example.design(("dM", "gamma"), {"theta_1": np.radians([44.0, 60.0, 82.0])})


def test_values_are_those_of_the_scene(moments):
    table = moments.scene.evaluate(theta_1=moments.at["theta_1"], outputs=["dM", "gamma"])
    found = moments.values([moments.start, moments.start])
    assert found.shape == (2, 2, 3)
    for row in found:
        assert row[0].tobytes() == table["dM"].tobytes() and row[1].tobytes() == table["gamma"].tobytes()


def test_slopes_are_those_of_differences(moments):
    """Each by a quotient of its own size of step, which leaves some 1e-9 of the greatest."""
    exact = moments.slopes(moments.start)
    assert exact.shape == (2, 3, 6)
    for place, value in enumerate(moments.start):
        step = 1e-5 * abs(value)
        ends = [moments.values([moments.start + sign * step * (np.arange(6) == place)])[0] for sign in (-1, 1)]
        wanted = (ends[1] - ends[0]) / (2 * step)
        assert np.allclose(exact[:, :, place], wanted, rtol=1e-6, atol=1e-6 * np.abs(wanted).max())


@pytest.mark.parametrize("component", [Crane, MatrixFreeCrane])
def test_openmdao_takes_exact_partials(moments, component):
    problem = om.Problem(reports=None)
    problem.model.add_subsystem("crane", component(design=moments), promotes=["*"])
    problem.setup(force_alloc_complex=False)
    problem.run_model()
    assert problem.get_val("dM").tobytes() == moments.values([moments.start])[0, 0].tobytes()
    checked = problem.check_partials(out_stream=None, method="fd", form="central", step_calc="rel_avg", step=1e-5)["crane"]
    slopes = moments.slopes(moments.start)
    assert len(checked) == 12
    for (of, by), found in checked.items():
        wanted = slopes[["dM", "gamma"].index(of), :, [plain(key) for key in moments.vary].index(by)]
        for way in ("J_fwd", "J_rev"):
            if way in found:
                assert np.allclose(np.ravel(found[way]), wanted, rtol=1e-14, atol=0.0), (of, by, way)
        assert np.allclose(np.ravel(found["J_fd"]), wanted, rtol=1e-5, atol=1e-5 * np.abs(wanted).max()), (of, by)


def test_openmdao_steps_back_from_what_cannot_be(example):
    design = example.design(("dM_max",))
    problem = om.Problem(reports=None)
    problem.model.add_subsystem("crane", Crane(design=design), promotes=["*"])
    problem.setup()
    problem.set_val("luffing:balance:l_1", 1.0)
    with pytest.raises(om.AnalysisError, match="no such design"):
        problem.run_model()


def test_openmdao_comes_as_far_as_the_search(example, least):
    """To the optimum of the same bounds, but for what lies between its positions of half a degree."""
    design = example.design()
    moment, angle = design.values([example.by_openmdao()])[0, :, 0]
    assert least * (1 - 1e-9) <= moment <= 1.01 * least and angle >= example.ANGLE - 1e-6


def test_pymoo_has_a_population_at_once(example, least):
    design = example.design()
    problem = CraneProblem(design, ["dM_max"], {"gamma_min": (float(example.ANGLE), None)})
    impossible = np.where(np.arange(6) == 2, 1.0, design.start)
    out = problem.evaluate(np.array([design.start, impossible]), return_as_dictionary=True)
    assert out["F"][0, 0] == published(design) and out["F"][1, 0] == BAD
    assert (out["G"][0] <= 0).all() and (out["G"][1] > 0).all()
    moment, angle = design.values([example.by_pymoo()])[0, :, 0]
    assert least <= moment < published(design) and angle >= example.ANGLE


def test_optuna_is_asked_and_told(example, least):
    design = example.design()
    moment, angle = design.values([example.by_optuna()])[0, :, 0]
    assert least <= moment <= published(design) and angle >= example.ANGLE
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    study = optuna.create_study(sampler=optuna.samplers.RandomSampler(seed=1))
    wide = Design(design.scene, {"luffing.balance.l_1": (1.0, 20.0)}, ["dM_max", "gamma_min"])
    search(study, wide, "dM_max", {"gamma_min": (float(example.ANGLE), None)}, 40, batch=16)
    assert study.trials[0].value == published(design) and len(study.trials) == 40
    exists = [not np.isnan(wide.values([[trial.params["luffing.balance.l_1"]]])).any() for trial in study.trials]
    assert exists == [trial.state == optuna.trial.TrialState.COMPLETE for trial in study.trials] and not all(exists)


def test_dask_loses_a_worker_and_no_bit(monkeypatch):
    """Two processes, of which one is killed while rows are computed: the rows are those of one thread here."""
    monkeypatch.setattr("lemnis.study.CHUNK", 8)
    scene = lemnis.Scene.read(SCENES / "portal_004_study.toml")
    here = scene.monte_carlo(512, threads=1)
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster, Client(cluster) as client:
        killed = []

        def kill():
            nanny = next(iter(cluster.workers.values()))
            killed.append(nanny.worker_address)
            client.sync(nanny.kill)

        submit, count = client.submit, []

        def submitted(*task):
            count.append(task)
            if len(count) == 32:
                threading.Timer(0.1, kill).start()
            return submit(*task)

        monkeypatch.setattr(client, "submit", submitted)
        there = scene.monte_carlo(512, executor=client)
    assert killed and len(count) == 64
    assert all(here[name].tobytes() == there[name].tobytes() for name in here) and here.faults == there.faults
    assert all(np.array_equal(here.fails[name], there.fails[name]) for name in here.fails)

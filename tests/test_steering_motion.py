"""Groups turned by their cylinders under the PLC, as FMUs: Model Exchange beside Co-Simulation in both standards, the
PLC's samples as time events, roll-back, two instances in two threads, refusals."""

import csv
import ctypes
import math
import threading
import zipfile

import numpy as np
import pytest
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Model, fmi2EventInfo
from fmpy.fmi3 import FMU3Model
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis
from test_fmpy import Slave

SCENE = ROOT / "models/scenes/boat_hoist_003_hydraulic.toml"
NAMES = ["theta[1]", "theta[5]", "e[8]", "omega_g[3]", "p_A[1]", "p_B[8]", "f_c[2]", "Q_P", "v[7]", "R[4]", "od[6]", "q_g[1]"]
CYCLE = 0.02


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("steering")
    lemnis("fmu", SCENE, "--output", folder)
    return folder


@pytest.fixture(scope="module", params=["BoatHoistHydraulic.fmu", "BoatHoistHydraulic.fmi2.fmu"],
                ids=["FMI 3.0", "FMI 2.0"])
def path(request, folder):
    return str(folder / request.param)


@pytest.fixture
def slave(path, tmp_path):
    return Slave(path, str(tmp_path / "fmu"))


def test_fmpy_finds_nothing_wrong(path):
    assert validate_fmu(path) == []
    description = read_model_description(path)
    assert (description.numberOfContinuousStates, description.numberOfEventIndicators) == (64, 50)
    # The rate of one of several is written as the standard has it.
    rates = {v.name: v.derivative.name for v in description.modelVariables if v.derivative is not None}
    assert rates["der(theta[3])"] == "theta[3]" and len(rates) == 64


@pytest.mark.parametrize("interface", ["CoSimulation", "ModelExchange"])
def test_the_default_experiment(path, interface):
    """The groups follow a command that runs through its range by itself."""
    result = simulate_fmu(path, fmi_type=interface, output=["theta[1]", "theta_w[1]", "e[1]", "e[5]"])
    assert result["time"][-1] == 15.0
    assert abs(result["theta[1]"][0] - math.radians(-10)) < 1e-12
    assert abs(result["theta[1]"][-1] - math.radians(20)) < math.radians(0.1)
    assert np.abs(result["e[1]"]).max() < math.radians(0.5) and np.abs(result["e[5]"]).max() < math.radians(0.7)


def signals():
    times = np.array([0.0, 1.0, 1.0, 2.5, 2.5, 4.0, 4.0, 6.0])
    rows = np.zeros(len(times), dtype=[("time", float), ("theta_b", float), ("G[3]", float)])
    rows["time"] = times
    rows["theta_b"] = [0.0, 0.0, 0.3, 0.3, 0.3, 0.3, -0.2, -0.2]
    rows["G[3]"] = [1e6, 1e6, 1e6, 1e6, 1.4e6, 1.4e6, 1.4e6, 1.4e6]
    return rows


@pytest.mark.parametrize("moved", [False, True], ids=["by itself", "by signals"])
def test_model_exchange_agrees_with_co_simulation(path, moved):
    """CVode over the FMU's rates, with its samples and kinks as events, against the solver inside doStep."""
    arguments = {"stop_time": 6.0, "output": NAMES, "input": signals() if moved else None}
    inside = simulate_fmu(path, fmi_type="CoSimulation", output_interval=CYCLE, **arguments)
    outside = simulate_fmu(path, fmi_type="ModelExchange", relative_tolerance=1e-8, output_interval=CYCLE, **arguments)
    # The first of several rows for one time is the one before its event, as after a step.
    rows = {}
    for i, t in enumerate(outside["time"]):
        rows.setdefault(round(t, 6), i)
    common = [(i, rows[round(t, 6)]) for i, t in enumerate(inside["time"]) if round(t, 6) in rows]
    assert len(common) == 301
    turned = inside["theta[5]"].max() - inside["theta[5]"].min()
    assert turned > 0.15, "the groups turn"
    for column in NAMES:
        # Ten times the tolerance of the solver inside, of the greatest amount. A result jumps with its input.
        jumps = (1.0, 2.5, 4.0) if moved else ()
        worst = max(abs(inside[column][i] - outside[column][j]) for i, j in common if inside["time"][i] not in jumps)
        size = abs(outside[column]).max()
        print(f"{column}: {worst / size:.1e}")
        assert worst <= 1e-4 * size, column


def test_samples_are_time_events(folder):
    """Both standards tell the next sample beforehand; the valve's command changes there and nowhere else."""
    seen = []
    for end, kind in ((".fmi2.fmu", FMU2Model), (".fmu", FMU3Model)):
        path = str(folder / ("BoatHoistHydraulic" + end))
        description = read_model_description(path)
        references = {v.name: v.valueReference for v in description.modelVariables}
        fmu = kind(guid=description.guid, unzipDirectory=extract(path),
                   modelIdentifier=description.modelExchange.modelIdentifier, instanceName="x")
        fmu.instantiate()

        def get(name):
            return (fmu.getReal if kind is FMU2Model else fmu.getFloat64)([references[name]])[0]

        def set_(name, value):
            (fmu.setReal if kind is FMU2Model else fmu.setFloat64)([references[name]], [value])

        def update():
            if kind is FMU2Model:
                info = fmi2EventInfo()
                fmu.fmi2NewDiscreteStates(fmu.component, ctypes.byref(info))
                assert not info.valuesOfContinuousStatesChanged and not info.newDiscreteStatesNeeded
                return bool(info.nextEventTimeDefined), info.nextEventTime
            needed, _, _, changed, defined, time = fmu.updateDiscreteStates()
            assert not needed and not changed
            return bool(defined), time

        if kind is FMU2Model:
            fmu.setupExperiment(startTime=0.0)
            fmu.enterInitializationMode()
        else:
            fmu.enterInitializationMode(startTime=0.0)
        set_("theta_b", 0.1)
        fmu.exitInitializationMode()
        assert get("u_v[1]") == 0.0
        times = [update()]
        commands = [get("u_v[1]")]
        for k in range(1, 5):
            set_("theta_b", 0.1 + 0.01 * k)
            fmu.enterContinuousTimeMode()
            fmu.setTime((k - 0.5) * CYCLE)
            assert get("u_v[1]") == commands[-1]
            fmu.setTime(times[-1][1])
            fmu.enterEventMode()
            times.append(update())
            commands.append(get("u_v[1]"))
        assert times == [(True, (k + 1) * CYCLE) for k in range(5)]
        assert commands[0] == 1.0, "far away: at its limit"
        fmu.terminate()
        fmu.freeInstance()
        seen.append(commands)
    assert seen[0] == seen[1]


def run(slave, first, last):
    rows = []
    for i in range(first, last):
        slave.write("theta_b", 0.2 * math.sin(0.3 * i))
        slave.step(0.013 * i, 0.013)
        rows.append([slave.read(name) for name in NAMES])
    return np.array(rows).tobytes()


def test_a_roll_back_gives_the_same_bits(slave):
    run(slave, 0, 40)
    fmu = slave.fmu
    three = hasattr(fmu, "getFMUState")
    get, put = (fmu.getFMUState, fmu.setFMUState) if three else (fmu.getFMUstate, fmu.setFMUstate)
    state = get()
    data = fmu.serializeFMUState(state) if three else fmu.serializeFMUstate(state)
    first = run(slave, 40, 90)
    put(state)
    assert run(slave, 40, 90) == first
    put(state)
    slave.write("p_P", 2e7)
    assert run(slave, 40, 90) != first, "the input acts"
    put(fmu.deserializeFMUState(data) if three else fmu.deSerializeFMUstate(data))
    assert run(slave, 40, 90) == first


def test_both_standards_and_two_threads_give_the_same_bits(folder, tmp_path):
    ends = [".fmu", ".fmi2.fmu"]
    of = lambda end: Slave(str(folder / ("BoatHoistHydraulic" + end)), str(tmp_path / end))
    alone = [run(of(end), 0, 80) for end in ends]
    assert alone[0] == alone[1]
    slaves = [of(ends[0]), of(ends[0])]
    together = [None, None]

    def work(i):
        together[i] = run(slaves[i], 0, 80)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert together == alone


def test_what_is_not_possible_is_refused_and_the_instance_goes_on(slave):
    run(slave, 0, 10)
    for name, value in (("p_P", math.nan), ("p_P", -1.0), ("G[3]", math.inf), ("theta_b", 4.0)):
        with pytest.raises(FMICallException):
            slave.write(name, value)
    # A step of a year has more samples than one call may take.
    with pytest.raises(FMICallException):
        slave.step(0.13, 3.2e7)
    slave.step(0.13, 0.013)
    assert math.isfinite(slave.read("theta[1]"))


# Cases of the reference with 200 digits, with states as in `models/tests/steering_derivatives.rs`.
DERIVATIVES = {
    "lengthening": (1, {"theta": 0.2, "omega_g": 0.03, "x_v": 0.3, "v_v": 5.0, "p_1": 120e5, "p_2": 25e5, "p_A": 90e5, "p_B": 60e5}),
    "shortening": (6, {"theta": -0.4, "omega_g": -0.02, "x_v": -0.6, "v_v": -20.0, "p_1": 340e5, "p_2": 350e5, "p_A": 290e5, "p_B": 190e5}),
}


@pytest.mark.parametrize("case", DERIVATIVES)
def test_derivatives_are_those_of_the_reference(path, case, tmp_path):
    """In Model Exchange, rates, results and event indicators of a group by its states, its load and the pump's pressure;
    nothing by another group's; adjoint derivatives are the transpose; what is searched for has none."""
    fmi3 = path.endswith("Hydraulic.fmu")
    with zipfile.ZipFile(path) as archive:
        text = archive.read("modelDescription.xml").decode("utf-8")
    for attribute in ("providesDirectionalDerivatives", "providesAdjointDerivatives") if fmi3 else ("providesDirectionalDerivative",):
        assert text.count(f'{attribute}="true"') == 2
    group, states = DERIVATIVES[case]
    description = read_model_description(path)
    reference = {v.name: v.valueReference for v in description.modelVariables}
    folder = str(tmp_path / "fmu")
    extract(path, unzipdir=folder)
    fmu = (FMU3Model if fmi3 else FMU2Model)(
        guid=description.instantiationToken if fmi3 else description.guid, unzipDirectory=folder,
        modelIdentifier=description.modelExchange.modelIdentifier, instanceName="test")
    fmu.instantiate()
    if not fmi3:
        fmu.setupExperiment(startTime=0.0)
    fmu.enterInitializationMode()
    of = lambda name: reference[name if name == "p_P" else f"der({name[4:-1]}[{group}])" if name.startswith("der(") else f"{name}[{group}]"]
    (fmu.setFloat64 if fmi3 else fmu.setReal)([of(n) for n in states], list(states.values()))
    fmu.exitInitializationMode()
    with open(ROOT / "tests/oracles/steering_derivatives.csv") as file:
        rows = {(row["unknown"], row["known"]): row for row in csv.DictReader(file) if row["case"] == case}
    unknowns = sorted({unknown for unknown, _ in rows if not unknown.startswith("z.") and unknown != "der(v_v)"})
    assert len(unknowns) == 16
    references = [of(n) for n in unknowns]
    values = dict(zip(unknowns, (fmu.getFloat64 if fmi3 else fmu.getReal)(references)))
    knowns = [*states, "G", "p_P"]
    columns = []
    for known in knowns:
        found = fmu.getDirectionalDerivative(references, [of(known)], [1.0])
        columns.append(found)
        size = max(abs(states.get(known, 1e6)), 0.1)
        for unknown, derivative in zip(unknowns, found, strict=True):
            expected = float(rows[unknown, known]["derivative"]) if (unknown, known) in rows else 0.0
            assert abs(derivative - expected) <= 1e-12 * max(abs(expected), abs(values[unknown]) / size), (unknown, known)
    assert fmu.getDirectionalDerivative(references, [reference["p_A[2]"]], [1.0]) == [0.0] * len(unknowns)
    # What is searched for does not change with a group's own states.
    searched = [of("theta_w"), reference["theta_b_n"], of("e")]
    assert fmu.getDirectionalDerivative(searched, [of("theta")], [1.0]) == [0.0, 0.0, -1.0]
    with pytest.raises(FMICallException):
        fmu.getDirectionalDerivative([of("theta_w")], [reference["theta_b"]], [1.0])
    if fmi3:
        seed = [1.0 / (1.0 + i) for i in range(len(unknowns))]
        adjoint = fmu.getAdjointDerivative(references, [of(n) for n in knowns], seed, len(knowns))
        for found, column in zip(adjoint, columns, strict=True):
            parts = [w * d for w, d in zip(seed, column, strict=True)]
            assert abs(found - sum(parts)) <= 1e-15 * sum(abs(p) for p in parts)
    fmu.terminate()
    fmu.freeInstance()

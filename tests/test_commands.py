"""Commands over time: closed forms, the same bits for every communication step, events at every break, both standards and
both interfaces, exact derivatives, a saved state on the way."""

import ctypes
import re
import shutil

import numpy as np
import pytest
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis
from test_levels import scene

ENDS = {"FMI 2": ".fmi2.fmu", "FMI 3": ".fmu"}
CYCLE = ROOT / "models/scenes/slewing_cycle.toml"

# Slewing without friction, load or slope: the angular velocity is the integral of the moment over the inertia.
J = 4.0e6
FREE = """name  = "{name}"
title = "Slewing without friction"

[slewing]
fidelity = "rigid"
R     = "20 m"
Q     = "0 kN"
J_sl  = "4000000 kg.m2"
{commands}

[slewing.motion]
from  = "-60 deg"
to    = "120 deg"
step  = "5 deg"
speed = "9 deg/s"
"""
ROWS = [(0.5, 0.0), (2.5, 300e3), (7.25, 300e3), (8.0, -500e3), (11.0, 0.0)]


def course(rows, between, unit="kN.m", factor=1e3):
    over = ", ".join(f'["{t!r} s", "{v / factor!r} {unit}"]' for t, v in rows)
    return f'{{ over = [{over}], between = "{between}" }}'


def integrals(rows, between, time):
    """First and second integral of a course from zero on, piece by piece."""
    first = second = 0.0
    pieces = [(0.0, rows[0][1]), *rows, (max(time, rows[-1][0]) + 1.0, rows[-1][1])]
    for (a, value), (b, following) in zip(pieces, pieces[1:]):
        h = min(time, b) - a
        if h <= 0.0:
            break
        slope = (following - value) / (b - a) if between == "linear" and b > a else 0.0
        second += first * h + value * h * h / 2 + slope * h ** 3 / 6
        first += value * h + slope * h * h / 2
    return first, second


def written(folder, name, text):
    path = folder / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    lemnis("fmu", path, "--output", folder)
    return {standard: str(folder / f"{name}{end}") for standard, end in ENDS.items()}


@pytest.fixture(scope="module")
def free(tmp_path_factory):
    folder = tmp_path_factory.mktemp("free")
    return {between: written(folder, f"Free{between.title()}", FREE.format(
        name=f"Free{between.title()}", commands=f"M_sl = {course(ROWS, between)}")) for between in ("linear", "steps")}


@pytest.fixture(scope="module")
def cycle(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cycle")
    lemnis("fmu", CYCLE, "--output", folder)
    return {standard: str(folder / f"SlewingCycle{end}") for standard, end in ENDS.items()}


class Stepped:
    """An FMU in Co-Simulation, stepped from communication point to communication point."""

    def __init__(self, path):
        self.folder = extract(path)
        self.description = read_model_description(path)
        self.references = {v.name: v.valueReference for v in self.description.modelVariables}
        of = FMU2Slave if self.description.fmiVersion.startswith("2") else FMU3Slave
        self.slave = of(guid=self.description.guid, unzipDirectory=self.folder,
                        modelIdentifier=self.description.coSimulation.modelIdentifier, instanceName="one")
        self.slave.instantiate()
        if of is FMU2Slave:
            self.slave.setupExperiment(startTime=0.0)
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()

    def get(self, names):
        references = [self.references[name] for name in names]
        get = self.slave.getReal if isinstance(self.slave, FMU2Slave) else self.slave.getFloat64
        return list(get(references))

    def set(self, name, value):
        put = self.slave.setReal if isinstance(self.slave, FMU2Slave) else self.slave.setFloat64
        put([self.references[name]], [value])

    def run(self, times, names):
        """Values at the times; a step ends exactly at each."""
        rows = [self.get(names)]
        for a, b in zip(times, times[1:]):
            self.slave.doStep(currentCommunicationPoint=a, communicationStepSize=b - a)
            rows.append(self.get(names))
        return rows

    def again(self, times, names):
        """Values at the times, twice from the state at the first one: before and after it was put back."""
        of = "state" if isinstance(self.slave, FMU2Slave) else "State"
        get, put, free = (getattr(self.slave, f"{act}FMU{of}") for act in ("get", "set", "free"))
        state = get()
        once = self.run(times, names)
        put(state)
        again = self.run(times, names)
        free(state)
        return once, again

    def close(self):
        self.slave.terminate()
        self.slave.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)


@pytest.mark.parametrize("standard", ENDS)
def test_a_command_over_time_is_an_output_and_the_experiment_its_cycle(cycle, standard):
    assert not validate_fmu(cycle[standard])
    description = read_model_description(cycle[standard])
    variables = {variable.name: variable for variable in description.modelVariables}
    assert [variables[name].causality for name in ("M_sl", "M_Bsl", "psi_sl")] == ["output"] * 3
    assert [v for v in description.modelVariables if v.causality == "input"] == []
    assert description.defaultExperiment.stopTime == "80" or float(description.defaultExperiment.stopTime) == 80.0
    depends = {unknown.variable.name: [known.name for known in unknown.dependencies] for unknown in description.outputs}
    assert depends["M_sl"] == ["time"] and "M_sl" not in sum(depends.values(), [])
    fmu = Stepped(cycle[standard])
    with pytest.raises(Exception):
        fmu.set("M_sl", 1e3)
    fmu.close()


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("between", ["linear", "steps"])
def test_the_speed_is_the_integral_of_the_moment_over_the_inertia(free, standard, between):
    """In Co-Simulation to rounding, whatever the step; the moment is what the scene says, the new one from a break on."""
    times = [i * 37 / 100 for i in range(33)]
    fmu = Stepped(free[between][standard])
    rows = fmu.run(times, ["omega_sl", "psi_sl", "M_sl"])
    fmu.close()
    for time, (omega, psi, moment) in zip(times, rows):
        first, second = integrals(ROWS, between, time)
        assert abs(omega - first / J) <= 1e-14, (time, omega, first / J)
        assert abs(psi - second / J) <= 1e-13
        held = [v for t, v in [(-1.0, ROWS[0][1]), *ROWS] if t <= time][-1]
        wanted = held if between == "steps" else float(np.interp(time, *zip(*ROWS)))
        assert abs(moment - wanted) <= 1e-9 * 500e3


def exchanged(path):
    """An FMU 3 for Model Exchange, initialised, and the references of its variables."""
    description = read_model_description(path)
    fmu = FMU3Model(guid=description.guid, unzipDirectory=extract(path), instanceName="one",
                    modelIdentifier=description.modelExchange.modelIdentifier)
    fmu.instantiate()
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    return fmu, {v.name: v.valueReference for v in description.modelVariables}


def as_told(path, states, names, inputs=()):
    """What an FMU 3 has in Model Exchange at states, after inputs: rates of the states, and results by their names."""
    fmu, references = exchanged(path)
    for name, value in dict(inputs).items():
        fmu.setFloat64([references[name]], [value])
    fmu.updateDiscreteStates()
    fmu.enterContinuousTimeMode()
    kind = ctypes.c_double * len(states)
    fmu.setContinuousStates(kind(*states), len(states))
    rates = kind()
    fmu.getContinuousStateDerivatives(rates, len(states))
    found = dict(zip(names, fmu.getFloat64([references[name] for name in names])))
    fmu.terminate()
    fmu.freeInstance()
    return list(rates), found


def same_bits(path, last, common):
    """The outputs up to a time (s/100), with communication steps of 10 ms, 50 ms and 0.37 s, equal at their common times."""
    names = [v.name for v in read_model_description(path).modelVariables
             if v.causality == "output" and v.type in ("Real", "Float64") and not v.dimensions]
    found = {}
    for step in (1, 5, 37):
        times = range(0, last + 1, step)
        fmu = Stepped(path)
        found[step] = dict(zip(times, fmu.run([time / 100 for time in times], names)))
        fmu.close()
    at = sorted(found[1].keys() & found[5].keys() & found[37].keys())
    assert len(at) == common and len(names) > 10
    for time in at:
        assert found[1][time] == found[5][time] == found[37][time], time
    return found[1]


@pytest.mark.parametrize("standard", ENDS)
def test_any_communication_step_gives_the_same_bits(cycle, standard):
    found = same_bits(cycle[standard], 6000, 33)
    assert found[6000] != found[0]


@pytest.mark.parametrize("standard", ENDS)
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_fmpy_runs_the_cycle(cycle, standard, kind):
    """Model Exchange by another solver agrees with Co-Simulation; at the end the crane is back and held."""
    names = ["psi_sl", "omega_sl", "M_sl", "M_Bsl", "S_R"]
    run = simulate_fmu(cycle[standard], fmi_type=kind, output_interval=0.5, relative_tolerance=1e-9, output=names,
                       record_events=False)
    assert run["time"][-1] == 80.0
    fmu = Stepped(cycle["FMI 3"])
    rows = np.array(fmu.run([i / 2 for i in range(161)], names))
    fmu.close()
    assert np.abs(rows[:, 0]).max() > 0.4 and rows[-1, 1] == 0.0
    for i, (name, near) in enumerate(zip(names[:2], (2e-7, 2e-7))):
        assert np.abs(run[name] - rows[:, i]).max() <= (0.0 if kind == "CoSimulation" else near), name


def test_every_break_is_a_time_event(free):
    """One each, where the scene has it, and nothing is known beforehand after the last."""
    for standard, path in free["steps"].items():
        folder = extract(path)
        description = read_model_description(path)
        two = standard == "FMI 2"
        model = (FMU2Model if two else FMU3Model)(
            guid=description.guid, unzipDirectory=folder, instanceName="one",
            modelIdentifier=description.modelExchange.modelIdentifier)
        reference = {v.name: v.valueReference for v in description.modelVariables}["M_sl"]
        model.instantiate()
        if two:
            model.setupExperiment(startTime=0.0)
        model.enterInitializationMode()
        model.exitInitializationMode()
        found = []

        update = model.newDiscreteStates if two else model.updateDiscreteStates

        def read():
            return (model.getReal if two else model.getFloat64)([reference])[0]

        told = update()
        while told[4]:
            due = told[5]
            model.enterContinuousTimeMode()
            model.setTime(due)
            before = read()
            model.enterEventMode()
            told = update()
            found.append((due, before, read()))
        values = [ROWS[0][1]] + [value for _, value in ROWS]
        assert found == [(time, values[i], values[i + 1]) for i, (time, _) in enumerate(ROWS)], standard
        model.terminate()
        model.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)


def test_derivatives_by_the_time_are_the_slopes(free):
    """∂M_sl/∂t is the slope of its piece, ∂(der(omega_sl))/∂t that over the inertia."""
    path = free["linear"]["FMI 3"]
    fmu = Stepped(path)
    names = {v.name: v.valueReference for v in fmu.description.modelVariables}
    pieces = [(1.0, 300e3 / 2.0), (5.0, 0.0), (7.5, -800e3 / 0.75), (9.0, 500e3 / 3.0), (12.0, 0.0)]
    now = 0.0
    for time, slope in pieces:
        fmu.slave.doStep(currentCommunicationPoint=now, communicationStepSize=time - now)
        now = time
        found = fmu.slave.getDirectionalDerivative([names["M_sl"], names["der(omega_sl)"]], [names["time"]], [1.0])
        assert list(found) == pytest.approx([slope, slope / J], rel=1e-15, abs=0.0), time
    fmu.close()


def test_a_saved_state_goes_on_in_the_same_bits(cycle):
    """Saved between two times of the solver's grid, as bytes too."""
    names = ["psi_sl", "omega_sl", "x_Q", "z_Q", "S_R", "M_sl"]
    times = [i * 37 / 100 for i in range(150)]
    fmu = Stepped(cycle["FMI 3"])
    through = fmu.run(times, names)
    fmu.close()
    fmu = Stepped(cycle["FMI 3"])
    fmu.run(times[:40], names)
    state = fmu.slave.getFMUState()
    saved = fmu.slave.serializeFMUState(state)
    fmu.run(times[39:80], names)
    fmu.slave.setFMUState(state)
    assert fmu.run(times[39:], names)[1:] == through[40:]
    other = Stepped(cycle["FMI 3"])
    other.slave.setFMUState(other.slave.deserializeFMUState(saved))
    assert other.run(times[39:], names)[1:] == through[40:]
    fmu.close()
    other.close()


LUFFING = {"M_A": ([(0.0, 3.6e6), (1.0, 3.9e6), (3.5, 4.0e6), (5.5, 3.8e6), (10.0, 3.8e6)], "linear", "kN.m", 1e3),
           "M_S": ([(0.0, 6e6), (1.5, 0.0), (4.5, 6e6)], "steps", "kN.m", 1e3),
           "v_h": ([(0.0, 0.0), (2.0, -0.1), (6.0, 0.0)], "steps", "m/s", 1.0)}


def luffing(folder, commanded):
    """A boom on a luffing rope with its load on another: the brake lifts and falls, the drive's moment goes up and down,
    the hoist lifts; told over time, or as inputs that start there."""
    text = (ROOT / "models/scenes/rope_motion.toml").read_text(encoding="utf-8")
    name = "Told" if commanded else "Open"
    text = re.sub(r'(?m)^name +=.*$', f'name = "{name}"', text)
    told = {key: course(*how) if commanded else f'"{how[0][0][1] / how[3]!r} {how[2]}"' for key, how in LUFFING.items()}
    text = re.sub(r'(?m)^M_S = .*$', f'M_A = {told["M_A"]}\nM_S = {told["M_S"]}', text)
    text = re.sub(r'(?m)^v_h = .*$', f'v_h = {told["v_h"]}', text)
    return written(folder, name, text)


def test_a_luffing_crane_follows_its_commands(tmp_path):
    """Against the same crane with inputs, which are set every millisecond: steps where they are, straight pieces at their
    middle, of second order."""
    told, free = luffing(tmp_path, True), luffing(tmp_path, False)
    names, rows = ["phi", "phi_R", "l_R", "S_R"], []
    fmu = Stepped(free["FMI 3"])
    for i in range(10_000):
        if i % 250 == 0:
            rows.append(fmu.get(names))
        for name, (values, between, *_) in LUFFING.items():
            held = [v for t, v in values if t <= i / 1000 + 1e-9][-1]
            fmu.set(name, held if between == "steps" else float(np.interp((i + 0.5) / 1000, *zip(*values))))
        fmu.slave.doStep(currentCommunicationPoint=i / 1000, communicationStepSize=1e-3)
    rows = np.array([*rows, fmu.get(names)])
    fmu.close()
    moved = np.abs(rows - rows[0]).max(axis=0)
    assert 0.02 < moved[0] < 0.5 and moved[2] > 0.2, moved
    for standard, path in told.items():
        assert not validate_fmu(path)
        for kind in ("CoSimulation", "ModelExchange"):
            run = simulate_fmu(path, fmi_type=kind, output_interval=0.25, relative_tolerance=1e-9, output=names,
                               record_events=False)
            assert run["time"][-1] == 10.0
            # Forces jump where a brake falls: there the reference has what was before.
            smooth = ~np.isin(run["time"], [time for values, *_ in LUFFING.values() for time, _ in values])
            # In Model Exchange the solver has 1e-9 of 12 m in each of its steps.
            rope = 1e-7 if kind == "CoSimulation" else 1e-6
            for i, (name, near) in enumerate(zip(names, (5e-7, 5e-6, rope, 20.0))):
                assert np.abs(run[name] - rows[:, i])[smooth].max() <= near, (standard, kind, name)


@pytest.mark.parametrize("kind", ["rope", "oil"])
def test_cranes_give_the_same_bits_for_any_communication_step(tmp_path, kind):
    """Explicit steps, and the solver of oil, which runs ahead; with oil a valve and a slewing moment in steps."""
    if kind == "rope":
        path = luffing(tmp_path, True)["FMI 3"]
    else:
        valve = course([(0.0, 0.0), (0.4, 0.6), (2.0, -0.2), (3.0, 0.0)], "steps", "1", 1.0)
        moment = course([(0.1, 0.0), (0.7, 300e3), (2.3, 0.0)], "steps")
        text = re.sub(r'(?m)^u_v +=.*$', "", scene("hydraulic_slewing"))
        text = text.replace("[luffing.hydraulics]\n", f"[luffing.hydraulics]\nu_v = {valve}\n")
        text = re.sub(r'(?m)^M_sl +=.*$', "", text).replace("[luffing.slewing]\n", f"[luffing.slewing]\nM_sl = {moment}\n")
        path = written(tmp_path, "Crane_hydraulic_slewing", text)["FMI 3"]
    same_bits(path, 370, 3)

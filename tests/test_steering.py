"""The steering as a set-point generator, through FMPy, against rigid bodies in the complex plane.

The plane is the complex plane: a machine with angular velocity omega, whose middle M moves with v_M, has the velocity
v(z) = v_M + i omega (z - M). Nothing of Lemnis is used for it but the outputs v_M and omega.
"""

import cmath
import ctypes
import math
import random

import numpy as np
import pytest
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis

MODES = ["straight", "crab", "crosswise", "front_axle", "rear_axle", "all_wheel", "pivot", "corner", "free"]
HOIST = (ROOT / "models/scenes/boat_hoist_003.toml").read_text(encoding="utf-8")
CAR = (ROOT / "models/scenes/car_4x2.toml").read_text(encoding="utf-8")


def scatter(count, seed):
    """A scene of groups at random places."""
    numbers = random.Random(seed)
    groups = "".join(
        f'[[steering.groups]]\nx = "{numbers.uniform(-20, 20):.6f} m"\ny = "{numbers.uniform(-10, 10):.6f} m"\n'
        for _ in range(count))
    return f'''name = "Scatter{count}"
title = "{count} groups"
[steering]
mode = "pivot"
{groups}
[steering.range]
min = "-100 deg"
max = "100 deg"
[steering.motion]
from = "-30 deg"
to = "30 deg"
step = "5 deg"
speed = "1 deg/s"
v_t = "1 m/s"
'''


SCENES = {"BoatHoist": HOIST, "Car": CAR, "Scatter4": scatter(4, 1), "Scatter64": scatter(64, 2)}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("steering")
    for name, text in SCENES.items():
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")
        lemnis("fmu", folder / f"{name}.toml", "--output", folder)
    return folder


class Machine:
    """An instance of either standard and interface, by the names of its variables."""

    def __init__(self, path, exchange=False, events=False):
        description = read_model_description(str(path))
        self.fmi3 = description.fmiVersion.startswith("3")
        self.variables = {v.name: v for v in description.modelVariables}
        unzipped = path.with_suffix(".unzipped")
        if not unzipped.exists():
            extract(str(path), unzipdir=str(unzipped))
        kind = {(True, True): FMU3Model, (True, False): FMU3Slave, (False, True): FMU2Model, (False, False): FMU2Slave}
        interface = description.modelExchange if exchange else description.coSimulation
        self.fmu = kind[self.fmi3, exchange](
            guid=description.instantiationToken if self.fmi3 else description.guid,
            unzipDirectory=str(unzipped), modelIdentifier=interface.modelIdentifier, instanceName="test")
        if self.fmi3:
            self.fmu.instantiate(**({"eventModeUsed": True} if events else {}))
            self.fmu.enterInitializationMode(startTime=0.0)
        else:
            self.fmu.instantiate()
            self.fmu.setupExperiment(startTime=0.0)
            self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def set(self, name, value):
        variable = self.variables[name]
        if variable.type == "Enumeration":
            (self.fmu.setInt64 if self.fmi3 else self.fmu.setInteger)([variable.valueReference], [int(value)])
        else:
            (self.fmu.setFloat64 if self.fmi3 else self.fmu.setReal)([variable.valueReference], [value])

    def get(self, name):
        variable = self.variables[name]
        kind = {"Enumeration": "Int64" if self.fmi3 else "Integer", "Boolean": "Boolean"}
        kind = kind.get(variable.type, "Float64" if self.fmi3 else "Real")
        return getattr(self.fmu, f"get{kind}")([variable.valueReference])[0]

    def all(self, name):
        """The values of a numbered quantity."""
        names = []
        while f"{name}[{len(names) + 1}]" in self.variables:
            names.append(f"{name}[{len(names) + 1}]")
        return [self.get(name) for name in names]

    def free(self):
        self.fmu.terminate()
        self.fmu.freeInstance()


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
@pytest.mark.parametrize("name", SCENES)
def test_descriptions_are_valid(folder, name, suffix):
    assert validate_fmu(str(folder / f"{name}.{suffix}")) == []


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
@pytest.mark.parametrize("name", SCENES)
def test_every_wheel_rolls_along_its_heading(folder, name, suffix):
    machine = Machine(folder / f"{name}.{suffix}")
    groups = [complex(x, y) for x, y in zip(machine.all("x"), machine.all("y"), strict=True)]
    xs, ys = [z.real for z in groups], [z.imag for z in groups]
    middle = complex((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)
    size = max(abs(z - middle) for z in groups)
    lines = {"front_axle": min(xs), "rear_axle": max(xs), "all_wheel": middle.real}
    numbers = random.Random(7)
    compared = reached = 0
    for _ in range(300):
        mode = numbers.choice(MODES)
        by = numbers.choice([1, 2, 3])
        centre = complex(lines.get(mode, numbers.uniform(-30, 30)), numbers.uniform(-60, 60))
        speed, radius, angle = numbers.uniform(-2, 2), numbers.choice([-1, 1]) * numbers.uniform(1, 1e4), numbers.uniform(-1.4, 1.4)
        inputs = {"mode": 1 + MODES.index(mode), "command": by, "corner": numbers.randint(1, 4), "theta_b": angle,
                  "R_t": radius, "x_c": centre.real, "y_c": centre.imag, "v_t": speed}
        for key, value in inputs.items():
            machine.set(key, value)
        try:
            omega = machine.get("omega")
        except FMICallException:
            # The base group of front-axle or rear-axle steering stands on the line of centres: no angle commands there.
            assert by == 1 and mode in lines and lines[mode] in xs, inputs
            continue
        v_m = complex(machine.get("v_M.x"), machine.get("v_M.y"))
        angles, speeds = machine.all("theta"), machine.all("v")
        for z, theta, v in zip(groups, angles, speeds, strict=True):
            assert abs(v * cmath.exp(1j * theta) - (v_m + 1j * omega * (z - middle))) <= 1e-12 * max(1, abs(speed)), inputs
            compared += 1
        assert max(map(abs, speeds)) == pytest.approx(abs(speed), rel=1e-12)
        # The turning centre is where nothing moves; at infinity the machine does not turn.
        if machine.get("O.at_infinity"):
            assert abs(omega) * size <= 1e-12 * abs(speed) and math.isinf(machine.get("R_O"))
        else:
            at = complex(machine.get("O.x"), machine.get("O.y"))
            assert abs(v_m + 1j * omega * (at - middle)) <= 1e-12 * abs(speed) * max(1, abs(at - middle) / size), inputs
            assert machine.get("R_O") == pytest.approx(abs(at - middle), rel=1e-12)
            if mode == "free" or (by == 3 and mode in lines):
                assert abs(at - centre) <= 1e-12 * abs(centre)
            elif by == 2 and mode in lines:
                assert abs(at - complex(lines[mode], middle.imag + radius)) <= 1e-12 * abs(radius)
        # The flag says what the ranges say.
        margin = machine.get("margin")
        assert bool(machine.get("reachable")) == (margin >= -1e-12), inputs
        reached += margin >= 0
    machine.free()
    assert compared > 200 * len(groups) and reached > 0


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_cylinders_forces_and_flows(folder, suffix):
    """Triangle of the cylinder by complex numbers, resistance and force by the publication's formulas."""
    machine = Machine(folder / f"BoatHoist.{suffix}")
    given = {name: machine.get(name) for name in ["R_c", "alpha", "l_x", "l_A", "D_g", "d", "f_t", "p_t", "k_v", "mu_r", "L_max", "D_L"]}
    loads = machine.all("G")
    assert sum(loads) == pytest.approx(8336e3, rel=1e-12)
    arm = given["R_c"] * cmath.exp(1j * given["alpha"])
    straight = given["l_A"] + 1.5 * given["l_x"]
    foot = arm - 1j * straight * arm / abs(arm)
    omega_s = math.radians(1)
    machine.set("omega_s", omega_s)
    for degrees in [-26.0, -3.0, 0.0, 20.0, 50.0, 57.0]:
        machine.set("theta_b", math.radians(degrees))
        angles, total = machine.all("theta"), 0.0
        machine.set("theta_b", math.radians(degrees + 1e-3))
        later = machine.all("theta")
        machine.set("theta_b", math.radians(degrees))
        for i, theta in enumerate(angles):
            mirrored = i >= 4
            turn = cmath.exp(-1j * theta if mirrored else 1j * theta)
            rod = arm * turn - foot
            lever = (arm * turn / rod).imag * abs(rod) * (1 if mirrored else -1)
            number = f"[{i + 1}]"
            assert machine.get("R" + number) == pytest.approx(abs(rod), rel=1e-14)
            assert machine.get("od" + number) == pytest.approx(lever, rel=1e-12)
            resistance = given["f_t"] / 3 * math.sqrt(loads[i] ** 3 / given["p_t"])
            drag = given["mu_r"] / 2 * (4.4 * loads[i] * given["L_max"] + loads[i] * given["D_L"])
            assert machine.get("T_r" + number) == pytest.approx(resistance, rel=1e-14)
            assert machine.get("f_g" + number) == pytest.approx((resistance + drag) / abs(lever), rel=1e-12)
            assert machine.get("f_gx" + number) == pytest.approx((resistance / given["k_v"] + drag) / abs(lever), rel=1e-12)
            speed = machine.get("v_c" + number)
            difference = (later[i] - theta) / math.radians(1e-3) * omega_s * lever
            assert speed == pytest.approx(difference, rel=1e-3, abs=1e-7)
            area = math.pi / 4 * (given["D_g"] ** 2 - (given["d"] ** 2 if speed < 0 else 0))
            assert machine.get("q_g" + number) == pytest.approx(area * speed, rel=1e-12, abs=1e-18)
            total += abs(area * speed)
        assert machine.get("q_sum") == pytest.approx(total, rel=1e-12)
    machine.free()


def test_arrays_of_fmi_3_are_the_numbered_variables(folder):
    machine = Machine(folder / "BoatHoist.fmu")
    machine.set("theta_b", 0.3)
    for name in ["theta", "v", "R", "od", "f_g", "q_g"]:
        assert machine.variables[name].dimensions[0].start == 8
        array = machine.fmu.getFloat64([machine.variables[name].valueReference], nValues=8)
        assert list(array) == machine.all(name)
    machine.free()


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_mode_changes_are_events(folder, suffix):
    """In Model Exchange, and in FMI 3 with event mode, the mode changes at events only."""
    kinds = [dict(exchange=True)] + ([dict(events=True)] if suffix == "fmu" else [])
    for kind in kinds:
        machine = Machine(folder / f"BoatHoist.{suffix}", **kind)
        fmu, exchange = machine.fmu, "exchange" in kind
        machine.set("theta_b", 0.3)
        machine.set("mode", 2)
        assert machine.all("theta") == pytest.approx([0.3] * 8, rel=1e-15)
        leave, enter = (fmu.enterContinuousTimeMode, fmu.enterEventMode) if exchange else (fmu.enterStepMode, fmu.enterEventMode)
        if suffix == "fmu":
            fmu.updateDiscreteStates()
        else:
            fmu.newDiscreteStates()
        leave()
        with pytest.raises(FMICallException):
            machine.set("mode", 6)
        assert machine.get("mode") == 2
        enter()
        machine.set("mode", 6)
        assert machine.all("theta")[3] == pytest.approx(-0.3, rel=1e-12)
        machine.fmu.freeInstance()


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_the_reachable_flag_changes_at_state_events(folder, suffix):
    """The event indicator crosses zero where the first group leaves its range."""
    machine = Machine(folder / f"BoatHoist.{suffix}", exchange=True)
    description = read_model_description(str(folder / f"BoatHoist.{suffix}"))
    assert (len(description.eventIndicators) if machine.fmi3 else description.numberOfEventIndicators) == 1

    def indicator():
        values = (ctypes.c_double * 1)()
        machine.fmu.getEventIndicators(values, 1)
        return values[0]

    machine.set("theta_b", math.radians(50))
    machine.fmu.updateDiscreteStates() if machine.fmi3 else machine.fmu.newDiscreteStates()
    machine.fmu.enterContinuousTimeMode()
    assert indicator() > 0 and machine.get("reachable")
    machine.set("theta_b", math.radians(58))
    # Between events a discrete variable keeps its value.
    assert indicator() < 0 and machine.get("reachable")
    machine.fmu.enterEventMode()
    machine.fmu.updateDiscreteStates() if machine.fmi3 else machine.fmu.newDiscreteStates()
    machine.fmu.enterContinuousTimeMode()
    assert not machine.get("reachable")
    machine.fmu.freeInstance()


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
@pytest.mark.parametrize("interface", ["CoSimulation", "ModelExchange"])
def test_a_run_with_changes_of_mode(folder, suffix, interface):
    """As FMPy's users do it: inputs over time, among them the mode."""
    dtype = [("time", float), ("theta_b", float), ("mode", int)]
    inputs = np.array([(0, 0.2, 6), (5, 0.2, 6), (5, 0.2, 2), (10, 0.2, 2)], dtype=dtype)
    result = simulate_fmu(str(folder / f"BoatHoist.{suffix}"), fmi_type=interface, start_time=0, stop_time=10,
                          output_interval=1, input=inputs, output=["theta[1]", "theta[4]", "omega", "mode"])
    before, after = result[result["time"] < 4.5], result[result["time"] > 5.5]
    assert len(before) >= 4 and len(after) >= 4
    assert np.allclose(before["theta[4]"], -0.2, rtol=1e-12) and np.allclose(after["theta[4]"], 0.2, rtol=1e-12)
    assert np.all(after["omega"] == 0) and np.all(before["omega"] != 0)
    assert set(before["mode"]) == {6} and set(after["mode"]) == {2}


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_unknown_modes_are_refused(folder, suffix):
    machine = Machine(folder / f"BoatHoist.{suffix}")
    for value in [0, 10, -1]:
        with pytest.raises(FMICallException):
            machine.set("mode", value)
        assert machine.get("mode") == 6
    machine.free()

"""The steering as a set-point generator, through FMPy, against rigid bodies in the complex plane.

The plane is the complex plane: a machine with angular velocity omega, whose middle M moves with v_M, has the velocity
v(z) = v_M + i omega (z - M). Nothing of Lemnis is used for it but the outputs v_M and omega.
"""

import cmath
import ctypes
import math
import random
import zipfile
from xml.etree import ElementTree

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


# Groups 2 and 7 must not stand between 25 and 32 degrees, one way each.
BARRED = HOIST.replace('name  = "BoatHoist"', 'name  = "Barred"').replace('mode = "all_wheel" ', 'mode = "crab"      ')
for place, ends in [('x = "4 m"\ny = "6 m"\n', "25 deg, 32 deg"), ('x = "-4 m"\ny = "-6 m"\n', "-32 deg, -25 deg")]:
    assert BARRED.count(place) == 1
    BARRED = BARRED.replace(place, f'{place}forbidden = ["{ends}"]\n')
BARRED = BARRED.replace('from  = "-26.5 deg"', 'from  = "-20 deg"').replace('to    = "57 deg" ', 'to    = "20 deg" ')

SCENES = {"BoatHoist": HOIST, "Car": CAR, "Scatter4": scatter(4, 1), "Scatter64": scatter(64, 2), "Barred": BARRED}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("steering")
    for name, text in SCENES.items():
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")
        lemnis("fmu", folder / f"{name}.toml", "--output", folder)
    return folder


class Machine:
    """An instance of either standard and interface, by the names of its variables."""

    def __init__(self, path, exchange=False, events=False, **start):
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
        for name, value in start.items():
            self.set(name, value)
        self.fmu.exitInitializationMode()
        self.time = 0.0

    def step(self, size):
        self.fmu.doStep(currentCommunicationPoint=self.time, communicationStepSize=size)
        self.time += size

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
def test_terminals_name_existing_variables(folder, suffix):
    """The machine and each group; a group without a cylinder has no length."""
    for name, groups, members in [("BoatHoist", 8, 10), ("Car", 4, 3)]:
        with zipfile.ZipFile(folder / f"{name}.{suffix}") as archive:
            root = ElementTree.fromstring(archive.read("terminalsAndIcons/terminalsAndIcons.xml"))
        terminals = {at.get("name"): [m.get("variableName") for m in at] for at in root.find("Terminals")}
        assert list(terminals) == ["machine"] + [f"group_{i + 1}" for i in range(groups)]
        known = {v.name for v in read_model_description(str(folder / f"{name}.{suffix}")).modelVariables}
        for terminal, variables in terminals.items():
            assert len(variables) == (3 if terminal == "machine" else members) and set(variables) <= known
        assert terminals["group_2"][0] == "theta[2]"


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


class Linkage:
    """Triangles of the cylinders in the complex plane."""

    def __init__(self, machine):
        given = {name: machine.get(name) for name in ["R_c", "alpha", "l_x", "l_A"]}
        self.arm = given["R_c"] * cmath.exp(1j * given["alpha"])
        self.foot = self.arm - 1j * (given["l_A"] + 1.5 * given["l_x"]) * self.arm / abs(self.arm)

    def lengths(self, angles):
        """Of all groups, over any number of rows; the cylinders of groups 5 to 8 are mirrored."""
        turns = np.exp(1j * np.asarray(angles) * np.array([1] * 4 + [-1] * 4))
        return np.abs(self.arm * turns - self.foot)


def commands(mode):
    """Inputs of a mode that all groups of the hoist can follow."""
    return {"mode": 1 + MODES.index(mode), "theta_b": {"crab": 0.5, "rear_axle": 0.3}.get(mode, 0.6), "x_c": -2.0, "y_c": 17.0}


def astray(groups, angles):
    """How far the axle lines are from meeting: the rigid motion that fits the headings best, in the complex plane."""
    rows = [[-math.sin(a), math.cos(a), (z * cmath.exp(-1j * a)).real / 10] for z, a in zip(groups, angles, strict=True)]
    return np.linalg.svd(np.array(rows), compute_uv=False)[-1]


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
@pytest.mark.parametrize("start,end,stands", [
    ("straight", "all_wheel", False), ("crab", "all_wheel", False), ("front_axle", "crab", False), ("free", "rear_axle", False),
    ("straight", "pivot", True), ("pivot", "crab", True)])
def test_changes_of_mode(folder, suffix, start, end, stands):
    """Set points keep the cylinders' speed limit, take the time that an independent sum gives, and end where commanded."""
    machine = Machine(folder / f"BoatHoist.{suffix}", **commands(start))
    linkage, limit = Linkage(machine), machine.get("v_c_max")
    groups = [complex(x, y) for x, y in zip(machine.all("x"), machine.all("y"), strict=True)]
    first = machine.all("theta")
    assert machine.all("theta_s") == first and machine.get("t_left") == 0 and not machine.get("stand")
    machine.step(1.0)
    before = motion_of(machine, groups)
    for name, value in commands(end).items():
        machine.set(name, value)
    last, after = machine.all("theta"), motion_of(machine, groups)
    assert machine.all("theta_s") == first and bool(machine.get("stand")) == stands
    duration = machine.get("t_x")
    assert machine.get("t_left") == pytest.approx(duration, rel=1e-14) and duration > 1
    rows, steps = [machine.all("theta_s")], 2000
    for step in range(steps):
        machine.step(duration / steps)
        rows.append(machine.all("theta_s"))
        assert machine.get("t_left") == pytest.approx(duration * (1 - (step + 1) / steps), abs=1e-9)
        rolls = machine.all("v_s")
        if stands:
            assert rolls == ([0.0] * 8 if step < steps - 1 else rolls)
        else:
            # One rigid motion: all axle lines meet, and with it go the rolling speeds; the fastest has the travel speed.
            assert astray(groups, rows[-1]) <= 1e-12
            velocities = np.array(rolls) * np.exp(1j * np.array(rows[-1]))
            columns = np.array([[[1, 0, -z.imag], [0, 1, z.real]] for z in groups]).reshape(-1, 3)
            sides = np.column_stack([velocities.real, velocities.imag]).reshape(-1)
            assert np.abs(columns @ np.linalg.lstsq(columns, sides, rcond=None)[0] - sides).max() <= 1e-12
            assert max(map(abs, rolls)) == pytest.approx(abs(machine.get("v_t")), rel=1e-12)
    machine.step(1e-6)
    assert machine.all("theta_s") == last and machine.get("t_left") == 0
    assert machine.all("v_s") == pytest.approx(machine.all("v"), abs=1e-12)
    assert np.allclose(rows[-1], last, atol=1e-9, rtol=0)
    lengths = linkage.lengths(rows)
    speeds = np.abs(np.diff(lengths, axis=0)) / (duration / steps)
    assert speeds.max() <= limit * (1 + 1e-9)
    if stands:
        # Every cylinder evenly, all together, the governing one at the limit.
        assert duration == pytest.approx(np.abs(lengths[-1] - lengths[0]).max() / limit, rel=1e-12)
        assert np.allclose(np.diff(lengths, 2, axis=0), 0, atol=1e-12)
    else:
        # The motion turns along a great circle from the one to the other; at every place one cylinder may be at the limit.
        across = after - before * (before @ after)
        across /= np.linalg.norm(across)
        whole = math.acos(before @ after)
        middle, size = 0j, max(map(abs, groups))
        parts = np.linspace(0, whole, 20001)
        motions = np.outer(np.cos(parts), before) + np.outer(np.sin(parts), across)
        velocities = (motions[:, 0] + 1j * motions[:, 1])[:, None] + 1j * motions[:, 2:] / size * (np.array(groups) - middle)
        angles = np.unwrap(np.angle(velocities), axis=0)
        angles += first - angles[0]
        ideal = np.abs(np.diff(linkage.lengths(angles), axis=0)).max(axis=1).sum() / limit
        assert ideal <= duration <= 1.02 * ideal
        # The angles lie on that way.
        places = np.array([np.abs(angles - row).max(axis=1).min() for row in rows[::100]])
        assert places.max() <= 1e-3
    # Once there, set points follow the command.
    machine.set("theta_b", machine.get("theta_b") - 0.01)
    machine.step(400.0)
    assert machine.all("theta_s") == machine.all("theta")
    machine.free()


def motion_of(machine, groups):
    """The machine's motion at unit speed of its middle and size times angular velocity together."""
    size = max(abs(z) for z in groups)
    found = np.array([machine.get("v_M.x"), machine.get("v_M.y"), machine.get("omega") * size])
    return found / np.linalg.norm(found)


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_changes_interrupted_and_barred(folder, suffix):
    """At random moments to random modes: nothing jumps, no cylinder is too fast, no group passes a forbidden range."""
    barred = {2: (25, 32), 7: (-32, -25)}
    for name in ["BoatHoist", "Barred"]:
        machine = Machine(folder / f"{name}.{suffix}", **(commands("straight")))
        linkage, limit, low, high = Linkage(machine), machine.get("v_c_max"), math.radians(-57), math.radians(57)
        numbers, stands, refused, size = random.Random(3), set(), 0, 0.2
        last = machine.all("theta_s")
        for _ in range(60):
            for key, value in commands(numbers.choice(MODES)).items():
                # A command that moves while the groups are on their way is another matter.
                machine.set(key, value)
            assert machine.all("theta_s") == pytest.approx(last, abs=1e-12)
            stands.add(machine.get("stand"))
            refused += math.isinf(machine.get("t_x"))
            for _ in range(numbers.randint(1, 120)):
                machine.step(size)
                now = machine.all("theta_s")
                moved = np.abs(linkage.lengths(now) - linkage.lengths(last))
                assert moved.max() <= limit * size * (1 + 1e-9)
                assert low - 1e-9 <= min(now) and max(now) <= high + 1e-9
                for group, ends in barred.items() if name == "Barred" else ():
                    assert not math.radians(ends[0]) + 1e-9 < now[group - 1] < math.radians(ends[1]) - 1e-9
                last = now
        assert stands == {0, 1} or stands == {False, True}
        assert (refused > 0) == (name == "Barred")
        machine.free()


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_changes_are_part_of_the_state(folder, suffix):
    machine = Machine(folder / f"BoatHoist.{suffix}", **commands("straight"))
    machine.step(1.0)
    machine.set("mode", 1 + MODES.index("all_wheel"))
    machine.step(5.0)
    names = ["getFMUState", "setFMUState", "serializeFMUState", "deserializeFMUState"]
    if not machine.fmi3:
        names = ["getFMUstate", "setFMUstate", "serializeFMUstate", "deSerializeFMUstate"]
    get, put, write, read = (getattr(machine.fmu, name) for name in names)
    state = get()
    saved = write(state)
    machine.step(3.0)
    there = [machine.all("theta_s"), machine.get("t_left"), machine.get("stand")]
    for back in [state, read(saved)]:
        machine.step(30.0)
        put(back)
        machine.time = 6.0
        machine.step(3.0)
        assert [machine.all("theta_s"), machine.get("t_left"), machine.get("stand")] == there
    machine.free()


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_changes_in_model_exchange(folder, suffix):
    """The mode changes at an event; between events the set points move with the time."""
    machine = Machine(folder / f"BoatHoist.{suffix}", exchange=True, **commands("straight"))
    update = machine.fmu.updateDiscreteStates if machine.fmi3 else machine.fmu.newDiscreteStates
    update()
    machine.fmu.enterContinuousTimeMode()
    machine.fmu.setTime(2.0)
    machine.fmu.enterEventMode()
    machine.set("mode", 1 + MODES.index("pivot"))
    update()
    machine.fmu.enterContinuousTimeMode()
    duration = machine.get("t_x")
    linkage = Linkage(machine)
    first = linkage.lengths(machine.all("theta_s"))
    assert machine.get("stand") and duration > 1
    machine.fmu.setTime(2.0 + duration / 4)
    quarter = linkage.lengths(machine.all("theta_s"))
    machine.fmu.setTime(2.0 + duration)
    assert machine.all("theta_s") == pytest.approx(machine.all("theta"), abs=1e-12)
    assert np.allclose(quarter, first + (linkage.lengths(machine.all("theta")) - first) / 4, atol=1e-12)
    machine.fmu.freeInstance()


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_the_nearest_command(folder, suffix):
    """Out of reach: the nearest angle, radius and centre by plain geometry; within reach the command itself."""
    machine = Machine(folder / f"BoatHoist.{suffix}")
    end = math.radians(57)

    def of(names, **inputs):
        for key, value in inputs.items():
            machine.set(key, value)
        return [machine.get(name) for name in names]

    number = {mode: 1 + MODES.index(mode) for mode in MODES}
    assert of(["theta_b_n"], mode=number["all_wheel"], command=1, theta_b=1.2) == pytest.approx([end], rel=1e-14)
    # Turning to the right, group 5 on the inner side stops at 57 degrees: cot(outer) = cot(57 deg) + S/L_2.
    outer = math.atan(1 / (1 / math.tan(end) + 12 / 9))
    assert of(["theta_b_n"], theta_b=-0.6) == pytest.approx([-outer], rel=1e-12)
    assert of(["R_t_n"], command=2, R_t=10.0) == pytest.approx([6 + 9 / math.tan(end)], rel=1e-12)
    assert of(["theta_b_n"], mode=number["crosswise"]) == pytest.approx([end], rel=1e-14)
    assert machine.all("theta_n") == pytest.approx([end] * 8, rel=1e-14)
    assert of(["theta_b_n", "R_t_n", "x_c_n"], mode=number["crab"], theta_b=0.4, R_t=33.0, x_c=3.0) == [0.4, 33.0, 3.0]
    assert machine.all("theta_n") == machine.all("theta")
    # About a corner: no centre of a fine grid that is nearer to it is within the ranges of all groups.
    x, y = of(["x_c_n", "y_c_n"], mode=number["corner"], corner=2)
    groups = np.array([complex(*at) for at in zip(machine.all("x"), machine.all("y"), strict=True)])

    def reaches(centre):
        turned = np.angle(1j * (groups - centre)) % np.pi
        return bool(np.all(np.minimum(turned, np.pi - turned) <= end + 1e-9))

    corner, found = complex(-11, 7), complex(x, y)
    assert reaches(found)
    for part in np.linspace(0.01, 0.999, 100):
        for angle in np.linspace(0, 2 * np.pi, 720):
            assert not reaches(corner + part * abs(found - corner) * np.exp(1j * angle))
    machine.free()


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_slip_against_all_signs(folder, suffix):
    """Angle errors of either sign in all 256 ways; for each, the rigid motion with the least sideways speeds."""
    machine = Machine(folder / f"BoatHoist.{suffix}")
    step, band = machine.get("resolution"), machine.get("dead_band")
    groups = np.array([complex(*at) for at in zip(machine.all("x"), machine.all("y"), strict=True)])
    signs = np.array([[1 if bits >> i & 1 else -1 for i in range(8)] for bits in range(256)])
    machine.set("v_t", 1.0)
    for mode, theta in [("all_wheel", 0.9), ("all_wheel", -0.3), ("crab", 0.5), ("front_axle", 0.4), ("pivot", 0.0)]:
        machine.set("mode", 1 + MODES.index(mode))
        machine.set("theta_b", theta)
        arms = np.array(machine.all("od"))
        errors = step / 2 + band / np.abs(arms)
        assert machine.all("delta") == pytest.approx(errors, rel=1e-12)
        omega, v_m = machine.get("omega"), complex(machine.get("v_M.x"), machine.get("v_M.y"))
        velocity = v_m + 1j * omega * groups
        worst = np.zeros(8)
        for pattern in signs * errors:
            normal = 1j * velocity / np.abs(velocity) * np.exp(1j * pattern)
            along = lambda w: (w * np.conj(normal)).real
            # Columns: what velocity forward, to the left, and turning add to each sideways speed.
            columns = np.column_stack([along(np.ones(8)), along(1j * np.ones(8)), along(1j * groups)])
            # The mean rolling speed stays: no part of the added motion along the travel of the groups.
            travel = np.array([velocity.real.sum(), velocity.imag.sum(), (velocity * np.conj(1j * groups)).real.sum()])
            scale = np.array([1, 1, np.abs(groups).max()])
            free = np.linalg.svd((travel / scale)[None, :])[2][1:].T / scale[:, None]
            added = free @ np.linalg.lstsq(columns @ free, -along(velocity), rcond=None)[0]
            worst = np.maximum(worst, np.abs(along(velocity) + columns @ added))
        slips = np.array(machine.all("slip"))
        # Turning on the spot, some errors have no part in the slip of others but by their square: either sign will do.
        least = 1 - errors.max() if mode == "pivot" else 1 - 1e-9
        assert np.all(slips <= worst * (1 + 1e-9)) and np.all(slips >= worst * least), mode
        assert machine.get("slip_max") == slips.max()
    machine.free()

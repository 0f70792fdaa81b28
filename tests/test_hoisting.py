"""A hoist with a motor on its drum, a rope that gives way, parts beside each other: their FMUs from outside."""

import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis, typst
from test_fmpy import Slave
from test_levels import SIZES, inside_and_outside, off, scene, signals

ENDS = {"FMI 3.0": ".fmu", "FMI 2.0": ".fmi2.fmu"}
ELASTIC = 'c_R = "3000 kN/m"\nd_R = "40 kN.s/m"\n'
# The load of 160 kN needs 10 kN·m on this drum, which weighs as 16 t at the head; its brake holds 11 kN·m.
MOTOR = 'J_h = "62.5 kg.m2"\nr_h = "250 mm"\nm_h = "4"\nM_Bh = "11 kN.m"\n'
HOISTS = {
    "swing_motor": MOTOR,
    "swing_motor_elastic": MOTOR + ELASTIC,
    "swing_slewing_motor": MOTOR,
    "swing_slewing_motor_elastic": MOTOR + ELASTIC,
    "hydraulic_swing_motor_elastic": MOTOR + ELASTIC,
}
# Lifted against the brake, stopped by it, lowered, stopped.
COMMANDS = [(0.0, 0.0), (0.4, 26e3), (1.2, 0.0), (2.0, -6e3), (3.0, 0.0)]


def crane(name, tmp_path, **replaced):
    """The scene's FMUs; its load hangs straight down."""
    level = re.sub("_motor|_elastic", "", name)
    text = scene(level, **{'l_R = "10 m"\n': "", 'phi_R = "0.1 rad"\n': "", 'phi_R = "0.05 rad"\n': "",
                           'v_h = "0.05 m/s"\n': "", 'chi_R = "-0.1 rad"\n': "", 'tol   = "1e-6"': 'tol   = "1e-8"'})
    text = text.replace(f"Crane_{level}", "Crane_hoist") + f'\n[hoisting]\nl_R = "10 m"\n{HOISTS[name]}'
    for old, new in replaced.items():
        assert old in text, old
        text = text.replace(old, new)
    (tmp_path / "crane.toml").write_text(text, encoding="utf-8")
    lemnis("fmu", tmp_path / "crane.toml", "--output", tmp_path)
    return str(tmp_path / "Crane_hoist")


@pytest.mark.parametrize("end", ENDS.values(), ids=ENDS)
@pytest.mark.parametrize("name", HOISTS)
def test_a_motor_inside_and_outside(name, end, tmp_path):
    """The drum breaks loose, is stopped by its brake and held: the same events in Model Exchange as in Co-Simulation."""
    path = crane(name, tmp_path) + end
    assert not validate_fmu(path)
    inside, outside = inside_and_outside(path, tmp_path, ["S_R", "v_R", "M_Rh"], "M_Mh", COMMANDS)
    for i, row in enumerate(inside, 1):
        if all(abs(0.05 * i - at) > 1e-9 for at, _ in COMMANDS):
            assert max(off(row, outside, i).values()) <= 1e-4, (i, off(row, outside, i))
    speeds = np.array([row["v_R"] for row in inside])
    assert speeds.min() < -0.5 and speeds.max() > 0.05 and (speeds == 0.0).sum() > 10, "lifted, lowered, held"
    assert min(row["S_R"] for row in inside) >= 0.0


@pytest.mark.parametrize("name", [name for name in HOISTS if name.startswith("swing")])
def test_the_motor_s_work_from_outside(name, tmp_path):
    """The crane held by its brakes: what the motor gives, less what brake, rope and blows take, lifts and moves load and
    drum and stretches the rope, to 1e-6 of what is exchanged."""
    replaced = {'M_A = "1800 kN.m"': 'M_A = "0 kN.m"\nM_S = "1e6 kN.m"'}
    slews = "slewing" in name
    if slews:
        replaced |= {'M_sl  = "400 kN.m"': 'M_sl = "0 kN.m"\nM_Bsl = "1e6 kN.m"'}
    path = crane(name, tmp_path, **replaced) + ".fmu"
    down = ["y_Q", "v_Qy"] if slews else ["s_Q", "v_Q"]
    names = ["S_R", "v_R", "l_R", "M_Rh", "W_blow", "omega_1", *down]
    # Short beside the rope's 80 ms of a radian: trapezia do.
    h = 2e-4
    run = simulate_fmu(path, fmi_type="ModelExchange", stop_time=4.0, output_interval=h, output=names,
                       input=signals("M_Mh", COMMANDS), relative_tolerance=1e-10)
    assert np.all(run["omega_1"] == 0.0)
    way, speed = (-run["y_Q"], -run["v_Qy"]) if slews else (run["s_Q"], run["v_Q"])
    ratio, weight, drum = 4 / 0.25, 160e3, 62.5 * 16 ** 2
    mass = weight / 9.81
    command = np.zeros_like(run["time"])
    for at, value in COMMANDS:
        command[run["time"] >= at - 1e-12] = value
    # At an event there are two rows: the first one is before it.
    for i in np.flatnonzero(np.diff(run["time"]) == 0.0):
        command[i] = command[i - 1]
    turning = -run["v_R"] * ratio
    if "elastic" in name:
        # What the rope's spring does not give back; all of it where it lets go while it is stretched.
        stretch = np.maximum(way - run["l_R"], 0.0)
        damped = (run["S_R"] - 3000e3 * stretch) * (speed - run["v_R"])
        stored = 0.5 * 3000e3 * stretch ** 2
    else:
        damped, stored = 0.0, 0.0
        speed = run["v_R"]
    power = (command + run["M_Rh"]) * turning - damped
    work = np.sum(np.diff(run["time"]) * (power[1:] + power[:-1]) / 2)
    energy = 0.5 * mass * speed ** 2 - weight * way + 0.5 * drum * run["v_R"] ** 2 + stored
    exchanged = weight * np.ptp(way)
    gained = energy[-1] - energy[0] + run["W_blow"][-1]
    print(name, work, gained, exchanged, (work - gained) / exchanged)
    assert abs(work - gained) <= 1e-6 * exchanged


def test_the_book_s_hoisting_and_stop_is_that_of_the_fmu(tmp_path):
    """The same command from outside, the crane held by its brakes: the least and the greatest force that the book has."""
    path = ROOT / "models/scenes/portal_crane.toml"
    lemnis("fmu", path, "--output", tmp_path)
    lemnis("book", path, "--format", "typ", "--output", tmp_path)
    source = typst(tmp_path / "PortalCraneWhole.typ")
    *_, start = re.findall(r"theta_1 = ([\d.]+)", source.split("[*Hoisting and stop*")[0])
    [row] = re.findall(r'(?s)\[\$S_R\$\];\], \[Least\](.*?)\[#say\("phi R"\)', source)
    forces = [float(force) for force in re.findall(r'\[\$([\d.]+) thin"kN"\$', row)]
    # At rest and in five manoeuvres, the least and the greatest.
    assert len(forces) == 12
    printed = [forces[4], forces[10]]
    # 0.1 m/s is reached with 0.4 m/s2, and kept for 4 s.
    run = simulate_fmu(str(tmp_path / "PortalCraneWhole.fmu"), fmi_type="CoSimulation", stop_time=12.5, output_interval=2.5e-3,
                       output=["S_R", "theta_1", "psi_sl"], input=signals("v_h", [(0.0, -0.1), (4.25, 0.0)]),
                       start_values={"theta_1": np.radians(float(start)), "M_A": 0.0, "M_S": 1e9, "M_sl": 0.0, "M_Bsl": 1e9})
    assert np.ptp(run["theta_1"]) == 0.0 and np.ptp(run["psi_sl"]) == 0.0
    found = [run["S_R"].min() / 1e3, run["S_R"].max() / 1e3]
    print(start, printed, found)
    assert np.allclose(found, printed, rtol=5e-4)


def test_the_book_lifts_with_a_motor(tmp_path):
    """A motor to which no speed is given lifts at a quarter of the rope's length in 4 s, reached in 4 s and kept for as long:
    half of the rope's 18 m in all. The rope's force is then that of the acceleration, and at most twice its part as the
    rope springs; elsewhere drum and load are held."""
    text = (ROOT / "models/scenes/portal_crane.toml").read_text(encoding="utf-8")
    motor = 'J_h = "62.5 kg.m2"\nr_h = "250 mm"\nm_h = "4"\nM_Mh = "9 kN.m"\nM_Bh = "11 kN.m"\n'
    text, count = re.subn(r'v_h = .*\na_h = .*\n', motor, text)
    assert count == 1
    (tmp_path / "crane.toml").write_text(text, encoding="utf-8")
    lemnis("book", tmp_path / "crane.toml", "--format", "typ", "--output", tmp_path)
    source = typst(tmp_path / "PortalCraneWhole.typ")
    [row] = re.findall(r'(?s)\[\$S_R\$\];\], \[Least\](.*?)\[#say\("phi R"\)', source)
    forces = np.array([float(force) for force in re.findall(r'\[\$([\d.]+) thin"kN"\$', row)]).reshape(2, 6)
    part = 100 * (18 / 4 / 4 / 4) / 9.81
    least, greatest = forces[:, 4] - 100
    assert -2 * part < least < -part and part < greatest < 2 * part, (part, forces)
    assert abs(np.delete(forces, 4, axis=1) - 100).max() < part
    [lifted] = re.findall(r'(?m)^  \[#say\("W h"\)\[\$W_h\$\];\],(.* thin"kJ".*)$', source)
    works = [float(work) for work in re.findall(r'\$(-?[\d.]+) thin"kJ"', lifted)]
    assert np.allclose(works, [0, 0, 0, 900, 0], atol=0.05)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_tells_of_a_drum_that_turns(language, tmp_path):
    """Neither motor nor brake holds the load: the drum's acceleration is one of the formulas of the motion."""
    text = (ROOT / "models/scenes/portal_crane.toml").read_text(encoding="utf-8")
    text, count = re.subn(r'v_h = .*\na_h = .*\n', 'J_h = "62.5 kg.m2"\nr_h = "250 mm"\nm_h = "4"\n', text)
    assert count == 1
    (tmp_path / "crane.toml").write_text(text, encoding="utf-8")
    options = ["--level", "full", "--language", language, "--format", "typ"]
    lemnis("book", tmp_path / "crane.toml", *options, "--output", tmp_path)
    source = typst(tmp_path / "PortalCraneWhole.typ")
    number = r'(-?"?\d+[.,]\d+"?)'
    [(*amounts, power)] = re.findall(
        rf'dot\(v\)_R &=.*\n.*frac\({number} thin"kN" - 4 slash \(250 thin"mm"\) dot \({number} thin"kN·m".*, 16 thin"t"\)\n'
        rf'.*= {number}(?: times 10\^\((-\d+)\))? thin"m/s²"', source)
    force, moment, rate = (float(amount.replace('"', "").replace(",", ".")) for amount in amounts)
    # What the rope pulls with, less what the motor gives, on a drum that weighs 16 t at the head.
    by_hand = (force - 4 / 0.25 * moment) / 16
    assert abs(rate * 10 ** int(power or 0) - by_hand) < 1e-6 < abs(by_hand)


class Driver:
    """Drives the FMU of the portal crane from outside as the book says that its manoeuvres are driven."""

    STEP, RAMP = 0.01, 4.0

    def __init__(self, path, folder, theta):
        class Started(Slave):
            def initialize(self):
                self.fmu.enterInitializationMode()
                start = {"theta_1": theta, "M_A": 0.0, "M_S": 1e9, "M_sl": 0.0, "M_Bsl": 1e9, "v_h": 0.0}
                self.fmu.setFloat64([self.references[name] for name in start], list(start.values()))
                self.fmu.exitInitializationMode()

        self.slave, self.seen = Started(path, folder), []

    def follow(self, drive, brake, rate, friction, most, dry, rates):
        """A moment by which the rate at the end of the step is the one wanted; what does not move is held by the brake."""
        read, write = self.slave.read, self.slave.write
        braked = rates == (0.0, 0.0)
        write(brake, most if braked else 0.0)
        now, before = read(drive), read(f"der({rate})")
        write(drive, now + most)
        gain = (read(f"der({rate})") - before) / most
        write(drive, now)
        if gain == 0.0:
            # At rest: what holds it, and a little more than dry friction where it is to move.
            moment = now + read(friction) + (0.0 if braked else np.sign(rates[1]) * dry * (1 + 1e-6))
        elif braked:
            moment = now
        else:
            moment = now + ((rates[1] - read(rate)) / self.STEP - before) / gain
        write(drive, float(np.clip(moment, -most, most)))

    def run(self, duration, luffing, slewing):
        begun = 1e-9
        for i in range(round(duration / self.STEP)):
            times = self.STEP * i, self.STEP * (i + 1)

            def tell():
                self.follow("M_A", "M_S", "omega_1", "M_R", 500e3, 20e3, tuple(map(luffing, times)))
                slewing(times)

            tell()
            if i == 0:
                # What breaks loose is free in the next step, and is then led.
                self.slave.step(0.0, begun)
                tell()
                self.look()
            self.slave.step(begun + times[0], self.STEP)
            self.look()
        self.slave.fmu.terminate()
        self.slave.fmu.freeInstance()
        return np.array(self.seen)

    def look(self):
        self.seen.append([self.slave.read("S_R") / 1e3, self.slave.read("N_3") / 1e3])

    def hold(self, times):
        self.follow("M_sl", "M_Bsl", "omega_sl", "M_Rsl", 300e3, 30e3, (0.0, 0.0))

    def turn(self, times):
        """The full moment for the ramp's time, the speed reached for as long, and the stop."""
        if times[0] < self.RAMP:
            self.reached = self.slave.read("omega_sl")
            self.slave.write("M_sl", 300e3)
            self.slave.write("M_Bsl", 0.0)
        else:
            rates = tuple(self.reached * np.clip(3 - time / self.RAMP, 0.0, 1.0) for time in times)
            self.follow("M_sl", "M_Bsl", "omega_sl", "M_Rsl", 300e3, 30e3, rates)


def trapeze(way, speed, ramp):
    """Speed over time, from rest to rest."""
    whole = abs(way) / speed + ramp
    return lambda time: np.sign(way) * speed * float(np.clip(min(time, whole - time) / ramp, 0.0, 1.0))


@pytest.mark.parametrize("place, name", [(1, "Luffing in"), (2, "Luffing out"), (3, "Slewing and stop")])
def test_the_book_s_manoeuvres_are_those_of_the_fmu(place, name, tmp_path):
    """Driven from outside by the rules that the book prints, with a driver of our own: the least and greatest forces in rope
    and rocker are the book's."""
    path = ROOT / "models/scenes/portal_crane.toml"
    lemnis("fmu", path, "--output", tmp_path)
    lemnis("book", path, "--format", "typ", "--output", tmp_path)
    source = typst(tmp_path / "PortalCraneWhole.typ")
    # 2 % of the range from 44 to 82 degrees are left at each end.
    low, high = np.radians([44.76, 81.24])
    start = high if name == "Luffing out" else low
    printed = [float(angle) for angle in re.findall(r"theta_1 = ([\d.]+)", source.split(f"[*{name}*")[0])][-1]
    assert np.isclose(np.degrees(start), printed)
    duration = float(re.findall(r'let duration = .*\$([\d.]+) thin"s"\$', source.split(f"[*{name}*")[0])[-1])
    driver = Driver(str(tmp_path / "PortalCraneWhole.fmu"), str(tmp_path / "fmu"), start)
    if name == "Slewing and stop":
        found = driver.run(duration, lambda time: 0.0, driver.turn)
    else:
        found = driver.run(duration, trapeze((low + high) - 2 * start, np.radians(0.5), driver.RAMP), driver.hold)
    for column, (symbol, after) in enumerate([("S_R", "phi R"), ("N_3", "M D")]):
        [row] = re.findall(rf'(?s)\[\${symbol}\$\];\], \[Least\](.*?)\[#say\("{after}"\)', source)
        forces = [float(force) for force in re.findall(r'\[\$(-?[\d.]+) thin"kN"\$', row)]
        assert len(forces) == 12, "at rest and in five manoeuvres, the least and the greatest"
        book = [forces[place], forces[6 + place]]
        ends = [found[:, column].min(), found[:, column].max()]
        print(name, symbol, book, ends)
        assert np.allclose(ends, book, rtol=5e-4)


def test_a_whole_crane(tmp_path):
    """Luffing, hoisting and slewing at once, in both standards and both interfaces."""
    lemnis("fmu", ROOT / "models/scenes/portal_crane.toml", "--output", tmp_path)
    names = [name for name in SIZES if name not in ("p_A", "p_B", "phi_R", "omega_R")] + ["S_R", "v_R"]
    runs = {}
    for end in ENDS.values():
        path = str(tmp_path / f"PortalCraneWhole{end}")
        assert not validate_fmu(path)
        known = {variable.name for variable in read_model_description(path).modelVariables}
        assert set(names) <= known
        for kind in ("CoSimulation", "ModelExchange"):
            runs[end, kind] = simulate_fmu(path, fmi_type=kind, stop_time=20.0, output_interval=0.05, output=names,
                                           relative_tolerance=1e-9, record_events=False)
    first = runs[".fmu", "CoSimulation"]
    assert first["S_R"].min() > 0.9e5 and first["l_R"][-1] < 16.5 and abs(first["psi_sl"][-1]) > 0.1
    for key, run in runs.items():
        rows = {round(t, 6): i for i, t in enumerate(run["time"])}
        common = [(i, rows[round(t, 6)]) for i, t in enumerate(first["time"]) if round(t, 6) in rows]
        assert len(common) > 350
        for column in names:
            size = SIZES.get(column, 1e5 if column == "S_R" else 1.0)
            worst = max(abs(first[column][i] - run[column][j]) for i, j in common)
            limit = 0.0 if key[1] == "CoSimulation" else 1e-5 * size
            assert worst <= limit, (key, column, worst)


def test_parts_beside_and_within_are_one_crane(tmp_path):
    """Tables at the top of a scene and within [luffing] give the same results, digit for digit."""
    beside = (ROOT / "models/scenes/portal_crane.toml").read_text(encoding="utf-8")
    within = beside
    for part in ("balance", "drive", "hoisting", "slewing"):
        assert f"\n[{part}]" in within
        within = within.replace(f"\n[{part}]", f"\n[luffing.{part}]")
    tables = {}
    for name, text in (("beside", beside), ("within", within)):
        (tmp_path / f"{name}.toml").write_text(text, encoding="utf-8")
        tables[name] = lemnis("check", tmp_path / f"{name}.toml", "--csv")
    assert tables["beside"] == tables["within"] and len(tables["beside"]) > 1000

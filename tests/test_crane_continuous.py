"""Luffing, slewing and hoist of a crane that luffs under continuous controllers: against closed forms of what slews with its boom
held, against SciPy with the law written here around the crane's motion without controllers, and as the limit of sampled ones;
both standards and both interfaces, saturation, a saved state, the same bits for every communication step, exact derivatives."""

import ctypes
import re

import numpy as np
import pytest
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi3 import FMU3Model
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis
from test_commands import ENDS, Stepped, same_bits, written
from test_control_continuous import KINDS, behind, chased, moments, told as straight
from test_crane_control import HOIST, LUFFING, SLEWING, TABLES, TEXT, without_control

SEEN = ["theta_1", "omega_1", "psi_sl", "omega_sl", "l_R", "v_R", "x_Q", "y_Q", "z_Q"]
# Commanded speeds from times on, in SI: of luffing, slewing and hoist.
ROWS = ([(0.0, 0.006), (6.0, -0.003)], [(0.0, 0.05), (7.0, 0.02)], [(0.0, -0.3), (5.0, 0.1)])
UNITS = ("rad/s", "rad/s", "m/s")


def told(rows, unit, end):
    return '{ between = "steps", over = [' + ", ".join(f'["{t} s", "{v} {unit}"]' for t, v in [*rows, (end, rows[-1][1])]) + "] }"


def put(text, pattern, by):
    text, count = re.subn(pattern, lambda _: by, text, flags=re.M | re.S)
    assert count == 1, (pattern, count)
    return text


def by_speed(cycle=None, rows=ROWS, end=12.0, **keys):
    """The ready scene with speeds commanded of all drives, its samples a cycle (s) apart, or continuous."""
    text = put(TEXT, r"^K_thetaA .*?\n(?=omega_maxA)", "")
    text = put(text, r"^omega_maxA .*?\n", "")
    for name, new, own, unit in zip(("theta_cA", "omega_csl", "v_ch"), ("omega_cA", "omega_csl", "v_ch"), rows, UNITS):
        text = put(text, rf"^{name} *= \{{.*?^\] \}}", f"{new} = {told(own, unit, end)}")
    text = re.sub(r"(?m)^(T_c\w+ *=).*\n", "" if cycle is None else rf'\1 "{cycle} s"' + "\n", text)
    for name, value in keys.items():
        text = put(text, rf"^{name} +=.*?$", f"{name} = {value}" if value else "")
    return text


SMOOTH = {"M_F": '"0 kN.m"\nstep = "1 ms"', "M_Fh": "", "M_Fsl": ""}
STEP = '"20 kN.m"\nstep = "1 ms"'


class Outside:
    """Proportional and integral around the crane's motion without controllers, whose rates an FMU tells; written here."""

    def __init__(self, path, drives):
        description = read_model_description(path)
        self.names = [unknown.variable.derivative.name for unknown in description.derivatives]
        self.references = {v.name: v.valueReference for v in description.modelVariables}
        self.count = len(self.names)
        self.model = FMU3Model(guid=description.guid, unzipDirectory=extract(path),
                               modelIdentifier=description.modelExchange.modelIdentifier, instanceName="plant")
        self.model.instantiate()
        self.model.enterInitializationMode()
        self.model.exitInitializationMode()
        # Under these moments all drives set off, by which friction of zero is none.
        self.put(drives)
        self.model.updateDiscreteStates()
        self.model.enterContinuousTimeMode()

    def put(self, drives):
        self.model.setFloat64([self.references[name] for name in drives], list(drives.values()))

    def states(self):
        return np.array([self.model.getFloat64([self.references[name]])[0] for name in self.names])

    def rates(self, y, drives):
        states = (ctypes.c_double * self.count)(*y)
        self.model.setContinuousStates(states, self.count)
        self.put(drives)
        out = (ctypes.c_double * self.count)()
        self.model.getContinuousStateDerivatives(out, self.count)
        return np.array(out)


def stepped(axes, rows):
    """Corners of set points behind commands in steps."""
    set_points = []
    for axis, own in zip(axes, rows):
        knots = [(0.0, 0.0)]
        for (start, command), stop in zip(own, [t for t, _ in own[1:]] + [np.inf]):
            at = np.interp(start, *zip(*knots))
            knots = [knot for knot in knots if knot[0] < start] + [(start, at)]
            reached = start + abs(command - at) / axis["ramp"]
            assert reached < stop
            knots.append((reached, command))
        set_points.append(np.array(knots).T)
    return set_points


def followed(path, axes, set_points, times, held):
    """The states at the times: every set point goes at its acceleration to its command and stays, e = s (v_r − v),
    M = K_p e + K_i ∫e dt from the moments that hold the crane at first."""
    plant = Outside(path, {axis["drive"]: moment + 1e3 * np.sign(points[1][1]) * axis["sense"]
                           for axis, points, moment in zip(axes, set_points, held)})
    found = plant.names
    speeds = [found.index(axis["speed"]) for axis in axes]
    ends = sorted({t for knots in set_points for t in knots[0]} | {times[-1]})

    def law(t, y):
        errors = [axis["sense"] * (np.interp(t, *knots) - y[i]) for axis, knots, i in zip(axes, set_points, speeds)]
        moments = {axis["drive"]: axis["k_p"] * e + axis["k_i"] * part
                   for axis, e, part in zip(axes, errors, y[plant.count:])}
        return errors, moments

    def rates(t, y):
        errors, moments = law(t, y)
        return np.concatenate([plant.rates(y[:plant.count], moments), errors])

    y = np.concatenate([plant.states(), [m / axis["k_i"] for axis, m in zip(axes, held)]])
    at, seen = 0.0, {0.0: y}
    for end in ends[1:]:
        inside = times[(times > at) & (times <= end)]
        run = solve_ivp(rates, (at, end), y, method="DOP853", rtol=1e-11, atol=1e-12, t_eval=sorted({*inside, end}))
        seen |= {time: run.y[:, i] for i, time in enumerate(run.t)}
        at, y = end, run.y[:, -1]
    whole = np.array([seen[time] for time in times])
    forces = np.array([list(law(time, seen[time])[1].values()) for time in times])
    return dict(zip(found, whole.T)) | {axis["drive"]: forces[:, i] for i, axis in enumerate(axes)}


# Straight commands: slower than the ramps, and faster.
LINES = ([(0.0, 0.0), (5.0, 0.008), (8.0, -0.002), (12.0, 0.0)], [(0.0, 0.0), (1.0, 0.06), (6.0, 0.04), (12.0, 0.04)],
         [(0.0, -0.1), (4.0, -0.5), (5.0, 0.3), (12.0, 0.1)])


@pytest.mark.parametrize("between", ["steps", "linear"])
def test_all_drives_at_once_are_the_law_around_the_crane(tmp_path, between):
    """Without dry friction and within their limits, in space, on a rope that gives way; all of range to 1e-7."""
    axes, times = (LUFFING, SLEWING, HOIST), np.arange(0.0, 12.01, 0.25)
    text, points = by_speed(**SMOOTH), stepped(axes, ROWS)
    if between == "linear":
        for name, rows, unit in zip(("omega_cA", "omega_csl", "v_ch"), LINES, UNITS):
            text = put(text, rf"^{name} = \{{.*?\}}$", f"{name} = {straight(rows, between, unit)}")
        points = [np.array(chased(rows, axis["ramp"])).T for rows, axis in zip(LINES, axes)]
    paths = written(tmp_path, "PortalBySpeed", text)
    at_rest = Stepped(paths["FMI 3"])
    held = at_rest.get(["M_A", "M_sl", "M_Mh"])
    at_rest.close()
    (tmp_path / "plant").mkdir()
    plant = written(tmp_path / "plant", "PortalBySpeed", without_control(by_speed(**SMOOTH)))["FMI 3"]
    wanted = followed(plant, axes, points, times, held)
    names = [*SEEN, "M_A", "M_sl", "M_Mh"]
    for standard, path in paths.items():
        assert not validate_fmu(path)
        for kind in KINDS:
            run = simulate_fmu(path, fmi_type=kind, stop_time=12.0, output_interval=0.25, relative_tolerance=1e-11, output=names,
                               record_events=False)
            apart = {name: np.abs(run[name] - wanted[name]).max() / np.ptp(wanted[name]) for name in names}
            print(standard, kind, apart)
            assert max(apart.values()) <= 1e-7, (standard, kind)


# What slews as one body: the boom held by its brake, the load at the head.
def rigid(command=None, **keys):
    text = TEXT.replace('fidelity = "swing" ', 'fidelity = "rigid" ', 1)
    for table in (r"luffing\.", r"hoisting\."):
        text = put(text, TABLES.format(table), "\n")
    text = put(text, r"\n\[hoisting\]\n(?:[^\[]|\[(?!\w))*?(?=\n\[\w)", "\n")
    text = put(text, r"^M_F .*?$", 'M_F = "0 kN.m"\nM_S = "5000 kN.m"\nstep = "10 ms"')
    text = put(text, r"^M_Fsl .*?$", "")
    if command is None:
        text = put(text, TABLES.format(r"slewing\."), '\nM_sl = "100 kN.m"\n')
        return put(text, r"^c_sl .*?$", "")
    text = put(text, r"^T_csl .*?\n", "")
    text = put(text, r"^omega_csl *= \{.*?^\] \}", f"omega_csl = {command}")
    for name, value in keys.items():
        text = put(text, rf"^{name} +=.*?$", f'{name} = "{value}"' if value else "")
    return text


@pytest.fixture(scope="module")
def inertia(tmp_path_factory):
    """Of all that slews, in kg·m²: from its acceleration under a moment."""
    fmu = Stepped(written(tmp_path_factory.mktemp("inertia"), "PortalBySpeed", rigid())["FMI 3"])
    rows = fmu.run([0.0, 4.0], ["omega_sl"])
    fmu.close()
    return 100e3 * 4.0 / rows[-1][0]


@pytest.mark.parametrize("part", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("standard", ENDS)
def test_slewing_with_the_boom_held_in_closed_form(tmp_path, inertia, standard, part):
    """Its damping is over, under and at its critical one, as the gain is a part of the square of half the other over the inertia."""
    k_p = 4.2e7
    k_i, command, ramp = part * k_p ** 2 / (4 * inertia), 0.05, 0.03
    path = written(tmp_path, "PortalBySpeed", rigid(f'"{command} rad/s"', c_sl="", K_isl=f"{k_i!r} N.m", M_maxsl="9e6 N.m"))[standard]
    for kind in KINDS:
        run = simulate_fmu(path, fmi_type=kind, stop_time=8.0, output_interval=0.1, relative_tolerance=1e-12,
                           output=["omega_sl", "omega_rsl"], record_events=False)
        t = run["time"]
        point = np.minimum(ramp * t, command)
        error = ramp * (behind(t, k_p, k_i, inertia) - behind(t - command / ramp, k_p, k_i, inertia))
        apart = [np.abs(run["omega_rsl"] - point).max(), np.abs(run["omega_sl"] - (point - error)).max()]
        print(standard, kind, part, [x / command for x in apart])
        assert max(apart) <= 1e-7 * command


def test_slewing_with_the_boom_held_at_its_limit(tmp_path, inertia):
    """Anti-windup, the integral waiting and sliding along the limit, against SciPy."""
    rows, gains, c, limit = [(0.0, 0.05), (12.0, -0.03), (24.0, 0.0)], (2e7, 4e7), 1e6, 200e3
    paths = written(tmp_path, "PortalBySpeed", rigid(told(rows, "rad/s", 40.0), K_psl=f"{gains[0]} N.m.s", K_isl=f"{gains[1]} N.m",
                                                     c_sl=f"{c} N.m.s", M_maxsl=f"{limit} N.m"))
    times = np.array([i / 4 for i in range(161)])
    expected, seen = moments(rows, gains, c, limit, 40.0, times, inertia)
    assert {"free", "waits", "stays"} == set(seen), seen
    for standard, path in paths.items():
        for kind in KINDS:
            run = simulate_fmu(path, fmi_type=kind, stop_time=40.0, output_interval=0.25, relative_tolerance=1e-11,
                               output=["omega_sl", "epsilon_sl", "M_sl"], record_events=False)
            apart = np.abs(run["omega_sl"] - expected[:, 0]).max() / 0.05
            wound = np.abs(gains[1] * run["epsilon_sl"] - expected[:, 1]).max() / limit
            print(standard, kind, apart, wound, seen)
            assert max(apart, wound) <= 1e-7
            assert np.abs(run["M_sl"]).max() == limit


FREE = {"M_F": STEP}
LIMITED = FREE | {"M_maxsl": '"120 kN.m"', "M_maxh": '"18 kN.m"', "a_ch": '"2 m/s2"'}


@pytest.mark.parametrize("case", ["free", "limited"])
def test_sampled_controllers_tend_to_it_at_first_order(tmp_path, case):
    """Of all drives at once, with friction that sticks, over three decades of the cycle."""
    keys, names, last = {"free": FREE, "limited": LIMITED}[case], SEEN, {}
    for cycle in (None, 0.1, 0.01, 1e-3, 1e-4):
        folder = tmp_path / f"{cycle}"
        folder.mkdir()
        path = written(folder, "PortalBySpeed", by_speed(cycle, **keys))["FMI 3"]
        fmu = Stepped(path)
        rows = np.array(fmu.run([0.5 * i for i in range(25)], [*names, "M_sl", "M_Mh"]))
        fmu.close()
        last[cycle] = rows[:, :-2]
        if case == "limited" and cycle is None:
            assert (np.abs(rows[:, -2:]).max(axis=0) == [120e3, 18e3]).all()
    scale = np.ptp(last[None], axis=0)
    off = np.array([(np.abs(last[cycle] - last[None]) / scale).max(axis=0) for cycle in (0.1, 0.01, 1e-3, 1e-4)])
    orders = -np.diff(np.log10(off), axis=0)
    print(case, off, orders)
    assert np.abs(orders - 1.0).max() <= 0.1


def test_the_crane_begins_at_rest_and_commands_act_at_events(tmp_path):
    rows = [[(0.0, 0.0)]] * 3
    for standard, path in written(tmp_path, "PortalBySpeed", by_speed(rows=rows)).items():
        description = read_model_description(path)
        variables = {v.name: v for v in description.modelVariables}
        states = [unknown.variable.derivative.name for unknown in description.derivatives]
        assert states[-6:] == ["omega_rA", "epsilon_rA", "omega_rsl", "epsilon_sl", "v_rh", "epsilon_rh"]
        assert {variables[name].variability for name in ("M_A", "M_sl", "M_Mh")} == {"continuous"}
        assert "T_cA" not in variables and "omega_sA" not in variables
        run = simulate_fmu(path, fmi_type="ModelExchange", stop_time=3.0, output_interval=0.1,
                           output=["omega_1", "v_R", "omega_sl", "M_Mh"], record_events=False)
        assert max(np.abs(run[name]).max() for name in ("omega_1", "v_R", "omega_sl")) <= 1e-12
        assert np.abs(run["M_Mh"] - 100e3 * 0.35 / 2).max() <= 1e-6
    one = re.sub(r"(omega_csl = ).*", r'\1"0.05 rad/s"', by_speed(rows=rows))
    variables = {v.name: v for v in read_model_description(written(tmp_path, "PortalBySpeed", one)["FMI 3"]).modelVariables}
    assert (variables["omega_csl"].causality, variables["omega_csl"].variability) == ("input", "discrete")


@pytest.mark.parametrize("standard", ENDS)
def test_any_communication_step_gives_the_same_bits(tmp_path, standard):
    found = same_bits(written(tmp_path, "PortalBySpeed", by_speed(**LIMITED))[standard], 1200, 7)
    assert found[1200] != found[0]


def test_a_saved_state_goes_on_in_the_same_bits(tmp_path):
    fmu = Stepped(written(tmp_path, "PortalBySpeed", by_speed(**LIMITED))["FMI 3"])
    names = ["omega_1", "omega_sl", "v_R", "M_A", "M_sl", "M_Mh", "epsilon_rA", "v_rh"]
    fmu.run([0.0, 0.7], names)
    once, again = fmu.again([0.7, 2.3, 9.0], names)
    fmu.close()
    assert once == again


def test_derivatives_are_those_of_the_law(tmp_path):
    """M = K_p e + K_i ε by each state; a moment more accelerates the bar by as much as the same crane's drive does."""
    fmu = Stepped(written(tmp_path, "PortalBySpeed", by_speed(**SMOOTH))["FMI 3"])
    fmu.run([0.0, 1.0], ["omega_1"])
    for axis, point, part in ((LUFFING, "omega_rA", "epsilon_rA"), (SLEWING, "omega_rsl", "epsilon_sl"), (HOIST, "v_rh", "epsilon_rh")):
        k_p, sense = axis["k_p"], axis["sense"]
        for known, slope, error in ((point, k_p * sense, sense), (axis["speed"], -k_p * sense, -sense), (part, axis["k_i"], 0.0)):
            found = fmu.slave.getDirectionalDerivative([fmu.references[axis["drive"]], fmu.references[f"der({part})"]],
                                                       [fmu.references[known]], [1.0])
            assert list(found) == pytest.approx([slope, error], rel=1e-14), (known, axis["drive"])
    fmu.close()


@pytest.mark.parametrize("name", ["curved_trunk_motion", "ellipsograph_motion", "rope_motion"])
def test_other_mechanisms_luff_by_it(tmp_path, name):
    """Model Exchange and Co-Simulation agree, and samples tend to it at first order."""
    text = (ROOT / f"models/scenes/{name}.toml").read_text(encoding="utf-8")
    last = {}
    for cycle in (None, 0.01, 1e-3):
        folder = tmp_path / f"{cycle}"
        folder.mkdir()
        control = f"""
[luffing.control]
K_pA = "50000 kN.m.s"
K_iA = "30000 kN.m"
{"" if cycle is None else f'T_cA = "{cycle} s"'}
a_A = "0.004 rad/s2"
M_maxA = "9000 kN.m"
omega_cA = "0.2 deg/s"
"""
        scene = re.sub(r"(?m)^M_[AS] +=.*\n", "", text) + control
        path = written(folder, re.search(r'(?m)^name += "(\w+)"', text)[1], scene)["FMI 3"]
        for kind in KINDS if cycle is None else KINDS[:1]:
            run = simulate_fmu(path, fmi_type=kind, stop_time=6.0, output_interval=0.5, relative_tolerance=1e-10,
                               output=["omega", "phi"], record_events=False)
            last[cycle, kind] = np.array([run["omega"], run["phi"]])
    continuous = last[None, KINDS[0]]
    scale = np.ptp(continuous, axis=1)[:, None]
    assert (np.abs(last[None, KINDS[1]] - continuous) <= 1e-6 * scale).all()
    off = [(np.abs(last[cycle, KINDS[0]] - continuous) / scale).max() for cycle in (0.01, 1e-3)]
    print(name, off)
    assert abs(np.log10(off[0] / off[1]) - 1.0) <= 0.1


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_has_the_law(tmp_path, language):
    (tmp_path / "scene.toml").write_text(by_speed(), encoding="utf-8")
    lemnis("book", tmp_path / "scene.toml", "--format", "typ", "--language", language, "--output", tmp_path)
    [page] = tmp_path.glob("*.typ")
    book = page.read_text(encoding="utf-8")
    for symbol in ('e_"r A"', 'M_"a A"', 'e_"r sl"', 'M_"a sl"', 'e_"r h"', 'M_"a h"'):
        assert symbol in book, symbol
    assert 'omega_"n A"' not in book and 'T_"c A"' not in book

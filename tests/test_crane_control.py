"""A crane whose luffing, slewing and hoist follow commands: its controllers against one written here that commands the moments
of the same crane without them, through an FMU of its own; both standards and both interfaces."""

import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT, lemnis
from test_commands import ENDS, Stepped, same_bits, written

SCENE = ROOT / "models/scenes/portal_by_speed.toml"
TEXT = SCENE.read_text(encoding="utf-8")

# Gains, ramp, greatest moment; speed over distance and greatest speed where a place is commanded; which way a moment acts; SI.
LUFFING = dict(drive="M_A", place="theta_1", speed="omega_1", k_p=1e8, k_i=7.6e7, ramp=0.004, limit=900e3,
               approach=(0.3, np.radians(0.5)), command=np.radians(49), sense=1)
SLEWING = dict(drive="M_sl", place="psi_sl", speed="omega_sl", k_p=4.2e7, k_i=3.1e7, ramp=0.03, limit=900e3, approach=None,
               command=np.radians(3), sense=1)
HOIST = dict(drive="M_Mh", place="l_R", speed="v_R", k_p=42e3, k_i=62e3, ramp=0.2, limit=40e3, approach=(0.6, 0.5), command=15.0,
             sense=-1)
T_C = 0.02
TABLES = r"\n\[{}control\]\n(?:[^\[]|\[(?!\w))*?(?=\n\[\w)"
HELD = ["omega_sA", "M_iA", "M_A", "omega_ssl", "M_isl", "M_sl", "v_sh", "M_ih", "M_Mh"]
SEEN = ["theta_1", "omega_1", "psi_sl", "omega_sl", "l_R", "v_R", "x_Q", "y_Q", "z_Q", "S_R"]


def without_control(text):
    for table in ("luffing.", "hoisting.", "slewing."):
        text, count = re.subn(TABLES.format(re.escape(table)), "\n", text)
        assert count == 1, table
    # A motor without a moment is one whose inputs are zero.
    return text


def constant(text, **commands):
    for name, value in commands.items():
        text, count = re.subn(rf"^{name} *= \{{.*?^\] \}}", f'{name} = "{value}"', text, flags=re.M | re.S)
        assert count == 1, name
    return text


def to_length(text):
    """The hoist goes to a length of rope."""
    return re.sub(r"^v_ch .*", 'l_ch = "15 m"\nK_lh = "0.6 1/s"\nv_maxh = "0.5 m/s"', text, flags=re.M)


class Controller:
    """Proportional and integral, its set point on a ramp, its moment limited; written without a look at the other one."""

    def __init__(self, axis, moment):
        self.axis, self.set, self.integral = axis, 0.0, axis["sense"] * moment

    def sample(self, fmu):
        a = self.axis
        place, speed = fmu.get([a["place"], a["speed"]])
        wanted = a["command"]
        if a["approach"]:
            left = a["command"] - place
            slope, most = a["approach"]
            wanted = np.sign(left) * min(slope * abs(left), most, np.sqrt(2 * a["ramp"] * abs(left)))
        self.set += np.clip(wanted - self.set, -a["ramp"] * T_C, a["ramp"] * T_C)
        error = self.set - speed
        asked = a["k_p"] * error + self.integral
        moment = np.clip(asked, -a["limit"], a["limit"])
        if asked == moment or np.sign(asked) != np.sign(error):
            self.integral += a["k_i"] * T_C * error
        fmu.set(a["drive"], a["sense"] * moment)
        return [self.set, a["sense"] * self.integral, a["sense"] * moment]


@pytest.fixture(scope="module")
def commanded(tmp_path_factory):
    text = to_length(constant(TEXT, theta_cA="49 deg", v_ch="0 m/s", omega_csl="3 deg/s"))
    return written(tmp_path_factory.mktemp("commanded"), "PortalBySpeed", text)


@pytest.fixture(scope="module")
def driven(tmp_path_factory):
    return written(tmp_path_factory.mktemp("driven"), "PortalBySpeed", without_control(TEXT))


@pytest.fixture(scope="module")
def outside(driven):
    """What the crane does under the controllers written here: at each sample before and after it."""
    fmu = Stepped(driven["FMI 3"])
    # The boom is held by what the mechanism's statics ask for, the drum by the load on its falls.
    [m_d] = statics(["M_D"])
    controllers = [Controller(LUFFING, m_d), Controller(SLEWING, 0.0), Controller(HOIST, 100e3 * 0.35 / 2)]
    rows = []
    for k in range(1500):
        held = sum((controller.sample(fmu) for controller in controllers), [])
        fmu.slave.doStep(currentCommunicationPoint=k * T_C, communicationStepSize=T_C)
        rows.append(held + fmu.get(SEEN))
    fmu.close()
    return np.array(rows)


def statics(names):
    """Of the same crane at rest at the start of its range, its drive's moment in closed form."""
    import tempfile
    from pathlib import Path
    text = without_control(TEXT).replace('fidelity = "swing" ', 'fidelity = "static" ', 1)
    for table in (r"luffing\.dynamics", "hoisting", "slewing"):
        text, count = re.subn(rf"\n\[{table}\]\n(?:[^\[]|\[(?!\w))*?(?=\n\[\w)", "\n", text)
        assert count == 1, table
    with tempfile.TemporaryDirectory() as folder:
        fmu = Stepped(written(Path(folder), "PortalBySpeed", text)["FMI 3"])
        found = fmu.get(names)
        fmu.close()
    return found


@pytest.mark.parametrize("standard", ENDS)
def test_commands_are_inputs_and_moments_results(commanded, standard):
    assert not validate_fmu(commanded[standard])
    variables = {v.name: v for v in read_model_description(commanded[standard]).modelVariables}
    assert [variables[name].causality for name in ("theta_cA", "omega_csl", "l_ch", "M_A", "M_sl", "M_Mh")] == ["input"] * 3 + ["output"] * 3
    assert {variables[name].variability for name in HELD} == {"discrete"}


@pytest.mark.parametrize("standard", ENDS)
def test_controllers_are_those_written_here(commanded, outside, standard):
    """Through ramps, limits and both approaches, at every sample; a step spans one sample or five, in the same bits."""
    names = HELD + SEEN
    runs = []
    for step in (1, 5):
        fmu = Stepped(commanded[standard])
        runs.append(np.array(fmu.run([k * T_C for k in range(0, 1501, step)], names))[1:])
        fmu.close()
    assert (runs[0][4::5] == runs[1]).all()
    found, wanted = runs[0], outside
    scale = np.abs(wanted).max(axis=0)
    off = np.abs(found - wanted).max(axis=0) / scale
    print(dict(zip(names, off)))
    assert off.max() <= 1e-11
    # It went where it was sent.
    assert abs(found[-1, names.index("l_R")] - 15.0) <= 2e-3
    assert abs(found[-1, names.index("omega_sl")] - np.radians(3)) <= 3e-3


@pytest.mark.parametrize("standard", ENDS)
def test_model_exchange_has_an_event_at_every_sample(commanded, outside, standard):
    run = simulate_fmu(commanded[standard], fmi_type="ModelExchange", stop_time=10.0, output_interval=T_C, relative_tolerance=1e-10,
                       output=SEEN, record_events=False)
    for i, name in enumerate(SEEN):
        wanted = outside[:500, len(HELD) + i]
        assert np.abs(run[name][1:501] - wanted).max() <= 2e-6 * max(1.0, np.abs(wanted).max()), name


@pytest.mark.parametrize("standard", ENDS)
def test_any_communication_step_gives_the_same_bits_and_the_cycle_ends_where_it_was_sent(tmp_path, standard):
    lemnis("fmu", SCENE, "--output", tmp_path)
    path = str(tmp_path / f"PortalBySpeed{ENDS[standard]}")
    found = same_bits(path, 3700, 21)
    assert found[3700] != found[0]
    fmu = Stepped(path)
    rows = fmu.run([i / 2 for i in range(141)], ["theta_1", "psi_sl", "l_R", "omega_1", "v_R"])
    fmu.close()
    theta, psi, rope, omega, v = rows[-1]
    assert abs(np.degrees(theta) - 49) <= 0.03 and abs(np.degrees(psi) - 45) <= 0.3
    assert abs(rope - (18 - 0.4 * 8)) <= 0.02 and abs(omega) <= 1e-3 and abs(v) <= 1e-3


def test_what_a_parameter_changes_is_held_at_the_start_too(commanded):
    """With another load on a rope that it stretches less boom and drum are held by other moments, and begin at rest all the same."""
    start = {"Q": 40e3, "y_Q": -18.0 - 40e3 / 2500e3, "theta_cA": np.radians(44), "l_ch": 18.0, "omega_csl": 0.0}
    run = simulate_fmu(commanded["FMI 2"], start_values=start, stop_time=5.0, output_interval=0.1,
                       output=["omega_1", "v_R", "M_Mh", "M_A"], record_events=False)
    assert np.abs(run["M_Mh"] - 40e3 * 0.35 / 2).max() <= 1e-6
    assert np.abs(run["v_R"]).max() <= 1e-12 and np.abs(run["omega_1"]).max() <= 1e-12
    # The load's part of the moment is in proportion to it.
    [m_d, m_q] = statics(["M_D", "M_Q"])
    assert np.abs(run["M_A"] - (m_d - 0.6 * m_q)).max() <= 1e-3

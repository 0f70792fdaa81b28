"""Wind on all that slews of a crane that luffs, slews and lifts: against the closed form of a crane that slews with its boom held,
against SciPy around the same crane without that wind, under controllers, on a cylinder with oil; both standards and both
interfaces, exact derivatives, the book."""

import math
import re

import numpy as np
import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp

from conftest import ROOT, lemnis, words
from test_commands import ENDS, Stepped, same_bits, written
from test_control_continuous import KINDS
from test_crane_continuous import Outside, by_speed, inertia, put, rigid  # noqa: F401, as a fixture

AREA, PLACE, RHO = 60.0, 7.5, 1.2
EXPOSED = f'A_ws = "{AREA} m2"\nr_ws = "{PLACE} m"\n'
PORTAL = (ROOT / "models/scenes/portal_crane.toml").read_text(encoding="utf-8")


def exposed(text, v="18 m/s", chi="70 deg", load=""):
    """Of what slews, in wind; with air around the load, or none."""
    air = f'\n[luffing.air]\nrho_air = "{RHO} kg/m3"\nv_air = {v if v[0] == "{" else chr(34) + v + chr(34)}\n' \
          f'chi_air = {chi if chi[0] == "{" else chr(34) + chi + chr(34)}\n{load}'
    return put(text, r"(?<=\n\[slewing\]\n)", EXPOSED) + air


def moment(v, chi, psi):
    return 0.5 * RHO * v * abs(v) * AREA * PLACE * np.sin(chi - psi)


@pytest.mark.parametrize("standard", ENDS)
def test_a_crane_with_its_boom_held_in_closed_form(tmp_path, inertia, standard):  # noqa: F811
    """Its drive and the wind are a potential: half its inertia times the square of its speed is what they have given."""
    path = written(tmp_path, "PortalBySpeed", exposed(rigid(), "28 m/s"))[standard]
    assert not validate_fmu(path)
    chi, most = math.radians(70.0), moment(28.0, math.pi / 2, 0.0)
    for kind in KINDS:
        run = simulate_fmu(path, fmi_type=kind, stop_time=60.0, output_interval=0.25, relative_tolerance=1e-12, record_events=False,
                           output=["psi_sl", "omega_sl", "M_ws", "p_ws"])
        psi = run["psi_sl"]
        given = 100e3 * (psi - psi[0]) + most * (np.cos(chi - psi) - math.cos(chi - psi[0]))
        energy = 0.5 * inertia * run["omega_sl"] ** 2
        assert np.abs(run["M_ws"] - moment(28.0, chi, psi)).max() <= 1e-12 * most
        assert np.abs(run["p_ws"] - 0.5 * RHO * 28.0 ** 2).max() <= 1e-9
        assert np.ptp(psi) > 2.0 and np.abs(energy - given).max() <= 2e-8 * energy.max(), (kind, np.abs(energy - given).max() / energy.max())


TIMES, SPEEDS, TO = [0.0, 3.0, 5.0, 8.0], [12.0, 12.0, 27.0, -15.0], [20.0, 20.0, 80.0, 130.0]
LOAD = 'Q_air = "100 kN"\nd_Q = "0.4 kN.s/m"\nc_wQ = "1.1"\nA_Q = "9 m2"\n'


def smooth(text):
    for name, value in {"M_F  ": '"0 kN.m"\nstep = "1 ms"', "v_h": '"0 m/s"'}.items():
        text = put(text, rf"^{name}=.*?$|^{name} =.*?$", f"{name} = {value}")
    return put(text, r"^M_Fsl .*?$", "")


@pytest.mark.parametrize("load", ["", LOAD])
def test_gusts_from_many_sides_against_scipy(tmp_path, load):
    """Luffing, slewing and a load that swings, in space: around the motion of the same crane without that wind, whose rates an FMU
    tells, the moment of the wind as one more of the drive, from one break of the wind to the next."""
    def over(values, unit):
        return '{ between = "linear", over = [' + ", ".join(f'["{t} s", "{v} {unit}"]' for t, v in zip(TIMES, values)) + "] }"

    paths = written(tmp_path, "PortalCraneWhole", exposed(smooth(PORTAL), over(SPEEDS, "m/s"), over(TO, "deg"), load))
    still = f'\n[luffing.air]\nrho_air = "{RHO} kg/m3"\n{load}' if load else ""
    (tmp_path / "calm").mkdir()
    calm = written(tmp_path / "calm", "PortalCraneWhole", smooth(PORTAL) + still)["FMI 3"]
    drives = {"M_A": 500e3, "M_sl": 300e3}
    plant = Outside(calm, drives)
    at = [plant.names.index(name) for name in ("psi_sl", "omega_sl")]

    def rates(t, y):
        v, chi = np.interp(t, TIMES, SPEEDS), math.radians(np.interp(t, TIMES, TO))
        around = {"v_air": v, "chi_air": chi} if load else {}
        return plant.rates(y, drives | {"M_sl": 300e3 + moment(v, chi, y[at[0]])} | around)

    y, seen = plant.states(), {}
    for start, end in zip(TIMES, TIMES[1:]):
        grid = np.arange(start, end + 1e-9, 0.25)
        run = solve_ivp(rates, (start, end), y, method="DOP853", rtol=1e-11, atol=1e-12, t_eval=grid)
        assert (run.y[at[1]][1:] > 0.0).all()
        seen |= dict(zip(np.round(run.t, 6), run.y.T))
        y = run.y[:, -1]
    names = [name for name in plant.names if name not in ("l_R", "v_R")]
    wanted = dict(zip(plant.names, np.array([seen[time] for time in sorted(seen)]).T))
    for standard, path in paths.items():
        assert not validate_fmu(path)
        for kind in KINDS:
            run = simulate_fmu(path, fmi_type=kind, stop_time=8.0, output_interval=0.25, relative_tolerance=1e-11, output=[*names, "M_ws"],
                               record_events=False)
            apart = {name: np.abs(run[name] - wanted[name]).max() / np.ptp(wanted[name]) for name in names}
            print(standard, kind, apart)
            assert np.abs(run["M_ws"]).max() > 1e5
            assert max(apart.values()) <= 1e-7, (standard, kind)


@pytest.mark.parametrize("standard", ENDS)
def test_a_controller_holds_it_against_the_wind(tmp_path, standard):
    """At rest from the start: its moment is that of the wind."""
    text = exposed(by_speed(rows=[[(0.0, 0.0)]] * 3))
    for kind in KINDS:
        run = simulate_fmu(written(tmp_path, "PortalBySpeed", text)[standard], fmi_type=kind, stop_time=3.0, output_interval=0.5,
                           output=["omega_sl", "M_sl", "M_ws"], record_events=False)
        assert np.abs(run["omega_sl"]).max() <= 1e-12
        assert np.abs(run["M_sl"] + moment(18.0, math.radians(70.0), 0.0)).max() <= 1e-3
        assert np.abs(run["M_ws"] - moment(18.0, math.radians(70.0), 0.0)).max() <= 1e-3


@pytest.mark.parametrize("standard", ENDS)
def test_friction_and_brake_hold_it_up_to_their_sum(tmp_path, standard):
    """A wind that turns it breaks it loose where its moment is that of dry friction, and no sooner: an event at its time."""
    gust = '{ between = "linear", over = [["0 s", "0 m/s"], ["20 s", "20 m/s"]] }'
    text = put(exposed(PORTAL, gust, "90 deg"), r"^M_sl .*?$", "")
    text = put(put(text, r"^v_h .*?$", 'v_h = "0 m/s"'), r"^M_A .*?$", 'M_S = "5000 kN.m"')
    loose = math.sqrt(30e3 / (0.5 * RHO * AREA * PLACE))
    for kind in KINDS:
        run = simulate_fmu(written(tmp_path, "PortalCraneWhole", text)[standard], fmi_type=kind, stop_time=16.0, output_interval=0.1,
                           output=["omega_sl", "M_Rsl", "M_ws", "S_R"], record_events=False)
        held = run["time"] < loose - 1e-9
        assert 50 < held.sum() < 140
        assert np.abs(run["omega_sl"][held]).max() == 0.0
        assert np.abs(run["M_Rsl"] + run["M_ws"])[held].max() <= 1e-6
        assert (run["omega_sl"][run["time"] > loose + 0.2] > 0.0).all()


def cylinder():
    """The crane that a cylinder luffs, on a slewing ring."""
    text = (ROOT / "models/scenes/luffing_cylinder.toml").read_text(encoding="utf-8")
    return text + '\n[slewing]\nJ_sl = "9000000 kg.m2"\nc_sl = "600 kN.m.s"\nM_sl = "200 kN.m"\n'


def test_it_acts_beside_oil(tmp_path):
    """The same for the wind as for a drive that gives the same: acceleration of slewing, at a start with the load at rest."""
    names = ["der(omega_sl)", "M_ws"]
    paths = written(tmp_path, re.search(r'(?m)^name += "(\w+)"', cylinder())[1], exposed(cylinder()))
    fmu = Stepped(paths["FMI 3"])
    blown, push = fmu.get(names)
    fmu.slave.setFloat64([fmu.references["v_air"]], [0.0])
    calm, nothing = fmu.get(names)
    fmu.slave.setFloat64([fmu.references["M_sl"]], [200e3 + push])
    driven, _ = fmu.get(names)
    fmu.close()
    assert nothing == 0.0 and abs(push) > 1e4 and abs(blown - calm) > 1e-4
    assert driven == pytest.approx(blown, rel=1e-12)


def test_derivatives_of_the_moment(tmp_path):
    fmu = Stepped(written(tmp_path, "PortalCraneWhole", exposed(smooth(PORTAL)))["FMI 3"])
    fmu.run([0.0, 1.0], ["omega_sl"])
    psi, chi = fmu.get(["psi_sl"])[0], math.radians(70.0)
    most = moment(18.0, math.pi / 2, 0.0)
    wanted = {"psi_sl": -most * math.cos(chi - psi), "chi_air": most * math.cos(chi - psi), "v_air": 2.0 * moment(18.0, chi, psi) / 18.0,
              "A_ws": moment(18.0, chi, psi) / AREA, "r_ws": moment(18.0, chi, psi) / PLACE, "rho_air": moment(18.0, chi, psi) / RHO}
    per_drive = fmu.slave.getDirectionalDerivative([fmu.references["der(omega_sl)"]], [fmu.references["M_sl"]], [1.0])[0]
    for known, slope in wanted.items():
        found = fmu.slave.getDirectionalDerivative([fmu.references[name] for name in ("M_ws", "der(omega_sl)")], [fmu.references[known]], [1.0])
        assert found[0] == pytest.approx(slope, rel=1e-13), known
        if known != "psi_sl":
            assert found[1] == pytest.approx(slope * per_drive, rel=1e-10), known
    fmu.close()


@pytest.mark.parametrize("standard", ENDS)
def test_any_communication_step_gives_the_same_bits(tmp_path, standard):
    gust = '{ between = "linear", over = [["0 s", "4 m/s"], ["5 s", "25 m/s"], ["12 s", "-9 m/s"]] }'
    found = same_bits(written(tmp_path, "PortalBySpeed", exposed(by_speed(), gust))[standard], 1200, 7)
    assert found[1200] != found[0]


def test_a_crane_without_it_has_nothing_of_it(tmp_path):
    [path, _] = written(tmp_path, "PortalCraneWhole", PORTAL).values()
    names = {variable.name for variable in read_model_description(path).modelVariables}
    assert not names & {"A_ws", "r_ws", "M_ws", "p_ws", "v_air", "chi_air", "rho_air"}


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_the_book_tells_of_it(tmp_path, language):
    known = words(language)
    books = []
    for name, text in (("windy", exposed(PORTAL)), ("calm", PORTAL)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "scene.toml").write_text(text, encoding="utf-8")
        lemnis("book", tmp_path / name / "scene.toml", "--format", "typ", "--language", language, "--output", tmp_path / name)
        [page] = (tmp_path / name).glob("*.typ")
        books.append(page.read_text(encoding="utf-8"))
    windy, calm = books
    told = [known["assumption"]["wind_aside_in_motion"], known["symbol"]["M_ws"] if language != "en" else "Moment of the wind on all that slews",
            'M_"ws"']
    for text in told:
        assert text in windy and text not in calm, text

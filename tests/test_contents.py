"""What the standards describe besides the functions: terminals, icons, documentation, derivatives."""

import csv
import math
import re
import tomllib
import zipfile
from html.parser import HTMLParser
from importlib.resources import files
from xml.etree import ElementTree

import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.fmi1 import FMICallException
from lxml import etree

from conftest import ROOT, lemnis, words
from test_fmpy import Slave
from test_levels import LEVELS, scene

DISCARD, ERROR = 2, 3
DERIVATIVES = ROOT / "tests/oracles/lemniscate_derivatives.csv"


@pytest.fixture
def slave(fmu, tmp_path):
    crane = Slave(fmu, str(tmp_path / "unzipped"))
    yield crane
    crane.fmu.freeInstance()


@pytest.mark.parametrize("suffix", ["fmu", "fmi2.fmu"])
def test_terminals_and_icons(out, suffix):
    """FMI 2.0.4 takes the folder of FMI 3 as it is, beside its own icon."""
    schema = etree.XMLSchema(file=str(files("fmpy") / "schema/fmi3/fmi3TerminalsAndIcons.xsd"))
    path = out / f"LemniscateCrane.{suffix}"
    variables = {v.name for v in read_model_description(str(path)).modelVariables}
    with zipfile.ZipFile(path) as archive:
        document = etree.fromstring(archive.read("terminalsAndIcons/terminalsAndIcons.xml"))
        assert archive.read("terminalsAndIcons/icon.png")[:8] == b"\x89PNG\r\n\x1a\n"
        assert ElementTree.fromstring(archive.read("terminalsAndIcons/icon.svg")).tag.endswith("svg")
        assert ("model.png" in archive.namelist()) == (suffix == "fmi2.fmu")
    schema.assertValid(document)
    members = {t.get("name"): {m.get("variableName") for m in t} for t in document.iter("Terminal")}
    assert set(members) == {"head", "shaft", "drive"}
    assert set.union(*members.values()) <= variables
    assert members["shaft"] == {"theta_1", "omega_1", "M_D"}


class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.links, self.words, self.open = [], [], []

    def handle_starttag(self, tag, attributes):
        if tag not in ("meta", "br"):
            self.open.append(tag)
        self.links += [value for key, value in attributes if key == "href"]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.words.append(data)


def test_the_documentation(fmu):
    """Every variable stands in it, every link leads somewhere, and the licences are there."""
    variables = [v.name for v in read_model_description(fmu).modelVariables if not v.dimensions]
    with zipfile.ZipFile(fmu) as archive:
        names = archive.namelist()
        page = Page()
        page.feed(archive.read("documentation/index.html").decode("utf-8"))
        assert "MIT OR Apache-2.0" in archive.read("documentation/licenses/license.txt").decode()
        assert archive.read("documentation/LemniscateCrane.pdf").startswith(b"%PDF")
    assert page.open == [] and "LemniscateCrane.pdf" in page.links
    for link in page.links:
        assert f"documentation/{link}" in names, link
    for name in variables:
        assert name == "time" or name in page.words, name


WORDS = words("en")["assumption"]
# What must be said of each level, and what would be wrong.
SAID = {
    "table": ({"level_table", "forces"}, {"level_static", "forces_in_motion", "sticking", "oil"}),
    "lemniscate": ({"level_static", "forces"}, {"level_rigid", "rope", "sticking"}),
    "portal_004_motion": ({"level_swing", "slack", "hoist", "slewing", "counterweight", "stops", "forces_in_motion"},
                          {"oil", "creep", "forces"}),
    "slewing_swing": ({"slewing_level_swing", "slewing_hook"}, {"slewing_level_rigid", "slewing_load", "slewing_coupling"}),
    "ellipsograph": ({"ellipsograph_rope"}, {"slewing_load"}),
    "ellipsograph_motion": ({"level_swing", "ellipsograph_masses", "counterweight", "slack", "hoist_ramp", "forces_in_motion"},
                            {"level_rigid", "ellipsograph_load", "ellipsograph_forces"}),
    "ellipsograph_cylinder": ({"level_hydraulic", "ellipsograph_masses", "rope", "oil", "anti_cavitation", "creep", "buffer", "forces_in_motion",
                               "solver_rodas"}, {"level_swing", "ellipsograph_load", "load_holding", "sticking", "stops", "solver_runge_kutta"}),
    "rope_motion": ({"level_swing", "rope_masses", "rope_led", "rope_winch", "hoist_ramp", "rope_at_rest"},
                    {"rope_load", "forces_in_motion", "rope_forces"}),
    "rope_slewing": ({"level_swing", "rope_masses", "rope_led", "rope_winch", "hoist_ramp", "slewing", "wind_aside_in_motion"},
                     {"rope_load", "slope_under_slewing", "air"}),
    "curved_trunk": ({"trunk_rope"}, {"ellipsograph_rope", "led_rope"}),
    "led_rope": ({"level_swing", "bodies", "led_rope", "led_rope_moves", "hoist_ramp", "forces_in_motion"}, {"rope_load", "rope_led", "slewing"}),
    "curved_trunk_motion": ({"level_swing", "trunk_masses", "trunk_taut", "counterweight", "slack", "hoist_ramp", "forces_in_motion"},
                            {"level_rigid", "trunk_load", "trunk_forces"}),
    "portal_004_braked": ({"level_swing", "rope", "sticking", "motor_shaft", "shaft_brakes", "wind_in_motion", "slope_in_motion",
                           "forces_in_motion"}, {"fixed_load", "slewing"}),
    "rigid": ({"level_rigid", "fixed_load", "sticking", "solver_runge_kutta", "forces_in_motion"}, {"rope", "hoist", "slewing"}),
    "hydraulic": ({"level_hydraulic", "oil", "creep", "buffer", "solver_rodas"},
                  {"rope", "sticking", "stops", "anti_cavitation", "load_holding", "pump_limits", "tank"}),
    "luffing_cylinder": ({"level_hydraulic", "oil", "anti_cavitation", "load_holding", "pump_limits", "tank", "rope"}, {"sticking", "stops"}),
    "hydraulic_swing_slewing": ({"level_hydraulic", "rope", "hoist", "slewing"}, {"fixed_load", "stops"}),
    "portal_crane": ({"level_swing", "elastic_rope", "hoist_ramp", "slewing"}, {"rope", "slack", "hoist", "hoist_motor"}),
    "portal_by_speed": ({"level_swing", "elastic_rope", "hoist_motor", "slewing", "control", "control_to_place"}, {"rope", "hoist_ramp"}),
    "slewing_by_speed": ({"slewing_level_swing", "control"}, {"slewing_load", "control_to_place"}),
    "load_on_ground": ({"level_swing", "elastic_rope", "hoist_ramp", "ground"}, {"rope", "slack", "air"}),
    "boat_hoist_003": ({"level_kinematic", "resistance"}, {"level_turning", "forces"}),
    "boat_hoist_003_hydraulic": ({"level_turning", "resistance"}, {"level_kinematic"}),
    "car_4x2": ({"level_kinematic"}, {"level_turning"}),
}
# Where the coordinate's name does not begin with theta.
COORDINATES = {"slewing_swing": "psi_sl", "slewing_by_speed": "psi_sl", "ellipsograph": "phi", "ellipsograph_motion": "phi", "ellipsograph_cylinder": "phi", "rope_motion": "phi", "rope_slewing": "phi", "curved_trunk": "phi",
               "curved_trunk_motion": "phi"}


@pytest.mark.parametrize("name", SAID)
def test_the_first_page_says_what_this_fmu_is(name, tmp_path):
    """Its level and assumptions in the words of the books, its default experiment, and its inputs with their starts."""
    path = ROOT / f"models/scenes/{name}.toml"
    if not path.exists():
        text = scene(name) if name in LEVELS else path.with_stem("lemniscate").read_text(encoding="utf-8").replace(
            "driven =", 'fidelity = "table"\ndriven =', 1)
        path = tmp_path / "scene.toml"
        path.write_text(text, encoding="utf-8")
    lemnis("fmu", path, "--output", tmp_path)
    model = tomllib.loads(path.read_text(encoding="utf-8"))["name"]
    for standard in ("", ".fmi2"):
        fmu = str(tmp_path / f"{model}{standard}.fmu")
        with zipfile.ZipFile(fmu) as archive:
            page = Page()
            page.feed(archive.read("documentation/index.html").decode("utf-8"))
        whole = " ".join("".join(page.words).split())
        names = {"$h$": "step", "$g$": "g", "$omega_c$": "omega_c", "$a_h$": "a_h", "$c_R$": "c_R", "$d_R$": "d_R", "$M_D$": "M_D", "$M_A$": "M_A",
                 "$R$": "R", "$X_8 = 0$": "X_8 = 0", "$C$": "C", "$O_1$": "O_1", "$A$": "A", "$B$": "B", "$v_h$": "v_h", "$M_S$": "M_S", "$d_Q$": "d_Q", '$Q_"air"$': "Q_air",
                 "$S_R$": "S_R", "$T$": "T", '$T_"dyn"$': "T_dyn", '$p_"ac"$': "p_ac", '$p_"lh"$': "p_lh", '$i_"lh"$': "i_lh",
                 '$Delta p_"lh"$': "dp_lh", "$x_T$": "x_T", '$p_"tank"$': "p_tank", "$Q_(P,max)$": "Q_Pmax", "$P_(P,max)$": "P_Pmax", "$c_A$": "c_A", "$k_A$": "k_A", "$J_M$": "J_M",
                 "$tau_b$": "tau_b", '$sigma_"m"$': "sigma_m", "$phi_R$": "phi_R", '$M_"lim"$': "M_lim",
                 '$J_"d"$': "J_d", "$J_0$": "J_0", '$M_"F sl"$': "M_Fsl", '$c_"sl"$': "c_sl", '$gamma_"s"$': "gamma_s", "$G_u$": "G_u", "$r_u$": "r_u"}
        plain = {id: re.sub(r"\$.*?\$", lambda found: names[found.group()], words) for id, words in WORDS.items()}
        said, wrong = SAID[name]
        assert [id for id in said if plain[id] not in whole] == [] and [id for id in wrong if plain[id] in whole] == []
        description = read_model_description(fmu)
        inputs = [v for v in description.modelVariables if v.causality == "input" and not v.dimensions]
        section = whole.split("NameMeaningStart")[1].split("Use")[0]
        assert inputs and all(v.name + v.description in section for v in inputs)
        experiment = description.defaultExperiment
        assert f"{float(experiment.stopTime):g} s" in whole
        assert f"The communication step is {float(experiment.stepSize):.9g} s." in whole
        # The coordinate runs by itself where it is an input, and nowhere else.
        coordinate = next(v for v in description.modelVariables if v.name.startswith(COORDINATES.get(name, "theta")))
        assert (f"is set, {coordinate.name} runs by itself" in whole) == (coordinate.causality == "input")
        assert ("moves by its equations alone" in whole) == (coordinate.causality != "input")


def test_a_hostile_title_stays_text(tmp_path):
    scene = (ROOT / "models/scenes/lemniscate.toml").read_text(encoding="utf-8")
    (tmp_path / "scene.toml").write_text(scene.replace("Lemniscate level-luffing crane 16 t × 30 m", "<script>{{ 7*7 }}</script>"), encoding="utf-8")
    lemnis("fmu", tmp_path / "scene.toml", "--output", tmp_path)
    with zipfile.ZipFile(tmp_path / "LemniscateCrane.fmu") as archive:
        page = archive.read("documentation/index.html").decode("utf-8")
        assert b"&lt;script&gt;{{ 7*7 }}" in archive.read("modelDescription.xml")
    assert "<script>" not in page and "{{ 7*7 }}" in page


def test_types_units_and_bounds(fmu):
    description = read_model_description(fmu)
    variables = {v.name: v for v in description.modelVariables}
    for variable in variables.values():
        if variable.type in ("Real", "Float64"):
            assert variable.declaredType is not None and variable.declaredType.quantity, variable.name
            assert variable.min is None or variable.start is None or float(variable.min) <= float(variable.start)
    theta = variables["theta_1"]
    # The dead points of the crane: 48.95968 and 231.78231 degrees.
    assert abs(math.degrees(float(theta.min)) - 48.95968) < 5e-6
    assert abs(math.degrees(float(theta.max)) - 231.78231) < 5e-6
    assert (theta.declaredType.unit, theta.declaredType.displayUnit) == ("rad", "deg")
    assert variables["M_Q"].declaredType.quantity == "Torque"
    assert variables["G_1"].variability == "tunable" and variables["X_1"].variability == "fixed"
    assert float(variables["R"].nominal) == 10.0


def test_version_and_scene_can_be_read(fmu, slave):
    description = read_model_description(fmu)
    strings = {v.name: v for v in description.modelVariables if v.type == "String"}
    assert set(strings) == {"lemnis.version", "lemnis.scene"}
    for variable in strings.values():
        [value] = slave.fmu.getString([variable.valueReference])
        assert (value if isinstance(value, str) else value.decode()) == variable.start


def test_directional_derivatives(fmu, slave):
    """Against the 50-digit references, every result by every quantity at one angle."""
    with open(DERIVATIVES) as file:
        rows = [row for row in csv.DictReader(file) if row["theta_1"] == "1.1"]
    slave.write("theta_1", 1.1)
    knowns = sorted({row["known"] for row in rows})
    outputs = sorted({row["output"] for row in rows})
    expected = {(row["output"], row["known"]): float(row["derivative"]) for row in rows}
    values = {row["output"]: float(row["value"]) for row in rows}
    unknown = [slave.references[name] for name in outputs]
    for known in knowns:
        derivatives = slave.fmu.getDirectionalDerivative(unknown, [slave.references[known]], [1.0])
        size = max(abs(slave.read(known)), 0.1)
        for output, derivative in zip(outputs, derivatives, strict=True):
            reference = expected[output, known]
            assert abs(derivative - reference) <= 1e-13 * max(abs(reference), abs(values[output]) / size), (output, known)


def test_adjoint_derivatives_are_the_transpose(out, tmp_path):
    crane = Slave(str(out / "LemniscateCrane.fmu"), str(tmp_path / "unzipped"))
    crane.write("theta_1", 1.3)
    reference = crane.references
    knowns = [reference[name] for name in ("theta_1", "Q", "X_1", "G_2", "s_d")]
    # The vector A counts as its two parts.
    unknowns, parts = [reference["A"], reference["M_D"]], [reference[name] for name in ("A.x", "A.y", "M_D")]
    weights = [0.5, -2.0, 1e-3]
    columns = [crane.fmu.getDirectionalDerivative(parts, [known], [1.0]) for known in knowns]
    expected = [sum(w * d for w, d in zip(weights, column)) for column in columns]
    adjoint = crane.fmu.getAdjointDerivative(unknowns, knowns, weights, len(knowns))
    for found, value in zip(adjoint, expected, strict=True):
        assert abs(found - value) <= 1e-15 * max(1.0, abs(value))
    crane.fmu.freeInstance()


def test_statuses_at_the_edge(fmu, slave):
    """What the standards prescribe, one message in plain words, and a nearest value that works."""
    fmi3 = fmu.endswith("Crane.fmu")
    slave.step(0.0, 1.0)
    reach = slave.read("R")
    for angle in (math.radians(45), math.radians(-100), math.radians(232)):
        slave.messages.clear()
        slave.write("theta_1", angle)
        with pytest.raises(FMICallException) as failure:
            slave.step(1.0, 1.0)
        # FMI 3: the call came to nothing and may be tried again. FMI 2: a step that was not carried out at all.
        assert failure.value.status == (DISCARD if fmi3 else ERROR)
        [message] = [text for text in slave.messages if "theta_1" in text]
        nearest = re.search(r"theta_1 = \S+ deg: .* closes for .*; the nearest angle is (\S+) deg", message)
        slave.write("theta_1", math.radians(float(nearest[1])))
        slave.step(1.0, 1.0)
        slave.fmu.reset()
        slave.initialize()
        slave.step(0.0, 1.0)
        assert slave.read("R") == reach
    slave.messages.clear()
    with pytest.raises(FMICallException) as failure:
        slave.write("Q", -1.0)
    assert failure.value.status == DISCARD
    assert slave.messages[-1].count("Q = -0.001 kN is not allowed: it must be") == 1, slave.messages


def test_tunable_and_fixed_parameters(slave):
    slave.write("theta_1", math.radians(75))
    slave.step(0.0, 1.0)
    moment = slave.read("M_G")
    slave.write("G_1", 2 * slave.read("G_1"))
    slave.step(1.0, 1.0)
    # The boom's own part is linear in its weight: s_1 cos(75 deg) times 196.2 kN.
    assert abs(slave.read("M_G") - moment - 196.2e3 * 9.65 * math.cos(math.radians(75))) < 1e-6
    with pytest.raises(FMICallException) as failure:
        slave.write("X_1", 19.0)
    assert failure.value.status == ERROR
    assert "X_1 is a parameter: it can be set before the end of initialization only" in slave.messages[-1]


def test_lengths_that_do_not_close_are_explained(slave):
    """Parameters are checked together, when initialization ends."""
    slave.fmu.reset()
    slave.messages.clear()
    slave.write("X_3", 2.0)
    with pytest.raises(FMICallException):
        slave.initialize()
    assert "X_2 and X_3 reach from 4.5 m to 8.5 m" in slave.messages[-1], slave.messages
    slave.fmu.reset()
    slave.initialize()
    slave.step(0.0, 1.0)


def test_model_exchange_holds_truth_values_between_events(fmu):
    """A discrete variable changes at events only; there is none here, so it stays as it was at the start."""
    result = simulate_fmu(fmu, fmi_type="ModelExchange", output=["P.at_infinity", "theta_1", "theta_3"])
    assert not result["P.at_infinity"].any()
    # theta_1 = theta_3 at 89.226 deg lies between.
    assert result["theta_1"][0] > result["theta_3"][0] and result["theta_1"][-1] < result["theta_3"][-1]


def test_irregular_and_repeated_steps(fmu, slave, tmp_path):
    """What comes out depends on where one is, not on the steps that led there; a repeated step gives the same bits."""
    names, time = ("theta_1", "R", "M_Q", "F_d"), 0.0
    for size in [1e-9, 0.3, 7.0, 1e-3, 12.345, 0.0001, 20.0]:
        state = slave.fmu.getFMUState()
        slave.step(time, size)
        first = [slave.read(name) for name in names]
        slave.fmu.setFMUState(state)
        slave.step(time, size)
        assert [slave.read(name) for name in names] == first
        slave.fmu.freeFMUState(state)
        time += size
        at_once = Slave(fmu, str(tmp_path / "unzipped"))
        at_once.step(0.0, time)
        assert [at_once.read(name) for name in names] == first
        at_once.fmu.freeInstance()

"""Nothing from nowhere: every symbol of a printed formula is in the notation, and every given quantity has its use.

The book's Typst source is read, in its full and its standard level, for every ready scene.
"""

import re

import numpy
import pytest
import tomllib

from conftest import ROOT, lemnis

SCENES = sorted(path.stem for path in (ROOT / "models/scenes").glob("*.toml"))
# What a formula has beside symbols.
FUNCTIONS = {"frac", "sqrt", "abs", "sin", "cos", "arcsin", "arccos", "arctan2", "pi", "slash", "more", "dot"}
# What is given and stands in no formula, and what it is used for.
USES = {
    "ends of the working range, which tables and curves run over": ["theta_a", "theta_e", "phi_a", "phi_e"],
    "limits, which requirements are judged by": [
        "abs(Delta M)_max", "abs(N_1)_max", "gamma_min", "mu_min", "epsilon_Y", "sigma_lim", "v_(c,max)", "T_max",
    ],
    "ranges of the groups, which the margins of the tables are counted to": ["theta_min", "theta_max"],
    "outline, of which the width of the swept lane is a result": ["x_(e F)", "x_(e R)", "y_(e L)", "y_(e R)"],
    "annulus of a cylinder that shortens": ["d_r"],
    "gravity, by which masses are weighed": ["g"],
    "start of the run": ["l_R"],
    "hoist of the run": ["a_h", "v_h"],
    "slewing's inertia within that of the whole": ['J_"sl"'],
}


def source(scene, level, folder):
    """Without the words for screen readers."""
    folder.mkdir(exist_ok=True)
    lemnis("book", ROOT / f"models/scenes/{scene}.toml", "--level", level, "--format", "typ", "--output", folder)
    [path] = folder.glob("*.typ")
    text = path.read_text(encoding="utf-8").split("#let column-head")[1]
    return re.sub(r'(?s)#say\("(?:[^"\\]|\\.)*"\)\[(\$.*?\$)\];', r"\1", text)


def chapter(text, title):
    return re.search(rf"(?ms)^= \d+ {title}\n(.*?)(?=^= \d|\Z)", text)[1]


def formulas(text):
    """Of every formula what it gives, and the formula in symbols."""
    for step in re.split(r"\n#step\([^)\n]*\)\[", text)[1:]:
        body = step[step.index("[$") + 2 : step.index("$]")]
        result, formula = body.split("&=", 1)
        yield result.strip(), re.split(r"\n\s+(?:\\ &)?= |\\\n", formula)[0]


def symbols(formula, known):
    """The known symbols of a formula, and what is left of it."""
    linked = re.findall(r'go\("((?:[^"\\]|\\.)*)", ', formula)
    found = {name.replace('\\"', '"') for name in linked}
    for name in linked:
        formula = formula.replace(f'go("{name}", ' + name.replace('\\"', '"') + ")", " ")
    for name in sorted(known, key=len, reverse=True):
        pattern = rf"(?<![\w'])" + re.escape(name) + r"(?![\w'])"
        formula, count = re.subn(pattern, " ", formula)
        if count:
            found.add(name)
    return found, set(re.findall(r"[A-Za-z][\w']*", formula)) - FUNCTIONS


@pytest.mark.parametrize("level", ["standard", "full"])
@pytest.mark.parametrize("scene", SCENES)
def test_every_symbol_of_a_formula_is_in_the_notation(scene, level, tmp_path):
    text = source(scene, level, tmp_path)
    notation = set(re.findall(r"(?m)^  \[\$(.*?)\$\], \[", chapter(text, "Notation")))
    count = 0
    for result, formula in formulas(text):
        found, left = symbols(formula, notation)
        assert not left and found <= notation, (result, formula, left, found - notation)
        count += bool(found)
    assert count > 10


@pytest.mark.parametrize("scene", SCENES)
def test_every_given_quantity_is_used(scene, tmp_path):
    """By a formula, or for what is known; or its table says that the book does not calculate with it. Weights of zero, as the
    chapter says, are in no formula."""
    text = source(scene, "full", tmp_path)
    notation = set(re.findall(r"(?m)^  \[\$(.*?)\$\], \[", chapter(text, "Notation")))
    used = set().union(*(symbols(formula, notation)[0] for _, formula in formulas(text)))
    used |= {symbol for symbols in USES.values() for symbol in symbols}
    unused = []
    for table in re.split(r"(?m)^== ", chapter(text, "Given quantities"))[1:]:
        given = re.findall(r'(?m)^  \[(?:#define\("(.*?)"\))?\$(.*?)\$\],$', table)
        # Of several groups the formulas speak of one: x_2 is x_i.
        names = [(name or shown).replace('\\"', '"') for name, shown in given]
        numbered = [re.sub(r"^([xyG])_[2-9]$", r"\1_i", name) for name in names]
        nothing = set(re.findall(r'\$(\S*)\$\],\n.*\n  \[\$0 thin"kN"\$\]', table))
        idle = [name for name, other in zip(names, numbered) if not {name, other} & used and name not in nothing]
        if "this book does not calculate with them" in table:
            assert idle == names, table
        else:
            unused += idle
    assert not unused, unused


def test_the_oil_of_a_steering_is_said_not_to_be_calculated(tmp_path):
    text = source("boat_hoist_003_hydraulic", "standard", tmp_path)
    tables = re.split(r"(?m)^== ", chapter(text, "Given quantities"))[1:]
    idle = [table.splitlines()[0] for table in tables if "this book does not calculate with them" in table]
    assert [re.sub(r"^[\d.]+ (.*?) #h.*", r"\1", title) for title in idle] == ["Groups in motion", "Oil and valves", "Control loop"]
    assert "this book does not calculate with them" not in source("portal_004_motion", "standard", tmp_path / "other")


def test_the_loads_of_the_groups_follow_from_the_weight(tmp_path):
    """A plane over the groups, by least squares, whose sum and moments are those of the weight."""
    given = tomllib.loads((ROOT / "models/scenes/boat_hoist_003.toml").read_text(encoding="utf-8"))["steering"]
    number = lambda text: float(text.split()[0])
    x, y = (numpy.array([number(group[axis]) for group in given["groups"]]) for axis in "xy")
    load = given["load"]
    weight, x_g, y_g = (number(load[key]) for key in ["W", "x_G", "y_G"])
    plane = numpy.array([numpy.ones_like(x), x, y])
    moments = weight * numpy.array([1, x_g, y_g])
    expected = plane.T @ numpy.linalg.solve(plane @ plane.T, moments)
    text = source("boat_hoist_003", "standard", tmp_path)
    section = text[text.index("Loads of the groups") :]
    rows = re.findall(r"(?m)^  \[(\d)\],\[(−?\d+)\],\[(−?\d+)\],\[(\d+)\],", section)[: len(x)]
    table = numpy.array([[float(cell.replace("−", "-")) for cell in row] for row in rows])
    assert (table[:, 1] == x).all() and (table[:, 2] == y).all()
    assert abs(table[:, 3] - expected).max() <= 0.5
    printed = re.search(r'(?s)G_max &= .*?\\ &= ([\d.]+) thin"kN" \$\]', section)[1]
    assert abs(float(printed) - expected.max()) <= 0.005

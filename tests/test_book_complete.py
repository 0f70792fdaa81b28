"""Nothing from nowhere: every symbol of a printed formula is in the notation and has its origin, and every given quantity
has its use.

The book's Typst source is read, in its full and its standard level, for every ready scene.
"""

import re
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy
import pytest
import tomllib

from conftest import ROOT, lemnis, typst, words

SCENES = sorted(path.stem for path in (ROOT / "models/scenes").glob("*.toml"))
# What a formula has beside symbols.
FUNCTIONS = {
    "frac", "sqrt", "abs", "sin", "cos", "arcsin", "arccos", "arctan2", "pi", "slash", "more", "dot", "max", "min", "sum_i", "dif", "integral",
}


@cache
def source(scene, level):
    """Without the words for screen readers."""
    with TemporaryDirectory() as folder:
        lemnis("book", ROOT / f"models/scenes/{scene}.toml", "--level", level, "--format", "typ", "--output", folder)
        [path] = Path(folder).glob("*.typ")
        text = typst(path).split("#let column-head")[1]
    return re.sub(r'(?s)#say\("(?:[^"\\]|\\.)*"\)\[(\$.*?\$)\];', r"\1", text)


def chapter(text, title):
    return re.search(rf"(?ms)^= \d+ {title}\n(.*?)(?=^= \d|\Z)", text)[1]


def formulas(text):
    """Of every formula what it gives, and the formula in symbols; nothing where a search has found the number."""
    text = text.replace(" dif t $]", " $]")  # what works are integrated over
    for step in re.split(r"\n#step\([^)\n]*\)\[", text)[1:]:
        body = step[step.index("[$") + 2 : step.index("$]")]
        result, formula = body.split("&=", 1)
        formula, *rest = re.split(r"\n\s+(?:\\ &)?= |\\\n", formula)
        yield result.strip(), formula if rest else ""


@cache
def searched(known):
    """Of every known symbol, the longest first, the pattern that finds it, and the symbol: one of several, x_1, is x_i."""
    several = {re.sub(r"i(\)?)$", rf"{number}\1", name): name for name in known if name[-2:] in ("_i", "i)") for number in range(1, 10)}
    names = {**several, **{name: name for name in known}}
    return [(name, re.compile(rf"(?<![\w'])" + re.escape(name) + r"(?![\w'])"), names[name]) for name in sorted(names, key=len, reverse=True)]


def symbols(formula, known):
    """The known symbols of a formula, and what is left of it."""
    linked = re.findall(r'go\("((?:[^"\\]|\\.)*)", ', formula)
    found = {name.replace('\\"', '"') for name in linked}
    for name in linked:
        formula = formula.replace(f'go("{name}", ' + name.replace('\\"', '"') + ")", " ")
    for name, pattern, symbol in searched(frozenset(known)):
        if name in formula:
            formula, count = pattern.subn(" ", formula)
            if count:
                found.add(symbol)
    return found, set(re.findall(r"[A-Za-z][\w']*", formula)) - FUNCTIONS


@pytest.mark.parametrize("level", ["standard", "full"])
@pytest.mark.parametrize("scene", SCENES)
def test_every_symbol_of_a_formula_is_in_the_notation(scene, level):
    text = source(scene, level)
    notation = set(re.findall(r"(?m)^  \[\$(.*?)\$\], \[", chapter(text, "Notation")))
    count = 0
    for result, formula in formulas(text):
        found, left = symbols(formula, notation)
        # Constants of formulas have few digits: what has many is a quantity without its name.
        assert not re.search(r"\d\.\d{4}", formula), (result, formula)
        assert not left and found <= notation, (result, formula, left, found - notation)
        count += bool(found)
    assert count > 10


def given(text):
    """The symbols of each table of given quantities: as defined and as shown, with the table."""
    for table in re.split(r"(?m)^== ", chapter(text, "Given quantities"))[1:]:
        symbols = re.findall(r'(?m)^  \[(?:#define\("(.*?)"\))?\$(.*?)\$\],(?=\n  \[[^$#])', table)
        yield table, [((name or shown).replace('\\"', '"'), shown) for name, shown in symbols]


def tabled(text, caption):
    """The symbols of the first columns of all tables of a caption, as far as the book has any."""
    tables = re.findall(rf"(?s)#titled\(\d+\)\[{caption}\]\n(.*?)\n\)\n", text)
    return {name for table in tables for name in re.findall(r"(?m)^  \[\$(.*?)\$\], \[", table)}


@pytest.mark.parametrize("level", ["standard", "full"])
@pytest.mark.parametrize("scene", SCENES)
def test_every_symbol_of_a_formula_has_its_origin(scene, level):
    """It is given, stands on the left of a formula, is the coordinate of the position, one of the states and commands at the
    instant, a constant of the equations or a result of the run, which are tabled, taken from what moves it, or a point of the curves that a table lists."""
    text = source(scene, level)
    notation = set(re.findall(r"(?m)^  \[\$(.*?)\$\], \[", chapter(text, "Notation")))
    known = {name for _, symbols in given(text) for pair in symbols for name in pair}
    known |= {result for result, _ in formulas(text)}
    # Of several that are all told of each has its number.
    known |= {re.sub(r"\d(\)?)$", r"i\1", result) for result, _ in formulas(text)} & notation
    known |= set(re.findall(r"(?m)^= \d+ [^\n]*?: \$(.*?) = ", text))
    for caption in ["States and commands at the instant", "Constants of the equations", "Energy", "Envelope of forces",
                    "What the formulas take from places and bodies",
                    "What the formulas take from support, drive and commands"]:
        known |= tabled(text, caption)
    # Points of the ring's curves, loads by strength, forces in pins and heels of levers stand in tables of their own; others are read off a
    # load chart.
    known |= set(re.findall(r"column-head\[\$(\S*\(c i\)|Q_s|F_\(p k\)|phi_\(h i\))\$\]", text))
    known |= {'Q_"ch"'} if re.search(r"(?m)^= \d+ Load chart$", text) else set()
    for result, formula in formulas(text):
        nowhere = symbols(formula, notation)[0] - known
        assert not nowhere, (result, formula, nowhere)


def reasons(table):
    """What a table of given quantities says of those that are in no formula: the symbols as shown, and each reason."""
    notes = re.findall(r"(?m)#note\[In no formula stand (.*?): (.*)\]\]$", table)
    return [symbol for symbols, _ in notes for symbol in re.findall(r"\$(.*?)\$", symbols)], [reason for _, reason in notes]


@pytest.mark.parametrize("scene", SCENES)
def test_every_given_quantity_is_in_a_formula_or_the_book_says_what_it_is_for(scene):
    """Of those in no printed formula, and of no other, the line under their table says it."""
    words = tomllib.loads((ROOT / "templates/words/en/common.toml").read_text(encoding="utf-8"))["use"]
    text = source(scene, "full")
    notation = set(re.findall(r"(?m)^  \[\$(.*?)\$\], \[", chapter(text, "Notation")))
    used = set().union(*(symbols(formula, notation)[0] for _, formula in formulas(text)))
    for table, pairs in given(text):
        shown = {shown for _, shown in pairs}
        used_here = {shown for name, shown in pairs if name in used}
        # Of several groups the formulas speak of one: x_2 is x_i, G_(c 2) is G_(c i), n_("w" 2) is n_("w" i). The number of
        # another may be its name: J_2 of a bar beside J_i of a load case.
        alike = {shown for name, shown in pairs if re.sub(r'^(\w+_(?:\(["\w]+ )?)[2-9](\)?)$', r"\1i\2", name) in used} - used_here
        told, why = reasons(table)
        assert shown - used_here - alike <= set(told) <= shown - used_here and len(told) == len(set(told)), table
        assert all(len(reason) > 10 and words["none"] not in reason for reason in why)


@pytest.mark.parametrize("level", ["standard", "full"])
def test_the_oil_of_a_steering_is_calculated(level):
    """Every quantity of bodies, oil and control loop is in a formula; of the pressures every flow, of the group the moments."""
    text = source("boat_hoist_003_hydraulic", level)
    tables = {re.sub(r"^[\d.]+ (.*?) #h[^$]*", r"\1", table.splitlines()[0]): table for table, _ in given(text)}
    for title in ["Groups in motion", "Oil and valves", "Control loop"]:
        assert title in tables and reasons(tables[title])[0] in ([], ["p_R", "k_R"]), "relief valves are shut"
    results = {result for result, _ in formulas(text)}
    rates = {f"dot(p)_({side} i)" for side in ["1", "2", "A", "B"]} | {"dot(omega)_(g i)", "dot(v)_(v i)", "I_(n i)", "u_(n i)"}
    assert rates | {"Q_1", "Q_2", "Q_A", "Q_B", "Q_L", "V_A", "V_B", "f_(c i)", "M_(R i)"} <= results


def test_the_loads_of_the_groups_follow_from_the_weight():
    """A plane over the groups, by least squares, whose sum and moments are those of the weight."""
    scene = tomllib.loads((ROOT / "models/scenes/boat_hoist_003.toml").read_text(encoding="utf-8"))["steering"]
    number = lambda text: float(text.split()[0])
    x, y = (numpy.array([number(group[axis]) for group in scene["groups"]]) for axis in "xy")
    load = scene["load"]
    weight, x_g, y_g = (number(load[key]) for key in ["W", "x_G", "y_G"])
    plane = numpy.array([numpy.ones_like(x), x, y])
    moments = weight * numpy.array([1, x_g, y_g])
    expected = plane.T @ numpy.linalg.solve(plane @ plane.T, moments)
    text = source("boat_hoist_003", "standard")
    section = text[text.index("Loads of the groups") :]
    rows = re.findall(r"(?m)^  \[(\d)\],\[(−?\d+)\],\[(−?\d+)\],\[(\d+)\],", section)[: len(x)]
    table = numpy.array([[float(cell.replace("−", "-")) for cell in row] for row in rows])
    assert (table[:, 1] == x).all() and (table[:, 2] == y).all()
    assert abs(table[:, 3] - expected).max() <= 0.5
    # The formula is that of the most heavily loaded group.
    for symbol in ["G_i", "G_max"]:
        printed = re.search(rf'(?s)\n  {symbol} &= .*?= ([\d.]+) thin"kN" \$\]', section)[1]
        assert abs(float(printed) - expected.max()) <= 0.005, symbol


def test_the_ring_bears_what_its_curve_says():
    """Moment over the one that the scene's curve allows with the force, by interpolation of the scene's own points."""
    scene = tomllib.loads((ROOT / "models/scenes/boat_hoist_003.toml").read_text(encoding="utf-8"))["steering"]
    [ring] = [ring for ring in scene["ring"]["catalogue"] if ring["D_L"] == scene["ring"]["D_L"]]
    text = source("boat_hoist_003", "full")

    def value(symbol):
        step = re.search(rf"(?s)\n  {re.escape(symbol)} &= (.*?) \$\]", text)[1]
        return float(re.split(r"(?<!<)= ", step.split(" <= ")[0])[-1].split()[0])

    for curve, force, moment, allowed, use in [("ring", "F'_a", "M'", "M_(c r)", "k_1"), ("bolts", "F_b", "M_b", "M_(c b)", "k_2")]:
        points = [[float(number.split()[0]) for number in point.split(", ")] for point in ring[curve]]
        expected = numpy.interp(value(force), *zip(*points))
        assert value(allowed) == pytest.approx(expected, rel=1e-5)
        assert value(use) == pytest.approx(100 * value(moment) / expected, rel=1e-5)


# The lever's lengths have the eight digits that its search gave them.
SMALL = {"portal_004_tail": 72}


@pytest.mark.parametrize("scene", SCENES)
def test_formulas_are_set_in_readable_type(scene):
    """Those too wide for a line are set smaller: what would need less than 85 % of the type lacks a name for a part."""
    sizes = re.findall(r"#step\(size: (\d+)%", source(scene, "full"))
    assert all(int(size) >= SMALL.get(scene, 85) for size in sizes), sizes


def test_a_result_that_nothing_changes_has_no_column_and_no_ranking():
    """Of a parallelogram the height of the head."""
    text = chapter(source("parallelogram", "standard"), "Sensitivity")
    assert "R_max" in text and "epsilon_Y" not in text and "mu_min" not in text
    rankings = re.findall(r"drawn\(\d+, \"(.*?)\", alt", text)
    assert rankings and all("solid" in ranking or "more" in ranking or "less" in ranking for ranking in rankings)


@pytest.mark.parametrize("language", ["en", "zh", "bg"])
def test_what_is_on_a_bar_is_told_with_it(language, tmp_path):
    """The sheaves of a led rope, each with the bar or frame that it is on, in their order."""
    scene = ROOT / "models/scenes/led_rope.toml"
    lemnis("book", scene, "--language", language, "--format", "typ", "--output", tmp_path)
    [path] = tmp_path.glob("*.typ")
    known = words(language)
    names = {known["resistance_bodies"][name]: name for name in ("boom", "jib", "rocker", "frame")}
    told = re.findall(r"x_\(r \d\)\$.*\n  \[([^:：\n]+)(?:\\u\{3a\}|[:：])", path.read_text(encoding="utf-8"))
    given = tomllib.loads(scene.read_text(encoding="utf-8"))["luffing"]["rope"]["sheave"]
    assert [names[name] for name in told] == [sheave["on"] for sheave in given]

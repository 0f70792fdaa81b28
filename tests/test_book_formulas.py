"""Every printed formula, recalculated from the numbers printed beside it, in interval arithmetic.

The book's Typst source is read as a person with a calculator would. Every printed number stands for itself and half of
its last digit to both sides, but that a number of fewer than six digits is exact, as the book's conventions say. What
follows from the numbers of a formula by the operations printed there must meet the printed result, which is read in the
same way, and must be known to a hundredth of it. A result that is less than a billionth of the greatest term that it is
put together from is near zero because its terms cancel: it is compared with that term.
"""

import math
import re

import pytest

from conftest import ROOT, lemnis, typst
from intervals import FUNCTIONS, Interval

UNITS = {
    "": 1, "%": 0.01, "m": 1, "mm": 1e-3, "m²": 1, "rad": 1, "°": math.pi / 180, "rad/s": 1, "°/s": math.pi / 180,
    "m/s": 1, "mm/s": 1e-3, "N": 1, "kN": 1e3, "MN": 1e6, "N·m": 1, "kN·m": 1e3, "m⁴": 1, "m·rad": 1, "m·°": math.pi / 180, "kJ": 1e3, "m³/s": 1, "L/min": 1e-3 / 60,
    "kg": 1, "t": 1e3, "kg/s": 1, "t/h": 1e3 / 3600, "s/m": 1, "N·s": 1, "kN·s": 1e3, "kg·m²": 1, "t·m²": 1e3, "N·m·s": 1, "kN·m·s": 1e3, "m/s²": 1, "J/kg": 1, "rad/s²": 1, "s": 1, "1/s": 1, "1/s²": 1, "1/m": 1, "m²/t": 1e-3, "kg/m³": 1,
    "Pa": 1, "bar": 1e5, "MPa": 1e6, "m³": 1, "L": 1e-3, "cm³": 1e-6, "L/(min·MPa)": 1e-9 / 60, "MPa/s": 1e6, "kN/m": 1e3,
    "kN·s/m": 1e3, "N/m": 1, "N·s/m": 1, "ms": 1e-3, "r/min": 1 / 60, "m/min": 1 / 60, "cm": 1e-2, "kW": 1e3,
    "1/rad": 1, "1/(rad·s)": 1, "rad·s": 1,
}
LANGUAGES = ["en", "zh", "bg"]
NUMBER = re.compile(r'(?<![\w.])(\d+(?:\.\d+)?)(?: times 10\^\(?(-?\d+)\)?)?(?:(?: ?thin)? ?"([^"]*)")?')
WIDEST = 0.01
CANCELLED = 1e-9
# Rounding of the calculation itself, as a part of the greatest term.
ROUNDING = 1e-12


def read(text):
    """The interval that follows from an expression."""
    values = []

    def take(match):
        digits, power, unit = match.groups()
        factor = UNITS[unit or ""] * 10.0 ** int(power or 0)
        significant = len(digits.replace(".", "").lstrip("0"))
        half = 0.5 * 10.0 ** -len(digits.partition(".")[2]) if significant >= 6 else 0.0
        values.append(Interval.around(float(digits) * factor, half * factor))
        return f"v[{len(values) - 1}]"

    # Exponents are no numbers of their own.
    words = "ZERO ONE TWO THREE FOUR FIVE SIX".split()
    text = re.sub(r"\^(\d)", lambda found: "**" + words[int(found[1])], text.replace("\\ &more", ""))
    text = re.sub(r"\^\((\d+)\\/(\d+)\)", r"**F\1O\2", text)
    text = NUMBER.sub(take, text)
    text = re.sub(r"F(\d+)O(\d+)", r"(\1/\2)", text)
    for number, name in enumerate(words):
        text = text.replace(f"**{name}", f"**{number}")
    text = text.replace(" dot ", "*").replace(" slash ", "/")
    # Factors without a sign between them: "2 pi".
    text = re.sub(r"(v\[\d+\]) pi", r"\1*pi", text)
    assert re.fullmatch(r"[\w\s\[\]()+\-*/.,]*", text), text
    return eval(compile(" ".join(text.split()), "book", "eval"), {}, {**FUNCTIONS, "v": values})


def formulas(source):
    """Of every formula with numbers: in symbols, in numbers, and its result."""
    for step in re.split(r"\n#step\([^)\n]*\)\[", source)[1:]:
        body = step[step.index("[$") + 2 : step.index("$]")]
        parts = re.split(r"\n\s+(?:\\ &)?= ", body)
        # One that only names another quantity, or a number, has none.
        if len(parts) == 3:
            # A requirement follows the result that it judges.
            yield parts[0], parts[1], re.split(r", quad| [<>]= ", parts[2].strip())[0].strip()


def check(formula, numbers, result):
    """How far what follows from the numbers is known, as a part of the result."""
    told = f"{formula} = {numbers} = {result}"
    computed, printed = read(numbers), read(result)
    size = abs(printed.low + printed.high) / 2
    reference = computed.scale if size < CANCELLED * computed.scale else size
    slack = ROUNDING * computed.scale
    turns = (-math.tau, 0.0, math.tau) if "°" in result else (0.0,)
    assert any(
        computed.low + turn <= printed.high + slack and printed.low <= computed.high + turn + slack for turn in turns
    ), f"{told}: {computed}"
    known = computed.half / reference if computed.half else 0.0
    assert known <= WIDEST, f"{told} is known to {known:.1%} only: {computed}"
    return known


def recalculated(source):
    """How many printed formulas give their results, and the one that is known least."""
    known = {formula: check(formula, numbers, result) for formula, numbers, result in formulas(source)}
    return len(list(formulas(source))), max(known.items(), key=lambda item: item[1])


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_formula_gives_its_result(language, tmp_path, capsys):
    lemnis("book", "--level", "full", "--language", language, "--format", "typ", "--output", tmp_path)
    source = typst(tmp_path / "LemniscateCrane.typ")
    # A decimal comma stands in quotes.
    commas = re.findall(r'"\d+,\d+"', source)
    assert (len(commas) > 100) == (language == "bg")
    count, (formula, known) = recalculated(re.sub(r'"(\d+),(\d+)"', r"\1.\2", source))
    with capsys.disabled():
        print(f"\n  {language}: {count} printed formulas recalculated; known to {known:.2%} at least: {formula.split()[0]}")
    assert count > 60


@pytest.mark.parametrize("scene", sorted(path.stem for path in (ROOT / "models/scenes").glob("*.toml")))
def test_every_formula_of_the_ready_scenes_gives_its_result(scene, tmp_path, capsys):
    lemnis("book", ROOT / f"models/scenes/{scene}.toml", "--level", "full", "--format", "typ", "--output", tmp_path)
    [book] = tmp_path.glob("*.typ")
    count, (formula, known) = recalculated(typst(book))
    with capsys.disabled():
        print(f"\n  {scene}: {count} printed formulas recalculated; known to {known:.2%} at least: {formula.split()[0]}")
    assert count > 10


@pytest.mark.parametrize("scene", ["portal_004_motion", "portal_crane"])
def test_the_account_of_energy_can_be_added_up(scene, tmp_path):
    """All terms have the same decimals, those that what is left over needs, and what is left over is what they leave."""
    lemnis("book", ROOT / f"models/scenes/{scene}.toml", "--format", "typ", "--output", tmp_path)
    [book] = tmp_path.glob("*.typ")
    source = typst(book)
    # Without the words for screen readers.
    source = re.sub(r'#say\("[^"]*"\)\[(\$[^$]*\$)\];', r"\1", source)
    rows = re.findall(r'\n  \[\$([^$]+)\$\],((?: \[\$-?[\d.]+ thin"kJ"\$\],)+)', source)
    [sides] = re.findall(r"\$ (W_A .*) &= (.*) \$", source)
    symbols = [side.split(" + ") for side in sides]
    assert [symbol for symbol, _ in rows] == symbols[0] + symbols[1]
    columns = list(zip(*(re.findall(r"-?[\d.]+", cells) for _, cells in rows)))
    assert len(columns) >= 4
    for column in columns:
        [decimals] = {len(number.partition(".")[2]) for number in column}
        numbers = [float(number) for number in column]
        given, used = numbers[:len(symbols[0])], numbers[len(symbols[0]):]
        assert len(used) == 4 and abs(used[-1]) <= 1e-3 * max(map(abs, numbers))
        assert abs(sum(given) - sum(used)) <= 0.5 * 10**-decimals * len(numbers)
        assert used[-1] == 0.0 or abs(used[-1]) >= 10 * 10**-decimals


@pytest.mark.parametrize("numbers, result", [
    ('19.3 thin"m" dot cos(120"°")', '-9.651 thin"m"'),
    # The last digit is wrong.
    ('frac(254.347 thin"kN·m", 1.48165 thin"m")', '171.668 thin"kN"'),
    # Nothing is left of six digits.
    ('15.0000 thin"m" - 14.9999 thin"m"', '0.000100000 thin"m"'),
    ('arctan2(-1.00000, 1.00000)', '45"°"'),
])
def test_a_wrong_or_an_unknown_result_is_caught(numbers, result):
    with pytest.raises(AssertionError):
        check("x", numbers, result)

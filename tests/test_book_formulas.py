"""Every printed formula, recalculated from the numbers printed beside it.

The book's Typst source is read as a person with a calculator would: the
numbers of the line with numbers, with their units, put through the operations
printed there, must give the printed result, within what the rounding of the
printed digits allows.
"""

import math
import re

import pytest

from conftest import ROOT, lemnis

UNITS = {
    "": 1, "%": 0.01, "m": 1, "mm": 1e-3, "m²": 1, "rad": 1, "°": math.pi / 180, "rad/s": 1, "°/s": math.pi / 180,
    "m/s": 1, "mm/s": 1e-3, "N": 1, "kN": 1e3, "N·m": 1, "kN·m": 1e3, "kJ": 1e3, "m³/s": 1, "L/min": 1e-3 / 60,
    "kg": 1, "t": 1e3, "kg·m²": 1, "N·m·s": 1, "kN·m·s": 1e3, "m/s²": 1, "rad/s²": 1, "s": 1, "1/s": 1, "1/s²": 1,
    "Pa": 1, "bar": 1e5, "MPa": 1e6, "m³": 1, "L": 1e-3, "cm³": 1e-6, "m³/(s·Pa)": 1, "bar/s": 1e5, "kN/m": 1e3,
    "kN·s/m": 1e3, "N/m": 1, "N·s/m": 1, "ms": 1e-3, "r/min": 1 / 60, "m/min": 1 / 60, "cm": 1e-2, "kW": 1e3,
    "1/rad": 1, "1/(rad·s)": 1,
}
LANGUAGES = ["en", "zh", "bg"]
NUMBER = re.compile(r'(?<![\w.])(\d+(?:\.\d+)?)(?: times 10\^\(?(-?\d+)\)?)?(?:(?: ?thin)? ?"([^"]*)")?')
FUNCTIONS = {
    "frac": lambda a, b: a / b, "sqrt": math.sqrt, "abs": abs, "sin": math.sin, "cos": math.cos,
    "arcsin": math.asin, "arccos": math.acos, "pi": math.pi,
    # Angles are counted in (-90°, 270°].
    "arctan2": lambda y, x: (a := math.atan2(y, x)) + (2 * math.pi if a <= -math.pi / 2 else 0),
}


def read(text):
    """A Python expression over v[0], v[1], ..., the values, and half a unit of each last digit."""
    values, roundings = [], []

    def take(match):
        digits, power, unit = match.groups()
        factor = UNITS[unit or ""] * 10.0 ** int(power or 0)
        significant = len(digits.replace(".", "").lstrip("0"))
        # Six digits are rounded; fewer, or more, are the number itself.
        half = 0.5 * 10.0 ** -len(digits.partition(".")[2]) if significant == 6 else 0.0
        values.append(float(digits) * factor)
        roundings.append(half * factor)
        return f"v[{len(values) - 1}]"

    # Exponents are no numbers of their own.
    text = re.sub(r"\^(\d)", lambda found: "**" + "ZERO ONE TWO THREE FOUR FIVE SIX".split()[int(found[1])], text.replace("\\ &more", ""))
    text = NUMBER.sub(take, text)
    for number, name in enumerate("ZERO ONE TWO THREE FOUR FIVE SIX".split()):
        text = text.replace(f"**{name}", f"**{number}")
    text = text.replace(" dot ", "*").replace(" slash ", "/").replace("arctan2 vec(", "arctan2(").replace("infinity", "math.inf")
    # Factors without a sign between them: "2 pi".
    text = re.sub(r"(v\[\d+\]) pi", r"\1*pi", text)
    assert re.fullmatch(r"[\w\s\[\]()+\-*/.,]*", text), text
    code = compile(" ".join(text.split()), "book", "eval")
    return (lambda v: eval(code, {"math": math}, {**FUNCTIONS, "v": v})), values, roundings


def recalculated(source):
    """How many printed formulas give their results, and how many of them to a thousandth."""
    count, sharp = 0, 0
    for step in re.split(r"\n#step\([^)\n]*\)\[", source)[1:]:
        body = step[step.index("[$") + 2 : step.index("$]")]
        symbol, formula = body.split("&=", 1)
        parts = re.split(r"\n\s+(?:\\ &)?= ", formula)
        if len(parts) < 3:  # a formula that only names another quantity, or a number
            continue
        formula, numbers, result = parts
        result = result.strip()
        evaluate, values, roundings = read(numbers)
        _, [value], [half] = read(result.lstrip("-"))
        value = -value if result.startswith("-") else value
        computed = evaluate(values)
        allowed = half + 1e-12 * abs(value)
        for i, rounding in enumerate(roundings):
            if rounding:
                moved = [abs(evaluate([x + s * rounding if i == j else x for j, x in enumerate(values)]) - computed)
                         for s in (-1, 1)]
                allowed += max(moved)
        difference = abs(computed - value)
        if "arctan2" in numbers or "°" in result:
            difference = min(difference, abs(difference - 2 * math.pi))
        assert difference <= allowed, f"{symbol} = {formula} = {numbers} = {result}: {computed}"
        count += 1
        sharp += allowed < 1e-3 * abs(value)
    return count, sharp


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_formula_gives_its_result(language, tmp_path, capsys):
    lemnis("book", "--level", "full", "--language", language, "--format", "typ", "--output", tmp_path)
    source = (tmp_path / "LemniscateCrane.typ").read_text(encoding="utf-8")
    # A decimal comma stands in quotes.
    commas = re.findall(r'"\d+,\d+"', source)
    assert (len(commas) > 100) == (language == "bg")
    count, sharp = recalculated(re.sub(r'"(\d+),(\d+)"', r"\1.\2", source))
    with capsys.disabled():
        print(f"\n  {language}: {count} printed formulas recalculated from their printed numbers")
    assert count > 60
    # A result wrong by a thousandth would not pass, but for differences of nearly equal numbers.
    assert sharp > 0.85 * count, sharp


@pytest.mark.parametrize("scene", sorted(path.stem for path in (ROOT / "models/scenes").glob("*.toml")))
def test_every_formula_of_the_ready_scenes_gives_its_result(scene, tmp_path, capsys):
    lemnis("book", ROOT / f"models/scenes/{scene}.toml", "--level", "full", "--format", "typ", "--output", tmp_path)
    [book] = tmp_path.glob("*.typ")
    count, sharp = recalculated(book.read_text(encoding="utf-8"))
    with capsys.disabled():
        print(f"\n  {scene}: {count} printed formulas recalculated, {sharp} to a thousandth")
    assert count > 10

"""The story of a book: its order, the engineer's own paragraphs, what is not covered, no pages of zeros, and the summary
that a manager signs."""

import json
import re

import pypdf
import pytest

from conftest import ROOT, lemnis, text_of, typst, words
from test_book import DEFAULT, LANGUAGES, scene

SCENES = sorted(path.stem for path in (ROOT / "models/scenes").glob("*.toml"))


def made(folder, path, *options):
    lemnis("book", path, "--output", folder, *options)
    [pdf] = folder.glob("*.pdf")
    return pdf


def ready(folder, name, *options):
    return made(folder, ROOT / f"models/scenes/{name}.toml", *options)


def plain(text):
    """Markup of a word as the PDF has it, as far as words between two pieces of code go."""
    return re.split(r"[#$*]", text)[0].strip().replace("'", "’")


OWN = """[book.text]
task = "What the boom X_1 bears: #read(\\"/etc/passwd\\") $x$ *b* <l> @r \\\\ `c`."
scope = { en = "Of the crane only the head.", bg = "Само върхът на крана." }
load_cases = '''
First of two.

- Second of two.
'''
method = "By the angle theta_1."
conclusion = { zh = "臂架 X_1 可用。", en = "The boom X_1 will do." }
remarks = "= no heading of Delta_99"
"""


def test_the_engineers_paragraphs_stand_at_their_places(tmp_path):
    path = scene(tmp_path, "crane.toml", ("[luffing]\n", OWN + "[luffing]\n"))
    pages = text_of(made(tmp_path / "en", path))
    assert "Conclusion: The boom 𝑋1 will do." in pages[0]
    text = " ".join(pages)
    said = [
        "2 Task and scope What the boom 𝑋1 bears: #read(\"/etc/passwd\") $x$ *b* <l> @r \\ `c`. The calculation follows",
        "Of the crane only the head. Not covered are wind;",
        "of a standard. First of two. - Second of two. ",
        "By the angle 𝜃1 . • The plane of the mechanism",
        "Remarks = no heading of Δ99 1. [Li2022]",
    ]
    places = [text.find(words) for words in said]
    assert -1 not in places and places == sorted(places), places
    text = " ".join(text_of(made(tmp_path / "zh", path, "--language", "zh")))
    assert "结论： 臂架𝑋1可用。" in text.replace("臂架 ", "臂架").replace(" 可用", "可用") and "Of the crane only the head." in text
    assert "Само върхът на крана." in " ".join(text_of(made(tmp_path / "bg", path, "--language", "bg")))


@pytest.mark.parametrize("name, absent", [
    # At rest nothing swings, accelerates or rubs; what moves by itself has a chapter of that.
    ("lemniscate", set()),
    ("portal_004_motion", {"sway", "inertia", "friction"}),
    ("portal_crane", {"sway", "inertia", "friction"}),
    # Load cases with a motor, brakes, a rack, its teeth and pins leave the gear, other bars and the structure.
    ("portal_004_drive", {"wind", "sway", "inertia", "friction", "load_cases", "motor_brake", "strength", "buckling"}),
])
def test_the_scope_says_what_is_not_covered(name, absent, tmp_path):
    text = " ".join(text_of(ready(tmp_path, name, "--level", "summary")))
    scope = text[text.index("Not covered are"):]
    scope = scope[: scope.index(".")]
    told = {id: plain(word) in scope for id, word in words("en")["uncovered"].items()}
    at_rest = {"wind", "sway", "inertia", "friction", "dynamic_coefficients", "motor_brake", "strength", "buckling", "stability", "load_cases"}
    instead = {"gear", "other_strength", "other_buckling"} if "motor_brake" in absent else set()
    assert {id for id, is_told in told.items() if is_told} == at_rest - absent | instead


def test_nothing_that_weighs_nothing_is_told(tmp_path):
    """A plain boom without a load: jib and rocker stand for none."""
    text = " ".join(text_of(ready(tmp_path, "ports_001", "--level", "full")))
    # What the scene gives as nothing stands among the given quantities, and nowhere later.
    results = text.rsplit("Constants of the mechanism", 1)[1].rsplit("Input file", 1)[0]
    assert "0 kN" in text.replace("0kN", "0 kN") and len(results) > 10_000
    assert re.findall(r".{60}(?<![\w.,])[−-]?0 ?kN.{20}", results) == []
    # Nor of jib and rocker are there results: level error, transmission angle, velocity of the head.
    assert not any(column in results for column in ("Level error", "Smallest transmission angle of", "Horizontal velocity of A [Li2022"))
    assert "Smallest transmission angle between rod and lever" in text and "Level error" not in text.rsplit("Constants of the mechanism", 1)[0]
    assert "Luffing moment of the load" not in results.split(" Remarks ")[0] and "Calculation of the balance of a plain boom" in text
    assert "Positionofthegreatestresidualmomentabouttheboom’sfoot:𝜃1=50.5°" in text.replace(" ", "")
    lemnis("book", ROOT / "models/scenes/ports_001.toml", "--format", "typ", "--output", tmp_path)
    source = typst(tmp_path / "PortsLever.typ")
    drawing = next(line for line in source.splitlines() if line.strip().startswith("drawn(1,"))
    labels = set(re.findall(r'\\"text\\":\\"([^"\\]+)', drawing))
    assert labels == {"O_1", "B", "theta_1", "X_1"}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", SCENES)
def test_the_summary_is_what_a_manager_signs(name, language, tmp_path):
    """Requirements and warnings on the first page, task, sketch, design forces and references on two or three."""
    pages = text_of(ready(tmp_path, name, "--level", "summary", "--language", language))
    assert 2 <= len(pages) <= 3
    text, said = " ".join(pages), words(language)
    for chapter in ["task", "references"]:
        assert said["chapter"][chapter] in text
    assert said["text"]["task"][:20] in text and said["text"]["uncovered"] in text
    assert not {said["chapter"][chapter] for chapter in ["inputs", "sensitivity", "notation", "remarks"]} & set(re.findall(r"\d (\w+)", text))
    heads = [plain(said["text"][id]) for id in ["met", "not_met", "no_requirements"]]
    assert any(head and head in pages[0] for head in heads), pages[0]
    assert said["text"]["figure"].split("#")[0].strip("~ ") + " 1" in text


def test_design_forces_are_the_greatest_of_the_whole_range(tmp_path):
    """Beside the search by amount of the governing results."""
    exact = scene(tmp_path, "exact.toml", ("[project]", "[book]\ndigits = 7\n[project]"))
    pages = " ".join(text_of(made(tmp_path / "exact", exact, "--level", "summary")))
    pages = pages.replace(" ", "")
    unit = {"kN": 1e3, "kN·m": 1e3}
    rows = {
        name: [float(value.replace("−", "-")) * unit[of] for value, of in zip(found[1::2], found[2::2])]
        for found in re.findall(r"(𝐹𝑑|𝑁3|𝑀𝐷):[A-Z][^:]*?\.(−?\d+\.?\d*)(kN·m|kN)𝜃1=[\d.]+°(−?\d+\.?\d*)(kN·m|kN)𝜃1=[\d.]+°", pages)
        for name in [found[0]]
    }
    governing = json.loads(lemnis("check", "--json", ROOT / "models/scenes/lemniscate.toml"))["summary"]
    assert set(rows) == {"𝐹𝑑", "𝑁3", "𝑀𝐷"}
    for name, id in {"𝐹𝑑": "F_d_max", "𝑁3": "N_3_max", "𝑀𝐷": "M_D_max"}.items():
        least, greatest = rows[name]
        assert least < greatest
        most = max(least, greatest, key=abs)
        assert most == pytest.approx(governing[id]["value"], rel=1e-5)


def test_without_loads_a_summary_has_the_results_instead(tmp_path):
    text = " ".join(text_of(ready(tmp_path, "car_4x2", "--level", "summary")))
    assert "Design forces" not in text and "Greatest and least results, with their positions" in text
    assert "Greatest and least results" not in " ".join(text_of(made(tmp_path / "loaded", scene(tmp_path, text=DEFAULT), "--level", "summary")))


def test_references_know_what_the_chapters_behind_them_cite(tmp_path):
    """The scene chooses the order: before the chapters that cite the list is the same as behind them."""
    listed = []
    for order in ['"references", "positions", "remarks"', '"positions", "remarks", "references"']:
        path = scene(tmp_path, "crane.toml", ("[luffing]\n", f"[book]\nchapters = [{order}]\n[luffing]\n"))
        text = " ".join(text_of(made(tmp_path, path)))
        listed.append(sorted(re.findall(r"\[([A-Z][A-Za-z]+\d+)\] [A-Z]", text)))
    assert listed[0] == listed[1] and "Li2022" in listed[0]


@pytest.mark.parametrize("name", ["curved_trunk", "ellipsograph"])
def test_figures_stand_in_their_order(name, tmp_path):
    """Down each page, those side by side from the left, a drawing at the foot or head of a page too."""
    found = []
    for page in pypdf.PdfReader(ready(tmp_path, name)).pages:
        captions = []

        def visit(text, current, matrix, *_):
            caption = re.match(r"\s*Figure\s(\d+):", text)
            if caption:
                captions.append((-round(matrix[5] * current[3] + current[5]), matrix[4], int(caption[1])))

        page.extract_text(visitor_text=visit)
        found += [number for *_, number in sorted(captions)]
    # Rankings, which come after these, have as many bars as matter: side by side their captions are not on one height.
    assert found[:11] == list(range(1, 12)), found

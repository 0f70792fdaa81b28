"""Every ready scene's book in every language, made and read once: chapters, words, references."""

import re
from itertools import groupby
from types import SimpleNamespace

import pypdf
import pytest

from conftest import ROOT, text_of, words
from test_languages import LANGUAGES, book, without_input_file

SCENES = sorted((ROOT / "models/scenes").glob("*.toml"))
ORDER = [
    "results", "task", "inputs", "conventions", "views", "constants", "positions", "range", "charts", "forces", "sizing", "balance",
    "cases", "afloat_cases", "motion", "cycle", "synthesis", "search", "study", "published", "sensitivity", "remarks", "notation",
    "references", "identities",
]


@pytest.fixture(scope="module", params=[(path, language) for path in SCENES for language in LANGUAGES],
                ids=lambda param: f"{param[0].stem}-{param[1]}")
def ready(request, tmp_path_factory):
    path, language = request.param
    made = book(tmp_path_factory.mktemp("ready"), path, "--language", language)
    return SimpleNamespace(path=path, language=language, outline=pypdf.PdfReader(made).outline, text=" ".join(text_of(made)))


def test_it_speaks_its_language(ready):
    if ready.language == "en":
        return
    # English are only names, publications, functions and, in quotation marks or parentheses, levels: what the scene
    # says in words it says in every language. An index of symbols is as long as a word.
    text = without_input_file(ready.text, ready.language)
    said = re.sub(r'#.*|(?m:^\w+\.|\b)en = "[^"]*"', "", ready.path.read_text(encoding="utf-8"))
    known = said + " ".join(words(ready.language)["reference"].values()) + "Lemnis Rodas Sobol arccos arcsin arctan slip toml"
    # The subscript of what a formula gives may be read behind the formula's number.
    text = re.sub(r"[“„（][a-z]+[”“）]|\(\d+\.\d+\) [a-z]+ =", "", text)
    assert not set(re.findall(r"\b[A-Za-z]{4,}\b", text)) - set(re.findall(r"[A-Za-z]+", known))


def test_chapters_stand_in_the_order_of_the_story(ready):
    titles = [re.sub(r"^\d+ ", "", entry.title) for entry in ready.outline if not isinstance(entry, list)]
    known = {title: id for id, title in words(ready.language)["chapter"].items()}
    # One for each position.
    chapters = [chapter for chapter, _ in groupby(known.get(title, "positions") for title in titles)]
    assert chapters == [chapter for chapter in ORDER if chapter in chapters]
    assert {"results", "task", "inputs", "conventions", "range", "notation", "references"} <= set(chapters)


def test_every_source_that_is_cited_is_among_the_references(ready):
    text, listed = ready.text.rsplit(words(ready.language)["chapter"]["references"], 1)
    listed = listed.split(words(ready.language)["chapter"]["identities"])[0]
    key = r"\[((?:[A-Z][A-Za-z]+\d+|Rothe Erde|ISO \d[\d-]*))"
    cited, known = set(re.findall(key + r"[,\]]", text)), re.findall(key + r"\]", listed)
    assert cited and cited == set(known) and len(known) == len(cited)

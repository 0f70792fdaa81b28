"""Books in English, Chinese and Bulgarian: words, numbers, accessibility, missing glyphs."""

import re
import subprocess

import pypdf
import pytest

from conftest import LEMNIS, ROOT, text_of, words

# As the publications write them: Chinese in [Li2022], Bulgarian in [Balance004] and the trade.
TERMS = {
    "en": ["boom", "jib", "rocker", "reach", "luffing moment", "instantaneous centre", "driving link", "driven link"],
    "zh": ["臂架", "象鼻架", "后摇杆", "刚性拉杆", "幅度", "变幅力矩", "速度瞬心", "下铰点", "回转中心线", "起升载荷", "主动杆", "从动杆"],
    "bg": ["стрела", "хобот", "оттяжка", "обсег", "център на тежестта", "шарнир", "ъгъл на предаване на движението", "водещото звено", "воденото звено"],
}
# What the trade calls otherwise: 起重量 is a mass, "driven" is what a mechanism moves and not what moves it.
NOT_OF_THE_TRADE = {
    "en": ["driven bar", "driven-along", "driven boom", "driven rocker"],
    "zh": ["活对重", "油缸", "起重量", "缸径", "杠杆支点", "静态参照力矩", "场景", "缺省"],
    "bg": ["задвижвано", "уравновесяването", "учетворен", "изработк", "сцена", "положителна при тласкане", "подробност"],
}
LANGUAGES = list(TERMS)


def book(folder, *arguments):
    """A book made without a word of warning."""
    done = subprocess.run([str(LEMNIS), "book", *map(str, arguments), "--output", str(folder)], capture_output=True,
                          text=True, encoding="utf-8")
    assert done.returncode == 0 and done.stderr == "", done.stderr
    return next(folder.glob("*.pdf"))


@pytest.fixture(scope="module", params=LANGUAGES)
def made(request, tmp_path_factory):
    return request.param, book(tmp_path_factory.mktemp(request.param), "--language", request.param)


def test_the_terms_of_the_trade_are_printed(made):
    language, path = made
    text = " ".join(text_of(path)).lower()
    if language == "zh":  # where a line ends anywhere
        text = text.replace(" ", "")
    for term in TERMS[language]:
        assert term in text, term


@pytest.mark.parametrize("language", LANGUAGES)
def test_other_terms_than_those_of_the_trade_stand_nowhere(language):
    said = "\n".join(path.read_text(encoding="utf-8") for path in (ROOT / f"templates/words/{language}").glob("*.toml"))
    if language == "en":
        said += (ROOT / "docs/notation.md").read_text(encoding="utf-8")
    # The publication's title says what its crane has.
    said = re.sub(r"(?m)^Li2022 = .*", "", said).lower()
    assert [term for term in NOT_OF_THE_TRADE[language] if term in said] == []


def without_input_file(text, language):
    """Without the appendix, which has the input file as it is written."""
    return text.split(words(language)["head"]["written"])[0]


def test_numbers_have_the_decimal_sign_of_the_language(made):
    language, path = made
    text = without_input_file(" ".join(text_of(path)), language)
    comma, point = "29,9766", "29.9766"
    assert (comma in text, point in text) == ((True, False) if language == "bg" else (False, True))
    if language == "bg":
        # What has a point is no number: sections, versions, identifiers of publications, numbers of formulas.
        rest = re.sub(r"doi:\S+|Lemnis [\d.]+|\[Li2022, [\d.]+\]|Фигура|\(\d+\.\d+\)|\b\d{1,2}\.\d\b", "", text)
        assert not re.search(r"\d\.\d", rest), re.search(r".{20}\d\.\d.{20}", rest)


def test_a_book_says_its_language_and_is_pdf_ua(made):
    language, path = made
    reader = pypdf.PdfReader(path)
    assert reader.trailer["/Root"]["/Lang"].startswith(language)
    assert reader.trailer["/Root"]["/MarkInfo"]["/Marked"]
    assert b"pdfuaid:part" in reader.trailer["/Root"]["/Metadata"].get_data()


def alternatives(node, kind):
    """The words of every structure element of a kind."""
    node = node.get_object()
    if not hasattr(node, "get"):
        return
    if node.get("/S") == kind:
        yield node.get("/Alt")
    children = node.get("/K", [])
    for child in children if isinstance(children, list) else [children]:
        if hasattr(child.get_object(), "get"):
            yield from alternatives(child, kind)


SPOKEN = {
    "en": "M Q equals Q times Y prime A equals 160 kN times 1.58967 m equals 254.347 kN·m",
    "zh": "M Q 等于 Q 乘 Y 撇 A 等于 160 kN 乘 1.58967 m 等于 254.347 kN·m",
    "bg": "M Q е равно на Q по Y прим A е равно на 160 kN по 1,58967 m е равно на 254,347 kN·m",
}


def test_every_equation_and_picture_is_spoken(made):
    language, path = made
    tree = pypdf.PdfReader(path).trailer["/Root"]["/StructTreeRoot"]
    equations = list(alternatives(tree, "/Formula"))
    assert len(equations) > 300 and all(equations)
    assert SPOKEN[language] in equations
    pictures = list(alternatives(tree, "/Figure"))
    # The drawing, six curves, five rankings.
    assert len(pictures) == 1 + 6 + 5 and all(pictures)


def scene(tmp_path, **changes):
    text = (ROOT / "models/scenes/lemniscate.toml").read_text(encoding="utf-8")
    for old, new in changes.values():
        assert old in text
        text = text.replace(old, new, 1)
    path = tmp_path / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_scene_chooses_and_the_command_line_overrides(tmp_path):
    path = scene(tmp_path, book=("[luffing]\n", "[book]\nlanguage = \"bg\"\n\n[luffing]\n"))
    assert "Работен диапазон" in " ".join(text_of(book(tmp_path, path)))
    assert "工作范围" in " ".join(text_of(book(tmp_path, path, "--language", "zh")))


def test_titles_in_all_scripts_need_no_fonts_of_the_system(tmp_path):
    title = "门座起重机 · Портален кран · Grue à flèche"
    path = scene(tmp_path, title=("Lemniscate level-luffing crane 16 t × 30 m", title))
    assert title in " ".join(text_of(book(tmp_path, path)))


def test_a_character_that_nobody_has_is_a_warning_that_names_it(tmp_path):
    path = scene(tmp_path, title=("Lemniscate level-luffing crane", "Crane \U00010ffe of"))
    done = subprocess.run([str(LEMNIS), "book", str(path), "--output", str(tmp_path)], capture_output=True, text=True,
                          encoding="utf-8")
    assert done.returncode == 0
    assert "warning: no font has the character" in done.stderr and "U+10FFE" in done.stderr, done.stderr
    assert "on page 1" in done.stderr
    assert "Crane U+10FFE of" in " ".join(text_of(tmp_path / "LemniscateCrane.pdf"))

"""The page of `lemnis serve` in a real browser, and what it is bundled from."""

import json
import os
import re
import shutil
import subprocess

import pytest
from playwright.sync_api import expect, sync_playwright

from conftest import ROOT, lemnis, text_of, words
from run import browser as installed
from run import PYTHON
from test_serve import SCENE, serving

PAGE = ROOT / "serve/page"
TEXT = SCENE.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def chromium():
    program = installed()
    assert program, "no Chromium: python3 tests/run.py says what to install"
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox", "--disable-gpu"])
        yield browser
        browser.close()


class Seen:
    """A page with what it asked for and what went wrong in it."""

    def __init__(self, browser, served, size=(1280, 720)):
        self.context = browser.new_context(viewport={"width": size[0], "height": size[1]}, accept_downloads=True)
        self.page = self.context.new_page()
        self.wrong, self.asked = [], []
        self.page.on("pageerror", lambda error: self.wrong.append(str(error)))
        self.page.on("console", lambda message: message.type == "error" and self.wrong.append(message.text))
        self.page.on("request", lambda request: self.asked.append(request.url))
        self.page.on("dialog", lambda dialog: (self.wrong.append(dialog.message), dialog.dismiss()))
        self.page.goto(served.address)
        expect(self.page.locator("#verdict .results").first).to_be_visible()

    def write(self, text):
        """Puts another text into the editor, as pasting does."""
        content = self.page.locator(".cm-content")
        content.focus()
        self.page.keyboard.press("ControlOrMeta+a")
        content.evaluate("""(content, text) => {
            const clipboardData = new DataTransfer();
            clipboardData.setData("text/plain", text);
            content.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
        }""", text)

    def caret_behind(self, text):
        """Puts the caret behind a text that stands once, by the editor's own search."""
        self.page.locator(".cm-content").focus()
        self.page.keyboard.press("ControlOrMeta+f")
        self.page.locator(".cm-search input[name=search]").press_sequentially(text)
        self.page.keyboard.press("Enter")
        self.page.keyboard.press("Escape")
        self.page.keyboard.press("ArrowRight")


@pytest.fixture(scope="module")
def served():
    with serving() as one:
        yield one


@pytest.fixture
def seen(chromium, served):
    one = Seen(chromium, served)
    yield one
    one.context.close()
    assert one.wrong == []


def test_every_keystroke_is_answered(seen):
    page = seen.page
    reach = page.locator("#verdict li", has_text="Greatest reach of the working range").locator(".line")
    expect(reach).to_contain_text("= 29.98")
    seen.caret_behind('X_8 = "5')
    page.keyboard.type("5")
    # R is measured from the slewing axis, 5.2 m behind the boom's foot, then 55.2 m.
    expect(reach).to_contain_text("= 79.98")
    page.keyboard.press("Backspace")
    expect(reach).to_contain_text("= 29.98")


def test_a_key_is_completed_with_its_unit(seen):
    page = seen.page
    without = re.sub(r"(?m)^X_8 = .*\n", "", TEXT)
    seen.write(without)
    expect(page.locator("#mistakes")).to_contain_text("X_8")
    assert page.locator("#stale").is_visible()
    seen.caret_behind('X_7 = "1.354 m"')
    page.keyboard.press("End")
    page.keyboard.press("Enter")
    page.keyboard.type("X_")
    option = page.locator(".cm-tooltip-autocomplete li", has_text="X_8")
    expect(option).to_be_visible()
    expect(page.locator(".cm-completionInfo")).to_contain_text("m")
    page.wait_for_timeout(100)
    option.click()
    page.keyboard.type("5.2")
    expect(page.locator("#mistakes")).to_contain_text(words("en")["page"]["no_mistakes"])
    assert page.locator("#stale").is_hidden()


def test_a_mistake_is_mended_by_a_click(seen):
    page = seen.page
    # Two characters that UTF-16 has as two units each, before the place.
    seen.write(TEXT.replace('title.en = "', 'title.en = "起重机 ° 𝛼𝛼 ').replace('X_2 = "6.5 m"', 'X_22 = "6.5 m"'))
    mistake = page.locator("#mistakes li", has_text="X_22")
    expect(mistake).to_contain_text("X_2")
    expect(page.locator(".cm-lintRange-error").first).to_be_visible()
    assert "X_22" in page.locator(".cm-lintRange-error").all_inner_texts()
    mistake.locator("button.fix").click()
    expect(page.locator("#mistakes")).to_contain_text("No mistakes")
    expect(page.locator("#title")).to_have_text("起重机 ° 𝛼𝛼 Lemniscate level-luffing crane 16 t × 30 m")


def test_hovering_tells_what_a_key_is(seen):
    seen.page.locator(".cm-line", has_text=re.compile("^X_1 =")).locator("span").first.hover()
    told = seen.page.locator(".cm-tooltip-hover")
    expect(told).to_contain_text("luffing.X_1")
    expect(told).to_contain_text("Allowed")


def test_the_slider_asks_for_nothing(seen):
    page = seen.page
    drawn = lambda: page.locator("#drawing svg").inner_html()  # noqa: E731
    page.wait_for_load_state("networkidle")
    seen.asked.clear()
    pictures, places = {drawn()}, set()
    page.locator("#position").focus()
    for key in ("Home", "ArrowRight", "PageUp", "End"):
        page.keyboard.press(key)
        page.wait_for_timeout(50)
        pictures.add(drawn())
        places.add(page.locator("#place").inner_text())
    assert len(pictures) == 5 and len(places) == 4
    # Curves and table show the same position.
    assert page.locator("#position").get_attribute("aria-valuetext") == "θ1 = 120°"
    reach = page.locator(".chart", has_text="Reach").locator("b").inner_text()
    page.click("#tab-table")
    row = page.locator("#table tr", has=page.locator("th", has_text=re.compile("^R$")))
    assert reach.split()[0] == row.locator("td").first.inner_text() == "10.54"
    page.click("#play")
    page.wait_for_timeout(300)
    moving = drawn()
    page.wait_for_timeout(300)
    assert drawn() != moving
    page.click("#play")
    assert page.locator("#play").get_attribute("aria-pressed") == "false"
    assert [url for url in seen.asked if not url.startswith("blob:")] == []


def test_a_curve_moves_the_slider_and_any_result_has_one(seen):
    page = seen.page
    page.locator("#choice summary").click()
    page.locator("#choice input[type=search]").fill("instantaneous")
    page.locator("#choice label:visible input").first.check()
    page.locator("#choice summary").click()
    assert page.locator("#charts .mark").count() == 4
    plot = page.locator(".u-over").first
    box = plot.bounding_box()
    page.mouse.click(box["x"] + 2, box["y"] + 20)
    expect(page.locator("#place")).to_have_text("θ1 = 60°")


@pytest.mark.parametrize("code", ["zh", "bg"])
def test_the_language_is_switched(seen, code):
    page, own = seen.page, words(code)
    page.select_option("#language", code)
    expect(page.locator("#save")).to_have_text(own["page"]["save"])
    expect(page.locator("#verdict h2").first).to_have_text(own["caption"]["requirements"])
    expect(page.locator("#mistakes")).to_contain_text(own["page"]["no_mistakes"])
    assert page.locator("html").get_attribute("lang") == code
    # Numbers too.
    expect(page.locator("#verdict")).to_contain_text("47,32" if code == "bg" else "47.32")
    english = words("en")["page"]
    same = {id for id, word in own["page"].items() if english[id] == word}
    seen_words = page.locator("body").inner_text()
    assert not [id for id, word in english.items() if id not in same and len(word) > 8 and word in seen_words]


@pytest.mark.parametrize("what", ["fmi2.fmu", "csv", "toml"])
def test_what_is_downloaded_has_the_bytes_of_the_command(seen, out, tmp_path, what):
    seen.page.locator("#downloads summary").click()
    with seen.page.expect_download() as started:
        seen.page.click(f'[data-make="{what}"]')
    path = tmp_path / "downloaded"
    started.value.save_as(path)
    assert started.value.suggested_filename == f"LemniscateCrane.{what}"
    made = {"csv": lambda: lemnis("check", SCENE, "--csv").encode(), "toml": SCENE.read_bytes,
            "fmi2.fmu": (out / "LemniscateCrane.fmi2.fmu").read_bytes}
    assert path.read_bytes() == made[what]()


def test_the_gallery_opens_a_scene(seen):
    page = seen.page
    page.click("#open-gallery")
    cards = page.locator(".card")
    expect(cards).to_have_count(len(list((ROOT / "models/scenes").glob("*.toml"))))
    assert all(svg.locator("polyline, polygon").count() > 2 for svg in cards.locator("svg").all())
    page.keyboard.press("Escape")
    page.click("#open-gallery")
    page.click('[data-scene="boat_hoist_003"]')
    expect(page.locator("#title")).to_have_text("Steering of a 600 t boat hoist on 16 wheels")
    # Back to the first one, with what was written there.
    page.select_option("#scene", "lemniscate")
    expect(page.locator("#title")).to_contain_text("Lemniscate")


def test_text_of_a_scene_never_becomes_html(seen):
    page = seen.page
    title = "<script>alert(1)</script><img src=x onerror=alert(2)>"
    seen.write(TEXT.replace("Lemniscate level-luffing crane 16 t × 30 m", title))
    expect(page.locator("#title")).to_have_text(title)
    page.click("#keep")
    page.click("#tab-comparison")
    seen.write(TEXT.replace("X_1 = ", f'"{title}" = '))
    expect(page.locator("#mistakes")).to_contain_text("onerror")
    assert page.locator("main img, #mistakes img, #mistakes script, main script").count() == 0


def test_designs_stand_side_by_side(seen):
    page = seen.page
    page.click("#keep")
    page.click("#tab-comparison")
    expect(page.locator("#comparison")).to_contain_text(words("en")["page"]["no_difference"])
    seen.write(re.sub(r'(mu_min *=) "30 deg"', r'\1 "60 deg"', TEXT.replace('X_1 = "19.3 m"', 'X_1 = "19.4 m"')))
    changed = page.locator("#comparison tr", has_text="luffing.X_1")
    expect(changed).to_contain_text("19.4 m")
    expect(changed).to_contain_text("19.3 m")
    assert page.locator("#comparison .broken").count() == 1
    expect(page.locator("#verdict li.broken")).to_have_count(1)
    page.click("#tab-curves")
    expect(page.locator(".chart").first).to_be_visible()
    page.click("#tab-comparison")
    page.locator("#comparison button").click()
    expect(page.locator("#comparison")).to_contain_text(words("en")["page"]["nothing_kept"])


def test_only_changed_pages_of_the_book_come_again(seen):
    page = seen.page
    page.click("#tab-book")
    page.select_option("#level", "summary")
    pages = page.locator("#pages img")
    expect(pages.first).to_be_visible(timeout=30000)
    expect(page.locator("#book-state")).to_have_text("", timeout=30000)
    first = pages.evaluate_all("pages => pages.map(page => page.dataset.hash)")
    pages.evaluate_all("pages => pages.forEach(page => { page.old = true; })")
    assert page.evaluate("document.querySelector('#pages img').naturalWidth") > 0
    seen.write(TEXT + "# one more line\n")
    page.wait_for_function("first => document.querySelector('#pages img').dataset.hash !== first", arg=first[0], timeout=30000)
    expect(page.locator("#book-state")).to_have_text("", timeout=30000)
    kept = pages.evaluate_all("pages => pages.map(page => [page.dataset.hash, Boolean(page.old)])")
    assert [hash in first for hash, _ in kept] == [old for _, old in kept] and len(kept) == len(first)


def test_a_result_opens_the_page_of_its_formula(seen, tmp_path):
    """What a click turns to is the page of the book that explains the symbol, and not a table that has its value."""
    page = seen.page
    first = page.locator("#verdict li").first
    assert first.locator("button").first.inner_text().startswith("μ")
    first.get_by_role("button", name=words("en")["page"]["formula"]).click()
    expect(page.locator("#tab-book")).to_have_attribute("aria-selected", "true")
    page.wait_for_function("() => document.querySelector('#book').scrollTop > 0", timeout=60000)
    tops = page.locator("#pages img").evaluate_all("pages => pages.map(page => page.getBoundingClientRect().top)")
    top = page.locator("#book").evaluate("book => book.getBoundingClientRect().top")
    turned = min(range(len(tops)), key=lambda i: abs(tops[i] - top))
    lemnis("book", SCENE, "-o", tmp_path)
    texts = text_of(next(tmp_path.glob("*.pdf")))
    meaning = "Transmission angle between coupler"
    assert turned == next(i for i, text in enumerate(texts) if meaning in text)


def centre(locator):
    box = locator.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def downloaded(page):
    """The whole text, as the page would download it."""
    page.click("#downloads summary")
    with page.expect_download() as download:
        page.click("[data-make=toml]")
    with open(download.value.path(), encoding="utf-8", newline="") as file:
        return file.read()


def written(page, key):
    """What the scene has behind a key, with its comment."""
    return re.search(rf"^{key} += +(.*)$", downloaded(page), re.MULTILINE).group(1)


def test_a_joint_is_dragged_and_its_keys_follow(seen):
    """C is placed by rear arm and rocker: both lengths become what the drawing shows, comments stay, and one undoes it."""
    page = seen.page
    joint = page.get_by_role("button", name="X2, X3")
    before = [written(page, key) for key in ("X_2", "X_3")]
    x, y = centre(joint)
    ends = [centre(page.get_by_role("button", name=name)) for name in ("X1", "X5, X6")]
    metre = 6.5 / ((x - ends[0][0]) ** 2 + (y - ends[0][1]) ** 2) ** 0.5
    page.mouse.move(x, y)
    page.mouse.down()
    for far in range(1, 6):
        page.mouse.move(x + far, y - far)
    expect(page.locator("#verdict")).not_to_contain_text("47.32")
    page.mouse.up()
    after = [written(page, key) for key in ("X_2", "X_3")]
    assert [line.split("#")[1] for line in after] == [line.split("#")[1] for line in before]
    # Five pixels to the right and five up, at the drawing's scale.
    number = lambda line: float(line.split('"')[1].split()[0])
    away = lambda end: ((x + 5 - end[0]) ** 2 + (y - 5 - end[1]) ** 2) ** 0.5
    assert [number(line) for line in after] == pytest.approx([away(ends[0]) * metre, away(ends[1]) * metre], abs=metre)
    scene = downloaded(page)
    assert scene != TEXT and "No mistakes" in page.inner_text("#mistakes")
    for _ in range(10):
        page.locator(".cm-content").focus()
        page.keyboard.press("ControlOrMeta+z")
    assert downloaded(page) == TEXT


def test_a_joint_is_moved_by_the_keyboard(seen):
    page = seen.page
    anchor = page.get_by_role("button", name="xE, yE")
    before = written(page, "E_x"), written(page, "E_y")
    anchor.focus()
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    page.keyboard.press("Shift+ArrowUp")
    assert page.evaluate("document.activeElement.getAttribute('aria-label')").endswith("xE, yE")
    expect(page.locator("#mistakes")).to_contain_text("No mistakes")
    number = lambda line: float(line.split('"')[1].split()[0])
    x, y = number(written(page, "E_x")) - number(before[0]), number(written(page, "E_y")) - number(before[1])
    # Ten units up are as far as three to the right, times ten thirds; both are written to what can be seen.
    assert 0 < x < y and abs(y / x - 10 / 3) < 0.4


def test_other_joints_do_not_drag(seen):
    """What follows from others is no handle: of the lemniscate's joints the heads, the anchors and the frame's points are."""
    labels = seen.page.locator(".handle").evaluate_all("all => all.map(one => one.getAttribute('aria-label').split(': ')[1])")
    assert labels == ["xE, yE", "sd, χd", "X1", "X2, X3", "X4", "X5, X6", "X8"]
    seen.write(TEXT + "\nnonsense = 1\n")
    expect(seen.page.locator("#stale")).to_be_visible()
    assert not seen.page.locator(".handle").first.is_visible()


def test_forces_are_arrows_to_one_scale(seen):
    """Each arrow has the amount that the table has, and a length of so many kilonewtons as the measure beside them says."""
    page = seen.page
    page.locator("#position").evaluate("slider => { slider.value = slider.max; slider.dispatchEvent(new Event('input')); }")
    expect(page.locator("#place")).to_contain_text("120°")
    page.check("#forces")
    results = json.loads(lemnis("check", "--json", SCENE))["variables"]
    row = int(page.input_value("#position"))
    value = lambda name: results[name]["values"][row] / 1e3
    forces = [(value("F_d"),)] + [(value(f"F_{joint}.x"), value(f"F_{joint}.y")) for joint in ("O1", "O3", "B", "C")]
    amounts = sorted(float(f"{sum(part**2 for part in force) ** 0.5:.3g}") for force in forces)
    shown = page.locator(".forces text").all_text_contents()
    measure, unit = shown.pop().split()
    assert unit == "kN" and sorted(float(text.replace("−", "-")) for text in shown) == amounts
    ends = page.locator(".forces polyline").evaluate_all("all => all.map(one => one.getAttribute('points').split(/[ ,]/).map(Number))")
    length = lambda x, y, u, v: ((u - x) ** 2 + (v - y) ** 2) ** 0.5
    scale = length(*ends[-1]) / float(measure)
    assert sorted(float(f"{length(*end) / scale:.3g}") for end in ends[:-1]) == pytest.approx(amounts, rel=0.01)
    page.uncheck("#forces")
    assert page.locator(".forces text").count() == 0


def test_centre_dead_points_and_transmission_angle_are_shown_where_asked_for(seen):
    """The centre lies on the boom's line as far from its foot as the table says; a boom has two dead points."""
    page = seen.page
    page.locator("#position").evaluate("slider => { slider.value = 0; slider.dispatchEvent(new Event('input')); }")
    expect(page.locator("#place")).to_contain_text("60°")
    lines = page.locator("#drawing .axis")
    plain, angles = lines.count(), page.locator("#drawing text", has_text="μ").count()
    page.check("#with-dead_points")
    expect(lines).to_have_count(plain + 2)
    page.uncheck("#with-dead_points")
    page.check("#with-transmission")
    expect(page.locator("#drawing text", has_text="μ")).to_have_count(angles + 1)
    page.check("#with-centre")
    expect(lines).to_have_count(plain + 2)
    results = json.loads(lemnis("check", "--json", SCENE))["variables"]
    ends = lines.evaluate_all("all => all.map(one => one.getAttribute('points').split(/[ ,]/).map(Number))")
    ends = [line for line in ends if [other[2:] for other in ends].count(line[2:]) == 2]
    assert len(ends) == 2, "both lines end in the centre"
    length = lambda x, y, u, v: ((u - x) ** 2 + (v - y) ** 2) ** 0.5
    at = lambda name: (results[f"{name}.x"]["values"][0], results[f"{name}.y"]["values"][0])
    far = [length(*at(joint), *at("P")) for joint in ("B", "C")]
    assert length(*ends[0]) / length(*ends[1]) == pytest.approx(far[0] / far[1], rel=1e-3)


def test_runs_are_played_in_time(chromium):
    """The manoeuvres of the book: the load hangs from the head, slewing is seen from above, and the range comes back."""
    with serving(ROOT / "models/scenes/portal_crane.toml") as served:
        seen = Seen(chromium, served)
        page = seen.page
        page.select_option("#run", index=1)
        expect(page.locator("#run option")).to_have_count(6)
        names = words("en")["manoeuvre"]
        assert names["slew_and_stop"] in page.locator("#run option").all_inner_texts()
        page.select_option("#run", label=names["slew_and_stop"])
        expect(page.locator("#place")).to_contain_text("t = 0.00")
        page.locator("#position").evaluate("slider => { slider.value = slider.max; slider.dispatchEvent(new Event('input')); }")
        expect(page.locator("#place")).not_to_contain_text("t = 0.00")
        load, head = page.locator("#drawing > .mechanism rect.weight"), page.locator("#drawing > .mechanism text.name", has_text="A").last
        assert load.bounding_box()["y"] > head.bounding_box()["y"] + 50
        boom = lambda: page.locator("#plan .bar").get_attribute("points").split(" ")[1]
        end = boom()
        page.locator("#position").evaluate("slider => { slider.value = 0; slider.dispatchEvent(new Event('input')); }")
        page.wait_for_function("end => document.querySelector('#plan .bar').getAttribute('points').split(' ')[1] !== end", arg=end)
        page.click("#play")
        page.wait_for_function("() => Number(document.getElementById('position').value) > 2")
        page.click("#play")
        assert page.locator(".handle").count() == 0
        # Another language names them anew, and what is seen stays.
        page.select_option("#language", "zh")
        expect(page.locator("#run option:checked")).to_have_text(words("zh")["manoeuvre"]["slew_and_stop"])
        assert page.locator("#plan").is_visible()
        page.select_option("#language", "en")
        expect(page.locator("#run option:checked")).to_have_text(names["slew_and_stop"])
        page.select_option("#run", index=0)
        expect(page.locator("#place")).to_contain_text("θ")
        # What runs in time have to say comes after the rest, to the same place.
        identities = page.locator("#identities li").all_text_contents()
        page.locator(".cm-content").focus()
        page.keyboard.press("ControlOrMeta+End")
        page.keyboard.type("\n#")
        expect(page.locator("#verdict .old, #verdict .awaited")).to_have_count(0)
        assert page.locator("#identities li").all_text_contents() == identities != []
        assert page.locator("#plan").is_hidden() and page.locator(".handle").count() > 0
        assert seen.wrong == []
        # While one types on they stay as they were, pale; an answer that was overtaken is told so.
        page.evaluate("""() => {
            const count = (what) => document.querySelectorAll(`#verdict ${what}`).length;
            window.states = [];
            const told = () => window.states.push([count(".awaited"), count(".old")]);
            new MutationObserver(told).observe(document.getElementById("verdict"), { childList: true });
        }""")
        for key in "abc":
            page.evaluate("() => { window.states.length = 0; }")
            page.keyboard.press(key)
            page.wait_for_function("() => window.states.some(([awaited]) => awaited)")
            assert all(old for awaited, old in page.evaluate("window.states") if awaited)
        expect(page.locator("#verdict .old, #verdict .awaited")).to_have_count(0)
        seen.context.close()


def test_a_search_is_watched_and_what_it_found_opens_beside(chromium, tmp_path):
    scene = ROOT / "models/scenes/rope_luffing.toml"
    lemnis("synth", scene, "-o", tmp_path)
    with serving(scene) as served:
        seen = Seen(chromium, served)
        page = seen.page
        page.click("#tab-work")
        page.click("[data-begin=synth]")
        expect(page.locator("#progress")).to_be_hidden(timeout=120000)
        expect(page.locator("#said")).to_contain_text("least T_max")
        assert str(tmp_path) not in page.inner_text("#said") and "/tmp" not in page.inner_text("#said")
        expect(page.locator("#scene option:checked")).to_have_text("RopeLuffing_synth")
        assert downloaded(page) == (tmp_path / "RopeLuffing_synth.toml").read_text(encoding="utf-8")
        page.click("#tab-comparison")
        # The quantity itself, not what the search notes of it.
        expect(page.locator("#comparison tr", has_text=re.compile(r"^\s*luffing\.tackle\.E_y"))).to_contain_text("13 m")
        assert seen.wrong == []
        seen.context.close()


def test_a_search_is_stopped_and_gives_its_best_so_far(chromium):
    with serving(ROOT / "models/scenes/portal_004_synthesis.toml") as served:
        seen = Seen(chromium, served)
        page = seen.page
        page.click("#tab-work")
        page.click("[data-begin=synth]")
        page.wait_for_function("() => document.getElementById('progress').value > 0", timeout=60000)
        page.click("#stop")
        expect(page.locator("#said")).to_contain_text("broken off", timeout=60000)
        expect(page.locator("#scene option:checked")).to_have_text("PortalCraneSynthesis_synth")
        seen.context.close()


def test_speed_against_accuracy_is_measured_from_the_page(chromium):
    with serving(ROOT / "models/scenes/rope_motion.toml") as served:
        seen = Seen(chromium, served)
        page = seen.page
        page.click("#tab-work")
        page.click("[data-begin=trade]")
        expect(page.locator("#said img")).to_be_visible(timeout=120000)
        assert page.evaluate("document.querySelector('#said img').naturalWidth") > 0
        expect(page.locator("#said pre")).to_contain_text("a cycle through the working range")
        assert seen.wrong == []
        seen.context.close()


def test_of_many_quick_keys_the_last_one_counts(seen):
    page = seen.page
    seen.caret_behind('X_8 = "5')
    page.keyboard.type("0" * 100)
    for _ in range(100):
        page.keyboard.press("Backspace")
    page.keyboard.type("5")
    expect(page.locator("#verdict li", has_text="Greatest reach of the working range")).to_contain_text("= 79.98")
    expect(page.locator("#mistakes")).to_contain_text("No mistakes")
    assert page.locator("#stale").is_hidden()


def test_a_file_is_saved_and_followed(chromium, tmp_path):
    file = tmp_path / "crane.toml"
    file.write_text(TEXT, encoding="utf-8")
    with serving(file) as served:
        seen = Seen(chromium, served)
        page = seen.page
        assert page.locator("#save").is_disabled()
        seen.write(TEXT.replace("Lemniscate level", "起重机 level"))
        expect(page.locator("#save")).to_be_enabled()
        assert file.read_text(encoding="utf-8") == TEXT, "not before it is asked for"
        page.keyboard.press("ControlOrMeta+s")
        expect(page.locator("#notice")).to_contain_text("is saved")
        assert file.read_text(encoding="utf-8") == TEXT.replace("Lemniscate level", "起重机 level")
        # Another program writes: it is followed while nothing is unsaved here.
        file.write_text(TEXT.replace("Lemniscate level", "Elsewhere level"), encoding="utf-8")
        expect(page.locator("#title")).to_contain_text("Elsewhere level", timeout=10000)
        page.locator(".cm-content").focus()
        page.keyboard.press("ControlOrMeta+End")
        page.keyboard.type("# mine")
        file.write_text(TEXT, encoding="utf-8")
        page.keyboard.press("ControlOrMeta+s")
        expect(page.locator("#notice")).to_contain_text("changed by another program")
        assert file.read_text(encoding="utf-8") == TEXT
        assert [wrong for wrong in seen.wrong if "409" not in wrong] == []
        seen.context.close()


def test_the_keyboard_reaches_everything(seen):
    page = seen.page
    controls = page.evaluate("""() => [...document.querySelectorAll('button, select, input, summary')]
        .filter((e) => e.checkVisibility() && !e.disabled && e.tabIndex >= 0).length""")
    page.evaluate("document.body.focus()")
    reached = set()
    for _ in range(controls + 20):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("""() => { const e = document.activeElement; e.dataset.reached = 1; return e.id; }"""))
    missed = page.evaluate("""() => [...document.querySelectorAll('button, select, input, summary')]
        .filter((e) => e.checkVisibility() && !e.disabled && e.tabIndex >= 0 && !e.dataset.reached).map((e) => e.outerHTML)""")
    assert missed == [] and {"scene", "open-gallery", "play", "position", "editor"} <= reached
    # Names for all of them.
    unnamed = page.evaluate("""() => [...document.querySelectorAll('button, select, input, summary, [role=img]')]
        .filter((e) => !(e.textContent.trim() || e.getAttribute('aria-label') || e.closest('label'))).map((e) => e.outerHTML)""")
    assert unnamed == []
    page.focus("#tab-curves")
    page.keyboard.press("ArrowRight")
    assert page.locator("#tab-table").get_attribute("aria-selected") == "true" and page.locator("#table").is_visible()


@pytest.mark.parametrize("size", [(1280, 720), (360, 740)])
def test_it_fits(chromium, served, size):
    seen = Seen(chromium, served, size)
    for code in ("en", "zh", "bg"):
        seen.page.select_option("#language", code)
        expect(seen.page.locator("#save")).to_have_text(words(code)["page"]["save"])
        for tab in ("curves", "table", "comparison"):
            seen.page.click(f"#tab-{tab}")
            width, height = seen.page.evaluate("[document.scrollingElement.scrollWidth, document.scrollingElement.scrollHeight]")
            assert width <= size[0] and (size[0] < 900 or height <= size[1]), (code, tab)
    assert seen.wrong == []
    seen.context.close()


def test_dark_has_contrast(chromium, served):
    """Text on its ground has at least 4.5 to 1, as WCAG 2 asks, in light and dark."""
    def luminance(colour):
        parts = [int(part) / 255 for part in re.findall(r"\d+", colour)[:3]]
        linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    for scheme in ("light", "dark"):
        context = chromium.new_context(color_scheme=scheme)
        page = context.new_page()
        page.goto(served.address)
        colours = page.evaluate("""() => { const probe = document.body.appendChild(document.createElement('p'));
            const of = (name) => { probe.style.color = `var(--${name})`; return getComputedStyle(probe).color; };
            return Object.fromEntries(['paper', 'ground', 'text', 'quiet', 'accent', 'bad', 'good', 'key', 'string', 'number'].map((n) => [n, of(n)])); }""")
        paper = luminance(colours["paper"])
        assert (paper > 0.5) == (scheme == "light")
        for name in ("text", "quiet", "accent", "bad", "good", "key", "string", "number"):
            light, dark = sorted([luminance(colours[name]), paper], reverse=True)
            assert (light + 0.05) / (dark + 0.05) >= 4.5, (scheme, name)
        context.close()


def test_the_bundle_is_made_of_its_sources(tmp_path):
    """`npm ci && npm run build` gives the same bytes again."""
    copy = tmp_path / "page"
    shutil.copytree(PAGE, copy, ignore=shutil.ignore_patterns("node_modules", "dist"))
    (copy / "dist").mkdir()
    # Node is a package of the environment.
    environment = dict(os.environ, PATH=os.pathsep.join([str(PYTHON.parent), os.environ["PATH"]]))
    npm = shutil.which("npm", path=environment["PATH"])
    assert npm, "no Node: python3 tests/run.py sets it up"
    for arguments in (["ci", "--no-audit", "--no-fund", "--ignore-scripts"], ["run", "build"]):
        done = subprocess.run([npm, *arguments], cwd=copy, env=environment, capture_output=True, text=True, encoding="utf-8")
        assert done.returncode == 0, done.stderr
    made = {path.name: path.read_bytes() for path in (copy / "dist").iterdir()}
    assert set(made) == {path.name for path in (PAGE / "dist").iterdir()}
    changed = [name for name, bytes in made.items() if bytes != (PAGE / "dist" / name).read_bytes()]
    assert changed == [], "npm run build in serve/page makes them anew"
    lock = json.loads((PAGE / "package-lock.json").read_text(encoding="utf-8"))
    assert not [name for name, package in lock["packages"].items() if "resolved" in package], "no registry is named"
    wanted = json.loads((PAGE / "package.json").read_text(encoding="utf-8"))["devDependencies"]
    assert all(re.fullmatch(r"\d+\.\d+\.\d+", version) for version in wanted.values())

"""Figures of the page beside their goals: `.venv/bin/python tests/page_goals.py`, after a build. Nothing here fails."""

import gzip
import statistics
import sys
import time
from pathlib import Path

from playwright.sync_api import sync_playwright

from conftest import ROOT
from run import browser
from test_serve import SCENE, serving

KEYS = 20
# Notes when a key goes down, when the results of a text are there, and when its runs in time are there too.
WATCH = """() => {
    window.keys = []; window.shown = []; window.whole = [];
    addEventListener("keydown", () => window.keys.push(performance.now()), true);
    const told = () => {
        const now = performance.now();
        window.shown.push(now);
        if (!document.querySelector("#verdict .awaited")) window.whole.push(now);
    };
    new MutationObserver(told).observe(document.getElementById("verdict"), { childList: true });
}"""
# Every frame another position, for two seconds; the time between frames.
SLIDE = """() => new Promise((done) => {
    const slider = document.getElementById("position"), frames = [];
    const begun = performance.now();
    const step = (now) => {
        frames.push(now);
        slider.value = (Number(slider.value) + 1) % (Number(slider.max) + 1);
        slider.dispatchEvent(new Event("input"));
        if (now - begun < 2000) requestAnimationFrame(step); else done(1000 * (frames.length - 1) / (frames.at(-1) - frames[0]));
    };
    requestAnimationFrame(step);
})"""


def row(what, value, unit, goal, least=False):
    reached = value >= goal if least else value <= goal
    print(f"{what:<60} {value:>8.1f} {unit:<4} goal {goal:>6} {unit:<4} {'reached' if reached else 'MISSED'}", flush=True)


def memory(process):
    """Resident, in MB; where the system tells it."""
    status = Path(f"/proc/{process}/status")
    return int(status.read_text().split("VmRSS:")[1].split()[0]) / 1024 if status.exists() else float("nan")


def opened(chromium, served):
    page = chromium.new_page(viewport={"width": 1280, "height": 720})
    page.goto(served.address)
    page.locator("#verdict .results").first.wait_for()
    return page


def keystrokes(chromium):
    for scene in sorted((ROOT / "models/scenes").glob("*.toml")):
        with serving(scene) as served:
            page = opened(chromium, served)
            page.evaluate(WATCH)
            page.locator(".cm-content").focus()
            page.keyboard.press("ControlOrMeta+End")
            page.keyboard.type("\n#")
            took = []
            for _ in range(KEYS):
                page.wait_for_timeout(100)
                page.evaluate("() => { keys.length = shown.length = whole.length = 0; }")
                page.keyboard.press("x")
                page.wait_for_function("() => whole.length > 0")
                took.append(page.evaluate("[shown[0] - keys[0], whole[0] - keys[0], whole[0] > shown[0]]"))
            first, all_of_it, awaited = (sorted(each)[int(0.95 * len(each)) - 1] for each in zip(*took))
            row(f"{scene.stem}: keystroke to results, 95 of 100", first, "ms", 100)
            if awaited:
                print(f"{'… with its runs in time':<60} {all_of_it:>8.1f} ms", flush=True)
            page.close()


def main():
    bundle = sum(len(gzip.compress((ROOT / "serve/page/dist" / name).read_bytes(), 9)) for name in ("page.js", "page.css"))
    row("bundle, gzipped", bundle / 1e3, "kB", 200)
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=browser(), args=["--no-sandbox", "--disable-gpu"])
        started = time.perf_counter()
        with serving() as served:
            page = opened(chromium, served)
            row("first results after the command", 1e3 * (time.perf_counter() - started), "ms", 1000)
            page.locator("#choice summary").click()
            for box in page.locator("#choice input[type=checkbox]").all():
                box.check()
            page.locator("#choice summary").click()
            row("slider with all curves", page.evaluate(SLIDE), "1/s", 50, least=True)
            page.click("#tab-book")
            page.locator("#pages img").first.wait_for()
            page.wait_for_function("() => !document.getElementById('book-state').textContent")
            took = []
            page.locator(".cm-content").focus()
            page.keyboard.press("ControlOrMeta+End")
            page.keyboard.type("\n#")
            page.wait_for_timeout(4000)
            for _ in range(5):
                before = page.locator("#pages img").first.get_attribute("data-hash")
                begun = time.perf_counter()
                page.keyboard.type("x")
                page.wait_for_function("before => document.querySelector('#pages img').dataset.hash !== before", arg=before, polling=10)
                took.append(1e3 * (time.perf_counter() - begun))
                page.wait_for_timeout(1500)
            row("changed page of the book after the last key", statistics.median(took), "ms", 500)
            text = SCENE.read_text(encoding="utf-8")
            found = {}
            for edit in range(1, 1001):
                served.ask("answer", text=f"{text}#{edit}", language="en", page=1, edit=edit)
                found[edit] = memory(served.process)
            row("memory after 1000 edits, of that after 10", found[1000] / found[10], "", 1.5)
        keystrokes(chromium)
        chromium.close()


if __name__ == "__main__":
    sys.exit(main())

"""`lemnis serve`: who may ask, what is answered, and what stays as it is."""

import json
import re
import signal
import socket
import subprocess
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from http.client import HTTPConnection
from urllib.parse import parse_qs, urlparse

import pytest

from conftest import LEMNIS, ROOT, lemnis

SCENE = ROOT / "models/scenes/lemniscate.toml"
LARGEST = 2 << 20


class Served:
    """A page that is served, with the token of its run."""

    def __init__(self, address, process=None):
        self.address, self.process = address, process
        self.port = urlparse(address).port
        self.token = parse_qs(urlparse(address).query)["token"][0]
        self.host = f"127.0.0.1:{self.port}"

    def request(self, method, path, body=None, without=(), **headers):
        """Status, headers and body; `without` names headers that are left out, the others replace what the page sends."""
        own = {"host": self.host}
        if method == "POST":
            own |= {"origin": f"http://{self.host}", "x-token": self.token, "content-type": "application/json"}
        own |= {name.replace("_", "-"): value for name, value in headers.items()}
        connection = HTTPConnection("127.0.0.1", self.port, timeout=60)
        connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
        for name, value in own.items():
            if name not in without:
                for one in value if isinstance(value, list) else [value]:
                    connection.putheader(name, one)
        data = None if body is None else json.dumps(body).encode()
        if data is not None:
            connection.putheader("content-length", str(len(data)))
        connection.endheaders(data)
        reply = connection.getresponse()
        found = reply.status, {name.lower(): value for name, value in reply.getheaders()}, reply.read()
        connection.close()
        return found

    def ask(self, question, /, expect=200, **body):
        status, headers, found = self.request("POST", f"/api/{question}", body)
        assert status == expect, found[:500]
        return json.loads(found) if headers["content-type"] == "application/json" else found


@contextmanager
def serving(*arguments):
    command = [str(LEMNIS), "serve", "--no-open", *map(str, arguments)]
    program = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, encoding="utf-8")
    try:
        address = program.stdout.readline().strip()
        assert address.startswith("http://127.0.0.1:"), program.stderr.read()
        yield Served(address, program.pid)
    finally:
        program.terminate()
        program.communicate()


@pytest.fixture(scope="module")
def served():
    with serving() as one:
        yield one


def test_results_at_rest_come_without_runs_in_time(served):
    text = (ROOT / "models/scenes/portal_crane.toml").read_text(encoding="utf-8")
    asked = {"text": text, "language": "en", "page": 77, "edit": 1}
    first, whole = (served.ask("answer", **asked, at_rest=at_rest)["shown"] for at_rest in (True, False))
    assert first["awaits_runs"] and not whole["awaits_runs"] and first["runs"] and whole["runs"]
    for same in ("governing", "summary", "columns", "curves", "drawing"):
        assert first[same] == whole[same], same
    known = [identity["of"] for identity in first["identities"]]
    assert known == [identity["of"] for identity in whole["identities"]][: len(known)]
    assert len(whole["identities"]) > len(known) > 0


def test_it_listens_to_this_machine_alone(served):
    # All of 127/8 is this machine: what listens on every address would be there too.
    with pytest.raises(OSError):
        socket.create_connection(("127.0.0.2", served.port), timeout=2)
    assert len(served.token) == 32
    with serving() as other:
        assert other.token != served.token


@pytest.mark.parametrize("host", ["evil.example", "evil.example:{}", "127.0.0.1", "127.0.0.1.evil.example:{}", "[::1]:{}",
                                  "127.0.0.1:{}@evil.example", None, "twice"])
def test_a_foreign_host_is_refused(served, host):
    """A name of someone else that leads here, as in DNS rebinding."""
    own = {"host": [served.host] * 2} if host == "twice" else {"host": (host or "").format(served.port)}
    without = ("host",) if host is None else ()
    for method, path in [("GET", f"/?token={served.token}"), ("GET", "/page.js"), ("POST", "/api/start")]:
        status, _, body = served.request(method, path, {} if method == "POST" else None, without, **own)
        assert status in (400, 403) and served.token.encode() not in body and b"words" not in body


def test_a_request_for_another_place_is_refused(served):
    status, _, _ = served.request("GET", f"http://evil.example/?token={served.token}")
    assert status == 403


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "https://127.0.0.1:{}", "http://127.0.0.1", None])
def test_a_foreign_origin_is_refused(served, origin):
    """A form or a script of another page that has the token from somewhere."""
    without = ("origin",) if origin is None else ()
    status, _, body = served.request("POST", "/api/start", {}, without, origin=(origin or "").format(served.port))
    assert status == 403 and b"words" not in body


def test_without_the_token_nothing_is_told(served):
    for token in ("", "0" * 32, served.token[:-1], served.token.upper() + " "):
        assert served.request("POST", "/api/start", {}, x_token=token)[0] == 403
        assert served.request("GET", f"/?token={token}".replace(" ", "%20"))[0] == 403
    assert served.request("POST", "/api/start", {}, ("x-token",))[0] == 403
    for path in ("/", "/?", "/book/00.svg", "/nothing"):
        status, _, body = served.request("GET", path)
        assert status == 403 and b"with its token" in body
    assert served.request("GET", f"/?token={served.token}")[0] == 200
    # Neither is the address of the page the way to ask.
    assert served.request("POST", f"/api/start?token={served.token}", {}, ("x-token",))[0] == 403


def test_every_reply_is_protected(served):
    replies = [served.request("GET", f"/?token={served.token}"), served.request("GET", "/page.js"),
               served.request("POST", "/api/start", {}), served.request("GET", "/", host="evil.example"),
               served.request("OPTIONS", "/api/start", origin="http://evil.example", access_control_request_method="POST"),
               served.request("PUT", "/api/save", {}), served.request("GET", f"/none?token={served.token}")]
    assert [status for status, *_ in replies] == [200, 200, 200, 403, 405, 405, 404]
    for _, headers, _ in replies:
        policy = headers["content-security-policy"]
        assert policy.startswith("default-src 'self'") and "unsafe" not in policy and "frame-ancestors 'none'" in policy
        assert headers["x-content-type-options"] == "nosniff" and headers["referrer-policy"] == "no-referrer"
        assert not [name for name in headers if name.startswith("access-control")]
    assert "no-store" in replies[2][1]["cache-control"]
    page = replies[0][2].decode()
    # Nothing from elsewhere, nothing inline.
    assert not re.search(r"https?://|<script>|<style|\son\w+=|style=", page)


@pytest.mark.parametrize("path", ["/../Cargo.toml", "/book/../Cargo.toml", "/book/..%2f..%2fCargo.toml.svg", "/page/../page.js",
                                  "//etc/passwd", "/book/.svg", "/%2e%2e/Cargo.toml"])
def test_no_path_leads_out(served, path):
    status, _, body = served.request("GET", f"{path}?token={served.token}")
    assert status in (400, 404) and b"workspace" not in body and b"root:" not in body


@pytest.mark.parametrize("scene", ["../Cargo", "/etc/passwd", str(SCENE), "lemniscate.toml", "0", "-1", ""])
def test_no_path_comes_from_the_page(served, scene):
    assert served.ask("open", expect=409, scene=scene) == b"there is no such scene"
    told = served.ask("save", expect=409, scene=scene, text="", hash="")
    assert b"opened for reading" in told


def test_nothing_else_is_asked(served):
    assert served.request("POST", "/api/nothing", {})[0] == 404
    assert served.request("POST", "/api/answer", {"path": "x"})[0] == 400
    assert served.request("POST", "/api/answer", "text")[0] == 400


def test_a_hundred_megabytes_are_not_read(served):
    status, _, _ = served.request("POST", "/api/answer", None, content_length=str(100 << 20))
    assert status == 413
    # Without a length in the head: after what a scene may have at most, nothing more is taken.
    sent, piece = 0, b"10000\r\n" + b"x" * 0x10000 + b"\r\n"
    head = (f"POST /api/answer HTTP/1.1\r\nhost: {served.host}\r\norigin: http://{served.host}\r\n"
            f"x-token: {served.token}\r\ntransfer-encoding: chunked\r\n\r\n")
    with socket.create_connection(("127.0.0.1", served.port), timeout=30) as connection:
        connection.sendall(head.encode())
        try:
            while sent < 100 << 20:
                connection.sendall(piece)
                sent += len(piece)
        except OSError:
            pass
    # What lies in the system's buffers between the two counts as sent.
    assert sent < 50 << 20
    assert served.ask("start")["files"] == []


def test_what_comes_slowly_is_given_up_and_holds_nothing(served):
    head = (f"POST /api/answer HTTP/1.1\r\nhost: {served.host}\r\norigin: http://{served.host}\r\n"
            f"x-token: {served.token}\r\ncontent-length: 1000\r\n\r\n")
    with ThreadPoolExecutor(2) as threads:
        def trickle(begin):
            with socket.create_connection(("127.0.0.1", served.port), timeout=60) as connection:
                connection.sendall(begin.encode())
                reply = b""
                while True:
                    try:
                        connection.sendall(b" ")
                        connection.settimeout(0.5)
                        part = connection.recv(1000)
                    except TimeoutError:
                        continue
                    except OSError:
                        return reply
                    if not part:
                        return reply
                    reply += part
        slow = [threads.submit(trickle, begin) for begin in (head, head[:60])]
        assert served.ask("start")["files"] == [] and not any(one.done() for one in slow)
        body, beginning = [one.result() for one in slow]
    assert body.startswith(b"HTTP/1.1 408")
    # Nothing can be said to half a head.
    assert not beginning or b" 40" in beginning


def test_a_thousand_quick_edits_are_answered_and_the_last_one_counts(served):
    text = SCENE.read_text(encoding="utf-8")
    count = 1000

    def edit(number):
        body = {"text": text.replace('X_1 = "19.3 m"', f'X_1 = "{19 + number / 10000:.4f} m"'), "language": "en", "page": 7, "edit": number}
        status, _, found = served.request("POST", "/api/answer", body)
        return status, found

    with ThreadPoolExecutor(24) as threads:
        found = list(threads.map(edit, range(1, count + 1)))
    statuses = [status for status, _ in found]
    assert set(statuses) == {200, 409} and statuses[-1] == 200
    # One that was overtaken while it waited is not computed.
    assert statuses.count(409) > 0
    last = json.loads(found[-1][1])["shown"]
    assert next(said["text"] for said in last["given"] if said["key"] == "luffing.X_1") == "19.1000 m"
    # Another page has edits of its own.
    assert served.ask("answer", text=text, language="en", page=8, edit=1)["diagnostics"] == []


def test_titles_are_data(served):
    title = "<script>alert(1)</script>"
    text = SCENE.read_text(encoding="utf-8").replace("Lemniscate level-luffing crane 16 t × 30 m", title)
    status, headers, body = served.request("POST", "/api/answer", {"text": text, "language": "en", "page": 1, "edit": 1})
    assert (status, headers["content-type"]) == (200, "application/json") and json.loads(body)["shown"]["title"] == title


def test_the_page_knows_the_words_of_every_language(served):
    start = served.ask("start")
    assert [language["code"] for language in start["languages"]] == ["en", "zh", "bg"]
    for group in ("page", "head", "level", "caption", "chapter"):
        assert len({frozenset(language["words"][group]) for language in start["languages"]}) == 1
    sources = "".join(path.read_text(encoding="utf-8") for path in [ROOT / "serve/page/index.html", *(ROOT / "serve/page/src").glob("*.js")])
    used = set(re.findall(r"""["`]((?:page|head|level|caption|chapter)\.\w+)["`]""", sources))
    known = {f"{group}.{id}" for group, words in start["languages"][0]["words"].items() for id in words}
    # What a drawing has for the page alone is called by the word of its id.
    asides = re.findall(r'self\.aside\("(\w+)"', (ROOT / "models/src/component/draw.rs").read_text(encoding="utf-8"))
    assert asides
    used |= {f"page.{of}" for of in asides}
    assert used <= known, used - known
    # Beside what the page says there are words of its language's name, and those that other parts of the program use.
    unused = {id for id in known - used if id.startswith("page.")} - {"page.own_name", "page.part_of_range"}
    assert not unused


def test_ready_scenes_are_there(served):
    ready = served.ask("gallery", language="bg")
    assert {scene["id"] for scene in ready} == {path.stem for path in (ROOT / "models/scenes").glob("*.toml")}
    for scene in ready[:3]:
        opened = served.ask("open", scene=scene["id"])
        assert opened["text"] == (ROOT / f"models/scenes/{scene['id']}.toml").read_text(encoding="utf-8") and not opened["writable"]


@pytest.mark.parametrize("what", ["fmu", "pdf"])
def test_what_is_downloaded_is_what_build_makes(served, out, what):
    made = served.ask("make", text=SCENE.read_text(encoding="utf-8"), language="en", what=what)
    assert made == (out / f"LemniscateCrane.{what}").read_bytes()


def test_results_are_those_of_check(served):
    text = SCENE.read_text(encoding="utf-8")
    for what in ("csv", "json"):
        assert served.ask("make", text=text, language="en", what=what).decode() == lemnis("check", SCENE, f"--{what}")
    # A limit that is not kept is told by the results themselves.
    broken = re.sub(r'(mu_min *=) "30 deg"', r'\1 "60 deg"', text)
    assert broken != text and b'"passed": false' in served.ask("make", text=broken, language="en", what="json")


def test_what_cannot_be_made_is_told(served):
    told = served.ask("make", expect=422, text="[luffing]", language="en", what="pdf").decode()
    assert "is missing in [luffing]" in told
    assert b"nothing is made" in served.ask("make", expect=422, text=SCENE.read_text(encoding="utf-8"), language="en", what="../x")


def ended(served, task):
    while True:
        stand = served.ask("look", task=task)
        if stand["ended"]:
            return stand
        time.sleep(0.1)


def test_work_that_fails_says_why(served):
    """A scene that asks for no synthesis: as the command says it, without the names of files that nobody knows."""
    text = SCENE.read_text(encoding="utf-8")
    stand = ended(served, served.ask("begin", what="synth", text=text)["task"])
    assert stand["ended"]["failed"] and stand["ended"]["printed"].startswith("scene asks for no synthesis")
    assert stand["ended"]["scene"] is None and stand["picture"] is None
    assert b"not TOML" in served.ask("begin", expect=422, what="synth", text="nonsense")


def test_work_is_one_at_a_time(served):
    """What is begun takes the place of what runs, which ends; of that nothing can be asked any more."""
    text = (ROOT / "models/scenes/portal_004_synthesis.toml").read_text(encoding="utf-8")
    first = served.ask("begin", what="synth", text=text)["task"]
    second = served.ask("begin", what="synth", text=text)["task"]
    served.ask("look", expect=404, task=first)
    served.ask("stop", task=second)
    stand = ended(served, second)
    assert not stand["ended"]["failed"] and "broken off" in stand["ended"]["printed"]
    assert "PortalCraneSynthesis_synth" in stand["ended"]["scene"]


def test_runs_are_those_of_the_book(served):
    text = (ROOT / "models/scenes/portal_crane.toml").read_text(encoding="utf-8")
    runs = served.ask("runs", text=text, language="en")
    assert ["".join(piece for piece, _ in run["name"]) for run in runs][:2] == ["Luffing in", "Luffing out"]
    for run in runs:
        frames = len(run["time"]["texts"])
        assert frames > 50 and len(run["drawing"]["positions"]) == frames
        assert len(run["hangs"]) == len(run["slewed"]) == frames
        # The hoist lifts, and the rope stretches a little under the load.
        assert all(5 < sum(part**2 for part in rope) ** 0.5 < 18.5 for rope in run["hangs"])
    assert served.ask("runs", text="nonsense", language="en") == []


def test_pages_of_the_book_are_known_by_their_hash(served):
    text = SCENE.read_text(encoding="utf-8")
    book = served.ask("book", text=text, language="zh", level="summary")
    first = book["sheets"]
    assert book["places"] == {}, "a summary has no formulas"
    page = served.request("GET", f"/book/{first[0]['hash']}.svg?token={served.token}")
    assert page[0] == 200 and page[1]["content-type"] == "image/svg+xml" and b"<svg" in page[2]
    assert "immutable" in page[1]["cache-control"] and served.request("GET", f"/book/{first[0]['hash']}.svg")[0] == 403
    assert [first[0][side] for side in ("width", "height")] == pytest.approx([595.28, 841.89], abs=0.01)
    assert served.ask("book", text=text, language="zh", level="summary") == book


def test_a_book_says_on_which_page_each_symbol_is_explained(served):
    book = served.ask("book", text=SCENE.read_text(encoding="utf-8"), language="bg", level="standard")
    pages = range(1, len(book["sheets"]) + 1)
    assert len(book["places"]) > 50 and set(book["places"].values()) <= set(pages)
    assert book["places"]["X_1"] < book["places"]["mu"]


TEXT = "title = \"起重机 ° кран\"\r\n"


def test_a_file_is_saved_when_it_is_asked_for_and_only_over_what_was_read(tmp_path):
    file, other = tmp_path / "crane.toml", tmp_path / "other.toml"
    file.write_bytes(TEXT.encode())
    other.write_bytes(b"")
    link = tmp_path / "link.toml"
    link.symlink_to(file)
    with serving(link, other) as served:
        opened = served.ask("open", scene="0")
        assert (opened["text"], opened["writable"]) == (TEXT, True)
        text = TEXT + "# 起重机\n"
        hash = served.ask("save", scene="0", text=text, hash=opened["hash"])
        assert file.read_bytes() == text.encode() and link.is_symlink()
        # The next change follows this one.
        hash = served.ask("save", scene="0", text=TEXT, hash=hash)
        file.write_text("someone else's", encoding="utf-8")
        told = served.ask("save", expect=409, scene="0", text=text, hash=hash)
        assert b"changed by another program" in told and file.read_text(encoding="utf-8") == "someone else's"
        assert served.ask("save", expect=409, scene="2", text=text, hash=hash)
    assert other.read_bytes() == b"" and len(list(tmp_path.iterdir())) == 3


def test_read_only_is_kept(tmp_path):
    file = tmp_path / "crane.toml"
    file.write_text(TEXT, encoding="utf-8", newline="")
    with serving(file, "--read-only") as served:
        opened = served.ask("open", scene="0")
        assert not opened["writable"]
        assert served.ask("save", expect=409, scene="0", text="", hash=opened["hash"])
    assert file.read_bytes() == TEXT.encode()


def test_what_cannot_be_served_is_told_at_once(tmp_path, served):
    assert "cannot read the scene" in lemnis("serve", tmp_path / "none.toml", expect=3)
    (tmp_path / "picture.toml").write_bytes(b"\xff\xd8")
    assert "UTF-8" in lemnis("serve", tmp_path / "picture.toml", expect=3)
    told = lemnis("serve", "--port", served.port, expect=3)
    assert f"port {served.port}" in told and "--port" in told
    assert "name a file" in lemnis("serve", "-", expect=3)


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="Windows sends no Ctrl+C to a child alone")
def test_control_c_ends_it_and_what_it_has_begun():
    program = subprocess.Popen([str(LEMNIS), "serve", "--no-open"], stdout=subprocess.PIPE, text=True)
    served = Served(program.stdout.readline().strip())
    asked = threading.Thread(target=lambda: served.request("POST", "/api/book", {"text": SCENE.read_text("utf-8"), "language": "en"}), daemon=True)
    threading.excepthook = lambda _: None
    asked.start()
    time.sleep(0.3)
    program.send_signal(signal.SIGINT)
    assert program.wait(timeout=20) == 0
    asked.join(timeout=20)
    assert not asked.is_alive()

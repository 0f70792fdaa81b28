"""The documents say what is there."""

import re
import subprocess
import sys

import pytest

from conftest import ROOT, lemnis


@pytest.mark.parametrize("document", ["README.md", "ARCHITECTURE.md"])
def test_every_path_named_exists(document):
    text = (ROOT / document).read_text(encoding="utf-8")
    folders = "models|fmu|report|serve|python|templates|tests|docs"
    paths = set(re.findall(rf"[`(]((?:{folders})/[\w./-]*|[A-Z]+\.md|clippy\.toml)[`)]", text))
    assert len(paths) > 5
    for path in paths:
        assert (ROOT / path).exists(), f"{document} names {path}"


def test_architecture_is_short():
    assert len((ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8").splitlines()) <= 150


def test_the_readme_example_runs(out, tmp_path):
    code = re.search(r"```python\n(from fmpy.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.S).group(1)
    assert len([line for line in code.splitlines() if line.strip()]) <= 10
    code = code.replace("out/LemniscateCrane.fmu", (out / "LemniscateCrane.fmu").as_posix())
    done = subprocess.run([sys.executable, "-X", "utf8", "-c", code], capture_output=True, text=True,
                          encoding="utf-8", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert "R = 29.9766 m" in lines[0] and "M_Q = -243.9938" in lines[0]


def test_the_starter_scene_builds(tmp_path):
    scene = tmp_path / "crane.toml"
    lemnis("new", scene)
    assert "wrote" in lemnis("fmu", scene, "--output", tmp_path)
    # It never overwrites.
    assert "exists already" in lemnis("new", scene, expect=3)


def test_the_schema_accepts_what_the_program_accepts():
    import json
    import tomllib

    schema = json.loads(lemnis("schema"))

    def check(value, schema, path):
        if "if" in schema:
            named = {key: each["const"] for key, each in schema["if"]["properties"].items()}
            meant = all(value.get(key) == const for key, const in named.items())
            check(value, schema["then" if meant else "else"], path)
        elif "anyOf" in schema:
            kind = "object" if isinstance(value, dict) else "string"
            check(value, next(each for each in schema["anyOf"] if each["type"] == kind), path)
        elif schema["type"] == "array":
            assert isinstance(value, list), path
            for inner in value:
                check(inner, schema["items"], path)
        elif schema["type"] == "object":
            assert isinstance(value, dict), path
            named, any_other = schema.get("properties", {}), schema.get("additionalProperties")
            assert set(schema.get("required", [])) <= set(value), path
            assert any_other or set(value) <= set(named), path
            for key, inner in value.items():
                check(inner, named.get(key, any_other), f"{path}.{key}")
        elif schema["type"] == "integer":
            assert isinstance(value, int) and schema["minimum"] <= value <= schema["maximum"], path
        else:
            assert isinstance(value, str), path
            assert "enum" not in schema or value in schema["enum"], path
            assert "pattern" not in schema or re.search(schema["pattern"], value), path

    for name in ("lemniscate", "rope_luffing", "ellipsograph", "curved_trunk"):
        check(tomllib.loads((ROOT / f"models/scenes/{name}.toml").read_text(encoding="utf-8")), schema, name)


def test_publications_are_cited_and_listed():
    import tomllib

    listed = tomllib.loads((ROOT / "templates/references.toml").read_text(encoding="utf-8"))
    paths = [*(ROOT / "models/src").rglob("*.rs"), *(ROOT / "models/scenes").glob("*.toml"), *(ROOT / "templates/words/en").glob("*.toml")]
    sources = "".join(path.read_text(encoding="utf-8") for path in paths)
    assert set(re.findall(r"\[([A-Z][A-Za-z]+\d{3,4}|ISO \d+(?:-\d)?|Rothe Erde|46 CFR 173|IS Code 2008)\b", sources)) == set(listed)

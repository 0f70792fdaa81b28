"""How the code is arranged: floors that see only what lies below them, and no circles of files."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# Each crate's sources, by the name that others call it.
CRATES = {
    "lemnis_models": "models/src",
    "lemnis_study": "models/study/src",
    "lemnis_synthesis": "models/synthesis/src",
    "lemnis_trade": "models/trade/src",
    "lemnis_fmu": "fmu/src",
    "lemnis_typeset": "report/typeset/src",
    "lemnis_serve": "serve/src",
    "lemnis": "report/src",
    "_lemnis": "python/src",
}


def plain(text):
    """The code without comments, texts and tests."""
    token = r"""//[^\n]*|/\*.*?\*/|'(?:\\.|[^'\\])'|b?r\#".*?"\#|b?"(?:[^"\\]|\\.)*\""""
    text = re.sub(token, "", text, flags=re.S)
    return re.sub(r"#\[cfg\(test\)\]\s*mod tests \{.*\Z", "", text, flags=re.S)


def expanded(tree):
    """The paths of a `use` tree, each with the name that it brings."""
    tree = tree.strip()
    if "{" in tree:
        head, rest = tree.split("{", 1)
        parts, depth, start = [], 0, 0
        rest = rest[: rest.rindex("}")]
        for i, char in enumerate(rest):
            depth += (char == "{") - (char == "}")
            if char == "," and depth == 0:
                parts.append(rest[start:i])
                start = i + 1
        parts.append(rest[start:])
        for part in filter(str.strip, parts):
            for path, name in expanded(part):
                path = head.strip() + path
                yield (path.removesuffix("::self"), path.split("::")[-2] if path.endswith("::self") else name)
        return
    path, _, alias = tree.partition(" as ")
    path = path.strip()
    yield path, (alias or path.split("::")[-1]).strip()


class Crate:
    def __init__(self, name, folder):
        self.name = name
        self.files = {}
        for path in sorted((ROOT / folder).rglob("*.rs")):
            parts = list(path.relative_to(ROOT / folder).with_suffix("").parts)
            if parts[-1] in ("lib", "main", "mod"):
                parts.pop()
            self.files.setdefault(tuple(parts), []).append(path)


def needs():
    """Of each file the files whose items it names: by `use`, `crate::`, `super::`, `self::` and paths through modules."""
    crates = {name: Crate(name, folder) for name, folder in CRATES.items()}
    found = {}
    for crate in crates.values():
        for module, paths in crate.files.items():
            for path in paths:
                found[path] = named(crates, crate, module, path)
    return found


def named(crates, crate, module, path):
    code = plain(path.read_text(encoding="utf-8"))
    uses = [one for tree in re.findall(r"\buse\s+([^;]+);", code) for one in expanded(tree.replace("\n", " "))]
    rest = re.sub(r"\buse\s+[^;]+;", "", code)
    paths = re.findall(r"(?<![\w:])((?:\$?[A-Za-z_]\w*::)+[A-Za-z_]\w*)", rest)
    names = {name: target for target, name in uses}
    children = {parts[-1] for parts in crate.files if parts[:-1] == module and parts}

    def absolute(target, seen=()):
        head, *tail = target.replace("$", "").split("::")
        if head == "crate":
            return crate.name, tail
        if head == "self":
            return crate.name, [*module, *tail]
        if head == "super":
            up = list(module)
            while head == "super":
                up = up[:-1]
                head, *tail = tail or ["super"][:0] or [""]
            return crate.name, [*up, head, *tail]
        if head in crates:
            return head, tail
        if head in names and head not in seen and names[head] != target:
            return absolute("::".join([names[head], *tail]), (*seen, head))
        if head in children:
            return crate.name, [*module, head, *tail]
        return None

    needed = set()
    for target in [target for target, _ in uses] + paths:
        place = absolute(target)
        if place is None or place[0] not in crates:
            continue
        files = crates[place[0]].files
        parts = tuple(place[1])
        # The longest part of the path that is a module: what follows is an item of it.
        depth = max((n for n in range(len(parts) + 1) if parts[:n] in files), default=None)
        # A path to a module itself names none of its items.
        if depth is None or (depth == len(parts) and depth > 0 and target in dict(uses)):
            continue
        needed.update(file for file in files[parts[:depth]] if file != path)
    return needed


def circles(graph):
    """Sets of files that need each other, directly or round about."""
    index, low, stack, on, found = {}, {}, [], set(), []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        on.add(node)
        for other in graph[node]:
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in on:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            circle = []
            while not circle or circle[-1] != node:
                circle.append(stack.pop())
                on.discard(circle[-1])
            if len(circle) > 1:
                found.append(sorted(circle))

    for node in graph:
        if node not in index:
            visit(node)
    return found


# Floors of `models/src`, the lowest first: each sees those before it. What stands on one floor does not see its neighbours.
FLOORS = [
    ["kernel"],
    ["parts"],
    ["component"],
    ["balance", "drive", "sway"],
    ["luffing", "slewing", "steering", "hopper", "unloader", "bridge"],
    ["afloat", "supports"],
    ["registry", "book", "vary"],
    ["reading", "request", "study"],
    ["scene"],
    ["alone"],
]


def test_each_floor_sees_those_below_it():
    sources = ROOT / "models/src"
    floor = {room: number for number, rooms in enumerate(FLOORS) for room in rooms}

    def room(path):
        return path.relative_to(sources).parts[0].removesuffix(".rs")

    rooms = {room(path) for path in sources.rglob("*.rs")} - {"lib"}
    assert rooms == set(floor), "each room of models/src has its floor"
    found = needs()
    assert sources / "registry.rs" in found[sources / "scene.rs"], "paths are read"
    told = [
        f"{path.relative_to(ROOT)} needs {other.relative_to(ROOT)}"
        for path, others in found.items() if sources in path.parents and room(path) != "lib"
        for other in others if sources in other.parents
        if room(other) != room(path) and floor.get(room(other), 99) >= floor[room(path)]
    ]
    assert not told, "\n".join(told)


def test_no_files_need_each_other_in_a_circle():
    told = ["\n  ".join(str(path.relative_to(ROOT)) for path in circle) for circle in circles(needs())]
    assert not told, "files that need each other in a circle:\n  " + "\n\n  ".join(told)


# What has a line for every mechanism: which there are, and the folders themselves.
LISTS = {
    "models/src/lib.rs", "models/src/luffing/kinds.rs", "models/src/luffing/mod.rs", "models/src/registry.rs", "models/src/supports/mod.rs",
}


def entries():
    """The file of each mechanism that lists it for scenes, in the mechanism's folder."""
    return [path for path in (ROOT / "models/src").rglob("*.rs") if "pub const ENTRY: Entry" in path.read_text("utf-8")]


def test_no_shared_file_names_a_mechanism():
    folders = {path.parent for path in entries()}
    types = {name for path in entries() for name in re.findall(r"impl Described for (\w+)", path.read_text("utf-8"))}
    assert len(folders) == len(types) >= 3
    rooms = "|".join(folder.name for folder in folders)
    name = re.compile(rf"\b(?:{rooms})::|::(?:{rooms})\b|\bmod (?:{rooms});|\b(?:{'|'.join(types)})\b")
    naming = set()
    for folder in CRATES.values():
        for path in (ROOT / folder).rglob("*.rs"):
            if not folders & set(path.parents) and name.search(plain(path.read_text(encoding="utf-8"))):
                naming.add(path.relative_to(ROOT).as_posix())
    assert naming == LISTS


def test_books_and_trade_name_no_level_or_table_of_a_mechanism():
    keys, levels = set(), set()
    for path in entries():
        for source in path.parent.rglob("*.rs"):
            code = source.read_text(encoding="utf-8")
            keys |= set(re.findall(r'Key::(?:table|part)\(\s*"(\w+)"', code))
            for listed in re.findall(r"FIDELITIES: &\[&str\] = &\[([^]]*)\]", code):
                levels |= set(re.findall(r'"(\w+)"', listed))
    # Every mechanism has these levels; chapters are the book's.
    chapters = re.search(r"CHAPTERS: &\[&str\] = &\[(.*?)\]", (ROOT / "models/src/book.rs").read_text("utf-8"), re.S)
    own = (keys | levels) - {"static", "table", "auto"} - set(re.findall(r'"(\w+)"', chapters[1]))
    assert {"swing", "hydraulic", "dynamics", "kinematic"} <= own
    literal = re.compile(rf'"(?:{"|".join(sorted(own))})"|\[(?:luffing|steering)\.')
    for folder in ("report/src", "models/trade/src", "fmu/src"):
        for path in (ROOT / folder).rglob("*.rs"):
            code = path.read_text(encoding="utf-8").split("#[cfg(test)]")[0]
            found = [line for line in code.splitlines() if literal.search(line) and not line.lstrip().startswith("//")]
            assert not found, (path, found)


def test_no_two_public_types_of_models_have_one_name():
    places = {}
    for path in (ROOT / "models/src").rglob("*.rs"):
        code = plain(path.read_text(encoding="utf-8"))
        # A macro's types have a name for each use of it.
        code = re.sub(r"^macro_rules! .*?^}", "", code, flags=re.S | re.M)
        names = re.findall(r"^\s*pub (?:struct|enum|trait|type) (\w+)", code, re.M)
        names += re.findall(r"quantities! \{\s*(?:#\[[^]]*\]\s*)*(\w+) \{", code)
        for name in names:
            places.setdefault(name, []).append(path.relative_to(ROOT).as_posix())
    assert len(places) > 100
    assert not {name: found for name, found in places.items() if len(found) > 1}


# Their ids differ from r_1 and R_1 of each other by case alone, which a constant does not have.
APART = {("R_K", "r_1"), ("R_L", "R_1")}


def test_a_symbol_has_the_name_of_its_id():
    apart, count = set(), 0
    for path in (ROOT / "models/src").rglob("symbols.rs"):
        for name, known in re.findall(r'^ {4}([A-Z]\w*): "([^"]+)" "', path.read_text(encoding="utf-8"), re.M):
            count += 1
            capitals = re.sub(r"[^A-Z0-9]", "", re.sub(r"der\((.*)\)", r"d\1", known).upper())
            if name.replace("_", "") != capitals:
                apart.add((name, known))
    assert count > 500 and apart == APART


# Files of mechanisms in motion, until what moves is written once too.
LONG = {
    "models/src/luffing/moving/hydraulic.rs",
}


def test_no_file_is_long():
    files = (ROOT / "models/src").rglob("*.rs")
    long = {path.relative_to(ROOT).as_posix() for path in files if len(path.read_text("utf-8").splitlines()) > 500}
    assert long == LONG


def functions():
    """Of each table id, function, source in a `mod.rs` the functions that it links, each with the file that has it.
    A type's function may stand in another file than the type. Searches for dimensions, in another crate, are not linked."""
    sources, found = ROOT / "models/src", {}
    code = {path: plain(path.read_text(encoding="utf-8")) for path in sources.rglob("*.rs")}
    for table in (path for path in code if path.name == "mod.rs"):
        rows = re.findall(r"^//! \| (.*) \|$", table.read_text(encoding="utf-8"), re.M)
        if "id | function | source" not in rows:
            continue
        paths = [path for row in rows for path in re.findall(r"\[`([^`]+)`\]", row.split(" | ")[1])]
        found[table] = {path: place(code, sources, table, path) for path in paths}
    return found


def place(code, sources, table, path):
    """The file of the function, type or module that a table links; none where there is no such thing."""
    folder, *items = [sources, *path.split("::")[1:]] if path.startswith("crate::") else [table.parent, *path.split("::")]
    while items and (folder / items[0]).is_dir():
        folder /= items.pop(0)
    module = folder / "mod.rs"
    if items and folder / f"{items[0]}.rs" in code:
        module = folder / f"{items.pop(0)}.rs"
    kinds = [rf"\bimpl\b[^{{]*\b{re.escape(name)}\b[^{{]*\{{" for name in items[:-1]]
    kinds += [rf"\b(?:fn|struct|enum)\s+{re.escape(name)}\b" for name in items[-1:]]
    has = lambda file: all(re.search(kind, code[file]) for kind in kinds)
    if module in code and has(module):
        return module
    having = list(filter(has, code)) if len(items) > 1 else []
    return having[0] if len(having) == 1 else None


def test_a_file_with_equations_has_at_most_200_lines():
    found = functions()
    links = [link for places in found.values() for link in places.items()]
    assert all(found.get(path.parent / "mod.rs") for path in entries()) and all(found.values()) and len(links) > 50
    assert not [path for path, file in links if file is None], "paths of tables that lead to nothing"
    lines = {file.relative_to(ROOT).as_posix(): len(file.read_text("utf-8").splitlines()) for _, file in links}
    assert not {file: count for file, count in lines.items() if count > 200 and file not in LONG}

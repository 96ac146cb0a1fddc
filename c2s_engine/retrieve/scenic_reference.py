"""The reference of the installed Scenic: docstrings and signatures of what scenarios use, taken from its source files.

Nothing is imported: Python modules are read by `ast`, Scenic modules by their `class` and `behavior` headings.
"""

import ast
import inspect
import re
from collections.abc import Iterator
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

from c2s_engine.retrieve.blocks import Block, Chunk, chunks

MODULES = (
    "syntax/veneer.py", "core/distributions.py", "core/regions.py", "core/vectors.py", "core/object_types.py",
    "core/workspaces.py", "core/dynamics/behaviors.py", "core/dynamics/scenarios.py", "core/dynamics/guards.py",
    "core/dynamics/actions.py", "core/simulators.py", "core/scenarios.py", "core/errors.py", "core/external_params.py",
    "core/shapes.py", "core/sensors.py", "domains/driving/roads.py", "domains/driving/actions.py",
    "domains/driving/controllers.py",
    "domains/driving/workspace.py", "domains/driving/simulators.py", "domains/driving/behaviors.scenic",
    "domains/driving/model.scenic", "domains/driving/__init__.py", "simulators/carla/__init__.py",
    "simulators/carla/model.scenic", "simulators/carla/behaviors.scenic", "simulators/carla/actions.py",
    "simulators/carla/blueprints.py", "simulators/carla/misc.py", "simulators/newtonian/driving_model.scenic",
    "simulators/utils/colors.py",
)  # fmt: skip
CLASSES_ONLY = (
    "core/regions.py", "core/distributions.py", "core/simulators.py", "core/scenarios.py", "core/external_params.py",
    "core/shapes.py", "core/sensors.py", "core/dynamics/scenarios.py",
)  # fmt: skip
"""Modules whose methods are for those who extend Scenic, not for those who write scenarios."""
_SCENIC_HEAD = re.compile(
    r"^(?P<indent>[ ]*)(?P<kind>class|behavior|def|monitor|scenario)\s+(?P<name>\w+)(?P<rest>[^:\n]*):?", re.M
)


def scenic_version() -> str:
    """The version of the installed Scenic."""
    return version("scenic")


def scenic_folder() -> Path:
    """Where the installed Scenic is."""
    spec = find_spec("scenic")
    assert spec and spec.origin
    return Path(spec.origin).parent


def reference() -> list[Chunk]:
    """The chunks of the reference."""
    title = f"Scenic {scenic_version()} reference"
    found: list[Chunk] = []
    for name in MODULES:
        path = scenic_folder() / name
        if not path.is_file():
            continue
        module = "scenic." + name.rsplit(".", 1)[0].removesuffix("/__init__").replace("/", ".")
        entries = _python(path.read_text()) if path.suffix == ".py" else _scenic(path.read_text())
        for names, signature, text in entries:
            if len(names) > 1 and name in CLASSES_ONLY:
                continue
            body = _plain(text)
            if name.startswith("syntax/"):
                signature = ""  # the veneer's functions stand for syntax, which their docstrings spell out
            if len(body) < 15 and not signature:
                continue
            head = [Block("code", signature)] if signature else []
            pieces = chunks([*head, *_paragraphs(body)], title)
            found += [Chunk((title, module, *names), piece.text) for piece in pieces]
    return found


def _python(source: str) -> Iterator[tuple[tuple[str, ...], str, str]]:
    """Names, signature and docstring of a module's public classes, functions and methods."""
    tree = ast.parse(source)
    if doc := ast.get_docstring(tree):
        yield (), "", doc
    for node in tree.body:
        if isinstance(node, ast.FunctionDef) and (doc := ast.get_docstring(node)) and not node.name.startswith("_"):
            yield (node.name,), _signature(node), doc
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            doc = ast.get_docstring(node) or ""
            bases = ", ".join(ast.unparse(b) for b in node.bases)
            fields = [ast.unparse(n) for n in node.body if isinstance(n, ast.AnnAssign)]
            if doc or fields:
                yield (
                    (node.name,),
                    f"class {node.name}({bases})" if bases else f"class {node.name}",
                    _fields(doc, source, node),
                )
            for inner in node.body:
                if not isinstance(inner, ast.FunctionDef) or inner.name.startswith("_"):
                    continue
                if text := ast.get_docstring(inner):
                    yield (node.name, inner.name), _signature(inner), text


def _fields(doc: str, source: str, node: ast.ClassDef) -> str:
    """A class's docstring with its attributes and the `#:` comments on them."""
    lines = source.splitlines()
    found = []
    for inner in node.body:
        if (
            isinstance(inner, ast.AnnAssign)
            and isinstance(inner.target, ast.Name)
            and not inner.target.id.startswith("_")
        ):
            comment = re.search(r"#:?\s*(.*)", lines[inner.lineno - 1])
            above: list[str] = []
            i = inner.lineno - 2
            while i >= 0 and lines[i].strip().startswith("#:"):
                above.insert(0, lines[i].strip()[2:].strip())
                i -= 1
            note = " ".join(above) or (comment[1] if comment else "")
            found.append(f"- {inner.target.id}: {ast.unparse(inner.annotation)}{' - ' + note if note else ''}")
    return doc + ("\n\nAttributes:\n\n" + "\n".join(found) if found else "")


def _signature(node: ast.FunctionDef) -> str:
    property_ = any(isinstance(d, ast.Name) and d.id in ("property", "cached_property") for d in node.decorator_list)
    arguments = "" if property_ else f"({ast.unparse(node.args).removeprefix('self, ').removeprefix('self')})"
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"{node.name}{arguments}{returns}"


def _scenic(source: str) -> Iterator[tuple[tuple[str, ...], str, str]]:
    """The same of a Scenic module: classes (with their properties), behaviours and functions."""
    if match := re.match(r'\s*"""(.*?)"""', source, re.S):
        yield (), "", match[1]
    heads = list(_SCENIC_HEAD.finditer(source))
    for i, head in enumerate(heads):
        if head["indent"] or head["name"].startswith("_"):
            continue
        following = [h for h in heads[i + 1 :] if not h["indent"]]
        body = source[head.end() : following[0].start() if following else len(source)]
        doc = re.match(r'[^\n]*\n?\s*"""(.*?)"""', body, re.S)
        properties = re.findall(r"^    (\w+)(?:\[\w+\])?:\s*(.+)$", body, re.M) if head["kind"] == "class" else []
        text = inspect.cleandoc(doc[1]) if doc else ""
        if properties:
            text += "\n\nProperties and their defaults:\n\n" + "\n".join(
                f"- {n}: {v.strip()}" for n, v in properties[:30]
            )
        if text or head["kind"] == "behavior":
            yield (
                (head["name"],),
                f"{head['kind']} {head['name']}{head['rest'].rstrip()}",
                text or _said_by_name(head["name"]),
            )
        methods = re.finditer(
            r'^    def (?P<name>[a-zA-Z]\w*)(?P<args>\([^\n]*\))[^\n]*:\n\s*"""(?P<doc>.*?)"""', body, re.S | re.M
        )
        for method in methods:
            yield (head["name"], method["name"]), f"{method['name']}{method['args']}", inspect.cleandoc(method["doc"])


def _said_by_name(name: str) -> str:
    """What a behaviour without a docstring is for, as far as its name tells."""
    words = re.findall(r"[A-Z][a-z]+|[a-z]+", name.removesuffix("Behavior"))
    return f"A behaviour of Scenic's library: {' '.join(words).lower()}."


def _paragraphs(text: str) -> list[Block]:
    """The paragraphs of a docstring; indented lists and listings keep their lines."""
    blocks = []
    for part in re.split(r"\n\s*\n", text):
        lines = part.rstrip().splitlines()
        listing = (
            sum(1 for line in lines if line.lstrip().startswith(("-", "*", ":")) or line.startswith("  "))
            > len(lines) / 2
        )
        if listing:
            blocks.append(Block("list", "\n".join(lines)))
        elif part.strip():
            blocks.append(Block("paragraph", " ".join(line.strip() for line in lines)))
    return blocks


def _plain(text: str) -> str:
    """A docstring without the marks of its markup."""
    text = re.sub(r":[\w:+.-]+:`~?([^`<]*?)(?:\s*<[^`]*>)?`", r"`\1`", inspect.cleandoc(text))
    text = re.sub(r"^\.\. (?:_[^\n]*|note::|code-block::[^\n]*|seealso::|warning::|version\w+::[^\n]*|"
                  r"raw::[^\n]*|important::|math::|figure::[^\n]*)$", "", text, flags=re.M)  # fmt: skip
    text = re.sub(r"^:meta private:$", "", text, flags=re.M)
    return re.sub(r"\n{3,}", "\n\n", text).strip()

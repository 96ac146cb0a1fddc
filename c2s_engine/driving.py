"""The driving library that programs import: `from c2s_driving import *`, one Scenic file, saved beside them.

`inlined(program)` is the program in one file, with those parts of the library that it uses.
"""

import ast
import functools
import hashlib
import io
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

from c2s_engine import paths
from c2s_engine.structure.names import renamed

MODULE = "c2s_driving"
FILE = f"{MODULE}.scenic"
IMPORT = f"from {MODULE} import *"
_IMPORTS = re.compile(rf"^from {MODULE} import [^\n]*\n", re.MULTILINE)
_DEFINES = re.compile(r"^(?:def|behavior|monitor|class) (\w+)|^(\w+) = ")


class BrokenLibrary(ValueError):
    """The library that is installed is no Scenic; the message says where."""

    def __init__(self, line: int, why: str) -> None:
        super().__init__(f"The driving library is broken: {path()}, line {line}: {why}. Install c2s anew, or mend it.")


def path() -> Path:
    """The library's file, as it is shipped."""
    return paths.shipped("driving", FILE)


@functools.cache
def text() -> str:
    return path().read_text(encoding="utf-8")


@functools.cache
def digest() -> str:
    """What tells versions of the library apart."""
    return hashlib.blake2b(text().encode(), digest_size=8).hexdigest()


@functools.cache
def names() -> frozenset[str]:
    """What the library defines at its top level."""
    return frozenset(name for part in _parts() for name in _names(part))


@functools.cache
def constants() -> dict[str, list[str]]:
    """Its lists of blueprints, by name."""
    lists = [part.partition(" = ") for part in _parts() if re.match(r"[A-Z_]+ = \['", part)]
    found = {}
    for name, _, value in lists:
        try:
            found[name] = ast.literal_eval(value)
        except (ValueError, SyntaxError):
            line = text()[: text().index(f"{name} = ")].count("\n") + 1
            raise BrokenLibrary(line, f"{name} is no list of names") from None
    return found


@functools.cache
def modules() -> frozenset[str]:
    """The names under which the library itself has modules of Python's or other packages: no program's business."""
    found = ast.parse("".join(part for part in _parts() if part.startswith(("import ", "from "))))
    outside = (n for n in found.body if not (isinstance(n, ast.ImportFrom) and str(n.module).startswith("scenic")))
    return frozenset((a.asname or a.name).partition(".")[0] for n in outside for a in getattr(n, "names", ()))


def used_by(program: str) -> bool:
    """Whether a program imports the library."""
    return _IMPORTS.search(program) is not None


def imported(program: str) -> dict[str, str]:
    """The names of the library that a program imports one by one, each with what it calls them."""
    named = " ".join(line.partition(" import ")[2] for line in _IMPORTS.findall(program))
    pairs = re.findall(r"(\w+)(?: as (\w+))?", named)
    return {name: own or name for name, own in pairs}


def beside(folder: str | Path) -> str | None:
    """The text of a library in a program's folder that is not the shipped one (of another version, or changed)."""
    try:
        found = (Path(folder) / FILE).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return None
    return None if found == text() else found


def inlined(program: str) -> str:
    """The program with what it uses of the library in the place of the import."""
    if not used_by(program):
        return program
    parts = {name: part for part in _parts() for name in _names(part)}
    called = {name: own for name, own in imported(program).items() if name != own}
    wanted = set(called)
    todo = [_IMPORTS.sub("", program), *(parts[name] for name in called if name in parts)]
    while todo:
        for word in set(re.findall(r"\w+", todo.pop())) & parts.keys() - wanted:
            wanted.add(word)
            todo.append(parts[word])
    kept = "\n".join(part.rstrip("\n") + "\n" for part in _parts() if not _names(part) or wanted & set(_names(part)))
    kept = renamed(kept, called)
    first, *others = _IMPORTS.findall(program)
    program = program.replace(first, f"\n# From {FILE}\n{kept}\n", 1)
    return "".join(line for line in program.splitlines(keepends=True) if line not in others)


@functools.cache
def _parts() -> tuple[str, ...]:
    """The library's top-level statements but its docstring, each with its lines."""
    lines = text().splitlines(keepends=True)
    starts: list[int] = []
    depth, fresh = 0, True
    for token in _tokens(starts):
        if token.type in (tokenize.INDENT, tokenize.DEDENT):
            depth += 1 if token.type == tokenize.INDENT else -1
        elif token.type == tokenize.NEWLINE:
            fresh = True
        elif token.type not in (tokenize.NL, tokenize.COMMENT, tokenize.ENDMARKER) and fresh:
            fresh = False
            if depth == 0:
                starts.append(token.start[0] - 1)
    cuts = zip(starts[1:], [*starts[2:], len(lines)], strict=True)
    return tuple(re.sub(r"\n#[^\n]*\n*\Z", "\n", "".join(lines[first:last]).rstrip() + "\n") for first, last in cuts)


def _tokens(starts: list[int]) -> Iterator[tokenize.TokenInfo]:
    """The library's tokens; `starts`: the rows (from 0) at which its statements begin, as far as they are known."""
    try:
        yield from tokenize.generate_tokens(io.StringIO(text()).readline)
    except IndentationError as error:
        raise BrokenLibrary(error.lineno or 1, "its indentation fits no block") from None
    except tokenize.TokenError:
        raise BrokenLibrary(starts[-1] + 1 if starts else 1, "a bracket or a string is never closed") from None


def _names(part: str) -> list[str]:
    """What a statement defines; none for an import."""
    found = _DEFINES.match(part)
    return [found[1] or found[2]] if found else []

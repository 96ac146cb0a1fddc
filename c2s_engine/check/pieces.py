"""A program cut at its top-level statements, each parsed and compiled once: an edit costs only what it touches.

The pieces together are exactly what Scenic's compiler makes of the whole: a test compares the AST hashes.
"""

import ast
import copyreg
import hashlib
import io
import re
import tokenize
from dataclasses import dataclass
from typing import Any

_MARGIN = re.compile(r"[A-Za-z_@#]")
CONTINUES = frozenset({"else", "elif", "except", "finally", "interrupt"})


@dataclass(frozen=True)
class Piece:
    """Source lines `first`..`last` (1-based, inclusive) that hold one top-level statement."""

    first: int
    last: int
    text: str


class Cut(Exception):
    """The text cannot be cut: a bracket or string that begins in the statement on line `first` does not end."""

    def __init__(self, message: str, first: int = 1) -> None:
        super().__init__(message)
        self.first = first


def cut(text: str) -> list[Piece]:
    """Cut at top-level statements; raises Cut where the tokenizer finds no end."""
    lines = list(io.StringIO(text))
    starts: list[int] = []
    ends: list[int] = []
    depth = 0
    begins, decorated = True, False
    try:
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type == tokenize.INDENT:
                depth += 1
            elif token.type == tokenize.DEDENT:
                depth -= 1
            elif token.type == tokenize.NEWLINE:
                begins = True
                if ends:
                    ends[-1] = max(ends[-1], token.start[0])
            elif token.type in (tokenize.NL, tokenize.COMMENT, tokenize.ENDMARKER):
                continue
            elif begins:
                begins = False
                if depth == 0 and token.string not in CONTINUES and not decorated:
                    starts.append(token.start[0])
                    ends.append(token.start[0])
                if depth == 0:
                    decorated = token.string == "@"
    except (tokenize.TokenError, IndentationError, SyntaxError) as error:
        raise Cut(str(error), starts[-1] if starts else 1) from None
    return [Piece(first, last, "".join(lines[first - 1 : last])) for first, last in zip(starts, ends, strict=True)]


def parse(text: str, filename: str, offset: int = 0) -> Any:
    """Scenic's syntax tree of a text that begins after `offset` lines."""
    from scenic.syntax.parser import parse_string

    return parse_string("\n" * offset + text, "exec", filename=filename)


def shifted(tree: Any, lines: int) -> Any:
    """The tree moved down by that many lines, in place."""
    node: Any
    for node in ast.walk(tree):
        if getattr(node, "lineno", None) is not None:
            node.lineno += lines
        if getattr(node, "end_lineno", None) is not None:
            node.end_lineno += lines
    return tree


def portable() -> None:
    """Teach pickle to copy Scenic's tree nodes (their constructors demand arguments)."""
    import inspect

    from scenic.syntax import ast as scenic_ast

    for _, kind in inspect.getmembers(scenic_ast, inspect.isclass):
        if issubclass(kind, scenic_ast.AST):
            copyreg.pickle(kind, _reduce)


def _reduce(node: Any) -> tuple:
    return _rebuild, (type(node), dict(node.__dict__))


def _rebuild(kind: type, state: dict[str, Any]) -> Any:
    node: Any = ast.AST.__new__(kind)
    node.__dict__.update(state)
    return node


def unfinished(lines: list[str], first: int) -> str:
    """The statement on line `first` that does not end, up to the next line that looks like a new statement."""
    last = first
    while last < len(lines) and not _MARGIN.match(lines[last]):
        last += 1
    return "".join(lines[first - 1 : last])


def translate(
    tree: Any, filename: str, requirements: list, syntax_id: int, first: int = 1
) -> tuple[ast.Module, list, int]:
    """The Python tree of a Scenic tree, as a continuation of what has `requirements` and `syntax_id` so far."""
    from scenic.syntax.compiler import ScenicToPythonTransformer

    transformer = ScenicToPythonTransformer(filename)
    transformer.inBehavior = transformer.inMonitor = transformer.inCompose = False
    transformer.inSetup = transformer.inInterruptBlock = False
    transformer.requirements = list(requirements)
    transformer.nextSyntaxId = syntax_id
    result = transformer.visit(tree)
    for statement in result.body:
        _locate(statement, first)
    return result, transformer.requirements, transformer.nextSyntaxId


def _locate(node: ast.AST, line: int) -> None:
    """Give nodes without a position that of what they stand in (a statement: its piece's first line)."""
    if "lineno" in node._attributes:
        if getattr(node, "lineno", None) is None:
            node.lineno = node.end_lineno = line  # type: ignore[attr-defined]
            node.col_offset = node.end_col_offset = 0  # type: ignore[attr-defined]
        line = node.lineno  # type: ignore[attr-defined]
    for child in ast.iter_child_nodes(node):
        _locate(child, line)
    ast.fix_missing_locations(node)


def ast_hash(dumps: list[str]) -> bytes:
    """Scenic's digest of a module, from the dumps of its statements."""
    whole = f"Module(body=[{', '.join(dumps)}], type_ignores=[])"
    return hashlib.blake2b(whole.encode(), digest_size=4).digest()


def compile_text(text: str, filename: str) -> tuple[ast.Module, list, bytes]:
    """A whole text at once: Python tree, requirements, digest (the library modules)."""
    tree, requirements, _ = translate(parse(text, filename), filename, [], 0)
    return tree, requirements, hashlib.blake2b(ast.dump(tree).encode(), digest_size=4).digest()

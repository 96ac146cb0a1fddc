"""The quick parser gives the trees and the errors of pegen's own."""

import ast
from pathlib import Path
from typing import Any

from scenic.syntax import parser
from scenic.syntax.compiler import compileScenicAST

from c2s_engine.check import library, quick_parser

HERE = Path(__file__).parent
WRONG = """
x = (1,
ego = new Car at
do while
behavior A(:
ego = Car at 1@2
require foo bar
x = = 3
if True
x = 'abc
param time = 3 4
class A
a = new new Car
terminate wen 3
ego = new Car ahead off x
try: take 1
""".strip().split("\n")


def outcome(text: str, filename: str) -> Any:
    try:
        tree, requirements = compileScenicAST(parser.parse_string(text, "exec", filename=filename), filename=filename)
    except Exception as error:
        where = [getattr(error, name, None) for name in ("lineno", "offset", "end_lineno", "end_offset")]
        return type(error), str(error), where
    return ast.dump(tree, include_attributes=True), [ast.dump(r) if isinstance(r, ast.AST) else r for r in requirements]


def test_the_same_trees_and_errors() -> None:
    programs = {str(p): p.read_text(encoding="utf-8") for p in sorted((HERE / "programs").glob("*.scenic"))[::3]}
    programs |= {str(path): path.read_text() for path in library.REHEARSALS}
    programs |= {f"wrong {i}": t for i, t in enumerate(WRONG)}
    kinds = [kind for kind in parser.ScenicParser.__mro__ if kind is not object]
    before = {kind: dict(vars(kind)) for kind in kinds}
    stock = {name: outcome(text, name) for name, text in programs.items()}
    try:
        quick_parser.install()
        replaced = sum(vars(kind)[n] is not rule for kind, rules in before.items() for n, rule in rules.items())
        quick = {name: outcome(text, name) for name, text in programs.items()}
    finally:
        for kind, rules in before.items():
            for name, rule in rules.items():
                if callable(rule) and vars(kind)[name] is not rule:
                    setattr(kind, name, rule)
    assert replaced > 100
    assert quick == stock

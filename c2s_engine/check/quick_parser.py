"""The memory of Scenic's parser (pegen), without what it does for a log that nobody asked for: a third of its time.

What is parsed and remembered is the same: only the two decorators that keep each rule's result are replaced, and what
makes an error of an error.
"""

import functools
import re
from collections.abc import Callable
from typing import Any

_PARTS = re.compile(r"memoize_(?:left_rec_)?wrapper")


def install() -> None:
    """Replace the decorators of all rules of the parser."""
    from pegen.tokenizer import Tokenizer
    from scenic.syntax import parser

    Tokenizer.get_lines = _lines  # type: ignore[assignment, method-assign]
    for kind in parser.ScenicParser.__mro__:
        for name, rule in list(vars(kind).items()):
            found = _PARTS.fullmatch(getattr(rule, "__name__", ""))
            if found and hasattr(rule, "__wrapped__"):
                setattr(kind, name, (_left_recursive if "left" in found[0] else _remembered)(rule.__wrapped__))


def _lines(tokens: Any, numbers: list[int]) -> list[str]:
    """The lines that an error is about. Those within a string of several lines pegen does not keep, and would fail."""
    return [tokens._lines.get(n, "") for n in numbers]


def _remembered(rule: Callable[..., Any]) -> Callable[..., Any]:
    """A rule that is applied once at a token: pegen's `memoize`."""
    name = rule.__name__

    def wrapper(self: Any, *args: Any) -> Any:
        tokens = self._tokenizer
        key = tokens._index, name, args
        known = self._cache.get(key)
        if known is not None:
            tree, tokens._index = known
            return tree
        tree = rule(self, *args)
        self._cache[key] = tree, tokens._index
        return tree

    return functools.update_wrapper(wrapper, rule)


def _left_recursive(rule: Callable[..., Any]) -> Callable[..., Any]:
    """A rule that begins with itself, applied for as long as it takes in more: pegen's `memoize_left_rec`."""
    name = rule.__name__

    def wrapper(self: Any) -> Any:
        tokens = self._tokenizer
        mark = tokens._index
        key = mark, name, ()
        known = self._cache.get(key)
        if known is not None:
            tree, tokens._index = known
            return tree
        best, furthest = None, mark
        self._cache[key] = best, furthest
        while True:
            tokens._index = mark
            self.in_recursive_rule += 1
            try:
                tree = rule(self)
            finally:
                self.in_recursive_rule -= 1
            if not tree or tokens._index <= furthest:
                break
            best, furthest = tree, tokens._index
            self._cache[key] = best, furthest
        tokens._index = furthest
        self._cache[key] = best, furthest if best else mark
        return best

    return functools.update_wrapper(wrapper, rule)

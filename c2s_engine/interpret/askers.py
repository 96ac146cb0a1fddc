"""First and second persons who only ask for a scenario or tell of it ("please write me a scene", "my thesis"): they are
not ego."""

import re
from functools import cache

from c2s_engine.interpret import language


@cache
def _asks() -> re.Pattern[str]:
    return re.compile("|".join(f"(?:{p})" for p in language.table("ego")["askers"]))


def asked(plain: str) -> list[tuple[int, int]]:
    """The stretches of a text in which somebody asks for it, or tells of the work that it is for."""
    return [m.span() for m in _asks().finditer(plain)]

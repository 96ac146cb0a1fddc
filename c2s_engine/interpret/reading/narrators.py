"""First and second persons who only ask for a scenario or tell of it ("please write me a scene", "my thesis"): they are
not ego."""

import re
from functools import cache

from c2s_engine.interpret import language


@cache
def _asks() -> re.Pattern[str]:
    return re.compile("|".join(f"(?:{p})" for p in language.table("ego")["askers"]))


def numbering(plain: str) -> bool:
    """Whether who tells it only numbers the vehicles of others: a police officer ("V1 ...; I checked the sign")."""
    told = language.table("ego")["numbered"]
    return re.search(told["labels"], plain) is not None and re.search(told["own"], plain) is None


def has_outside_narrator(plain: str) -> bool:
    """Whether nobody in the scene tells the whole text."""
    return numbering(plain)


def asked(plain: str) -> list[tuple[int, int]]:
    """The stretches of a text in which first and second persons are nobody on the road: somebody asks for it there, or
    tells of the work that it is for; the whole text where a bystander tells it."""
    return [(0, len(plain))] if has_outside_narrator(plain) else [m.span() for m in _asks().finditer(plain)]


@cache
def _narrators() -> dict[str, re.Pattern[str]]:
    told = language.table("ego")["narrators"]
    return {k: re.compile(v if isinstance(v, str) else "|".join(v)) for k, v in told.items()}


def narrator(plain: str) -> str:
    """What the first person of a text is, where it is not at the wheel: "pedestrian", "bicycle", or "" for a driver."""
    told = _narrators()
    if told["drives"].search(plain):
        return ""
    return next((kind for kind in ("bicycle", "pedestrian") if told[kind].search(plain)), "")

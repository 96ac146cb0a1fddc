"""How many lanes a road has in ego's direction: "a six-lane road", "two lanes each way", "the third of four lanes"."""

import re
from functools import cache
from typing import Any

from c2s_engine.interpret import language

COUNT = ("one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
NUMBERS = {word: value for value, word in enumerate(COUNT, 1)}
NTH = {word: value for value, word in enumerate(("first", "second", "third", "fourth", "fifth", "sixth"), 1)}
MOST = 4
"""More lanes than these in one direction no specification names."""
CARRIAGEWAY = re.compile(
    r"one-way|motorway|freeway|interstate|divided highway|carriageway|expressway|in this direction"
)
ONE_WAY = re.compile(r"one-way|in this direction|per direction|each way|in each direction|same direction")
SINGLE = re.compile(r"(?:one|a|1) lane (each|per|in each|for each|either|in either) |single[- ]lane|single lane")


def counted(word: str) -> int:
    """What a numeral says."""
    return NUMBERS.get(word) or NTH.get(word) or int(word)


@cache
def patterns() -> list[tuple[re.Pattern[str], re.Pattern[str] | None, dict[str, Any]]]:
    """The ways to say it: what is looked for, what may not be near, and what it means."""
    several = "|".join(w for w in NUMBERS if w != "one") + r"|[2-9]|1[0-2]"
    many = "|".join(w for w, value in NUMBERS.items() if value >= 4) + r"|[4-9]|1[0-2]"
    said = {"{n}": f"(?:{several})", "{many}": f"(?:{many})", "{nth}": f"(?:{'|'.join(NTH)})"}
    return [
        (
            re.compile(re.sub(r"\{\w+\}", lambda m: said.get(m[0], m[0]), entry["find"])),
            re.compile(entry["not"]) if "not" in entry else None,
            entry,
        )
        for entry in language.table("places")["lanes"]
    ]


def lanes_of(plain: str, counted_only: bool = False) -> tuple[int | None, tuple[int, int] | None, bool]:
    """The lanes in ego's direction, the words that say it, and whether the other direction has its lane beside them;
    on demand only where their number is told, not that there must be more than one."""
    single = SINGLE.search(plain) is not None
    lanes, span, oncoming = None, None, False
    for find, but, entry in patterns():
        if counted_only and "at_least" in entry:
            continue
        for match in find.finditer(plain):
            near = plain[max(0, match.start() - 20) : match.end() + 25]
            if but is not None and but.search(near):
                continue
            span = span or match.span()
            told = _told(match)
            if entry.get("both") and told:
                told, beside = _one_way(told, near, near + plain[match.end() : match.end() + 40])
                oncoming = oncoming or beside
            if told and (lanes is None or entry.get("per_direction")):
                lanes = min(MOST, told)
            least = entry.get("at_least", 0)
            whole = re.search(r"both (lanes|directions)", match[0]) and (lanes == 1 or single)
            if (lanes or 0) < least and not whole:
                lanes = least
    return 1 if single and (lanes or 0) < 2 else lanes, span, oncoming


def _told(match: re.Match[str]) -> int | None:
    named = (word for name, word in match.groupdict().items() if word)
    return next((counted(word) for word in named), None)


def _one_way(total: int, near: str, around: str) -> tuple[int, bool]:
    """How many of all lanes go one way, and whether the others are beside them."""
    carriageway = CARRIAGEWAY.search(around) and not re.search("undivided|two-way", near)
    divided = re.search(r"(?<!un)divided|\bdual\b", near) or total >= 6
    halved = total >= 4 and divided and not ONE_WAY.search(near)  # with a median: two each way
    lanes = total if (carriageway or total == 3) and not halved else max(1, total // 2)
    return lanes, not carriageway and lanes == 1 and not re.search(r"highway|motorway", near)

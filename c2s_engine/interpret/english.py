"""Whether a text is English at all: other languages and nonsense are refused before anything is read into them."""

import re
from difflib import get_close_matches
from functools import cache

from c2s_engine.interpret.language import actor_nouns, table
from c2s_engine.interpret.parser import parser

NOT_ENGLISH = "This text is not English: describe the scene in English, for example “a car cuts in ahead of ego”."
WORD = re.compile(r"[^\W\d_]{2,}(?:['’][^\W\d_]+)?")
LONG = 8
"""Words."""
ENOUGH = 4
"""Words that it takes to tell; of shorter texts only the script is looked at."""
SHARE, NOTED = 0.7, 0.8
"""Least share of known words and of function words ("the", "of"), added up: English has 1.0 and more, notes 0.8; the
same of LONG texts without any function word."""
ALIKE = 0.8
"""How like a misspelt word is to the word of the trade that is meant (0 to 1)."""


def is_english(text: str) -> bool:
    """Whether most words of a text are English ones; misspelt words of the trade count as such."""
    words = [word.lower().replace("’", "'") for word in WORD.findall(text)]
    if len(words) < ENOUGH:
        return not re.search(r"[^\W\d_a-zA-Z]{2,}", text) and (len(words) < ENOUGH - 1 or any(map(_known, words)))
    function_words = parser().Defaults.stop_words
    functional = sum(word in function_words for word in words)
    return sum(map(_known, words)) + functional >= (SHARE if functional or len(words) < LONG else NOTED) * len(words)


@cache
def _known(word: str) -> bool:
    if word in table("trade")["foreign"]:
        return False
    strings = parser().vocab.strings
    bases = (word, *(word[: -len(e)] for e in ("s", "ed", "d", "ing", "ly", "er") if word.endswith(e)))
    if word in of_the_trade() or word in strings or any(base in strings for base in bases if len(base) > 4):
        return True
    return word.isascii() and len(word) > 3 and bool(get_close_matches(word, of_the_trade(), 1, ALIKE))


@cache
def of_the_trade() -> frozenset[str]:
    """Road users and the words of data/language/trade.yaml."""
    nouns = (word for noun in actor_nouns() for word in re.findall(r"[a-z]{3,}", noun))
    return frozenset([*nouns, *table("trade")["words"]])

"""Whether a text is English at all: other languages and nonsense are refused before anything is read into them."""

import re

from c2s_engine.interpret.reading import spelling, syntax

WORD = re.compile(r"[^\W\d_]{2,}(?:['’][^\W\d_]+)?")
NOTED = 0.8
"""The same of LONG texts without any function word."""
LONG = 8
"""Words."""
ENOUGH = 4
"""Words that it takes to tell; of shorter texts only the script is looked at."""
SHARE = 0.7
"""Least share of known words and of function words ("the", "of"), added up: English has 1.0 and more, notes 0.8."""


def is_english(text: str) -> bool:
    """Whether most words of a text are English ones; shorthand and misspelt words of the trade count as such."""
    words = [word.lower().replace("’", "'") for word in WORD.findall(text)]
    if len(words) < ENOUGH:
        return not re.search(r"[^\W\d_a-zA-Z]{2,}", text)
    function_words = syntax.parser().Defaults.stop_words
    functional = sum(word in function_words for word in words)
    return sum(map(_known, words)) + functional >= (SHARE if functional or len(words) < LONG else NOTED) * len(words)


def _known(word: str) -> bool:
    return spelling.known(word) or word.isascii() and spelling.nearest(word) is not None

"""Names of crash types ("control loss with prior vehicle action", "CCRs"): what they mean in plain words."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.mentions import mentions
from c2s_engine.interpret.text import normalised

MORE = 2
"""Road users that a text names beside a crash type from which on it tells its own scene."""


def meant(text: str) -> tuple[str, tuple[int, int]] | None:
    """A short text with the crash type that it names in plain words, and where the name stands; None where it names
    none, or tells a scene itself."""
    table = language.table("typologies")
    plain = normalised(text)
    if len(plain.split()) > table["words_at_most"]:
        return None
    for entry in table["types"]:
        name = re.search(entry["find"], plain.strip(" ."))
        if name and not ("not" in entry and re.search(entry["not"], plain)):
            rest = plain.replace(name[0], " ", 1)
            if len(mentions(rest)) >= MORE:
                return None
            start = plain.index(name[0])
            more = rest.strip(" .,:-")
            said = f"{entry['means']} {more[:1].upper()}{more[1:]}." if more else entry["means"]
            return said, (start, start + len(name[0]))
    return None

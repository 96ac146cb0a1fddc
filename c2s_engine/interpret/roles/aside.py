"""Places and ways that are told as beside or towards somebody who is not named: that is ego."""

from c2s_engine.interpret.who.mentions import Cast


def after(i: int, cast: Cast) -> str:
    """A word with what follows it in its sentence."""
    return " ".join(w.norm for w in cast.words[i : i + 10] if w.sentence == cast.words[i].sentence)

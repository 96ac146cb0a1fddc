"""Names of streets that are common nouns, too: "from Pine onto Bush"."""

from c2s_engine.interpret.spans import Span


def without_streets(names: list[Span]) -> list[Span]:
    """The names without those things that stand where a street is named, with a capital and no article."""
    return list(names)

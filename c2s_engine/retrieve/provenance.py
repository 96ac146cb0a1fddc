"""Whose words a passage is in: this project's notes on regulations are not the regulations' text."""

from functools import cache

from c2s_engine import paths
from c2s_engine.structure.progress import Passage

NOTES = "notes of this project, not the regulation's text"


@cache
def shipped() -> frozenset[str]:
    """The titles of the documents that come with c2s."""
    files = paths.shipped("docs").glob("*.md")
    return frozenset(f.read_text("utf-8").split("\n", 1)[0].removeprefix("# ").strip() for f in files)


def attribution(passage: Passage) -> str:
    """What to say beside a clause; empty where the text is the source's own, or has no clause."""
    return NOTES if passage.kind == "doc" and passage.clause and passage.source in shipped() else ""

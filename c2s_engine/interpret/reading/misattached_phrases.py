"""Phrases that the tree hangs on something else than what they tell of."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret.reading.tree_edits import attach, road_user

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word


def reattach_phrase(words: list[Word], word: Word) -> None:
    """Hang such a phrase on what it tells of."""
    before = words[word.i - 1]
    if word.norm in ("at", "with") and word.dep == "prep" and before.dep == "nsubjpass" and road_user(before):
        attach(words, word, before)  # "V1 at 60 km/h is overtaken by a van"
    if (lane := _lane_before(words, word)) is not None:
        attach(words, word, lane)  # "approaches a queue in the lane to its right"


def _lane_before(words: list[Word], word: Word) -> Word | None:
    """The lane right before "to its right", in which somebody is and which the tree has not with it."""
    if word.norm != "to" or word.dep != "prep" or word.i < 3 or words[word.i - 1].norm != "lane":
        return None
    lane = words[word.i - 1]
    sideways = any(words[c].dep == "pobj" and words[c].norm in ("left", "right") for c in word.children)
    placed = lane.dep == "pobj" and words[lane.head].norm in ("in", "along")
    return lane if sideways and placed and word.head != lane.i else None

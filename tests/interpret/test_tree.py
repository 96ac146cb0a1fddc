"""Whatever is typed, the words of a sentence hang together as a tree."""

from hypothesis import example, given, settings
from hypothesis import strategies as st

from c2s_engine.interpret.understanding import understand

PIECES = [
    "a van ahead of ego",
    "V2",
    "the truck in the left lane",
    "a cyclist",
    "two cars",
    "ego",
    "the caravan pulled by",
    "that is",
    "which",
    "and then",
    "braking hard",
    "overtaking ego",
    "changing lanes",
    "running the red light",
    "starts to brake",
    "to cut in",
    "let",
    "have",
    "we need",
    "with",
    "behind ego",
    "from the left",
    ",",
    ".",
    "suddenly",
    "and",
    "it",
    "hits it",
    "passes him",
    "towing a trailer",
    "parked",
    "having overtaken",
    "first",
    "(",
    ")",
    "at 50 km/h",
    "when",
    "because",
    "on the right",
    "crossing",
    "turning",
    "turning left",
    "a truck",
    "that",
    "stopped",
    "ahead",
]


@settings(max_examples=150)
@given(st.lists(st.sampled_from(PIECES), min_size=2, max_size=18))
@example(["hits it", "turning left", "hits it", "turning left", "a van ahead of ego", "and", "V2"])
@example(["turning left", "parked", "V2", "V2", "ahead", "parked", ".", "it"])
@example(["behind ego", "parked", "at 50 km/h", "a van ahead of ego", "starts to brake"])
def test_each_word_has_a_way_up_to_a_root(pieces: list[str]) -> None:
    words = understand(" ".join(pieces)).words
    for word in words:
        up = word
        for _ in words:
            if up.head == up.i:
                break
            assert up.i in words[up.head].children
            up = words[up.head]
        assert up.head == up.i, " ".join(pieces)

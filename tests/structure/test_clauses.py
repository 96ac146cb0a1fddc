"""The account of a text: every character of it lies in one clause, and what nobody took up is said to be lost."""

from hypothesis import given
from hypothesis import strategies as st

from c2s_engine.structure.account import account, covering
from c2s_engine.structure.components import Component, Link, Structure, Unmet
from c2s_engine.structure.specs import ObjectSpec, Phase

PIECES = st.lists(
    st.sampled_from(["A car brakes", "it stops", ", and", ". ", "; ", "\n\n", " ", "-", "...", "when", " ego 40", "\t"])
    | st.text(max_size=6),
    max_size=12,
)
SPANS = st.lists(st.tuples(st.integers(-5, 80), st.integers(-5, 120)), max_size=8)


@given(PIECES, SPANS)
def test_every_character_lies_in_one_clause(pieces: list[str], spans: list[tuple[int, int]]) -> None:
    text = "".join(pieces)
    found = covering(text, spans)
    assert found == sorted(found) and all(0 <= s < e <= len(text) for s, e in found)
    held = [i for s, e in found for i in range(s, e)]
    assert len(held) == len(set(held))
    assert all(text[i].isspace() for i in set(range(len(text))) - set(held))
    assert [c.span for c in account(Structure(text=text, clauses=tuple(spans)))] == found


def span_in(text: str, words: str) -> tuple[int, int]:
    return text.index(words), text.index(words) + len(words)


def test_each_clause_says_what_became_of_it() -> None:
    text = "A van brakes, and its horn sounds. Police came. A zeppelin sang. It was odd."
    van = Component(
        id="O1", spec=ObjectSpec(name="van", type="van", phases=(Phase(action="brake"),)),
        links=(Link(kind="text", label="brakes", span=span_in(text, "brakes"), field="phases.0"),),
        unmet=(Unmet(text="horn sounds", reason="nothing can be heard", span=span_in(text, "horn sounds")),),
    )  # fmt: skip
    police = Unmet(text="Police came.", reason="authorities", span=span_in(text, "Police came."))
    zeppelin = Unmet(text="A zeppelin sang.", reason="strange", span=span_in(text, "A zeppelin sang."))
    found = account(Structure(text=text, objects=(van,), background=(police,), not_understood=(zeppelin,)))
    assert [(c.text, c.status, c.fields, c.reason) for c in found] == [
        ("A van brakes,", "understood", ("O1.phases.0",), ""),
        ("and its horn sounds.", "not_expressible", (), "nothing can be heard"),
        ("Police came.", "background", (), "authorities"),
        ("A zeppelin sang.", "not_understood", (), "strange"),
        ("It was odd.", "not_understood", (), "no component of S uses it"),
    ]


def test_what_makes_no_difference_is_lost_of_its_clause() -> None:
    text = "A van brakes late. It is white."
    van = Component(
        id="O1", spec=ObjectSpec(name="van", type="van", phases=(Phase(action="brake"),)),
        links=(
            Link(kind="text", label="brakes", span=span_in(text, "brakes"), field="phases.0"),
            Link(kind="text", label="It", span=span_in(text, "It")),
        ),
    )  # fmt: skip
    idle = [Unmet(text=words, reason="the same", span=span_in(text, words)) for words in ("late", "It is white.")]
    found = account(Structure(text=text, objects=(van,)), idle)
    assert [(c.status, [u.text for u in c.lost]) for c in found] == [
        ("partly", ["late"]), ("not_understood", ["It is white."])
    ]  # fmt: skip


def test_a_component_that_is_removed_leaves_its_clause_to_nobody() -> None:
    text = "A van brakes."
    van = Component(id="O1", spec=ObjectSpec(), links=(Link(kind="text", label="van", span=(2, 5)),))
    structure = Structure(text=text, objects=(van,))
    assert account(structure)[0].components == ("O1",)
    assert account(structure.model_copy(update={"objects": ()}))[0].status == "not_understood"


def test_a_field_that_is_gone_leaves_its_clause_understood_in_part_or_not() -> None:
    text = "A van brakes. It turns left."
    links = (Link(kind="text", label="van", span=span_in(text, "van"), field="type"),
             Link(kind="text", label="brakes", span=span_in(text, "brakes"), field="phases.0"),
             Link(kind="text", label="turns", span=span_in(text, "turns"), field="phases.1"))  # fmt: skip
    both = ObjectSpec(type="van", phases=(Phase(action="brake"), Phase(action="turn_left")))
    for kept, statuses in ((2, ["understood", "understood"]), (1, ["understood", "not_understood"]),
                           (0, ["partly", "not_understood"])):  # fmt: skip
        spec = both.model_copy(update={"phases": both.phases[:kept]})
        found = account(Structure(text=text, objects=(Component(id="O1", spec=spec, links=links),)))
        assert [c.status for c in found] == statuses
        assert all(c.reason for c in found if c.status != "understood")

"""When a model's fragment is stale: never after writing, but where the model failed. Code by hand gets an offer."""

import re

import pytest

from c2s_engine.structure import edits
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Say
from c2s_engine.structure.regenerate import dirty
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write import by_hand
from c2s_engine.write.prompted import PromptedMethod
from tests.write_prompted.programmer import asked_for

BASE = {
    "G": "model scenic.simulators.carla.model",
    "R": "spot = new OrientedPoint on road",
    "E": "ego = new Car at spot",
    "T": "require ego",
}


def two_objects() -> Structure:
    objects = tuple(Component(id=f"O{i}", description=f"Car {i}.", spec=ObjectSpec(name=f"car{i}")) for i in (1, 2))
    return Structure(text="Two cars.", objects=objects)


class Told:
    """A model that writes what it is told to, and counts what it was asked."""

    def __init__(self, server, **codes: str) -> None:
        self.codes, self.asked = {**BASE, **codes}, []
        server.respond = self

    def __call__(self, request) -> str:
        cid = asked_for(request)
        self.asked.append(cid)
        return f"```scenic\n{self.codes[cid]}\n```" if self.codes[cid] else "I cannot."


def described(structure: Structure, cid: str, words: str) -> Structure:
    return edits.apply(structure, edits.SetDescription(component=cid, description=words))


@pytest.fixture
def method(server, client_of):
    return PromptedMethod("C1", client_of(server, num_ctx=16384))


async def test_a_name_of_a_later_component_leaves_nothing_stale(server, method):
    told = Told(server, O1="first = new Car behind second by 5", O2="second = new Car ahead of ego by 9")
    written = await method.write(two_objects())
    assert dirty(written, method.keys) == []
    told.asked.clear()
    assert await method.write(written) == written and told.asked == []


async def test_what_a_later_component_ceases_to_define_makes_its_reader_stale(server, method):
    told = Told(server, O1="first = new Car behind second by 5", O2="second = new Car ahead of ego by 9")
    written = await method.write(two_objects())
    told.codes |= {"O2": "bus = new Bus ahead of ego by 9", "O1": "first = new Car behind ego by 5"}
    told.asked.clear()
    after = await method.write(described(written, "O2", "A bus."))
    assert told.asked == ["O2", "O1"] and dirty(after, method.keys) == []
    assert not re.search(r"\bsecond\b", assemble(after).text)


async def test_a_name_gone_since_its_reader_was_written_has_it_written_once_more(server, method):
    told = Told(server, O1="first = new Car ahead of ego by 5", O2="second = new Car ahead of ego by 9")
    written = await method.write(two_objects())
    both = described(described(written, "O1", "Car 1 again."), "O2", "A bus.")
    told.asked.clear()
    answers = iter(["first = new Car behind second by 5", "first = new Car behind ego by 5"])

    def respond(request):
        cid = asked_for(request)
        told.codes[cid] = next(answers) if cid == "O1" else "bus = new Bus ahead of ego by 9"
        return told(request)

    server.respond = respond
    after = await method.write(both)
    assert told.asked == ["O1", "O2", "O1"] and dirty(after, method.keys) == []
    assert not re.search(r"\bsecond\b", assemble(after).text)


async def test_names_that_come_and_go_for_ever_end(server, method):
    told = Told(server)
    turns = iter(range(99))

    def respond(request):
        n = next(turns)
        told.codes |= {"O1": f"a{n} = new Car behind b{n - 1}", "O2": f"b{n} = new Car behind a{n - 1}"}
        return told(request)

    server.respond = respond
    after = await method.write(two_objects())
    assert dirty(after, method.keys) == [] and len(told.asked) <= 8
    await method.write(described(after, "O1", "Another."))
    assert len(told.asked) <= 12


async def test_what_the_model_fails_to_write_keeps_its_code_and_stays_stale(server, method):
    told = Told(server, O1="first = new Car ahead of ego by 5", O2="second = new Car ahead of first by 9")
    written = await method.write(two_objects())
    told.codes["O1"] = ""
    events: list = []
    after = await method.write(described(written, "O1", "A lorry."), events.append)
    assert after["O1"].code == written["O1"].code and after["O1"].description == "A lorry."
    assert dirty(after, method.keys) == ["O1"]
    assert any("O1 keeps its code of before" in e.text for e in events if isinstance(e, Say))
    told.codes["O1"] = "first = new Truck ahead of ego by 5"
    told.asked.clear()
    mended = await method.write(after)
    assert told.asked == ["O1"] and "new Truck" in mended["O1"].code and dirty(mended, method.keys) == []


async def test_code_by_hand_stays_and_gets_an_offer_where_its_sentence_changes(server, method):
    told = Told(server, O1="first = new Car ahead of ego by 5", O2="second = new Car ahead of first by 9")
    written = await method.write(two_objects())
    mine = "first = new Car ahead of ego by 7  # mine\n"
    hand = await method.write(edits.apply(written, edits.SetCode(component="O1", code=mine)))
    assert hand["O1"].conflict is None and hand["O1"].origin == "by_hand"
    told.asked.clear()
    assert await method.write(hand) == hand and told.asked == []
    told.codes["O1"] = "first = new Truck ahead of ego by 5"
    after = await method.write(described(hand, "O1", "A lorry."))
    assert after["O1"].code == mine and "new Truck" in after["O1"].conflict and told.asked == ["O1"]
    assert mine in assemble(after).text and "new Truck" not in assemble(after).text
    assert await method.write(after) == after and told.asked == ["O1"], "offered once"
    told.codes["O1"] = "first = new Bus ahead of ego by 5"
    taken = await method.write(by_hand.apply(after, edits.SetCode(component="O1", code=None)))
    assert taken["O1"].code == after["O1"].conflict and taken["O1"].origin == "generated" and told.asked == ["O1"]
    assert taken["O1"].conflict is None and dirty(taken, method.keys) == [], "what was shown is what is taken"
    kept = await method.write(edits.apply(after, edits.SetCode(component="O1", code=mine)))
    assert kept["O1"].conflict is None and told.asked == ["O1"]


async def test_code_by_hand_gets_an_offer_where_a_name_that_it_uses_is_gone(server, method):
    told = Told(server, O1="first = new Car ahead of ego by 5", O2="second = new Car ahead of first by 9")
    written = await method.write(two_objects())
    hand = edits.apply(written, edits.SetCode(component="O2", code="second = new Car ahead of first by 3\n"))
    hand = await method.write(hand)
    told.codes |= {"O1": "lorry = new Truck ahead of ego by 5", "O2": "second = new Car ahead of lorry by 9"}
    after = await method.write(described(hand, "O1", "A lorry."))
    assert "first" in after["O2"].code and "lorry" in after["O2"].conflict


def test_marks_are_of_the_code_that_they_stand_by():
    structure = two_objects()
    hand = by_hand.with_marks(edits.apply(structure, edits.SetCode(component="O1", code="a = new Car\n")))
    assert by_hand.outdated(hand, words=True) == []
    changed = described(hand, "O1", "Other words.")
    assert by_hand.outdated(changed, words=True) == ["O1"] and by_hand.outdated(changed, words=False) == []
    again = by_hand.with_marks(edits.apply(changed, edits.SetCode(component="O1", code="a = new Truck\n")))
    assert by_hand.outdated(again, words=True) == [], "written by hand since"
    faster = edits.apply(hand, edits.SetField(component="O1", path="speed", value=3.0))
    assert by_hand.outdated(faster, words=False) == ["O1"]
    assert by_hand.with_offer(faster, "O1", "a = new Car").components[3].conflict is None, "the same code is no offer"

"""Stability under rewording, and requirements in the results."""

import pytest

from c2s_bench.records import BenchmarkError
from c2s_bench.results import Result, classes, load_results, save
from c2s_bench.rewording import PAIRS, Pair, compared, markdown, read_pairs
from c2s_bench.scorer import RecordScore
from c2s_bench.tables import requirements
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import ObjectSpec, Phase, Placement

LEAD = ObjectSpec(name="lead", phases=(Phase(action="brake"),))
VAN = ObjectSpec(name="van", type="van", placement=Placement(of="O1", position="behind"))


def s(*objects: ObjectSpec) -> Structure:
    return Structure(objects=tuple(Component(id=f"O{i}", spec=o) for i, o in enumerate(objects, 1)))


def test_the_same_in_another_order_is_the_same():
    other = s(VAN.model_copy(update={"placement": Placement(of="O2", position="behind")}), LEAD)
    assert compared(s(LEAD, VAN), other) == (1.0, ())


def test_what_differs_is_named():
    share, differ = compared(s(LEAD), s(LEAD.model_copy(update={"phases": (Phase(action="stop"),)})))
    assert 0.5 < share < 1.0 and "O1.phases.0.brake" in differ and "O1.phases.0.stop" in differ
    told = markdown([Pair(("a", "b"), share, differ), Pair(("c", "d"), 1.0, ())], every=False)
    assert told.startswith("1 of 2 pairs require the same (50 %)") and "O1.phases.0.stop" in told


def test_the_shipped_pairs_are_pairs():
    pairs = read_pairs(PAIRS)
    assert len(pairs) == 60 and len({t for p in pairs for t in p}) == 120


@pytest.mark.parametrize("text", ["- [only one]", "a: b", "- - x\n  - [y", ""])
def test_what_is_no_list_of_pairs_is_told_in_a_sentence(tmp_path, text):
    file = tmp_path / "pairs.yaml"
    file.write_text(text)
    with pytest.raises(BenchmarkError, match=str(file)):
        read_pairs(file)


def result(ran: bool, *held: bool | None) -> Result:
    required = tuple({"id": f"E.{i}", "kind": "pace" if i else "phase", "holds": h} for i, h in enumerate(held))
    layers = dict.fromkeys(("RL", "TI", "TM", "DO", "EN"))
    return Result("dev", False, RecordScore("a", "x", ran, layers, 0.0, ()), 1.0, 0.0, "", "", "", required=required)


def test_whole_is_what_ran_and_showed_all():
    found = [
        result(True, True, True),
        result(True, True, None),
        result(True, True, False),
        result(False, True),
        result(True),
    ]
    assert [r.whole for r in found] == [True, False, False, False, False]
    assert classes(found) == {"pace": (1, 3, 1), "phase": (3, 3, 0)}
    assert requirements(found).startswith("Whole: 1 of 5 (20 %)")


def test_results_keep_what_was_required(tmp_path):
    save([result(True, True, None)], tmp_path / "r.jsonl")
    assert [dict(r) for r in load_results(str(tmp_path / "r.jsonl"))[0].required] == list(
        result(True, True, None).required
    )

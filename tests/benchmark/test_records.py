"""Records: the shipped ones are whole and distributed as in the paper; a broken one is refused with its place."""

import pytest

from c2s_bench import records
from c2s_bench.distribution import COLUMNS, distribution, markdown
from c2s_bench.paper import paper

WHOLE = """
- id: mine-01
  source: Mine
  reference: a note
  text: The ego drives.
  tags: {sce: true, vru: [], traffic_control: [], temporal: false, vehicle_behaviors: [], vru_behaviors: []}
  expect:
    ego: {does: [keep_lane]}
    actors:
      - {as: lead, type: car}
"""


def test_the_123_are_distributed_as_the_paper_says():
    found, theirs = distribution(records.load()), paper()["distribution"]
    numbers = {source: row[0] for source, row in found.items() if source != "Total"}
    assert numbers == {s: row[0] for s, row in theirs.items() if s != "Total"}
    defined = [COLUMNS.index(c) for c in ("Number", "SCE", "VRU", "VRU types", "TC", "Temporal")]
    assert [found["Total"][i] for i in defined] == [123, 121, 26, 3, 12, 103]
    for source, row in found.items():
        assert [row[i] for i in (0, 1, 2, 4, 5)] == [theirs[source][i] for i in (0, 1, 2, 4, 5)], source
    assert "| Total | 123 | 121 | 26 | 3 | 12 | 103 |" in markdown(records.load())


def test_the_parts_are_split_by_the_number():
    dev, test = records.load(split="dev"), records.load(split="test")
    assert len(dev) + len(test) == 123
    assert {r.id for r in test} >= {"un-r152-03", "carla-lb-24"} and not {r.id for r in test} & {r.id for r in dev}
    assert all(r.withheld for r in test) and not any(r.withheld for r in dev)


def test_records_of_ones_own_are_never_withheld(tmp_path):
    file = tmp_path / "mine.yaml"
    file.write_text(WHOLE.replace("mine-01", "mine-03"))
    (record,) = records.load([file])
    assert (record.id, record.source, record.text, record.part) == ("mine-03", "Mine", "The ego drives.", "test")
    assert not record.withheld


@pytest.mark.parametrize(
    ("old", "new", "place", "complaint"),
    [
        ("type: car", "type: tank", ":10: mine-01: expect.actors[0].type", "'tank' is not one of"),
        ("keep_lane", "fly", ":8: mine-01: expect.ego.does[0]", "'fly' is not one of"),
        ("  text: The ego drives.\n", "", ":2: mine-01: text", "is missing"),
        ("as: lead", "as: ego", ":10: mine-01: expect.actors[0].as", "must be a name of its own"),
        ("source: Mine", "source: Mine\n  source: Yours", "mine.yaml:4", "twice"),
        ("expect:", "expect: [", "mine.yaml:", "no YAML"),
    ],
)
def test_a_broken_record_is_refused_with_file_line_and_id(tmp_path, old, new, place, complaint):
    file = tmp_path / "mine.yaml"
    file.write_text(WHOLE.replace(old, new))
    with pytest.raises(records.BenchmarkError) as caught:
        records.load([file])
    assert place in str(caught.value) and complaint in str(caught.value)


def test_an_id_that_is_used_twice_is_refused(tmp_path):
    file = tmp_path / "mine.yaml"
    file.write_text(WHOLE + WHOLE)
    with pytest.raises(records.BenchmarkError, match="mine.yaml:12: mine-01: id: is used before, at mine.yaml:2"):
        records.load([file])


@pytest.mark.full
def test_the_fresh_descriptions_are_records():
    files = sorted((records.FOLDER.parent / "fresh").glob("*.yaml"))
    found = records.load(files)
    assert len(found) == 1372 == len({r.id for r in found})
    assert {r.part for r in found} == {"dev", "test"}
    assert all(r.withheld == (r.part == "test") for r in found), "what is only counted is not shown"

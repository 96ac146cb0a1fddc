"""Records may hold S itself, so that the way from S to the run is judged apart from reading."""

from pathlib import Path

import pytest

from c2s_engine.report.gather import of_text, read_records, structure_of
from c2s_engine.report.material import ReportError
from c2s_engine.require import require
from c2s_engine.write.typed import contradiction

BATCHES = sorted((Path(__file__).parents[2] / "benchmark/judging/batches").glob("*.yaml"))
WRONG = {
    "an unknown component": ({"X": {}}, "X is no component of S"),
    "no map": ({"R": "a road"}, "R is no component of S"),
    "an unknown field": ({"E": {"velocity": 3}}, "E.velocity"),
    "an unknown value": ({"R": {"kind": "beach"}}, "R.kind"),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_is_no_structure_is_named(case):
    components, named = WRONG[case]
    with pytest.raises(ReportError, match=named.replace(".", r"\.")):
        structure_of(components, "A text.")


@pytest.mark.parametrize("file", BATCHES, ids=lambda f: f.stem)
def test_judged_batches_hold_structures(file):
    """All of a batch, or, where only readings were judged, none."""
    records = read_records(file)
    given = [r for r in records if r.structure is not None]
    assert len(records) >= 14 and len(given) in (0, len(records))
    assert not [r.id for r in given if contradiction(r.structure)]
    assert all(require(r.structure) for r in given)


@pytest.mark.full
async def test_a_given_structure_is_realised(engine, tmp_path):
    file = tmp_path / "records.yaml"
    file.write_text(
        "- id: lead\n"
        "  text: The car ahead brakes hard.\n"
        "  structure:\n"
        "    E: {speed: 14}\n"
        "    O1: {name: lead, placement: {position: ahead}, phases: [{action: brake, rate: 6}], unmet: [no lights]}\n"
    )
    material = await of_text(engine, read_records(file)[0])
    assert not material.problem and material.program.text
    assert material.structure["O1"].unmet[0].text == "no lights"
    assert "brakes hard" in material.structure["O1"].description
    assert material.structure.ego.spec.reaction == "brake"  # and says so
    assert [a.field for a in material.structure.ego.assumed] == ["reaction"]

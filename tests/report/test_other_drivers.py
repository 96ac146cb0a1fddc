"""A scene with other drivers in ego's place: what hangs on ego's reaction is not seen with one that never reacts."""

import pytest

from c2s_engine.report.dossier import dossier
from c2s_engine.report.gather import of_text, read_records
from c2s_engine.report.markdown import markdown
from c2s_engine.session.other_drivers import slower

RECORDS = """
- id: waits
  text: A pedestrian steps out; ego stops. The truck opposite, which stood, sets out as ego stands.
  structure:
    E: {speed: 11, reaction: brake, react_to: O1, hard: true, phases: [{action: stop, target: O1}]}
    O1:
      {name: walker, type: pedestrian, placement: {position: roadside, side: right, gap: 45},
       phases: [{action: enter_road}]}
    O2:
      {name: truck, type: truck, speed: 0, placement: {position: oncoming_lane, gap: 90},
       phases: [{action: wait}, {action: start, speed: 6, trigger: {kind: action, of: ego, action: stop}}]}
"""


@pytest.mark.full
async def test_what_hangs_on_egos_reaction_is_not_seen_with_one_that_never_reacts(engine, tmp_path):
    file = tmp_path / "records.yaml"
    file.write_text(RECORDS)
    material = await of_text(engine, read_records(file)[0], drivers=True)
    assert not material.problem
    never, slow = material.drivers
    assert (never.name, slow.name) == ("never reacts", "20 % slower")
    assert any("O2" in missed for missed in never.missed)
    assert not slow.missed and not [r for r in material.results if not r.holds and "O2" in r.requirement]
    text = markdown(dossier(material))
    assert "never reacts" in text and never.missed[0] in text
    code = slower(material.structure.ego).code
    assert code.count("0.8 * EGO_SPEED") == material.structure.ego.code.count("EGO_SPEED") - 1

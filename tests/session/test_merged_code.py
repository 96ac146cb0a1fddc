"""Generated code that was edited by hand follows S, and S follows it."""

import pytest
import pytest_asyncio

from c2s_engine.session.read_back import plain
from c2s_engine.session.sessions import Sessions
from c2s_engine.structure.components import unrecognised
from c2s_engine.structure.edits import SetCode, SetField, SetProgram
from c2s_engine.structure.progress import Finished, Say

TEXT = "Ego drives at 30 km/h in a city. A car ahead of ego at 50 km/h brakes hard."


@pytest_asyncio.fixture
async def session(engine, tmp_path):
    sessions = Sessions(tmp_path)
    opened = sessions.open("one", engine)
    await done(opened.say(TEXT, run=False))
    yield opened
    opened.close()
    sessions.close()


async def done(events):
    found = [event async for event in events]
    assert isinstance(found[-1], Finished)
    assert not [d for stage in found[-1].stages for d in stage.diagnostics if d.severity == "error"]
    return " ".join(event.text for event in found if isinstance(event, Say))


async def by_hand(session, cid, *swaps):
    code = session.structure[cid].code
    for swap in swaps:
        assert swap[0] in code
        code = code.replace(*swap)
    return await done(session.apply(SetCode(component=cid, code=code), run=False))


REMARK = ("\nbehavior", "\n# my own remark\nbehavior")


async def test_a_comment_leaves_all_required_and_everything_editable(session):
    await by_hand(session, "O1", REMARK)
    assert session.structure["O1"].origin == "by_hand" and not unrecognised(session.structure)
    was = session.structure["O1"].code
    await done(session.say("make the lead car drive at 45 km/h", run=False))
    now = session.structure["O1"]
    assert now.spec.speed == pytest.approx(12.5) and now.conflict is None
    assert "THE_CAR_SPEED = 12.5  # m/s" in now.code and "# my own remark" in now.code and "45 km/h" in now.code
    assert len(now.code.split("\n")) == len(was.split("\n"))


async def test_a_new_description_asks_before_it_replaces_code_by_hand(session):
    await by_hand(session, "O1", REMARK)
    before = session.structure
    assert "O1 has code of yours" in await done(session.say(TEXT, run=False))
    assert session.structure == before
    assert "Taken as a new description" in await done(session.say(TEXT, run=False))
    assert session.structure["O1"].origin == "rendered"


async def test_in_a_conflict_the_sentence_says_what_the_fields_do(session):
    await by_hand(session, "O1", ("take SetSpeedAction(THE_CAR_SPEED)", "take SetSpeedAction(9)"), REMARK)
    await done(session.apply(SetField(component="O1", path="placement.position", value="left_lane"), run=False))
    now = session.structure["O1"]
    assert "lane to the left" in now.description and "lane to the left" in (now.conflict or now.code)


async def test_another_type_keeps_the_name_that_code_by_hand_uses(session):
    await by_hand(session, "E", REMARK)
    await by_hand(session, "O1", REMARK)
    await done(session.say("make the lead car a bus", run=False))
    bus = session.structure["O1"]
    assert bus.spec.type == "bus" and "the_car = new Bus at" in bus.code and "# my own remark" in bus.code
    assert "Uniform(*CARS)" not in bus.code and "the_car" in session.structure["E"].code


async def test_code_in_conflict_stays_as_it_is(session):
    """Another type asks for another speed, too, which code that was changed there cannot take."""
    await by_hand(session, "O1", ("THE_CAR_SPEED = 13.89", "THE_CAR_SPEED = EGO_SPEED + 5.5"), REMARK)
    was = session.structure["O1"].code
    said = await done(session.say("make the lead car a pedestrian", run=False))
    now = session.structure["O1"]
    assert now.spec.type == "pedestrian" and now.code == was and now.conflict
    assert "your code is kept" in said and "changed in the code" not in said


async def test_a_number_beside_other_changes_is_read_into_s(session):
    told = await by_hand(session, "E", REMARK, ("EGO_SPEED = 8.33", "EGO_SPEED = 5.0"))
    ego = session.structure["E"]
    assert "E, read from the code: speed is 18 km/h." in told and ego.spec.speed == pytest.approx(5.0)
    assert "EGO_SPEED = 5.0" in ego.code and ego.description in ego.code and "18 km/h" in ego.description
    told = await by_hand(session, "E", ("EGO_SPEED = 5.0", "EGO_SPEED = 10"))
    assert "speed is 36 km/h" in told and session.structure["E"].origin == "by_hand"


async def test_a_number_changed_with_its_comment_is_read_into_s_and_the_comment_stays(session):
    mine = "EGO_SPEED = 5.0  # m/s, mine: keep me\nMY_NOTE = 3\n"
    told = await by_hand(session, "E", ("EGO_SPEED = 8.33  # m/s\n", mine))
    ego = session.structure["E"]
    assert "E, read from the code: speed is 18 km/h." in told and ego.spec.speed == pytest.approx(5.0)
    assert mine in ego.code and "18 km/h" in ego.description and not ego.conflict
    await done(session.say("ego at 36 km/h", run=False))
    assert mine.replace("5.0", "10") in session.structure["E"].code and not session.structure["E"].conflict


@pytest.mark.full
async def test_code_that_was_kept_against_its_fields_says_so(session):
    await by_hand(session, "O1", ("THE_CAR_SPEED = 13.89", "THE_CAR_SPEED = EGO_SPEED + 5.5"))
    await done(session.apply(SetField(component="O1", path="speed", value=12.5), run=False))
    kept = session.structure["O1"]
    assert kept.conflict and "12.5" in kept.conflict
    await done(session.apply(SetCode(component="O1", code=kept.code), run=False))
    assert session.structure["O1"].by_hand == "apart" and session.structure["O1"].conflict is None
    await done(session.apply(SetField(component="E", path="speed", value=7.0), run=False))
    assert session.structure["O1"].by_hand == "apart"
    whole = session.program.text.replace("\nthe_car = ", "\n# touched again\nthe_car = ")
    await done(session.apply(SetProgram(text=whole), run=False))
    assert session.structure["O1"].by_hand == "", "what was kept is not what stands there now"
    await done(session.apply(SetCode(component="O1", code=None), run=False))
    assert session.structure["O1"].by_hand == "" and "THE_CAR_SPEED = 12.5" in session.structure["O1"].code


@pytest.mark.parametrize(
    ("value", "words"),
    [
        ([{"kind": "distance", "subject": "ego", "other": "O2", "minimum": 100.0, "maximum": None}],
         "kind distance, subject ego, other O2, minimum 100"),
        ("police_car", "police car"), (None, "nothing"), ([], "nothing"),
    ],
)  # fmt: skip
def test_what_was_read_is_told_in_words(value, words):
    assert plain("require", value) == words


FOLLOWING = "Ego follows a car at 60 km/h on a straight road. The car brakes hard and ego stops behind it."


async def test_a_constant_that_the_writer_uses_once_is_read_into_s(session):
    """The writer would follow at the speed of the car: other code than ego's constant gives."""
    await done(session.say(FOLLOWING, map=None, run=False))
    told = await by_hand(session, "E", ("EGO_SPEED = 16.67", "EGO_SPEED = 13.89"))
    ego = session.structure["E"]
    assert "E, read from the code: speed is 50 km/h." in told and ego.spec.speed == pytest.approx(13.89)
    assert "50 km/h" in ego.description and ego.description in ego.code and not ego.conflict
    await done(session.say("ego should be 10 km/h slower", run=False))
    ego = session.structure["E"]
    assert "40 km/h" in ego.description and "EGO_SPEED = 11.1" in ego.code and not ego.conflict


async def test_a_constant_that_no_field_gives_is_named_as_not_read(session):
    told = await by_hand(session, "E", ("EGO_SPEED = 8.33", "EGO_SPEED = 8000"))
    assert "E: EGO_SPEED = 8000 was not read from the code; S still says: Ego, a car, drives at 30 km/h" in told
    assert session.structure["E"].spec.speed == pytest.approx(8.33, abs=0.01)


async def test_a_number_is_read_into_s_after_an_edit_that_did_not_parse(session):
    code = session.structure["E"].code
    broken = code.replace("EGO_SPEED = 8.33", "EGO_SPEED =# my note: 20 km/h")
    async for _ in session.apply(SetCode(component="E", code=broken), run=False):
        pass
    mine = "EGO_SPEED = 5.0  # my note: 20 km/h"
    fixed = code.replace("EGO_SPEED = 8.33  # m/s", f"{mine}\nMY_MARGIN = 2.0  # m, mine")
    told = await done(session.apply(SetCode(component="E", code=fixed), run=False))
    ego = session.structure["E"]
    assert "E, read from the code: speed is 18 km/h." in told and ego.spec.speed == pytest.approx(5.0)
    assert mine in ego.code and "18 km/h" in ego.description


async def test_another_name_in_s_is_the_name_in_code_by_hand(session):
    await by_hand(session, "E", ("\nbehavior", "\n# the_car is Ida's\nbehavior"))
    was = session.structure["E"].code
    assert "the_car" in was.replace("# the_car is Ida's", "")
    await done(session.apply(SetField(component="O1", path="name", value="lead"), run=False))
    now = session.structure["E"].code
    assert "# the_car is Ida's" in now and "the_car" not in now.replace("# the_car is Ida's", "")
    assert session.structure["E"].origin == "by_hand" and session.structure["E"].conflict is None
    await by_hand(session, "O1", REMARK)
    await done(session.apply(SetField(component="O1", path="name", value="leader"), run=False))
    assert "LEADER_SPEED" in session.structure["O1"].code and "# my own remark" in session.structure["O1"].code
    assert "leader" in session.structure["E"].code and session.structure["O1"].conflict is None


async def test_another_type_in_changed_code_has_a_blueprint_of_its_own(session):
    await done(session.apply(SetField(component="O1", path="type", value="van"), run=False))
    at = next(line for line in session.structure["O1"].code.splitlines() if "_AT = " in line)
    await by_hand(session, "O1", (at, at.split("#")[0].rstrip() + " + 1  # mine"))
    await done(session.apply(SetField(component="O1", path="type", value="bus"), run=False))
    now = session.structure["O1"].code
    assert "new Bus at" in now and "mercedes.sprinter" not in now and "# mine" in now


async def test_a_comment_in_ego_leaves_the_others_as_they_are(session):
    was = {c.id: c.code for c in session.structure.components}
    await by_hand(session, "E", REMARK)
    others = {c.id: c.code for c in session.structure.components if c.id != "E"}
    assert others == {k: v for k, v in was.items() if k != "E"}
    assert "place_of(" not in session.structure["O1"].code


async def test_a_number_that_becomes_a_range_is_read_into_s(session):
    told = await by_hand(session, "E", REMARK, ("EGO_SPEED = 8.33", "EGO_SPEED = Range(4, 6)"))
    ego = session.structure["E"]
    assert "E, read from the code: speed is 14.4 to 21.6 km/h." in told
    assert ego.spec.speed == (4.0, 6.0) and "Range(4, 6)" in ego.code and not ego.conflict


async def test_an_expression_in_the_place_of_a_number_is_told(session):
    told = await by_hand(session, "E", REMARK, ("EGO_SPEED = 8.33", "EGO_SPEED = 2 * 4"))
    assert "EGO_SPEED = 2 * 4 was not read from the code" in told or "speed is 28.8 km/h" in told

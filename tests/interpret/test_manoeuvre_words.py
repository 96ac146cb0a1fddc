"""The families of words for one manoeuvre: idioms, nouns and particles, each in several sentences."""

import pytest

from c2s_engine.interpret.embedded import EmbeddedInterpreter

CONTACT = [
    "The front of Vehicle 1 met the passenger door of Vehicle 2.",
    "Vehicle 1's front bumper met the left rear of Vehicle 2.",
    "A van caught my rear wing.",
    "My car ended up in the side of a white van.",
    "The ego finished up against the rear of a parked truck.",
    "The ego came to rest against a parked van.",
    "I buried the bonnet in the back of a truck.",
    "The AV nudged the car ahead.",
    "The AV tapped the rear bumper of a stopped sedan.",
    "Vehicle 1 brushed against a parked car.",
    "Vehicle 1 and Vehicle 2 came together in the middle of the junction.",
    "The ego was in collision with a motorcycle.",
    "V1 broadsided V2 in the intersection.",
    "V1 cannoned into a parked car.",
    "V1 mowed down a pedestrian on the crosswalk.",
    "The pedestrian was run over by V1.",
    "A deer jumped out and was hit.",
    "The cyclist rode into my front left corner.",
    "V2 was parked. Contact occurred between the front of V1 and the rear of V2.",
    "V1 followed V2. V2 braked and an impact resulted.",
    "V2 merged into the side of V1.",
]
NO_CONTACT = [
    "The ego tapped the brakes behind a van.",
    "The AV nudged forward behind a truck.",
    "A van took the gap in front of ego.",
    "The ego ran down the hill behind a truck.",
    "The ego came to rest behind a parked van.",
    "A cyclist caught up with the ego.",
]
WORDS = [
    ("u_turn", "A taxi ahead of ego swings round in the road."),
    ("u_turn", "A van reverses its direction of travel by a U-turn ahead of the ego."),
    ("u_turn", "The parked car pulled out and made a complete about-turn in front of ego."),
    ("overtake", "The safety driver took the AV around a stopped truck."),
    ("overtake", "The ego leaves the tractor behind."),
    ("overtake", "The ego completes the pass of a slow truck."),
    ("oncoming", "An oncoming car eased over the double yellow line while ego approached."),
    ("oncoming", "V2 took the bend too wide as V1 came the other way."),
    ("oncoming", "An approaching van left its own half of the road in front of ego."),
    ("leave_road", "The ego departed from the carriageway on the right."),
    ("leave_road", "The motorcycle ahead of ego took to the shoulder."),
    ("leave_road", "The oncoming van saved itself by descending onto the verge as ego passed."),
    ("turn", "V1 made a right on red."),
    ("turn", "A pickup made its left in front of the AV."),
    ("turn", "An oncoming car makes an unprotected left in front of ego."),
    ("turn", "I was making a right into a petrol station."),
    ("brake", "I stood on the pedal."),
    ("brake", "The ego locked its wheels."),
    ("brake", "The car in front of ego came off the throttle."),
    ("stop", "The bus ahead of ego drew up at the crossing."),
    ("follow", "Our van hung on the tail of a black BMW."),
    ("follow", "The ego travels in the wake of a lorry."),
    ("cut_in", "A car slotted in ahead of the AV."),
    ("cut_in", "A car from the next lane moved across me."),
    ("cut_in", "The motorcyclist re-enters the left lane 15 m in front of ego."),
    ("lane_change", "The ego moves one lane over to the left."),
    ("lane_change", "The VUT makes for the left lane."),
    ("cross_road", "An individual wheeled a cart over both lanes in front of the AV."),
    ("start", "The AV got under way again."),
]


def acts(text: str) -> dict[str, str]:
    """What happens in a text: act and mode."""
    return {e["act"]: e["mode"] for e in EmbeddedInterpreter().interpret(text).stages["events"]}


@pytest.mark.parametrize("text", CONTACT)
def test_contact_is_read_in_many_words(text: str) -> None:
    assert acts(text).get("collide") == "fact"


@pytest.mark.parametrize("text", NO_CONTACT)
def test_no_contact_where_only_the_word_is_the_same(text: str) -> None:
    assert "collide" not in acts(text)


@pytest.mark.parametrize(("act", "text"), WORDS)
def test_a_manoeuvre_is_read_in_many_words(act: str, text: str) -> None:
    assert act in acts(text)


def test_what_was_under_way_when_one_failed_is_not_denied() -> None:
    found = acts("Turning left on green, V1 failed to yield to an oncoming motorcycle.")
    assert found["turn"] == "fact" and found["yield"] == "negated"

"""What a text says besides its tale: codes of crash research, titles, file names, what is not needed, how cars look."""

import pytest

from c2s_engine.interpret.embedded import EmbeddedInterpreter

CODES = [
    "The critical reason was assigned to this vehicle.",
]
TALE = "V1 was eastbound in the left lane of a divided highway. V2 was stopped ahead of V1 and V1 struck V2."


def read(text):
    return EmbeddedInterpreter().interpret(text).structure


def specs(structure):
    return [c.spec for c in structure.components]


@pytest.mark.parametrize("code", CODES)
def test_codes_of_crash_research_tell_nothing_new(code):
    assert specs(read(f"{TALE} {code}")) == specs(read(TALE))


def test_what_an_event_tells_in_words_stays():
    found = read("The critical event is a cyclist who crosses from the right.")
    assert found["O1"].spec.type == "bicycle"


@pytest.mark.parametrize(
    "head",
    [
        "# turn_left_across_path\n# ",
    ],
)
def test_a_file_name_and_a_heading_are_no_manoeuvre(head):
    tale = "Ego cruises down a residential street at 30 km/h. A van ahead brakes because a dog runs out from the left."
    assert specs(read(head + tale)) == specs(read(tale))


def test_the_name_of_a_form_is_no_manoeuvre():
    found = read("Category: opposite direction. Name: mid-block U-turn.\nLanes: 2\nEgo speed: 45 km/h\nWeather: cloudy")
    assert found.ego.spec.phases == ()


@pytest.mark.parametrize("rest", ["other traffic is not required", "further vehicles are not needed."])
def test_what_is_not_required_is_not_there(rest):
    tale = "Ego follows a bus at 40 km/h. The bus brakes; "
    assert specs(read(tale + rest)) == specs(read(tale))


@pytest.mark.parametrize("verb", ["backed", "ran", "drove", "smashed"])
@pytest.mark.parametrize("looks", ["", "small ", "small red ", "rather old white ", "loaded "])
def test_whoever_is_hit_may_look_like_anything(verb, looks):
    actions = [p.action for p in read(f"I {verb} into a {looks}car.").ego.spec.phases]
    assert "collide" in actions


def test_whom_one_hails_is_no_weather():
    assert read("A taxi stops for a man who is hailing it. Heavy rain.").settings.spec.weather == ("heavy_rain",)


@pytest.mark.parametrize("said", ["It was pouring.", "It was pouring and getting dark."])
def test_it_pours(said):
    assert read(f"{said} Ego follows a van.").settings.spec.weather == ("heavy_rain",)


def test_who_pours_out_is_no_weather():
    assert read("Fans are pouring out of the stadium. Ego follows a van.").settings.spec.weather == ()


@pytest.mark.parametrize("plural", ["schoolchildren", "wolves", "calves"])
def test_plurals(plural):
    assert read(f"Two {plural} cross the road in front of ego.")["O1"].spec.count == 2


@pytest.mark.parametrize("pulls", ["pulling a semi-trailer", "towing one loaded semi-trailer", "with a semi-trailer"])
def test_a_semi_trailer_is_part_of_who_pulls_it(pulls):
    assert len(read(f"V1, a truck-tractor {pulls}, was westbound in the right lane.").objects) == 0


def test_who_had_been_following_ego_is_behind_it():
    text = "The AV turned right on green and stopped for a pedestrian. A van that had been following the AV did not "
    van = read(text + "stop in time and hit it.")["O2"].spec
    assert (van.placement.position, van.phases[-1].action) == ("behind", "collide")


def test_a_driver_behind_the_wheel_says_no_place():
    van = read("V-2 was stalled in the lane ahead, D-2 still behind whl. V-1 struck V-2.")["O1"].spec
    assert van.placement.position == "ahead"

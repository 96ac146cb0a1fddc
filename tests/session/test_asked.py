"""Questions about the scene at hand are answered from S and from its run; others are left to the documents."""

import pytest

from c2s_engine.session.asked import HELP, UNANSWERED, answered, asks_for_account, wants_help
from c2s_engine.structure.account import count_lost_clauses, requirements_met
from c2s_engine.structure.components import Assumption, Component, Link, Structure, Unmet
from c2s_engine.structure.facts import ContactFact, EventFact, ObjectFacts, RunFacts
from c2s_engine.structure.measures import ActorMeasures, Measures, PairMeasures
from c2s_engine.structure.program import Program
from c2s_engine.structure.progress import Finished
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import EgoSpec, ObjectSpec

EGO = ObjectFacts(
    name="ego", component="E", types=("car", "vehicle"), length=4.5, width=2, moves=True, held_speed=13.9,
    events=(EventFact(event="brake", time=3.6), EventFact(event="keep_lane", time=0.0)),
)  # fmt: skip
CYCLIST = ObjectFacts(
    name="cyclist", component="O1", types=("bicycle",), length=1.8, width=0.6, moves=True,
    events=(EventFact(event="enter_road", time=2.9), EventFact(event="hits", time=4.1, other="ego")),
)  # fmt: skip
STRUCTURE = Structure(
    text="Ego drives. A cyclist crosses.",
    ego=Component(id="E", description="Ego drives.", spec=EgoSpec(reaction="brake"),
                  assumed=(Assumption(field="reaction", value="brake", reason="the text does not say"),)),
    objects=(Component(id="O1", description="A bicycle crosses.", spec=ObjectSpec(name="cyclist", type="bicycle")),),
)  # fmt: skip
REQUIRED = Requirement(
    id="T.no_other_contact", kind="outcome", component="T", text="Nobody touches anybody.", check="no_other_contact",
    values={"pairs": ()},
)  # fmt: skip
SHOWN = Finished(
    ok=True, structure=STRUCTURE, program=Program(text="ego = new Car\n"), requirements=(REQUIRED,),
    facts=(RunFacts(seed=0, duration=5.1, ended_by="collision", objects=(EGO, CYCLIST), contacts=(
        ContactFact(time=4.08, one="ego", other="cyclist", part_one="front", part_other="left"),)),),
    results=(Result(requirement=REQUIRED.id, holds=False, robustness=-1, said="no other contact", seen="they touch"),),
    measures=(Measures(
        pairs=(PairMeasures(other="cyclist", gap_m=0.0, gap_at_s=4.1, ttc_s=0.2, ttc_at_s=4.0),),
        actors=(ActorMeasures(name="ego", fastest=13.9, slowest=9.0, slowest_at_s=4.1, braking=4.2, braking_at_s=3.9),
                ActorMeasures(name="cyclist", fastest=4.5, slowest=4.4, slowest_at_s=1, braking=0.1, braking_at_s=1)),
    ),),
)  # fmt: skip


@pytest.mark.parametrize(
    ("question", "words"),
    [("was there a collision?", "COLLISION ego-cyclist at 4.1 s, not in the text"),
     ("did they crash", "COLLISION ego-cyclist"),
     ("Why does ego brake?", "the text does not say"),
     ("why did the ego slow down?", "begins to brake at 3.6 s, after cyclist enters the road at 2.9 s"),
     ("how hard did ego brake?", "4.2 m/s2 at most, at 3.9 s"),
     ("how close did they come?", "bumper to bumper: 0 m at 4.1 s; smallest time to collision 0.2 s"),
     ("was there a collision? and how close did they come?", "not in the text.\nSmallest gap"),
     ("what was the minimum TTC?", "time to collision 0.2 s at 4.0 s"),
     ("how fast was the cyclist?", "cyclist fastest 16 km/h"),
     ("did ego stop?", "No: ego does not stop in the run."),
     ("what happened?", "2.9 s cyclist enters the road; 3.6 s ego brakes; 4.1 s cyclist hits ego"),
     ("was the cyclist hidden?", "cyclist is in ego's sight from the start."),
     ("did it work?",
          "0 of 1 requirements met; 2 clauses of the text are not fully in S.\nT: Nobody touches anybody."),
     ("what was not understood?", "0 of 2 clauses of the text are in S as understood.\n“Ego drives.”: not understood"),
     ("what did you assume?", "E: reaction brake (the text does not say)"),
     ("what was assumed of O1?", "Nothing was assumed."),
     ("who is O1?", "O1: A bicycle crosses."),
     ("what is TTC?", "TTC: Time to collision"),
     ("what does PET mean?", "PET: Post-encroachment time"),
     ("what is the maximum deceleration of ego?", "4.2 m/s2 at most, at 3.9 s"),
     ("when does the cyclist enter the road and at which speed?", "cyclist enters the road at 2.9 s. cyclist fastest"),
     ("how far from the cyclist does ego stop?", "bumper to bumper: 0 m at 4.1 s"),
     ("how long did the run take?", "The run ended after 5.1 s"),
     ("how many lanes are there?", "S leaves the number of lanes open; in the run: 0."),
     ("is ego on a motorway?", "No: R says kind road."),
     ("is it foggy?", "No: G leaves weather open."),
    ("was it foggy when ego braked?", "“foggy” was not understood"),  # of a moment S says nothing
     ("is there a bus?", "No: O1 a bicycle."),
     ("is the cyclist a pedestrian?", "No: O1 (cyclist) is a bicycle."),
     ("is there a bicycle?", "Yes: O1 says type bicycle."),
     ("is ego able to see the bicycle?", UNANSWERED),
     ("where is this?", "R: "),
     ("is ego's driver tired?", UNANSWERED),
     ("which song does the cyclist sing?", UNANSWERED)],
)  # fmt: skip
def test_questions_about_the_scene_and_its_run(question, words):
    assert words in answered(question, SHOWN)


VAN = ObjectFacts(name="van", component="O2", types=("van",), length=5, width=2, moves=True)
TWO_OTHERS = SHOWN.model_copy(update={
    "structure": STRUCTURE.model_copy(update={
        "objects": (*STRUCTURE.objects, Component(id="O2", spec=ObjectSpec(name="van", type="van"))),
    }),
    "facts": (SHOWN.facts[0].model_copy(update={"objects": (EGO, CYCLIST, VAN)}),),
})  # fmt: skip


@pytest.mark.parametrize(
    ("question", "words"),
    [("what was the closest distance between the cyclist and the van?", "Smallest gap between cyclist and van, bumper "
      "to bumper: 3.2 m at 2.5 s."),
     ("did the van hit the cyclist?", "No collision of these two in the run of 5.1 s. Smallest gap between cyclist"),
     ("how close did ego come to the cyclist?", "Smallest gap between ego and cyclist")],
)  # fmt: skip
def test_two_others_than_ego_are_answered_for(question, words):
    near = PairMeasures(one="cyclist", other="van", gap_m=3.2, gap_at_s=2.5)
    measures = SHOWN.measures[0].model_copy(update={"others": (near,)})
    said = answered(question, TWO_OTHERS.model_copy(update={"measures": (measures,)}))
    assert said.startswith(words)
    assert "between ego and van" not in said


@pytest.mark.parametrize(
    ("question", "words"),
    [("did ego brake?", "Yes: ego brakes at 3.6 s."),
     ("did the cyclist brake?", "No: cyclist does not brake in the run."),
     ("did the van overtake ego?", "No: van does not overtake in the run."),
     ("did anybody brake?", "Yes: ego brakes at 3.6 s."),
     ("did anybody else brake?", "No: in the run nobody is seen to brake."),
     ("did ego brake before the cyclist entered the road?", "No: ego brakes at 3.6 s; cyclist enters the road"),
     ("did ego brake after the cyclist entered the road?", "Yes: ego brakes at 3.6 s; cyclist enters the road"),
     ("did the bus stop in time?", "There is no bus in this scene."),
     ("did ego stop in time?", "No: ego does not stop"),
     ("did ego brake because of the van?", "I cannot say yes or no: whether “because of the van” is not judged."),
     ("did ego brake gracefully?",
      "I cannot say yes or no: “gracefully” was not understood. The run: ego brakes at 3.6 s"),
     ("did the van sing?", "I cannot say yes or no: “sing” was not understood. The run: ")],
)  # fmt: skip
def test_yes_and_no_only_where_every_word_was_read(question, words):
    assert answered(question, TWO_OTHERS).startswith(words)


@pytest.mark.parametrize("question", ["did the van run the red light?", "did the cyclist cross?",
                                      "did ego get back in before the van came?"])  # fmt: skip
def test_what_somebody_is_says_nothing_of_what_he_did(question):
    assert not answered(question, TWO_OTHERS).startswith("Yes")


def test_how_near_two_others_come_may_not_be_known():
    said = answered("how close did the van come to the cyclist?", TWO_OTHERS)
    assert said == "The gap between these two was not measured, only their gaps to ego."


def test_why_ego_hit_somebody_is_told_by_what_it_saw_and_did():
    assert answered("why did ego hit the cyclist?", SHOWN) == (
        "COLLISION ego-cyclist at 4.1 s, not in the text. cyclist is in ego's sight from the start. "
        "Before: cyclist enters the road at 2.9 s; ego brakes at 3.6 s."
    )
    rolls = EGO.model_copy(update={"events": ()})
    facts = SHOWN.facts[0].model_copy(update={"objects": (rolls, CYCLIST)})
    assert answered("why did ego hit the cyclist?", SHOWN.model_copy(update={"facts": (facts,)})).endswith(
        "Before: cyclist enters the road at 2.9 s. Ego does not brake before."
    )


def test_a_measure_is_explained_with_what_the_run_has_of_it():
    none = "\nThere is none in the run: nobody leaves a place that another then comes to."
    assert answered("what is PET?", SHOWN).endswith(none)
    pair = SHOWN.measures[0].pairs[0].model_copy(update={"pet_s": 0.8})
    shown = SHOWN.model_copy(update={"measures": (SHOWN.measures[0].model_copy(update={"pairs": (pair,)}),)})
    assert answered("what is PET?", shown).endswith("post-encroachment time 0.8 s.")


@pytest.mark.parametrize(
    ("question", "words"),
    [("why did the cyclist not stop?",
      "O1 (cyclist): stop. Required: stop; the run: did not occur; instead: enter road.\n"
      "In the run cyclist enters the road at 2.9 s; cyclist hits ego at 4.1 s."),
     ("why hasn't the cyclist stopped", "O1 (cyclist): stop. Required: stop"),
     ("why does O1 never stop?", "O1 (cyclist): stop. Required: stop"),
     ("why did the cyclist not sing?", UNANSWERED),
     ("why did ego not stop?", "ego does not stop: its slowest is 32 km/h"),
     ("why does ego brake?", "the text does not say")],
)  # fmt: skip
def test_why_something_is_not_so_is_answered_from_what_was_required_and_not_seen(question, words):
    stop = Requirement(id="O1.phases.0.stop", kind="phase", component="O1", text="O1 (cyclist): stop.", check="event")
    missed = Result(requirement=stop.id, holds=False, said="stop", seen="did not occur; instead: enter road")
    shown = SHOWN.model_copy(update={"requirements": (REQUIRED, stop), "results": (*SHOWN.results, missed)})
    assert words in answered(question, shown)


@pytest.mark.parametrize("question", ["which words were not used?", "Which of my words have no effect?",
                                      "which words were never really used?", "are there unused words?"])  # fmt: skip
def test_the_words_that_made_no_difference_can_be_asked_for(question):
    idle = (Unmet(text="red", reason="S would be the same without it", span=(3, 6)),
            Unmet(text="with a smile", reason="S would be the same without it"))  # fmt: skip
    shown = SHOWN.model_copy(update={"details": {"without_effect": idle}})
    assert asks_for_account(question)
    assert answered(question, shown).startswith("Nothing in S says: “red”; “with a smile”.")


def test_what_was_not_understood_counts_the_words_without_effect():
    text, cyclist = STRUCTURE.text, STRUCTURE.objects[0]
    link = Link(kind="text", label=text, span=(0, len(text)), field="type")
    read = STRUCTURE.model_copy(update={"objects": (cyclist.model_copy(update={"links": (link,)}),)})
    shown = SHOWN.model_copy(update={"structure": read})
    assert answered("what did you not understand?", shown) == "2 of 2 clauses of the text are in S as understood."
    idle = Unmet(text="crosses", reason="S would be the same without it", span=(22, 29))
    shown = shown.model_copy(update={"details": {"without_effect": (idle,)}})
    assert answered("what did you not understand?", shown) == (
        "1 of 2 clauses of the text are in S as understood.\n"
        "“A cyclist crosses.”: partly understood (“crosses”: S would be the same without it)"
    )


def test_without_a_collision_the_nearest_of_all_is_named_also_one_that_stands():
    jam = ObjectFacts(name="jam[0]", component="O1", types=("car",), length=4.5, width=2, moves=False)
    coach = jam.model_copy(update={"name": "coach", "component": "O2", "moves": True})
    run = SHOWN.facts[0].model_copy(update={"objects": (EGO, coach, jam), "contacts": ()})
    pairs = tuple(PairMeasures(other=o, gap_m=m, gap_at_s=9.0) for o, m in (("coach", 49.1), ("jam[0]", 2.6)))
    shown = SHOWN.model_copy(update={"facts": (run,), "measures": (Measures(pairs=pairs),)})
    said = answered("was there a collision?", shown)
    assert said.startswith("No collision in the run of 5.1 s. Smallest gap between ego and jam[0], bumper to bumper")
    assert "coach" not in said
    assert answered("how close did they come?", shown).startswith("Smallest gap between ego and jam[0]")


def test_a_collision_between_two_others_is_none_of_the_one_who_is_asked_about():
    coach = CYCLIST.model_copy(update={"name": "coach", "component": "O2"})
    hit = ContactFact(time=4.0, one="coach", other="cyclist", part_one="front", part_other="left")
    run = SHOWN.facts[0].model_copy(update={"objects": (EGO, CYCLIST, coach), "contacts": (hit,)})
    other = STRUCTURE.objects[0].model_copy(update={"id": "O2", "spec": ObjectSpec(name="coach", type="bus")})
    both = STRUCTURE.model_copy(update={"objects": (*STRUCTURE.objects, other)})
    shown = SHOWN.model_copy(update={"facts": (run,), "structure": both})
    assert answered("did ego hit anybody?", shown).startswith("No collision of ego in the run")
    assert answered("did ego hit the coach?", shown).startswith("No collision of these two in the run")
    assert "4.0 s" in answered("did the coach hit anybody?", shown)
    assert "4.0 s" in answered("was there a collision?", shown)


@pytest.mark.parametrize("question", ["was the cyclist hidden?", "could ego see the cyclist?", "who is occluded?"])
def test_who_is_hidden_is_answered_from_the_run(question):
    behind = CYCLIST.model_copy(update={"hidden_behind": ("parked_van",)})
    run = SHOWN.facts[0].model_copy(update={"objects": (EGO, behind)})
    said = answered(question, SHOWN.model_copy(update={"facts": (run,)}))
    assert said == "cyclist is hidden from ego at the start, behind parked_van."


@pytest.mark.parametrize(
    "question", ["What does UN R157 say about collisions?", "What is a cut-in?", "How do I brake in Scenic?",
                 "show me a snippet where a car brakes", "why is the cyclist here?"],
)  # fmt: skip
def test_other_questions_are_left_to_the_documents_and_to_why(question):
    assert answered(question, SHOWN) == ""


def test_before_a_run_nothing_is_known_of_it():
    fresh = SHOWN.model_copy(update={"facts": (), "measures": (), "results": ()})
    for question in ("was there a collision?", "does ego brake?", "did ego stop?", "how fast is the cyclist?",
                     "did the cyclist cross the road?", "who braked first?", "when did ego brake?"):  # fmt: skip
        assert "has not been run" in answered(question, fresh)
    assert "the text does not say" in answered("why does ego brake?", fresh)
    assert answered("was there a collision?", None) == ""


@pytest.mark.parametrize(("text", "wants"), [("help", True), ("Hello!", True), ("thanks", True), ("hi there", True),
                                             ("what can I do here?", True), ("help the cyclist cross", False),
                                             ("the car says hello", False)])  # fmt: skip
def test_help_and_greetings(text, wants):
    assert wants_help(text) is wants
    assert "c2s --help" in HELP


def test_the_clauses_that_are_not_wholly_in_s_are_counted():
    assert requirements_met(Structure(), ()) == ""
    told = "0 of 1 requirements met; 2 clauses of the text are not fully in S"
    assert requirements_met(STRUCTURE, SHOWN.results) == told


def test_a_clause_without_effect_is_not_wholly_in_s_and_a_word_may_be():
    links = (Link(kind="text", label="crosses", span=(22, 29), field="name"),)
    ego = STRUCTURE.ego.model_copy(update={"links": (Link(kind="text", label="Ego", span=(0, 3), field="reaction"),)})
    crossing = STRUCTURE.objects[0].model_copy(update={"links": links})
    one = STRUCTURE.with_component(ego).with_component(crossing)
    clause, word = (Unmet(text=one.text[a:b], reason="S would be the same without it", span=(a, b))
                    for a, b in ((12, 29), (14, 21)))  # fmt: skip
    assert [count_lost_clauses(one, idle) for idle in ((), (word,), (clause,))] == [0, 0, 1]

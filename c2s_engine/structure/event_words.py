"""Events of a run in plain words, as fronts show them and answers tell them."""

from c2s_engine.structure.facts import EventFact, RunFacts

WORDS = {
    "stationary": "stands all the time", "keep_lane": "keeps its lane", "stop": "stops", "brake": "brakes",
    "brake_hard": "brakes hard", "accelerate": "accelerates", "slow": "is slow", "follow": "follows",
    "approach": "comes nearer to", "lane_change": "changes lane", "lane_change_left": "changes lane to the left",
    "lane_change_right": "changes lane to the right", "cut_in": "cuts in ahead of", "cut_out": "cuts out ahead of",
    "overtake": "overtakes", "swerve": "swerves", "skid": "skids", "drift": "drifts", "turn_left": "turns left",
    "turn_right": "turns right", "u_turn": "turns round", "go_straight": "goes straight on",
    "cross_path": "crosses the path of", "cross_road": "crosses the road ahead of",
    "walk_along": "walks along the road",
    "ride_along": "rides along the road", "enter_road": "enters the road", "leave_road": "leaves the road",
    "oncoming_intrusion": "drives in the oncoming lane", "reverse": "reverses", "run_red": "runs a red light",
    "run_stop": "runs a stop sign", "yield": "yields to", "hits": "hits", "passes_first": "passes before",
}  # fmt: skip
"""By event (the names of data/events.yaml); where another is named, its name follows."""
USUAL = ("keep_lane", "approach", "follow", "stationary", "passes_first", "slow")
"""Events that say nothing of note by themselves."""


ACTS = {
    "stationary": "stands", "keep_lane": "keeps its lane", "accelerate": "accelerates", "brake": "brakes",
    "stop": "stops", "wait": "waits", "start": "sets off", "lane_change": "changes lane", "cut_in": "cuts in",
    "cut_out": "cuts out",
    "overtake": "overtakes", "follow": "follows", "swerve": "swerves", "drift": "drifts out of its lane",
    "turn_left": "turns left", "turn_right": "turns right", "go_straight": "goes straight on", "u_turn": "turns round",
    "cross_road": "crosses the road", "move_along": "moves along the road", "enter_road": "enters the road",
    "leave_road": "leaves the road", "reverse": "reverses", "oncoming": "drives in the oncoming lane",
    "run_red": "runs a red light", "run_stop": "runs a stop sign", "yield": "yields", "lose_control": "loses control",
    "collide": "collides",
}  # fmt: skip
"""The actions of S in plain words."""
ENDED = {"time": "time limit reached", "terminated": "the program's end condition was met",
         "collision": "a collision", "rejected": "no scene could be sampled",
         "error": "an error in the program", "cancelled": "cancelled"}  # fmt: skip


def ended(facts: RunFacts) -> str:
    """Why a run ended, in plain words."""
    why = f": {facts.reason}" if facts.reason and facts.ended_by in ("rejected", "error") else ""
    return f"{ENDED[facts.ended_by]}{why}"


def event_phrase(event: EventFact) -> str:
    """`cuts in ahead of ego`."""
    words = WORDS.get(event.event, event.event.replace("_", " "))
    return f"{words} {event.other}" if event.other else words

"""One event becomes phases in the vocabulary of the specs, with its rate, speed, duration and trigger."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.scene import side
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.towards import OPPOSITE
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import Phase, Placement, PlaceSpec, Trigger
from c2s_engine.structure.vocabulary import TOWARDS_EGO

ONWARDS = r"^(?:continue|resume|proceed|(?:go|goes|drive|carry|move|ride|travel) on)|^\w+ (?:on|again|further|off)\b"
SOFT = (
    r"\b(?:lightly|gently|softly|slightly|mildly|smoothly|moderately)\b"
    r"(?! (?:ahead|behind|in front|to the|left|right|off|offset|beyond|before|past|above|below|up|down"
    r"|wet|damp|curved|bent))"
)
HARD = r"\b(hard|sharply|heavily|abruptly|suddenly|emergency|slam|full brak\w+|sudden|violently|fully|strongly)\b"


def trigger_of(event: Event) -> Trigger | None:
    """The trigger that a clause states."""
    if event.trigger is None:
        return None
    told = event.trigger
    if told["kind"] == "headway":
        return None  # until it is known how fast they are
    return Trigger(kind=told["kind"], value=round(told["value"], 2), place=told.get("place"), of=told.get("id"))


def rate_of(event: Event) -> float | None:
    """The stated or implied rate of a speed change, m/s2."""
    for quantity in event.quantities:
        if quantity["dimension"] == "acceleration":
            return round(max(0.5, abs(quantity["low"]), abs(quantity["high"])), 2)
    if event.act in ("brake", "brake_stop", "stop") and (event.hard or re.search(HARD, event.whole)):
        return float(language.table("defaults")["rates"]["hard"]["value"])
    return None


def target_speed(event: Event) -> float | None:
    """The speed that is reached."""
    for quantity in event.quantities:
        if quantity["dimension"] == "speed" and quantity.get("role") == "target":
            return round(quantity["low"], 2)
    return None


def duration_of(event: Event) -> float | tuple[float, float] | None:
    """How long it lasts, where the clause says so ("for 3 s")."""
    for quantity in event.quantities:
        if quantity["dimension"] == "time" and re.search(
            r"\b(for|waits?|waiting) (about |around |roughly |some |at least |another )?#time|#time long", event.whole
        ):
            return round(quantity["low"], 2)
    return None


def steps_of(
    event: Event,
    entity: Entity,
    who: str | None,
    ego: str,
    placement: Placement,
    place: PlaceSpec,
    crossing: bool,
    before: list[Phase]) -> list[Phase]:
    act, trigger = event.act, trigger_of(event)
    towards = side(event)
    by_braking = bool(before) and before[-1].action in ("brake", "stop") and event.whole.startswith("to ")
    avoids = act == "evade" and event.patient is not None and not by_braking  # "stopped to avoid a dog": by that
    if avoids and not entity.person and not event.patient.ego and not crossing:  # type: ignore[union-attr]
        return [Phase(action="swerve", side=towards, trigger=trigger)]
    if act in ("travel", "lead", "held_up", "approach", "keep_lane", "evade", "swing"):
        if act == "keep_lane" and not before:
            return [Phase(action="keep_lane")]
        again = before and before[-1].action in ("stop", "wait") and re.search(ONWARDS, event.text)
        return [Phase(action="start")] if again and act == "travel" and not entity.person else []
    if act == "stationary" and event.text.startswith("park") and before:
        return []
    if act == "stationary":
        duration = duration_of(event)
        if before and before[-1].action in ("brake", "stop", "cross_road", "enter_road", "cut_in"):
            return [Phase(action="wait", duration=duration)]
        return [Phase(action="stationary")] if not duration else [Phase(action="wait", duration=duration)]
    if act in ("brake", "brake_stop", "stop"):
        rate = rate_of(event)
        action = "brake" if act == "brake" else "stop"
        halt = Phase(
            action=action, rate=rate, speed=target_speed(event) if action == "brake" else None, trigger=trigger
        )
        stands = duration_of(event) if action == "stop" else None
        return [halt, Phase(action="wait", duration=stands)] if stands else [halt]
    if act in ("accelerate", "start"):
        if trigger is not None and trigger.kind == "time" and before and before[-1].action == "stop":
            return [Phase(action="wait", duration=trigger.value), Phase(action="start", speed=target_speed(event))]
        return [
            Phase(
                action="accelerate"
                if act == "accelerate" and not (before and before[-1].action in ("stop", "wait", "stationary"))
                else "start",
                rate=rate_of(event),
                speed=target_speed(event),
                trigger=trigger,
            )
        ]
    if act == "turn" and towards is None and any(p.action.startswith("turn") for p in before):
        return []  # the turn that was told of
    if act == "turn":
        towards = towards or "left"
        return [Phase(action=f"turn_{towards}", trigger=trigger)]
    if act == "go_straight":
        if any(p.action in ("turn_left", "turn_right", "go_straight") for p in before):
            return []
        return (
            [Phase(action="go_straight", trigger=trigger)] if place.kind == "intersection" and not entity.person else []
        )
    if act == "cross_path":
        return [Phase(action="go_straight", trigger=trigger)] if crossing else []
    if act == "u_turn":
        return [Phase(action="u_turn", trigger=trigger)]
    if act == "cut_in":
        if placement.position in {"parked", "roadside"}:
            return [Phase(action="enter_road", target=ego, trigger=trigger)]
        if placement.position in ("oncoming_lane",):
            return [Phase(action="oncoming", side="left", trigger=trigger)]
        if placement.position == "partly_in_lane" and entity.type == "bicycle":
            return [Phase(action="swerve", side=OPPOSITE[placement.side or "right"], trigger=trigger)]
        flank = OPPOSITE.get(placement.side or "") if placement.position == "beside" else None
        goal = TOWARDS_EGO.get(placement.position, flank)
        if crossing:
            return []
        back = towards if placement.position == "behind" else None  # it has come past first
        found = [
            Phase(action="cut_in", side=goal or back, target=who if who and who != "ego" else ego, trigger=trigger)
        ]
        if (
            goal
            and re.search(rf"through the (middle|centre|center)|(on |over )?into the {goal} (one|lane)", event.whole)
            and place.ego_lane == "middle"
        ):
            found.append(Phase(action="cut_out", side=goal, target=ego))
        return found
    if act == "lane_change" and (entity.person or crossing):
        return []
    if act == "lane_change" and placement.position == "on_ramp":
        return [Phase(action="cut_in", target=ego, trigger=trigger)]
    if act == "lane_change" and placement.position in ("parked", "roadside"):
        return (
            [Phase(action="enter_road", target=ego, trigger=trigger)]
            if not before or before[-1].action != "enter_road"
            else []
        )
    if act in ("lane_change", "cut_out"):
        if any(p.action == "swerve" for p in before):
            return []
        if placement.position == "oncoming_lane" and event.patient is not None and event.patient.ego:
            return [Phase(action="oncoming", side="left", trigger=trigger)]
        if act == "lane_change" and placement.position in ("left_lane", "right_lane"):
            toward_ego = TOWARDS_EGO[placement.position]
            if towards in (None, toward_ego) and not any(p.action == "cut_in" for p in before):
                return [
                    Phase(
                        action="cut_in"
                        if placement.along != "behind"
                        or any(p.action == "overtake" and p.target == ego for p in before)
                        else "lane_change",
                        side=toward_ego,
                        target=ego,
                        trigger=trigger,
                    )
                ]
        gone = next((p for p in before if p.action == "cut_out"), None)
        returns = gone is not None and towards and gone.side and towards != gone.side
        if placement.position == "ahead" and placement.of == "ego" and returns:
            return [Phase(action="cut_in", side=towards, target=ego, trigger=trigger)]
        if placement.position == "ahead" and placement.of == "ego":
            return [Phase(action="cut_out", side=towards, target=ego, trigger=trigger)]
        return [Phase(action="lane_change", side=towards or "left", trigger=trigger)]
    if act == "overtake":
        if (who or ego) == "ego" and (placement.position in ("oncoming_lane", "opposite_approach") or crossing):
            return []
        if entity.person or any(p.action in ("cut_out", "swerve") for p in before):
            return []
        if any(p.action == "overtake" and p.target == (who or ego) for p in before) and event.adverbial:
            return []  # "... and, before it has fully passed, cuts in"
        return [Phase(action="overtake", target=who or ego, side=towards, trigger=trigger)]
    if act == "follow":
        return [Phase(action="follow", target=who or ego)] if who != "ego" or placement.position == "behind" else []
    if act == "swerve":
        return [Phase(action="swerve", side=towards, trigger=trigger)]
    if act == "drift":
        if placement.position == "oncoming_lane":
            return [Phase(action="drift", side="left", trigger=trigger)]
        goal = TOWARDS_EGO.get(placement.position)
        return [Phase(action="drift", side=goal or towards, trigger=trigger)]
    if act == "oncoming":
        if placement.facing == "against":
            return []
        return [Phase(action="oncoming", side="left", trigger=trigger)]
    if act in ("cross_road", "move_along"):
        if (
            act == "move_along"
            and entity.type == "bicycle"
            and place.kind == "intersection"
            and any(p.action == "move_along" for p in before)
            and "straight" in event.whole
            and not any(p.action == "go_straight" for p in before)
        ):
            return [Phase(action="go_straight", trigger=trigger)]
        if (
            act == "move_along"
            and any(p.action in ("cross_road", "move_along") for p in before)
            or act == "cross_road"
            and any(p.action == "cross_road" for p in before)
        ):
            return []
        if (
            act == "move_along"
            and entity.type == "bicycle"
            and (placement.position == "opposite_approach" or place.kind == "roundabout" and crossing)
            or act == "cross_road"
            and crossing
        ):
            return [Phase(action="go_straight")] if not any(p.action == "go_straight" for p in before) else []
        if act == "move_along" and placement.facing == "against" and not entity.person:
            return []
        found = [Phase(action=act, trigger=trigger)]
        if (
            act == "move_along"
            and entity.type == "bicycle"
            and place.kind == "intersection"
            and re.search(
                r"straight|(over|through|across) (the|an) (\w+ )?(junction|intersection|crossroads)", event.whole
            )
        ):
            found.append(Phase(action="go_straight"))
        return found
    if act == "enter_road":
        if not entity.person and any(p.action == "enter_road" for p in before):
            return []
        return [
            Phase(
                action="cross_road" if entity.person else "enter_road",
                rate=None if entity.person else rate_of(event),
                target=None if entity.person else ego,
                trigger=trigger,
            )
        ]
    if act == "exit_road":
        return [Phase(action="leave_road", side=towards or "right", trigger=trigger)]
    if act == "leave_road":
        return [Phase(action="leave_road", side=towards, trigger=trigger)]
    if act == "reverse":
        return [Phase(action="reverse", trigger=trigger)]
    if act == "run_red":
        return [Phase(action="run_red", trigger=trigger)] if not any(p.action == "run_red" for p in before) else []
    if act == "run_stop":
        return [Phase(action="run_stop", trigger=trigger)]
    if act == "yield":
        return [Phase(action="yield", target=who or ego)]
    if act == "lose_control":
        return (
            [Phase(action="lose_control", side=towards)] if not any(p.action == "lose_control" for p in before) else []
        )
    if act == "collide":
        other = who
        return [Phase(action="collide", target=other or ego)]
    return []

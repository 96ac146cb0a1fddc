"""E: what ego does of its own accord, and how it reacts."""

import re

from c2s_engine.interpret.composing.changed_speeds import changed
from c2s_engine.interpret.composing.ego_pace import ego_pace
from c2s_engine.interpret.composing.lasting import lasting
from c2s_engine.interpret.composing.own_braking import SHORT_OF, stated_braking, stated_stop
from c2s_engine.interpret.composing.passive import RESPONSES, remains_passive
from c2s_engine.interpret.composing.seen import MARKS
from c2s_engine.interpret.composing.steps import ONWARDS, duration_of, rate_of, target_speed, trigger_of
from c2s_engine.interpret.composing.tidied import tidy
from c2s_engine.interpret.roles.ego_others import free_side, in_lane_conflict, last_actor, passed, way_back
from c2s_engine.interpret.scene import Scene, side
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.fill_omissions import struck_standing
from c2s_engine.interpret.who.mentions import MOTOR, Entity
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.specs import EgoSpec, Phase, PlaceSpec, Trigger

RETURNS = frozenset(("overtake", "oncoming", "swerve"))
RETURNING = re.compile(r"return|back|own lane|its lane")
GOES_BY = frozenset(("overtake", "travel", "cross_road", "cross_path", "go_straight", "leave_road", "turn"))
"""What another does who is gone then."""
AROUND = frozenset(("overtake", "oncoming", "lane_change", "cut_out", "evade", "swerve", "u_turn"))
"""What ego does to get past what it stopped for."""
WIDE = re.compile(r"\b(?:berth|clearance|room|space)\b")
"""What is left beside one whom ego goes around, though it slows first."""


def compose_ego(scene: Scene, ids: dict[Entity, str], place: PlaceSpec) -> tuple[EgoSpec, list[Assumption]]:
    """Ego's spec and what was assumed in it."""
    ego = scene.cast.ego
    assumed: list[Assumption] = []
    events = scene.events(ego)
    others = [e for e in scene.actors if e in ids]
    phases: list[Phase] = []
    reaction, react_to, hard = "none", None, False
    said_reaction = False
    response: Phase | None = None  # that is no phase: after it ego may go on
    for event in events:
        if (first := _gone_by(scene, event, ids)) and (response or phases and phases[-1].action in ("stop", "wait")):
            phases += [response] if response else []
            if phases[-1].action == "wait":
                phases.pop()
            phases.append(Phase(action="wait", until=Trigger(kind="passed", subject=first, of="ego")))
            response = None
        who = ids.get(event.patient) if event.patient is not None and not event.patient.ego else None
        act = event.act
        towards = side(event)
        trigger = trigger_of(event)
        if act == "yield":
            reaction, said_reaction = "yield", True
            stands = event.patient is not None and bool(event.patient.roles & {"parked"})  # "gives way behind" those
            react_to = react_to or (None if stands else who)
        elif onward := _goes_on(event, response or (phases[-1] if phases else None), who or _before(scene, event, ids)):
            phases += [*([response] if response else []), onward]
            response = None
        elif act in RESPONSES:
            stop = act != "brake"
            if not others or "turn" in event.text and not event.hard and not others:
                phases += _halt(event)
                continue
            said_reaction = True
            if reaction in ("none", "follow"):
                reaction = "brake" if reaction == "none" or event.hard else reaction
            hard = hard or event.hard or bool(rate_of(event) and rate_of(event) >= 4)  # type: ignore[operator]
            who = who or (_before(scene, event, ids) if stop and SHORT_OF.search(event.text) else None)
            if stop and reaction == "brake" and not any(e.act in AROUND for e in events[events.index(event) :]):
                phases.append(stated_stop(event, who))
            elif not stop and (braking := stated_braking(event, who)) is not None:
                phases.append(braking)
            else:
                response = stated_stop(event, who) if stop else Phase(action="brake", target=who)
        elif act == "follow":
            phases += lasting(event, [Phase(action="follow", target=who)])
            if phases[-1].target is None:
                phases.pop()
        elif act in ("lane_change", "cut_out", "evade"):
            wide = reaction == "brake" and not phases and WIDE.search(event.text)
            if act == "evade" and (reaction == "none" or wide) and who:
                reaction, said_reaction = "evade", True
            elif (
                act == "lane_change"
                and any(p.action == "swerve" for p in phases)
                and RETURNING.search(event.whole)
            ):
                continue
            elif act != "evade":
                joined = scene.where(event.patient).lane if event.patient is not None and not towards else None
                towards = towards or (joined if joined in ("left", "right") else None)
                away = way_back(phases) if RETURNING.search(event.whole) else None
                phases.append(Phase(action="lane_change", side=towards or away or free_side(place), trigger=trigger))
        elif (
            act == "overtake"
            and event.patient is not None
            and scene.where(event.patient).lane in ("parked", "roadside", "sidewalk")
        ):
            continue
        elif act == "overtake":
            if event.patient is not None and (
                scene.where(event.patient).lane == "oncoming" or "oncoming" in event.patient.roles
            ):
                who = passed(scene, ids) or who
            if towards == "right" and place.ego_lane == "leftmost":
                towards = None  # the side where the passed one is
            phases.append(Phase(action="overtake", target=who or passed(scene, ids), side=towards, trigger=trigger))
            if phases[-1].target is None:
                phases.pop()
        elif act == "cut_in" and any(p.action.startswith("turn_") for p in phases):
            continue  # its turn is what cuts the other off
        elif act == "cut_in":
            phases.append(Phase(action="cut_in" if who else "lane_change", target=who, side=towards, trigger=trigger))
        elif act == "turn":
            if towards is None and any(p.action.startswith("turn_") for p in phases):
                continue
            towards = (
                towards
                or next((s for e in events if e.act == "turn" and (s := side(e))), None)
                or (place.manoeuvre if place.manoeuvre in ("left", "right") else "left")
            )
            phases.append(Phase(action=f"turn_{towards}", trigger=trigger))
        elif act in ("u_turn", "run_red", "run_stop", "lose_control", "accelerate", "start"):
            step = Phase(
                action=act,  # type: ignore[arg-type]
                side=towards if act == "lose_control" else None,
                speed=target_speed(event) if act in ("accelerate", "start") else None,
                rate=rate_of(event) if act == "accelerate" else None,
                trigger=trigger,
            )
            phases += lasting(event, [step])
        elif act == "go_straight" and place.kind == "intersection":
            phases.append(Phase(action="go_straight", trigger=trigger))
        elif act == "cross_path" and place.kind == "intersection":
            phases.append(Phase(action="go_straight"))
        elif act == "reverse" and re.match(r"\w+ back\b", event.text) and any(p.action in RETURNS for p in phases):
            continue  # into its lane
        elif act == "drift" and towards is None and phases and phases[-1].action == "lane_change":
            continue  # it goes on towards the side to which it changes lanes
        elif act in ("leave_road", "drift", "swerve", "reverse", "oncoming", "enter_road"):
            sided = act in ("leave_road", "drift", "swerve", "oncoming")
            phases.append(
                Phase(
                    action=act,
                    side=(towards or ("right" if act in ("leave_road", "drift") else None)) if sided else None,
                    trigger=trigger,
                )
            )  # type: ignore[arg-type]
        elif act == "collide":
            target = who or last_actor(scene, ids)
            for actor in (event.agent, *event.also):
                target = target if actor.ego else ids.get(actor, target)
            if target:
                phases.append(Phase(action="collide", target=target))
                said_reaction = True
        elif act == "stationary" and reaction in ("brake", "evade") and not phases:
            continue  # it waits where it has stopped
        elif act == "stationary":
            phases.append(Phase(action="wait" if phases else "stationary", duration=duration_of(event)))
        elif act == "keep_lane" and not phases:
            phases.append(Phase(action="keep_lane"))
    if any(p.action == "follow" for p in phases):
        phases = [p for p in phases if p.action not in ("start", "accelerate")]
    turned = any(p.action.startswith("turn_") for p in phases) or struck_standing(scene.clauses)
    if place.manoeuvre in ("left", "right") and not turned:
        phases.append(Phase(action=f"turn_{place.manoeuvre}"))  # type: ignore[arg-type]
    if place.kind == "on_ramp":
        phases = [p.model_copy(update={"side": "left"}) if p.action == "lane_change" else p for p in phases]
    struck = next(
        (e for e in scene.clauses.events if e.act == "collide" and e.done and not e.agent.ego and e.patient is ego),
        None,
    )
    if reaction == "yield":
        phases = [p for p in phases if p.action != "wait"]
    phases = tidy(phases, place)
    speed = ego_pace(scene, ids, place, phases, assumed)
    phases = changed(events, phases, speed)
    if (
        reaction == "none"
        and not said_reaction
        and struck is None
        and not any(
            p.action
            in (
                "collide",
                "oncoming",
                "leave_road",
                "lose_control",
                "reverse",
                "turn_left",
                "turn_right",
                "run_red",
                "run_stop",
                "overtake",
                "lane_change",
                "u_turn",
            )
            for p in phases
        )
        and in_lane_conflict(scene, place)
        and not remains_passive(scene)
    ):
        reaction = "brake"
        assumed.append(
            Assumption(
                field="reaction",
                value="brake",
                reason="the text does not say how ego reacts: it brakes for anything entering its path",
            )
        )
    kind = ego.type if ego.type in MOTOR and ego.type != "vehicle" else "car"
    model = None
    if scene.settings.ego_model is not None and scene.settings.ego_model.confidence >= 0.6:
        model = scene.settings.ego_model.value
    spec = EgoSpec(
        type=kind, model=model, speed=speed, phases=tuple(phases[:8]), reaction=reaction, react_to=react_to, hard=hard
    )  # type: ignore[arg-type]
    return spec, assumed


def _gone_by(scene: Scene, event: Event, ids: dict[Entity, str]) -> str | None:
    """Who has gone by ego, in the clause joined to it, when ego does what an event says."""
    gone = [e for e in scene.clauses.events if e.agent in ids and e.act in GOES_BY and e.mode == "fact"]
    joined = (e for e in gone if e.adverbial in MARKS and scene.clauses.joined_to(e) is event)
    return next((ids[e.agent] for e in joined if not e.agent.ego), None)


def _before(scene: Scene, event: Event, ids: dict[Entity, str]) -> str | None:
    """Whom ego answered: who last did something that concerns it before an event."""
    others = [e for e in scene.clauses.events if e.agent in ids and not e.agent.ego and e.order < event.order]
    concerned = [e for e in others if e.patient is event.agent or e.act not in ("travel", "stationary", "approach")]
    return ids[max(concerned, key=lambda e: e.order).agent] if concerned else last_actor(scene, ids)


def _goes_on(event: Event, last: Phase | None, whom: str | None) -> Phase | None:
    """The step by which ego goes on after it has braked or stopped: on at its speed, or behind somebody; None where it
    has not, or does something else."""
    if last is None or last.action not in ("stop", "brake", "wait"):
        return None
    if event.act == "follow" and whom is not None:
        return Phase(action="follow", target=whom)
    if event.act in ("start", "accelerate") or event.act == "travel" and re.search(ONWARDS, event.text):
        stands = last.action != "brake" or event.act == "start"
        return Phase(action="start" if stands else "accelerate", speed=target_speed(event), trigger=trigger_of(event))
    return None


def _halt(event: Event) -> list[Phase]:
    """A stop or a braking that nobody causes, and how long ego stands then."""
    action = "brake" if event.act == "brake" else "stop"
    halt = Phase(action=action, rate=rate_of(event), speed=target_speed(event), trigger=trigger_of(event))  # type: ignore[arg-type]
    stands = duration_of(event) if action == "stop" else None
    return [halt, Phase(action="wait", duration=stands)] if stands else lasting(event, [halt])

"""E: what ego does of its own accord, and how it reacts."""

import re

from c2s_engine.interpret.composing.changed_speeds import changed
from c2s_engine.interpret.composing.ego_pace import ego_pace
from c2s_engine.interpret.composing.lasting import lasting
from c2s_engine.interpret.composing.own_braking import told_braking, told_stop
from c2s_engine.interpret.composing.passive import RESPONSES, remains_passive
from c2s_engine.interpret.composing.steps import duration_of, rate_of, target_speed, trigger_of
from c2s_engine.interpret.composing.tidied import tidy
from c2s_engine.interpret.entities import URGENT
from c2s_engine.interpret.roles.ego_others import (
    ahead,
    faces_red,
    for_sign,
    free_side,
    in_lane_conflict,
    last_actor,
    passed,
    yielded,
)
from c2s_engine.interpret.scene import Scene, side
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.left_untold import struck_standing
from c2s_engine.interpret.who.mentions import MOTOR, Entity
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.specs import EgoSpec, Phase, PlaceSpec

RETURNS = frozenset(("overtake", "oncoming", "swerve"))
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
    said_reaction, waits_at = False, 0
    for event in events:
        who = ids.get(event.patient) if event.patient is not None and not event.patient.ego else None
        act = event.act
        towards = side(event)
        trigger = trigger_of(event)
        if act == "yield":
            reaction, said_reaction, waits_at = "yield", True, len(phases)
            stands = event.patient is not None and bool(event.patient.roles & {"parked"})  # "gives way behind" those
            react_to = react_to or (None if stands else who) or yielded(scene, event, ids)
        elif act in RESPONSES:
            stop = act != "brake"
            if (
                stop
                and for_sign(scene, event, place)
                or not others
                or "turn" in event.text
                and not event.hard
                and not others
            ):
                phases += _halt(event)
                continue
            said_reaction = True
            if stop and phases and phases[-1].action in ASIDE and _from_behind(scene):
                phases.append(Phase(action="stop", trigger=trigger))
                continue
            if reaction in ("none", "follow"):
                reaction = "brake" if reaction == "none" or event.hard else reaction
            hard = hard or event.hard or bool(rate_of(event) and rate_of(event) >= 4)  # type: ignore[operator]
            if stop and reaction == "brake" and not any(e.act in AROUND for e in events[events.index(event) :]):
                phases.append(told_stop(event, who))
            elif not stop and (braking := told_braking(event, who)) is not None:
                phases.append(braking)
        elif act == "follow":
            phases += lasting(event, [Phase(action="follow", target=who or ahead(scene, ids))])
            if phases[-1].target is None:
                phases.pop()
        elif act in ("lane_change", "cut_out", "evade"):
            wide = reaction == "brake" and not phases and WIDE.search(event.text)
            if act == "evade" and (reaction == "none" or wide) and who:
                reaction, said_reaction = "evade", True
            elif (
                act == "lane_change"
                and any(p.action == "swerve" for p in phases)
                and re.search(r"return|back|own lane|its lane", event.whole)
            ):
                continue
            elif act != "evade":
                joined = scene.where(event.patient).lane if event.patient is not None and not towards else None
                towards = towards or (joined if joined in ("left", "right") else None)
                phases.append(Phase(action="lane_change", side=towards or free_side(place), trigger=trigger))
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
        elif act == "start" and not phases and _under_way(scene) and event is not events[-1]:
            continue  # "starts to swap lanes"
        elif act in ("u_turn", "run_red", "run_stop", "lose_control", "accelerate", "start"):
            step = Phase(
                action=act,  # type: ignore[arg-type]
                side=towards if act == "lose_control" else None,
                speed=target_speed(event) if act in ("accelerate", "start") else None,
                rate=rate_of(event) if act == "accelerate" else None,
                trigger=trigger,
            )
            phases += lasting(event, [step])
        elif act == "travel" and (onwards := _goes_on(phases, event, place)) is not None:
            phases.append(Phase(action=onwards, trigger=trigger))  # type: ignore[arg-type]
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
            if act == "drift" and towards is None and _meets_over_the_line(scene, place):
                act, towards = "oncoming", "left"
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
    shift = next((n for n, p in enumerate(phases[waits_at:], waits_at) if p.action == "lane_change"), None)
    if reaction == "yield" and shift is not None and _lets_by(scene, react_to, ids):
        phases = [p for p in phases[:shift] if p.action not in ("stop", "wait")] + phases[shift:]
        phases.insert(min(shift, len(phases) - 1), Phase(action="yield", target=react_to))
        reaction, react_to = "none", None
    elif reaction == "yield" and _makes_way(scene, react_to, phases, ids):
        slows = {e.act for e in events}
        halts = "stop" if slows & {"stop", "brake_stop", "stationary"} else "brake" if "brake" in slows else None
        phases.append(Phase(action=halts) if halts else Phase(action="yield", target=react_to))  # type: ignore[arg-type]
        reaction, react_to = "none", None
    if reaction == "yield":
        phases = [p for p in phases if p.action != "wait"]
    phases = tidy(phases, place)
    if (
        scene.road.signal
        and not any(p.action in ("run_red", "stop", "wait", "stationary") for p in phases)
        and faces_red(scene)
        and any(p.action in ("turn_right", "turn_left", "go_straight") for p in phases)
        and not any(e.act in (*RESPONSES, "stationary", "yield") for e in events)
    ):
        phases.insert(0, Phase(action="run_red"))
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
                reason="the text does not say how ego reacts: it brakes for what comes into its way",
            )
        )
    kind = ego.type if ego.type in MOTOR and ego.type != "vehicle" else "car"
    model = None
    if scene.settings.ego_model is not None and scene.settings.ego_model.confidence >= 0.6:
        model = scene.settings.ego_model.value
    phases = [p.model_copy(update={"target": None}) if _for_one_behind(scene, p, ids) else p for p in phases]
    spec = EgoSpec(
        type=kind, model=model, speed=speed, phases=tuple(phases[:8]), reaction=reaction, react_to=react_to, hard=hard
    )  # type: ignore[arg-type]
    return spec, assumed


def _for_one_behind(scene: Scene, phase: Phase, ids: dict[Entity, str]) -> bool:
    """Whether ego brakes "with a truck behind it": not for that one."""
    rest = ("travel", "follow", "approach")
    behind = {
        ids.get(a)
        for a in scene.actors
        if scene.where(a).rel == "behind" and all(e.act in rest for e in scene.events(a))
    }
    return phase.action in ("brake", "stop") and phase.target is not None and phase.target in behind


ONWARDS = re.compile(
    r"(?:move|roll|creep|edge|inch|ease|drive|go|pull|nose) (?:\w+ly )?(?:forwards?|ahead|off|on|away|into|through)\b"
    r"|(?:proceed|continue|resume|(?:go|carry|drive|move|ride|travel) on)\b"
)
"""What one does who has stood and goes on."""
ASIDE = ("lane_change", "leave_road", "drift")


def _halt(event: Event) -> list[Phase]:
    """A stop or a braking that nobody causes, and how long ego stands then."""
    action = "brake" if event.act == "brake" else "stop"
    halt = Phase(action=action, rate=rate_of(event), speed=target_speed(event), trigger=trigger_of(event))  # type: ignore[arg-type]
    stands = duration_of(event) if action == "stop" else None
    return [halt, Phase(action="wait", duration=stands)] if stands else lasting(event, [halt])


def _goes_on(phases: list[Phase], event: Event, place: PlaceSpec) -> str | None:
    """How ego goes on that has stopped: into a junction, or along its road."""
    last = phases[-1] if phases else None
    if last is None or last.action not in ("stop", "wait", "stationary") or last.target is not None:
        return None
    onwards = ONWARDS.match(event.text) is not None
    if place.kind == "intersection" and (onwards and last.action != "stationary"):
        return "go_straight"
    return "start" if onwards else None


def _meets_over_the_line(scene: Scene, place: PlaceSpec) -> bool:
    """Whether all others come the other way, on a road with no lane beside: it is their lane that ego drifts into."""
    movers = [a for a in scene.actors if a.mover]
    comes = all(scene.where(a).lane == "oncoming" or "oncoming" in a.roles for a in movers)
    return bool(movers) and comes and (place.lanes or 1) < 2 and place.kind != "motorway"


def _under_way(scene: Scene) -> bool:
    """Whether it is told how fast ego is, and not that it stands at first."""
    said = scene.speeds.get(scene.cast.ego)
    return said is not None and said[0] > 0 and scene.does(scene.cast.ego, "stationary", "stop", "brake_stop") is None


def _from_behind(scene: Scene) -> bool:
    """Whether somebody comes from behind for whom ego makes room."""
    return any(scene.where(a).rel == "behind" and (a.type in URGENT) for a in scene.actors)


def _makes_way(scene: Scene, react_to: str | None, phases: list[Phase], ids: dict[Entity, str]) -> bool:
    """Whether ego lets one from behind pass after it moved aside."""
    aside = phases and phases[-1].action in ASIDE
    stops = any(e.act in ("stop", "brake_stop") for e in scene.events(scene.cast.ego))
    urgent = any(a.type in URGENT and ids.get(a) == react_to for a in scene.actors)
    stays = not any(p.action in ASIDE for p in phases)
    return bool(aside or stops and urgent and stays) and _lets_by(scene, react_to, ids)


def _lets_by(scene: Scene, react_to: str | None, ids: dict[Entity, str]) -> bool:
    """Whether whom ego lets pass comes from behind."""
    return any(scene.where(a).rel == "behind" and ids.get(a) == react_to for a in scene.actors if a.mover)

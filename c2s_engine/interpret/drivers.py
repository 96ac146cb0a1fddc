"""E: how ego drives of its own accord, and how it reacts to the others."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.clauses import Event
from c2s_engine.interpret.mentions import MOTOR, Entity
from c2s_engine.interpret.phases import duration_of, rate_of, target_speed, trigger_of
from c2s_engine.interpret.scene import Scene, side
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.specs import EgoSpec, Phase, PlaceSpec

RESPONSES = ("brake", "brake_stop", "stop")


def compose_ego(scene: Scene, ids: dict[Entity, str], place: PlaceSpec) -> tuple[EgoSpec, list[Assumption]]:
    """Ego's spec and what was assumed in it."""
    ego = scene.cast.ego
    assumed: list[Assumption] = []
    events = scene.events(ego)
    others = [e for e in scene.actors if e in ids]
    phases: list[Phase] = []
    reaction, react_to, hard = "none", None, False
    said_reaction = False
    for event in events:
        who = ids.get(event.patient) if event.patient is not None and not event.patient.ego else None
        act = event.act
        towards = side(event)
        trigger = trigger_of(event)
        if act == "yield":
            reaction, said_reaction = "yield", True
            react_to = react_to or who or _yielded(scene, event, ids)
        elif act in RESPONSES:
            stop = act != "brake"
            if (
                stop
                and _for_sign(scene, event, place)
                or not others
                or "turn" in event.text
                and not event.hard
                and not others
            ):
                phases.append(
                    Phase(
                        action="stop" if stop else "brake",
                        rate=rate_of(event),
                        speed=target_speed(event),
                        trigger=trigger,
                    )
                )
                if stop and others and not said_reaction:
                    pass
                continue
            said_reaction = True
            if reaction in ("none", "follow"):
                reaction = "brake" if reaction == "none" or event.hard or stop and rate_of(event) else reaction
            hard = hard or event.hard or bool(rate_of(event) and rate_of(event) >= 4)  # type: ignore[operator]
        elif act == "follow":
            phases.append(Phase(action="follow", target=who or _ahead(scene, ids)))
            if phases[-1].target is None:
                phases.pop()
        elif act in ("lane_change", "cut_out", "evade"):
            if act == "evade" and reaction == "none" and who:
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
                phases.append(Phase(action="lane_change", side=towards or _free_side(place), trigger=trigger))
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
                who = _passed(scene, ids) or who
            phases.append(Phase(action="overtake", target=who or _passed(scene, ids), side=towards, trigger=trigger))
            if phases[-1].target is None:
                phases.pop()
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
            phases.append(Phase(action=act, side=towards if act == "lose_control" else None, trigger=trigger))  # type: ignore[arg-type]
        elif act == "go_straight" and place.kind == "intersection":
            phases.append(Phase(action="go_straight", trigger=trigger))
        elif act == "cross_path" and place.kind == "intersection":
            phases.append(Phase(action="go_straight"))
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
            target = who or _last_actor(scene, ids)
            for actor in event.also:
                target = ids.get(actor, target)
            if target:
                phases.append(Phase(action="collide", target=target))
                said_reaction = True
        elif act == "stationary":
            phases.append(Phase(action="wait" if phases else "stationary", duration=duration_of(event)))
        elif act == "keep_lane" and not phases:
            phases.append(Phase(action="keep_lane"))
    if any(p.action == "follow" for p in phases):
        phases = [p for p in phases if p.action not in ("start", "accelerate")]
    if place.manoeuvre in ("left", "right") and not any(p.action.startswith("turn_") for p in phases):
        phases.append(Phase(action=f"turn_{place.manoeuvre}"))  # type: ignore[arg-type]
    if place.kind == "on_ramp":
        phases = [p.model_copy(update={"side": "left"}) if p.action == "lane_change" else p for p in phases]
    struck = next(
        (e for e in scene.clauses.events if e.act == "collide" and e.done and not e.agent.ego and e.patient is ego),
        None,
    )
    if reaction == "yield":
        phases = [p for p in phases if p.action != "wait"]
    phases = _tidy(phases, place, reaction)
    if (
        scene.road.signal
        and not any(p.action in ("run_red", "stop", "wait", "stationary") for p in phases)
        and _faces_red(scene)
        and any(p.action in ("turn_right", "turn_left", "go_straight") for p in phases)
        and not any(e.act in (*RESPONSES, "stationary", "yield") for e in events)
    ):
        phases.insert(0, Phase(action="run_red"))
    speed = _speed(scene, ids, place, phases, assumed)
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
        and _in_lane_conflict(scene, place)
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
    spec = EgoSpec(
        type=kind, model=model, speed=speed, phases=tuple(phases[:8]), reaction=reaction, react_to=react_to, hard=hard
    )  # type: ignore[arg-type]
    return spec, assumed


def _faces_red(scene: Scene) -> bool:
    """Whether the light that ego faces is red while it goes on (a right turn on red)."""
    for event in scene.events(scene.cast.ego):
        if re.search(
            r"\bred\b",
            " ".join(
                scene.words[i].norm
                for i in range(max(0, event.word - 8), min(len(scene.words), event.word + 9))
                if scene.words[i].sentence == scene.words[event.word].sentence
            ),
        ):
            return True
    return bool(re.search(r"right turn on red|turn(s|ing)? right on red", scene.plain))


def _tidy(phases: list[Phase], place: PlaceSpec, reaction: str) -> list[Phase]:
    found: list[Phase] = []
    for phase in phases:
        if found and found[-1].action == phase.action and found[-1].target == phase.target:
            continue
        if phase.action in ("turn_left", "turn_right", "go_straight", "u_turn", "follow", "overtake") and any(
            p.action == phase.action and p.target == phase.target for p in found
        ):
            continue
        if found and found[-1].action == "lose_control" and phase.action in ("leave_road", "oncoming", "drift"):
            found[-1] = phase
            continue
        if found and found[-1].action in ("brake", "stop") and phase.action == "stop":
            found[-1] = phase
            continue
        if (
            found
            and found[-1].action == "start"
            and phase.action in ("turn_left", "turn_right", "go_straight", "enter_road")
        ) and found[0].action == "start":
            found.pop()
        if found and found[-1].action == "enter_road" and phase.action in ("start", "lane_change"):
            continue
        if (
            found
            and found[-1].action in ("oncoming", "drift", "leave_road")
            and phase.action in ("lose_control", "lane_change")
            and phase.action == "lose_control"
        ):
            continue
        if phase.action == "stationary" and found:
            continue
        found.append(phase)
    if len(found) > 1 and found[0].action == "stationary":
        found = (
            found[1:]
            if found[1].action in ("enter_road", "start", "turn_left", "turn_right", "go_straight", "reverse")
            else found
        )
    turns = [p for p in found if p.action in ("turn_left", "turn_right", "u_turn")]
    if turns and place.kind == "intersection":
        found = [p for p in found if p.action != "go_straight"]
    return [p for p in found if p.action != "keep_lane" or len(found) == 1]


def _speed(
    scene: Scene, ids: dict[Entity, str], place: PlaceSpec, phases: list[Phase], assumed: list[Assumption]
) -> float | tuple[float, float] | None:
    said = scene.speeds.get(scene.cast.ego)
    if said is not None:
        low, high = said[0], said[1]
        return round(low, 2) if high - low < 0.05 else (round(low, 2), round(high, 2))
    lead = next(
        (
            e
            for e in scene.actors
            for p in phases
            if p.action == "follow" and ids.get(e) == p.target and e in scene.speeds
        ),
        None,
    )
    if lead is not None:
        low, high = scene.speeds[lead][0], scene.speeds[lead][1]
        if not any(e.act in ("approach", "brake") and e.agent.ego for e in scene.clauses.events):
            assumed.append(
                Assumption(
                    field="speed", value=f"{low * 3.6:.0f} km/h", reason="it follows at the speed of the one ahead"
                )
            )
            return round((low + high) / 2, 2)
    flow = _speed_among_others(scene, ids, phases)
    if flow is not None and not (
        phases and phases[0].action in ("stationary", "enter_road", "start", "wait", "reverse")
    ):
        value, reason = flow
        assumed.append(Assumption(field="speed", value=f"{value * 3.6:.0f} km/h", reason=reason))
        return value
    if phases and phases[0].action in ("stationary", "enter_road", "start", "wait"):
        assumed.append(Assumption(field="speed", value="0 km/h", reason="it stands at first"))
        return 0.0
    table = language.table("defaults")["speeds"]
    key = (
        place.kind if place.kind in table and place.kind not in ("road", "curve") else scene.road.setting or place.kind
    )
    if place.kind in ("straight",):
        key = scene.road.setting or "road"
    entry = table.get(key, table["road"])
    value, reason = float(entry["value"]), entry["reason"]
    if place.speed_limit and place.kind not in ("intersection", "roundabout"):
        value, reason = (
            round(min(value * 1.4, place.speed_limit), 2),
            language.table("defaults")["limits"]["maximum_from_limit"]["reason"],
        )
    if any(p.action == "reverse" for p in phases[:1]):
        value, reason = 3.0, "a usual speed backwards"
    assumed.append(Assumption(field="speed", value=f"{value * 3.6:.0f} km/h", reason=reason))
    return value


def _speed_among_others(scene: Scene, ids: dict[Entity, str], phases: list[Phase]) -> tuple[float, str] | None:
    """Ego's speed as what happens with the others needs it, whose speeds are told: (m/s, why)."""
    factors = language.table("defaults")["factors"]
    targets = {p.target for p in phases if p.action in ("overtake", "collide")}
    for entity in scene.actors:
        said, where = scene.speeds.get(entity), scene.where(entity)
        if (
            said is None
            or entity not in ids
            or not entity.mover
            or entity.person
            or entity.type == "bicycle"
            or said[1] < 3
        ):
            continue
        if where.lane in ("oncoming", "crossing", "parked", "roadside") or "oncoming" in entity.roles:
            continue
        acts = scene.events(entity)
        passes = any(e.act == "overtake" and (e.patient is None or e.patient.ego) for e in acts)
        caught = ids[entity] in targets or any(
            e.act in ("approach", "held_up") and e.patient is entity and e.agent.ego
            for e in scene.clauses.events
            if e.done
        )
        if any(e.act in ("turn", "go_straight", "run_red", "cross_path") for e in acts) and where.rel is None:
            continue
        name = "closing" if caught else "passed" if passes or where.rel == "behind" else "flow"
        if (
            name == "flow"
            and where.rel is None
            and where.lane not in ("left", "right", "same")
            and "lead" not in entity.roles
        ):
            continue
        factor = factors[name]
        return round(min(50.0, max(3.0, (said[0] + said[1]) / 2 * factor["value"])), 2), factor["reason"]
    return None


def _yielded(scene: Scene, event: Event, ids: dict[Entity, str]) -> str | None:
    """Whom ego lets pass, where the clause does not name it: the other in conflict with it."""
    near = [e for e in scene.actors if e in ids and e.mover]
    before = [e for e in near if e.mentions and e.mentions[0].word < event.word]
    conflicts = [
        e
        for e in before or near
        if scene.where(e).lane in ("crossing", "oncoming", "left", "right")
        or scene.where(e).rel == "behind"
        or "oncoming" in e.roles
        or e.person
    ]
    pick = conflicts or before or near
    return ids[pick[-1]] if pick else None


def _ahead(scene: Scene, ids: dict[Entity, str]) -> str | None:
    ahead = [e for e in scene.actors if e in ids and (scene.where(e).rel == "ahead" or "lead" in e.roles)]
    return ids[ahead[0]] if ahead else None


def _passed(scene: Scene, ids: dict[Entity, str]) -> str | None:
    """What ego gets past, where the clause does not name it: what is in its lane ahead."""
    ahead = [
        e
        for e in scene.actors
        if e in ids
        and (
            scene.where(e).rel == "ahead"
            or scene.where(e).lane in ("same", "partly")
            or scene.where(e).lane is None
            and scene.where(e).rel is None
        )
    ]
    vehicles = [e for e in ahead if e.mover]
    pick = vehicles or ahead
    return ids[pick[0]] if pick else None


def _last_actor(scene: Scene, ids: dict[Entity, str]) -> str | None:
    movers = [e for e in scene.actors if e in ids]
    return ids[movers[-1]] if movers else None


def _for_sign(scene: Scene, event: Event, place: PlaceSpec) -> bool:
    """A stop that a sign or a red light asks for, not another road user."""
    near = event.whole
    sentence = " ".join(w.norm for w in scene.words if w.sentence == scene.words[event.word].sentence)
    if re.search(
        r"stop sign|stop line|red light|traffic (light|signal)|at (the|a) (red|sign|line|intersection|junction)|where the cross street",
        near,
    ):
        return True
    if event.adverbial == "after" and place.kind == "intersection" and place.control in ("signal", "stop"):
        return True
    return (
        scene.road.stop_sign
        and "stop sign" in sentence
        or event.act == "stop"
        and place.kind == "intersection"
        and bool(re.search(r"full stop|complete stop", near))
        and any(
            e.act in ("start", "go_straight", "turn") and e.order > event.order for e in scene.events(scene.cast.ego)
        )
    )


def _free_side(place: PlaceSpec) -> str:
    return "right" if place.ego_lane == "leftmost" else "left"


def _in_lane_conflict(scene: Scene, place: PlaceSpec) -> bool:
    return any(e.mover or e.type not in ("warning_sign",) for e in scene.actors)

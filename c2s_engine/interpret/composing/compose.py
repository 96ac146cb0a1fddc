"""Sixth stage: the scene becomes S: places, positions, phases, reactions, with defaults named in `assumed`."""

import re

from c2s_engine.interpret.composing import objects, unmet
from c2s_engine.interpret.composing.awaited import waited_for
from c2s_engine.interpret.composing.braking_triggers import braking_triggers
from c2s_engine.interpret.composing.drivers import compose_ego
from c2s_engine.interpret.composing.objects import Draft
from c2s_engine.interpret.composing.roads import compose_place
from c2s_engine.interpret.composing.run_limits import restrictions
from c2s_engine.interpret.composing.settling import settle
from c2s_engine.interpret.composing.three_arms import by_the_side_road
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.surroundings.settings import ACCEPTED, DEFAULTS, Settings
from c2s_engine.interpret.who.mentions import ZONES, Entity
from c2s_engine.structure import sentences as describe
from c2s_engine.structure.components import FITTED, Assumption, Component, Structure
from c2s_engine.structure.specs import SettingsSpec


def compose(scene: Scene) -> Structure:
    """S of a scene; every choice that the text does not make is an assumption of its component."""
    ids = scene.ids = {scene.cast.ego: "ego"}
    ordered = sorted(scene.actors, key=lambda e: e.mentions[0].word if e.mentions else 0)
    ordered = _blockers_first(scene, ordered)
    for number, entity in enumerate(ordered, 1):
        ids[entity] = f"O{number}"
    for event in scene.clauses.events:
        if event.trigger is not None and event.trigger.get("of") in ids:
            event.trigger["id"] = ids[event.trigger["of"]]
    place = compose_place(scene)
    ego, ego_assumed = compose_ego(scene, ids, place)
    drafts: list[Draft] = [objects.compose_object(scene, entity, ids, place, ego) for entity in ordered]
    ego = waited_for(scene, ego, drafts, ids)
    braking_triggers(scene, ego, drafts, ids)
    ego = settle(scene, ego, place, drafts, ids)
    place, turn_assumed = by_the_side_road(place, ego, drafts)
    place_assumed = [*_place_assumed(scene, place), *turn_assumed]
    untold = unmet.find(scene)
    ego_assumed += [Assumption(field="reaction", value="", reason=r) for r in unmet.alternatives(scene, scene.cast.ego)]
    for draft in drafts:
        if draft.entity is not None:
            draft.unmet += [u.note for u in untold if u.owner is draft.entity]
            draft.assumed += [
                Assumption(field="phases", value=", ".join(p.action for p in draft.spec.phases) or "none", reason=r)
                for r in unmet.alternatives(scene, draft.entity)
            ]
    mine = {d.entity for d in drafts}
    left = {c: tuple(u.note for u in untold if u.owner == c) for c in ("G", "R", "T")}
    left["E"] = tuple(u.note for u in untold if u.owner == "E" or isinstance(u.owner, Entity) and u.owner not in mine)
    components = [
        Component(id=f"O{n}", spec=d.spec, assumed=tuple(d.assumed), unmet=tuple(d.unmet))
        for n, d in enumerate(drafts, 1)
    ]
    settings, settings_assumed = compose_settings(scene.settings, scene)
    limits = restrictions(scene, ids, ego)
    called = {f"O{n}": d.spec.name for n, d in enumerate(drafts, 1)}
    structure = Structure(
        text=scene.text,
        settings=Component(
            id="G",
            spec=settings,
            assumed=tuple(settings_assumed),
            description=describe.settings(settings),
            unmet=left["G"],
        ),
        place=Component(
            id="R",
            spec=place,
            assumed=tuple(place_assumed),
            description=describe.place(place),
            unmet=left["R"],
        ),
        ego=Component(id="E", spec=ego, assumed=tuple(ego_assumed), unmet=left["E"]),
        objects=tuple(components),
        restrictions=Component(id="T", spec=limits, description=describe.restrictions(limits, called), unmet=left["T"]),
    )
    names = {c.id: c.spec.name for c in structure.objects}  # type: ignore[union-attr]
    described = [c.model_copy(update={"description": describe.obj(c.spec, names)}) for c in structure.objects]  # type: ignore[arg-type]
    return structure.model_copy(
        update={
            "ego": structure.ego.model_copy(update={"description": describe.ego(ego, names)}),
            "objects": tuple(described),
        }
    )


def _blockers_first(scene: Scene, ordered: list[Entity]) -> list[Entity]:
    """What others are seen from stands before them, so that it is written first."""
    done: list[Entity] = []

    def visit(entity: Entity, depth: int) -> None:
        if entity in done or entity not in ordered:
            return
        where = scene.where(entity)
        for other in (where.hidden_by, where.of):
            if other is not None and depth < 6:
                visit(other, depth + 1)
        if entity not in done:
            done.append(entity)

    for entity in ordered:
        visit(entity, 0)
    return done


def compose_settings(found: Settings, scene: Scene) -> tuple[SettingsSpec, list[Assumption]]:
    """G, with the paper's defaults where the text names nothing with a confidence of 0.6 or more."""
    assumed = []
    sky = tuple(dict.fromkeys(f.value for f in found.weather if f.confidence >= ACCEPTED))
    time = found.time.value if found.time and found.time.confidence >= ACCEPTED else None
    preset = found.preset.value if found.preset and found.preset.confidence >= ACCEPTED else None
    town = found.map.value if found.map and found.map.confidence >= ACCEPTED else None
    if town is None:
        assumed.append(Assumption(field="map", value=DEFAULTS["map"], reason="the text names no map"))
    if not sky and time is None and preset is None:
        assumed.append(
            Assumption(field="weather", value=DEFAULTS["weather"], reason="the text says nothing of weather or light")
        )
    state = None
    if scene.light and scene.road.signal:
        state = _ego_light(scene)
    return SettingsSpec(map=town, weather=sky, time=time, preset=preset, light=state), assumed  # type: ignore[arg-type]


CHANGES = re.compile(
    r"(?:turn|go|goes|gone|went|chang|switch|flip)\w*(?: to| from green to| over to| just)? (?:yellow|amber|red)$"
)
FROM_TO = re.compile(
    r"(?<!pedestrian )\b(?:lights?|signals?)\b(?! for)[^.;]{0,40}?\bfrom (?:green|yellow|amber|red)"
    r"(?: (?:over |via \w+ )?to (?P<state>green|yellow|amber|red))+\b"
)
"""A light that changes: "turns from green to yellow"."""


def _ego_light(scene: Scene) -> str | None:
    """The state of the light that ego faces: of several, the first that is not the one another runs."""
    ego = scene.cast.ego
    runner = next((e for e in scene.clauses.events if e.act == "run_red" and e.done and not e.agent.ego), None)
    if scene.does(ego, "run_red") is not None:
        return "red"
    for found in scene.light:
        if found.value == "red" and runner is not None:
            start, end = _clause_span(runner)
            if start - 25 <= found.span[0] <= end + 25:
                continue
        if (
            found.value in ("green", "red")
            and len({f.value for f in scene.light}) > 1
            and _of_another(scene, found.span[0])
        ):
            continue
        return found.value
    return "green" if runner is not None else None


def _of_another(scene: Scene, at: int) -> bool:
    """Whether a light is told right after another road user than ego ("the cyclist has the green")."""
    words = [w for w in scene.words if w.start < at]
    near = [i for i in scene.cast.of if words and i <= words[-1].i and scene.words[i].sentence == words[-1].sentence]
    last = scene.cast.of[max(near)] if near else None
    return last is not None and not last.ego and last.mover


def _clause_span(event) -> tuple[int, int]:  # noqa: ANN001
    return event.start, event.end


ONE_OF_ITS_KIND = ("curve", "intersection", "roundabout")
"""Kinds of place that S has on ordinary roads only: a motorway that is said with them is given up."""


def _named_road(scene: Scene) -> str:
    """The words that name a kind of road which S does not tell from others ("a country road"); empty where none do."""
    if scene.road.setting not in ("rural", "urban") or "setting" not in scene.road.spans:
        return ""
    start = scene.road.spans["setting"][0]
    words = re.match(r"(?:[\w-]+ ){0,2}?(?:road|street|avenue|boulevard|roadway|highway)s?\b", scene.plain[start:])
    return f"{'an' if words[0][0] in 'aeiou' else 'a'} {words[0].removesuffix('s')}" if words else ""


def _said_too(scene: Scene, kind: str) -> str:
    """The other kind of place that is said besides the one that S has; empty where none is."""
    other = "curve" if kind == "motorway" else "motorway" if kind in ONE_OF_ITS_KIND else ""
    return other if other in scene.road.spans else ""


def _place_assumed(scene: Scene, place) -> list[Assumption]:  # noqa: ANN001
    assumed = []
    spans = scene.road.spans
    if scene.road.kind is None:
        named = _named_road(scene)
        reason = f"no field tells {named} from others" if named else "the text does not say what kind of road it is"
        assumed.append(Assumption(field="kind", value=place.kind, reason=reason))
    elif (also := _said_too(scene, place.kind)) and not scene.road.no_intersection:
        words = scene.plain[slice(*spans[also])]
        assumed.append(
            Assumption(field="kind", value=place.kind, reason=f"R has one kind of place; “{words}” was said, too",
                       by=FITTED, was=also)
        )  # fmt: skip
    if place.kind == "intersection" and place.arms is None:
        assumed.append(Assumption(field="arms", value="3 or 4", reason="the text does not say how many roads meet"))
    return assumed


__all__ = ["ZONES", "compose", "compose_settings"]

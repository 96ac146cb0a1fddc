"""The road that ego is on and the setting are as S says (R and G)."""

from collections.abc import Iterator

from c2s_engine.require.evidence import Evidence
from c2s_engine.require.results import between, decided, scored, unknown
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.require.watched import SHOWN_AS
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.requirements import Requirement, Result, Value
from c2s_engine.structure.specs import SettingsSpec

SIGNS = {"signal": "traffic_light", "stop": "stop_sign", "yield": "yield_sign"}


def required(scene: Scene) -> Iterator[Requirement]:
    place = scene.place

    def make(check: str, path: str, text: str, **values: float | str | bool | tuple[str, ...]) -> Requirement:
        return scene.make("road", check, EGO, path, text, component="R", **values)  # type: ignore[arg-type]

    if scene.structure.place.recognised and place.kind in ("intersection", "straight", "road", "curve"):
        yield make("road_kind", "kind", f"Ego's path leads through this kind of place: {place.kind}.", place=place.kind)
    if place.arms and scene.stated("R", "arms"):
        yield make(
            "road_fact", "arms", f"{place.arms} roads meet there.", fact="intersection", value=f"{place.arms}way"
        )
    if place.control in SIGNS:
        yield make("infrastructure", "control", f"Ego's approach is controlled by: {place.control}.",
                   value=SIGNS[place.control])  # fmt: skip
    elif place.control == "none":
        yield make("road_fact", "control", "No light regulates ego's approach.", fact="signalized", value=False)
    if place.crosswalk or place.kind == "crosswalk":
        yield make("infrastructure", "crosswalk", "There is a crosswalk on ego's path.", value="crosswalk")
    if place.lanes and scene.stated("R", "lanes"):
        yield make("lanes", "lanes", f"At least {place.lanes} lanes lead in ego's direction.", value=place.lanes)
    if place.oncoming is not None and scene.stated("R", "oncoming"):
        text = "There is an adjacent oncoming lane." if place.oncoming else "There is no adjacent oncoming lane."
        yield make("road_fact", "oncoming", text, fact="oncoming_lane", value=place.oncoming)
    if place.distance is not None and scene.stated("R", "distance") and place.kind in ("intersection", "crosswalk"):
        yield make("distance_to", "distance", f"Ego starts {low(place.distance):g} m before the {place.kind}.",
                   least=low(place.distance), most=high(place.distance), place=place.kind)  # fmt: skip
    yield from _settings(scene)


def _settings(scene: Scene) -> Iterator[Requirement]:
    spec = scene.structure.settings.spec
    assert isinstance(spec, SettingsSpec)
    if spec.light and not spec.light_changes:  # else it may have changed by then
        yield scene.make("settings", "light", EGO, "light", f"The light is {spec.light} when ego comes near.",
                         component="G", value=spec.light)  # fmt: skip
    for weather in spec.weather:
        if weather not in ("snow", "wind", "clear"):
            yield scene.make("settings", "weather", EGO, f"weather.{weather}", f"The weather: {weather}.",
                             component="G", value=weather)  # fmt: skip
    if spec.time:
        low_sun = spec.time == "day" and spec.parameters.get("sun_altitude_angle", 0.0) > 0
        more: dict[str, Value] = {"low_sun": True} if low_sun else {}
        yield scene.make("settings", "time_of_day", EGO, "time", f"The time of day: {spec.time}.", component="G",
                         value=spec.time, **more)  # type: ignore[arg-type]  # fmt: skip


def road_kind(requirement: Requirement, evidence: Evidence) -> Result:
    road, kind = evidence.facts.road, str(requirement.values["place"])
    seen = {
        "intersection": road.intersection != "none",
        "curve": road.curve,
        "straight": not road.curve or road.straight,
        "road": True,
    }[kind]
    parts = [f"intersection {road.intersection}", *(["a curve"] if road.curve else []),
             *(["straight"] if road.straight else [])]  # fmt: skip
    return decided(requirement, seen, kind, ", ".join(parts), 0.0)


def road_fact(requirement: Requirement, evidence: Evidence) -> Result:
    seen, said = getattr(evidence.facts.road, str(requirement.values["fact"])), requirement.values["value"]
    return decided(requirement, seen == said, str(said), str(seen), 0.0)


def lanes(requirement: Requirement, evidence: Evidence) -> Result:
    said, seen = float(requirement.values["value"]), evidence.facts.road.lanes_same_direction  # type: ignore[arg-type]
    return scored(
        requirement, float(seen - said) + (0.5 if seen >= said else 0.0), f"at least {said:g}", f"{seen}", 0.0
    )


def infrastructure(requirement: Requirement, evidence: Evidence) -> Result:
    value, found = str(requirement.values["value"]), evidence.facts.infrastructure
    return decided(requirement, value in found, value.replace("_", " "), ", ".join(found) or "none", 0.0)


def distance_to(requirement: Requirement, evidence: Evidence) -> Result:
    v, ego = requirement.values, evidence.motion(EGO)
    said = f"{v['least']:g} m"
    if ego is None or not ego.course.along:
        return unknown(requirement, said, "ego's place was not recorded")
    kind = "junction" if v["place"] == "intersection" else "crosswalk"
    front = ego.course.along[0] + ego.size[0] / 2
    ahead = [m.start - front for m in ego.course.marks if m.kind == kind and m.start > front - 1.0]
    if not ahead:
        return decided(requirement, False, said, f"no {v['place']} ahead", 0.0)
    seen, room = min(ahead), bounds()["start"]["distance"]["value"]
    return between(requirement, seen, room, said, f"{seen:.0f} m", 0.0)


def light(requirement: Requirement, evidence: Evidence) -> Result:
    seen, said = evidence.facts.light, str(requirement.values["value"])
    if seen in SHOWN_AS.get(said, ()):
        seen = said
    if seen == "":
        return unknown(requirement, said, "not judged: ego never came near the light")
    return decided(requirement, seen == said, said, seen or "there is no light")


def weather(requirement: Requirement, evidence: Evidence) -> Result:
    said = str(requirement.values["value"])
    alike = {"heavy_rain": {"rain", "heavy_rain"}, "wet": {"wet", "rain"}}.get(said, {said})
    return decided(requirement, bool(alike & set(evidence.facts.weather)), said, ", ".join(evidence.facts.weather), 0.0)


def time_of_day(requirement: Requirement, evidence: Evidence) -> Result:
    said = str(requirement.values["value"])
    said_too = {said, "dawn", "dusk"} if requirement.values.get("low_sun") else {said}
    return decided(requirement, bool(said_too & set(evidence.facts.time)), said, ", ".join(evidence.facts.time), 0.0)


CHECKS = {"road_kind": road_kind, "road_fact": road_fact, "lanes": lanes, "infrastructure": infrastructure,
          "distance_to": distance_to, "light": light, "weather": weather, "time_of_day": time_of_day}  # fmt: skip

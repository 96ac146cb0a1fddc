"""A demand told as a sentence, and the scene amid which it is read."""

import re
from functools import lru_cache

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.refer import objects_of, refer, spec_of
from c2s_engine.interpret.entities import PERSONS
from c2s_engine.interpret.reading import amounts, scan
from c2s_engine.interpret.spans import Span
from c2s_engine.structure import sentences as describe
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.specs import EgoSpec, PlaceSpec, SettingsSpec


def table() -> dict[str, str]:
    """The patterns of demands that are told like a scene."""
    found: dict[str, str] = language.table("refine")["told"]
    return found


def indicative(clause: str, structure: Structure) -> str | None:
    """The demand as a sentence that tells it, or None where it names nobody."""
    forms = table()
    said = re.sub(forms["beside_the_point"], " ", clause).strip(" ,")
    said = re.sub(r"\bo(\d+)\b", lambda m: _called(f"O{m[1]}", structure), said)
    said = re.sub(r"\bi\b", "I", _settled(said, structure))
    if (begins := re.match(forms["begins"], said)) and (who := refer(begins["who"], structure, alone=False)):
        first = next(iter(getattr(who.spec, "phases", ())), None)
        if first is not None:
            if first.action == "stationary":
                doing = "cross the road" if getattr(who.spec, "type", "") in PERSONS else "start"
                return f"{begins['who']} will {doing} {begins['when']}"
            target = _called(first.target or "ego", structure)
            action = describe.table()["actions"][first.action].format(target=target)
            return f"{begins['who']} will {action} {begins['when']}"
    if match := re.match(forms["adds"], said):
        rest = re.sub(forms["more"], "a", said[match.end() :])
        first = next(iter(s.data["type"] for s in scan.names(rest) if s.kind == "actor"), "")
        rest = re.sub(r"^an?\b", "another", rest) if objects_of(structure, first) else rest
        return rest if re.search(forms["finite"], rest) else f"there {'is' if rest[0] == 'a' else 'are'} {rest}"
    named = [s for s in scan.names(said) if s.kind in ("actor", "ego", "label")]
    if not named:
        return None
    first = named[0]
    bare = first.kind == "actor" and first.start == 0 and not first.data.get("plural") and " " in said[first.end - 1 :]
    meant = refer(said[: first.end], structure, alone=False) if bare or _all_act(first, said) else None
    if meant is not None:
        said = f"the {said}"
    if match := re.match(forms["causes"], said):
        subject = next((s for s in named if s.start >= match.end()), None)
        if subject is None:
            return None
        return f"{said[match.end() : subject.end]} will{said[subject.end :]}"
    if first.kind == "ego":
        said = re.sub(forms["pauses"], r"\g<before>stop for \g<time>", said)
    said = re.sub(forms["demands"], "will", said)
    return re.sub(forms["beside_on"], r"the \g<who>\g<where> on the \g<side>", said)


def _all_act(first: Span, said: str) -> bool:
    """Whether a text begins with several who are told to do something: "pedestrians should stand at the kerb"."""
    several = first.kind == "actor" and first.start == 0 and bool(first.data.get("plural"))
    return several and bool(re.match(table()["all_act"], said[first.end :]))


def _settled(said: str, structure: Structure) -> str:
    """The demand with the nouns by which the scene calls those who are there: an animal for "the dog"."""
    for span in reversed(scan.names(said)):
        before = said[: span.start]
        if span.kind != "actor" or span.data.get("plural") or span.data.get("roles") or re.search(r"\ban? $", before):
            continue
        meant = refer(f"the {said[span.start : span.end]}", structure, alone=False)
        same = meant is not None and meant.id != "E" and spec_of(meant).count == 1
        if meant is None or not same:
            continue
        if span.data["type"] not in PERSONS and not _misnamed(span, meant):
            continue
        if span.data["type"] in PERSONS and spec_of(meant).type not in (span.data["type"], "bicycle", "motorcycle"):
            continue
        article = "" if re.search(r"\b(?:the|that|this|second|other|another|more)(?: \w+)? $", before) else "the "
        said = f"{before}{article}{_noun(meant)}{said[span.end :]}"
    return said


def _misnamed(span: Span, meant: Component) -> bool:
    """Whether a noun that is somebody's name, or a word of it, is that of another type: the scooter of an e-scooter,
    the wrong-way driver who is a car."""
    spec = spec_of(meant)
    words = (*spec.name.split("_"), spec.name.replace("_", " "))
    return span.data["type"] != spec.type and span.data["noun"] in words


def _called(cid: ComponentId, structure: Structure) -> str:
    return f"the {_noun(structure[cid])}" if cid in structure else cid


def _noun(component: Component) -> str:
    return spec_of(component).type.replace("_", " ")


def located_in(told: str) -> bool:
    """Whether a sentence tells where somebody is, apart from when something happens."""
    return bool(re.match(table()["located"], re.sub(table()["meanwhile"], "", told)))


def on_its_way(told: str, component: Component) -> bool:
    """Whether a sentence says what one who crosses the road does on it, not where he begins."""
    crosses = any(p.action == "cross_road" for p in getattr(component.spec, "phases", ()))
    return crosses and re.search(table()["midway"], told) is not None


def scene(structure: Structure, told: str) -> str:
    """Where everything stands, without what it does and without what the sentence tells anew: where somebody is, or
    where ego goes.
    """
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    if re.match(r"(?:the )?ego\b", told):
        way = place.manoeuvre if re.match(table()["some_turn"], told) else None
        place = place.model_copy(update={"ego_lane": None, "manoeuvre": way})
    told_speed = any(q.data["dimension"] == "speed" for q in amounts.quantities(told))
    mover = refer(told, structure, alone=False) if told_speed else None
    placed = located_in(told) and not re.match(table()["adds"], told)
    located = refer(told, structure, alone=False) if placed else None
    located = None if located is not None and on_its_way(told, located) else located
    names = {c.id: _noun(c) for c in structure.objects}
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    own = {"speed": None} if mover is not None and mover.id == "E" else {}
    still = ego.model_copy(update={"phases": (), "reaction": "none", **own})
    sentences = [describe.place(place), describe.ego(still, names)]
    told_of: set[str] = set()
    for component in structure.objects:
        if located is not None and component.id == located.id:
            count = spec_of(component).count
            many = f"There are {count} {language.plurals(_noun(component))[0]}."
            sentence = many if count > 1 else f"There is a {_noun(component)}."
        else:
            untold = component is mover
            assumed = {"speed": None} if untold else {}
            sentence = describe.obj(spec_of(component).model_copy(update={"phases": (), **assumed}), names)
        sentences.append(re.sub(r"^An? ", "Another ", sentence) if _noun(component) in told_of else sentence)
        told_of.add(_noun(component))
    return " ".join(_SPEED_BEHIND.sub(r", at \g<speed>, \g<hidden>.", s) for s in sentences)


_SPEED_BEHIND = re.compile(r", (?P<hidden>hidden by [\w -]+), at (?P<speed>[\d.]+ km/h)\.$")
"""A speed that would be read as that of who hides somebody."""


@lru_cache(64)
def read(text: str) -> Structure | None:
    from c2s_engine.interpret.embedded import EmbeddedInterpreter, InterpretError

    try:
        return EmbeddedInterpreter().interpret(text).structure
    except InterpretError:
        return None


def tells_ego(text: str, structure: Structure) -> bool:
    """Whether a text says where ego is, how fast it goes or what it does: then it is a scene, no addition to one."""
    found = read(text)
    if found is None or not found.objects:
        return True
    ego, place, settings = found.ego.spec, found.place.spec, found.settings.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec) and isinstance(settings, SettingsSpec)
    assumed = {(c.id, a.field) for c in found.components for a in c.assumed}
    named = any(s.kind == "ego" for s in scan.names(scan.normalised(text)))
    drives = named and (bool(ego.phases) or ego.speed is not None and ("E", "speed") not in assumed)
    here = getattr(structure.place.spec, "kind", "road")
    elsewhere = place.kind not in ("road", here) and ("R", "kind") not in assumed
    return drives or elsewhere

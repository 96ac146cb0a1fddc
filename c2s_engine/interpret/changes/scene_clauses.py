"""Changes that are told like a scene: the clause is read amid what is there, and what that adds is what it asks for.

Two texts are read: one that says where everything stands, and the same with the clause behind it. The fields in which
they differ are set, of the components that the clause names and of those that are new.
"""

import re
from typing import Any

from c2s_engine.interpret.changes.acts import at_rest_before, struck
from c2s_engine.interpret.changes.apart import with_distinct_nouns
from c2s_engine.interpret.changes.bounds import CONTACT
from c2s_engine.interpret.changes.forms import Found
from c2s_engine.interpret.changes.in_words import in_words
from c2s_engine.interpret.changes.kept import WAYS
from c2s_engine.interpret.changes.phases import (
    PASSING,
    afterwards,
    awaited,
    begun,
    begun_at,
    given_up,
    in_other_words,
    joined,
    mapped,
    paused,
    settled,
    without_awaited,
)
from c2s_engine.interpret.changes.places import added_as, kept_place, only_by_ego, placed_before
from c2s_engine.interpret.changes.refer import doing, refer, spec_of
from c2s_engine.interpret.changes.scene_context import indicative, located_in, read, scene, table
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import AddObject, Edit, MoveObject, SetField, apply
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec, SettingsSpec, Trigger

PLACE = ("kind", "manoeuvre", "arms", "control", "ego_lane", "crosswalk")
"""Fields of R that a clause about road users can say."""
SIGNS = frozenset(("stop_sign", "yield_sign", "speed_sign"))


def acting(clause: str, structure: Structure) -> Found | None:
    """ "Let the car brake when the pedestrian is 10 m away", "add a parked van that hides the child": who does what."""
    if re.search(r"\d ?(?:m|metres|meters) apart\b", clause):
        return None
    if re.match(table()["sets_speed"], clause):
        return None
    acts = ("phases", "reaction", "manoeuvre", "+")
    return _from_scene_clause(clause, structure, lambda path: path.split(".")[0] in acts)


def introduced(parts: list[str], structure: Structure) -> Found | None:
    """ "One more pedestrian, an adult, crosses from the left, hidden by the bus": who is new, with all that is said of
    him, over several parts of a text; None where a part asks for something else."""
    if not parts or not re.match(table()["adds"], parts[0]):
        return None
    said = "".join((". " if re.match(table()["apart"], p) else ", ") + p for p in parts)[2:]
    return _from_scene_clause(said, structure, lambda path: path == "+")


def standing(clause: str, structure: Structure) -> Found | None:
    """ "Ego in the left lane", "the van is parked on the left", "the pedestrian comes from the other side"."""
    return _from_scene_clause(clause, structure, lambda path: path not in ("speed", "type"))


def _from_scene_clause(clause: str, structure: Structure, wanted: Any) -> Found | None:
    """What a clause asks for that is read amid the scene, those of one type told apart."""
    found = _read_amid(*with_distinct_nouns(clause, structure), wanted)
    if found is None:
        return None
    found = struck(clause, at_rest_before(clause, found, structure))
    edits = [_named_apart(e, structure) if isinstance(e, AddObject) else e for e in found]
    return edits, in_words(edits, structure)


def _named_apart(edit: AddObject, structure: Structure) -> AddObject:
    """One who is added under a name that nobody has."""
    assert isinstance(edit.spec, ObjectSpec)
    if edit.spec.name not in {spec_of(c).name for c in structure.objects} or edit.component is None:
        return edit
    spec = edit.spec.model_copy(update={"name": f"{edit.spec.name}_{edit.component[1:]}"})
    return edit.model_copy(update={"spec": spec})


def _read_amid(clause: str, structure: Structure, wanted: Any) -> list[Edit] | None:
    if (denied := _denied(clause, structure)) is not None:
        return denied
    told = indicative(clause, structure)
    new = re.match(table()["adds"], clause)
    stranger = re.search(r"\b(?:second|third)\b(?! of (?:the|them|these|those)\b)", clause)
    if not new and stranger and refer(clause, structure) is None:
        return None
    if (
        told is None
        or not new
        and re.search(table()["relative"], clause)
        or not new
        and re.search(r"(?<!to the )(?<!across to )\b(?:other|opposite) side\b", clause)
    ):
        return None
    waited = awaited(told, structure)
    if then := afterwards(told, structure):
        told = then[0]
    if not told:
        return None
    there_is = scene(structure, told)
    was, now = read(there_is), read(f"{there_is} {told[0].upper()}{told[1:]}.")
    if was is None or now is None or len(was.objects) != len(structure.objects) or len(now.objects) < len(was.objects):
        return None
    before = _counterparts(was, now)
    if before is None:
        return None
    there = {a.id: b.id for a, b in zip(was.objects, structure.objects, strict=True)}
    both = bool(re.search(r"\bboth sides\b", told))
    added = [c.id for c in now.objects if c.id not in before and not _there_already(c, was, both)]
    if added and not re.search(table()["new"], told):
        return None
    ids = {c.id: there[before[c.id].id] for c in now.objects if c.id in before}
    number = int(structure.next_object_id()[1:])
    ids |= {cid: f"O{number + i}" for i, cid in enumerate(added)}
    main = re.sub(table()["meanwhile"], " ", told)
    main = main if scan.names(main) else told
    edits: list[Edit] = []
    paths: list[str] = []
    for component in now.components:
        cid = ids.get(component.id, component.id)
        awaited_only = waited is not None and cid == waited.of and not _names(main, structure[cid], structure)
        if component.id in ("G", "T") or awaited_only:
            continue
        if component.id.startswith("O") and component.id not in ids:
            continue  # a sign, or one like it is there
        if component.id in added:
            edits.append(added_as(component, cid, ids, structure))
            paths.append("+")
        elif cid == "R" or _names(main, structure[cid], structure):
            old = before.get(component.id) or was[component.id]
            changed = _changes(old, component, structure[cid], ids, clause, waited)
            changed = begun_at(changed, structure[cid])
            changed = kept_place(changed, structure[cid], told)
            if cid not in ("R", "E") and _only_beside(main, structure[cid], structure):
                changed = [c for c in changed if c[0] in ("placement.hidden_by", "count")]
            if cid == "R" and getattr(structure.place.spec, "ego_lane", None) == "middle" and not located_in(told):
                changed = [c for c in changed if c[0] != "ego_lane"]  # it can leave the middle either way
            if cid == "R" and not (_names(told, structure.ego, structure) and re.search(table()["of_lanes"], told)):
                changed = [c for c in changed if c[0] != "ego_lane"]
            if added and new and cid.startswith("O"):
                changed = [c for c in changed if c[0] == "placement.hidden_by"]
            if added and new and cid == "E" and only_by_ego(main):
                changed = []  # the new one is placed by ego
            changed = without_awaited(changed)
            edits += [SetField(component=cid, path=path, value=value) for path, value in changed]
            paths += [path for path, _ in changed]
    if not any(wanted(path) for path in paths):
        return None
    edits += [
        *_light(clause, now, structure),
    ]
    edits = settled(_one_way(edits, structure), structure)
    return [*sorted(edits, key=lambda e: not isinstance(e, AddObject)), *_moves(now, ids, structure)]


def _there_already(component: Component, was: Structure, both: bool) -> bool:
    """Whether it is a sign that the place has, or of those on both sides (`both`) the ones who stand there."""
    spec = spec_of(component)
    return spec.type in SIGNS


def _light(clause: str, now: Structure, structure: Structure) -> list[Edit]:
    """The light that ego faces, where the clause says it besides."""
    new, old = now.settings.spec, structure.settings.spec
    assert isinstance(new, SettingsSpec) and isinstance(old, SettingsSpec)
    first = refer(clause, structure, alone=False)
    own = first is None or first.id == "E" or bool(re.search(r"\b(?:ego|our|us|my|me)\b", clause))
    told = own and new.light is not None and new.light != old.light and new.light in clause
    return [SetField(component="G", path="light", value=new.light)] if told else []


def _one_way(edits: list[Edit], structure: Structure) -> list[Edit]:
    """Ego's way through the intersection is what its phases say now."""
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    phases = next((e.value for e in edits if isinstance(e, SetField) and (e.component, e.path) == ("E", "phases")), ())
    way = next((WAYS[p.action] for p in phases if p.action in WAYS), None)
    if way is None or place.kind != "intersection":
        return edits
    others = [e for e in edits if not (isinstance(e, SetField) and e.path == "manoeuvre")]
    return [*others, *([] if place.manoeuvre == way else [SetField(component="R", path="manoeuvre", value=way)])]


def _moves(now: Structure, ids: dict[str, str], structure: Structure) -> list[Edit]:
    """New ones by which old ones are placed come before these."""
    edits: list[Edit] = []
    for component in now.objects:
        place = spec_of(component).placement
        for other in sorted({ids.get(place.of, ""), ids.get(place.hidden_by or "", "")} - {""}):
            if component.id in ids and ids[component.id] in structure and other not in structure:
                index = structure.ids.index(ids[component.id]) - structure.ids.index(structure.objects[0].id)
                edits.append(MoveObject(component=other, index=index))
    return edits


def _denied(clause: str, structure: Structure) -> list[Edit] | None:
    """ "The truck should not stop": it does everything else."""
    positive, number = re.subn(table()["not"], "will", clause)
    edits: list[Edit] = []
    doer = refer(clause, structure, alone=False)
    if doer is not None and doer.id == "E" and not re.match(r"(?:the )?ego\b", clause):
        doer = None  # to whom it is not done
    found = _read_amid(positive, structure, lambda path: path == "phases") if number == 1 else None
    alone = _acts_alone(positive, doer, structure) if number == 1 and doer is not None else set()
    for edit in found or ():
        if not isinstance(edit, SetField) or edit.path != "phases":
            continue
        if (
            edit.component != (doer.id if doer is not None else edit.component)
            or doer is None
            and edit.component == "E"
        ):
            continue
        denied = {p.action for p in edit.value} - {"go_straight"}
        said = re.sub(table()["meanwhile"], "", clause)
        denied = {a for a in denied if doing(said, (a,))} or denied & alone or denied
        own = structure[edit.component].spec
        assert isinstance(own, EgoSpec | ObjectSpec)
        phases = own.phases
        if edit.component == "E":
            denied -= WAYS.keys()
        kept = tuple(p for p in phases if p.action not in denied)
        if kept != phases:
            edits.append(SetField(component=edit.component, path="phases", value=kept))
    if number == 1 and doer is not None and doer.id == "E" and not edits:
        edits = given_up(clause, structure)
    return edits or None


def _acts_alone(told: str, doer: Component, structure: Structure) -> set[str]:
    """The acts that a sentence tells of somebody who does nothing yet."""
    idle = apply(structure, SetField(component=doer.id, path="phases", value=()))
    found = _read_amid(told, idle, lambda path: path == "phases") or ()
    told_acts = [e.value for e in found if isinstance(e, SetField) and (e.component, e.path) == (doer.id, "phases")]
    return {p.action for phases in told_acts for p in phases}


def _names(told: str, component: Component, structure: Structure) -> bool:
    """Whether the sentence speaks of a component."""
    for span in scan.names(told):
        if span.kind == "ego" and component.id == "E":
            return True
        if span.kind != "ego" and component.id != "E":
            meant = refer(f"the {told[span.start : span.end]}", structure, alone=False)
            if meant is not None and meant.id == component.id:
                return True
    return component.id != "E" and bool(re.search(r"\b(?:they|them|it|he|she)\b", told)) and len(structure.objects) == 1


def _only_beside(told: str, component: Component, structure: Structure) -> bool:
    """Whether a sentence names a component only as the one for, behind or from whom something is done."""
    found = False
    for span in scan.names(told):
        if span.kind in ("actor", "label"):
            meant = refer(f"the {told[span.start : span.end]}", structure, alone=False)
            if meant is not None and meant.id == component.id:
                if not re.search(table()["beside"], told[: span.start]):
                    return False
                found = True
    return found


def _counterparts(was: Structure, now: Structure) -> dict[str, Component] | None:
    """By id, of the objects of the later reading those of the earlier one: of the same name ("the lead" may give a car
    another one), else of the same type; None where one is lost.
    """
    left, found = list(was.objects), {}
    for same in (lambda s: s.name, lambda s: s.type):
        for component in now.objects:
            old = next((c for c in left if same(spec_of(c)) == same(spec_of(component))), None)
            if old is not None and component.id not in found:
                found[component.id] = old
                left.remove(old)
    return None if left else found


def _changes(
    was: Component, now: Component, there: Component, ids: dict[str, str], clause: str, waited: Trigger | None
) -> list[tuple[str, Any]]:
    """Paths and new values of the fields of a component that the clause says."""
    old, new = was.spec.model_dump(), now.spec.model_dump()
    if any(a.field == "reaction" for a in was.assumed) and not any(a.field == "reaction" for a in now.assumed):
        old["reaction"] = getattr(there.spec, "reaction", None)
    found: list[tuple[str, Any]] = []
    for path, value in new.items():
        same = value == old[path] and path != "placement"
        if path == "ego_lane" and re.match(table()["located"], clause):
            same = value == getattr(there.spec, path)
        if path == "speed":
            same = _near(value, old[path]) or _near(value, getattr(there.spec, "speed", None))
        if path == "speed" and not re.search(table()["paces"], clause):
            moves = getattr(there.spec, "speed", None) == 0.0 and bool(new["phases"])
            same = not moves or not value
        if path == "speed" and getattr(there.spec, "speed", None) and any(a.field == "speed" for a in now.assumed):
            same = True
        if path in ("speed", "phases") and re.match(table()["put"], clause):
            continue  # where somebody begins, not that he stays there
        same = same or path == "speed" and not value and bool(re.search(table()["besides"], clause))
        same = same and not (path == "phases" and value and re.search(table()["besides"], clause))
        if same or path in ("name", "component", "model", "type") or (there.id == "R" and path not in PLACE):
            continue
        if path == "reaction" and value == "none" and not _unmoved(now, clause):
            continue  # what it does of its own accord does not say that it reacts to nothing
        if path == "phases":
            assert isinstance(there.spec, EgoSpec | ObjectSpec) and isinstance(now.spec, EgoSpec | ObjectSpec)
            turns = any(p.action in ("turn_left", "turn_right", "u_turn") for p in now.spec.phases)
            phases = tuple(mapped(p, ids) for p in now.spec.phases if not (turns and p.action == "go_straight"))
            phases = paused(phases, clause)
            phases = tuple(sorted(phases, key=lambda p: p.action not in PASSING))
            phases = in_other_words(phases, there.spec)
            phases = begun(phases, waited, there.spec.phases)
            found.append((path, joined(there.spec.phases, phases, clause)))
        elif path == "placement":
            place = placed_before(was, now, there, clause)
            found += [
                (f"placement.{key}", ids.get(part, part) if key in ("of", "hidden_by") else part)
                for key, part in value.items()
                if part != place[key]
            ]
        elif value is not None:
            found.append((path, ids.get(value, value) if path == "react_to" else value))
    return found


def _unmoved(now: Component, clause: str) -> bool:
    """Whether ego reacts to nobody by a clause: it denies it, tells of a contact, or ego passes somebody."""
    assert isinstance(now.spec, EgoSpec)
    passes = any(p.action in ("overtake", "collide") for p in now.spec.phases)
    return passes or CONTACT.search(clause) is not None or re.search(table()["denies"], clause) is not None


def unparsed_words(clause: str, structure: Structure) -> list[str]:
    """The words of a clause that are not understood where it is read amid the scene."""
    told = indicative(clause, structure)
    if told is None:
        return []
    if then := afterwards(told, structure):
        told = then[0]
    if not told:
        return []
    there_is = scene(structure, told)
    now = read(f"{there_is} {told[0].upper()}{told[1:]}.")
    notes = [*now.not_understood, *now.background] if now is not None else []
    return [n.text.strip(" ,.") for n in notes if n.span and n.span[0] > len(there_is)]


def _near(a: Any, b: Any) -> bool:
    """Whether speeds are the same but for their being told in whole km/h."""
    return a is not None and b is not None and abs(low(a) - low(b)) < 0.15 and abs(high(a) - high(b)) < 0.15

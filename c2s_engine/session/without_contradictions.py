"""A text's reading that contradicts itself is made to agree: as little as possible is left out, and that is said.

Only for what was read from a text as a whole: where a person edits S, a contradiction is refused with its fields named.
"""

from collections.abc import Iterator

from c2s_engine.structure.components import ComponentId, Structure, Unmet
from c2s_engine.structure.edits import Edit, EditError, RemoveObject, SetField, apply
from c2s_engine.structure.sentences import with_updated_sentences
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec
from c2s_engine.write.typed import ResolveError, contradiction

STEPS = 6
"""The most that is left out; a text that needs more is refused as it is."""


def without_contradictions(structure: Structure) -> Structure:
    """The structure without what contradicts the rest of it, which is listed as unmet. Where that does not help, the
    structure as it is: the place is looked up next, and that refuses it.
    """
    changed = structure
    for _ in range(STEPS):
        problem = contradiction(changed)
        if problem is None:
            return changed
        simpler = _simpler(changed, problem)
        if simpler is None:
            return structure
        changed = simpler
    return structure if contradiction(changed) else changed


def _simpler(structure: Structure, problem: ResolveError) -> Structure | None:
    """With one thing less, so that the contradiction is gone; else so that it is another one."""
    other = None
    for cid, what, edit in _edits(structure, problem):
        try:
            changed = apply(structure, edit)
        except EditError:
            continue
        found = contradiction(changed)
        again = found is not None and str(found) == str(problem)  # of several that are placed so, one is left out
        if again and not (isinstance(edit, SetField) and edit.path == "placement") or found and other is not None:
            continue
        changed = with_updated_sentences(structure, changed)
        where = cid if cid in changed else "R"
        unmet = Unmet(text=what, reason=f"left out, because {problem}")
        component = changed[where]
        changed = changed.with_component(component.model_copy(update={"unmet": (*component.unmet, unmet)}))
        if found is None:
            return changed
        other = changed
    return other


def _edits(structure: Structure, problem: ResolveError) -> Iterator[tuple[ComponentId, str, Edit]]:
    """What could be left out: component, in words, edit; what says least first, of whom the problem names first."""
    named = {f.split(".")[0] for f in problem.fields}
    objects = [o.id for o in reversed(structure.objects)]
    order = sorted([*objects, "E", "R"], key=lambda c: c not in named and not (c in objects and "O" in named))
    for cid in order:
        spec = structure[cid].spec
        if isinstance(spec, ObjectSpec):
            for field in ("gap", "along", "hidden_by", "facing"):
                if getattr(spec.placement, field) is not None:
                    yield cid, f"{spec.name}: {field}", SetField(component=cid, path=f"placement.{field}", value=None)
        if isinstance(spec, PlaceSpec):
            for field in ("distance", "ego_lane", "lanes", "shoulder", "oncoming", "control"):
                if getattr(spec, field) is not None:
                    yield cid, field.replace("_", " "), SetField(component=cid, path=field, value=None)
    if getattr(structure.settings.spec, "light_changes", ()):
        yield "G", "light changes", SetField(component="G", path="light_changes", value=())
    for cid in order:
        spec = structure[cid].spec
        if isinstance(spec, ObjectSpec | EgoSpec):
            for i in reversed(range(len(spec.phases))):
                kept = tuple(p for n, p in enumerate(spec.phases) if n != i)
                action = spec.phases[i].action.replace("_", " ")
                who = spec.name if isinstance(spec, ObjectSpec) else "ego"
                yield cid, f"{who}: {action}", SetField(component=cid, path="phases", value=kept)
    for cid in order:
        spec = structure[cid].spec
        if isinstance(spec, ObjectSpec) and spec.placement.position not in ("ahead", "behind"):
            words = f"{spec.name}: {spec.placement.position.replace('_', ' ')}"
            yield cid, words, SetField(component=cid, path="placement", value={"position": "ahead"})
    for cid in objects:
        yield cid, structure[cid].description or cid, RemoveObject(component=cid)

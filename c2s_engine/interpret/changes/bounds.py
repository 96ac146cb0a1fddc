"""Limits that a change demands: "ego must not brake harder than 6 m/s2". The run is judged by them."""

from c2s_engine.interpret.changes.forms import Found, name_of, quantity_of
from c2s_engine.interpret.changes.retold import read, scene
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField
from c2s_engine.structure.specs import Limit, RestrictionsSpec


def bound(clause: str, structure: Structure) -> Found | None:
    """The limit of an acceleration that the clause tells amid the scene; it replaces one of the same kind."""
    if quantity_of(clause, "acceleration") is None:
        return None
    told = read(f"{scene(structure, clause)} {clause[:1].upper()}{clause[1:]}.")
    if told is None or len(told.objects) != len(structure.objects):
        return None
    spec, old = told.restrictions.spec, structure.restrictions.spec
    assert isinstance(spec, RestrictionsSpec) and isinstance(old, RestrictionsSpec)
    ids = {a.id: b.id for a, b in zip(told.objects, structure.objects, strict=True)}
    limits = [m.model_copy(update={"subject": ids.get(m.subject, m.subject)}) for m in spec.limits]
    if not limits:
        return None
    kept = [m for m in old.limits if (m.kind, m.subject) not in {(n.kind, n.subject) for n in limits}]
    said = "; ".join(_in_words(limit, structure) for limit in limits)
    return [SetField(component="T", path="limits", value=(*kept, *limits))], said


def _in_words(limit: Limit, structure: Structure) -> str:
    who = name_of(structure["E" if limit.subject == "ego" else limit.subject])
    least = [f"at least {limit.minimum:g} m/s2"] if limit.minimum is not None else []
    most = [f"at most {limit.maximum:g} m/s2"] if limit.maximum is not None else []
    return f"{who}: {limit.kind.replace('_', ' ')} of {' and '.join([*least, *most])}"

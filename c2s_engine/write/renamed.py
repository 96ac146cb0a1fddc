"""Code by hand when an object of S is given another name: its names there are others, its comments and texts stay."""

from c2s_engine.structure import names
from c2s_engine.structure.components import ComponentId, Structure
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write import by_hand
from c2s_engine.write.typed import scope


def in_code(before: Structure, after: Structure) -> tuple[Structure, Structure, dict[ComponentId, dict[str, str]]]:
    """Both structures, in which code by hand goes by the names that objects have after an edit; by component whose code
    that changed: its names of before, each with that of now."""
    called = _called(before, after)
    changed: dict[ComponentId, dict[str, str]] = {}
    for component in (c for c in after.components if c.origin in by_hand.OWN and c.id in before):
        used = names.uses(component.code)
        if own := {old: new for old, new in called.items() if old in used}:
            code, in_step = names.renamed(component.code, own), by_hand.in_step(before, component.id)
            changed[component.id] = own
            after = after.with_component(component.model_copy(update={"code": code}))
            after = by_hand.followed(after, before, component.id, in_step)
            before = before.with_component(before[component.id].model_copy(update={"code": code}))
            before = by_hand.followed(before, before, component.id, in_step)
    return before, after, changed


def _called(before: Structure, after: Structure) -> dict[str, str]:
    """The names that code of objects defines, and what each is called once its object has another name."""
    was, now = scope.variables(before), scope.variables(after)
    found: dict[str, str] = {}
    for component in (c for c in after.objects if c.id in before and isinstance(c.spec, ObjectSpec)):
        old, new = was[component.id], now[component.id]
        was_spec = before[component.id].spec
        same = isinstance(was_spec, ObjectSpec) and was_spec.type == component.spec.type  # type: ignore[union-attr]
        if old == new or not same:
            continue
        forms = [(old, new, ""), (old.upper(), new.upper(), "_"), (scope.camel(old), scope.camel(new), "")]
        for name in names.defines(before[component.id].code):
            for one, other, after_it in forms:
                if name == one or after_it and name.startswith(one + after_it) or name == one + "Behavior":
                    found[name] = other + name.removeprefix(one)
    taken = frozenset[str]().union(*(names.defines(c.code).keys() for c in before.components))
    return {old: new for old, new in found.items() if new not in taken or new in found}

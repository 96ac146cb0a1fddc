"""Edits of S as data: chat, panes, CLI and undo share one path."""

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from c2s_engine.structure import layout
from c2s_engine.structure.components import OBJECT_ID, Assumption, Component, ComponentId, Structure, Unmet
from c2s_engine.structure.specs import AnySpec, ObjectSpec
from c2s_engine.structure.vocabulary import SIDED

SPEC_ADAPTER: TypeAdapter[AnySpec] = TypeAdapter(AnySpec)


class EditError(ValueError):
    """An edit that cannot be made; the message says why and what would do."""


class _Edit(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class SetDescription(_Edit):
    """Say a component in other words. The caller interprets the sentence and follows with SetSpec."""

    kind: Literal["description"] = "description"
    component: ComponentId
    description: str
    unmet: tuple[Unmet, ...] | None = Field(None, description="what of the sentence is in no field")


class SetSpec(_Edit):
    """Replace a component's spec (and what is assumed and unmet in it)."""

    kind: Literal["spec"] = "spec"
    component: ComponentId
    spec: AnySpec
    description: str | None = None
    assumed: tuple[Assumption, ...] | None = None
    unmet: tuple[Unmet, ...] | None = None


class SetField(_Edit):
    """Set one field of a spec by its path: `speed`, `placement.gap`, `phases.0.action`."""

    kind: Literal["field"] = "field"
    component: ComponentId
    path: str
    value: Any = None


class AddObject(_Edit):
    """Add an object; `component` names it, or the next free id is taken."""

    kind: Literal["add"] = "add"
    spec: ObjectSpec
    description: str = ""
    component: ComponentId | None = None
    unmet: tuple[Unmet, ...] = ()


class RemoveObject(_Edit):
    kind: Literal["remove"] = "remove"
    component: ComponentId


class MoveObject(_Edit):
    """Move an object to another place (0-based) in the order of writing."""

    kind: Literal["move"] = "move"
    component: ComponentId
    index: int


class SetCode(_Edit):
    """Write a fragment by hand; `code=None` gives it back to the writer."""

    kind: Literal["code"] = "code"
    component: ComponentId
    code: str | None


class SetProgram(_Edit):
    """The whole program as somebody edited it: what its lines belong to is by hand where they are others."""

    kind: Literal["program"] = "program"
    text: str


class Replace(_Edit):
    """Take a whole new S (a new text, an import)."""

    kind: Literal["replace"] = "replace"
    structure: Structure


Edit = Annotated[
    SetDescription | SetSpec | SetField | AddObject | RemoveObject | MoveObject | SetCode | SetProgram | Replace,
    Field(discriminator="kind"),
]


def apply(structure: Structure, edit: Edit) -> Structure:
    """The structure after the edit; raises EditError. Code is not written here (see regenerate.py)."""
    if isinstance(edit, Replace):
        return edit.structure
    if isinstance(edit, SetProgram):
        return layout.edited(structure, edit.text)
    if isinstance(edit, AddObject):
        cid = edit.component or structure.next_object_id()
        if cid in structure:
            raise EditError(f"there is already a component {cid}")
        added = Component(id=cid, description=edit.description, spec=edit.spec, unmet=edit.unmet)
        return structure.model_copy(update={"objects": (*structure.objects, added)})
    if edit.component not in structure:
        raise EditError(f"there is no component {edit.component}; there are {', '.join(structure.ids)}")
    if isinstance(edit, RemoveObject | MoveObject) and not edit.component.startswith("O"):
        raise EditError(f"{edit.component} is no object; only O1, O2, ... can be removed or moved")
    if isinstance(edit, RemoveObject):
        users = [c.id for c in structure.components if c.id != edit.component and edit.component in references(c)]
        if users:
            raise EditError(f"{edit.component} is referred to by {', '.join(users)}: change that first")
        kept = tuple(o for o in structure.objects if o.id != edit.component)
        return structure.model_copy(update={"objects": kept})
    component = structure[edit.component]
    if isinstance(edit, SetField):
        value = _by_id(edit.value, edit.path.rsplit(".", 1)[-1], structure, edit)
        edit = edit.model_copy(update={"value": value})
    if isinstance(edit, MoveObject):
        rest = [o for o in structure.objects if o.id != edit.component]
        rest.insert(max(0, min(edit.index, len(rest))), component)
        return layout.moved(structure.model_copy(update={"objects": tuple(rest)}), edit.component)
    return structure.with_component(_changed(component, edit))


def placed_in_order(structure: Structure) -> Structure:
    """S whose objects stand behind those that they are placed by, as a program needs it; the others keep their order.
    Objects that are placed by one another stay as they are."""
    for _ in structure.objects:
        for index, component in enumerate(structure.objects):
            later = {o.id for o in structure.objects[index + 1 :]} & _placed_by(component)
            if later and not any(component.id in _placed_by(structure[other]) for other in later):
                last = max(structure.objects.index(structure[other]) for other in later)
                structure = apply(structure, MoveObject(component=component.id, index=last))
                break
        else:
            break
    return structure


def _placed_by(component: Component) -> set[str]:
    """Whose places an object's place is told by."""
    placement = getattr(component.spec, "placement", None)
    return {cid for cid in (placement.of, placement.hidden_by) if cid} if placement is not None else set()


def _changed(component: Component, edit: SetDescription | SetSpec | SetField | SetCode) -> Component:
    if isinstance(edit, SetDescription):
        noted = {} if edit.unmet is None else {"unmet": edit.unmet}
        return component.model_copy(update={"description": edit.description, "generated": False, **noted})
    if isinstance(edit, SetCode):
        if edit.code is None:
            return component.model_copy(
                update={"code": "", "origin": "rendered", "key": "", "conflict": None, "by_hand": ""}
            )
        kept = component.conflict is not None and edit.code == component.code
        own = component.with_own_code(edit.code)
        return own.model_copy(update={"by_hand": "apart"}) if kept else own
    if isinstance(edit, SetSpec):
        if edit.spec.component != component.kind:
            raise EditError(f"a spec of {edit.spec.component} does not fit {component.id}")
        worded = edit.description is None or edit.description == component.description
        update: dict[str, Any] = {"spec": edit.spec, "generated": component.generated and worded}
        for name in ("description", "assumed", "unmet"):
            if getattr(edit, name) is not None:
                update[name] = getattr(edit, name)
        return component.model_copy(update=update)
    if edit.path == "description":
        return component.model_copy(update={"description": str(edit.value), "generated": False})
    data = component.spec.model_dump(mode="json")
    _put(data, edit.path.split("."), edit.value, edit.path)
    if edit.path == "type" and edit.value != getattr(component.spec, "type", None) and "model" in data:
        data["model"] = None  # it was one of the other type
    try:
        spec = SPEC_ADAPTER.validate_python(data)
    except ValidationError as error:
        raise EditError(f"{component.id}.{edit.path}: {refused(error, edit.value)}") from None
    if edit.path == "placement.side" and edit.value is not None and (why := no_side(spec)):
        raise EditError(f"{component.id}.{edit.path}: {why}")
    dropped = edit.path.split(".")[0]
    assumed = tuple(a for a in component.assumed if a.field.split(".")[0] != dropped)
    return component.model_copy(update={"spec": spec, "assumed": assumed})


def no_side(spec: AnySpec) -> str:
    """Why a place has no side, in words; "": it has one, or is none."""
    at = spec.placement if isinstance(spec, ObjectSpec) else None
    if at is None or at.position in SIDED:
        return ""
    where = at.position.replace("_", " ")
    return f"a place {where} has no side (those that have: {', '.join(SIDED)}): change the position first"


def refused(error: ValidationError, value: Any) -> str:
    """Why a value does not do, in plain words."""
    first = error.errors()[0]
    kind, context = first["type"], first.get("ctx", {})
    if kind == "literal_error":
        return f"{value} is not one of {context['expected']}"
    if kind in ("float_parsing", "float_type", "int_parsing", "int_type"):
        return f"{value} is no number"
    if "error" in context:
        return str(context["error"])
    return str(first["msg"]).lower()


def _put(data: Any, path: list[str], value: Any, whole: str) -> None:
    key: Any = int(path[0]) if path[0].isdigit() else path[0]
    try:
        if len(path) == 1:
            if isinstance(data, list) and key == len(data):
                data.append(value)
            elif isinstance(data, list) and value is None:
                del data[key]
            else:
                many = isinstance(data[key], list) and isinstance(value, str)  # one word for a list of them
                data[key] = [value] if many else value
            return
        if data[key] is None:
            data[key] = {}
        _put(data[key], path[1:], value, whole)
    except (KeyError, IndexError, TypeError):
        known = f"0 to {len(data)}" if isinstance(data, list) else "none"
        known = ", ".join(_names(data)) if isinstance(data, dict) else known
        raise EditError(f"there is no field {whole}: {path[0]} is not one of {known}") from None


def _names(data: dict[str, Any]) -> list[str]:
    """The fields of a spec as one names them, those of its parts by their paths."""
    inner = [f"{name}.{key}" for name, value in data.items() if isinstance(value, dict) for key in value]
    return [*(name for name in data if name != "component" and not isinstance(data[name], dict)), *inner]


def references(component: Component) -> frozenset[ComponentId]:
    """The objects that a component's spec refers to by id ('ego' counts as E)."""
    found: set[str] = set()

    def walk(value: Any, key: str = "") -> None:
        if isinstance(value, dict):
            for k, v in value.items():
                walk(v, k)
        elif isinstance(value, list | tuple):
            for v in value:
                walk(v, key)
        elif isinstance(value, str) and key in _REFERENCE_FIELDS:
            found.add("E" if value == "ego" else value)

    walk(component.spec.model_dump(exclude_defaults=True))
    return frozenset(found - {component.id})


def _by_id(value: Any, key: str, structure: Structure, edit: SetField) -> Any:
    """A field's value with ids for the names of those that it refers to, as S shows them."""
    if isinstance(value, dict):
        return {k: _by_id(v, k, structure, edit) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return type(value)(_by_id(v, key, structure, edit) for v in value)
    if key not in _REFERENCE_FIELDS or not isinstance(value, str) or value == "ego" or OBJECT_ID.fullmatch(value):
        return value
    others = {o.id: o.spec for o in structure.objects if o.id != edit.component and isinstance(o.spec, ObjectSpec)}
    wanted = value.strip().lower().replace(" ", "_").removeprefix("the_")
    if wanted in ("e", "ego"):
        return "ego"
    exact = [cid for cid, spec in others.items() if wanted in (cid.lower(), spec.name.lower())]
    found = exact or [cid for cid, spec in others.items() if wanted == spec.type]
    if len(found) == 1:
        return found[0]
    names = ", ".join(["ego", *(f"{cid} ({spec.name})" for cid, spec in others.items())])
    several = f": {value} can be {' or '.join(found)}" if found else ""
    raise EditError(f"{edit.component}.{edit.path} is one of {names}{several}")


_REFERENCE_FIELDS = {"of", "target", "react_to", "hidden_by", "subject", "other"}

"""Turns of the chat with a model: what a turn asks for, and its changes as edits of S, each component's spec by form.

What needs no model (undo, redo, no S yet) is decided without one; where it fails, the routing without a model decides.
"""

from collections.abc import Sequence
from typing import Any, get_args

from c2s_engine.interpret import turn as plain_turn
from c2s_engine.interpret.llm import fallback, rendered_sentences
from c2s_engine.interpret.llm.asking import Asker, OnEvent, prompt
from c2s_engine.interpret.llm.components import ObjectSentence, Sentences
from c2s_engine.interpret.llm.schema import limits
from c2s_engine.interpret.llm.settings import detect
from c2s_engine.interpret.llm.typed import TypedReader
from c2s_engine.interpret.llm.units import annotate
from c2s_engine.interpret.turn import Turn, TurnKind
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import ModelError
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Component, Structure, Unmet
from c2s_engine.structure.edits import AddObject, Edit, EditError, RemoveObject, SetSpec, apply
from c2s_engine.structure.objects import object_spec
from c2s_engine.structure.progress import Say
from c2s_engine.structure.specs import SPEC_OF, AnySpec, ObjectSpec

KINDS: dict[str, TurnKind] = {"question": "question", "new": "scenario", "undo": "undo", "redo": "redo", "edit": "edit"}


async def route(
    text: str,
    structure: Structure | None,
    *,
    client: OllamaClient,
    reader: Any,
    plain: Any = None,
    on_event: OnEvent | None = None,
) -> Turn:
    """What a turn asks for; never raises ModelError. S is not changed: the edits are.

    `plain`: what the routing without a model says (kind, edits, reply), where that was asked already."""
    plain = plain or plain_turn.route(text, structure)
    if structure is None or plain.kind in ("undo", "redo") or plain.kind == "scenario" and not structure.text:
        return plain
    asker = Asker(client, on_event)
    try:
        found = await asker.form(
            prompt("turn"), _asked(text, structure), turn_schema(structure), purpose="turn", build=_sensible
        )
        kind = KINDS[found["kind"]]
        if kind != "edit":
            return Turn(kind)
        edits, said = await _edits(found["changes"], structure, client, reader, on_event)
    except (ModelError, EditError) as error:
        if on_event:
            on_event(Say(text=f"The turn was read without the model. {error}", severity="warning"))
        return plain
    return Turn("edit", edits, "; ".join(said))


async def mend(
    differences: Sequence[str],
    structure: Structure,
    *,
    client: OllamaClient,
    reader: Any,
    on_event: OnEvent | None = None,
) -> list[Edit]:
    """Edits of S by which a run would show what it says, for what it did not show; raises ModelError, EditError."""
    rows = "\n".join(f"- {d}" for d in differences)
    asked = f"{_asked('', structure).removesuffix('Turn: ')}Said, but not seen:\n{rows}"
    found = await Asker(client, on_event).form(
        prompt("seen"), asked, turn_schema(structure), purpose="seen", build=_sensible
    )
    if found["kind"] != "edit":
        return []
    return (await _edits(found["changes"], structure, client, reader, on_event))[0]


def turn_schema(structure: Structure) -> dict[str, Any]:
    """The schema of the answer: only components that there are can be changed, and a change has all that it needs."""
    told = {
        "component": {"type": "string", "enum": list(structure.ids)},
        "sentence": {"type": "string", "maxLength": limits()["lengths"]["sentence"]},
        "type": {"type": "string", "enum": list(get_args(v.ObjectType))},
    }
    needed = {"change": ("component", "sentence"), "add": ("sentence", "type"), "remove": ("component",)}
    shapes = [
        {
            "type": "object",
            "properties": {"do": {"type": "string", "enum": [do]}, **told},
            "required": ["do", *names],
            "additionalProperties": False,
        }
        for do, names in needed.items()
    ]
    return {
        "type": "object",
        "properties": {
            "kind": {"type": "string", "enum": list(KINDS)},
            "changes": {"type": "array", "items": {"anyOf": shapes}, "maxItems": limits()["lengths"]["objects"]},
        },
        "required": ["kind"],
        "additionalProperties": False,
    }


def _asked(text: str, structure: Structure) -> str:
    rows = [f"{c.id}: {c.description or 'nothing is said'}" for c in structure.components]
    return "Components:\n" + "\n".join(rows) + f"\n\nTurn: {text}"


def _sensible(found: dict[str, Any]) -> dict[str, Any]:
    if found["kind"] != "edit":
        return found
    if not found.get("changes"):
        raise ValueError("an edit needs its changes")
    for change in found["changes"]:
        if change["do"] != "add" and "component" not in change:
            raise ValueError(f"to {change['do']} needs the component")
        if change["do"] != "remove" and not change.get("sentence", "").strip():
            raise ValueError(f"to {change['do']} needs the sentence")
    return found


async def _edits(
    changes: list[dict[str, Any]], structure: Structure, client: OllamaClient, reader: Any, on_event: OnEvent | None
) -> tuple[list[Edit], list[str]]:
    """The edits of a turn's changes, and what they do in words; raises ModelError or EditError."""
    edits: list[Edit] = []
    said: list[str] = []
    forms = Forms(client, reader, on_event)
    for change in changes:
        cid, sentence = change.get("component", ""), change.get("sentence", "").strip()
        if change["do"] == "add":
            cid = structure.next_object_id()
            added = ObjectSpec(type=change.get("type", "car"), name=change.get("type", "car"))
            structure = apply(structure, AddObject(spec=added, description=sentence, component=cid))
            spec, unmet = await forms.spec(cid, sentence, structure)
            made, unmet = _rendered_sentence(cid, sentence, spec, unmet, structure)
            edit: Edit = AddObject(spec=spec, description=made, component=cid)
            said.append(f"{cid} added: {sentence}")
        elif change["do"] == "remove" and cid.startswith("O"):
            edit = RemoveObject(component=cid)
            said.append(f"{cid} removed")
            structure = apply(structure, edit)
        else:
            kept = change["do"] == "change"
            spec, unmet = (await forms.spec(cid, sentence, structure)) if kept else (SPEC_OF[cid[0]](), ())
            made, unmet = _rendered_sentence(cid, sentence, spec, unmet, structure) if kept else ("", ())
            edit = SetSpec(component=cid, spec=spec, description=made, assumed=(), unmet=unmet)
            said.append(f"{cid}: {sentence}" if kept else f"{cid}: nothing is said of it any more")
            structure = apply(structure, edit)
        edits.append(edit)
    return edits, said


def _rendered_sentence(
    cid: str, sentence: str, spec: AnySpec, unmet: tuple[Unmet, ...], structure: Structure
) -> tuple[str, tuple[Unmet, ...]]:
    """The sentence of a spec that was written for a component, and what it lost of the one that was asked for."""
    component = structure[cid].model_copy(update={"spec": spec, "unmet": unmet})
    found = rendered_sentences.with_rendered_sentences(structure.with_component(component), {cid: sentence})[cid]
    return found.description, found.unmet


class Forms:
    """Single components of an S read with a model."""

    def __init__(self, client: OllamaClient, reader: Any, on_event: OnEvent | None = None) -> None:
        self.reader = TypedReader(client, reader, on_event)

    async def spec(self, cid: str, sentence: str, structure: Structure) -> tuple[Any, tuple]:
        """The spec of a sentence for a component of an S, and what is unmet; raises ModelError."""
        if cid == "G":
            found = await detect(sentence, self.reader.asker)
            return found.spec, found.unmet
        sentences, ids = numbered(structure, cid, sentence)
        spec, unmet = await self.reader.fill(ids.get(cid, cid), sentence, annotate(sentence), sentences)
        back = {mine: theirs for theirs, mine in ids.items()}
        spec = fallback.renumbered(spec, {"ego": "ego", **back})
        before = structure[cid].spec
        if isinstance(spec, ObjectSpec) and isinstance(before, ObjectSpec) and structure[cid].code:
            spec = spec.model_copy(update={"name": before.name})  # others may use the name
        return spec, unmet


def numbered(structure: Structure, cid: str, sentence: str) -> tuple[Sentences, dict[str, str]]:
    """The sentences of an S (a new one for `cid`), its objects numbered without gaps, and whose number is whose."""
    ids = {o.id: f"O{i + 1}" for i, o in enumerate(structure.objects)}

    def said(component: Component) -> str:
        return sentence if component.id == cid else component.description

    kinds = [object_spec(o).type for o in structure.objects]
    objects = tuple(
        ObjectSentence(type=kind, sentence=said(o) or kind) for kind, o in zip(kinds, structure.objects, strict=True)
    )
    plain = {"settings": structure.settings, "place": structure.place, "ego": structure.ego,
             "restrictions": structure.restrictions}  # fmt: skip
    return Sentences(objects=objects, **{name: said(c) for name, c in plain.items()}), ids

"""Answers to "why is this here?": what a component really rests on, or the rule by which it was written."""

import re

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import ObjectSpec

_ASKS = re.compile(
    r"(?:and |but |so )?(?:why\b|where (?:does|do|did) .+ come from|what (?:does|do) .+ (?:rest|depend) on)", re.I
)
_WORDS = {"G": "settings|weather|time of day|map|rain|fog|night", "R": "place|road|lane|intersection|junction|motorway",
          "E": "ego|my car|the test vehicle", "T": "restrictions?|end of the run|duration"}  # fmt: skip
_KINDS = {"text": "your words", "clause": "the source", "snippet": "the snippet", "chunk": "the documentation",
          "rule": "the rule"}  # fmt: skip

KEPT = "its hand-written code was kept: it does not match these fields"


def explained(question: str, structure: Structure) -> str:
    """The answer; empty where the question is none about why something of S is there."""
    if not _ASKS.match(question.strip()) or not any(c.code for c in structure.components):
        return ""
    asked = [c for c in structure.components if _names(question, c)]
    if not asked and re.search(r"\b(?:this|that|it|all|everything|here)\b", question, re.I):
        asked = [c for c in structure.components if c.code and (c.links or c.description)]
    return "\n".join(reason(c) for c in asked)


def reason(component: Component) -> str:
    """One sentence on what a component rests on."""
    found: dict[str, list[str]] = {}
    for link in component.links:
        found.setdefault(_KINDS[link.kind], []).append(f"“{link.label}”")
    told = "; ".join(f"{kind} {', '.join(dict.fromkeys(labels))}" for kind, labels in found.items())
    chosen = [f"{a.called} = {a.value} ({a.reason})" for a in component.assumed]
    parts = [
        f"{component.id} rests on {told}" if told else f"{component.id} rests on no words and no source",
        rule(component),
        *([f"assumed: {'; '.join(chosen)}"] if chosen else []),
    ]
    return ". ".join(p[0].upper() + p[1:] for p in parts) + "."


def rule(component: Component) -> str:
    """By what its code came to be."""
    if component.origin == "by_hand":
        return KEPT if component.by_hand == "apart" else "its code was written by hand"
    if component.origin == "imported":
        return "its code was imported"
    if component.origin == "generated":
        sources = [link for link in component.links if link.kind in ("snippet", "chunk")]
        return "its code was written by a model" + ("" if sources else ", and no retrieved passage shows in it")
    spec = component.spec.model_dump(exclude_defaults=True, exclude={"component", "name"}, mode="json")
    if not spec:
        return "its code is the typed writer's default"
    fields = ", ".join(_path(name, value) for name, value in spec.items())
    return f"its code was rendered by the typed writer's rules for {fields}"


def _path(name: str, value: object) -> str:
    if name == "phases" and isinstance(value, list):
        return "phases " + " then ".join(str(p.get("action", "")) for p in value)
    if isinstance(value, dict):
        return f"{name} {' '.join(str(v) for v in value.values())}"
    return f"{name} {value}"


def _names(question: str, component: Component) -> bool:
    """Whether a question names the component: by id, by its name or type, or by what its kind is called."""
    if re.search(rf"\b{component.id}\b", question):
        return True
    if isinstance(component.spec, ObjectSpec):
        words = {component.spec.name, component.spec.type, component.spec.type.replace("_", " ")}
        return any(re.search(rf"\b{re.escape(w)}s?\b", question, re.I) for w in words)
    return bool(re.search(rf"\b(?:{_WORDS[component.kind]})\b", question, re.I))

"""A dossier as plain data: what all its forms (Markdown, HTML, JSON) show, in SI units where no unit is named."""

import hashlib
import json
from importlib.metadata import version
from typing import Any

from c2s_engine.report.material import Material
from c2s_engine.report.moments import Moment, moments
from c2s_engine.report.tracks import rows
from c2s_engine.require import evaluate, require
from c2s_engine.require.measured import extremes
from c2s_engine.require.measures import pairs
from c2s_engine.structure.account import account
from c2s_engine.structure.components import Component
from c2s_engine.structure.requirements import Result


def dossier(material: Material, blind: bool = False) -> dict[str, Any]:
    """The whole dossier. `blind`: without what tells who wrote the program and how this project scores it."""
    facts, ways = material.facts, material.ways
    shown = {
        "id": material.id,
        "matters": material.matters,
        "text": material.text,
        "changes": list(material.changes),
        "account": [
            {**c.model_dump(mode="json"), "reason": c.reason} for c in account(material.structure, material.idle)
        ],
        "structure": [_component(c) for c in material.structure.components],
        "problem": material.problem,
        "faults": [] if blind else [f"{d.stage}: {d.message}" for d in material.faults],
        "moments": [{"time": m.time, "what": m.what} for m in decisive(material)],
        "surroundings": _surroundings(material),
        "timeline": _timeline(material),
        "criticality": [extremes(p).model_dump() for p in pairs(ways)] if ways else [],
        "tracks": rows(ways) if ways else [],
        "program": material.program.text,
        "run": {"seed": facts.seed, "duration": facts.duration, "ended_by": facts.ended_by} if facts else None,
    }
    if blind:
        return shown
    return {
        **shown, "origin": material.origin, "requirements": _requirements(material),
        "drivers": [d.model_dump(mode="json") for d in material.drivers], "digests": _digests(material),
    }  # fmt: skip


def decisive(material: Material) -> list[Moment]:
    """The moments that are pictured; none where nothing ran."""
    if material.facts is None or material.ways is None or not material.ways.tracks:
        return []
    return moments(material.structure, material.facts, material.ways)


def _component(component: Component) -> dict[str, Any]:
    return {
        "id": component.id,
        "description": component.description,
        "spec": component.spec.model_dump(mode="json", exclude_defaults=True, exclude={"component"}),
        "origin": component.origin,
        "sources": [{"kind": li.kind, "label": li.label} for li in component.links if li.kind not in ("text", "rule")],
        "assumed": [a.model_dump(mode="json") for a in component.assumed],
        "unmet": [{"text": u.text, "reason": u.reason} for u in component.unmet],
    }


def _requirements(material: Material) -> list[dict[str, Any]]:
    """What S requires of a run, and what this one showed of it; without a run, none of it was reached."""
    asked = require(material.structure)
    if material.facts is None or material.ways is None:
        results = [Result(requirement=r.id, holds=None, robustness=None, said=r.text, why="not judged") for r in asked]
    else:
        judged = {r.requirement: r for r in material.results}
        alone = evaluate(asked, material.facts, material.ways) if any(r.id not in judged for r in asked) else ()
        results = list(alone or (judged[r.id] for r in asked))
    return [
        {**result.model_dump(mode="json"), "kind": asks.kind, "component": asks.component, "text": asks.text}
        for asks, result in zip(asked, results, strict=True)
    ]


def _surroundings(material: Material) -> dict[str, Any]:
    """The road on ego's path, light, weather and things at the road, as the run had them."""
    facts = material.facts
    if facts is None:
        return {}
    road = facts.road.model_dump(mode="json")
    shown = {
        **{k: v for k, v in road.items() if v not in (False, None, "none")},
        "ego's light when it first comes within 30 m": facts.light,
        "on ego's path": ", ".join(facts.infrastructure),
        "roadworks": ", ".join(facts.temporary),
        "weather": ", ".join(facts.weather),
        "time of day": " or ".join(facts.time),
    }
    return {k.replace("_", " "): v for k, v in shown.items() if v not in (None, "")}


def _timeline(material: Material) -> list[dict[str, Any]]:
    facts = material.facts
    found = [(e.time, o.name, e.event, e.other or "") for o in facts.objects for e in o.events] if facts else []
    return [{"time": t, "who": w, "event": e, "other": o} for t, w, e, o in sorted(found)]


def _digests(material: Material) -> dict[str, str]:
    structure = material.structure.model_dump(mode="json", exclude={"objects": {"__all__": {"key"}}})
    ways = material.ways.model_dump(mode="json", exclude={"outline"}) if material.ways else None
    found = {
        "c2s": version("c2s"),
        "scenic": version("scenic"),
        "map": " ".join(w for w in (material.map_name, material.map_digest) if w),
        "text": digest(material.text),
        "S": digest(json.dumps(structure, sort_keys=True)),
        "program": digest(material.program.text),
        "tracks": digest(json.dumps(ways, sort_keys=True)) if ways else "",
        "seed": str(material.seed),
    }
    return {k: v for k, v in found.items() if v}


def digest(text: str) -> str:
    """The first 16 digits of a text's SHA-256."""
    return hashlib.sha256(text.encode()).hexdigest()[:16]

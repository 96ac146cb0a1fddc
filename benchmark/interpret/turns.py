"""Turns upon a scene: does the change that somebody types touch what was meant, and nothing else?

`scenes.yaml` holds the scenes as S, so that only the reading of the turn is judged; `turns.yaml` what is typed and what
S must say afterwards (keys: COMPONENT.path; a value, [low, high], {any: [...]}, {has: x}, {lacks: x}).
"""

from functools import cache
from pathlib import Path
from typing import Any

import yaml

from c2s_bench.interpret.score import Verdict
from c2s_engine.interpret.turn import route
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import SPEC_ADAPTER, EditError, apply
from c2s_engine.structure.quantity import high, low

HERE = Path(__file__).parent
STAGE = "turns"


@cache
def scenes() -> dict[str, Structure]:
    """The scenes by name."""
    found = {}
    for name, entry in yaml.safe_load((HERE / "scenes.yaml").read_text(encoding="utf-8")).items():
        parts = {cid: _component(cid, data) for cid, data in entry["components"].items()}
        objects = tuple(c for cid, c in parts.items() if cid.startswith("O"))
        found[name] = Structure(
            text=entry["text"], settings=parts["G"], place=parts["R"], ego=parts["E"], objects=objects
        )
    return found


def _component(cid: str, data: dict[str, Any]) -> Component:
    spec = SPEC_ADAPTER.validate_python({"component": cid[0], **data["spec"]})
    return Component(id=cid, description=data["says"], spec=spec)


def judge(entry: dict[str, Any]) -> list[Verdict]:
    """All verdicts on one turn: what is expected, and that the rest stays."""
    before = after = scenes()[entry["scene"]]
    turn = route(entry["turn"], before)
    expect = entry["expect"]
    if isinstance(expect, str) or turn.kind != "edit":
        wanted = expect if isinstance(expect, str) else "edit"
        verdict = Verdict(STAGE, turn.kind == wanted, f"taken for: {turn.kind}, not {wanted}")
        return [verdict] * (1 if isinstance(expect, str) else len(expect))
    for edit in turn.edits:
        try:
            after = apply(after, edit)
        except EditError as error:
            return [Verdict(STAGE, False, str(error))]
    new = next((cid for cid in after.ids if cid not in before), None)
    verdicts = [
        Verdict(STAGE, _holds(key, wanted, after, new), f"{key}: {wanted}")
        for key, wanted in expect.items()
        if wanted != {"may": "change"}
    ]
    named = {key.split(".")[0] for key in expect}
    place_too = new is not None and "new" in named
    for cid in before.ids:
        same = cid in after and after[cid].spec == before[cid].spec
        if not same and cid not in named and not (cid == "R" and place_too):
            verdicts.append(Verdict(STAGE, False, f"{cid} is another, too"))
    if len(after.ids) > len(before.ids) and "new" not in named:
        verdicts.append(Verdict(STAGE, False, "there is a new one"))
    return verdicts


def _holds(key: str, wanted: Any, after: Structure, new: str | None) -> bool:
    cid, _, path = key.partition(".")
    cid = (new or "") if cid == "new" else cid
    if wanted == "gone" or cid not in after:
        return wanted == "gone" and cid not in after
    spec: Any = after[cid].spec
    if path == "actions":
        return _fits([p.action for p in spec.phases], wanted)
    if path.startswith("trigger"):
        spec = next((p.trigger for p in spec.phases if p.trigger), None)
        path = path.partition(".")[2]
    for name in path.split(".") if path else ():
        if isinstance(spec, tuple | list):
            spec = spec[int(name)] if name.isdigit() and int(name) < len(spec) else None
        else:
            spec = getattr(spec, name, None)
    return _fits(list(spec) if isinstance(spec, tuple) else spec, wanted)


def _fits(found: Any, wanted: Any) -> bool:
    if isinstance(wanted, dict):
        if "any" in wanted:
            return any(_fits(found, w) for w in wanted["any"])
        if "has" in wanted:
            return wanted["has"] in (found or ())
        return wanted["lacks"] not in (found or ())
    numbers = isinstance(wanted, list) and len(wanted) == 2 and all(isinstance(w, int | float) for w in wanted)
    if numbers and isinstance(found, int | float | list) and not isinstance(found, bool):
        return low(found) >= wanted[0] - 0.05 and high(found) <= wanted[1] + 0.05  # type: ignore[arg-type]
    if isinstance(wanted, float) and isinstance(found, int | float):
        return abs(found - wanted) < 0.05
    return bool(found == wanted)

"""The lines that close a turn in the chat."""

from collections import Counter

from c2s_engine.structure.account import requirements_met
from c2s_engine.structure.components import given_up
from c2s_engine.structure.requirements import failures, tally
from c2s_tui.desk import Desk

FAR = {"compile": "compiles", "sample": "samples", "run": "runs"}
"""How far a program came, by the last stage that it passed."""
MISSED = 6
"""Lines of what was not seen that a turn's closing line shows."""


def summary(desk: Desk, back: str = "") -> tuple[str, str]:
    """What was rewritten (or `back`: where in the history a turn led), how far it came, what was seen; and whether that
    is a note, a warning or an error."""
    if desk.stale and not desk.rewritten:
        return "", "note"
    new = [c for c in desk.structure.components if c.origin == "by_hand" and c.code.strip() not in desk.before]
    own = [c.id for c in new if c.id not in desk.rewritten]
    origins = {c.id: c.origin for c in desk.structure.components}
    changed = [cid for cid in desk.rewritten if origins.get(cid) in ("by_hand", "imported")]
    written = [cid for cid in desk.rewritten if cid not in changed]
    kinds = ((own, "by hand"), (changed, "changed in your code"), (written, "written"))
    done = [f"{', '.join(ids)} {what}" for ids, what in kinds if ids]
    parts = [back] if back else done or ["nothing rewritten"]
    failed = next((s for s in desk.stages if not s.ok), None)
    hits = [f"{str(c)[0].upper()}{str(c)[1:]}." for c in desk.collisions]
    if failed is not None:
        first = next((d for d in failed.diagnostics if d.severity == "error"), None)
        where = f" ({first.component})" if first and first.component else ""
        parts.append(f"{failed.name} failed{where}: {first.message}" if first else f"{failed.name} failed")
        if first and first.fix:
            parts.append(f"fix: {first.fix}")
    elif desk.stages:
        passed = [FAR[s.name] for s in desk.stages if s.name in FAR]
        parts += passed[-1:]
    seen, required = tally(desk.results)
    if required:
        parts.append(f"{requirements_met(desk.structure, desk.results, desk.idle)}{_fewer(desk)}")
    left = given_up(desk.structure)
    if left and desk.stages:
        parts.append(f"changed from the text: {', '.join(left)}")
    if desk.seconds:
        parts.append(f"{desk.seconds:.1f} s")
    unasked = any(c.said is False for c in desk.collisions)
    kind = "error" if failed is not None or unasked else "warning" if required and seen < required or left else "note"
    missed = failures(desk.requirements, desk.results)
    return "\n".join([*hits, "; ".join(parts), *missed[:MISSED]]), kind


def _fewer(desk: Desk) -> str:
    """Of which components that are still there fewer requirements are made than before; of code by hand, why. Those of
    another description are no measure."""
    if desk.text_before not in (None, desk.structure.text):
        return ""
    before, now = (Counter(r.component for r in asked) for asked in (desk.required_before, desk.requirements))
    fewer = {c.id: before[c.id] - now[c.id] for c in desk.structure.components if before[c.id] > now[c.id]}
    if not fewer:
        return ""
    hand = [cid for cid in fewer if desk.structure[cid].origin == "by_hand"]
    why = f"; of {', '.join(hand)}, by hand, only what is read from the code" if hand else ""
    return f" ({', '.join(f'{n} fewer of {cid}' for cid, n in fewer.items())} than before{why})"

"""The speeds that are reached where a text says by how much, or to which part, a speed changes."""

from c2s_engine.interpret.what.event import Event
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import Phase


def changed(events: list[Event], phases: list[Phase], speed: float | tuple[float, float] | None) -> list[Phase]:
    """The phases with the speeds that are told by how much they change: "slows by 30 percent" from 20 m/s to 14."""
    found = list(phases)
    for event in events:
        told = next((q for q in event.quantities if q["dimension"] == "change"), None)
        at = next((i for i, p in enumerate(found) if p.action == event.act and p.speed is None), None)
        if told is None or at is None or speed is None:
            continue
        before = next((p.speed for p in reversed(found[:at]) if p.speed is not None), speed)
        goal = middle(before) * told["times"] + told["more"]
        found[at] = found[at].model_copy(update={"speed": round(max(0.5, goal), 2)})
    return found

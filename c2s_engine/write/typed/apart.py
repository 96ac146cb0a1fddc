"""Nobody starts inside another: where a gap is open it is set so, else S is refused with the fields to change."""

from collections.abc import Iterator

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.typed import stations
from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.layout import clashes, draws
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.planning import make_plan
from c2s_engine.write.typed.tables import APPROACH_ANGLE
from c2s_engine.write.typed.usual import has_marking, uses_crosswalk

OFTEN = 0.5
"""The share of drawings in which two may overlap: the sampler finds one of the others soon."""
STEP = 2.0
FURTHEST = 60.0
"""m by which an open gap grows, in steps."""
ROOM = 1.0
"""m between two that were set apart."""


def apart(structure: Structure, said: Structure | None = None) -> Structure:
    """S with open gaps such that nobody starts inside another; raises ResolveError where none does that. `said`: S
    before gaps that it leaves open were solved for; those may grow, too."""
    for _ in range(2 * len(structure.objects)):
        plan = make_plan(structure)
        found = clashes(draws(structure, plan))
        pair = next((p for p, share in found.items() if share > OFTEN), None)
        if pair is None:
            return structure
        changed = _set_off(structure, said or structure, plan, pair, sum(found.values()))
        if changed is None:
            raise _refusal(structure, pair)
        structure = changed
    found = clashes(draws(structure, make_plan(structure)))
    if found and max(found.values()) > OFTEN:
        raise _refusal(structure, max(found, key=lambda p: found[p]))
    return structure


def _set_off(
    structure: Structure, said: Structure, plan: Plan, pair: tuple[str, str], clashing: float
) -> Structure | None:
    """With the gap of one of the two, or of one that they are placed by, so that they are clear of each other."""
    for cid in _movable(said, pair):
        spec = structure[cid].spec
        assert isinstance(spec, ObjectSpec)
        start = _now(cid, spec, plan)
        for n in range(1, int(FURTHEST / STEP) + 1):
            placement = spec.placement.model_copy(update={"gap": round(start + STEP * n, 1)})
            changed = spec.model_copy(update={"placement": placement})
            moved = structure.with_spec(cid, changed)
            drawn = draws(moved, plan)
            if pair not in clashes(drawn, ROOM) and sum(clashes(drawn).values()) < clashing:
                return moved
    return None


def _movable(structure: Structure, pair: tuple[str, str]) -> Iterator[str]:
    """Those of the two whose gap S leaves open, the later one first, and then those that they are placed by."""
    waiting, seen = [pair[1], pair[0]], set[str]()
    while waiting:
        cid = waiting.pop(0)
        if cid == "ego" or cid in seen:
            continue
        seen.add(cid)
        spec = structure[cid].spec
        assert isinstance(spec, ObjectSpec)
        if spec.placement.gap is None:
            yield cid
        waiting += [spec.placement.of, *([spec.placement.hidden_by] if spec.placement.hidden_by else [])]


def _now(cid: str, spec: ObjectSpec, plan: Plan) -> float:
    """The gap at which it starts as things are, m."""
    if has_marking(plan.place) and uses_crosswalk(spec):
        return middle(plan.distance or 0.0)
    if spec.placement.position in APPROACH_ANGLE:
        return middle(stations.to_junction(cid, spec, plan))
    if spec.placement.position == "intersection_exit":
        return middle(stations.exit_gap(spec, plan))
    return middle(stations.gap(spec, plan)) if stations.along(spec) else 0.0


def _refusal(structure: Structure, pair: tuple[str, str]) -> ResolveError:
    """In S's terms: who starts inside whom, and what to change."""
    first, last = pair
    fields = [f"{cid}.placement.{_open(structure, cid)}" for cid in dict.fromkeys((last, first)) if cid != "ego"]
    counted = [cid for cid in dict.fromkeys(pair) if cid != "ego" and getattr(structure[cid].spec, "count", 1) > 1]
    fields += [f"{cid}.{name}" for cid in counted for name in ("count", "spacing")]
    who = f"the members of {first} start inside each other" if first == last else f"{last} starts inside {first}"
    return ResolveError(f"{who} wherever they are drawn: change {' or '.join(fields)}", tuple(fields))


def _open(structure: Structure, cid: str) -> str:
    """The field of an object's placement that would move it."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    return "gap" if stations.along(spec) or spec.placement.gap is not None else "along"

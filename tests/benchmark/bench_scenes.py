"""Hand-made facts of a rollout, and records to score them by."""

from pathlib import Path
from typing import Any

import yaml

from c2s_bench.records import Record
from c2s_engine.structure.facts import EGO, EventFact, ObjectFacts, RoadFacts, RunFacts, StartFact

SUPERTYPES = {
    "car": "vehicle", "truck": "vehicle", "van": "vehicle", "bus": "vehicle", "motorcycle": "vehicle",
    "pedestrian": "vru", "bicycle": "vru",
}  # fmt: skip


def record(expect: str, identity: str = "own-01") -> Record:
    """A record that expects that YAML."""
    return Record(identity, "own", "A text.", {}, yaml.safe_load(expect), "", Path("own.yaml"), 1, False)


def thing(
    name: str,
    kind: str = "car",
    *,
    does: tuple[str | tuple[str, str], ...] = (),
    ahead_of_ego: tuple[str, str, float] | None = None,
    moves: bool = True,
    **more: Any,
) -> ObjectFacts:
    """An object; `ahead_of_ego` is its relation, lane and gap (m) to ego; `does` are events, some with the other."""
    pairs = [(e, None) if isinstance(e, str) else e for e in does]
    starts = dict(more.pop("starts", {}))
    if ahead_of_ego:
        relation, lane, gap = ahead_of_ego
        starts[EGO] = StartFact(relations=(relation,), lanes=(lane,), gap=gap)
    return ObjectFacts(
        name=name,
        types=(kind, SUPERTYPES[kind]) if kind in SUPERTYPES else (kind,),
        length=4.5,
        width=1.9,
        moves=moves,
        starts=starts,
        events=tuple(EventFact(event=e, time=1.0, other=o) for e, o in pairs),
        **more,
    )


def run(*objects: ObjectFacts, ego: ObjectFacts | None = None, **more: Any) -> RunFacts:
    """A rollout with those objects that ran to its end."""
    values: dict[str, Any] = {"seed": 0, "duration": 20.0, "ended_by": "time", "road": RoadFacts(), **more}
    return RunFacts(objects=(ego or thing(EGO, does=("keep_lane",)), *objects), **values)

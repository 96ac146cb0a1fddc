"""What a run would have shown by an earlier end: the same run, cut. It tells which length is worth a run of its own."""

from collections.abc import Sequence

from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import Course, RunFacts, Track, Trajectories
from c2s_engine.structure.requirements import Run
from c2s_engine.structure.specs import RestrictionsSpec


def ended_earlier(structure: Structure, other: Structure, runs: Sequence[Run]) -> list[Run]:
    """What runs of `other` show of `structure`, where all that sets it apart is that it ends while they go on; else
    nothing."""
    spec, was = structure.restrictions.spec, other.restrictions.spec
    if not isinstance(spec, RestrictionsSpec) or not isinstance(was, RestrictionsSpec) or spec.duration is None:
        return []
    same = spec.model_copy(update={"duration": was.duration}) == was
    rest = [c.spec for c in structure.components if c.id != "T"] == [c.spec for c in other.components if c.id != "T"]
    earlier = all(spec.duration <= run.facts.duration for run in runs)
    return [_cut(run, spec.duration) for run in runs] if same and rest and earlier else []


def _cut(run: Run, seconds: float) -> Run:
    facts = run.facts
    objects = tuple(
        o.model_copy(update={"events": tuple(e for e in o.events if e.time <= seconds), "line": None})
        for o in facts.objects
    )
    contacts = tuple(c for c in facts.contacts if c.time <= seconds)
    ended: RunFacts = facts.model_copy(update={"duration": seconds, "ended_by": "terminated", "objects": objects,
                                               "contacts": contacts})  # fmt: skip
    return Run(facts=ended, trajectories=_ways(run.trajectories, seconds))


def _ways(ways: Trajectories, seconds: float) -> Trajectories:
    count = round(seconds / ways.step) + 1
    lights = tuple(change for change in ways.lights if change[0] <= seconds)
    tracks = tuple(_track(track, count, seconds) for track in ways.tracks)
    return ways.model_copy(update={"tracks": tracks, "lights": lights})


def _track(track: Track, count: int, seconds: float) -> Track:
    course = track.course and _course(track.course, seconds)
    values = {name: getattr(track, name)[:count] for name in ("x", "y", "heading", "speed")}
    return track.model_copy(update={**values, "course": course})


def _course(course: Course, seconds: float) -> Course:
    count = round(seconds / course.every) + 1
    values = {name: getattr(course, name)[:count] for name in ("along", "aside", "ego_along", "ego_aside")}
    stays = tuple(stay for stay in course.stays if stay.time <= seconds)
    sight = tuple(change for change in course.sight if change[0] <= seconds)
    return course.model_copy(update={**values, "stays": stays, "sight": sight})

"""What a run showed, in the vocabulary of FORMAT.md. The definitions and thresholds stand in data/events.yaml."""

from c2s_engine.dryrun.events.courses import contacts, courses
from c2s_engine.dryrun.events.environment import weather_and_time
from c2s_engine.dryrun.events.junctions import junctions
from c2s_engine.dryrun.events.kinds import types_of
from c2s_engine.dryrun.events.lanes import lanes
from c2s_engine.dryrun.events.meetings import Meetings
from c2s_engine.dryrun.events.motion import held_speed, motion
from c2s_engine.dryrun.events.pairs import pairs
from c2s_engine.dryrun.events.road import EgoPath
from c2s_engine.dryrun.events.situation import Seen, Situation
from c2s_engine.dryrun.events.starts import hidden_behind, starts
from c2s_engine.dryrun.events.vru import vru
from c2s_engine.dryrun.events.works import temporary
from c2s_engine.dryrun.recording import Recording
from c2s_engine.dryrun.roads import RoadIndex
from c2s_engine.maps.extras import MapExtras
from c2s_engine.structure.facts import Course, ObjectFacts, RunFacts


def derive(recording: Recording, index: RoadIndex, extras: MapExtras | None) -> RunFacts:
    """The facts of a run that came to its end (the runner fills in how it ended)."""
    return facts_of(Situation(recording, index, extras))


def with_courses(
    recording: Recording, index: RoadIndex, extras: MapExtras | None
) -> tuple[RunFacts, dict[str, Course]]:
    """The same, with the course of each object by its name."""
    situation = Situation(recording, index, extras)
    return facts_of(situation), courses(situation)


def facts_of(situation: Situation) -> RunFacts:
    """What a run on its roads showed."""
    recording = situation.recording
    meetings = Meetings(situation)
    path = EgoPath(situation)
    weather, time = weather_and_time(recording.params.get("weather"))
    return RunFacts(
        seed=0,
        duration=(recording.steps - 1) * recording.step,
        ended_by="time",
        road=path.facts(),
        light=path.light(),
        infrastructure=path.infrastructure(),
        speed_limits_kmh=path.limits(),
        temporary=temporary(path),
        weather=weather,
        time=time,
        objects=tuple(_object(seen, situation, meetings) for seen in situation.objects),
        contacts=contacts(situation),
    )


def _object(seen: Seen, situation: Situation, meetings: Meetings) -> ObjectFacts:
    events = [*motion(seen, situation), *lanes(seen, situation), *junctions(seen, situation), *vru(seen, situation)]
    others = [o for o in situation.objects if o is not seen]
    for other in others:
        events += pairs(seen, other, situation, meetings)
    path = seen.path
    return ObjectFacts(
        name=seen.name,
        types=types_of(path),
        blueprint=path.blueprint,
        length=round(path.length, 3),
        width=round(path.width, 3),
        height=round(path.height, 3),
        moves=seen.moves,
        held_speed=held_speed(seen),
        starts={o.name: starts(seen, o, situation) for o in others},
        hidden_behind=hidden_behind(seen, situation),
        events=tuple(sorted(events, key=lambda e: (e.time, e.event, e.other or ""))),
    )

"""From a text, a session or a program to the material of its dossier, with the engine's own turns and checks."""

import contextlib
import hashlib
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml
from pydantic import ValidationError

from c2s_engine.api import Engine
from c2s_engine.maps.library import NAMED, MapNotFound
from c2s_engine.report.material import Material, ReportError, problem_of
from c2s_engine.saving import followed, spans, taken
from c2s_engine.structure.components import Component, Link, Structure, Unmet
from c2s_engine.structure.edits import SPEC_ADAPTER
from c2s_engine.structure.facts import Trajectories
from c2s_engine.structure.program import Program
from c2s_engine.structure.progress import Finished, ProgramChanged, RunDone, Say
from c2s_engine.structure.sentences import described
from c2s_engine.structure.specs import SPEC_OF

_FOLDER_NAME = re.compile(r"[A-Za-z0-9][\w.-]{0,79}")


@dataclass(frozen=True)
class TextRecord:
    """A text with its id, what matters most to who wrote it, and S where somebody wrote that by hand."""

    id: str
    text: str
    matters: str = ""
    structure: Structure | None = None


def read_records(file: Path) -> list[TextRecord]:
    """The texts of a YAML list of maps with `id` and `text` (and `structure`: S by component, `O1: {type: car}`);
    raises ReportError naming every entry that is not one."""
    try:
        items = yaml.safe_load(file.read_text(encoding="utf-8"))
    except UnicodeDecodeError:
        raise ReportError(f"{file} is no text in UTF-8: save it as UTF-8.") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f", line {mark.line + 1}" if mark else ""
        raise ReportError(f"{file}{where} is no YAML: give a list of maps with `id` and `text`.") from None
    if not isinstance(items, list) or not items:
        raise ReportError(f"{file} holds no list of records: give a YAML list of maps with `id` and `text`.")
    problems = list(_problems(items))
    if problems:
        raise ReportError(f"{file}: {'; '.join(problems[:8])}.")
    return [_record_from(item) for item in items]


def _record_from(item: dict[str, Any]) -> TextRecord:
    text = str(item["text"]).strip()
    structure = structure_of(item["structure"], text) if item.get("structure") else None
    return TextRecord(str(item["id"]), text, str(item.get("matters") or "").strip(), structure)


def structure_of(components: dict[str, Any], text: str) -> Structure:
    """S from plain data by component (specs as in docs/VOCABULARY.md, SI units; `unmet`: what they cannot say, a list);
    raises ReportError naming the field that does not fit."""
    found = Structure(text=text)
    for cid, data in components.items():
        if str(cid)[:1] not in SPEC_OF or not isinstance(data, dict):
            raise ReportError(f"{cid} is no component of S: give G, R, E, O1, O2, ..., T as maps of fields.")
        fields = {k: v for k, v in data.items() if k != "unmet"}
        try:
            component = Component(
                id=cid,
                spec=SPEC_ADAPTER.validate_python({"component": str(cid)[:1], **fields}),
                links=(Link(kind="text", label=text, span=(0, len(text))),),
                unmet=tuple(Unmet(text=str(u), reason="S has no words for it") for u in data.get("unmet") or ()),
            )
        except ValidationError as error:
            first = error.errors()[0]
            raise ReportError(f"{cid}.{'.'.join(map(str, first['loc'][1:]))}: {first['msg']}.") from None
        found = found.with_component(component) if cid in found else _added(found, component)
    return described(found)


def _added(structure: Structure, component: Component) -> Structure:
    return structure.model_copy(update={"objects": (*structure.objects, component)})


def _problems(items: list[Any]) -> Iterator[str]:
    seen: set[str] = set()
    for number, item in enumerate(items, 1):
        if not isinstance(item, dict) or not isinstance(item.get("text"), str) or not item["text"].strip():
            yield f"record {number} has no text"
            continue
        name = str(item.get("id") or "")
        if not _FOLDER_NAME.fullmatch(name):
            yield f"record {number} needs an id of letters, digits, '-', '_' and '.', not {name!r}"
        elif name in seen:
            yield f"the id {name} is used twice"
        seen.add(name)


async def of_text(
    engine: Engine, told: TextRecord, *, method: str | None = None, seed: int = 0, drivers: bool = False
) -> Material:
    """A text that is generated and run now; with other `drivers` in ego's place, too."""
    done: Finished | None = None
    ways: Trajectories | None = None
    said = ""
    turn = (
        engine.generate(told.text, method=method, seed=seed, trajectories=True) if told.structure is None
        else engine.realise(told.structure, method=method, seed=seed, trajectories=True)
    )  # fmt: skip
    async for event in turn:
        if isinstance(event, ProgramChanged):
            ways = None  # what ran before was another program
        elif isinstance(event, RunDone) and ways is None:
            ways = event.trajectories
        elif isinstance(event, Say) and event.severity == "error":
            said = event.text
        elif isinstance(event, Finished):
            done = event
    if done is None:
        problem = said or "No program could be made from the text."
        return Material(id=told.id, text=told.text, matters=told.matters, problem=problem)
    read_here = told.structure is None and done.structure.text
    idle = await engine.without_effect(told.text, done.structure) if read_here else ()
    facts = done.facts[0] if done.facts else None
    name, folder = done.details.get("map") or "", done.details.get("folder")
    others = (
        await engine.other_drivers(done.structure, map=name, room=done.details.get("room", 1.0), seed=seed)
        if drivers and facts is not None and name else ()
    )  # fmt: skip
    return Material(
        id=told.id, text=told.text, matters=told.matters, origin=f"method {method or engine.settings.method}",
        structure=done.structure, idle=idle, program=done.program, faults=done.diagnostics, facts=facts, ways=ways,
        results=done.results, drivers=others, seed=seed,
        map_name=name, map_digest=_digest_of(done.program, folder), problem=problem_of(done.diagnostics, facts),
    )  # fmt: skip


async def of_program(engine: Engine, file: Path, text: str, *, seed: int = 0) -> Material:
    """A Scenic program; its S is the one that was saved with it, else what is recognised in it. Raises CheckError where
    it cannot be parsed."""
    from c2s_engine.session.reader import Unreadable

    edits = taken(file, text)
    structure = await followed(engine, edits) if edits else await engine.import_program(text, file.name)
    found = await _run(engine, Program(text=text, spans=spans(edits)), str(file.resolve().parent), file.name, seed)
    origin = f"program {file.name}, S {'saved with it' if edits else 'recognised in it'}"
    idle: Sequence[Unmet] = ()
    if structure.text.strip():
        with contextlib.suppress(Unreadable):
            idle = await engine.without_effect(structure.text, structure)
    return Material(id=file.stem, text=structure.text, origin=origin, structure=structure, idle=tuple(idle), **found)


async def of_session(engine: Engine, name: str, *, seed: int = 0) -> Material:
    """A session as it stands, run now; raises ReportError and SessionError."""
    from c2s_engine.session.reader import Unreadable
    from c2s_engine.session.sessions import Sessions

    session = Sessions().open(name, engine, create=False)
    try:
        structure, program, folder = session.structure, session.program, session.details.get("folder")
        later = [t for t in session.history if not t.asked and t.text != structure.text]
        changes = tuple(t.text if t.kind == "say" else t.summary for t in later)
        idle = session.idle
        if idle is None:
            with contextlib.suppress(Unreadable):
                idle = await session.without_effect()
    finally:
        session.close()
    if not program.text.strip():
        raise ReportError(f"The session {name!r} has no program yet: say a scenario in it first.")
    found = await _run(engine, program, folder or _folder(engine, program), "program.scenic", seed)
    identity = re.sub(r"[^\w.-]+", "-", name).strip("-.") or "session"
    return Material(
        id=identity, text=structure.text, origin=f"session {name}", structure=structure, idle=idle or (),
        changes=changes if structure.text else (), **found
    )


async def _run(engine: Engine, program: Program, folder: str | None, filename: str, seed: int) -> dict[str, Any]:
    report = await engine.check(
        program.text, spans=program.spans, upto="run", seed=seed, trajectories=True, folder=folder, filename=filename
    )
    faults = tuple(d for s in report.stages for d in s.diagnostics)
    facts = report.facts[0] if report.facts else None
    named = NAMED.search(program.text)
    return {
        "program": program,
        "faults": faults,
        "facts": facts,
        "ways": report.trajectories[0] if report.trajectories else None,
        "seed": seed,
        "map_name": Path(named[1]).name if named else "",
        "map_digest": _digest_of(program, folder),
        "problem": problem_of(faults, facts),
    }


def _folder(engine: Engine, program: Program) -> str | None:
    """Where the map of a session's program lies."""
    try:
        found = engine.library.named_in(program.text)
        return str(engine.library.working_copy(found).parent) if found else None
    except MapNotFound:
        return None


def _digest_of(program: Program, folder: str | None) -> str:
    """The digest of the map that a program names; empty where its file is not there."""
    named = NAMED.search(program.text)
    file = Path(folder or ".") / f"{named[1]}.xodr" if named else None
    return hashlib.sha256(file.read_bytes()).hexdigest()[:16] if file is not None and file.is_file() else ""

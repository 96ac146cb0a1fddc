"""The one orchestrator: a LangGraph graph whose nodes are thin over `steps`. The state is plain data, so that a
checkpointer can keep it; typed progress events go out on the custom stream.
"""

from typing import Any, TypedDict

from langgraph.config import get_stream_writer
from langgraph.graph import END, START, StateGraph
from pydantic import TypeAdapter

from c2s_engine.session import in_place, steps, unwritten
from c2s_engine.session.citing import resting_on, uncited
from c2s_engine.session.improving import can_improve, improved, summed
from c2s_engine.session.methods import Method, method_named
from c2s_engine.session.places import demanded
from c2s_engine.session.read_back import read_back
from c2s_engine.session.requiring import check_and_judge
from c2s_engine.session.solving import can_solve, solved
from c2s_engine.session.steps import Tools
from c2s_engine.session.with_consequences import with_consequences
from c2s_engine.solve.defaults import with_usual_reaction
from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import StageResult
from c2s_engine.structure.edits import Edit, Replace, SetCode, SetProgram, placed_in_order
from c2s_engine.structure.progress import Say, StructureChanged
from c2s_engine.structure.sentences import with_updated_sentences
from c2s_engine.write import by_hand

EDITS: TypeAdapter[list[Edit]] = TypeAdapter(list[Edit])


class State(TypedDict, total=False):
    """A turn's input (text or edits and how to work), and what came of it. JSON-like values only."""

    text: str
    given: bool
    own: dict[str, Any]
    edits: list[dict[str, Any]]
    method: str
    map: str | None
    seed: int
    runs: int
    upto: str
    trajectories: bool
    improve: bool
    strict: bool
    widen: bool
    structure: dict[str, Any]
    before: dict[str, Any]
    program: dict[str, Any]
    stages: list[dict[str, Any]]
    report: dict[str, Any]
    rewritten: list[str]
    places: int
    folder: str
    room: float
    map_name: str
    requirements: list[dict[str, Any]]
    results: list[dict[str, Any]]
    measures: list[dict[str, Any]]
    details: dict[str, Any]
    in_place: list[str]
    stop: bool


def build_graph(tools: Tools, checkpointer: Any = None) -> Any:
    """interpret -> configure -> write -> check -> solve -> improve; each may end the turn with a diagnostic."""

    def structure_of(state: State) -> Structure:
        return Structure.model_validate(state.get("structure") or {})

    def with_stage(state: State, result: StageResult) -> list[dict[str, Any]]:
        return [*state.get("stages", []), result.model_dump(mode="json")]

    def method_of(state: State) -> Method:
        return method_named(state.get("method") or tools.settings.method, tools)

    async def interpret(state: State) -> State:
        emit = get_stream_writer()
        if not state.get("text"):
            return {"stages": [], "details": {}}
        text, source = uncited(state["text"])
        method = method_of(state)
        structure, edits, details, result = await method.interpret(text, structure_of(state), emit)
        if structure is not None:
            structure = resting_on(structure.model_copy(update={"read_by": method.name}), source, state["text"])
            if own := state.get("own"):
                structure = by_hand.carried(structure, Structure.model_validate(own))
            emit(StructureChanged(structure=structure))
        return {
            "structure": (structure or structure_of(state)).model_dump(mode="json"),
            "edits": [e.model_dump(mode="json") for e in edits],
            "stages": [result.model_dump(mode="json")],
            "details": details,
            "stop": not result.ok,
        }

    async def configure(state: State) -> State:
        emit = get_stream_writer()
        before = by_hand.with_marks(structure_of(state))
        edits = EDITS.validate_python(state.get("edits") or [])
        structure = read = before
        for edit in edits:
            structure = by_hand.apply(structure, edit)
            read = structure if isinstance(edit, Replace) else read  # what edits by hand are read upon
        structure = by_hand.with_names(structure, read)
        if edits and not any(isinstance(e, Replace | SetProgram | SetCode) for e in edits):
            structure, said = with_consequences(before, structure)
            for text in said:
                emit(Say(text=text))
        method = method_of(state)
        for edit in method.described(before, structure) if edits else []:
            structure = steps.apply(structure, edit)
        structure = placed_in_order(structure)
        if state.get("given"):
            structure = with_usual_reaction(structure)
        strict = state.get("strict")
        given = state.get("map") or (demanded(structure, tools.library) if strict else None)
        lenient = bool(state.get("text") or state.get("given")) and not strict
        structure, found, result = await steps.configure(
            structure, tools, emit, given=given, needed=method.needs_place, lenient=lenient,
            strict=bool(strict),
        )  # fmt: skip
        changed: list[str] = []
        if found.writer is None:
            structure = unwritten.left(before, structure, emit)
        elif edits:
            structure = await read_back(read, structure, found.writer, tools.check, emit)
            structure, changed = await in_place.followed(read, structure, found.writer, tools.check, emit)
        structure = with_updated_sentences(before, structure)
        emit(StructureChanged(structure=structure))
        update: State = {
            "before": before.model_dump(mode="json"),
            "structure": structure.model_dump(mode="json"),
            "edits": [],
            "stages": with_stage(state, result),
            "places": found.count,
            "in_place": changed,
            "stop": found.writer is None,
        }
        if found.writer is not None:
            update |= {
                "folder": str(found.writer.map.path.parent),
                "room": found.writer.room,
                "map_name": found.writer.map.name,
            }
        return update

    async def write(state: State) -> State:
        emit = get_stream_writer()
        method = method_of(state)
        before = Structure.model_validate(state["before"])
        changed = state.get("in_place", [])
        structure, program, written, result = await method.write(
            structure_of(state),
            in_place.marking_rewritten(changed, emit),
            map_name=state["map_name"],
            room=state["room"],
            folder=state["folder"],
        )
        if result.ok:
            unwritten.conflicts(before, structure, emit)
        else:
            structure = unwritten.left(before, structure, emit)
        emit(StructureChanged(structure=structure))
        return {
            "structure": structure.model_dump(mode="json"),
            "program": program.model_dump(mode="json"),
            "rewritten": [*written, *(c for c in changed if c not in written)],
            "details": {**summed(state.get("details", {}), method.account(structure)), "in_place": changed},
            "stages": with_stage(state, result),
            "stop": not result.ok,
        }

    async def check(state: State) -> State:
        from c2s_engine.structure.program import Program

        report, found = await check_and_judge(
            structure_of(state),
            Program.model_validate(state["program"]),
            tools,
            get_stream_writer(),
            map_name=state["map_name"],
            room=state["room"],
            folder=state["folder"],
            upto=state.get("upto", "run"),  # type: ignore[arg-type]
            seed=state.get("seed", 0),
            runs=state.get("runs", 1),
            trajectories=state.get("trajectories", False),
        )
        stages = [*state.get("stages", []), *(s.model_dump(mode="json") for s in report.stages)]
        kept = report.model_dump(mode="json", exclude={"trajectories"})
        return {"report": kept, "stages": stages, **found.as_state()}  # type: ignore[typeddict-item]

    async def solve(state: State) -> State:
        return await solved(state, tools, get_stream_writer())  # type: ignore[return-value, arg-type]

    async def improve(state: State) -> State:
        return await improved(state, tools, method_of(state), get_stream_writer())  # type: ignore[return-value, arg-type]

    def onward(then: str) -> Any:
        return lambda state: END if state.get("stop") else then

    def after_check(state: State) -> str:
        return "solve" if can_solve(state, tools) else "improve" if can_improve(state) else END  # type: ignore[arg-type]

    graph = StateGraph(State)
    for name, node in (("interpret", interpret), ("configure", configure), ("write", write), ("check", check),
                       ("solve", solve), ("improve", improve)):  # fmt: skip
        graph.add_node(name, node)
    graph.add_edge(START, "interpret")
    graph.add_conditional_edges("interpret", onward("configure"), ["configure", END])
    graph.add_conditional_edges("configure", onward("write"), ["write", END])
    graph.add_conditional_edges("write", onward("check"), ["check", END])
    graph.add_conditional_edges("check", after_check, ["solve", "improve", END])
    graph.add_conditional_edges("solve", lambda state: "improve" if can_improve(state) else END, ["improve", END])
    graph.add_edge("improve", END)
    return graph.compile(checkpointer=checkpointer)

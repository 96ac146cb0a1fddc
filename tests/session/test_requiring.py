"""The run without ego's reaction is made beside the run that is judged; what only ends earlier is foreseen."""

from c2s_engine.session import steps
from c2s_engine.session.places import map_choice
from c2s_engine.session.requiring import KEPT, by_its_runs, check_and_judge
from c2s_engine.solve.shortened import ended_earlier
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.program import assemble
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec, RestrictionsSpec
from c2s_engine.write.typed import TypedWriter

VAN = ObjectSpec(name="van", type="van", phases=(Phase(action="brake", rate=6.0),))
STRUCTURE = Structure(
    place=Component(id="R", spec=PlaceSpec(kind="straight")),
    ego=Component(id="E", spec=EgoSpec(speed=14.0, reaction="brake", react_to="O1")),
    objects=(Component(id="O1", spec=VAN),),
    restrictions=Component(id="T", spec=RestrictionsSpec()),
)


async def test_a_run_that_only_ends_at_another_time_has_the_same_without_reaction(engine, monkeypatch):
    chosen = map_choice(engine.library, engine.library.find("town"))
    asked, check = [], engine.tools.check.check

    async def counted(request):
        asked.append(request.program)
        return await check(request)

    monkeypatch.setattr(engine.tools.check, "check", counted)
    found = []
    for seconds in (14.0, 12.0, 12.0):
        changed = STRUCTURE.with_spec("T", duration=seconds)
        structure, program, _, _ = steps.write(changed, [], TypedWriter(chosen, room=1.0), steps.silent)
        _, judged = await check_and_judge(
            structure,
            program,
            engine.tools,
            steps.silent,
            map_name=chosen.name,
            room=1.0,
            folder=str(chosen.path.parent),
            seed=7,
        )
        found.append((structure, judged))
    assert len(asked) == 4 and 0 < len(engine.tools.blind) <= KEPT
    (long, by_long), (short, by_short), _ = found
    runs = ended_earlier(short, long, by_long.runs)
    assert by_its_runs(short, runs, by_long.without).results == by_short.results
    assert not ended_earlier(short, long.with_spec("E", speed=13.0), by_long.runs), "another scene"
    assert not ended_earlier(long, short, by_short.runs), "what comes after its end is not known"


async def test_a_program_that_does_not_compile_has_no_run_to_compare(engine):
    chosen = map_choice(engine.library, engine.library.find("town"))
    structure, program, _, _ = steps.write(STRUCTURE, [], TypedWriter(chosen, room=1.0), steps.silent)
    broken = program.model_copy(update={"text": program.text + "\nego = new Nothing\n"})
    report, judged = await check_and_judge(
        structure, broken, engine.tools, steps.silent, map_name=chosen.name, room=1.0, folder=str(chosen.path.parent)
    )
    assert not report.ok and not judged.results


async def test_an_ego_by_hand_that_says_the_same_reacts_all_the_same(engine):
    """Its code is not taken for that with the reaction switched off."""
    chosen = map_choice(engine.library, engine.library.find("town"))
    structure, program, _, _ = steps.write(STRUCTURE, [], TypedWriter(chosen, room=1.0), steps.silent)
    own = structure.ego.with_own_code(structure.ego.code.replace("# m/s", "# as ever"))
    assert own.code != structure.ego.code
    structure = structure.with_component(own.model_copy(update={"by_hand": "same"}))
    _, judged = await check_and_judge(
        structure, assemble(structure), engine.tools, steps.silent, map_name=chosen.name, seed=7, room=1.0,
        folder=str(chosen.path.parent),
    )  # fmt: skip
    reacts = {r.requirement: r for r in judged.results if r.requirement.startswith("E.reaction")}
    assert reacts and all(r.holds for r in reacts.values()), reacts

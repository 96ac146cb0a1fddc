"""The run without ego's reaction: made beside the run that is judged, and once for programs that only end otherwise."""

from c2s_engine.session import steps
from c2s_engine.session.places import map_choice
from c2s_engine.session.requiring import KEPT, check_and_judge
from c2s_engine.structure.components import Component, Structure
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
    for seconds in (16.0, 12.0, 12.0):
        changed = STRUCTURE.with_spec("T", duration=seconds)
        structure, program, _, _ = steps.write(changed, [], TypedWriter(chosen, room=1.0), steps.silent)
        _, judged = await check_and_judge(structure, program, engine.tools, steps.silent, map_name=chosen.name, room=1.0,
                                          folder=str(chosen.path.parent), seed=7)  # fmt: skip
        found.append({r.requirement: r.holds for r in judged.results if r.requirement.startswith("O1.threat")})
    assert len(asked) == 4 and found[0] == found[1] == found[2]
    assert 0 < len(engine.tools.blind) <= KEPT


async def test_a_program_that_does_not_compile_has_no_run_to_compare(engine):
    chosen = map_choice(engine.library, engine.library.find("town"))
    structure, program, _, _ = steps.write(STRUCTURE, [], TypedWriter(chosen, room=1.0), steps.silent)
    broken = program.model_copy(update={"text": program.text + "\nego = new Nothing\n"})
    report, judged = await check_and_judge(structure, broken, engine.tools, steps.silent, map_name=chosen.name, room=1.0,
                                           folder=str(chosen.path.parent))  # fmt: skip
    assert not report.ok and not judged.results

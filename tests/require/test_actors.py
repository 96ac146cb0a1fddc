"""Every actor is there once, and nobody else."""

from c2s_engine.require import evaluate, require, whole
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.facts import ObjectFacts, RunFacts, Trajectories
from c2s_engine.structure.specs import ObjectSpec

S = Structure(objects=(Component(id="O1", spec=ObjectSpec(name="lead")),))


def run(*objects: tuple[str, str | None]) -> RunFacts:
    made = tuple(
        ObjectFacts(name=n, component=c, types=("car", "vehicle"), length=4.5, width=1.9, moves=True)
        for n, c in objects
    )
    return RunFacts(seed=0, duration=10.0, ended_by="time", objects=made)


def verdicts(facts: RunFacts) -> dict[str, bool | None]:
    found = evaluate(require(S), facts, Trajectories(step=0.1, tracks=()))
    return {r.requirement: r.holds for r in found if r.requirement.endswith(("there", "nobody_else"))}


def test_all_are_there_once() -> None:
    assert set(verdicts(run(("ego", "E"), ("lead", "O1"))).values()) == {True}


def test_who_is_missing_or_there_twice_is_seen() -> None:
    assert verdicts(run(("ego", "E")))["O1.there"] is False
    assert verdicts(run(("ego", "E"), ("a", "O1"), ("b", "O1")))["O1.there"] is False


def test_somebody_whom_s_does_not_name_is_seen() -> None:
    assert verdicts(run(("ego", "E"), ("lead", "O1"), ("stranger", None)))["R.nobody_else"] is False


def test_a_run_that_did_not_begin_reaches_nothing() -> None:
    found = evaluate(require(S), RunFacts(seed=0, duration=0, ended_by="error", reason="boom"),
                     Trajectories(step=0.1, tracks=()))  # fmt: skip
    assert all(r.holds is None and "boom" in r.why for r in found) and not whole(found)

"""The assignment satisfies as many atoms as the best of all assignments, tried one by one."""

from itertools import permutations

from bench_scenes import run, thing
from hypothesis import given, settings
from hypothesis import strategies as st

from c2s_bench.assign import match
from c2s_bench.atoms import expectation, names, object_holds
from c2s_engine.structure.facts import EGO, StartFact

KINDS, EVENTS, LANES, NAMES = ("car", "truck", "pedestrian"), ("stop", "cut_in"), ("same", "left"), ("a", "b", "c")


@st.composite
def actors(draw):
    """Up to three actors with relations among them."""
    chosen = NAMES[: draw(st.integers(1, 3))]
    found = []
    for name in chosen:
        others = [n for n in chosen if n != name]
        actor = {"as": name, "type": draw(st.sampled_from([*KINDS, "any"])), "does": draw(st.just([]))}
        events = st.sampled_from(EVENTS) | st.builds(lambda n: {"follow": n}, st.sampled_from([*others, EGO]))
        actor["does"] = draw(st.lists(events, max_size=2, unique_by=str))
        starts = {"lane": draw(st.sampled_from(LANES))}
        if others and draw(st.booleans()):
            starts["of"] = draw(st.sampled_from(others))
        actor["starts"] = starts
        found.append(actor)
    return found


@st.composite
def scenes(draw):
    """Up to four objects with drawn types, events and lanes towards each other."""
    there = [f"o{i}" for i in range(draw(st.integers(0, 4)))]
    objects = []
    for name in there:
        others = [n for n in there if n != name] + [EGO]
        starts = {o: StartFact(lanes=(draw(st.sampled_from(LANES)),)) for o in others}
        pairs = st.sampled_from(EVENTS) | st.tuples(st.just("follow"), st.sampled_from(others))
        does = tuple(draw(st.lists(pairs, max_size=2)))
        kind, moves = draw(st.sampled_from(KINDS)), draw(st.booleans())
        objects.append(thing(name, kind, does=does, starts=starts, moves=moves))
    return run(*objects)


def best_by_trying(expected, facts):
    """The most atoms over every injective assignment, none included; who satisfies nothing of an actor is not it."""
    ego = [o for o in facts.objects if o.name == EGO]
    things = [o for o in facts.objects if o.name != EGO]
    most = 0
    for chosen in permutations([*things, *[None] * len(expected.actors)], len(expected.actors)):
        pairs = [(a, o) for a, o in zip(expected.actors, chosen, strict=True) if o]
        if not all(any(names(x) or object_holds(x, o, {EGO: ego}) for x in a.atoms) for a, o in pairs):
            continue
        binding = {a.name: [o] if o else [] for a, o in zip(expected.actors, chosen, strict=True)} | {EGO: ego}
        held = [object_holds(atom, o, binding) for actor, o in pairs for atom in actor.atoms]
        held += [object_holds(atom, ego[0], binding) for atom in expected.ego]
        most = max(most, sum(held))
    return most


@settings(max_examples=120, derandomize=True)
@given(actors(), st.lists(st.sampled_from(NAMES), max_size=1), scenes())
def test_no_assignment_satisfies_more(expected_actors, followed, facts):
    known = [n for n in followed if n in {a["as"] for a in expected_actors}]
    expected = expectation({"actors": expected_actors, "ego": {"does": [{"follow": n} for n in known]}})
    found = match(expected, facts)
    assert len(found.held) == found.rank[0] == best_by_trying(expected, facts)
    taken = [m.name for members in found.members.values() for m in members]
    assert len(taken) == len(set(taken))
    movers = {o.name for o in facts.objects if o.moves and o.name != EGO}
    assert set(found.unaccounted) == movers - set(taken)

"""Which object of a rollout stands for which expected actor: the assignment that satisfies most atoms.

Searched exhaustively with a bound, because relations between actors (`of:`, `{follow: lead}`) make it more than a
linear assignment. An object that satisfies nothing that is said of an actor does not stand for it. Ties go to the
assignment that leaves fewest moving objects unaccounted for.
"""

from dataclasses import dataclass, field
from itertools import combinations

from c2s_bench.atoms import Actor, Atom, Expectation, names, object_holds
from c2s_engine.structure.facts import EGO, ObjectFacts, RunFacts

MOST_LEAVES = 50_000  # of the search; far above what records and scenes at hand need

Members = tuple[ObjectFacts, ...]


@dataclass
class Matching:
    """One rollout's assignment: the members of each actor, the atoms that hold, the movers without an expectation."""

    members: dict[str, Members] = field(default_factory=dict)
    held: set[Atom] = field(default_factory=set)
    unaccounted: tuple[str, ...] = ()
    present: frozenset[str] = frozenset()  # the actors with at least one member
    rank: tuple[int, int, int] = (-1, 0, 0)


def match(expected: Expectation, facts: RunFacts) -> Matching:
    """The best matching of the expected actors to the objects of a rollout."""
    return _Search(expected, facts).run()


class _Search:
    def __init__(self, expected: Expectation, facts: RunFacts):
        self.expected = expected
        self.ego = [o for o in facts.objects if o.name == EGO]
        self.things = [o for o in facts.objects if o.name != EGO]
        options = [(actor, self._options(actor)) for actor in expected.actors]
        self.options = sorted(options, key=lambda pair: -pair[1][0][0])
        alone = {EGO: tuple(self.ego)}
        self.ego_bound = sum(bool(names(a)) or any(object_holds(a, e, alone) for e in self.ego) for a in expected.ego)
        self.best = Matching()
        self.leaves = 0

    def _options(self, actor: Actor) -> list[tuple[int, Members]]:
        """Every choice of members with the most atoms that it can satisfy, best first; none at all is the last."""
        alone = {EGO: tuple(self.ego)}
        possible = {
            thing.name: frozenset(a for a in actor.atoms if names(a) or object_holds(a, thing, alone))
            for thing in self.things
        }
        useful = [thing for thing in self.things if possible[thing.name]]
        found: list[tuple[int, Members]] = []
        for size in range(min(actor.count, len(useful)), 0, -1):
            for members in combinations(useful, size):
                can = frozenset.intersection(*(possible[m.name] for m in members))
                short = size < actor.count and actor.atoms[0] in can
                found.append((len(can) - short, members))
        found.sort(key=lambda option: -option[0])
        return [*found, (0, ())]

    def run(self) -> Matching:
        bounds = [options[0][0] if not actor.optional else 0 for actor, options in self.options]
        self.rest = [sum(bounds[i:]) for i in range(len(bounds) + 1)]
        self._step(0, {EGO: tuple(self.ego)}, frozenset(), 0)
        return self.best

    def _step(self, depth: int, binding: dict[str, Members], used: frozenset[str], optimum: int) -> None:
        if self.leaves >= MOST_LEAVES or optimum + self.rest[depth] + self.ego_bound < self.best.rank[0]:
            return
        if depth == len(self.options):
            self._leaf(binding, used)
            return
        actor, options = self.options[depth]
        for bound, members in options:
            taken = {m.name for m in members}
            if used.isdisjoint(taken):
                self._step(
                    depth + 1,
                    {**binding, actor.name: members},
                    used | taken,
                    optimum + (0 if actor.optional else bound),
                )

    def _leaf(self, binding: dict[str, Members], used: frozenset[str]) -> None:
        self.leaves += 1
        held = {a for a in self.expected.ego for ego in self.ego if object_holds(a, ego, binding)}
        free = [thing for thing in self.things if thing.name not in used]
        failed_optional = mandatory = 0
        members = {name: chosen for name, chosen in binding.items() if name != EGO}
        for actor in self.expected.actors:
            chosen = binding[actor.name]
            holding = {a for a in actor.atoms if chosen and all(object_holds(a, m, binding) for m in chosen)}
            if len(chosen) < actor.count:
                holding.discard(actor.atoms[0])
            elif actor.exactly or actor.open_ended:
                more = [t for t in free if holding and all(object_holds(a, t, binding) for a in holding)]
                more = [t for t in more if object_holds(actor.atoms[0], t, binding)]
                free = [t for t in free if t not in more]
                members[actor.name] = (*chosen, *more)
                if more and actor.exactly:
                    holding.discard(actor.atoms[0])
            if actor.optional:
                failed_optional += len(actor.atoms) - len(holding) if chosen else 0
            else:
                mandatory += len(holding)
            held |= holding
        loose = tuple(t.name for t in free if t.moves)
        ego_held = sum(a in held for a in self.expected.ego)
        typed = sum(actor.atoms[0] in held for actor in self.expected.actors)
        rank = (mandatory + ego_held, -(len(loose) + failed_optional), typed)
        if rank > self.best.rank:
            present = frozenset(name for name, chosen in members.items() if chosen)
            self.best = Matching(members, held, loose, present, rank)

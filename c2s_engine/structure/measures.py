"""A run in numbers, and its collisions in words: data that fronts show and questions are answered from. SI units."""

from collections.abc import Sequence
from typing import Any

from pydantic import BaseModel, ConfigDict

from c2s_engine.structure.facts import EGO, RunFacts, component_of
from c2s_engine.structure.requirements import Requirement


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class PairMeasures(_Frozen):
    """The smallest values between ego (or `one`) and another, with their times; None where there is none.

    Gaps are from bumper to bumper (between the two boxes). `ttc_s`: time to collision, both keeping speed and heading;
    `pet_s`: post-encroachment time where their ways cross."""

    one: str = EGO
    other: str
    gap_m: float
    gap_at_s: float
    ttc_s: float | None = None
    ttc_at_s: float | None = None
    pet_s: float | None = None
    pet_at_s: float | None = None
    required_deceleration_mps2: float = 0.0
    required_deceleration_at_s: float | None = None


class ActorMeasures(_Frozen):
    """One actor's motion up to its first contact: speeds in m/s, hardest braking in m/s2, when it first stands (s)."""

    name: str
    fastest: float
    slowest: float
    slowest_at_s: float
    braking: float
    braking_at_s: float
    stands_at_s: float | None = None


class Measures(_Frozen):
    """The measures of one run; `pairs`: ego with each other, `others`: two others of whom one moves."""

    pairs: tuple[PairMeasures, ...] = ()
    others: tuple[PairMeasures, ...] = ()
    actors: tuple[ActorMeasures, ...] = ()

    def least(self, name: str) -> PairMeasures | None:
        """The pair with the smallest `gap_m`, `ttc_s` or `pet_s`; None where no pair has one."""
        having = [p for p in self.pairs if getattr(p, name) is not None]
        return min(having, key=lambda p: getattr(p, name), default=None)


class SeedResult(_Frozen):
    """One row of a series of runs: the scene sampled with a seed, and what its run showed."""

    seed: int
    ran: bool
    ended: str  # how the run ended, or why there was none
    duration: float = 0.0
    met: int = 0
    required: int = 0
    collisions: tuple[str, ...] = ()
    unmet: tuple[str, ...] = ()
    gap_m: float | None = None
    ttc_s: float | None = None

    @property
    def passed(self) -> bool:
        """Whether it ran, everything that is required was seen, and nobody collided who should not."""
        return self.ran and self.met == self.required and not any(c.startswith("COLLISION") for c in self.collisions)


class Collision(_Frozen):
    """A first contact of two actors. `said`: whether S says it; None where S does not say all that its code does."""

    time: float
    one: str
    other: str
    components: tuple[str, str]
    said: bool | None
    in_text: bool = True  # S was read from a text

    @property
    def verdict(self) -> str:
        """Whether it was to be expected."""
        if self.said is None:
            return ""
        return ", as said" if self.said else ", not in the text" if self.in_text else ", not in S"

    @property
    def word(self) -> str:
        """In capitals where nobody asked for it."""
        return "COLLISION" if self.said is False else "collision"

    def __str__(self) -> str:
        return f"{self.word} {self.one}-{self.other} at {self.time:.1f} s{self.verdict}"

    def of(self, cid: str) -> str:
        """The same from the side of one of the two components."""
        other = self.other if cid == self.components[0] else self.one
        return f"{self.word} with {other} at {self.time:.1f} s{self.verdict}"


def collisions(
    facts: RunFacts | None, requirements: Sequence[Requirement], in_text: bool = True
) -> tuple[Collision, ...]:
    """The collisions of a run in the order of time, those that S says told from the others."""
    if facts is None:
        return ()
    pairs = next((r.values["pairs"] for r in requirements if r.check == "no_other_contact"), None)
    said: Any = None if pairs is None else {frozenset(str(p).split()) for p in pairs}  # type: ignore[union-attr]
    known = {o.name: EGO if o.name == EGO else o.component or o.name for o in facts.objects}
    found = []
    for c in sorted(facts.contacts, key=lambda c: c.time):
        who = tuple(known.get(n, n) for n in (c.one, c.other))
        cids = tuple(map(component_of, who))
        asked = None if said is None else frozenset(who) in said
        found.append(Collision(time=c.time, one=c.one, other=c.other, components=cids, said=asked, in_text=in_text))  # type: ignore[arg-type]
    return tuple(found)

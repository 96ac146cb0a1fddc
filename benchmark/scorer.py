"""Scores of a record from the facts of its rollouts (FORMAT.md, "Scoring"). Pure functions, all shares in percent."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from c2s_bench.assign import Matching, match
from c2s_bench.atoms import LAYERS, Atom, Layer, expectation, scene_holds
from c2s_bench.records import Record
from c2s_engine.structure.facts import RunFacts


@dataclass(frozen=True)
class AtomScore:
    """One atom of a record with the share of the rollouts (0..1) in which it held."""

    id: str
    layer: Layer
    atom: str
    kind: str
    share: float
    holds: bool
    excluded: str = ""

    @property
    def counts(self) -> bool:
        return not self.excluded


@dataclass(frozen=True)
class RecordScore:
    """A record's scores. `sq` and `layers` of a program that did not run are 0; a layer without atoms is None."""

    id: str
    source: str
    ran: bool
    layers: Mapping[Layer, float | None]
    sq: float
    atoms: tuple[AtomScore, ...]

    @property
    def csr(self) -> float:
        return 100.0 if self.ran else 0.0

    @property
    def fa(self) -> float:
        return self.csr * self.sq / 100.0

    @property
    def excluded(self) -> int:
        """Atoms that no program could satisfy here (snow)."""
        return sum(1 for a in self.atoms if a.kind == "weather" and a.excluded)


def score(record: Record, facts: Sequence[RunFacts], runs: int) -> RecordScore:
    """Score a program by the facts of its K = `runs` rollouts; those that are lacking or broke off satisfy nothing.

    The program counts as run where over half of the rollouts ran, the rule by which an atom holds.
    """
    expected = expectation(record.expect)
    good = [f for f in facts[:runs] if f.ran]
    matchings = [match(expected, f) for f in good]
    ran = 2 * len(good) > runs
    atoms = [_scene_atom(record, a, good, runs) for a in expected.scene]
    atoms += [_object_atom(record, a, matchings, runs) for a in expected.ego]
    for actor in expected.actors:
        there = [m for m in matchings if actor.name in m.present]
        absent = actor.optional and 2 * len(there) <= runs
        over, of = (there, len(there)) if actor.optional else (matchings, runs)
        for atom in actor.atoms:
            atoms.append(_object_atom(record, atom, over, of, "optional, and not there" if absent else ""))
    loose = {name for m in matchings for name in m.unaccounted}
    for name in sorted(loose):
        share = 1 - sum(name in m.unaccounted for m in matchings) / runs
        if share <= 0.5:  # it is accounted for in no more than half of them
            atoms.append(AtomScore(record.id, "DO", f"{name} moves, and nothing expects it", "stray", share, False))
    layers = {layer: _layer_score([a for a in atoms if a.layer == layer], ran) for layer in LAYERS}
    counted = [value for value in layers.values() if value is not None]
    sq = sum(counted) / len(counted) if ran and counted else 100.0 if ran else 0.0
    return RecordScore(record.id, record.source, ran, layers, sq, tuple(atoms))


def _scene_atom(record: Record, atom: Atom, facts: Sequence[RunFacts], runs: int) -> AtomScore:
    return _atom(record, atom, sum(scene_holds(atom, f) for f in facts), runs, atom.excluded)


def _object_atom(record: Record, atom: Atom, matchings: Sequence[Matching], runs: int, excluded: str = "") -> AtomScore:
    return _atom(record, atom, sum(atom in m.held for m in matchings), runs, excluded)


def _atom(record: Record, atom: Atom, times: int, runs: int, excluded: str) -> AtomScore:
    return AtomScore(
        record.id, atom.layer, atom.text, atom.kind, times / runs if runs else 0.0, 2 * times > runs, excluded
    )


def _layer_score(atoms: Sequence[AtomScore], ran: bool) -> float | None:
    counted = [a for a in atoms if a.counts]
    if not counted:
        return None
    return 100.0 * sum(a.holds for a in counted) / len(counted) if ran else 0.0


@dataclass(frozen=True)
class Totals:
    """The columns of the paper's tables over some records; a layer that no record that ran has is None."""

    number: int
    csr: float
    sq: float
    fa: float
    rt: float  # s
    tokens: float
    layers: Mapping[Layer, float | None]
    excluded: int

    def as_dict(self) -> dict[str, float | int | None]:
        row: dict[str, float | int | None] = {"number": self.number, "CSR": self.csr, "RT": self.rt}
        return {
            **row, "tokens": self.tokens, **self.layers, "SQ": self.sq, "FA": self.fa, "excluded": self.excluded
        }  # fmt: skip


def totals(scores: Sequence[RecordScore], seconds: Sequence[float], tokens: Sequence[float]) -> Totals:
    """The means over records: SQ and layers over the programs that ran, RT (s) and tokens over all."""
    ran = [s for s in scores if s.ran]
    csr = 100.0 * _mean([s.ran for s in scores])
    sq = _mean([s.sq for s in ran])
    layers: dict[Layer, float | None] = {}
    for layer in LAYERS:
        values = [value for s in ran if (value := s.layers[layer]) is not None]
        layers[layer] = _mean(values) if values else None
    return Totals(
        len(scores), csr, sq, csr * sq / 100.0, _mean(seconds), _mean(tokens), layers, sum(s.excluded for s in scores)
    )


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values) if values else 0.0

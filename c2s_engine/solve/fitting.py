"""Where a map's roads are too short or bend too much for the speeds of a scene: the fewest of these are lowered."""

from collections.abc import Collection, Iterator

from c2s_engine.solve.unknowns import PLANNER, Field, Unknown, chosen
from c2s_engine.structure.components import FITTED, Structure
from c2s_engine.structure.quantity import Quantity, high, in_words, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.write.typed import ResolveError
from c2s_engine.write.typed.tables import APPROACH_ANGLE, is_vehicle
from c2s_engine.write.typed.usual import crosses
from c2s_engine.write.typed.usual_values import usual_values

SHARES = (0.85, 0.7, 0.55, 0.4)
"""Of the speed of whoever is the fastest, what is tried; the most first."""
LEAST = 5.0
"""m/s below which no speed is lowered."""


def slower(structure: Structure, where: str) -> list[Structure]:
    """What may stand for a structure on roads with less room, from the one that gives up least: first with the speeds
    lowered that the text left open, then with others; each is said in `assumed`."""
    try:
        usual = usual_values(structure, 1.0).speeds
    except ResolveError:
        return []
    said = dict(_said(structure))
    open_: dict[Field, Quantity] = {f: usual[f[0]] for f in _open(structure) if usual.get(f[0], 0.0) > LEAST}
    tried = [*([open_] if open_ and said else []), open_ | said]
    found = [_lowered(structure, speeds, share, where) for speeds in tried for share in SHARES if speeds]
    return [each for each in found if each is not structure]


def _drivers(structure: Structure) -> Iterator[tuple[str, EgoSpec | ObjectSpec]]:
    """Who drives along ego's road."""
    for component in (structure.ego, *structure.objects):
        spec = component.spec
        if isinstance(spec, EgoSpec) or (
            isinstance(spec, ObjectSpec) and is_vehicle(spec.type) and not crosses(spec)
            and spec.placement.position not in APPROACH_ANGLE
        ):  # fmt: skip
            yield component.id, spec


def _said(structure: Structure) -> Iterator[tuple[Field, Quantity]]:
    """The speeds that S has."""
    for cid, spec in _drivers(structure):
        paths = {"speed": spec.speed, **{f"phases.{i}.speed": phase.speed for i, phase in enumerate(spec.phases)}}
        yield from (((cid, path), speed) for path, speed in paths.items() if speed is not None and high(speed) > LEAST)


def _open(structure: Structure) -> Iterator[Field]:
    yield from ((cid, "speed") for cid, spec in _drivers(structure) if spec.speed is None)


def _lowered(structure: Structure, speeds: dict[Field, Quantity], share: float, where: str) -> Structure:
    """The structure with those of some speeds lowered that are over a share of the highest."""
    said = dict(_said(structure))
    over = _concerned({high(speed) for speed in speeds.values()}, share)
    changed = structure
    for (cid, path), speed in speeds.items():
        if high(speed) not in over:
            continue
        open_ = (cid, path) not in said or path in {a.field for a in structure[cid].assumed}
        now = round(low(speed) * share, 2), round(high(speed) * share, 2)
        was = "" if open_ else in_words(path, speed)
        before = f"{was} was specified" if was else "left open"
        reason = f"{before}; the roads of {where} only allow {in_words(path, now)}"
        unknown = Unknown(cid, path, middle(speed))
        by = PLANNER if open_ else FITTED
        changed = chosen(changed, unknown, now[1] if now[0] == now[1] else now, reason, by, was)
    return changed


def _concerned(speeds: Collection[float], share: float) -> set[float]:
    """The speeds over a share of the highest, and those that would otherwise be higher than one of them then is."""
    over = {speed for speed in speeds if speed > share * max(speeds)}
    while more := {speed for speed in speeds if speed not in over and speed > share * min(over)}:
        over |= more
    return over

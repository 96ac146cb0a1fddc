"""`python -m c2s_bench.reading read | run | through | turns`: how well scenes and changes are read; how many run as S
by hand requires.

read: the learned reader on wordings of scenes held out of training. run: S by hand to a run; the share in which all
that S requires is seen, and what fails most. through: the text to a run; the share in which all that S by hand requires
is seen. turns: changes upon scenes that are held out of training, as the app makes them (--writer: of one writer); the
share in which S becomes what it should.
"""

import argparse
import asyncio
import random
import re
from collections import Counter

from c2s_bench.reading.agreement import Agreement, agreement
from c2s_bench.reading.scenes import Scene, scenes
from c2s_bench.reading.through import seen
from c2s_bench.reading.turns import outcome, turns
from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.interpret.learned import learned
from c2s_engine.report.gather import TextRecord, of_text


def read(chosen: list[Scene]) -> None:
    """Print how the scenes' first wordings are read."""
    found: list[Agreement] = []
    for scene in chosen:
        try:
            found.append(agreement(learned(scene.texts[0]).structure, scene.structure))
        except ValueError as error:  # a text that the reader refuses
            print(f"{scene.id}: {error}")
            found.append(Agreement(0, 0, agreement(scene.structure, scene.structure).there, False))
    agreed, said, there = (sum(getattr(a, name) for a in found) for name in ("agreed", "read", "there"))
    precision, recall = agreed / max(said, 1), agreed / max(there, 1)
    f1 = 2 * precision * recall / max(precision + recall, 1e-9)
    print(f"{len(found)} texts: fields precise {precision:.1%}, found {recall:.1%}, F1 {f1:.1%}")
    objects, exact = sum(a.objects for a in found) / len(found), sum(a.exact for a in found)
    print(f"as many objects in {objects:.0%}, all the same in {exact}")


async def run(chosen: list[Scene]) -> None:
    """Print in how many scenes everything that S requires is seen, and the checks that fail most."""
    whole, failing, problems = 0, Counter[str](), 0
    async with Engine(Settings()) as engine:
        for number, scene in enumerate(chosen, 1):
            material = await of_text(engine, TextRecord(scene.id, scene.texts[0], "", scene.structure))
            failed = {re.sub(r"^\w+\.|\.\d+", "", r.requirement) for r in material.results if not r.holds}
            problems += bool(material.problem)
            whole += not failed and not material.problem
            failing.update(failed)
            if number % 20 == 0:
                print(f"{number}: {whole} whole", flush=True)
    print(f"{len(chosen)} scenes: {whole} whole ({whole / len(chosen):.0%}), {problems} do not run to their end")
    for name, times in failing.most_common(20):
        print(f"{times:4} {name}")


async def through(chosen: list[Scene]) -> None:
    """Print in how many scenes the run of what is read of the text shows all, or all but one, that S by hand requires,
    and what fails most."""
    failed, failing = list[int | None](), Counter[str]()
    async with Engine(Settings()) as engine:
        for number, scene in enumerate(chosen, 1):
            try:
                results = await seen(engine, scene.id, learned(scene.texts[0]).structure, scene.structure)
            except ValueError:  # a text that the reader refuses
                results = ()
            names = {re.sub(r"^(O)\d+|\.\d+", r"\1", r.requirement) for r in results if not r.holds}
            failed.append(sum(not r.holds for r in results) if results else None)
            failing.update(names)
            if number % 20 == 0:
                print(f"{number}: {failed.count(0)} whole", flush=True)
    whole, but_one = failed.count(0), failed.count(1)
    print(f"{len(chosen)} texts: {whole} whole ({whole / len(chosen):.0%}), {but_one} but for one requirement, "
          f"{failed.count(None)} do not run")  # fmt: skip
    for name, times in failing.most_common(20):
        print(f"{times:4} {name}")


def change(count: int, seed: int, writer: str) -> None:
    """Print how many changes are made as they should."""
    chosen = [turn for turn in turns() if turn.held and writer in ("", turn.writer)]
    random.Random(seed).shuffle(chosen)
    found = {bool(lines): Counter[str]() for lines in (True, False)}
    for turn in chosen[:count]:
        found[bool(turn.lines)][outcome(turn)] += 1
    for changes, said in ((True, "changes"), (False, "no changes")):
        total = max(sum(found[changes].values()), 1)
        shares = (f"{name} {n} ({n / total:.0%})" for name, n in found[changes].most_common())
        print(f"{total} {said}: {', '.join(shares)}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("read", "run", "through", "turns"))
    parser.add_argument("--n", type=int, default=100, help="how many scenes, drawn by --seed")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--trained", action="store_true", help="of those trained on, instead of those held out")
    parser.add_argument("--writer", default="", help="turns: of that writer alone")
    given = parser.parse_args()
    if given.what == "turns":
        change(given.n, given.seed, given.writer)
        return
    chosen = [s for s in scenes() if s.held is not given.trained]
    random.Random(given.seed).shuffle(chosen)
    chosen = chosen[: given.n]
    if given.what == "read":
        read(chosen)
    elif given.what == "through":
        asyncio.run(through(chosen))
    else:
        asyncio.run(run(chosen))


if __name__ == "__main__":
    main()

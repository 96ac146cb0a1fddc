"""Whether a program written on one of CARLA's towns is sampled by plain Scenic on another that has such a place.

`python -m c2s_bench.perf.portable --python ENV/bin/python --maps FOLDER`: the environment has `scenic` and `carla` from
the registry and nothing else; the folder has the towns. Texts are those of the benchmark. A town has a place where the
engine finds one for the same structure. Of the program only the names of the map change.
"""

import argparse
import asyncio
import itertools
import json
import shutil
import subprocess
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

from c2s_bench.records import load
from c2s_engine import driving
from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.session.places import on_map
from c2s_engine.structure.components import Structure
from c2s_engine.structure.progress import Finished

RESULT = Path(__file__).resolve().parents[1] / "results" / "portable.json"
SCRIPT = Path(__file__).with_name("plain_scenic.py")
SEED, ITERATIONS = 3, 2000


@dataclass
class Pair:
    """A text, the map that its program was written on, the one that it is sampled on, and what came of it."""

    record: str
    written: str
    sampled: str
    program: str
    stage: str = ""
    error: str = ""


async def pairs(folder: Path, number: int, every: int) -> list[Pair]:
    """Programs of every so many texts, each written on one town and meant for another, all pairs of towns in turn."""
    found: list[Pair] = []
    async with Engine(Settings(map_folders=(str(folder),), offers=False)) as engine:
        towns = [name for name in engine.library.names() if engine.library.is_town(name)]
        ways = itertools.cycle(itertools.permutations(towns, 2))
        for record in load()[::every]:
            if len(found) >= number:
                break
            for here, there in itertools.islice(ways, len(towns)):
                done = [e async for e in engine.generate(record.text, map=here, run=False, strict=True)
                        if isinstance(e, Finished)][0]  # fmt: skip
                if done.ok and await _has(engine, done.structure, there):
                    program = done.program.text.replace(f"{here}.xodr", f"{there}.xodr")
                    program = program.replace(f"carla_map = '{here}'", f"carla_map = '{there}'")
                    found.append(Pair(record.id, here, there, program))
                    print(f"{len(found)} of {number}", file=sys.stderr)
                    break
    return found


async def _has(engine: Engine, structure: Structure, town: str) -> bool:
    return await on_map(structure, engine.library, engine.check_client, town) is not None


def sample(python: str, maps: Path, found: list[Pair]) -> None:
    """Have plain Scenic sample a scene of each program, with its map and the driving library beside it."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file in (driving.path(), *(maps / f"{town}.xodr" for town in {pair.sampled for pair in found})):
            shutil.copy(file, folder)
        files = {str(folder / f"{i}.scenic"): pair for i, pair in enumerate(found)}
        for file, pair in files.items():
            Path(file).write_text(pair.program, encoding="utf-8")
        command = [python, "-I", str(SCRIPT), str(SEED), str(ITERATIONS), *files]
        out = subprocess.run(command, capture_output=True, text=True, check=True, cwd=folder).stdout
        for answer in map(json.loads, out.splitlines()):
            files[answer["file"]].stage, files[answer["file"]].error = answer["stage"], answer.get("error", "")


def main() -> int:
    """Write, sample, print, keep; the exit status tells whether fewer than 95 % were sampled."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--python", required=True, help="of an environment with scenic and carla only")
    parser.add_argument("--maps", type=Path, required=True, help="the folder with CARLA's towns")
    parser.add_argument("--pairs", type=int, default=40)
    parser.add_argument("--every", type=int, default=3, help="only every n-th text")
    parser.add_argument("--out", type=Path, default=RESULT)
    options = parser.parse_args()
    if not list(options.maps.glob("Town*.xodr")):
        print(f"There is no Town*.xodr in {options.maps}: name the folder with CARLA's towns.", file=sys.stderr)
        return 2
    found = asyncio.run(pairs(options.maps, options.pairs, options.every))
    sample(options.python, options.maps, found)
    failed = [pair for pair in found if pair.stage]
    for pair in failed:
        print(f"{pair.record:18}{pair.written:>9} -> {pair.sampled:9}{pair.stage}: {pair.error[:160]}")
    summary = f"{len(found) - len(failed)} of {len(found)} programs are sampled on another town"
    print(summary)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(json.dumps({"summary": summary, "pairs": [asdict(p) for p in found]}, indent=1) + "\n")
    return int(20 * len(failed) > len(found))


if __name__ == "__main__":
    sys.exit(main())

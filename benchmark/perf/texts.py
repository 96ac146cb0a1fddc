"""From a text to a run and its verdict, on each of several maps: `python -m c2s_bench.perf.texts --maps FOLDER MAP...`

The texts are those of `c2s_bench.through`; one of them is taken once more before, so that the maps have been read. A
map that has no such place is left out for a text. Run it on a machine that does nothing else.
"""

import argparse
import asyncio
import statistics

from c2s_bench.through.run import fresh
from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.structure.progress import Finished


async def seconds(engine: Engine, text: str, name: str) -> float | None:
    """From the text to the verdict (s); None: refused."""
    done = [e async for e in engine.generate(text, map=name) if isinstance(e, Finished)][0]
    return done.seconds if done.ok else None


async def measured(folder: str, names: list[str], every: int) -> dict[str, dict[str, float]]:
    """By map and text, the time (s)."""
    found: dict[str, dict[str, float]] = {name: {} for name in names}
    async with Engine(Settings(map_folders=(folder,), offers=False)) as engine:
        texts = [description.text for description in fresh()]
        for name in names:
            await seconds(engine, texts[-1], name)
        for text in texts[:-1:every]:
            for name in names:
                if (time := await seconds(engine, text, name)) is not None:
                    found[name][text] = time
    return found


def main() -> None:
    """Print the medians, and by how much more each text takes than on the first map."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("maps", nargs="+", help="the first is what the others are compared with")
    parser.add_argument("--maps", dest="folder", default="", help="the folder that has the towns")
    parser.add_argument("--every", type=int, default=1, help="only every so many texts")
    given = parser.parse_args()
    times = asyncio.run(measured(given.folder, given.maps, given.every))
    first = times[given.maps[0]]
    print("| map | texts | median s | most s | median s more than on the first |\n| --- | --- | --- | --- | --- |")
    for name, by_text in times.items():
        more = statistics.median(by_text[text] - first[text] for text in by_text if text in first)
        median, most = statistics.median(by_text.values()), max(by_text.values())
        print(f"| {name} | {len(by_text)} | {median:.2f} | {most:.2f} | {more:+.2f} |")


if __name__ == "__main__":
    main()

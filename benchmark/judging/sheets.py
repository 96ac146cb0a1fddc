"""Writing dossiers for judges, with what they must not see kept beside the folder."""

import gzip
from collections.abc import Iterator, Sequence
from pathlib import Path

from c2s_bench.records import BenchmarkError
from c2s_engine.report.gather import TextRecord, of_text
from c2s_engine.report.material import Material
from c2s_engine.report.writing import write

RUBRIC = Path(__file__).with_name("rubric.md")


async def write_dossiers(
    told: Sequence[TextRecord], out: Path, *, blind: bool = True, method: str | None = None, model: str | None = None,
    seed: int = 0,
) -> list[Material]:  # fmt: skip
    """A folder for each text with its dossier under the rubric; the run itself goes to `out`.key for the comparison."""
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    head, key, made = RUBRIC.read_text("utf-8").rstrip(), key_folder(out), []
    key.mkdir(parents=True, exist_ok=True)
    async with Engine(load_settings(model=model)) as engine:
        for record in told:
            material = await of_text(engine, record, method=method, seed=seed)
            write(material, out / record.id, blind=blind, head=head)
            (key / f"{record.id}.json.gz").write_bytes(gzip.compress(material.model_dump_json().encode(), mtime=0))
            made.append(material)
    return made


def key_folder(out: Path) -> Path:
    """Where what judges must not see lies."""
    return out.with_name(f"{out.name}.key")


def materials(out: Path) -> Iterator[Material]:
    """The scenarios that dossiers were written of; raises BenchmarkError where there are none."""
    files = sorted(key_folder(out).glob("*.json.gz"))
    if not files:
        raise BenchmarkError(f"{key_folder(out)} holds no runs: write the dossiers first, with --out {out}.")
    for file in files:
        try:
            yield Material.model_validate_json(gzip.decompress(file.read_bytes()))
        except (OSError, ValueError):
            raise BenchmarkError(f"{file} cannot be read: write the dossiers again.") from None

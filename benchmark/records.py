"""Benchmark records: read from YAML, checked against FORMAT.md, split into their two parts."""

import importlib.util
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any, Literal

import yaml

FOLDER = Path(__file__).parent / "records"
Part = Literal["dev", "test"]
Split = Literal["dev", "test", "all"]


class BenchmarkError(Exception):
    """Something that the user has to mend; the message says what and where."""


@dataclass(frozen=True)
class Record:
    """One record with where it stands; `shipped` where its file is one of the project's."""

    id: str
    source: str
    text: str
    tags: dict[str, Any]
    expect: dict[str, Any]
    reference: str
    file: Path
    line: int
    shipped: bool

    @property
    def part(self) -> Part:
        """The reporting part (`test`) holds the ids whose number is divisible by 3."""
        return part_of(self.id)

    @property
    def withheld(self) -> bool:
        """Whether its own results are shown only when asked for: the reporting part of the shipped records."""
        return self.shipped and self.part == "test"


def part_of(identity: str) -> Part:
    """The part of a record by its id."""
    return "test" if int(identity.rsplit("-", 1)[1]) % 3 == 0 else "dev"


@cache
def validator() -> ModuleType:
    """The checker that lies beside the records, as a module."""
    spec = importlib.util.spec_from_file_location("c2s_bench_validate", FOLDER / "validate.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def load(files: Sequence[Path] | None = None, split: Split = "all") -> list[Record]:
    """The records of those files (default: the shipped ones); raises BenchmarkError listing every broken record."""
    ours = FOLDER.parent.resolve()
    paths = sorted(FOLDER.glob("*.yaml")) if files is None else list(files)
    records: list[Record] = []
    problems: list[str] = []
    first: dict[str, str] = {}
    for path in paths:
        shipped = path.resolve().is_relative_to(ours)
        for record, found in _checked(path, path.stat().st_mtime_ns if path.exists() else 0, shipped):
            errors = list(found)
            where = f"{path.name}:{record.line}"
            if record.id in first:
                errors.append(f"{where}: {record.id}: id: is used before, at {first[record.id]}")
            first.setdefault(record.id, where)
            problems += errors
            records.append(record)
    if problems:
        count = len(problems)
        head = f"{count} problem{'s' if count > 1 else ''} in the benchmark records (the format: FORMAT.md)"
        raise BenchmarkError("\n".join([head, *problems]))
    if not records:
        raise BenchmarkError("there is no record in " + ", ".join(map(str, paths)))
    return [r for r in records if split == "all" or r.part == split]


def by_source(records: Iterable[Record]) -> dict[str, list[Record]]:
    """The records of each source, the benchmark's own sources first and in their order."""
    grouped: dict[str, list[Record]] = {}
    for record in records:
        grouped.setdefault(record.source, []).append(record)
    known = list(validator().SOURCES)
    return {s: grouped[s] for s in sorted(grouped, key=lambda s: (known.index(s) if s in known else len(known), s))}


@cache
def _checked(path: Path, changed: int, shipped: bool) -> list[tuple[Record, list[str]]]:
    """A file's records, read once as long as it does not change."""
    return list(_read(path, shipped))


def _read(path: Path, shipped: bool) -> Iterable[tuple[Record, list[str]]]:
    try:
        loader = validator().UniqueKeyLoader(path.read_text(encoding="utf-8"))
        root = loader.get_single_node()
        items = loader.construct_document(root) if root else None
    except OSError as error:
        raise BenchmarkError(f"{path} cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise BenchmarkError(f"{path} is no text in UTF-8") from None
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        raise BenchmarkError(f"{path.name}:{mark.line + 1 if mark else 1}: no YAML: {error.problem}") from None
    if not isinstance(items, list):
        raise BenchmarkError(f"{path.name}:1: must be a list of records")
    for number, (node, item) in enumerate(zip(root.value, items, strict=True), 1):
        line = node.start_mark.line + 1
        name = str(item.get("id") or f"record {number}") if isinstance(item, dict) else f"record {number}"
        errors = [
            f"{path.name}:{_line(node, key)}: {name}: {key}: {message}"
            for key, message in validator().RecordCheck(item).run()
        ]
        data = item if isinstance(item, dict) else {}
        yield (
            Record(
                id=name,
                source=str(data.get("source", "")),
                text=str(data.get("text", "")).strip(),
                tags=data.get("tags") or {},
                expect=data.get("expect") or {},
                reference=str(data.get("reference", "")),
                file=path,
                line=line,
                shipped=shipped,
            ),
            errors,
        )


def _line(node: yaml.Node, key: str) -> int:
    """The line (1-based) of a key such as `expect.actors[0].type`, or of the nearest that is there."""
    line = node.start_mark.line + 1
    for name, index in re.findall(r"([^.\[\]]+)|\[(\d+)\]", key):
        if index and isinstance(node, yaml.SequenceNode) and int(index) < len(node.value):
            node = node.value[int(index)]
            line = node.start_mark.line + 1
        elif name and isinstance(node, yaml.MappingNode):
            for child, value in node.value:
                if str(child.value) == name:
                    node, line = value, child.start_mark.line + 1
                    break
            else:
                return line
        else:
            return line
    return line

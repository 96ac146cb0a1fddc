"""`c2s bench`: run, explain, compare, rate and tabulate."""

import json
import os
import sys
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from c2s_bench.records import BenchmarkError, Record, load
from c2s_engine.config import METHOD

app = typer.Typer(
    help="The benchmark: how well methods turn texts into programs that do what the text says.",
    invoke_without_command=True,
    no_args_is_help=False,
)


class SplitName(StrEnum):
    """The parts of the benchmark: ids divisible by 3 report (test), the others develop (dev)."""

    dev = "dev"
    test = "test"
    all = "all"


Runs = Annotated[int, typer.Option("--runs", min=1, max=50, help="Rollouts of each program (K).")]
Jobs = Annotated[int, typer.Option("--jobs", min=0, help="Processes at a time; 0: in this one.")]
SplitOption = Annotated[SplitName, typer.Option("--split", help="Which part: ids divisible by 3 are `test`.")]
Files = Annotated[
    list[Path] | None, typer.Option("--records", help="Records of your own in the same format (may be repeated).")
]
Scheduler = Annotated[str, typer.Option("--scheduler", help="Run on the Dask cluster at that address.")]
Fresh = Annotated[bool, typer.Option("--fresh", help="Run again what is known from before.")]
Reveal = Annotated[bool, typer.Option("--reveal", help="Show the reporting part record by record, too.")]
Seed = Annotated[int, typer.Option("--seed", help="Of the first rollout.")]
Method = Annotated[
    str,
    typer.Option("--method", help="reader, typed, mixed, chat2scenic:C1 to :C12, chatscene, nl2scenic."),
]
Model = Annotated[str, typer.Option("--model", help="The language model, for methods that use one.")]
EngineOption = Annotated[str, typer.Option("--engine", hidden=True)]
CORES = os.cpu_count() or 1


@app.callback()
def bench(
    context: typer.Context,
    method: Method = METHOD,
    model: Model = "",
    split: SplitOption = SplitName.all,
    runs: Runs = 5,
    jobs: Jobs = CORES,
    records: Files = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
    explain: Annotated[str, typer.Option("--explain", metavar="ID", help="Show one record atom by atom.")] = "",
    atoms: Annotated[bool, typer.Option("--atoms", help="List every atom that fails, by kind.")] = False,
    reveal: Reveal = False,
    scheduler: Scheduler = "",
    out: Annotated[Path | None, typer.Option("--out", help="Write the results there as JSON lines.")] = None,
    seed: Seed = 0,
    map_name: Annotated[str | None, typer.Option("--map", help="Place every scenario on that map.")] = None,
    fresh: Fresh = False,
    engine: EngineOption = "",
) -> None:
    """Run a method on the records and print the paper's table; what is known from before is not run again."""
    if context.invoked_subcommand:
        return
    with _one_sentence():
        from c2s_bench import tables
        from c2s_bench.execute import execute
        from c2s_bench.explain import explain as explanation
        from c2s_bench.results import as_json as json_of
        from c2s_bench.results import results_file, save
        from c2s_bench.tasks import Setup

        chosen = load(records, split.value)
        if explain:
            chosen = [_record(load(records), explain, reveal)]
        setup = Setup(method, model, map_name, runs, seed)
        results = execute(chosen, setup, jobs=jobs, scheduler=scheduler, fresh=fresh, engine=engine)
        if explain:
            typer.echo(explanation(chosen[0], results[0]))
            return
        stem = "-".join([setup.name, *(p.stem for p in records or ())])
        save(results, results_file(stem))
        if out:
            save([r for r in results if reveal or not r.withheld], out)
        if as_json:
            typer.echo(json.dumps(json_of(results, setup, reveal), indent=1))
        else:
            typer.echo(tables.by_source(results))
            typer.echo("\nBy kind of atom, where the program ran:\n\n" + tables.by_kind(results))
            typer.echo("\n" + tables.requirements(results))
            _list_failures(results, reveal)
            if atoms:
                typer.echo("\nAtoms that fail, where the program ran:\n")
                typer.echo(tables.failing(results, reveal))


@app.command()
def compare(a: str, b: str, reveal: Reveal = False) -> None:
    """Show what changed from A to B (files of results, or methods that were run), by record and atom."""
    with _one_sentence():
        from c2s_bench.compare import compare as difference
        from c2s_bench.results import load_results

        typer.echo(difference(load_results(a), load_results(b), (a, b), reveal))


@app.command()
def rate(
    out: Annotated[Path | None, typer.Option("--out", help="Write a sheet for scores by hand there.")] = None,
    read: Annotated[Path | None, typer.Option("--read", help="Read a filled sheet, print the agreement.")] = None,
    method: Method = METHOD,
    model: Model = "",
    split: SplitOption = SplitName.dev,
    runs: Runs = 5,
    jobs: Jobs = CORES,
    records: Files = None,
    every: Annotated[int, typer.Option("--every", min=1, help="Only every n-th record.")] = 1,
    reveal: Reveal = False,
    seed: Seed = 0,
    engine: EngineOption = "",
) -> None:
    """Have people score what was generated, layer by layer as in the paper, and compare with the executed scores."""
    with _one_sentence():
        from c2s_bench.execute import execute
        from c2s_bench.pictures import text_pictures
        from c2s_bench.rate import markdown, read_sheet, write_sheet
        from c2s_bench.tasks import Setup

        if (out is None) == (read is None):
            raise BenchmarkError("say either --out SHEET to write a sheet or --read SHEET to read a filled one")
        if read:
            typer.echo(markdown(read_sheet(read)))
        elif out:
            chosen = [r for r in load(records, split.value) if reveal or not r.withheld][::every]
            results = execute(chosen, Setup(method, model, None, runs, seed), jobs=jobs, engine=engine)
            pictures = text_pictures(results, seed)
            facts = {r.id: r.first for r in results if r.first}
            number = write_sheet(out, chosen, results, facts, pictures.__getitem__)
            typer.echo(f"{number} programs that ran are on {out}; {len(chosen) - number} did not run.")


@app.command()
def judge(
    records: Annotated[Path | None, typer.Argument(help="A YAML list of maps with id, text, matters.")] = None,
    out: Annotated[Path | None, typer.Option("--out", help="Write a dossier for each text there.")] = None,
    read: Annotated[Path | None, typer.Option("--read", help="Read the verdicts in that folder.")] = None,
    blind: Annotated[bool, typer.Option("--blind/--open", help="Without method, scores and requirements.")] = True,
    method: Method = METHOD,
    model: Model = "",
    seed: Seed = 0,
) -> None:
    """Write dossiers for judges under the rubric, or read what they found and how far they agree."""
    with _one_sentence():
        from c2s_bench.judging.run import read_verdicts, write_for_judges

        if (out is None) == (read is None) or (out is None) != (records is None):
            raise BenchmarkError("say either RECORDS --out FOLDER to write dossiers or --read FOLDER to read verdicts")
        if read:
            typer.echo(read_verdicts(read))
        elif out and records:
            typer.echo(write_for_judges(records, out, blind=blind, method=method, model=model or None, seed=seed))


@app.command()
def rewording(
    pairs: Annotated[Path | None, typer.Option("--pairs", help="A YAML list of pairs of texts of your own.")] = None,
    method: Method = METHOD,
    model: Model = "",
    seed: Seed = 0,
    every: Annotated[bool, typer.Option("--all", help="Show all pairs that differ, not only the worst.")] = False,
    engine: EngineOption = "",
) -> None:
    """Read texts that mean the same in other words, and show how far the same is required of a run."""
    with _one_sentence():
        from c2s_bench.host import REAL
        from c2s_bench.rewording import PAIRS, markdown, read_pairs, stability
        from c2s_bench.tasks import Setup

        found = read_pairs(pairs or PAIRS)
        setup = Setup(method, model, None, 1, seed)
        done = stability(found, setup, engine or REAL, lambda n: typer.echo(f"{n} of {len(found)}", err=True))
        typer.echo(markdown(done, every))


@app.command()
def distribution(records: Files = None) -> None:
    """Print how the records are distributed, beside the paper's table."""
    with _one_sentence():
        from c2s_bench.distribution import markdown

        typer.echo(markdown(load(records)))


@app.command()
def table(
    models: Annotated[str, typer.Option("--models", help="Models, by commas; `reader` is the method without one.")],
    method: Method = "chat2scenic:C11",
    split: SplitOption = SplitName.all,
    runs: Runs = 5,
    jobs: Jobs = CORES,
    records: Files = None,
    scheduler: Scheduler = "",
    baselines: Annotated[bool, typer.Option(help="Also the two baselines, with the first model.")] = True,
    engine: EngineOption = "",
) -> None:
    """Print the paper's second table: models and baselines."""
    with _one_sentence():
        from c2s_bench import tables
        from c2s_bench.execute import execute
        from c2s_bench.results import total_of
        from c2s_bench.tasks import Setup

        names = [m.strip() for m in models.split(",") if m.strip()]
        setups = {m: Setup(METHOD if m == METHOD else method, "" if m == METHOD else m) for m in names}
        first = next((m for m in names if m != METHOD), "")
        if baselines and first:
            setups |= {f"{m} ({first})": Setup(m, first) for m in ("chatscene", "nl2scenic")}
        chosen, rows = load(records, split.value), {}
        for label, setup in setups.items():
            setup = Setup(setup.method, setup.model, None, runs)
            rows[label] = total_of(execute(chosen, setup, jobs=jobs, scheduler=scheduler, engine=engine))
        typer.echo(tables.models(rows))


@app.command()
def ablation(
    model: Model = "",
    only: Annotated[str, typer.Option("--only", help="Configurations, by commas; default C1 to C12.")] = "",
    split: SplitOption = SplitName.all,
    runs: Runs = 5,
    jobs: Jobs = CORES,
    records: Files = None,
    scheduler: Scheduler = "",
    engine: EngineOption = "",
) -> None:
    """Print the paper's first table: the twelve prompting configurations with one model."""
    with _one_sentence():
        from c2s_bench import tables
        from c2s_bench.execute import execute
        from c2s_bench.results import total_of
        from c2s_bench.tasks import Setup

        known = [f"C{n}" for n in range(1, 13)]
        names = [n.strip() for n in only.split(",") if n.strip()] or known
        if wrong := [n for n in names if n not in known]:
            raise BenchmarkError(f"{wrong[0]} is no configuration; there are C1 to C12")
        chosen = load(records, split.value)
        setups = {name: Setup(f"chat2scenic:{name}", model, None, runs) for name in names}
        rows = {
            name: total_of(execute(chosen, setup, jobs=jobs, scheduler=scheduler, engine=engine))
            for name, setup in setups.items()
        }
        typer.echo(tables.ablation(rows))


def _record(records: list[Record], identity: str, reveal: bool) -> Record:
    for record in records:
        if record.id == identity:
            if record.withheld and not reveal:
                raise BenchmarkError(f"{identity} is of the reporting part, kept unseen: --reveal shows it")
            return record
    raise BenchmarkError(f"there is no record {identity}")


def _list_failures(results: list, reveal: bool) -> None:
    shown = [r for r in results if not r.score.ran and (reveal or not r.withheld)]
    if shown:
        typer.echo("\nDid not run:\n")
        for result in shown:
            typer.echo(f"- {result.id}: {result.reason}")


class _one_sentence:
    """Faults that the user can mend end the command with their sentence, not with a traceback."""

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: type | None, error: BaseException | None, trace: object) -> None:
        if isinstance(error, BenchmarkError):
            typer.echo(str(error), err=True)
            raise typer.Exit(1) from None
        if isinstance(error, KeyboardInterrupt):
            typer.echo("Stopped. The same command goes on from here.", err=True)
            sys.exit(130)

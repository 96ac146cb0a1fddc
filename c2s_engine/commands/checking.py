"""`c2s check` and `c2s run`: any Scenic driving program."""

import csv
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.text import Text

from c2s_engine.check.protocol import CheckReport, Upto
from c2s_engine.commands import show
from c2s_engine.commands.console import BAD_INPUT, OK, REFUSED, dump, err, fail, out, sentences, work
from c2s_engine.commands.reading import judged_by, read_program
from c2s_engine.commands.series import chosen_seeds, series
from c2s_engine.saving import beside, spans, taken
from c2s_engine.structure.components import Structure
from c2s_engine.structure.measures import Measures
from c2s_engine.structure.program import run_limit
from c2s_engine.structure.requirements import Requirement, Result

if TYPE_CHECKING:
    from c2s_engine.api import Engine

File = Annotated[Path, typer.Argument(help="A .scenic file.")]
Seed = Annotated[int, typer.Option(help="The seed of the sampled scene.")]
Trust = Annotated[bool, typer.Option("--trust", help="Trust the file: skip the safety stage.")]
OnMap = Annotated[str | None, typer.Option("--map", help="Use this map instead of the one that the program names.")]
Model = Annotated[str | None, typer.Option("--model", help="Use this world model, not the one that the program names.")]
Modular = Annotated[str | None, typer.Option("--scenario", help="Of several modular scenarios, the one to run.")]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON object.")]


def check(
    file: File,
    seed: Seed = 0,
    trust: Trust = False,
    fix: Annotated[bool, typer.Option("--fix", help="Write the deterministic fixes back to the file.")] = False,
    upto: Annotated[str, typer.Option(help="parse, safety, compile or sample.")] = "sample",
    map_name: OnMap = None,
    model: Model = None,
    scenario: Modular = None,
    as_json: Json = False,
) -> None:
    """Check a program: syntax, safety, compile, sample; where and why it fails, and what would mend it."""
    with sentences(as_json):
        text = read_program(file)
        if upto not in ("parse", "safety", "compile", "sample"):
            fail(f"There is no stage {upto}: say parse, safety, compile or sample.", BAD_INPUT, as_json)
    given = {"map": map_name, "model": model, "scenario": scenario}
    report: CheckReport = work(_check(text, file, upto, seed, trust, **given), as_json)  # type: ignore[arg-type]
    fixed = 0
    if fix:
        text, fixed = work(_fix(text, file, seed, trust, **given), as_json)
        if fixed:
            with sentences(as_json):
                draft = file.with_name(f".{file.name}.part")
                draft.write_text(text, encoding="utf-8")
                draft.replace(file)
            report = work(_check(text, file, upto, seed, trust, **given), as_json)  # type: ignore[arg-type]
    if as_json:
        dump({"ok": report.ok, "fixed": fixed, **report.model_dump(mode="json", exclude={"facts", "trajectories"})})
    else:
        if fix:
            words = f"{fixed} fix{'es' * (fixed != 1)} written to {file}"
            err.print(Text(words if fixed else "There was nothing to fix."))
        if taken(file, text):
            err.print(Text(f"Components as in {beside(file).name}.", style="dim"))
        show.stages(report.stages)
        show.diagnostics(d for s in report.stages for d in s.diagnostics)
        if trust:
            out.print(Text("trusted: the safety stage was skipped", style="yellow"))
        if report.isolation:
            out.print(Text(report.isolation, style="dim"))
    raise typer.Exit(OK if report.ok else REFUSED)


async def _check(text: str, file: Path, upto: Upto, seed: int, trust: bool, **options: Any) -> CheckReport:
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    places: dict[str, Any] = {"spans": spans(taken(file, text)), "folder": str(file.resolve().parent)}
    async with Engine(load_settings()) as engine:
        return await engine.check(
            text, upto=upto, seed=seed, trust=trust, filename=file.name, **places, **options
        )


async def _fix(text: str, file: Path, seed: int, trust: bool, **given: Any) -> tuple[str, int]:
    return await fixed(text, lambda text: _check(text, file, "sample", seed, trust, **given))


async def fixed(text: str, check: Callable[[str], Awaitable[CheckReport]]) -> tuple[str, int]:
    """Apply deterministic fixes until none is offered; the text and how many were applied."""
    from c2s_engine.check.fixes import apply_fixes

    applied = 0
    for _ in range(12):
        report = await check(text)
        found = [d for s in report.stages for d in s.diagnostics if d.edit]
        after = apply_fixes(text, found)
        if not found or after == text:
            break
        applied += len(found)
        text = after
    return text, applied


def run(
    file: File,
    seed: Seed = 0,
    runs: Annotated[int, typer.Option(min=1, max=100, help="Rollouts.")] = 1,
    seeds: Annotated[
        str | None,
        typer.Option(help="Run it once with each of N seeds: 20, or 5-9; a row each, passed or failed. Files (--svg, "
                          "--png, --csv) are of the first seed's run."),
    ] = None,
    seconds: Annotated[
        float | None,
        typer.Option(min=0.1, max=600, help="Simulated seconds at most; default: 20, or the program's own end."),
    ] = None,
    simulator: Annotated[str, typer.Option(help="dry (no CARLA needed) or carla.")] = "dry",
    address: Annotated[str, typer.Option(help="carla: HOST:PORT of the server.")] = "127.0.0.1:2000",
    svg: Annotated[Path | None, typer.Option(help="Write a top-down picture.")] = None,
    png: Annotated[Path | None, typer.Option(help="Write a top-down picture.")] = None,
    csv_file: Annotated[Path | None, typer.Option("--csv", help="Write the trajectories.")] = None,
    picture: Annotated[bool, typer.Option("--picture", help="Show the scene in text graphics.")] = False,
    trust: Trust = False,
    map_name: OnMap = None,
    model: Model = None,
    scenario: Modular = None,
    as_json: Json = False,
) -> None:
    """Run a program without CARLA (or in CARLA) and print the timeline of its events."""
    with sentences(as_json):
        text, chosen = read_program(file), chosen_seeds(seeds, seed)
    if simulator == "carla":
        from c2s_engine.dryrun.carla import run_in_carla

        with sentences(as_json):
            most = seconds or run_limit(text, 20.0)
            raise typer.Exit(
                run_in_carla(text, file, address=address, seed=seed, seconds=most, model=model, scenario=scenario)
            )
    if simulator != "dry":
        fail(f"There is no simulator {simulator}: say dry or carla.", BAD_INPUT, as_json)
    if chosen:
        given: dict[str, Any] = {"trust": trust, "seconds": seconds, "map": map_name, "model": model}
        given["scenario"] = scenario
        code, found = series(None, text, chosen, as_json, file, **given)
        if svg or png or csv_file:
            first: Ran = work(_run(text, file, chosen[0], **given), as_json)
            with sentences(as_json):
                written = _write_files(first.report, svg, png, csv_file)
            if not as_json:
                names = ", ".join(map(str, written)) or "no file was written"
                run_of = f"of the run with seed {chosen[0]}" if written else f"seed {chosen[0]} did not run"
                err.print(Text(f"{names}: {run_of}"), soft_wrap=True)
        if as_json:
            dump(found)
        raise typer.Exit(code)
    options = {"runs": runs, "seconds": seconds, "map": map_name, "model": model, "scenario": scenario}
    ran: Ran = work(_run(text, file, seed, trust, **options), as_json)
    report = ran.report
    with sentences(as_json):
        _write_files(report, svg, png, csv_file)
    if as_json:
        required = show.required_as_dicts(ran.requirements, ran.results)
        numbers = [m.model_dump(mode="json") for m in ran.measures]
        told = {"judged_by": ran.judged_by, "requirements": required, "measures": numbers}
        dump({"ok": report.ok, **told, **report.model_dump(mode="json")})
    else:
        show.stages(report.stages)
        show.diagnostics(d for s in report.stages for d in s.diagnostics)
        if picture and report.trajectories:
            from c2s_engine.dryrun.picture import text_picture

            out.print(Text(text_picture(report.trajectories[0], columns=min(out.width, 120), rows=36)))
        if ran.results:
            out.print(Text(ran.judged_by, style="dim"), soft_wrap=True)
        show.outcome(ran.structure, report.facts, ran.requirements, ran.results, ran.measures)
    raise typer.Exit(OK if report.ok else REFUSED)


@dataclass(frozen=True)
class Ran:
    """A program's runs, the S that they are judged by (and which that is, in words), and what it requires of them."""

    report: CheckReport
    structure: Structure = Structure()
    requirements: tuple[Requirement, ...] = ()
    results: tuple[Result, ...] = ()
    measures: tuple[Measures, ...] = ()
    judged_by: str = ""


async def _run(text: str, file: Path, seed: int, trust: bool, **options: Any) -> Ran:
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    async with Engine(load_settings()) as engine:
        return await ran(engine, text, str(file.resolve().parent), file.name, seed, trust=trust, **options)


async def ran(engine: "Engine", text: str, folder: str | None, filename: str, seed: int, **options: Any) -> Ran:
    """A program's dry runs with trajectories, and what is required of them. `options`: of `Engine.check`."""
    structure, program, words = await judged_by(engine, text, Path(folder) / filename if folder else None)
    report = await engine.check(
        text, spans=program.spans, upto="run", seed=seed, folder=folder, filename=filename, trajectories=True, **options
    )
    found = await engine.judge(structure if program.spans else None, report, seed=seed)
    return Ran(report, structure, found.requirements, found.results, found.measures, words)


def _write_files(report: CheckReport, svg: Path | None, png: Path | None, csv_file: Path | None) -> list[Path]:
    """Write the files that are asked for; those that were written: none where nothing ran."""
    if not report.trajectories:
        return []
    first = report.trajectories[0]
    if svg:
        from c2s_engine.dryrun.picture import svg_picture

        svg.write_text(svg_picture(first), encoding="utf-8")
    if png:
        from c2s_engine.dryrun.picture import png_picture

        png.write_bytes(png_picture(first))
    if csv_file:
        with csv_file.open("w", newline="", encoding="utf-8") as stream:
            rows = csv.writer(stream)
            rows.writerow(["run", "time_s", "object", "x_m", "y_m", "heading_rad", "speed_mps"])
            for k, ways in enumerate(report.trajectories):
                for track in ways.tracks:
                    for i in range(len(track.x)):
                        rows.writerow(
                            [
                                k,
                                round(i * ways.step, 3),
                                track.name,
                                track.x[i],
                                track.y[i],
                                track.heading[i],
                                track.speed[i],
                            ]
                        )
    return [file for file in (svg, png, csv_file) if file]

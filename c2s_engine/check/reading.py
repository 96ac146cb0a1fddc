"""The reader process: parses, lints and compiles programs piece by piece, remembers the pieces, runs none."""

import ast
import functools
import hashlib
import marshal
import pickle
import socket
import time
from collections import OrderedDict
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from c2s_engine import driving
from c2s_engine.check import beginnings, catalogue, diagnose, library, lint, pieces, safety, wire, world
from c2s_engine.check.beside import MODULES, Texts
from c2s_engine.structure.diagnostics import Diagnostic, StageResult

KEEP = 4000  # pieces
MODEL = "scenic.simulators.carla.model"  # of most programs


class BrokenModule(Exception):
    """A module beside a program does not parse; `diagnostic` says where and why."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(diagnostic.message)
        self.diagnostic = diagnostic


@dataclass
class Beside:
    """A module beside a program: what it gives, which of the names are its own, and what in it is not allowed."""

    world: world.World
    own: frozenset[str]
    unsafe: list[Diagnostic]


@dataclass
class Compiled:
    """One piece: its code, what it adds to the requirements, its digest's text, and what the lints found in it."""

    code: bytes
    digest: str  # of the code
    requirements: list
    syntax_id: int
    dump: str
    facts: lint.PieceFacts
    unsafe: list[Diagnostic]
    first: int
    beginning: beginnings.Beginning


@dataclass
class Reader:
    """Reads programs; keeps what it compiled."""

    cache: OrderedDict = field(default_factory=OrderedDict)
    trees: OrderedDict = field(default_factory=OrderedDict)
    modules: OrderedDict = field(default_factory=OrderedDict)

    def __post_init__(self) -> None:
        pieces.portable()
        self.trusted = frozenset() if library.fault() else frozenset(p.text for p in pieces.cut(driving.text()))

    def read(self, request: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        """The stages parse and safety of a request, and the code where they pass."""
        text, filename = request["program"], request["filename"]
        where = diagnose.Program(text, filename, request["spans"])
        stages: list[StageResult] = []
        started = time.perf_counter()
        if "\0" in text:
            before = text[: text.index("\0")].count("\n") + 1
            null = where.locate(catalogue.finding("null_character", before, None))
            return {"stages": _dump([_stage("parse", started, (null,))])}, b""
        try:
            parts = self._compile(where)
        except Exception as error:
            stages.append(_stage("parse", started, (diagnose.diagnose(error, "parse", where),)))
            return {"stages": _dump(stages)}, b""
        if driving.used_by(text) and driving.MODULE not in (request.get("modules") or {}) and library.fault():
            broken = Diagnostic(stage="parse", code="library", message=library.fault())
            return {"stages": _dump([_stage("parse", started, (broken,))])}, b""
        try:
            beside = self._beside(request.get("modules") or {})
        except BrokenModule as error:
            return {"stages": _dump([_stage("parse", started, (error.diagnostic,))])}, b""
        worlds = {name: module.world for name, module in beside.items()}
        found = lint.check([p.facts for p in parts], where, worlds, request.get("model"))
        stages.append(_stage("parse", started, found))
        started = time.perf_counter()
        if not stages[-1].ok or request["upto"] == "parse":
            return {"stages": _dump(stages)}, b""
        if not request["trust"]:
            stages.append(_stage("safety", started, _unsafe(request, parts, beside, where)))
            if not stages[-1].ok or request["upto"] == "safety":
                return {"stages": _dump(stages)}, b""
        digest = pieces.ast_hash([p.dump for p in parts])
        header = {"stages": _dump(stages), "ast_hash": digest.hex(), **_beginning(parts, driving.MODULE in beside)}
        requirements = [r for p in parts for r in p.requirements]
        blob = pickle.dumps(([p.code for p in parts], requirements, digest))
        return header, blob

    def _beside(self, texts: Texts) -> dict[str, Beside]:
        """The modules beside a program, each read once; raises BrokenModule where one does not parse."""
        read = {name: self._parsed(name, file, text) for name, (file, text) in texts.items()}
        known = {name: module for name, (module, _) in read.items()}
        return {name: Beside(_world(name, known), _own(module), unsafe) for name, (module, unsafe) in read.items()}

    def _parsed(self, name: str, file: str, text: str) -> tuple[world.Module, list[Diagnostic]]:
        """What a module beside a program defines, and what in it is not on the allow-list."""
        if (name, file, text) not in self.modules:
            try:
                tree = pieces.parse(text, file) if file.endswith(".scenic") else ast.parse(text, file)
            except Exception as error:
                raise BrokenModule(_broken(error, name, file, text)) from None
            self.modules[name, file, text] = world.read_module(tree), self._unsafe_in(name, file, text, tree)
            if len(self.modules) > 4 * MODULES:
                self.modules.popitem(last=False)
        return self.modules[name, file, text]

    def _unsafe_in(self, name: str, file: str, text: str, tree: Any) -> list[Diagnostic]:
        """What in a module is not allowed; of a driving library only what the shipped one does not say, too."""
        trees = [tree]
        if name == driving.MODULE:
            foreign = [part for part in pieces.cut(text) if part.text not in self.trusted]
            trees = [pieces.parse(part.text, file, part.first - 1) for part in foreign]
        nowhere = {"line": None, "column": None}
        return [
            d.model_copy(update={**nowhere, "message": f"{Path(file).name}, line {d.line}: {d.message}"})
            for one in trees
            for d in safety.examine(one)
        ]

    def _compile(self, where: diagnose.Program) -> list[Compiled]:
        try:
            parts = pieces.cut(where.text)
        except pieces.Cut as endless:
            try:
                pieces.parse(pieces.unfinished(where.lines, endless.first), where.filename, endless.first - 1)
            except Exception as error:
                if "EOF" in str(error) or "never closed" in str(error):
                    error.lineno, error.offset = endless.first, None  # type: ignore[attr-defined]
                raise
            parts = [pieces.Piece(1, len(where.lines), where.text)]
        done: list[Compiled] = []
        count, syntax_id = 0, 0
        for part in parts:
            key = (part.text, part.first, where.filename, count, syntax_id)
            compiled = self.cache.get(key)
            if compiled is None:
                compiled = self.cache[key] = self._piece(part, where.filename, count, syntax_id)
                if len(self.cache) > KEEP:
                    self.cache.popitem(last=False)
            else:
                self.cache.move_to_end(key)
            count += len(compiled.requirements)
            syntax_id = compiled.syntax_id
            done.append(compiled)
        return done

    def _piece(self, part: pieces.Piece, filename: str, count: int, syntax_id: int) -> Compiled:
        tree = self._tree(part, filename)
        facts = lint.gather(tree)
        unsafe = [] if part.text in self.trusted else safety.examine(tree)
        beginning = beginnings.beginning(tree)
        python, requirements, syntax_id = pieces.translate(tree, filename, [None] * count, syntax_id, part.first)
        code = marshal.dumps(compile(python, filename, "exec"))
        return Compiled(
            code=code,
            digest=hashlib.blake2b(code, digest_size=16).hexdigest(),
            requirements=requirements[count:],
            syntax_id=syntax_id,
            dump=", ".join(ast.dump(s) for s in python.body),
            facts=facts,
            unsafe=unsafe,
            first=part.first,
            beginning=beginning,
        )

    def _tree(self, part: pieces.Piece, filename: str) -> Any:
        """The piece's Scenic tree, parsed only where its text is new, whatever line it stands on."""
        stored = self.trees.get(part.text)
        if stored is None:
            try:
                stored = pickle.dumps(pieces.parse(part.text, filename))
            except Exception:
                return pieces.parse(part.text, filename, part.first - 1)
            self.trees[part.text] = stored
            if len(self.trees) > KEEP:
                self.trees.popitem(last=False)
        else:
            self.trees.move_to_end(part.text)
        return pieces.shifted(pickle.loads(stored), part.first - 1)


def _unsafe(
    request: dict[str, Any], parts: list[Compiled], beside: dict[str, Beside], where: diagnose.Program
) -> tuple[Diagnostic, ...]:
    """What is not allowed in a program and in the modules beside it."""
    allow = {tuple(pair) for pair in request["allow"]}
    model, own = request.get("model"), {name: module.own for name, module in beside.items()}
    found = [where.locate(d) for p in parts for d in p.unsafe if not (model and d.code.startswith("model "))]
    found += [d for module in beside.values() for d in module.unsafe]
    if model and model not in safety.rules()["import_models"]:
        found.append(Diagnostic(stage="safety", code=f"model {model} *", fix=safety.FIX,
                                message=f"not allowed in a scenario: the world model {model}"))  # fmt: skip
    return tuple(d for d in found if not safety.allowed(d, allow) and not safety.beside(d, own))


def _broken(error: Exception, name: str, file: str, text: str) -> Diagnostic:
    if name == driving.MODULE:
        found = diagnose.diagnose(error, "parse", diagnose.Program(text, file))
        said = f"the {driving.FILE} beside the program, line {found.line or 1}: {found.message}"
        return Diagnostic(stage="parse", code="library", message=said, fix="delete it to use this version's own")
    found = diagnose.diagnose(error, "parse", diagnose.Program(text, file))
    return Diagnostic(stage="parse", code=found.code, fix=found.fix,
                      message=f"{Path(file).name}, line {found.line or 1}: {found.message}")  # fmt: skip


def _world(name: str, known: dict[str, world.Module]) -> world.World:
    """What a module beside the program gives: its names, those of the others that it takes over, and of Scenic's."""
    reached, todo = {name}, [name]
    while todo:
        new = {star for star in known[todo.pop()].stars if star in known} - reached
        reached |= new
        todo += new
    installed = [replace(known[n], stars=tuple(s for s in known[n].stars if world.source_of(s))) for n in reached]
    return functools.reduce(world.World.with_names_of, map(world.world_of, installed))


def _own(module: world.Module) -> frozenset[str]:
    """The names that a module defines itself."""
    imported = {here for _, _, here in module.imports}
    return frozenset(n for n in module.names - imported if not n.startswith("param ") and not safety.bad_name(n))


def _beginning(parts: list[Compiled], own_library: bool) -> dict[str, Any]:
    """What snapshots are chosen by: the statements up to `model` (and the driving library, if that follows at once)
    apart from the params' values, and those values. None with a library of the user's: a snapshot is not confined.
    """
    count = next((i + 1 for i, p in enumerate(parts) if p.beginning.model), 0)
    before = [p.beginning for p in parts[:count]]
    maps = [p.beginning.map for p in parts[: count or None] if p.beginning.map]
    found: dict[str, Any] = {"map": maps[-1] if maps else "", "preamble": "", "count": 0, "settings": []}
    found["pieces"] = [p.digest for p in parts]
    found["ego"] = next((i + 1 for i, p in enumerate(parts) if p.facts.ego), 0)
    if not before or own_library or not all(b.simple for b in before):
        return found
    if count < len(parts) and parts[count].beginning.library:
        count += 1
    shape = [[name for name, _ in p.beginning.params] or p.dump for p in parts[:count]]
    return {
        **found,
        "preamble": hashlib.blake2b(repr(shape).encode(), digest_size=16).hexdigest(),
        "params": [pair for b in before for pair in b.params],
        "count": count,
        "settings": [i for i, b in enumerate(before) if b.params],
    }


def _stage(name: Any, started: float, found: tuple[Diagnostic, ...]) -> StageResult:
    ok = not any(d.severity == "error" for d in found)
    return StageResult(name=name, ok=ok, seconds=time.perf_counter() - started, diagnostics=found)


def _dump(stages: list[StageResult]) -> list[dict]:
    return [s.model_dump(mode="json") for s in stages]


def serve(conn: socket.socket) -> None:
    """Say that the world model is known, then answer read requests one after the other until the server hangs up."""
    reader = Reader()
    world.world(MODEL)
    wire.send(conn, {"ready": True})
    while True:
        try:
            request, _ = wire.receive(conn)
        except wire.Closed:
            return
        if request.get("kind") == "import":
            wire.send(conn, _import(request))
            continue
        header, blob = reader.read(request)
        wire.send(conn, header, blob)


def _import(request: dict[str, Any]) -> dict[str, Any]:
    from c2s_engine.check import importer
    from c2s_engine.check.protocol import ImportRequest

    wanted = ImportRequest(text=request["text"], filename=request["filename"])
    return importer.import_program(wanted).model_dump(mode="json")

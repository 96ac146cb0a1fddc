"""The modules beside a program that it imports, directly or through each other: found by their names, carried as text.

They are parsed and checked for safety as the program is (reading.py), and the child that runs it imports these very
texts (`take`), whatever their files hold by then. What is installed is never taken for one of them.
"""

import importlib.abc
import importlib.machinery
import importlib.util
import io
import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from c2s_engine import driving

MODULES = 50
CHARACTERS = 500_000
Texts = Mapping[str, tuple[str, str]]  # name of a module -> its file, its text
_IMPORT = re.compile(
    r"^[ \t]*(?:from[ \t]+(?P<of>[\w.]+)[ \t]+import[ \t]+\(?(?P<names>[^#\n)]*)|import[ \t]+(?P<whole>[^#\n]+))", re.M
)


def found(program: str, folder: Path) -> dict[str, tuple[str, str]]:
    """The modules that a program imports from its folder; the driving library, where it is not the shipped one."""
    known: dict[str, tuple[str, str]] = {}
    todo = [program]
    while todo:
        for name in _named(todo.pop()):
            if name in known or len(known) == MODULES:
                continue
            read = _read(folder, name)
            if read is not None:
                known[name] = read
                todo.append(read[1])
    return known


def _named(text: str) -> Iterator[str]:
    """Each dotted name that a text may import, after those of the packages that it is in."""
    for match in _IMPORT.finditer(text):
        if match["of"]:
            said = [match["of"], *(f"{match['of']}.{word}" for word in _words(match["names"]))]
        else:
            said = _words(match["whole"])
        for name in said:
            parts = name.split(".")
            yield from (".".join(parts[: i + 1]) for i in range(len(parts)))


def _words(listed: str) -> list[str]:
    """The names in `a, b as c`."""
    return [word[0] for part in listed.split(",") if (word := part.split()) and re.fullmatch(r"[\w.]+", word[0])]


def _read(folder: Path, name: str) -> tuple[str, str] | None:
    if name == driving.MODULE:
        text = driving.beside(folder)
        return None if text is None else (str(folder / driving.FILE), text)
    base = folder.joinpath(*name.split("."))
    for file in (base.with_name(f"{base.name}.scenic"), base.with_name(f"{base.name}.py"), base / "__init__.py"):
        try:
            fits = file.is_file() and file.resolve().suffix == file.suffix and file.stat().st_size <= CHARACTERS
            if fits and not _installed(name.partition(".")[0]):
                return str(file), file.read_text(encoding="utf-8")
        except (OSError, ValueError):
            continue
    return None


def _installed(top: str) -> bool:
    """Whether Python has a module of that name without the program's folder."""
    if top in sys.stdlib_module_names or top in sys.modules:
        return True
    here = str(Path.cwd())
    elsewhere = [path for path in sys.path if path not in ("", here)]
    return importlib.machinery.PathFinder.find_spec(top, elsewhere) is not None


def take(modules: Texts) -> None:
    """Let this process import these modules, from their texts. Raises ImportError where it has one of that name."""
    sys.modules.pop(driving.MODULE, None)
    if clash := sorted(sys.modules.keys() & modules.keys()):
        raise ImportError(f"there is a module {clash[0]} already: give the one beside the program another name")
    sys.meta_path.insert(0, _Finder(modules))


class _Finder(importlib.abc.MetaPathFinder):
    def __init__(self, modules: Texts) -> None:
        self.modules = modules
        self.packages = {name.rpartition(".")[0] for name in modules} - {""}

    def find_spec(self, name: str, path: Any, target: Any = None) -> Any:
        if name in self.modules:
            file, text = self.modules[name]
            loader = _scenic_loader(name, file, text) if file.endswith(".scenic") else _Loader(file, text)
            package = name in self.packages or file.endswith("__init__.py")
            return importlib.util.spec_from_loader(name, loader, origin=file, is_package=package)
        if name in self.packages:
            return importlib.machinery.ModuleSpec(name, None, is_package=True)
        return None


class _Loader(importlib.abc.Loader):
    """A module of plain Python."""

    def __init__(self, file: str, text: str) -> None:
        self.file, self.text = file, text

    def exec_module(self, module: Any) -> None:
        exec(compile(self.text, self.file, "exec"), vars(module))


def _scenic_loader(name: str, file: str, text: str) -> Any:
    from scenic.syntax import translator, veneer

    class Loader(translator.ScenicLoader):
        def exec_module(self, module: Any) -> None:
            options = translator.CompileOptions()
            module._source = text
            module._code, module._pythonSource = translator.compileStream(
                io.BytesIO(text.encode()), vars(module), options, file
            )
            if veneer.isActive():
                veneer.currentScenario._inherit(module._scenario)

    return Loader(name, file)

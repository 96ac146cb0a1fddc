"""Where map files are: the shipped town, CARLA's, configured folders, and any path of the user's. No Scenic here."""

import contextlib
import glob
import hashlib
import os
import re
import shutil
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

from c2s_engine import paths
from c2s_engine.maps.opendrive import MAX_BYTES

SHIPPED = "town"
EXTENSION = ".xodr"
NAMED = re.compile(r"localPath\(['\"]([^'\"]+)\.xodr['\"]\)")
_CONTENT = [f"{root}CarlaUE4/Content/*/Maps/" for root in ("", "Unreal/")]
CARLA_FOLDERS = ("", "OpenDrive/", *(f"{maps}{town}OpenDrive/" for maps in _CONTENT for town in ("", "*/")))
"""Where maps are below CARLA's root: a release, a build from source, towns and packages with folders of their own."""
CARLA_TOWN = re.compile(r"Town[0-9]{2}[A-Za-z_]*")
CARLA_TOWNS = (*(f"Town{n:02}" for n in range(1, 8)), "Town10HD", "Town11", "Town12", "Town13", "Town15")
"""The towns that CARLA has; some of them also with _Opt behind their name."""


class MapNotFound(LookupError):
    """No map of that name, or none that can be used; the message says which there are, or what to do."""


@dataclass(frozen=True)
class MapFile:
    """A map file. `carla_map` is the name under which a CARLA server knows it; None: it is none of CARLA's."""

    name: str
    path: Path
    carla_map: str | None
    digest: str


class MapLibrary:
    """Finds maps by name or path. Order: the shipped town, `folders`, then CARLA's installation."""

    def __init__(self, folders: Iterable[str | Path] = (), carla_root: str | Path | None = None) -> None:
        """`carla_root`: CARLA's installation folder, or the folder of its maps; without it, $CARLA_ROOT."""
        self.folders = tuple(Path(folder).expanduser() for folder in folders)
        root = carla_root or os.environ.get("CARLA_ROOT")
        self.carla_root = Path(root).expanduser() if root else None
        self._digests: dict[tuple[str, int, int], str] = {}
        self._by_path: dict[str, Path] = {}

    def list(self) -> tuple[MapFile, ...]:
        """All maps that can be read, the shipped town first; of two files with one name the first found."""
        found = []
        for name, path in self._files().items():
            with contextlib.suppress(MapNotFound):
                found.append(self._map_file(name, path))
        return tuple(found)

    def names(self) -> tuple[str, ...]:
        """The names of all maps, without reading the files."""
        return tuple(self._files())

    def is_town(self, name: str) -> bool:
        """Whether a map bears the name of one of CARLA's towns."""
        return CARLA_TOWN.fullmatch(name) is not None

    def find(self, name: str) -> MapFile:
        """The map of that name (case aside), or the file at that path (then known by name too); raises MapNotFound."""
        text = name.strip()
        files = self._files()
        for known, path in {**self._by_path, **files}.items():
            if known.lower() == text.lower():
                return self._map_file(known, path)
        if text.lower().endswith(EXTENSION) or os.sep in text:
            return self._at_path(text, files)
        there = {name.lower(): name for name in files}
        near = [there[n] for n in get_close_matches(text.lower(), there, 3, 0.6)]
        hint = f" Did you mean {', '.join(near)}?" if near else ""
        if text.removesuffix("_Opt") in CARLA_TOWNS and not any(map(self.is_town, files)):
            hint = " It is one of CARLA's: set CARLA_ROOT to the folder where CARLA is installed"
            hint += f" (none of its maps are below {self.carla_root})." if self.carla_root else "."
        raise MapNotFound(f"There is no map named {text}. Known maps: {', '.join(files)}.{hint}")

    def named_in(self, program: str) -> MapFile | None:
        """The map beside which a program lies (`localPath`): one by name, else one that was used by its path."""
        said = NAMED.search(program)
        if said is None:
            return None
        with contextlib.suppress(MapNotFound):
            return self.find(said[1])
        copies = paths.cache_folder().glob(f"maps/*/{glob.escape(said[1])}{EXTENSION}")
        used = max(copies, key=lambda path: path.stat().st_mtime, default=None)
        return self._map_file(said[1], used) if used is not None else None

    def beside(self, program: str, folder: Path) -> Path | None:
        """The map that a program in a folder names by its file, where that is none of those known by name."""
        said = NAMED.search(program)
        path = (folder / f"{said[1]}{EXTENSION}").resolve() if said is not None else None
        if path is None or not path.is_file():
            return None
        with contextlib.suppress(MapNotFound):
            return path if self._digest(self.find(path.stem).path) != self._digest(path) else None
        return path

    def folder_of(self, program: str) -> str | None:
        """The folder in which the map that a program names lies; None where it names none that is known."""
        try:
            found = self.named_in(program)
            return str(self.working_copy(found).parent) if found else None
        except (LookupError, ValueError, OSError):
            return None

    def _at_path(self, text: str, files: dict[str, Path]) -> MapFile:
        path = Path(text).expanduser()
        if path.is_dir():
            inside = ", ".join(sorted(p.name for p in path.glob(f"*{EXTENSION}"))[:12])
            raise MapNotFound(f"{text} is a folder: name one map in it ({inside or f'it has no {EXTENSION} files'}).")
        if not path.suffix:
            path = path.with_name(path.name + EXTENSION)
        if path.is_file() and path.suffix.lower() == EXTENSION:
            self._by_path[path.stem] = path.resolve()
            return self._map_file(path.stem, path.resolve())
        if path.is_file():
            raise MapNotFound(f"{text} is no OpenDRIVE map: give a file whose name ends in {EXTENSION}.")
        if "*" not in text and os.sep not in text and path.stem.lower() in {known.lower() for known in files}:
            return self.find(path.stem)
        raise MapNotFound(f"There is no map file {text}. Known maps: {', '.join(files)}.")

    def working_copy(self, map_file: MapFile) -> Path:
        """A copy in the cache folder, where Scenic may put its own cache beside it; raises MapNotFound."""
        target = paths.cache_folder() / "maps" / map_file.digest / f"{map_file.name}.xodr"
        if not target.is_file():
            try:
                target.parent.mkdir(parents=True, exist_ok=True)
                draft = target.with_name(f".{target.name}.{os.getpid()}")
                shutil.copyfile(map_file.path, draft)
                draft.replace(target)
            except OSError as error:
                raise MapNotFound(
                    f"The map {map_file.name} cannot be copied to {target.parent}: {error.strerror or error}. "
                    "Set XDG_CACHE_HOME to a folder that can be written."
                ) from None
        return target

    def _files(self) -> dict[str, Path]:
        found = {SHIPPED: paths.shipped("maps", f"{SHIPPED}.xodr")}
        for path in self._beyond():
            found.setdefault(path.stem, path)
        return found

    def _beyond(self) -> Iterator[Path]:
        for folder in self.folders:
            yield from _below(folder)
        if self.carla_root:
            for pattern in CARLA_FOLDERS:
                yield from sorted(self.carla_root.glob(f"{pattern}*{EXTENSION}"))

    def _map_file(self, name: str, path: Path) -> MapFile:
        carla = name if self.is_town(name) else None
        return MapFile(name=name, path=path, carla_map=carla, digest=self._digest(path))

    def _digest(self, path: Path) -> str:
        """The first 16 hexadecimal digits of the file's digest, kept while the file does not change."""
        try:
            state = path.stat()
            key = (str(path), state.st_mtime_ns, state.st_size)
            if key not in self._digests:
                if state.st_size > MAX_BYTES:
                    raise MapNotFound(f"The map {path} is larger than {MAX_BYTES // 1_000_000} MB: it is not read.")
                with path.open("rb") as file:
                    self._digests[key] = hashlib.file_digest(file, lambda: hashlib.blake2b(digest_size=8)).hexdigest()
        except OSError as error:
            raise MapNotFound(f"The map {path} cannot be read: {error.strerror or error}.") from None
        return self._digests[key]


def _below(folder: Path) -> Iterator[Path]:
    """The map files below a folder, by path, through links too; each folder once."""
    seen: set[str] = set()
    for parent, folders, files in os.walk(folder, followlinks=True):
        real = os.path.realpath(parent)
        if real in seen:
            folders.clear()
            continue
        seen.add(real)
        folders.sort()
        yield from (Path(parent, file) for file in sorted(files) if file.lower().endswith(EXTENSION))

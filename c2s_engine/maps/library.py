"""Where map files are: the shipped town, CARLA's, configured folders, and any path of the user's. No Scenic here."""

import hashlib
import os
import re
import shutil
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from c2s_engine import paths

SHIPPED = "town"
CARLA_TOWN = re.compile(r"Town[0-9]{2}[A-Za-z_]*")


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
        """`carla_root`: CARLA's installation folder; without it, $CARLA_ROOT."""
        self.folders = tuple(Path(folder).expanduser() for folder in folders)
        root = carla_root or os.environ.get("CARLA_ROOT")
        self.carla_root = Path(root).expanduser() if root else None
        self._digests: dict[tuple[str, int, int], str] = {}

    def list(self) -> tuple[MapFile, ...]:
        """All maps by name, the shipped town first; of two files with one name the first found."""
        return tuple(self._map_file(name, path) for name, path in self._files().items())

    def names(self) -> tuple[str, ...]:
        """The names of all maps, without reading the files."""
        return tuple(self._files())

    def find(self, name: str) -> MapFile:
        """The map of that name (case aside), or the file at that path; raises MapNotFound."""
        text = name.strip()
        files = self._files()
        for known, path in files.items():
            if known.lower() == text.lower():
                return self._map_file(known, path)
        if text.lower().endswith(".xodr") or os.sep in text:
            path = Path(text).expanduser()
            if path.is_file() and path.suffix.lower() == ".xodr":
                return self._map_file(path.stem, path.resolve())
            if path.is_file():
                raise MapNotFound(f"{text} is no OpenDRIVE map: give a file whose name ends in .xodr.")
            stem = path.stem.lower()
            if "*" not in text and os.sep not in text and stem in {known.lower() for known in files}:
                return self.find(path.stem)
            raise MapNotFound(f"There is no map file {text}. Known maps: {', '.join(files)}.")
        hint = ""
        if CARLA_TOWN.fullmatch(text) and not self.carla_root:
            hint = " It is one of CARLA's: set CARLA_ROOT to the folder where CARLA is installed."
        raise MapNotFound(f"There is no map named {text}. Known maps: {', '.join(files)}.{hint}")

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
            if folder.is_dir():
                yield from sorted(folder.rglob("*.xodr"))
        if self.carla_root and self.carla_root.is_dir():
            yield from sorted(path for path in self.carla_root.rglob("*.xodr") if path.parent.name == "OpenDrive")

    def _map_file(self, name: str, path: Path) -> MapFile:
        carla = name if CARLA_TOWN.fullmatch(name) else None
        return MapFile(name=name, path=path, carla_map=carla, digest=self._digest(path))

    def _digest(self, path: Path) -> str:
        """The first 16 hexadecimal digits of the file's digest, kept while the file does not change."""
        try:
            state = path.stat()
            key = (str(path), state.st_mtime_ns, state.st_size)
            if key not in self._digests:
                self._digests[key] = hashlib.blake2b(path.read_bytes(), digest_size=8).hexdigest()
        except OSError as error:
            raise MapNotFound(f"The map {path} cannot be read: {error.strerror or error}.") from None
        return self._digests[key]

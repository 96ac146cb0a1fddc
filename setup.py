"""The packages, found; everything else is in pyproject.toml. Data and benchmark lie beside the engine at the top level
and are installed under names of their own (package-dir there). Folders of data count as packages, too: setuptools
warns of each that is installed and not named."""

from setuptools import find_namespace_packages, setup


def under(name: str, folder: str) -> list[str]:
    """The names under which a folder and those in it are installed."""
    found = find_namespace_packages(folder, exclude=["*__pycache__*"])
    return [name, *(f"{name}.{package}" for package in found)]


setup(
    packages=[
        *under("c2s_engine", "c2s_engine"),
        *under("c2s_tui", "c2s_tui"),
        *under("c2s_engine.data", "data"),
        *under("c2s_bench", "benchmark"),
    ]
)

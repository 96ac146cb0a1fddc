"""The packages, found; everything else is in pyproject.toml. Data and benchmark lie beside the engine at the top level
and are installed under names of their own (package-dir there)."""

from setuptools import find_packages, setup

setup(
    packages=[
        *find_packages(include=["c2s_engine", "c2s_engine.*", "c2s_tui", "c2s_tui.*"]),
        "c2s_engine.data",
        "c2s_bench",
        *(f"c2s_bench.{name}" for name in find_packages("benchmark")),
    ]
)

"""The wheel, installed into an empty environment and run from another folder, with a read-only installation."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.mark.full
def test_the_wheel_does_the_main_job(tmp_path):
    built = subprocess.run(
        [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", tmp_path / "dist", ROOT],
        check=True, capture_output=True, timeout=300, text=True,
    )  # fmt: skip
    assert "would be ignored" not in built.stdout + built.stderr
    wheel = next((tmp_path / "dist").glob("c2s-*.whl"))
    site = tmp_path / "site"
    subprocess.run(
        [sys.executable, "-m", "pip", "install", "-q", "--no-deps", "--target", site, wheel],
        check=True, capture_output=True, timeout=300,
    )  # fmt: skip
    for path in [site, *site.rglob("*")]:
        path.chmod(path.stat().st_mode & ~0o222)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    environment = {
        **{k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "XDG"))},
        "PYTHONPATH": str(site),
        "PYTHONDONTWRITEBYTECODE": "1",
        "XDG_CACHE_HOME": str(tmp_path / "cache"),
        "XDG_DATA_HOME": str(tmp_path / "data"),
        "XDG_CONFIG_HOME": str(tmp_path / "config"),
    }
    code = (
        f"import c2s_engine; assert c2s_engine.__file__.startswith({str(site)!r}), c2s_engine.__file__;"
        "from c2s_engine.cli import main; main()"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, "generate", "--json", "A car ahead brakes hard and the ego stops behind it."],
        cwd=elsewhere, env=environment, capture_output=True, timeout=280,
    )  # fmt: skip
    for path in [site, *site.rglob("*")]:
        path.chmod(path.stat().st_mode | 0o200)
    assert done.returncode == 0, done.stderr.decode()
    assert json.loads(done.stdout)["ok"]
    assert (tmp_path / "cache" / "c2s").is_dir()

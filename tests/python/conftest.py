"""The module against the command, which stands beside it."""

import os
import subprocess
from pathlib import Path

import plm_impact as plm
import pytest

try:
    import tomllib
except ModuleNotFoundError:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
STEEL = dict(youngs_modulus="210 GPa", poissons_ratio=0.3)


@pytest.fixture(scope="session")
def command(request: pytest.FixtureRequest) -> Path:
    # the same build as in .ci/run, so that nothing is built twice
    build = ["cargo", "test", "--no-run", "--test", "table"]
    target = ROOT / os.environ.get("CARGO_TARGET_DIR", "target")
    with request.config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
        print(
            f"\nbuilding the command in {target}, which takes some minutes the first time: {' '.join(build)}",
            flush=True,
        )
        subprocess.run(build, cwd=ROOT, check=True)
    return target / "debug" / "plm-impact"


def tables_of_steel(**tables: object) -> dict[str, object]:
    """The ball, the half-space and the law of scenarios/steel-on-steel.toml, and other tables in place of them or beside them."""
    scenario = tomllib.loads((ROOT / "scenarios" / "steel-on-steel.toml").read_text())
    return {name: scenario[name] for name in ("sphere", "half_space", "law")} | tables


def steel(**tables: object) -> plm.Contact:
    return plm.Contact(**tables_of_steel(**tables))


@pytest.fixture
def contact() -> plm.Contact:
    return steel()

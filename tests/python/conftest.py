"""The module against the command, which stands beside it."""

import os
import subprocess
from pathlib import Path

import plm_impact as plm
import pytest

ROOT = Path(__file__).parents[2]
STEEL = dict(youngs_modulus="210 GPa", poissons_ratio=0.3)


@pytest.fixture(scope="session")
def command(request: pytest.FixtureRequest) -> Path:
    # the same build as in .ci/run, so that nothing is built twice
    build = ["cargo", "test", "--no-run", "--test", "tables"]
    target = ROOT / os.environ.get("CARGO_TARGET_DIR", "target")
    with request.config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
        print(f"\nbuilding the command in {target}, which takes some minutes the first time: {' '.join(build)}", flush=True)
        subprocess.run(build, cwd=ROOT, check=True)
    return target / "debug" / "plm-impact"


def steel(**tables: dict[str, object]) -> plm.Contact:
    """The ball and the half-space of scenarios/steel-on-steel.toml."""
    sphere, half_space = dict(radius="5 mm", density=7850, **STEEL), dict(yield_strength="345 MPa", **STEEL)
    return plm.Contact(**{"sphere": sphere, "half_space": half_space, **tables})


@pytest.fixture
def contact() -> plm.Contact:
    return steel()

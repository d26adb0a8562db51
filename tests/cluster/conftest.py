"""A table of many small parts, and a folder in which the recipes of scenarios/tables.md find the command."""

import os
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]
STEEL = (ROOT / "scenarios" / "steel-on-steel.toml").read_text().split("[solver]")[0]
SWEEP = """
[sweep]
"impact.speed" = { logspace = ["1 mm/s", "10 m/s"], points = POINTS }
"""
RECIPES = (ROOT / "scenarios" / "tables.md").read_text().split("### Beyond one machine")[1].split("\n## ")[0]


def recipe(containing: str) -> str:
    """The block of the page that has this word."""
    (found,) = [block for block in re.findall(r"```sh\n(.*?)```", RECIPES, flags=re.DOTALL) if containing in block]
    return found


class Desk:
    def __init__(self, folder: Path, points: int = 2000, name: str = "big") -> None:
        # the same build as in .ci/run, so that nothing is built twice
        build = ["cargo", "test", "--quiet", "--no-run", "--test", "table"]
        subprocess.run(build, cwd=ROOT, check=True)
        self.folder = folder
        built = ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "debug"
        self.environment = {**os.environ, "PATH": f"{built}{os.pathsep}{os.environ['PATH']}"}
        # a hundred parts
        self.environment["PLM_IMPACT_TEST_ROWS_PER_PART"] = "20"
        self.name = name
        (folder / f"{name}.toml").write_text(STEEL + SWEEP.replace("POINTS", str(points)))

    def run(self, line: str, **environment: str) -> str:
        done = subprocess.run(
            ["bash", "-ec", line],
            cwd=self.folder,
            env=self.environment | environment,
            capture_output=True,
            text=True,
            timeout=600,
        )
        assert done.returncode == 0, f"{line}: {done.stdout}{done.stderr}"
        return done.stdout

    def is_whole(self) -> bool:
        """Whether the table of the shards has the bytes of one run."""
        self.run(f"plm-impact run {self.name}.toml --out whole-{self.name} --quiet")
        return (self.folder / self.name / "table.csv").read_bytes() == (
            self.folder / f"whole-{self.name}" / "table.csv"
        ).read_bytes()

"""Where LAMMPS finds the plug-in `fix plm/wall`, which src/interfaces/lammps/build.py builds."""

from pathlib import Path


def plugin_dir() -> str:
    """The folder of the plug-in; LAMMPS takes an empty or missing folder for no plug-in."""
    return str(Path(__file__).parent / "lammps")

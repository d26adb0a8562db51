"""The plug-in, built once for all tests of this folder."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def plugin(tmp_path_factory: pytest.TempPathFactory) -> Path:
    from runs import build, is_installed, plm

    folder = tmp_path_factory.mktemp("plugin")
    if is_installed():
        # where it goes by itself: `test_lmp_finds_the_plugin_of_the_module` loads this one
        build()
        shutil.copy(Path(plm.__file__).parent / "lammps" / "plmplugin.so", folder)
    else:
        build("--into", folder)
    return folder

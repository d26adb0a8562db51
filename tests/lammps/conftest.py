"""The plug-in, built once for all tests of this folder."""

from __future__ import annotations

from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def plugin(tmp_path_factory: pytest.TempPathFactory) -> Path:
    from runs import build

    folder = tmp_path_factory.mktemp("plugin")
    build("--into", folder)
    return folder

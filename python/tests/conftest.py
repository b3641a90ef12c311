import json
import os
import pathlib

import pytest


@pytest.fixture(autouse=True)
def own_caches(tmp_path, monkeypatch):
    """Keeps tests away from the user's caches."""
    monkeypatch.setenv("PHYRE_CACHE_DIR", str(tmp_path / "phyre"))
    monkeypatch.setenv("PATHLIGHT_PHYRE_CACHE_DIR", str(tmp_path / "pathlight"))


@pytest.fixture(scope="session")
def reference():
    """The folder of PHYRE's reference data."""
    folder = os.environ.get("PATHLIGHT_PHYRE")
    if not folder:
        pytest.skip("needs PATHLIGHT_PHYRE, the folder of PHYRE's reference data")
    return pathlib.Path(folder)


@pytest.fixture(scope="session")
def outcomes(reference):
    """The recorded balls: task, ball (px), kind, solved."""
    return [json.loads(line) for line in (reference / "outcomes.jsonl").read_text().splitlines()]

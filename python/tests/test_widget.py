"""The Python half of the widget; tests/browser/widget.test.mjs tests the other half in a browser."""

import hashlib
import json
import pathlib

import pytest

anywidget = pytest.importorskip("anywidget")
from pathlight_phyre import _native  # noqa: E402
from pathlight_phyre.widget import Puzzle  # noqa: E402


def test_it_gives_back_what_the_person_placed():
    puzzle = Puzzle("00002:007")
    seen = []
    puzzle.observe(lambda change: seen.append(change.new), "ball")
    assert puzzle.action is None
    # As sent by the browser.
    puzzle.set_state({"ball": [100, 200, 17], "panel": "imagine"})
    assert seen == [(100, 200, 17)] and puzzle.panel == "imagine"
    assert _native.Scene("00002:007").ball(tuple(puzzle.action)) == pytest.approx([100, 200, 17])


def test_it_sends_the_files_of_the_page(monkeypatch):
    puzzle, sent = Puzzle(), []
    monkeypatch.setattr(puzzle, "send", lambda *message: sent.append(message))
    puzzle._handle_custom_msg({"wants": "files"}, [])
    puzzle._handle_custom_msg({"wants": "nothing"}, [])
    [(message, files)] = sent
    by_name = dict(zip(message["files"], files))
    assert [data[:4] for name, data in by_name.items() if name.endswith(".wasm")] == [b"\0asm"] * 2
    assert len(by_name["worker.js"]) > 10_000
    model = json.loads((pathlib.Path(__file__).parents[2] / "assets/model.json").read_text())["models"][0]
    assert hashlib.sha256(by_name[f"assets/{model['file']}"]).hexdigest() == model["sha256"]


def test_the_licences_of_its_parts_are_there():
    licences = (pathlib.Path(_native.__file__).parent / "page/licences.txt").read_text(encoding="utf-8-sig")
    for part in ["Pathlight", "pyo3 ", "numpy ", "lit-html ", "Box2D"]:
        assert part in licences


@pytest.mark.parametrize("traits", [{"task": "nonsense"}, {"ball": (1, 2)}, {"panel": "make"}])
def test_bad_input_is_refused(traits):
    with pytest.raises(Exception, match=r"no ball task|'ball' trait|'panel' trait"):
        Puzzle(**traits)

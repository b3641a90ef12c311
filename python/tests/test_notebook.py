"""Runs the example notebook, without looking at its pictures."""

import pathlib

import nbformat
from nbclient import NotebookClient

EXAMPLE = pathlib.Path(__file__).parents[2] / "examples/phyre.ipynb"


def test_the_example_runs():
    notebook = nbformat.read(EXAMPLE, as_version=4)
    NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    printed = "".join(output.text for output in outputs if output.get("name") == "stdout")
    scores = {name: float(score) for name, score in (line.split(": ") for line in printed.splitlines()[:2])}
    assert scores.keys() == {"random", "model"} and 0 <= scores["random"] < scores["model"] <= 100
    shown = [kind for output in outputs for kind in output.get("data", ())]
    assert "text/html" in shown and "application/vnd.jupyter.widget-view+json" in shown

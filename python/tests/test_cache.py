"""The statuses of PHYRE's actions, simulated on demand."""

import numpy as np
import pytest

import pathlight_phyre as phyre
from pathlight_phyre import _native, simulation_cache

TASK = "00002:007"


@pytest.fixture
def cache(monkeypatch):
    monkeypatch.setattr(simulation_cache, "CHUNK", 100)
    monkeypatch.setattr(simulation_cache, "KEPT_EVERY", 1)
    return phyre.get_default_100k_cache("ball")


def kept(tmp_path):
    return next((tmp_path / "pathlight").glob("*/*.npy"))


def test_the_actions_are_phyres(cache):
    assert (cache.action_array.dtype, cache.action_array.shape, len(cache)) == (np.float32, (100_000, 3), 100_000)
    assert cache.action_array[2].tolist() == pytest.approx([0.1834045, 0.3042422, 0.5247564])
    assert len(cache.task_ids) == 2500


def test_a_sample_is_simulated_once(cache, tmp_path):
    sample = cache.get_sample([TASK], 250)
    statuses = sample["simulation_statuses"]
    assert (statuses.dtype, statuses.shape, sample["actions"].shape) == (np.int8, (1, 250), (250, 3))
    simulator = phyre.initialize_simulator([TASK], "ball")
    assert (statuses[0] == simulator.simulate_actions(0, sample["actions"])).all()
    marked = np.full(250, 3, np.int8)
    np.save(kept(tmp_path), marked)
    assert (cache.get_sample([TASK], 250)["simulation_statuses"] == marked).all()


def test_an_interrupted_simulation_goes_on(cache, monkeypatch, tmp_path):
    whole = cache.get_sample([TASK], 300)["simulation_statuses"]
    kept(tmp_path).unlink()
    simulated = []

    class Interrupted:
        def __init__(self, task):
            self.scene = scene(task)

        def statuses(self, actions, stable):
            if len(simulated) == 2:
                raise KeyboardInterrupt
            simulated.append(len(actions))
            return self.scene.statuses(actions, stable)

    scene = _native.Scene
    monkeypatch.setattr(simulation_cache._native, "Scene", Interrupted)
    with pytest.raises(KeyboardInterrupt):
        cache.get_sample([TASK], 300)
    assert len(np.load(kept(tmp_path))) == 200
    simulated.clear()
    again = cache.get_sample([TASK], 300)["simulation_statuses"]
    assert simulated == [100] and (again == whole).all()


def test_a_damaged_file_is_made_again(cache, tmp_path, caplog):
    whole = cache.get_sample([TASK], 100)["simulation_statuses"]
    kept(tmp_path).write_bytes(b"nonsense")
    assert (cache.get_sample([TASK], 100)["simulation_statuses"] == whole).all()
    assert "will be simulated again" in caplog.text


def test_a_folder_that_cannot_be_written_is_named(cache, tmp_path):
    (tmp_path / "pathlight").write_text("a file, not a folder")
    with pytest.warns(UserWarning, match="PATHLIGHT_PHYRE_CACHE_DIR"):
        assert cache.get_sample([TASK], 50)["simulation_statuses"].shape == (1, 50)


def test_phyres_own_file_is_read():
    joblib = pytest.importorskip("joblib")
    folder = simulation_cache.get_cache_folder(100_000) / "ball"
    folder.mkdir(parents=True)
    actions, statuses = np.zeros((4, 3), np.float32), np.array([1, 0, -1, 1], np.int8)
    joblib.dump({"actions": actions, "statuses_per_task": {TASK: statuses}}, folder / "simulation_cache.gz")
    cache = phyre.get_default_100k_cache("ball")
    assert len(cache) == 4 and cache.task_ids == {TASK}
    assert cache.load_simulation_states(TASK).tolist() == [1, 0, -1, 1]


def test_bad_requests_are_refused(cache, tmp_path):
    with pytest.raises(ValueError, match="ask for fewer"):
        cache.get_sample([TASK], 100_001)
    with pytest.raises(ValueError, match="no ball task"):
        cache.get_sample(["00000:999"], 1)
    with pytest.raises(ValueError, match="simulates the statuses instead"):
        phyre.SimulationCache(tmp_path)

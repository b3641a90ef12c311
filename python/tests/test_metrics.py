"""Folds and scores."""

import json

import pytest

import pathlight_phyre as phyre


def test_the_folds_are_phyres(reference):
    recorded = json.loads((reference / "folds.json").read_text())
    for seed in range(10):
        train, dev, test = phyre.get_fold("ball_cross_template", seed)
        for part, ids in [("train", train), ("dev", dev), ("test", test)]:
            assert sorted({task.split(":")[0] for task in ids}) == recorded[str(seed)]["cross"][f"{part}_templates"]
            assert list(ids) == sorted(ids) and len(ids) in (1600, 400, 500)


def test_within_a_template_a_fifth_is_tested():
    train, dev, test = phyre.get_fold("ball_within_template", 3)
    assert (len(train), len(dev), len(test)) == (1600, 400, 500)
    assert len(set(train) | set(dev) | set(test)) == 2500
    assert all(sum(task.startswith(f"{template:05}") for task in test) == 20 for template in range(25))


def test_auccess_weighs_early_solutions_more():
    scores = []
    for attempt in (1, 2, 10, 50):
        evaluator = phyre.Evaluator(("00000:000",))
        assert not evaluator.maybe_log_attempt(0, phyre.SimulationStatus.INVALID_INPUT)
        for number in range(1, 101):
            assert evaluator.maybe_log_attempt(0, 1 if number == attempt else -1)
        scores.append(evaluator.get_auccess())
    assert scores == pytest.approx([1.0, 0.850, 0.501, 0.152], abs=1e-3)
    with pytest.raises(AssertionError, match="continue with the next task"):
        evaluator.maybe_log_attempt(0, -1)
    assert evaluator.get_attempts_for_task(0) == len(evaluator) == 100


def test_there_is_no_fold_beyond_a_byte():
    with pytest.raises(ValueError, match="0 to 9"):
        phyre.get_fold("ball_cross_template", 256)

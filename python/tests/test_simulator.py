"""Simulations of actions, and their results."""

import multiprocessing

import numpy as np
import pytest

import pathlight_phyre as phyre
from pathlight_phyre import SimulationStatus as Status
from pathlight_phyre.loader import WALLS, load_compiled_task_list
from pathlight_phyre.metrics import get_task_ids_in_tier

TASKS = get_task_ids_in_tier("ball")[::480]


def action_of(ball):
    x, y, r = ball
    return [x / 255, y / 255, (r - 2) / 30]


@pytest.fixture(scope="module")
def simulator():
    return phyre.initialize_simulator(["00007:008", "00002:007"], "ball")


SOLUTION = action_of([178, 218, 19])


def test_the_statuses_of_all_recorded_balls_are_phyres(outcomes):
    rows = {}
    for row in outcomes:
        rows.setdefault(row["task"], []).append(row)
    wrong = []
    for task, listed in rows.items():
        statuses = phyre.initialize_simulator([task], "ball").simulate_actions(
            0, [action_of(row["ball"]) for row in listed]
        )
        solved = [row.get("reference_solved", row["solved"]) for row in listed]
        wrong += [row for row, one, status in zip(listed, solved, statuses) if status != (1 if one else -1)]
    assert wrong == []


@pytest.mark.parametrize("kind, status", [("stable", Status.STABLY_SOLVED), ("unstable", Status.UNSTABLY_SOLVED)])
def test_solutions_are_stable_where_phyre_says_so(outcomes, kind, status):
    rows = [row for row in outcomes if row["kind"] == kind and row.get("reference_solved", True)][::150]
    found = [
        phyre.initialize_simulator([row["task"]], "ball")
        .simulate_action(0, action_of(row["ball"]), need_images=False, stable=True)
        .status
        for row in rows
    ]
    assert found == [status] * len(rows)


def test_one_action_and_many_have_the_same_status(simulator):
    actions = [SOLUTION, [0.5, 0.5, 0.1], [0, 0, 0], [2, 0, 0]]
    one_by_one = [simulator.simulate_action(0, action).status for action in actions]
    assert one_by_one[0] is Status.SOLVED and one_by_one[2:] == [Status.INVALID_INPUT] * 2
    statuses = simulator.simulate_actions(0, actions)
    assert statuses.dtype == np.int8 and statuses.tolist() == one_by_one
    assert simulator.simulate_actions(0, []).shape == (0,)


def test_an_invalid_action_returns_its_status_alone(simulator):
    simulated = simulator.simulate_action(0, [0, 0, 0], need_featurized_objects=True)
    assert simulated.status.is_invalid()
    assert simulated.images is None and simulated.featurized_objects is None


def test_shapes_and_types_are_phyres(simulator):
    simulated = simulator.simulate_action(
        0, SOLUTION, need_featurized_objects=True, need_masks=True, need_velocities=True
    )
    times, objects = simulated.images.shape[0], simulator.initial_featurized_objects[0].num_objects + 1
    assert (simulated.images.dtype, simulated.images.shape[1:]) == (np.uint8, (256, 256))
    features = simulated.featurized_objects.features
    assert (features.dtype, features.shape) == (np.float32, (times, objects, 14))
    assert simulated.featurized_objects.colors[-1] == "RED" and simulated.featurized_objects.num_user_inputs == 1
    assert (simulated.velocities.shape, simulated.masks.shape) == ((times, objects, 3), (times, objects, 256, 256))
    assert simulated.steps.tolist() == list(range(1, 60 * times, 60)) and simulated.touching.shape == (times,)
    assert (simulator.initial_scenes.dtype, simulator.initial_scenes.shape) == (np.uint8, (2, 256, 256))
    assert simulator.task_ids == ("00007:008", "00002:007") and simulator.action_space_dim == 3
    assert simulator.goals is None
    assert phyre.ActionSimulator(TASKS, "ball", no_goals=False).goals.shape == (len(TASKS), 3)


def test_a_failure_is_observed_17_times(simulator):
    failure = simulator.simulate_action(0, [0.5, 0.5, 0.1])
    assert failure.status.is_not_solved() and len(failure.images) == 17


@pytest.mark.parametrize("task", TASKS)
def test_images_are_what_their_objects_look_like(task):
    """As in PHYRE's own tests: the features determine the image."""
    simulator = phyre.initialize_simulator([task], "ball")
    statuses = simulator.simulate_actions(0, phyre.get_default_100k_cache("ball").action_array[:200])
    action = phyre.get_default_100k_cache("ball").action_array[int(np.argmax(statuses != 0))]
    simulated = simulator.simulate_action(0, action, need_featurized_objects=True, need_masks=True, stride=7)
    for image, features, masks in zip(simulated.images, simulated.featurized_objects.features, simulated.masks):
        assert (phyre.featurized_objects_vector_to_raster(features) == image).all()
        drawn = np.zeros_like(image)
        for mask, code in zip(masks, np.argmax(features[:, 8:], axis=1) + 1):
            drawn[mask == 1] = code
        assert (drawn == image).all()


def test_a_ball_falls_as_gravity_says(simulator):
    """The acceleration is 9.8 m/s2, which is 58.8 px/s2; a step is a sixtieth of a second."""
    simulated = simulator.simulate_action(0, SOLUTION, need_velocities=True, stride=1)
    assert simulated.velocities[0, -1] == pytest.approx([0, -58.8 / 60, 0], abs=1e-2)
    assert simulated.velocities[9, -1] == pytest.approx([0, -58.8 / 6, 0], abs=1e-2)


def test_contacts_are_events_of_two_bodies(simulator):
    simulated = simulator.simulate_action(0, SOLUTION, need_images=False, need_featurized_objects=True, stride=1)
    assert simulated.contacts is None
    contacts = simulator.simulate_action(0, SOLUTION, need_images=False, need_contacts=True).contacts
    assert (contacts.dtype, contacts.shape[1]) == (np.int64, 4)
    objects, steps = simulated.featurized_objects.num_objects, len(simulated.steps)
    assert (contacts[:, 0] < contacts[:, 1]).all() and contacts[:, 0].min() >= 0 and contacts[:, 1].max() < objects + 4
    assert (np.diff(contacts[:, 2]) >= 0).all() and (contacts[:, 2] < contacts[:, 3]).all()
    task = load_compiled_task_list(["00007:008"])[0]
    goal = sorted([task.bodyId1 - WALLS, task.bodyId2 - WALLS])
    touching = np.zeros(steps + 2, bool)
    for *pair, begin, end in contacts.tolist():
        if pair == goal:
            touching[begin:end] = True
    assert touching[1:-1].tolist() == simulated.touching.tolist() and touching[-2]


def test_a_status_prints_its_name_and_formats_as_a_number():
    """As an IntEnum did in the versions of Python that phyre supported."""
    assert str(Status.NOT_SOLVED) == "SimulationStatus.NOT_SOLVED"
    assert f"{Status.NOT_SOLVED} {Status.SOLVED:02d}" == "-1 01"


def test_the_scene_of_a_task_has_the_walls_and_the_objects_of_the_simulation():
    tasks = load_compiled_task_list(TASKS)
    initial = phyre.initialize_simulator(TASKS, "ball").initial_featurized_objects
    for task, objects in zip(tasks, initial):
        walls, bodies = task.scene.bodies[:WALLS], task.scene.bodies[WALLS:]
        for wall, (x, y) in zip(walls, [(128, -2.5), (-2.5, 128), (128, 258.5), (258.5, 128)]):
            assert (wall.position.x, wall.position.y, wall.bodyType, wall.color, wall.shapeType) == (x, y, 1, 6, 0)
            corner = wall.shapes[0].polygon.vertices[0]
            assert (corner.x, corner.y) == ((128, 2.5) if x == 128 else (2.5, 128))
        colors, shapes = objects.colors_one_hot.argmax(1) + 1, objects.shapes_one_hot.argmax(1) + 1
        assert [(body.color, body.shapeType) for body in bodies] == [*zip(colors, shapes)]
        for body, diameter, angle in zip(bodies, objects.diameters, objects.angles[0]):
            assert body.angle == pytest.approx(angle * 2 * np.pi, abs=1e-5)
            if body.shapeType == 1:
                assert body.shapes[0].polygon is None
                assert 2 * body.shapes[0].circle.radius == pytest.approx(diameter * 256, abs=1e-4)
                assert body.position.x == pytest.approx(objects.xs[0, bodies.index(body)] * 256, abs=1e-4)
        goal = task.scene.bodies[task.bodyId1]
        assert goal.color in (2, 3)


def test_a_scene_without_an_action_has_its_own_objects(simulator):
    simulated = simulator.simulate_action(0, None, need_featurized_objects=True)
    assert simulated.status.is_not_solved() and simulated.featurized_objects.num_user_inputs == 0


def test_draws_are_those_of_numpys_generator(simulator):
    """From a seed, phyre draws three numbers at a time until the ball is inside."""
    assert simulator.sample(rng=np.random.RandomState(42)).astype(np.float32).tolist() == (
        phyre.get_default_100k_cache("ball").action_array[0].tolist()
    )
    drawn = simulator.build_discrete_action_space(5)
    assert len(drawn) == 5 and drawn[0].shape == (3,)


def _statuses(actions):
    return phyre.initialize_simulator(["00002:007"], "ball").simulate_actions(0, actions).tolist()


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="this system cannot fork")
def test_a_forked_process_simulates_too(simulator):
    """Data loaders of PyTorch fork like this."""
    actions = phyre.get_default_100k_cache("ball").action_array[:300]
    expected = _statuses(actions)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map_async(_statuses, [actions, actions]).get(timeout=60) == [expected, expected]


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda s: s.simulate_action(0, [0.5, float("nan"), 0.5]), "NaN"),
        (lambda s: s.simulate_action(0, [0.5, 0.5]), r"shape \(2,\)"),
        (lambda s: s.simulate_action(0, "abc"), "must be numbers"),
        (lambda s: s.simulate_action(0, [0.5, 0.5, 0.1], stride=0), "at least 1"),
        (lambda s: s.simulate_actions(0, np.zeros((3, 4))), r"\(3, 4\)"),
        (lambda s: phyre.initialize_simulator(["00000:999"], "ball"), "no ball task"),
        (lambda s: phyre.initialize_simulator(["nonsense"], "ball"), "no ball task"),
        (lambda s: phyre.initialize_simulator("00000:000", "ball"), "a list of ids"),
        (lambda s: phyre.featurized_objects_vector_to_raster(np.zeros((3, 13))), "14"),
        (lambda s: phyre.featurized_objects_vector_to_raster(np.full((1, 14), np.inf)), "finite"),
        (lambda s: phyre.FeaturizedObjects(np.zeros((2, 14))), "times, objects, 14"),
    ],
)
def test_bad_input_is_refused_with_a_remedy(simulator, call, words):
    with pytest.raises(ValueError, match=words):
        call(simulator)


def test_there_is_no_task_beyond_the_last(simulator):
    with pytest.raises(IndexError):
        simulator.simulate_action(2, [0.5, 0.5, 0.5])

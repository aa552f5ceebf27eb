"""What docs/hosts.md says of Python. TASKC_HOME is where taskc is, TASKS the folder of test tasks."""

import math
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np

import taskc

TASKS = Path(os.environ["TASKS"])


def episode(x, **others):
    """Of the task `each`: places along x, all else still."""
    x = np.asarray(x, dtype=np.float64)
    place = np.zeros((len(x), 3))
    place[:, 0] = x
    sensors = {"place": place, "turn": np.array([1.0, 0, 0, 0]), "steps": np.int64(0),
               "touches": np.zeros((len(x), 3), dtype=bool)}
    sensors.update(others)
    return sensors


class Load(unittest.TestCase):
    def test_says_what_the_task_reads_and_pays(self):
        task = taskc.load(TASKS / "each.task")
        self.assertEqual(task.name, "each")
        self.assertEqual(list(task.sensors), ["place", "turn", "steps", "touches"])
        place = task.sensors["place"]
        self.assertEqual((place.doc, place.type, place.unit, place.shape, place.maximum),
                         ("Where it is.", "vec3", "m", (3,), 10.0))
        self.assertEqual(task.sensors["steps"].shape, ())
        self.assertEqual(task.sensors["touches"].dtype, np.bool_)
        self.assertEqual((task.params["reach"].unit, task.params["reach"].initial), ("m", 5.0))
        self.assertEqual([term.name for term in task.terms], ["begun", "moved", "touched", "done"])
        self.assertEqual([metric.reduction for metric in task.metrics], ["max", "last"])
        self.assertEqual(task.ends, [taskc._describe.End("arrived", "success")])
        self.assertEqual(task.phases, ("going", "gone"))
        self.assertEqual(task.goals["target"].shape, (2,))
        self.assertEqual(task.observation_size, 7)
        self.assertEqual(task.warnings, [])

    def test_knows_links_joints_and_sites(self):
        task = taskc.load(TASKS / "starting.task")
        self.assertEqual((task.robot, task.links[0], task.joints[0], task.sites[0]),
                         ("humanoid", "body", "neck_yaw", "head_top"))
        self.assertEqual([each.code for each in task.warnings], ["W0707"])

    def test_mistakes_are_data(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "wrong.task"
            file.write_text("task wrong\nsensor place: vec3 [m]\n"
                            "on end_of_time_step { reward near = norm(plase) / 1 m }\n")
            with self.assertRaises(taskc.TaskError) as raised:
                taskc.load(file)
        mistake = raised.exception.diagnostics[0]
        self.assertEqual((mistake.severity, mistake.line, mistake.column), ("error", 3, 42))
        self.assertEqual(mistake.fixes[0].text, "place")
        self.assertIn("wrong.task:3:42: error[E", str(raised.exception))

    def test_a_file_that_is_missing_is_no_mistake_of_a_task(self):
        with self.assertRaisesRegex(taskc.CompilerError, "nowhere.task"):
            taskc.load("nowhere.task")
        with self.assertRaisesRegex(taskc.HostError, "nowhere.so: cannot be read"):
            taskc.load("nowhere.so")


class Evaluate(unittest.TestCase):
    def setUp(self):
        self.task = taskc.load(TASKS / "each.task")

    def test_gives_return_terms_and_ends(self):
        result = self.task.evaluate(episode([1, 2, 3, 4]), time_step=0.5, action_length=2,
                                    with_term_sums=True)
        self.assertEqual(result.rewards.tolist(), [1.5, 2.75, 3.5, 4.75])
        self.assertEqual(result.episode_return, 12.5)
        self.assertEqual(result.terms, {"begun": 1, "moved": 10, "touched": 0, "done": 1.5})
        self.assertEqual(result.term_sums[:, 1].tolist(), [1, 3, 6, 10])
        self.assertEqual(result.logs, {"ways": 10})
        self.assertEqual((result.outcome, result.reason, result.time_steps), ("truncated", "", 4))
        ended = self.task.evaluate(episode([1, 6, 1]), time_step=0.5)
        self.assertIsNone(ended.term_sums)
        self.assertEqual((ended.outcome, ended.reason, ended.time_steps), ("success", "arrived", 2))

    def test_reads_any_strides_and_formats(self):
        x = [1, 2, 3]
        wanted = self.task.evaluate(episode(x), time_step=0.5).episode_return
        place = episode(x)["place"]
        wide = np.zeros((3, 7), dtype=np.float32)
        wide[:, 1::2] = place
        for other in (place.astype(np.float32), place.astype(np.int32), place.astype(np.float16),
                      wide[:, 1::2], np.asfortranarray(place), place[::-1].copy()[::-1],
                      place.tolist()):
            result = self.task.evaluate(episode(x, place=other), time_step=0.5)
            self.assertEqual(result.episode_return, wanted)
        still = np.broadcast_to(place[0], (5, 3))
        self.assertEqual(self.task.evaluate(episode([1] * 5, place=still), time_step=0.5).terms["moved"],
                         5)

    def test_entries_stand_for_themselves(self):
        sensors = episode([1, 1])
        del sensors["touches"]
        sensors.update({f"touches[{i}]": np.array([0, i == 2], dtype=np.uint8) for i in range(3)})
        self.assertEqual(self.task.evaluate(sensors, time_step=0.5).terms["touched"], 1)

    def test_several_episodes_have_one_result_each(self):
        episodes = [episode([i] * (10 + i)) for i in range(5)]
        results = self.task.evaluate(episodes, time_step=0.5, action_length=0, threads=3)
        self.assertEqual([each.time_steps for each in results], [10, 11, 12, 13, 14])
        self.assertEqual([each.terms["moved"] for each in results], [0, 11, 24, 39, 56])

    def test_params_and_goals_are_given_by_name(self):
        result = self.task.evaluate(episode([1, 4]), time_step=0.5, params={"gain": 0},
                                    goals={"target": [1, 0]})
        self.assertEqual(result.terms["moved"], 0)
        self.assertEqual(result.metrics["distance"], 3)

    def test_mistakes_are_named(self):
        sensors = episode([1, 2])
        del sensors["steps"]
        with self.assertRaisesRegex(taskc.HostError, "reads `steps`, which is not bound"):
            self.task.evaluate(sensors, time_step=0.5)
        with self.assertRaisesRegex(ValueError, r"`place` has the shape \(3,\)"):
            self.task.evaluate(episode([1, 2], place=np.zeros((2, 2))), time_step=0.5)
        with self.assertRaisesRegex(ValueError, "has 3 time steps, and others have 2"):
            self.task.evaluate(episode([1, 2], touches=np.zeros((3, 3))), time_step=0.5)
        with self.assertRaisesRegex(taskc.HostError, "is of ints, and takes no floats"):
            self.task.evaluate(episode([1, 2], steps=np.zeros(2)), time_step=0.5)
        with self.assertRaisesRegex(taskc.HostError, "did you mean `gain`"):
            self.task.evaluate(episode([1, 2]), time_step=0.5, params={"gian": 1})


class Instances(unittest.TestCase):
    def setUp(self):
        self.task = taskc.load(TASKS / "each.task")
        self.instance = self.task.instance({"gain": 4})

    def test_follows_its_sensors(self):
        instance = self.instance
        instance.start_episode(seed=1)
        instance.sensors["place"][:] = [1, 0, 2]
        self.assertEqual(instance.start_action().reward, 0.5)
        self.assertEqual(instance.end_time_step(0.5).reward, 2)
        self.assertEqual(instance.end_action().reward, 0.75)
        self.assertIsNone(instance.outcome)
        self.assertEqual(instance.phase, "going")
        instance.sensors["place"][0] = 6
        result = instance.end_time_step(0.5)
        self.assertEqual((result.outcome, result.reason), ("success", "arrived"))
        instance.end_episode()
        self.assertEqual(instance.outcome, "success")
        self.assertEqual(instance.metrics["height"], 2)
        self.assertEqual(instance.episode_return, 0.5 + 2 + 0.75 + 12)

    def test_reads_what_is_bound_where_it_is(self):
        places = np.zeros((4, 3), dtype=np.float32)
        self.instance.bind("place", places[2])
        self.instance.bind("turn", taskc.xyzw(np.array([0.25, 0.5, 0.75, 0.125])))
        self.instance.start_episode()
        places[2] = [2, 4, 6]
        self.assertEqual(self.instance.observe().tolist(), [1, 2, 3, 0.125, 0.25, 0.5, 0.75])

    def test_calls_what_is_bound_as_a_function(self):
        self.instance.bind_function("place", lambda: [0.5, 0, 0])
        self.instance.bind_function("touches[1]", lambda: True)
        self.instance.bind_function("touches[0]", lambda: False)
        self.instance.bind_function("touches[2]", lambda: False)
        self.instance.start_episode()
        self.assertEqual(self.instance.end_time_step(0.5).reward, 2)

    def test_a_value_that_is_not_finite_is_not_paid(self):
        self.instance.start_episode()
        self.instance.sensors["place"][0] = math.nan
        self.assertEqual(self.instance.end_time_step(0.5).fault, "moved")

    def test_goals_are_drawn_by_the_seed_or_held(self):
        self.instance.start_episode(seed=3)
        drawn = self.instance.goal("target").tolist()
        self.instance.hold_goal("target", [0.5, -0.5])
        self.instance.start_episode(seed=4)
        self.assertEqual(self.instance.goal("target").tolist(), [0.5, -0.5])
        self.instance.release_goal("target")
        self.instance.start_episode(seed=3)
        self.assertEqual(self.instance.goal("target").tolist(), drawn)

    def test_mistakes_are_named(self):
        with self.assertRaisesRegex(KeyError, "reads no sensor `plase`; it reads `place`"):
            self.instance.bind("plase", np.zeros(3))
        with self.assertRaisesRegex(TypeError, "needs an array"):
            self.instance.bind("place", [0, 0, 0])
        with self.assertRaisesRegex(taskc.HostError, "in `m`, not in `km`"):
            self.instance.set_param("reach", 2, unit="km")
        with self.assertRaisesRegex(taskc.HostError, "no episode runs") as raised:
            self.instance.end_time_step(0.5)
        self.assertEqual(raised.exception.status, 11)


if __name__ == "__main__":
    unittest.main()

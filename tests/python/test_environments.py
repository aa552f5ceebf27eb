"""taskc.make and taskc.make_vec, by the rules that Gymnasium checks environments by.

Gymnasium itself is not needed; where it is installed the classes are its own.
"""

import os
import unittest
import warnings
from pathlib import Path

import numpy as np

import taskc

TASKS = Path(os.environ["TASKS"])

# Episodes of eleven steps, if the robot does not fall: they end right after 20 s.
COARSE = {"action_space.hold": 400}


def with_seed(env, seed):
    return env.reset(seed=seed)[0]


class One(unittest.TestCase):
    def setUp(self):
        self.env = taskc.make("crawling", settings=COARSE, render_mode="rgb_array", render_size=48)
        self.env.action_space.seed(1)

    def tearDown(self):
        self.env.close()

    def test_spaces(self):
        for space in (self.env.action_space, self.env.observation_space):
            self.assertEqual(space.dtype, np.float32)
            self.assertEqual(len(space.shape), 1)
            self.assertTrue(space.contains(space.sample()))
        self.assertEqual(self.env.action_space.low.tolist(), [-1] * 5)
        self.assertEqual(self.env.action_space.high.tolist(), [1] * 5)
        sizes = [each.size for each in self.env.observed]
        self.assertEqual(self.env.observation_space.shape, (sum(sizes),))
        self.assertEqual((self.env.observed[0].name, self.env.observed[0].unit), ("height", "m"))
        self.assertEqual(self.env.observed[1].offset, sizes[0])

    def test_metadata(self):
        self.assertEqual(self.env.metadata["render_modes"], ["rgb_array"])
        self.assertGreater(self.env.metadata["render_fps"], 0)
        self.assertEqual(taskc.make("crawling").metadata["render_fps"], 25)
        self.assertEqual(self.env.dt, 2.0)
        self.assertIs(self.env.unwrapped, self.env)

    def test_reset(self):
        result = self.env.reset(seed=3)
        self.assertEqual(len(result), 2)
        observation, info = result
        self.assertIsInstance(info, dict)
        self.assertTrue(self.env.observation_space.contains(observation))
        self.assertTrue(np.isfinite(observation).all())
        self.assertEqual(self.env.reset(seed=3, options={})[0].tolist(), observation.tolist())

    def test_seeds_its_random_numbers(self):
        self.env.reset(seed=3)
        drawn = self.env.np_random.random()
        self.env.reset(seed=3)
        self.assertEqual(self.env.np_random.random(), drawn)
        self.env.reset()
        self.assertNotEqual(self.env.np_random.random(), drawn)
        for seed in (-1, 2**53):
            with self.assertRaisesRegex(ValueError, "seed"):
                self.env.reset(seed=seed)

    def test_step(self):
        first = with_seed(self.env, 3)
        kept = first.copy()
        result = self.env.step(self.env.action_space.sample())
        self.assertEqual(len(result), 5)
        observation, reward, terminated, truncated, info = result
        self.assertTrue(self.env.observation_space.contains(observation))
        self.assertIsInstance(reward, float)
        self.assertIs(terminated, False)
        self.assertIs(truncated, False)
        self.assertAlmostEqual(sum(info["terms"].values()), reward)
        self.assertNotIn("task", info)
        self.assertEqual(first.tolist(), kept.tolist())  # what it gave is not changed afterwards

    def test_the_same_decisions_are_the_same_episode(self):
        traces = []
        for _ in range(2):
            self.env.action_space.seed(7)
            trace = [with_seed(self.env, 11).tolist()]
            for _ in range(4):
                observation, reward, *_ = self.env.step(self.env.action_space.sample())
                trace.append((observation.tolist(), reward))
            traces.append(trace)
        self.assertEqual(traces[0], traces[1])

    def test_an_episode_ends(self):
        self.env.reset(seed=3)
        total = 0.0
        for _ in range(11):
            _, reward, terminated, truncated, info = self.env.step(0.02 * self.env.action_space.sample())
            total += reward
        self.assertEqual((terminated, truncated), (False, True))
        task = info["task"]
        self.assertAlmostEqual(task["return"], total)
        self.assertEqual(task["terms"], info["terms"])
        self.assertEqual((task["outcome"], task["number"], task["time"]), ("truncated", 4, 20.005))
        self.assertTrue(task["reason"])
        self.assertTrue(all(np.isfinite(value) for value in task["metrics"].values()))
        with self.assertRaisesRegex(taskc.HostError, "reset it first"):
            self.env.step(self.env.action_space.sample())
        self.env.reset()
        self.env.step(self.env.action_space.sample())

    def test_a_parameter_counts_from_the_next_step_on(self):
        with_settings = taskc.make("crawling", settings={**COARSE, "task.turning_cost": 1})
        action = np.full(5, 0.1, np.float32)
        for env in (self.env, with_settings):
            env.reset(seed=3)
        self.assertNotEqual(self.env.step(action)[1], with_settings.step(action)[1])
        self.env.set("task.turning_cost", 1)
        self.assertEqual(self.env.step(action)[1], with_settings.step(action)[1])
        self.env.set("environment.random_friction", (0.5, 1.5))
        with self.assertRaisesRegex(taskc.HostError, "must lie in 0 .. 1, and 2 does not"):
            self.env.set("task.turning_cost", 2)

    def test_a_wrong_action(self):
        self.env.reset(seed=3)
        with self.assertRaisesRegex(ValueError, r"\(5,\)"):
            self.env.step(np.zeros(4, np.float32))
        with self.assertRaisesRegex(taskc.HostError, "finite"):
            self.env.step(np.full(5, np.nan, np.float32))

    def test_render(self):
        self.env.reset(seed=3)
        picture = self.env.render()
        self.assertEqual((picture.shape, picture.dtype), ((48, 48, 3), np.uint8))
        self.assertGreater(len(np.unique(picture.reshape(-1, 3), axis=0)), 20)
        with self.assertRaisesRegex(ValueError, "human"):
            taskc.make("crawling", render_mode="human")

    def test_without_a_render_mode_nothing_is_shown(self):
        with taskc.make("crawling") as env:
            env.reset(seed=1)
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                self.assertIsNone(env.render())
            self.assertIn("rgb_array", str(caught[0].message))

    def test_first_episodes_without_a_seed_differ(self):
        env = taskc.make("crawling", settings=COARSE)
        numbers = set()
        for each in (self.env, env):
            each.reset()
            for _ in range(11):
                *_, info = each.step(0.02 * each.action_space.sample())
            numbers.add(info["task"]["number"])
        self.assertEqual(len(numbers), 2)


class Making(unittest.TestCase):
    def test_says_what_is_wrong(self):
        with self.assertRaisesRegex(ValueError, "there is no task `crawlin`.*crawling, forward"):
            taskc.make("crawlin")
        with self.assertRaisesRegex(taskc.HostError, "did you mean `humanoid`"):
            taskc.make("crawling", robot="humanoit")
        with self.assertRaisesRegex(taskc.HostError, "scale"):
            taskc.make("crawling", settings={"action_space.scael": 1.0})

    def test_settings(self):
        env = taskc.make("crawling", settings={"action_space.dof": "all", "action_space.hold": 4},
                         profile="fast")
        self.assertEqual((env.action_space.shape, env.dt, env.sim.profile), ((17,), 0.02, "fast"))

    def test_takes_tasks_that_are_loaded(self):
        task = taskc.load(TASKS.parents[2] / "tasks" / "turning.task")
        env = taskc.make(task)
        self.assertEqual((env.sim.robot, env.sim.term_names),
                         ("humanoid", tuple(term.name for term in task.terms)))
        self.assertEqual(env.action_space.shape, (17,))  # as its agent says


class Many(unittest.TestCase):
    def setUp(self):
        self.envs = self.make()

    @staticmethod
    def make(**others):
        return taskc.make_vec("crawling", num_envs=3, settings=COARSE, **others)

    def run_for(self, envs, steps):
        envs.action_space.seed(5)
        return [envs.step(0.02 * envs.action_space.sample()) for _ in range(steps)]

    def test_spaces(self):
        envs = self.envs
        self.assertEqual(envs.num_envs, 3)
        self.assertEqual(envs.action_space.shape, (3, 5))
        self.assertEqual(envs.single_action_space.shape, (5,))
        self.assertEqual(envs.observation_space.shape, (3,) + envs.single_observation_space.shape)
        self.assertEqual(envs.metadata["autoreset_mode"], taskc.AutoresetMode.NEXT_STEP)

    def test_each_is_what_it_is_alone(self):
        observations, _ = self.envs.reset(seed=[4, 9, 2])
        self.assertTrue(self.envs.observation_space.contains(observations))
        self.envs.action_space.seed(5)
        actions = [self.envs.action_space.sample() for _ in range(3)]
        rewards = [self.envs.step(each)[1] for each in actions]
        for index, seed in enumerate([4, 9, 2]):
            env = taskc.make("crawling", settings=COARSE)
            self.assertEqual(env.reset(seed=seed)[0].tolist(), observations[index].tolist())
            for step in range(3):
                self.assertEqual(env.step(actions[step][index])[1], rewards[step][index])

    def test_one_seed_is_that_of_the_first(self):
        self.envs.reset(seed=7)
        *_, infos = self.run_for(self.envs, 11)[-1]
        self.assertEqual(infos["task"]["number"].tolist(), [8, 9, 10])
        with self.assertRaisesRegex(ValueError, "2 seeds for 3"):
            self.envs.reset(seed=[1, 2])

    def test_types(self):
        self.envs.reset(seed=7)
        observations, rewards, terminated, truncated, infos = self.run_for(self.envs, 1)[0]
        self.assertEqual((observations.dtype, rewards.dtype), (np.float32, np.float64))
        for flags in (terminated, truncated):
            self.assertEqual((flags.dtype, flags.shape), (np.bool_, (3,)))
        self.assertAlmostEqual(sum(paid[1] for paid in self.envs.terms.values()), rewards[1])
        self.assertEqual(infos, {})

    def test_next_step(self):
        first, _ = self.envs.reset(seed=7)
        steps = self.run_for(self.envs, 11)
        terms = self.envs.terms
        steps += self.run_for(self.envs, 1)
        _, _, _, truncated, infos = steps[10]
        self.assertTrue(truncated.all())
        task = infos["task"]
        self.assertEqual(task["outcome"].tolist(), ["truncated"] * 3)
        self.assertEqual(infos["_task"].tolist(), [True] * 3)
        for name in self.envs.sim.term_names:
            self.assertEqual(task["terms"][name].tolist(), terms[name].tolist())
        observations, rewards, _, truncated, _ = steps[11]
        self.assertFalse(truncated.any())
        self.assertEqual(rewards.tolist(), [0] * 3)
        self.assertEqual(observations.tolist(), first.tolist())

    def test_same_step(self):
        envs = self.make(autoreset_mode="SameStep")
        first, _ = envs.reset(seed=7)
        observations, _, _, truncated, infos = self.run_for(envs, 11)[-1]
        self.assertTrue(truncated.all())
        self.assertEqual(observations.tolist(), first.tolist())
        self.assertNotEqual(infos["final_obs"][1].tolist(), first[1].tolist())
        self.assertIs(infos["final_info"]["task"], infos["task"])

    def test_disabled(self):
        envs = self.make(autoreset_mode=taskc.AutoresetMode.DISABLED)
        envs.reset(seed=7)
        self.run_for(envs, 11)
        with self.assertRaisesRegex(taskc.HostError, "reset it first"):
            self.run_for(envs, 1)
        envs.reset(options={"reset_mask": np.array([True, True, True])})
        self.run_for(envs, 1)

    def test_a_parameter_is_set_where_it_is_wanted(self):
        envs = self.envs
        envs.set("task.turning_cost", 0, which=[True, False, True])
        envs.reset(seed=7)
        self.run_for(envs, 2)
        paid = envs.terms["turning"].tolist()
        self.assertEqual((paid[0], paid[2]), (0, 0))
        self.assertLess(paid[1], 0)
        with self.assertRaisesRegex(ValueError, r"which has the shape \(2,\)"):
            envs.set("task.turning_cost", 0, which=[True, False])

    def test_what_is_kept_stays(self):
        def keep(steps):
            return [[array.tolist() for array in step[:4]] for step in steps]

        self.envs.reset(seed=7)
        alone = [keep([step])[0] for step in (self.run_for(self.envs, 1)[0] for _ in range(6))]
        self.envs.reset(seed=7)
        steps = [self.run_for(self.envs, 1)[0] for _ in range(6)]  # all arrays are held
        views = [step[0][1, :3] for step in steps]
        self.assertEqual(keep(steps), alone)
        del steps
        self.run_for(self.envs, 6)
        self.assertEqual([view.tolist() for view in views], [step[0][1][:3] for step in alone])

    def test_arrays_that_nobody_keeps_are_used_again(self):
        self.envs.reset(seed=7)
        places = {self.run_for(self.envs, 1)[0][0].ctypes.data for _ in range(6)}
        self.assertEqual(len(places), 1)

    def test_a_reset_of_some_shows_the_others_as_they_are(self):
        self.envs.reset(seed=7)
        before = self.run_for(self.envs, 1)[0][0]
        after, _ = self.envs.reset(options={"reset_mask": np.array([False, True, False])})
        self.assertEqual(after[0].tolist(), before[0].tolist())
        self.assertNotEqual(after[1].tolist(), before[1].tolist())

    def test_copies(self):
        kept, *_ = self.envs.reset(seed=7)
        again, *_ = self.envs.reset(seed=8)
        self.assertIsNot(kept, again)
        envs = self.make(copy=False)
        kept, *_ = envs.reset(seed=7)
        again, *_ = envs.reset(seed=8)
        self.assertIs(kept, again)

    def test_wrong_actions(self):
        self.envs.reset(seed=7)
        with self.assertRaisesRegex(ValueError, r"\(3, 5\)"):
            self.envs.step(np.zeros(5, np.float32))

    def test_render(self):
        envs = self.make(render_mode="rgb_array", render_size=32)
        envs.reset(seed=7)
        pictures = envs.render()
        self.assertEqual([each.shape for each in pictures], [(32, 32, 3)] * 3)

    def test_closes(self):
        self.envs.reset(seed=1)
        self.envs.close()
        with self.assertRaises(taskc.HostError):
            self.envs.reset(seed=1)


if __name__ == "__main__":
    unittest.main()

"""Our environments under Gymnasium's own checker, registry and wrappers, where it is installed."""

import os
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

import taskc

try:
    import gymnasium
    from gymnasium.utils.env_checker import check_env
    from gymnasium.vector import AutoresetMode
except ImportError:
    raise unittest.SkipTest("Gymnasium is not installed")

# Episodes of eleven steps, if the robot does not fall.
COARSE = {"action_space.hold": 400}

SWING = """task swing

sensor pole.height: real
sensor pole.rate: real [rad/s]
memory steps: int = 0

on end_of_time_step {
  reward up = pole.height
  reward hurry = -0.01 * abs(pole.rate) / 1 rad/s
  steps += 1
  if steps == 40 { truncate_episode "time is up" }
}
"""


def swing(folder, **options):
    """Gymnasium's pendulum, paid by a task of ours."""
    task = Path(folder) / "swing.task"
    task.write_text(SWING)
    return taskc.Wrapper(gymnasium.make("Pendulum-v1", **options), str(task), time_step=0.05, sensors={
        "pole.height": 0,
        "pole.rate": lambda env, observation, info: env.state[1],
    })


def checked(env, **options):
    """What Gymnasium's checker warns of. It raises where a rule is broken."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        check_env(env, **options)
    return [str(warning.message) for warning in caught]


class Checked(unittest.TestCase):
    def test_a_robot_in_a_task(self):
        with taskc.make("crawling", render_mode="rgb_array", render_size=48) as env:
            self.assertIsInstance(env, gymnasium.Env)
            for warning in checked(env):
                # What a simulation shows has no limits, and a name is given by the registry only.
                self.assertRegex(warning, "infinity|not having a spec")

    def test_an_environment_of_gymnasium_in_a_task(self):
        with tempfile.TemporaryDirectory() as folder, swing(folder) as env:
            checked(env, skip_render_check=True)  # the pendulum is drawn by pygame
            with env.spec.make() as again:
                again.reset(seed=1)
                env.reset(seed=1)
                action = np.array([0.5], np.float32)
                self.assertEqual(again.step(action)[1:4], env.step(action)[1:4])

    def test_what_the_registry_makes(self):
        gymnasium.register("taskc/Crawling-v0",
                           entry_point=lambda **options: taskc.make("crawling", **options),
                           vector_entry_point=lambda num_envs, **options: taskc.make_vec(
                               "crawling", num_envs, **options))
        self.addCleanup(gymnasium.registry.pop, "taskc/Crawling-v0")
        with gymnasium.make("taskc/Crawling-v0", render_mode="rgb_array", render_size=48) as env:
            for warning in checked(env.unwrapped):
                self.assertRegex(warning, "infinity")
        for mode in ("vector_entry_point", "sync"):
            envs = gymnasium.make_vec("taskc/Crawling-v0", 3, mode, settings=COARSE)
            envs.reset(seed=1)
            observations, rewards, *_ = envs.step(envs.action_space.sample())
            self.assertTrue(envs.observation_space.contains(observations))
            self.assertEqual(rewards.shape, (3,))
            envs.close()


class Wrapped(unittest.TestCase):
    def test_one(self):
        wrappers = gymnasium.wrappers
        env = taskc.make("crawling", settings=COARSE)
        env = wrappers.TimeLimit(wrappers.PassiveEnvChecker(env), 6)
        env = wrappers.FrameStackObservation(wrappers.NormalizeObservation(wrappers.ClipAction(env)), 3)
        env = wrappers.RecordEpisodeStatistics(env)
        observation, _ = env.reset(seed=1)
        self.assertEqual(observation.shape, env.observation_space.shape)
        paid = []
        for _ in range(6):
            _, reward, terminated, truncated, info = env.step(np.zeros(5, np.float32))
            paid.append(reward)
        self.assertEqual((terminated, truncated), (False, True))
        self.assertAlmostEqual(float(info["episode"]["r"]), sum(paid))
        env.close()

    def test_many(self):
        for mode in AutoresetMode:
            with self.subTest(mode):
                envs = taskc.make_vec("crawling", 4, settings=COARSE, autoreset_mode=mode)
                self.assertIsInstance(envs, gymnasium.vector.VectorEnv)
                counted = gymnasium.wrappers.vector.RecordEpisodeStatistics(envs)
                counted.reset(seed=5)
                finished = 0
                for _ in range(30):
                    _, _, terminated, truncated, infos = counted.step(np.zeros((4, 5), np.float32))
                    over = terminated | truncated
                    if "task" not in infos:
                        continue
                    finished += over.sum()
                    np.testing.assert_array_equal(infos["_episode"], infos["_task"])
                    if mode != AutoresetMode.SAME_STEP:  # its first rewards are not counted there
                        np.testing.assert_allclose(infos["episode"]["r"][over],
                                                   infos["task"]["return"][over])
                    if mode == AutoresetMode.DISABLED and over.any():
                        counted.reset(options={"reset_mask": over})
                self.assertGreaterEqual(finished, 8)
                counted.close()

    def test_an_environment_of_gymnasium_in_a_task(self):
        with tempfile.TemporaryDirectory() as folder, swing(folder) as env:
            _, info = env.reset(seed=4)
            paid = 0.0
            for _ in range(40):
                self.assertNotIn("task", info)
                observation, reward, terminated, truncated, info = env.step(
                    np.array([0.5], np.float32))
                self.assertAlmostEqual(
                    reward, observation[0] - 0.01 * abs(env.unwrapped.state[1]), places=6)
                paid += reward
            self.assertEqual((terminated, truncated), (False, True))
            self.assertEqual(info["task"]["reason"], "time is up")
            self.assertAlmostEqual(info["task"]["return"], paid)
            self.assertLess(info["env_reward"], 0)


if __name__ == "__main__":
    unittest.main()

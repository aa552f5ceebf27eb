"""taskc.Wrapper around an environment that follows Gymnasium's contract."""

import os
import unittest
from pathlib import Path

import numpy as np

import taskc
from taskc._gymnasium import Env

TASKS = Path(os.environ["TASKS"])


class Cart(Env):
    """Moves by what it is told; is over after six steps, or where it is told more than 2."""

    action_space = "a space"
    observation_space = "another"
    dt = 0.5

    def __init__(self):
        self.seeds = []

    @property
    def unwrapped(self):
        return self

    def reset(self, *, seed=None, options=None):
        del options
        self.seeds.append(seed)
        self.position, self.steps = 0.0, 0
        return self.observation(), {"turn": [1, 0, 0, 0]}

    def step(self, action):
        self.position += action
        self.steps += 1
        return (self.observation(), -1.0, action > 2, self.steps == 6,
                {"turn": [1, 0, 0, 0], "own": 7})

    def observation(self):
        return np.array([self.position, 0, 0, 9], dtype=np.float32)

    def render(self):
        return "a picture"

    def close(self):
        self.position = None


SENSORS = {
    "place": slice(0, 3),
    "turn": "turn",
    "steps": lambda env, observation, info: env.steps,
    "touches": lambda env, observation, info: [observation[0] > 3, False, False],
}


class Wrapping(unittest.TestCase):
    def setUp(self):
        self.cart = Cart()
        self.env = taskc.Wrapper(self.cart, str(TASKS / "each.task"), SENSORS)

    def run_with(self, actions):
        steps = []
        for action in actions:
            steps.append(self.env.step(action))
        return steps

    def test_pays_what_the_task_pays(self):
        observation, info = self.env.reset(seed=5)
        self.assertEqual((observation.tolist(), info["turn"]), ([0, 0, 0, 9], [1, 0, 0, 0]))
        self.assertEqual(self.cart.seeds, [5])
        observation, reward, terminated, truncated, info = self.env.step(1)
        self.assertEqual((observation[0], reward, terminated, truncated), (1, 2.25, False, False))
        self.assertIsInstance(reward, float)
        self.assertEqual((info["env_reward"], info["own"]), (-1, 7))
        self.assertNotIn("task", info)

    def test_ends_where_the_task_does(self):
        self.env.reset(seed=5)
        _, reward, terminated, truncated, info = self.run_with([2, 2, 2])[-1]
        self.assertEqual((terminated, truncated), (True, False))
        self.assertEqual(reward, 0.5 + 6 + 1)  # the action is not done
        self.assertEqual((info["task"]["outcome"], info["task"]["reason"]), ("success", "arrived"))
        self.assertEqual(info["task"]["return"], 2 + 4 + 6 + 2 + 3 * 0.5 + 2 * 0.75)
        self.assertEqual(info["task"]["metrics"]["height"], 0)
        self.env.reset()
        self.assertEqual(self.env.step(1)[1], 2.25)

    def test_a_limit_of_the_environment_is_a_limit(self):
        self.env.reset(seed=5)
        _, reward, terminated, truncated, info = self.run_with([0] * 6)[-1]
        self.assertEqual((terminated, truncated, reward), (False, True, 1.25))
        self.assertEqual((info["task"]["outcome"], info["task"]["reason"]), ("truncated", ""))

    def test_the_environments_own_ends_count_where_they_are_kept(self):
        self.env.reset(seed=5)
        _, _, terminated, _, info = self.env.step(3)
        self.assertEqual((terminated, info["env_terminated"]), (False, True))
        kept = taskc.Wrapper(Cart(), str(TASKS / "each.task"), SENSORS, keep_ends=True)
        kept.reset(seed=5)
        _, _, terminated, truncated, info = kept.step(3)
        self.assertEqual((terminated, truncated), (True, False))
        self.assertEqual(info["task"]["outcome"], "failure")

    def test_the_same_seed_gives_the_same_episodes(self):
        goals = []
        for _ in range(2):
            self.env.reset(seed=9)
            goals.append(self.env.instance.goal("target").tolist())
            self.env.reset()
            goals.append(self.env.instance.goal("target").tolist())
        self.assertEqual(goals[:2], goals[2:])
        self.assertNotEqual(goals[0], goals[1])

    def test_is_the_environment_in_all_else(self):
        self.assertEqual(self.env.action_space, "a space")
        self.assertEqual(self.env.observation_space, "another")
        self.assertEqual(self.env.render(), "a picture")
        self.assertIs(self.env.unwrapped, self.cart)
        self.env.close()

    def test_mistakes_are_named(self):
        with self.assertRaisesRegex(ValueError, r"no \['turn', 'steps', 'touches'\]"):
            taskc.Wrapper(self.cart, self.env.task, {"place": slice(0, 3)})
        with self.assertRaisesRegex(ValueError, r"\['plase'\], which it does not read"):
            taskc.Wrapper(self.cart, self.env.task, {**SENSORS, "plase": 0})
        with self.assertRaisesRegex(ValueError, "say how long a step is"):
            taskc.Wrapper(Env(), self.env.task, SENSORS)


if __name__ == "__main__":
    unittest.main()

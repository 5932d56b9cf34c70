# SPDX-License-Identifier: Apache-2.0
"""Several axes, via points, queues, and setpoints in each cycle."""
import unittest

import jounce
import numpy as np

AXES = jounce.Bounds([2, 1], [10, 5], [100, 50])


class Synchronized(unittest.TestCase):
    def test_all_axes_arrive_at_the_same_instant(self) -> None:
        moves = jounce.synchronize([0, 0], [1, 2], AXES)
        alone = jounce.move_to([0, 0], [1, 2], AXES).duration
        np.testing.assert_allclose(moves.duration, alone.max(), rtol=1e-14)
        self.assertEqual(moves[0].end.position, 1)

    def test_phase_keeps_the_line(self) -> None:
        moves = jounce.synchronize([0, 0], [1, 2], AXES, sync="phase")
        p = moves.at(np.linspace(0, moves.duration[0], 50)[:, None]).position
        np.testing.assert_allclose(p[:, 1], 2 * p[:, 0], atol=1e-12)

    def test_groups_equal_single_groups(self) -> None:
        random = np.random.default_rng(4)
        start, target = random.normal(size=(2, 20, 2))
        together = jounce.synchronize(start, target, AXES).duration
        for i in range(20):
            np.testing.assert_array_equal(jounce.synchronize(start[i], target[i], AXES).duration, together[i])

    def test_errors_name_the_axis(self) -> None:
        with self.assertRaises(jounce.MoveError) as caught:
            jounce.synchronize([0, 0], jounce.State([1, 1], [0, 5]), AXES)
        self.assertIn("axis 1", str(caught.exception))
        many = jounce.synchronize(np.zeros((2, 2)), jounce.State([1.0, 1.0], [[0, 0], [0, 5]]), AXES)
        np.testing.assert_array_equal(many.ok, [[True, True], [False, False]])
        with self.assertRaises(jounce.InputError):
            jounce.synchronize(0, 1, jounce.Bounds(1, 1, 1))


class Via(unittest.TestCase):
    def test_it_passes_the_points_within_the_bounds(self) -> None:
        points = np.array([[0, 0], [1, 0.5], [2, 2]])
        motion = jounce.via(points, AXES)
        for k, axis in enumerate(motion.axes):
            np.testing.assert_allclose(axis(motion.times), points[:, k], atol=1e-9)
            np.testing.assert_allclose(axis.at(motion.times).velocity, motion.velocity[:, k], atol=1e-9)
            self.assertTrue(axis.check(jounce.Limits(velocity=[2, 1][k], acceleration=[10, 5][k], jerk=[100, 50][k])))
        self.assertLess(motion.duration, motion.stopping_duration)
        with self.assertRaises(jounce.InputError):
            jounce.via([[0, 0]], AXES)
        with self.assertRaises(ValueError):
            jounce.via([[0, 0, 0], [1, 1, 1]], AXES)


class Queue(unittest.TestCase):
    def test_blending_passes_the_junction_at_the_lower_velocity(self) -> None:
        queue = jounce.queue([
            jounce.Command.move_absolute(10, velocity=5, acceleration=10),
            jounce.Command.move_absolute(50, velocity=20, acceleration=20, mode="blending_low"),
            jounce.Command.dwell(0.5),
            jounce.Command.move_relative(-10, velocity=5, acceleration=10, jerk=100),
        ])
        first = queue.commands[0]
        self.assertEqual((first.reached, first.target, first.aborted), (5, 10, False))
        self.assertAlmostEqual(queue.curve.at(first.end).velocity, 5, delta=1e-12)
        self.assertEqual(queue.end, jounce.State(40, 0, 0))
        self.assertAlmostEqual(queue.commands[3].begin - queue.commands[1].end, 0.5, delta=1e-12)

    def test_errors_name_the_command(self) -> None:
        with self.assertRaises(jounce.InputError) as caught:
            jounce.queue([jounce.Command.move_absolute(10, velocity=-5, acceleration=10)])
        self.assertIn("[1]", caught.exception.key)
        with self.assertRaises(jounce.InputError) as caught:
            jounce.Command.move_absolute(10, velocity=5, acceleration=10, mode="blended")
        self.assertIn("blending_low", caught.exception.rule)


class Online(unittest.TestCase):
    def test_it_reaches_the_target_in_the_time_of_the_offline_plan(self) -> None:
        generator = jounce.OnlineGenerator(2, sync="time")
        generator.set_bounds(AXES)
        generator.set_target([1, -0.5])
        t, motion = generator.run(0.001)
        planned = jounce.synchronize([0, 0], [1, -0.5], AXES)
        self.assertAlmostEqual(t[-1], planned.duration[0], delta=0.0011)
        np.testing.assert_array_equal(motion.position[-1], [1, -0.5])
        np.testing.assert_allclose(motion.position, planned.at(t[:, None]).position, atol=1e-12)
        self.assertTrue(generator.step(0.001).arrived)

    def test_steps_equal_a_run(self) -> None:
        def made() -> jounce.OnlineGenerator:
            generator = jounce.OnlineGenerator(2, sync="phase_or_time")
            generator.set_bounds(AXES)
            generator.set_state(jounce.State([0.5, 0], [1, 0]))
            generator.set_target(jounce.State([2, 1], [0.5, 0]))
            return generator

        _, motion = made().run(0.01, most=30)
        steps = made()
        for row in range(30):
            steps.step(0.01)
            np.testing.assert_array_equal(steps.motion.position, motion.position[row])

    def test_errors(self) -> None:
        generator = jounce.OnlineGenerator(2)
        with self.assertRaises(jounce.InputError):
            generator.set_target([1, 2, 3])
        with self.assertRaises(jounce.MoveError) as caught:
            generator.set_bounds(jounce.Bounds([1, 1e60], 1, 1))
        self.assertIn("axis 1", str(caught.exception))
        with self.assertRaises(jounce.InputError):
            generator.step(-1)
        with self.assertRaises(jounce.InputError):
            jounce.OnlineGenerator(0)
        with self.assertRaises(IndexError):
            generator.set_enabled(2, False)


if __name__ == "__main__":
    unittest.main()

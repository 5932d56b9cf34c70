# SPDX-License-Identifier: Apache-2.0
"""Moves and batches of moves, against closed forms."""
import concurrent.futures
import copy
import gc
import math
import pickle
import unittest

import jounce
import numpy as np

AXIS = jounce.Bounds(velocity=2, acceleration=10, jerk=100)


def seven_phases(distance: float, v: float, a: float, j: float) -> float:
    """The least duration from rest to rest, from the areas under the velocity (independent of the library)."""
    if v * j >= a * a:  # a ramp reaches the acceleration
        ramp = v / a + a / j
    else:
        ramp = 2 * math.sqrt(v / j)
    if distance >= v * ramp:
        return ramp + distance / v
    if distance >= 2 * a**3 / j**2:  # the peak w of the velocity: w (w / a + a / j) = distance
        w = (-a * a / j + math.sqrt((a * a / j) ** 2 + 4 * a * distance)) / 2
        return 2 * (w / a + a / j)
    return 4 * (distance / (2 * j)) ** (1 / 3)


class TheBounds(unittest.TestCase):
    def test_wrong_ones_are_rejected_at_once(self) -> None:
        nan = float("nan")
        for key, rule, arguments in (("velocity", "greater than 0", {"velocity": -1.0}),
                                     ("velocity", "greater than 0", {"velocity": 0.0}),
                                     ("acceleration", "greater than 0", {"acceleration": nan}),
                                     ("jerk[1]", "greater than 0", {"jerk": [5, -1]}),
                                     ("jerk_min", "less than 0", {"jerk": 5, "jerk_min": 5}),
                                     ("position_max", "a number", {"position_max": nan})):
            with self.assertRaises(jounce.InputError) as caught:
                jounce.Bounds(**arguments)  # type: ignore[arg-type]
            self.assertEqual(caught.exception.key, key)
            self.assertIn(rule, caught.exception.rule)


class OneMove(unittest.TestCase):
    def test_the_duration_is_that_of_the_closed_form(self) -> None:
        for distance in (1e-3, 0.01, 0.05, 0.3, 0.6, 1, 7, 1e4):
            self.assertAlmostEqual(jounce.move_to(0, distance, AXIS).duration / seven_phases(distance, 2, 10, 100), 1,
                                   delta=1e-14)

    def test_it_begins_and_ends_exactly_in_the_given_states(self) -> None:
        start, target = jounce.State(0.1, -1, 2), jounce.State(1.3, 0.5, -1)
        move = jounce.move_to(start, target, AXIS)
        self.assertEqual((move.start, move.end), (start, target))
        self.assertEqual(move.at(move.duration)[:3], target)
        self.assertEqual(move(0), 0.1)
        self.assertTrue(move.check(AXIS.limits))

    def test_phases_integrate_to_the_motion(self) -> None:
        move = jounce.move_to(jounce.State(0, 1), 3, AXIS)
        p, v, a, t = 0.0, 1.0, 0.0, 0.0
        for duration, jerk in move.phases:
            p += v * duration + a * duration**2 / 2 + jerk * duration**3 / 6
            v += a * duration + jerk * duration**2 / 2
            a += jerk * duration
            t += duration
        self.assertAlmostEqual(p, 3, delta=1e-13)
        self.assertAlmostEqual(v, 0, delta=1e-13)
        self.assertAlmostEqual(t, move.duration, delta=1e-14)

    def test_a_uniform_grid_ends_at_or_after_the_end(self) -> None:
        for duration, count in ((0.8005, 802), (0.8, 801), (0.80099, 802)):
            move = jounce.move_to(0, 1, jounce.Bounds(velocity=20, acceleration=100, jerk=1000), duration=duration)
            t, motion = move.sample(0.001, uniform=True)
            self.assertEqual(len(t), count)
            np.testing.assert_array_equal(t, np.arange(count) * 0.001)
            np.testing.assert_allclose(motion.position[-1], 1, atol=1e-12)
            plain = move.sample(0.001)[0]
            np.testing.assert_array_equal(plain[:-1], t[:-1])
            self.assertEqual(plain[-1], move.duration)

    def test_a_requested_duration_is_kept(self) -> None:
        move = jounce.move_to(0, 1, AXIS, duration=1.25)
        self.assertAlmostEqual(move.duration, 1.25, delta=1e-15)
        with self.assertRaises(jounce.MoveError) as caught:
            jounce.move_to(0, 1, AXIS, duration=0.5)
        self.assertEqual(caught.exception.status, "too_short")
        self.assertIn(repr(jounce.durations(0, 1, AXIS).minimum), str(caught.exception))
        self.assertEqual(jounce.durations(0, 1, AXIS).minimum, jounce.move_to(0, 1, AXIS).duration)
        self.assertFalse(jounce.durations(0, 1, AXIS).allows(0.5))

    def test_blocked_durations_have_no_move(self) -> None:
        start, target = jounce.State(0, 1), jounce.State(0.1, 1)
        possible = jounce.durations(start, target, AXIS)
        self.assertEqual(len(possible.blocked), 1)
        low, high = possible.blocked[0]
        self.assertEqual(possible.at_least((low + high) / 2), high)
        with self.assertRaises(jounce.MoveError) as caught:
            jounce.move_to(start, target, AXIS, duration=(low + high) / 2)
        self.assertEqual(caught.exception.status, "blocked")

    def test_stop_and_velocity(self) -> None:
        stop = jounce.stop(jounce.State(0, 2), AXIS)
        self.assertAlmostEqual(stop.duration, 2 / 10 + 10 / 100, delta=1e-15)
        self.assertAlmostEqual(stop.end.position, 2 * stop.duration / 2, delta=1e-15)
        faster = jounce.move_velocity(jounce.State(0, 0), 1.5, AXIS)
        self.assertEqual(faster.end.velocity, 1.5)

    def test_generators(self) -> None:
        self.assertAlmostEqual(jounce.trapezoid(0, 50, velocity=10, acceleration=20).duration, 5.5, delta=1e-14)
        self.assertAlmostEqual(jounce.s_curve(0, 50, velocity=10, acceleration=20, jerk=100).duration, 5.7, delta=1e-14)
        smooth = jounce.fourth_order(0, 0.1, velocity=0.25, acceleration=2, jerk=40, jounce=2000)
        self.assertTrue(smooth.check_continuity(3))
        self.assertTrue(smooth.check(jounce.Limits(velocity=0.25, acceleration=2, jerk=40)))

    def test_bounds_of_each_direction(self) -> None:
        bounds = jounce.Bounds(2, 10, 100, velocity_min=-1, position_max=5)
        self.assertEqual(bounds.velocity_min, -1)
        self.assertGreater(jounce.move_to(1, 0, bounds).duration, jounce.move_to(0, 1, bounds).duration)
        self.assertEqual(repr(bounds), "Bounds(velocity=2, velocity_min=-1, acceleration=10, jerk=100, position_max=5)")
        with self.assertRaises(jounce.InputError):
            bounds.limits
        with self.assertRaises(jounce.MoveError):
            jounce.move_to(0, 6, bounds)

    def test_errors_have_their_parts(self) -> None:
        with self.assertRaises(jounce.InputError) as caught:
            jounce.trapezoid(0, 1, velocity=-1, acceleration=2)
        error = caught.exception
        self.assertEqual((error.key, error.value, error.rule), ("velocity", "-1", "must be greater than 0"))
        self.assertEqual((error.file, error.line, error.column, error.errors), ("", 0, 0, (error,)))
        self.assertIsInstance(error, ValueError)
        pickled = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(pickled), pickled.key, pickled.rule), (str(error), error.key, error.rule))
        with self.assertRaises(TypeError):
            jounce.move_to(0, "far", AXIS)
        with self.assertRaises(TypeError):
            jounce.move_to(0, None, AXIS)


class ManyMoves(unittest.TestCase):
    def test_each_equals_the_single_move_bit_for_bit(self) -> None:
        random = np.random.default_rng(1)
        n = 300
        start = jounce.State(random.normal(size=n), random.uniform(-1, 1, n), random.uniform(-3, 3, n))
        target = jounce.State(random.normal(size=n), random.uniform(-1, 1, n))
        velocity = random.uniform(1.5, 3, n)
        moves = jounce.move_to(start, target, jounce.Bounds(velocity, 10, 100))
        self.assertTrue(moves.ok.all())
        t = random.uniform(0, 1, n)
        together = moves.at(t)
        for i in range(n):
            one = jounce.move_to(jounce.State(*(float(x[i]) for x in start)),
                                 jounce.State(float(target.position[i]), float(target.velocity[i])),
                                 jounce.Bounds(float(velocity[i]), 10, 100))
            self.assertEqual(one.duration, moves.duration[i])
            self.assertEqual(one.at(float(t[i])), tuple(float(x[i]) for x in together))
            self.assertEqual(one.phases, moves[i].phases)

    def test_broadcasting(self) -> None:
        moves = jounce.move_to(np.zeros((2, 1)), [1, 2, 3], AXIS)
        self.assertEqual(moves.shape, (2, 3))
        self.assertEqual(moves.duration.shape, (2, 3))
        self.assertEqual(moves[1, -1].end.position, 3)
        self.assertEqual(moves.at(np.linspace(0, 1, 4).reshape(4, 1, 1)).velocity.shape, (4, 2, 3))
        with self.assertRaises(IndexError):
            moves[2, 0]
        with self.assertRaises(IndexError):
            moves[0]
        with self.assertRaises(ValueError):
            jounce.move_to([0, 1], [1, 2, 3], AXIS)
        self.assertEqual(jounce.move_to([], 1, AXIS).duration.shape, (0,))

    def test_any_kind_of_array(self) -> None:
        wide = np.arange(12, dtype=np.float32).reshape(3, 4)
        expected = jounce.move_to(0, np.ascontiguousarray(wide.T, dtype=float) + 1, AXIS).duration
        for array in (wide.T + 1, np.asfortranarray(wide.T + 1), (wide.T + 1).astype(int), (wide.T + 1).tolist()):
            np.testing.assert_array_equal(jounce.move_to(0, array, AXIS).duration, expected)

    def test_moves_that_do_not_exist(self) -> None:
        moves = jounce.move_to(0, jounce.State([1, 1], [0, 5]), AXIS)
        np.testing.assert_array_equal(moves.ok, [True, False])
        self.assertTrue(np.isnan(moves.duration[1]) and np.isnan(moves.at(0.1).position[1]))
        with self.assertRaises(jounce.MoveError) as caught:
            moves[1]
        self.assertEqual(caught.exception.status, "target_outside")

    def test_durations_by_vectors(self) -> None:
        distances = np.random.default_rng(2).uniform(-3, 3, 1001)
        np.testing.assert_allclose(jounce.minimum_durations(distances, velocity=2, acceleration=10, jerk=100),
                                   jounce.move_to(0, distances, AXIS).duration, rtol=1e-12)
        self.assertAlmostEqual(jounce.minimum_durations(1, velocity=2, acceleration=10, jerk=100), 0.8, delta=1e-12)

    def test_results_keep_their_memory_alive(self) -> None:
        moves = jounce.move_to(0, np.arange(1.0, 1000), AXIS)
        durations = moves.duration
        expected = durations.copy()
        del moves
        gc.collect()
        other = [np.full(999, np.nan) for _ in range(50)]
        np.testing.assert_array_equal(durations, expected)
        self.assertEqual(len(other), 50)
        with self.assertRaises(ValueError):
            durations[0] = 1

    def test_threads(self) -> None:
        targets = np.random.default_rng(3).uniform(0.1, 5, (4, 20000))
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            parallel = list(pool.map(lambda row: jounce.move_to(0, row, AXIS).duration, targets))
        np.testing.assert_array_equal(parallel, jounce.move_to(0, targets, AXIS).duration)


class ManyKindsOfArguments(unittest.TestCase):
    def test_moves_of_several_axes_have_no_order(self) -> None:
        moves = jounce.move_to(np.zeros((3, 1)), np.arange(1, 5), AXIS)
        with self.assertRaises(TypeError):
            list(moves)
        with self.assertRaises(IndexError):
            moves[3, 0]
        self.assertEqual([m.end.position for m in jounce.move_to(0, [1, 2], AXIS)], [1, 2])
        with self.assertRaises(TypeError):
            jounce.move_to(0, [1, 2], AXIS)[0:1]

    def test_a_time_that_is_not_a_number_has_no_position(self) -> None:
        move = jounce.move_to(0, 1, AXIS)
        self.assertTrue(math.isnan(move(math.nan)))
        self.assertTrue(math.isnan(move.at(math.nan).velocity))
        np.testing.assert_array_equal(np.isnan(move([0.1, math.nan])), [False, True])
        np.testing.assert_array_equal(
            np.isnan(jounce.move_to(0, [1, 2], AXIS).at(math.nan).position), [True, True])

    def test_arrays_without_real_numbers_are_rejected(self) -> None:
        for wrong in (np.array([1 + 1j]), np.array(["1"]), np.array(["2020-01-01"], dtype="datetime64[s]"), "1"):
            with self.assertRaises(TypeError, msg=repr(wrong)):
                jounce.move_to(0, wrong, AXIS)
        for right in (np.array([1], dtype=np.int8), np.array([1], dtype=">f4"), np.array([True]), [1]):
            self.assertEqual(jounce.move_to(0, right, AXIS)[0].end.position, 1)

    def test_a_copy_is_the_same_object(self) -> None:
        for value in (AXIS, AXIS.limits, jounce.move_to(0, 1, AXIS)):
            self.assertIs(copy.copy(value), value)
            self.assertIs(copy.deepcopy([value])[0], value)
        with self.assertRaises(TypeError):
            copy.deepcopy(jounce.OnlineGenerator(1))


if __name__ == "__main__":
    unittest.main()

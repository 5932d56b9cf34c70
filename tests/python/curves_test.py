# SPDX-License-Identifier: Apache-2.0
"""Curves: evaluation, algebra, extrema, checks."""
import gc
import unittest

import jounce
import numpy as np


def rise() -> jounce.Trajectory:
    return jounce.s_curve(0, 50, velocity=10, acceleration=20, jerk=100).curve


class Evaluation(unittest.TestCase):
    def test_arrays_equal_single_values(self) -> None:
        curve = rise()
        t = np.linspace(-0.5, 6, 77).reshape(7, 11)
        motion = curve.at(t)
        np.testing.assert_array_equal(curve(t), motion.position)
        for index in np.ndindex(t.shape):
            self.assertEqual(curve.at(float(t[index])), tuple(float(x[index]) for x in motion))

    def test_samples_end_at_the_end(self) -> None:
        t, motion = rise().sample(0.1)
        self.assertEqual(len(t), 58)
        self.assertEqual((t[0], t[-1]), (0, rise().end))
        self.assertEqual(motion.position[-1], 50)
        self.assertAlmostEqual(motion.velocity[-1], 0, delta=1e-14)
        np.testing.assert_allclose(np.diff(t), 0.1, atol=1e-12)
        with self.assertRaises(jounce.InputError):
            rise().sample(0)
        with self.assertRaises(jounce.InputError):
            rise().sample(1e-12)

    def test_derivatives_agree_with_differences(self) -> None:
        curve, h = rise(), 1e-5
        t = np.linspace(0.13, 5.5, 40)
        np.testing.assert_allclose(curve.at(t).velocity, (curve(t + h) - curve(t - h)) / (2 * h), atol=1e-6)
        np.testing.assert_allclose(curve.derivative()(t), curve.at(t).velocity, atol=1e-12)
        np.testing.assert_allclose(curve.derivative().integral()(t), curve(t), atol=1e-12)

    def test_sides(self) -> None:
        ramp = jounce.trapezoid(0, 50, velocity=10, acceleration=20).curve
        self.assertEqual(ramp.at(0.5, side="left").acceleration, 20)
        self.assertEqual(ramp.at(0.5).acceleration, 0)
        with self.assertRaises(jounce.InputError) as caught:
            ramp.at(0.5, side="middle")
        self.assertEqual(caught.exception.key, "side")

    def test_outside(self) -> None:
        curve = rise()
        self.assertEqual(curve(100), 50)
        self.assertEqual(curve.with_outside("advance")(curve.end + 1), 50 + curve(1))
        with self.assertRaises(jounce.InputError) as caught:
            curve.with_outside("refuse")([1, 2, 100])
        self.assertEqual(caught.exception.value, "100")

    def test_breaks_are_a_view(self) -> None:
        curve = rise()
        breaks = curve.breaks
        self.assertFalse(breaks.flags.owndata or breaks.flags.writeable)
        del curve
        gc.collect()
        self.assertEqual(breaks[0], 0)
        np.testing.assert_allclose(np.diff(breaks), [0.2, 0.3, 0.2, 4.3, 0.2, 0.3, 0.2], atol=1e-14)


class Algebra(unittest.TestCase):
    def test_each_operation(self) -> None:
        f = rise()
        t = np.linspace(0, f.end, 50)
        np.testing.assert_allclose(f.reversed()(t), f(f.end - t), atol=1e-12)
        np.testing.assert_allclose(f.scaled(2, 3)(3 * t), 2 * f(t), atol=1e-12)
        for product, wanted in ((2 * f, 2 * f(t)), (f * 2, 2 * f(t)), (-f, -f(t)), (3 * f - f, 2 * f(t))):
            np.testing.assert_allclose(product(t), wanted, atol=1e-12)
        np.testing.assert_allclose(f.shifted(1, 2)(t + 1), f(t) + 2, atol=1e-12)
        np.testing.assert_allclose((f + f.reversed())(t), f(t) + f(f.end - t), atol=1e-12)
        both = jounce.Trajectory.concatenated([f, f.reversed()])
        np.testing.assert_allclose(both(t + f.end), f(f.end - t), atol=1e-12)
        self.assertAlmostEqual(f.repeated(3).length, f.length * 3, delta=1e-12)
        np.testing.assert_allclose(f.between(1, 2)(np.linspace(1, 2, 9)), f(np.linspace(1, 2, 9)), atol=1e-12)

    def test_filters(self) -> None:
        hard = jounce.trapezoid(0, 9, velocity=100, acceleration=500).curve
        smooth = hard.moving_average(0.05)
        self.assertAlmostEqual(smooth.end, hard.end + 0.05, delta=1e-12)
        self.assertTrue(smooth.check_continuity(2))
        shaped = hard.shaped(5.5, damping=0.03)
        w, breaks = 2 * np.pi * 5.5, hard.breaks  # the load's deviation obeys y'' + w^2 y = -f''
        phasor = sum(a * (np.exp(1j * w * t1) - np.exp(1j * w * t0)) / (1j * w)
                     for a, t0, t1 in zip((500, -500), breaks, breaks[1:], strict=False))
        self.assertAlmostEqual(hard.residual_vibration(5.5), abs(phasor) / w, delta=1e-12)
        self.assertLess(shaped.residual_vibration(5.5, 0.03), 1e-12)

    def test_retiming_reaches_a_limit(self) -> None:
        fits = rise().retimed(jounce.Limits(velocity=5, acceleration=20, jerk=100))
        self.assertAlmostEqual(fits.extrema(1).peak.value, 5, delta=1e-12)


class Checks(unittest.TestCase):
    def test_extrema_bound_all_samples(self) -> None:
        cam = jounce.fourth_order(0, 1, velocity=2, acceleration=10, jerk=100, jounce=2000)
        speed = cam.extrema(1)
        t = np.linspace(0, cam.end, 200001)
        self.assertLessEqual(cam.at(t).velocity.max(), speed.max.value + 1e-12)
        self.assertAlmostEqual(cam.at(speed.max.where).velocity, speed.max.value, delta=1e-12)

    def test_crossings(self) -> None:
        places = rise().crossings(0, 25)
        self.assertEqual(len(places), 1)
        self.assertAlmostEqual(places[0], rise().end / 2, delta=1e-12)
        with self.assertRaises(jounce.InputError):
            rise().crossings(4, 0)

    def test_findings(self) -> None:
        report = rise().check(jounce.Limits(velocity=8, acceleration=30))
        self.assertEqual([str(report[0]), str(report[-1])], [str(report.findings[0]), str(report.findings[-1])])
        self.assertEqual(len(report[:1]), 1)
        with self.assertRaises(IndexError):
            report[len(report)]
        self.assertFalse(report)
        self.assertFalse(report.ok)
        worst = report.broken[0]
        self.assertEqual((worst.rule, worst.quantity, worst.value, worst.limit), ("limit/velocity", "velocity", 10, 8))
        self.assertAlmostEqual(worst.margin, -0.25, delta=1e-15)
        self.assertEqual(len(report), len(list(report)))
        self.assertIn("exceeds the limit 8 by 25 %", str(report))
        self.assertIn("exceeds", str(worst))
        meaning = jounce.explain(worst.rule)
        self.assertIsNotNone(meaning)
        self.assertIsNone(jounce.explain("no/rule/at/all"))

    def test_limits_are_valid(self) -> None:
        for bad in ({"velocity": 0}, {"jerk": -1}, {"position_min": 2, "position_max": 1}, {"jerk": float("nan")}):
            with self.assertRaises(jounce.InputError):
                jounce.Limits(**bad)

    def test_jumps_and_the_witness(self) -> None:
        hard = jounce.trapezoid(0, 50, velocity=10, acceleration=20).curve
        self.assertAlmostEqual(abs(hard.largest_jump(2).step), 20, delta=1e-12)
        self.assertFalse(hard.check_continuity(2))
        self.assertTrue(hard.check_continuity(1))
        report = rise().witness()
        self.assertTrue(report)
        self.assertLess(max(f.value for f in report), 1e-12)


if __name__ == "__main__":
    unittest.main()

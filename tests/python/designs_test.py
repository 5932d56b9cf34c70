# SPDX-License-Identifier: Apache-2.0
"""Cams, tables, specs, optimization, validation and conversion."""
import gc
import math
import pathlib
import pickle
import signal
import tempfile
import threading
import unittest

import jounce
import numpy as np

ROOT = pathlib.Path(__file__).parents[2]
CAM = ROOT / "examples/pmc600-cam/cam.toml"


def rise_and_return() -> jounce.Cam:
    return jounce.design_cam([jounce.CamSegment("inclined_sine", 120, 50, name="rise"),
                              jounce.CamSegment("dwell", 200, 50),
                              jounce.CamSegment("quintic", 360, 0)], periodic=True)


class Cams(unittest.TestCase):
    def test_a_cycloid_is_that_of_the_formula(self) -> None:
        cam, x = rise_and_return(), np.linspace(0, 120, 100)
        z = x / 120
        np.testing.assert_allclose(cam(x), 50 * (z - np.sin(2 * np.pi * z) / (2 * np.pi)), atol=1e-12)
        np.testing.assert_allclose(cam.at(x).geo_velocity, 50 / 120 * (1 - np.cos(2 * np.pi * z)), atol=1e-12)
        self.assertAlmostEqual(cam.extrema(1).max.value, 50 / 120 * 2, delta=1e-13)
        self.assertEqual(cam(360 + 60), cam(60))

    def test_characteristic_values(self) -> None:
        cycloid = jounce.characteristics("inclined_sine")
        self.assertAlmostEqual(cycloid.cv, 2, delta=1e-12)
        self.assertAlmostEqual(cycloid.ca, 2 * math.pi, delta=1e-12)
        self.assertAlmostEqual(cycloid.cj, 4 * math.pi**2, delta=1e-11)
        self.assertIn("modified_sine", jounce.laws())

    def test_points_and_knots(self) -> None:
        cam = jounce.design_cam([jounce.CamSegment("cubic_spline", 10, 0, points=[jounce.CamPoint(5, 3)])],
                                start=jounce.CamKnot(0, 0))
        self.assertAlmostEqual(cam(5), 3, delta=1e-12)
        self.assertEqual(repr(jounce.CamPoint(5, 3)), "CamPoint(master=5, slave=3)")
        self.assertEqual(repr(jounce.CamPoint(5)), "CamPoint(master=5, slave=None)")

    def test_errors(self) -> None:
        with self.assertRaises(jounce.InputError) as caught:
            jounce.CamSegment("modified_sin", 1, 2)
        self.assertIn("modified_sine", caught.exception.rule)
        with self.assertRaises(jounce.InputError) as caught:
            jounce.design_cam([jounce.CamSegment("quintic", 10, 1), jounce.CamSegment("quintic", 5, 0)])
        self.assertEqual(caught.exception.key, "segment[2].end.master")

    def test_a_periodic_cam_is_closed(self) -> None:
        open_cam = [jounce.CamSegment("345", 180, 50), jounce.CamSegment("345", 360, 10)]
        with self.assertRaises(jounce.InputError) as caught:
            jounce.design_cam(open_cam, periodic=True)
        self.assertEqual((caught.exception.key, caught.exception.value), ("segment[2].end.slave", "10"))
        self.assertIn("must be 0", caught.exception.rule)
        self.assertEqual(jounce.design_cam(open_cam, periodic=True, slave_period=10).advance, 10)
        self.assertEqual(jounce.design_cam(open_cam).outside, "hold")

    def test_gears(self) -> None:
        cam = jounce.gear([jounce.GearChange(0, 0.5, 100)], master_end=1000)
        self.assertEqual(cam(100), 25)  # a straight clutch moves the slave by d (r0 + r1) / 2
        self.assertEqual(cam.at(500).geo_velocity, 0.5)
        shifted = jounce.gear([jounce.GearChange(0, 1)], master_end=360, ratio=1, shifts=[jounce.GearShift(90, 5, 90)])
        self.assertAlmostEqual(shifted(360), 365, delta=1e-12)
        with self.assertRaises(jounce.InputError) as caught:
            jounce.gear([jounce.GearChange(0, 1, 100), jounce.GearChange(50, 2)], master_end=1000)
        self.assertEqual(caught.exception.key, "change[2].at")
        # PMC600 manual, example 6.2: the master at 8000, the slave at 2000, over 4000, by 1 : 2.
        engaged = jounce.gear_in_pos(1, 2, master_sync=8000, slave_sync=2000, start_distance=4000, master_start=0,
                                     master_end=10000)
        self.assertEqual((engaged(4000), engaged(8000)), (0, 2000))
        self.assertAlmostEqual(engaged(9000), 2500, delta=1e-9)
        with self.assertRaises(jounce.InputError) as caught:
            jounce.gear_in_pos(1, 1, master_sync=8000, slave_sync=-2000, start_distance=4000, master_start=0,
                               master_end=10000, avoid_reversal=True)
        self.assertEqual(caught.exception.key, "start_distance")

    def test_a_slave_behind_its_master(self) -> None:
        cam = rise_and_return()
        master = jounce.trapezoid(0, 360, velocity=400, acceleration=2000).curve
        slave, t = cam.over_time(master), np.linspace(0, master.end, 60)
        np.testing.assert_allclose(slave(t), cam(np.minimum(master(t), 360 - 1e-12)), atol=1e-8)


class Tables(unittest.TestCase):
    def test_columns_are_views(self) -> None:
        table = rise_and_return().table(tolerance=1e-3, x_unit="deg", position_unit="mm")
        assert table.velocity is not None
        for column in (table.x, table.position, table.velocity, table.acceleration):
            self.assertFalse(column.flags.owndata or column.flags.writeable)
        self.assertEqual(table.x.ctypes.data, table.x.ctypes.data)  # twice the same memory: no copy
        x, expected = table.x, table.x.copy()
        del table
        gc.collect()
        np.testing.assert_array_equal(x, expected)

    def test_the_error_bounds_the_difference(self) -> None:
        cam = rise_and_return()
        table = cam.table("cubic_hermite", tolerance=1e-3)
        x = np.linspace(0, 360, 20001)
        difference = np.abs(table(x) - cam(x)).max()
        self.assertLessEqual(difference, table.error.position * (1 + 1e-9))
        self.assertGreater(difference, table.error.position * 0.99)
        self.assertLessEqual(table.error.position, 1e-3)
        fewest = cam.reduced_table("cubic_hermite", tolerance=1e-3)
        self.assertLess(len(fewest), len(table))
        np.testing.assert_array_equal(cam.table(intervals=4).x, [0, 90, 180, 270, 360])
        with self.assertRaises(jounce.InputError):
            cam.table(tolerance=1, intervals=3)

    def test_a_table_from_columns(self) -> None:
        t = np.linspace(0, 1, 11)
        table = jounce.Table(t, t**2, 2 * t, x_unit="s", position_unit="mm")
        self.assertEqual((table.rule, table.domain, table.outside, len(table)), ("cubic_hermite", "time", "hold", 11))
        np.testing.assert_allclose(table.at(np.linspace(0, 1, 33)).acceleration[:-1], 2, atol=1e-9)
        self.assertIsNone(table.acceleration)
        again = jounce.parse_table(table.text("json"))
        self.assertEqual((again.hash, again.position_unit), (table.hash, "mm"))
        np.testing.assert_array_equal(again.position, table.position)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "t.csv"
            table.write(path)
            self.assertEqual(jounce.read_table(path).hash, table.hash)
            self.assertEqual(jounce.load(path).kind, "table")
            with self.assertRaises(OSError):
                table.write(pathlib.Path(folder) / "no" / "t.csv")
            with self.assertRaises(jounce.InputError):
                jounce.Table(t, t).write(path)
        with self.assertRaises(jounce.InputError):
            jounce.Table([0, 1, 1], [0, 1, 2])
        with self.assertRaises(jounce.InputError):
            jounce.Table([[0, 1]], [[0, 1]])


class Designs(unittest.TestCase):
    def test_the_numbers_of_the_manual(self) -> None:
        design = jounce.load(CAM)
        self.assertEqual((design.kind, design.x_unit, design.position_unit), ("cam", "pulse", "pulse"))
        self.assertAlmostEqual(design.curve.extrema(1).peak.value, -3.392270802, delta=1e-9)
        self.assertAlmostEqual(design.curve.extrema(2).peak.value, -0.1619234501, delta=1e-10)
        report = design.check()
        self.assertFalse(report)
        self.assertEqual([f.rule for f in report.broken], ["limit/geo_velocity", "limit/geo_acceleration"])
        self.assertEqual(report.broken[0].segment_name, "3 return")
        self.assertEqual(report.broken[0].unit, "pulse/pulse")
        self.assertTrue(design.check(limits=jounce.Limits(velocity=4, acceleration=0.2)))
        self.assertEqual([str(f) for f in design.findings], [str(f) for f in report])
        self.assertEqual(len(design.table), 5)
        figures = {f.name: f.value for f in design.figures(["stroke", "duration"])}
        self.assertAlmostEqual(figures["stroke"], 232.361666, delta=1e-6)
        self.assertAlmostEqual(design.over_time().curve.extrema(1).peak.value, -3.392270802 * 200, delta=1e-6)

    def test_errors_have_their_place(self) -> None:
        text = CAM.read_text().replace("master = 200, slave", "master = 60, slave")
        with self.assertRaises(jounce.InputError) as caught:
            jounce.parse(text, "wrong.toml")
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column), ("wrong.toml", 21, 18))
        self.assertEqual((error.key, error.value), ("segment[2].end.master", "60 pulse"))
        with self.assertRaises(jounce.InputError) as caught:
            jounce.parse(CAM.read_text().replace("law = ", "lew = "), "many.toml")
        self.assertGreater(len(caught.exception.errors), 1)
        self.assertIs(caught.exception.errors[0], caught.exception)
        pickled = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual([str(e) for e in pickled.errors], [str(e) for e in caught.exception.errors])
        self.assertIs(pickled.errors[0], pickled)
        with self.assertRaises(jounce.InputError):
            jounce.load("no such file.toml")

    def test_errors_name_the_arguments_of_python(self) -> None:
        with self.assertRaises(jounce.InputError) as caught:
            jounce.load(ROOT / "examples/gcode-part/plate.ngc")
        self.assertIn("with machine to check,", caught.exception.rule)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "comma.txt"
            file.write_text("0;0,5\n1;1,5\n2;2,5\n")
            with self.assertRaises(jounce.InputError) as caught:
                jounce.load(file)
            self.assertIn("load(..., decimal_comma=True)", caught.exception.rule)
            self.assertNotIn("--", str(caught.exception))

    def test_files_of_several_axes(self) -> None:
        path = ROOT / "examples/gcode-part/plate.toml"
        axes = jounce.load_axes(path)
        self.assertGreater(len(axes), 1)
        self.assertEqual(jounce.load(path, axis=axes[0].axis).axis, axes[0].axis)
        with self.assertRaises(jounce.InputError):
            jounce.load(path)


class Paths(unittest.TestCase):
    SPEC = ROOT / "examples/himc-path/arc-corners.toml"

    def test_arrays_have_a_column_for_each_axis(self) -> None:
        path = jounce.plan_path(self.SPEC)
        axes = jounce.load_axes(self.SPEC)
        self.assertEqual(path.axes, [axis.axis for axis in axes])
        self.assertEqual(len(path), len(axes))
        self.assertEqual(path.duration, axes[0].curve.end)
        t, motion = path.sample(0.01)
        self.assertEqual(motion.velocity.shape, (len(t), len(path)))
        for k, axis in enumerate(axes):
            np.testing.assert_array_equal(motion.position[:-1, k], axis.curve(t[:-1]))
        np.testing.assert_array_equal(path.at(t).acceleration, motion.acceleration)
        self.assertEqual(path.at(0.5).position.shape, (len(path),))
        self.assertTrue(np.isnan(path.at(np.nan).position).all())
        self.assertEqual(path.ok, all(path.reports))
        self.assertAlmostEqual(path.data["path"]["duration"], path.duration, delta=1e-9)

    def test_programs_and_errors(self) -> None:
        folder = ROOT / "examples/gcode-part"
        path = jounce.plan_path(folder / "plate.ngc", machine=folder / "machine.toml")
        self.assertGreater(path.duration, 0)
        with self.assertRaises(jounce.InputError) as caught:
            jounce.plan_path(CAM)
        self.assertIn("kind \"path\"", caught.exception.rule)
        same = jounce.parse_path(self.SPEC.read_text())
        self.assertEqual(same.duration, jounce.plan_path(self.SPEC).duration)


class Values(unittest.TestCase):
    def test_equal_members_make_equal_values(self) -> None:
        point = jounce.CamPoint(5, 3, tolerance=0.1)
        pairs = [(jounce.Limits(velocity=2, position_min=-1), jounce.Limits(velocity=3, position_min=-1)),
                 (jounce.CamKnot(1, 2, geo_velocity=3), jounce.CamKnot(1, 2)),
                 (point, jounce.CamPoint(5, 3)),
                 (jounce.CamSegment("cubic_spline", 10, 0, name="a", points=[point]), jounce.CamSegment("345", 10, 0)),
                 (jounce.CamSegment("scca", 10, 0, shares=(0.25, 0.5, 0.25)), jounce.CamSegment("345", 10, 0)),
                 (jounce.Command.move_absolute(5, velocity=1, acceleration=2), jounce.Command.dwell(5)),
                 (jounce.GearChange(0, 0.5, 100), jounce.GearChange(0, 0.5, 90)),
                 (jounce.GearShift(0, 5, 90), jounce.GearShift(0, 5, 80)),
                 (rise_and_return(), rise_and_return().shifted(1)),
                 (jounce.s_curve(0, 5, velocity=1, acceleration=2, jerk=9).curve,
                  jounce.s_curve(0, 6, velocity=1, acceleration=2, jerk=9).curve),
                 (rise_and_return().table(tolerance=0.01), rise_and_return().table(tolerance=0.1))]
        for value, other in pairs:
            with self.subTest(type(value).__name__):
                copied = pickle.loads(pickle.dumps(value))
                self.assertEqual(copied, value)
                self.assertEqual(hash(copied), hash(value))
                self.assertEqual(repr(copied), repr(value))
                self.assertNotEqual(value, other)
                self.assertNotEqual(value, 5)

    def test_bounds_have_arrays(self) -> None:
        bounds = jounce.Bounds([2, 3], 10, 100, position_max=5)
        self.assertEqual(pickle.loads(pickle.dumps(bounds)), bounds)
        self.assertNotEqual(jounce.Bounds([2, 4], 10, 100, position_max=5), bounds)
        self.assertNotEqual(jounce.Bounds(2, 10, 100, position_max=5), bounds)
        self.assertEqual(hash(jounce.Bounds(2, 10)), hash(jounce.Bounds(2, 10)))
        self.assertNotEqual(hash(jounce.Bounds(2, 10)), hash(jounce.Bounds(3, 10)))
        with self.assertRaises(TypeError):
            hash(bounds)

    def test_results_pass_to_another_process(self) -> None:
        cam = rise_and_return()
        report = cam.check(jounce.Limits(velocity=0.01, acceleration=5))
        copied = pickle.loads(pickle.dumps(report))
        self.assertEqual((str(copied), repr(copied), len(copied)), (str(report), repr(report), len(report)))
        self.assertFalse(copied)
        self.assertEqual([repr(f) for f in pickle.loads(pickle.dumps(report.findings))], [repr(f) for f in report.findings])
        move = jounce.move_to(1, 40, jounce.Bounds(200, 2000, 50000))
        other = pickle.loads(pickle.dumps(move))
        self.assertEqual((other.duration, other.start, other.end, other.phases),
                         (move.duration, move.start, move.end, move.phases))
        self.assertEqual(other.at(0.1), move.at(0.1))
        text = """jounce = 1
kind = "move"
units = { position = "mm" }
move = { profile = "trapezoid", to = 300, velocity = 200, acceleration = 1000 }
"""
        design = jounce.parse(text, "made.toml")
        same = pickle.loads(pickle.dumps(design))
        self.assertEqual((same.text, same.path, same.curve), (design.text, design.path, design.curve))
        with self.assertRaisesRegex(TypeError, "load .* in the other process"):
            pickle.dumps(jounce.parse(design.table.text(), "made.csv"))

    def test_a_table_keeps_its_error(self) -> None:
        table = rise_and_return().table(tolerance=0.01)
        assert table.error is not None
        copied = pickle.loads(pickle.dumps(table))
        self.assertEqual((copied.error.position, copied.error.where), (table.error.position, table.error.where))
        self.assertEqual(copied.hash, table.hash)


class LongWork(unittest.TestCase):
    def test_optimize(self) -> None:
        seen: list[tuple[float, str]] = []
        best = jounce.optimize(CAM, progress=lambda done, step: seen.append((done, step)))
        self.assertTrue(best.ok)
        copied = pickle.loads(pickle.dumps(best))
        self.assertEqual((str(copied), copied.data, copied.spec, copied.ok), (str(best), best.data, best.spec, True))
        self.assertTrue(best.design.check())
        self.assertAlmostEqual(abs(best.design.curve.extrema(2).peak.value), best.data["objectives"][0]["reached"], delta=1e-9)
        self.assertLess(best.data["objectives"][0]["reached"], 0.0709)
        self.assertTrue(seen and all(0 <= done <= 1 for done, _ in seen))
        self.assertEqual(seen[0][1], "peak geo_acceleration")
        with tempfile.TemporaryDirectory() as folder:
            best.write(pathlib.Path(folder) / "better.toml")
            self.assertEqual((pathlib.Path(folder) / "better.toml").read_text(), best.spec)

    def test_the_callback_stops_the_work(self) -> None:
        self.assertEqual(jounce.optimize(CAM, progress=lambda done, step: False).status, "cancelled")

        def fail(done: float, step: str) -> None:
            raise LookupError(step)

        with self.assertRaises(LookupError):
            jounce.optimize(CAM, progress=fail)
        with self.assertRaises(jounce.InputError):
            jounce.optimize(CAM, seconds=0)

    def test_interrupt(self) -> None:
        def press(done: float, step: str) -> None:
            signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            jounce.optimize(CAM, progress=press)

    def test_interrupt_of_a_validation(self) -> None:
        steps: list[str] = []

        def press(done: float, step: str) -> None:
            steps.append(step)
            signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            jounce.validate(CAM, progress=press)
        self.assertEqual(steps, ["integration"])
        with self.assertRaises(jounce.InputError) as caught:
            jounce.validate(CAM, progress=lambda done, step: False)
        self.assertEqual(caught.exception.key, "progress")

    def test_other_threads_run_meanwhile(self) -> None:
        counted, done = [0], threading.Event()

        def count() -> None:
            while not done.is_set():
                counted[0] += 1

        thread = threading.Thread(target=count)
        thread.start()
        before = counted[0]
        jounce.optimize(CAM)
        after = counted[0]
        done.set()
        thread.join()
        self.assertGreater(after - before, 1000)

    def test_validate(self) -> None:
        proof = jounce.validate(CAM, samples=101)
        self.assertTrue(proof.ok)
        self.assertIn("proven", str(proof))
        self.assertLess(proof.data["witness"]["curve"]["position"], 1e-11)
        self.assertEqual(proof.signals["torque"].shape, (101,))
        self.assertLess(np.abs(proof.signals["reference"] - proof.signals["motor"] - proof.signals["following_error"]).max(), 1e-9)
        self.assertEqual(jounce.validate(rise_and_return().table()).signals, {})

    def test_convert(self) -> None:
        result = jounce.convert(CAM, to="codesys")
        self.assertIn("CODESYS", result.text)
        self.assertIn("laws and limits stay in the spec", result.losses)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "cam.st"
            jounce.convert(CAM, path)
            np.testing.assert_array_equal(jounce.load(path).table.position, jounce.load(CAM).table.position)
            with self.assertRaises(jounce.InputError):
                jounce.convert(CAM, pathlib.Path(folder) / "cam.unknown")
        fewer = jounce.convert(CAM, to="csv", rule="cubic_hermite", tolerance="0.01 pulse")
        self.assertLessEqual(fewer.table.error.position, 0.01)
        same = jounce.convert(CAM, to="csv", rule="cubic_hermite", tolerance=0.01)
        self.assertEqual(same.table.hash, fewer.table.hash)
        for bad in ({"to": "xyz"}, {"rule": "cubic"}, {"tolerance": -1}):
            with self.assertRaises(jounce.InputError):
                jounce.convert(CAM, **bad)
        self.assertIn("codesys", dict(jounce.formats()))
        with self.assertRaisesRegex(jounce.InputError, "allow_loss"):
            jounce.convert(CAM, to="pairs", intervals=2)
        self.assertEqual(jounce.convert(CAM, to="pairs", intervals=2, allow_loss=True).table.position.size, 3)
        coarse, fine = (jounce.convert(CAM, to="trio", p_step=f"{size} pulse") for size in (10, 1))
        self.assertLess(fine.table.error.position, coarse.table.error.position)


class Memory(unittest.TestCase):
    def test_repeated_calls_leave_no_memory(self) -> None:
        def resident() -> int:
            return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * 4096

        axis, cam = jounce.Bounds(2, 10, 100), rise_and_return()
        table = cam.table(intervals=1000)

        def work(times: int) -> None:
            for i in range(times):
                move = jounce.move_to(0, 1 + i % 7, axis)
                move.at([0.1, 0.2])
                move.curve.breaks
                table.position
                cam.extrema(1).peak.value
                try:
                    jounce.move_to(0, jounce.State(1, 5), axis)
                except jounce.MoveError:
                    pass
            gc.collect()

        work(2000)
        before = resident()
        work(20000)
        self.assertLess(resident() - before, 2_000_000)  # a leak of 100 bytes a call would be 2 MB


if __name__ == "__main__":
    unittest.main()

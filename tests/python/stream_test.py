# SPDX-License-Identifier: Apache-2.0
"""A client of an executor, which runs in a process of its own behind sockets in a folder."""
import os
import pathlib
import pickle
import signal
import subprocess
import tempfile
import threading
import time
import unittest

import jounce
import numpy as np

AXIS = """jounce = 1
kind = "axis"
name = "feeder"
units = { position = "mm" }
axis = { cycle = "1 ms" }
limits = { velocity = "500 mm/s", acceleration = "5000 mm/s^2", jerk = "100000 mm/s^3" }
"""


class Stream(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        (pathlib.Path(self.folder.name) / "axis.toml").write_text(AXIS)
        self.url = "unix://" + self.folder.name
        self.executor = subprocess.Popen([os.environ["JOUNCE"], "run", "axis.toml", "--url", self.url, "--seconds", "60"],
                                         cwd=self.folder.name, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(self.end)
        with jounce.Client("feeder", url=self.url, patience=10) as axis:
            self.assertEqual(axis.status(timeout=10).state, "disabled")

    def end(self) -> None:
        self.executor.terminate()
        self.executor.communicate(timeout=20)

    def test_commands_and_tables(self) -> None:
        with jounce.Client("feeder", url=self.url, patience=10) as axis:
            with self.assertRaises(jounce.AxisError) as caught:
                axis.move_absolute(10)
            self.assertEqual((caught.exception.error, caught.exception.refusal), ("refused", "not_enabled"))
            self.assertGreater(caught.exception.cause, 0)
            axis.enable()
            axis.override(0.5)
            axis.override(1)
            axis.move_absolute(10, velocity=200)
            self.assertEqual(axis.wait_for_rest(20), "standstill")
            self.assertAlmostEqual(axis.status().position, 10, delta=1e-9)
            self.assertEqual(axis.status().unit, "mm")

            t, motion = jounce.move_to(10, 40, jounce.Bounds(200, 2000, 50000)).sample(0.01)
            table = jounce.Table(t, motion.position, motion.velocity, x_unit="s", position_unit="mm")
            stages: list[str] = []
            axis.stream(table, progress=lambda done, stage: stages.append(stage))
            self.assertEqual(axis.wait_for_rest(20), "standstill")
            self.assertAlmostEqual(axis.status().position, 40, delta=1e-9)
            self.assertEqual(axis.status().finished, 2)
            self.assertTrue(stages)
            back = jounce.Table(t, 50 - motion.position, -motion.velocity, x_unit="s", position_unit="mm")
            with self.assertRaises(jounce.InputError) as ended:
                axis.stream(back, progress=lambda done, stage: False)
            self.assertEqual(ended.exception.key, "progress")
            self.assertEqual(axis.wait_for_rest(20), "standstill")
            self.assertAlmostEqual(axis.status().position, 40, delta=1e-9)
            with self.assertRaises(jounce.AxisError) as caught:  # a table that begins elsewhere would be a step
                axis.stream(table)
            self.assertEqual(caught.exception.refusal, "start_position")
            self.assertNotIn("jounce order", str(caught.exception))
            self.assertIn("start_position: ", str(caught.exception))
            with self.assertRaises(jounce.InputError) as wrong:
                axis.stream(jounce.move_to(40, 50, jounce.Bounds(200, 2000, 50000)).curve.table())
            self.assertIn("the table has no unit", str(wrong.exception))
            with self.assertRaises(jounce.InputError):
                axis.move_absolute(float("nan"))
            self.assertTrue(np.isfinite(axis.status().position))

    def stop_as_operator(self) -> None:
        subprocess.run([os.environ["JOUNCE"], "stop", "feeder", "--url", self.url], check=True, stdout=subprocess.DEVNULL)

    def test_an_operators_stop_is_raised_once(self) -> None:
        with jounce.Client("feeder", url=self.url, patience=10) as axis:
            axis.enable()
            axis.move_velocity(20)
            self.stop_as_operator()
            with self.assertRaises(jounce.AxisError) as caught:
                axis.move_absolute(100)
            self.assertEqual((caught.exception.error, caught.exception.cause), ("stopped", 80))
            self.assertEqual(axis.status().state, "standstill")
            axis.move_velocity(20)  # the program continues
            self.stop_as_operator()
            with self.assertRaises(jounce.AxisError) as caught:
                axis.wait_for_rest(20)
            self.assertIn("another operator stopped the axis; the axis rests at ", str(caught.exception))
            self.assertEqual(axis.wait_for_rest(20), "standstill")  # reported already
            self.assertEqual((axis.status().reason, axis.status().stopped), (80, 2))
            axis.move_relative(5)
            self.assertEqual(axis.wait_for_rest(20), "standstill")

    def test_missing_heartbeats_are_raised(self) -> None:
        with jounce.Client("feeder", url=self.url, patience=10) as axis:
            axis.enable()
            axis.move_velocity(20)
            while axis.status().state != "standstill":  # a status is not a heartbeat
                pass
            with self.assertRaises(jounce.AxisError) as caught:
                axis.wait_for_rest(20)
            self.assertEqual(caught.exception.error, "stopped")
            self.assertIn("no heartbeat of this program arrived in time", str(caught.exception))

    def test_ctrl_c_stops_the_axis(self) -> None:
        with jounce.Client("feeder", url=self.url, patience=10) as axis:
            axis.enable()
            axis.move_velocity(20)
            timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                axis.wait_for_rest(20)
            timer.join()
            self.assertEqual(axis.status().state, "standstill")
            self.assertEqual(axis.wait_for_rest(20), "standstill")  # its own stop

    def test_an_exception_leaves_no_axis_in_motion(self) -> None:
        with self.assertRaises(ZeroDivisionError):
            with jounce.Client("feeder", url=self.url, patience=10) as axis:
                axis.enable()
                axis.move_velocity(20)
                raise ZeroDivisionError
        with jounce.Client("feeder", url=self.url, patience=10) as other:
            while other.status().state != "standstill":
                time.sleep(0.05)
            self.assertEqual(other.status().reason, 80)

    def test_a_wait_ends_without_an_executor(self) -> None:
        with jounce.Client("feeder", url=self.url, patience=3) as axis:
            axis.enable()
            axis.move_velocity(20)
            self.executor.kill()
            with self.assertRaises(jounce.AxisError) as caught:
                axis.wait_for_rest(500)
            self.assertEqual(caught.exception.error, "contact_lost")

    def test_a_wait_ends_at_its_timeout(self) -> None:
        # The patience of the client is longer than the time limit of this test.
        axis = jounce.Client("absent", url=self.url, patience=500)
        with self.assertRaises(TimeoutError) as caught:
            axis.wait_for_rest(0.2)
        self.assertIsInstance(caught.exception, jounce.AxisTimeout)
        self.assertEqual(caught.exception.error, "out_of_time")
        copied = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual((type(copied), str(copied), copied.error), (jounce.AxisTimeout, str(caught.exception), "out_of_time"))

    def test_no_answer(self) -> None:
        with self.assertRaises(TimeoutError) as caught:
            jounce.Client("absent", url=self.url, patience=0.3).enable()
        self.assertEqual(caught.exception.error, "no_answer")
        with self.assertRaises(jounce.InputError):
            jounce.Client("no name", url=self.url)
        with self.assertRaises(jounce.InputError):
            jounce.Client("feeder", url="http://example")


if __name__ == "__main__":
    unittest.main()

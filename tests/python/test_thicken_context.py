# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long runs: other Python threads go on, progress is seen, and the run can be ended."""

import os
import signal
import threading
import time
import unittest

from thicken import RunContext, ThickenError, thicken_mesh
from thicken_surfaces import grid

import numpy as np


def long_run():
    """Takes seconds: many triangles, and folds that draw the shell back again and again."""
    return grid(lambda x, y: np.sin(3 * x) * np.cos(2 * y), size=20, n=250)


class LongRun(unittest.TestCase):
    def run_beside(self, context, **arguments):
        """Start thicken_mesh() on another thread; return that thread and where its outcome will be."""
        outcome = {}

        def work():
            try:
                outcome["result"] = thicken_mesh(*long_run(), 0.2, context=context, **arguments)
            except ThickenError as error:
                outcome["error"] = error

        thread = threading.Thread(target=work)
        thread.start()
        self.addCleanup(thread.join)
        self.addCleanup(context.cancel)
        return thread, outcome

    def test_a_time_limit_ends_a_run(self):
        context = RunContext()
        context.set_time_limit(0.05)
        with self.assertRaises(ThickenError) as caught:
            thicken_mesh(*long_run(), 0.2, context=context)
        self.assertEqual(caught.exception.code, "time-limit")
        self.assertGreater(caught.exception.time["enough_seconds"], 0.05)

    def test_other_threads_run_and_see_progress(self):
        context = RunContext()
        self.assertEqual((context.progress, context.stage, context.cancelled), (0, "waiting", False))
        thread, outcome = self.run_beside(context)
        seen, stages = [], set()
        while thread.is_alive():
            time.sleep(0.002)
            if context.stage != "waiting":  # before that, the arrays are copied
                seen.append(context.progress)
                stages.add(context.stage)
        self.assertIn("result", outcome)
        self.assertGreater(len(seen), 20, "this thread stood still")
        self.assertEqual(seen, sorted(seen), "progress went back")
        self.assertGreater(len(set(seen)), 3)
        self.assertLessEqual({"checking", "sweeping", "auditing"}, stages)
        self.assertEqual((context.progress, context.stage), (1, "done"))

    def test_every_stage_of_a_contour_is_entered(self):
        context, stages = RunContext(), set()
        surface = grid(lambda x, y: np.sin(x) * np.cos(y), size=20, n=100)
        thread = threading.Thread(target=lambda: thicken_mesh(*surface, 0.5, method="reconstruct", context=context))
        thread.start()
        while thread.is_alive():
            stages.add(context.stage)
            time.sleep(0.001)
        self.assertLessEqual({"checking", "field", "contouring", "joining", "shaping", "auditing", "measuring"}, stages)

    def test_cancel_from_another_thread(self):
        context = RunContext()
        thread, outcome = self.run_beside(context)
        while context.stage in ("waiting", "checking") and thread.is_alive():
            time.sleep(0.005)
        begin = time.process_time()
        context.cancel()
        thread.join()
        # Of the processors' time, which other programs do not lengthen.
        self.assertLess(time.process_time() - begin, 1.0 * (os.cpu_count() or 1))
        self.assertTrue(context.cancelled)
        self.assertEqual(outcome["error"].code, "cancelled")

    def test_cancelled_before_it_began(self):
        context = RunContext()
        context.cancel()
        with self.assertRaises(ThickenError) as caught:
            thicken_mesh(*long_run(), 0.2, context=context)
        self.assertEqual(caught.exception.code, "cancelled")

    def test_interrupt_ends_the_run(self):
        """Ctrl-C while the main thread waits in the library."""
        context = RunContext()

        def interrupt():
            while context.stage in ("waiting", "checking"):
                time.sleep(0.005)
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt)
        thread.start()
        self.addCleanup(thread.join)
        with self.assertRaises(KeyboardInterrupt):
            thicken_mesh(*long_run(), 0.2, context=context)
        self.assertTrue(context.cancelled)


if __name__ == "__main__":
    unittest.main()

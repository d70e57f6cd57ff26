"""What the Python module promises: long work can be followed and stopped.

usage: python_work_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import os
import signal
import threading
import time
import unittest

import numpy

from python_module import batten, main


class Work(unittest.TestCase):
    # Long enough to be stopped on its way.
    wave = numpy.stack([numpy.arange(5000.0), numpy.sin(numpy.arange(5000.0))], axis=1)

    def long_work(self, **more):
        return batten.interpolate(self.wave, exact=True, **more)

    def test_progress_is_told_and_may_stop_the_work(self):
        shares = []
        batten.interpolate(self.wave, progress=shares.append)
        self.assertEqual(sorted(shares), shares)
        self.assertEqual(shares[-1], 1)
        with self.assertRaises(batten.Cancelled):
            self.long_work(progress=lambda share: False)
        with self.assertRaises(ZeroDivisionError):
            self.long_work(progress=lambda share: 1 / 0)

    def test_an_interrupt_stops_the_work(self):
        timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            while True:
                self.long_work()

    def test_other_threads_run_meanwhile(self):
        ticks = []
        stop = threading.Event()

        def tick():
            while not stop.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        before = len(ticks)
        batten.interpolate(self.wave)
        stop.set()
        thread.join()
        self.assertGreater(len(ticks) - before, 3)


if __name__ == "__main__":
    main()

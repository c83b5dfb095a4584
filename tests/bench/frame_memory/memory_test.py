#!/usr/bin/env python3
"""memory_test.py RSH_BENCH - whether rsh-bench memory notices a kernel that is broken for small budgets alone,
and a layer that is missing. Kernels are changed in a copy. No device is a failure."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

BENCH = sys.argv[1]
ROOT = pathlib.Path(__file__).resolve().parents[3]
# Of pairs that a level cannot hold, each one's first child alone is followed.
KERNEL, RIGHT, BROKEN = ("traverse/paper_faithful/traverse_walk.cl", "if (survives[4 * i + k])",
                         "if (survives[4 * i + k] && k == 0)")


class Memory(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_bench(self, calls, **environment):
        """The exit status, all that was printed, and the cases by budget."""
        file = self.folder / "out.json"
        done = subprocess.run([BENCH, "memory", "--quick", "--filter", calls, "--json", file],
                              env={**os.environ, **environment}, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        cases = json.loads(file.read_text())["cases"]
        return done.returncode, done.stdout, {case["params"].get("budget"): case for case in cases}

    def test_every_budget_is_counted_and_timed(self):
        status, text, cases = self.run_bench("call:frame/.*engine:tiles")
        self.assertEqual(status, 0, text)
        self.assertEqual(list(cases), ["below", "none", "least", "whole"])
        below, none, least, whole = (case["metrics"] for case in cases.values())
        self.assertEqual(below["budget"] + 1, least["budget"])
        self.assertIn(f"budget: is {below['budget']}, must be 0 or at least {least['budget']}", below["refusal"])
        self.assertEqual(whole["budget"], none["bytes_allowed"])
        for metrics in (none, least, whole):
            self.assertGreater(metrics["ms"], 0)
            self.assertGreater(metrics["bytes_peak"], metrics["bytes_allowed"] // 2)
            self.assertLessEqual(metrics["bytes_peak"], metrics["bytes_allowed"])
        self.assertGreater(least["parts"], none["parts"])

    def test_what_only_small_budgets_spoil_is_noticed(self):
        for folder in ("kernels", "include"):
            shutil.copytree(ROOT / folder, self.folder / folder)
        path = self.folder / "kernels" / KERNEL
        source = path.read_text()
        self.assertIn(RIGHT, source, "the list of changes must follow the kernels")
        path.write_text(source.replace(RIGHT, BROKEN))
        status, text, cases = self.run_bench("call:trace/.*engine:paper_faithful",
                                             RSH_KERNEL_DIR=str(self.folder / "kernels"))
        self.assertEqual(status, 1, text)
        self.assertFalse(cases["least"]["ok"])
        self.assertGreater(cases["least"]["metrics"]["mismatches"], 0)
        self.assertNotIn("ms", cases["least"]["metrics"])
        self.assertTrue(cases["none"]["ok"])
        self.assertTrue(cases["below"]["ok"])

    def test_without_the_layer_nothing_is_measured(self):
        status, text, cases = self.run_bench("call:frame/.*engine:tiles", OPENCL_LAYERS="")
        self.assertEqual(status, 1, text)
        self.assertIn('bytes of the device cannot be counted: OPENCL_LAYERS is ""', text)
        self.assertEqual([case["ok"] for case in cases.values()], [False])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

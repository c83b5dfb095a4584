#!/usr/bin/env python3
"""report_test.py - whether report.py makes tables of every suite, and finds each fault of pages and results.
Needs no device and draws nothing."""
import contextlib
import copy
import io
import json
import pathlib
import shutil
import sys
import tempfile
import unittest

BENCH = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(BENCH))
import report
from reporting.metrics import COSTS
from reporting.results import by_suite
from reporting.suites import SUITES

ROOT = BENCH.parents[1]
STORED = {path.stem: path for path in sorted((ROOT / "docs/results").glob("*.json"))}
DEVICE = {"name": "Chip", "platform": "Loom", "driver": "9.1", "compute_units": 7,
          "host_instruction_set": "avx2"}


def document_of(suite, *cases):
    return {"suite": suite, "format_version": 1, "rsh": {"version": "0.1.0", "commit": "abc"}, "device": DEVICE,
            "command": f"build/rsh-bench {suite} --quick", "quick": True, "cases": list(cases)}


def case(name, params, metrics, ok=True):
    return {"name": name, "params": params, "metrics": metrics, "ok": ok}


def run(*arguments):
    """Exit status, and what was printed on both streams."""
    text = io.StringIO()
    with contextlib.redirect_stdout(text), contextlib.redirect_stderr(text):
        try:
            status = report.main([str(argument) for argument in arguments]) or 0
        except SystemExit as error:
            if isinstance(error.code, str):
                print(error.code)
            status = error.code if isinstance(error.code, int) else 1
    return status, text.getvalue()


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def store(self, name, document):
        path = self.folder / name
        path.write_text(document if isinstance(document, str) else json.dumps(document))
        return path

    def fails(self, words, *arguments):
        status, text = run(*arguments)
        self.assertEqual(status, 1, text)
        self.assertIn(words, text)
        return text

    def passes(self, *arguments):
        status, text = run(*arguments)
        self.assertEqual(status, 0, text)
        return text


class Tables(InFolder):
    def test_every_stored_file_has_one(self):
        self.assertLessEqual({"ablation", "accuracy", "hits", "mirrors"}, STORED.keys())
        for suite, path in STORED.items():
            text = self.passes(path)
            self.assertIn(json.loads(path.read_text())["rsh"]["commit"], text, suite)

    def test_every_suite_is_known(self):
        names = {path.stem.removesuffix("_suite") for path in BENCH.glob("*/*_suite.cpp")}
        self.assertEqual(names, set(SUITES))
        self.assertEqual(names, set(COSTS))

    def test_a_suite_without_a_table_of_its_own_has_its_metrics(self):
        file = self.store("q.json", document_of("queries", case("queries/a", {}, {"ms_any": 2.5, "wrong": 0})))
        self.assertIn("| case | ms any | wrong |\n|---|---|---|\n| a | 2.5 | 0 |\n", self.passes(file))

    def test_of_approximate_frames_those_worth_it_are_bold(self):
        def approximate(scene, ratio, flip, above):
            params = {"scene": scene, "width": 960, "tolerance": 0.01}
            metrics = {"ratio": ratio, "ratio_cpu": 1.7, "flip": flip, "flip_above": above, "traced": 0.25}
            return case(f"approximate/{scene}", params, metrics)
        text = self.passes(self.store("a.json", document_of(
            "approximate", approximate("good", 1.5, 0.0199, 0.001), approximate("slow", 1.49, 0, 0),
            approximate("seen", 2, 0.02, 0), approximate("spotty", 2, 0, 0.0011))))
        self.assertIn("| good | **1.50 (1.70) · 0.0199 · 0.100** |\n"
                      "| slow | 1.49 (1.70) · 0.0000 · 0.000 |\n"
                      "| seen | 2.00 (1.70) · 0.0200 · 0.000 |\n"
                      "| spotty | 2.00 (1.70) · 0.0000 · 0.110 |\n", text)
        self.assertIn("with 0.01: good. Not so: slow (1.49 times), seen (seen), spotty (seen).",
                      " ".join(text.split()))

    def test_of_memory_each_budget_is_beside_none(self):
        def trace(budget, slowdown, batches, peak, bytes_of_budget):
            params = {"call": "trace", "scene": "room", "width": 64, "height": 32, "engine": "paper",
                      "budget": budget}
            metrics = {"refusal": "budget: is 65535"} if budget == "below" else {
                "ms": 10 * slowdown, "slowdown": slowdown, "batches": batches, "bytes_peak": peak << 20,
                "bytes_allowed": 8 << 20, "budget": bytes_of_budget, "mismatches": 0}
            return case(f"memory/{budget}", params, metrics)
        text = self.passes(self.store("m.json", document_of(
            "memory", trace("below", 0, 0, 0, 65535), trace("none", 1, 1, 8, 0), trace("least", 1.5, 11, 2, 65536),
            trace("16x", 1.2, 4, 3, 1 << 20), trace("4x", 1.3, 6, 3, 1 << 18), trace("whole", 1, 1, 8, 8 << 20))))
        self.assertIn("| | least, MiB | least | 4x | 16x | whole | without |\n", text)
        self.assertIn("| room 64x32, paper | 0.06 | 1.50 · 11 · 2.0 | 1.30 · 6 · 3.0 | 1.20 · 4 · 3.0 | "
                      "1.00 · 1 · 8.0 | 10 ms · 1 · 8.0 |\n", text)
        self.assertNotIn("Frames", text)
        self.assertIn("0 mismatches in 5 cases. Allocated at once is at most 1.0000 of what is allowed.",
                      " ".join(text.split()))

    def test_several_files_of_a_suite_are_one_table(self):
        def stream(strategy, speed):
            params = {"strategy": strategy, "n": 1 << 22, "bytes": 4, "keep": 50, "pattern": "random",
                      "keep_by": "not_null"}
            return case(f"reduce/{strategy}", params, {"elements_per_s": speed, "ratio_to_copy": 0.5})
        one = self.store("one.json", document_of("reduce", stream("auto", 1e9), stream("chunk", 2e9)))
        other = self.store("other.json", document_of("reduce", stream("auto", 3e9)))
        text = self.passes(one, other)
        self.assertIn("| auto |  | 3.00 (0.50) |", text)
        self.assertIn("| chunk |  | 2.00 (0.50) |", text)
        self.assertIn("Chip, 7 compute units, avx2, Loom 9.1, commit abc; `rsh-bench reduce --quick`", text)

    def test_what_was_not_recorded_is_said(self):
        document = document_of("parity", case("parity/a", {}, {"wrong": 0}))
        del document["device"]["host_instruction_set"], document["command"], document["rsh"]
        text = " ".join(self.passes(self.store("p.json", document)).split())
        for words in ("instruction set not recorded", "commit not recorded", "`command not recorded`"):
            self.assertIn(words, text)

    def test_of_wrong_answers_there_is_none(self):
        file = self.store("p.json", document_of("parity", case("parity/a", {}, {"wrong": 3}, ok=False)))
        self.fails("p.json: parity/a is wrong", file)

    def test_other_files_are_refused(self):
        self.fails("no.json: ", self.folder / "no.json")
        self.fails("half.json: ", self.store("half.json", '{"suite": "hits", "cases": ['))
        self.fails("is not of rsh-bench: has no suite", self.store("list.json", "[1]"))
        self.fails("is not of rsh-bench: has no cases", self.store("none.json", '{"suite": "hits"}'))
        self.fails("a case has not all of",
                   self.store("some.json", '{"suite": "hits", "cases": [{"ok": true}]}'))
        self.fails("suite is tests, must be one of ablation", self.store("t.json", document_of("tests")))

    def test_a_case_that_is_none_is_refused(self):
        self.fails("a case has not all of", self.store("list.json", '{"suite": "hits", "cases": ["hits/a"]}'))

    def test_files_of_two_devices_are_refused(self):
        one, other = document_of("parity"), document_of("parity")
        other["device"] = {**DEVICE, "driver": "9.2"}
        self.fails("are of several devices: driver is 9.1 and 9.2",
                   self.store("a", one), self.store("b", other))


class Pages(InFolder):
    """On a copy of README.md, with the plots that it shows."""

    def setUp(self):
        super().setUp()
        self.page = self.folder / "README.md"
        self.text = (ROOT / "README.md").read_text()
        self.page.write_text(self.text)
        (self.folder / "docs").mkdir()
        for name in ("hits.svg", "accuracy.svg"):
            shutil.copy(ROOT / "docs" / name, self.folder / "docs")

    def change(self, old, new):
        self.assertEqual(self.text.count(old), 1, old)
        self.page.write_text(self.text.replace(old, new))

    def test_of_the_tree_are_those_of_the_results(self):
        self.assertLessEqual({"README.md", "ablation.md", "numerics.md"},
                             {page.name for page in report.all_pages()})
        self.passes("--check")
        self.passes("--check", self.page)

    def test_one_digit_is_noticed_in_each_section(self):
        lines = self.text.split("\n")
        begins = [i for i, line in enumerate(lines) if line.endswith("report.py writes from here -->")]
        self.assertEqual(len(begins), 3)
        for begin in begins:
            at = begin + 4  # an empty line, two of the table's head, its first row
            changed = lines[at].replace(".", ".9", 1)
            self.assertNotEqual(changed, lines[at])
            self.page.write_text("\n".join([*lines[:at], changed, *lines[at + 1:]]))
            name = lines[begin].split()[1].rstrip(":")
            text = self.fails(f"README.md:{at + 1}: section {name} has\n    {changed}\n", "--check", self.page)
            self.assertIn(f"where the results say\n    {lines[at]}\n", text)
            self.assertIn(f"report.py --write {self.page}\n", text)

    def test_a_missing_last_line_is_noticed(self):
        before, end, after = self.text.partition("\n<!-- ablation-costs: to here -->")
        last = before.rstrip("\n").split("\n")[-1]
        self.page.write_text(before.replace(last + "\n", "") + end + after)
        self.fails(f"where the results say\n    {last}\n", "--check", self.page)

    def test_are_written_as_they_must_be(self):
        self.change("| rooms (6) |", "| rooms (7) |")
        self.assertEqual(self.passes("--write", self.page), f"{self.page}: written\n")
        self.assertEqual(self.page.read_text(), self.text)
        self.assertEqual(self.passes("--write", self.page), f"{self.page}: is so already\n")

    def test_a_plot_of_other_results_is_noticed(self):
        plot = self.folder / "docs/hits.svg"
        plot.write_text(plot.read_text().replace("results ", "results 0"))
        self.fails("docs/hits.svg is no plot of ", "--check", self.page)
        plot.unlink()
        self.fails("docs/hits.svg is no plot of ", "--check", self.page)

    def test_new_results_stand_in_for_the_stored_ones(self):
        document = json.loads(STORED["ablation"].read_text())
        document["rsh"]["commit"] = "feedbeef"
        file = self.store("new.json", document)
        text = self.fails("feedbeef", file, "--check", self.page)
        self.assertIn(f"report.py {file} --write {self.page}", text)
        self.passes(file, "--write", self.page)
        self.passes(file, "--check", self.page)
        self.fails("section ablation-costs has", "--check", self.page)

    def test_a_section_that_is_none_is_refused(self):
        begin = "<!-- hits: tests/bench/report.py writes from here -->"
        self.change("<!-- hits: to here -->", "")
        self.fails("section hits begins, and has no line", "--check", self.page)
        self.change(begin, begin.replace("report.py", "hits/report.py"))
        self.fails("it has 2, of lines \"<!-- NAME: to here -->\" 3", "--check", self.page)
        self.page.write_text(self.text.replace("<!-- hits:", "<!-- misses:"))
        self.fails("section misses is of no suite", "--check", self.page)
        self.page.write_text("nothing\n")
        self.fails("README.md: has no section", "--check", self.page)
        self.fails("No such file", "--check", self.folder / "other.md")

    def test_a_row_of_budgets_without_a_case_is_refused(self):
        budgets = SUITES["budgets"]
        path = self.store("b.json", document_of("budgets", case(
            "budgets/a", {"bound": "a", "division": "correct"},
            {"measured_u": 2, "derived_u": 3, "granted_u": 4, "evaluations": 1e8})))
        results = by_suite([path])["budgets"]
        row = "| `a` | what | u | x | x | x | x | remark |"
        self.assertIn("| `a` | what | u | 2 of 3 | - | 4 | 1.0e+08 | remark |", budgets.filled(results, row))
        with self.assertRaisesRegex(SystemExit, "has no case for `b`"):
            budgets.filled(results, row + "\n| `b` | what | u | x | x | x | x | |")
        with self.assertRaisesRegex(SystemExit, "has cases for a, which the table has no row for"):
            budgets.filled(results, "| bound |")


class Comparisons(InFolder):
    """Of the stored results of hits with a changed copy."""

    def setUp(self):
        super().setUp()
        self.old = STORED["hits"]
        self.document = json.loads(self.old.read_text())
        self.case = next(c for c in self.document["cases"] if c["params"]["contender"] == "tiles/box")

    def compare(self, *options):
        return run("--compare", self.old, self.store("new.json", self.document), *options)

    def slow_down(self, factor):
        for metric in ("ms_total", "ms_low", "ms_high"):
            self.case["metrics"][metric] *= factor

    def assert_fails(self, words, *options):
        status, text = self.compare(*options)
        self.assertEqual(status, 1, text)
        self.assertIn(words, text)

    def assert_passes(self, words, *options):
        status, text = self.compare(*options)
        self.assertEqual(status, 0, text)
        self.assertIn(words, text)

    def test_every_stored_file_is_as_good_as_itself(self):
        for path in STORED.values():
            text = self.passes("--compare", path, path)
            self.assertIn("0 worse by more than 5 %, 0 new faults", text)
            self.assertIn(" +0.0% of ", text)
            self.assertNotIn("only in", text)

    def test_a_slower_case_fails(self):
        self.slow_down(1.1)
        self.assert_fails(f"{self.case['name']}  BEYOND THE THRESHOLD")
        self.assert_fails("1 worse by more than 9.9 %", "--threshold", "9.9%")
        self.assert_passes("0 worse by more than 11 %", "--threshold", "11")

    def test_the_worst_stands_first_and_the_median_below(self):
        self.slow_down(1.1)
        _, text = self.compare()
        self.assertRegex(text.split("\n")[2], r"^ +\+10\.0%  ms_total .*" + self.case["name"])
        self.assertRegex(text, r"\nmedian: ms_total \+0\.0% of \d+\n")

    def test_a_quicker_case_passes(self):
        self.slow_down(0.5)
        self.assert_passes("-50.0%  ms_total")

    def test_a_change_within_the_quartiles_is_noise(self):
        self.slow_down(1.1)
        self.case["metrics"]["ms_low"] /= 1.2
        self.assert_passes("quartiles overlap")

    def test_where_more_is_better_less_is_worse(self):
        self.case["metrics"]["ratio_embree_default"] /= 1.1
        self.case["metrics"]["ms_low"] *= 1.5  # no noise
        self.assert_fails("+10.0%  ratio_embree_default")

    def test_a_slower_peer_is_nobodys_fault(self):
        self.case = next(c for c in self.document["cases"] if c["params"]["peer"])
        self.slow_down(2)
        self.case["metrics"]["missed"] += 5
        self.assert_passes("0 new faults")

    def test_one_more_wrong_hit_fails(self):
        self.case["metrics"]["spurious"] += 1
        self.assert_fails(f"WRONG: {self.case['name']}: spurious is 1, was 0", "--threshold", "1000%")

    def test_a_case_that_is_wrong_fails(self):
        self.case.update(ok=False, metrics={"error": "out of memory"})
        self.assert_fails(f"WRONG: {self.case['name']}: is wrong: out of memory")

    def test_a_new_case_that_is_wrong_fails(self):
        self.document["cases"].append(case("hits/new", {"contender": "tiles/box"}, {"missed": 2}, ok=False))
        self.assert_fails("WRONG: hits/new: missed is 2, was not measured")

    def test_cases_in_one_file_are_named(self):
        self.document["cases"].remove(self.case)
        self.document["cases"].append(case("hits/new", {}, {"missed": 0}))
        self.assert_passes(f"only in {self.old}: {self.case['name']}\n")
        self.assert_passes(f"only in {self.folder / 'new.json'}: hits/new\n")

    def test_a_case_with_other_parameters_is_another(self):
        self.case["params"]["triangles"] += 1
        self.assert_passes(f"only in {self.old}: {self.case['name']}\n")

    def test_files_without_a_common_case_are_refused(self):
        self.document["cases"] = []
        self.assert_fails("have no case in common")

    def test_another_device_is_refused(self):
        self.document["device"]["driver"] = "4.0"
        self.assert_fails("devices differ: driver is 3.1+debian and 4.0")
        self.assert_passes("0 worse", "--any-device")

    def test_what_cannot_be_compared_is_refused(self):
        original = copy.deepcopy(self.document)
        for field, value, words in (("format_version", 2, "format_version differs: is 1 and 2"),
                                    ("quick", True, "quick differs: is False and True"),
                                    ("suite", "frame", "suites differ: hits and frame")):
            self.document = {**original, field: value}
            self.assert_fails(words)

    def test_a_file_that_tells_more_of_the_device_is_not_refused(self):
        self.document["device"]["host_instruction_set"] = "avx512f"
        self.document["format_version"] = 1
        self.assert_passes("0 worse")

    def test_infinite_errors_are_null(self):
        mirrors = json.loads(STORED["mirrors"].read_text())
        one = next(c for c in mirrors["cases"] if c["metrics"].get("position_error_median"))
        one["metrics"]["position_error_median"] = None
        self.fails("+inf%  position_error_median", "--compare", STORED["mirrors"], self.store("m.json", mirrors))


if __name__ == "__main__":
    unittest.main()

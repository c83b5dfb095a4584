#!/usr/bin/env python3
"""report_test.py - whether report.py makes tables of every suite, and finds each fault of pages and results.
Needs no device and draws nothing."""
import contextlib
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
        folders = {path.parent.name for path in BENCH.glob("*/*_suite.cpp")}
        self.assertEqual(folders, set(SUITES))
        self.assertEqual(folders, set(COSTS))

    def test_a_suite_without_a_table_of_its_own_has_its_metrics(self):
        file = self.store("q.json", document_of("queries", case("queries/a", {}, {"ms_any": 2.5, "wrong": 0})))
        self.assertIn("| case | ms any | wrong |\n|---|---|---|\n| a | 2.5 | 0 |\n", self.passes(file))

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
        text = self.fails("commit feedbeef", file, "--check", self.page)
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


if __name__ == "__main__":
    unittest.main()

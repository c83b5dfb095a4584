#!/usr/bin/env python3
"""plugins_test.py RSH_BENCH PLUGINS - what rsh-bench reduce makes of streams and reductions of others:
PLUGINS is the folder of those that plugins.cmake makes. No device is a failure."""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

BENCH, PLUGINS = sys.argv[1], pathlib.Path(sys.argv[2])
NO_HIT = 0xFFFFFFFF
SCENE = "room_20k"  # needs no files


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_bench(self, *options):
        """The exit status, all that was printed, and the JSON or None."""
        file = self.folder / "out.json"
        file.unlink(missing_ok=True)
        done = subprocess.run([BENCH, "reduce", "--budget", "1", "--json", file, *map(str, options)],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        return done.returncode, done.stdout, json.loads(file.read_text()) if file.exists() else None

    def results(self, *options):
        status, text, document = self.run_bench(*options)
        self.assertEqual(status, 0, text)
        return document

    def fails(self, words, *options):
        status, text, document = self.run_bench(*options)
        self.assertNotEqual(status, 0, text)
        self.assertIn(words, text)
        return document


class Plugins(InFolder):
    def plugin(self, name):
        return PLUGINS / f"{name}_plugin.so"

    def small(self, name):
        return "--n", 1000, "--strategy", "chunk", "--plugin", self.plugin(name)

    def test_a_right_one_is_timed(self):
        document = self.results("--n", "1,1000,100000", "--bytes", "4,8,12,16", "--strategy", "chunk",
                                "--plugin", self.plugin("example"))
        own = [case for case in document["cases"] if case["params"]["strategy"] == "peer:example"]
        self.assertEqual(len(own), 12)
        for case in own:
            self.assertTrue(case["ok"], case)
            self.assertGreater(case["metrics"]["ms"], 0, case)

    def test_one_that_writes_nothing_is_wrong_and_not_timed(self):
        """Behind a contender that was right, whose answer must not be there any more."""
        for keep in (0, 50, 100):
            document = self.fails("1 wrong", *self.small("idle"), "--keep", keep)
            chunk, idle = document["cases"]
            self.assertTrue(chunk["ok"])
            self.assertFalse(idle["ok"])
            self.assertEqual(idle["params"]["strategy"], "peer:broken")
            self.assertEqual(idle["metrics"], {})

    def test_one_that_fails_is_wrong_and_says_why(self):
        for fault, words in (("create", "create of the plug-in broken returned -30: as it was told to"),
                             ("run", "run of the plug-in broken returned -54: as it was told to")):
            document = self.fails(words, *self.small(fault))
            self.assertEqual([case["ok"] for case in document["cases"]], [True, False])

    def test_what_it_refuses_is_left_out(self):
        document = self.results(*self.small("refuse"))
        self.assertEqual(len(document["cases"]), 1)
        self.assertEqual(document["left_out"][0]["why"],
                         "create of the plug-in broken returned 1: as it was told to")
        document = self.results(*self.small("example"), "--keep-by", "flags")
        self.assertIn("takes not_null alone", document["left_out"][0]["why"])

    def test_one_that_is_none_is_refused(self):
        for fault, words in (("version", "version is 2, must be 1"),
                             ("name", 'name is "a/b", must be of letters, digits and _'),
                             ("taken", 'name is "copy", which another peer has'),
                             ("no_run", "run is NULL, must be a function"),
                             ("no_plugin", "rsh_bench_get_plugin returns NULL"),
                             ("no_symbol", "has no symbol rsh_bench_get_plugin"),
                             ("missing", "cannot open shared object file")):
            document = self.fails(words, *self.small(fault))
            self.assertEqual(document["cases"] if document else [], [], fault)

    def test_two_of_one_name_are_refused(self):
        self.fails('name is "example", which another peer has', *self.small("example"),
                   "--plugin", self.plugin("example"))


class Streams(InFolder):
    def store(self, name, data):
        (self.folder / name).write_bytes(data)

    def kept(self, *options):
        """The number of kept elements of each file, and of its elements and their bytes."""
        document = self.results("--streams", self.folder, "--strategy", "chunk", *options)
        return {case["params"]["pattern"]: (case["metrics"]["kept"], case["params"]["n"],
                                            case["params"]["bytes"]) for case in document["cases"]}

    def test_every_kind_is_reduced(self):
        self.store("a.flags", bytes([1, 0, 1, 1, 0]))
        self.store("b.pairs", struct.pack("<6I", 5, 6, NO_HIT, 7, 0, 0))
        self.store("c.pbm", b"P4\n3 2\n\xa0\x40")
        self.store("d.pgm", b"P5\n2 1\n255\n\x00\x09")
        self.store("notes.txt", b"no stream")
        self.assertEqual(self.kept(), {"file:a.flags": (3, 5, 4), "file:b.pairs": (2, 3, 8),
                                       "file:c.pbm": (3, 6, 4), "file:d.pgm": (1, 2, 4)})
        self.assertEqual(self.kept("--bytes", 16)["file:a.flags"], (3, 5, 16))

    def test_everybody_takes_part(self):
        self.store("a.flags", bytes(i % 3 == 0 for i in range(1000)))
        document = self.results("--streams", self.folder, "--plugin", PLUGINS / "example_plugin.so")
        names = {case["params"]["strategy"] for case in document["cases"]}
        self.assertLessEqual({"auto", "lookback", "atomic", "peer:copy", "peer:std_copy_if", "peer:example"},
                             names)

    def test_a_file_that_is_none_ends_it_before_anything_is_timed(self):
        self.store("a.flags", b"\x01")
        self.store("b.pairs", b"123456789")
        self.fails("b.pairs: is 9 bytes long, must be 8 for each of 1 to 2147483648 elements",
                   "--streams", self.folder)
        self.store("b.pairs", bytes(8))
        self.store("a.flags", b"\x01\x07")
        self.fails("a.flags: byte 1 is 7, must be 0 or 1", "--streams", self.folder)
        self.fails("none: No such file or directory", "--streams", self.folder / "none")
        self.fails("--n excludes --streams", "--streams", self.folder, "--n", 5)

    def test_pairs_that_were_dumped_are_those_of_the_frame(self):
        streams = self.folder / "pairs"
        status, text, _ = self.run_bench("--dump", streams, "--scene", SCENE)
        self.assertEqual(status, 0, text)
        files = sorted(streams.iterdir())
        self.assertEqual([file.name for file in files], [f"{SCENE}_level_{level}.pairs" for level in range(9)])
        self.follow(streams)
        levels = (7, 4)  # short ones
        for file in files:
            if int(file.stem.rsplit("_", 1)[1]) not in levels:
                file.unlink()
        of_files = self.results("--streams", streams, "--strategy", "chunk")
        of_frame = self.results("--pattern", ",".join(f"pairs:{SCENE}:{level}" for level in sorted(levels)),
                                "--bytes", 8, "--strategy", "chunk")
        for file, frame in zip(of_files["cases"], of_frame["cases"], strict=True):
            self.assertEqual(file["params"]["n"], frame["params"]["n"])
            self.assertEqual(file["params"]["keep"], frame["params"]["keep"])
            self.assertEqual(file["metrics"]["kept"], frame["metrics"]["kept"])

    def follow(self, streams):
        """The four pairs below each survivor are the next stream: same triangle, its four children."""
        above = None
        for level in range(8, -1, -1):
            words = (streams / f"{SCENE}_level_{level}.pairs").read_bytes()
            pairs = list(struct.iter_unpack("<2I", words[:8 * 4000]))
            if above is not None:
                expected = [(triangle, self.child(node, k, level)) for triangle, node in above
                            for k in range(4)][:len(pairs)]
                for found, (triangle, node) in zip(pairs, expected):
                    self.assertIn(found[0], (triangle, NO_HIT))
                    self.assertEqual(found[1], node)
            above = [pair for pair in pairs if pair[0] != NO_HIT]

    def child(self, parent, k, level):
        x, y = 2 * (parent & 0xFFFF) + k % 2, 2 * (parent >> 16) + k // 2
        return y * 512 + x if level == 0 else y << 16 | x


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

#!/usr/bin/env python3
"""Reader and published schema must say the same of every study file the schema language can judge.

    schema_test.py PROBE

files/good: both accept. files/bad: both refuse, and the reader finds exactly one mistake (each file has one defect).
files/bad_beyond_schema: the schema cannot see it, the reader refuses. The shipped studies are accepted by both.
"""
import json
import pathlib
import subprocess
import sys
import unittest

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[3]
FILES = ROOT / "tests/study/files"
PROBE = sys.argv.pop(1)
SCHEMA = json.loads((ROOT / "studies/schema/icebow-study-1.schema.json").read_text())


def reader(files):
    out = subprocess.run([PROBE, *map(str, files)], check=True, capture_output=True, text=True).stdout
    return {pathlib.Path(name): mistakes for name, mistakes in json.loads(out).items()}


def json_files(directory):
    return sorted(directory.glob("*.json"))


class SchemaTest(unittest.TestCase):
    def setUp(self):
        self.validator = jsonschema.Draft202012Validator(SCHEMA)

    def schema_accepts(self, path):
        return self.validator.is_valid(json.loads(path.read_text()))

    def test_the_schema_is_one(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)
        self.assertTrue(SCHEMA["$id"].startswith("urn:"))

    def test_there_are_enough_files(self):
        self.assertGreaterEqual(len(json_files(FILES / "good")), 8)
        self.assertGreaterEqual(len(json_files(FILES / "bad")), 25)

    def test_both_accept_good_files(self):
        files = json_files(FILES / "good") + json_files(ROOT / "studies") + json_files(ROOT / "studies/families")
        files += [ROOT / "studies/convergence/layers.json", ROOT / "studies/convergence/time_step.json"]
        said = reader(files)
        for path in files:
            with self.subTest(path.name):
                self.assertEqual(said[path], [])
                self.assertEqual([e.message for e in self.validator.iter_errors(json.loads(path.read_text()))], [])

    def test_both_refuse_bad_files(self):
        files = json_files(FILES / "bad")
        said = reader(files)
        for path in files:
            with self.subTest(path.name):
                self.assertFalse(self.schema_accepts(path), "the schema accepts it")
                # A section that is missing or no object lacks all its keys: one mistake for the reader or many.
                whole = path.stem == "missing_bow"
                self.assertTrue(len(said[path]) == 1 or (whole and said[path]), said[path])

    def test_only_the_reader_sees_the_rest(self):
        files = json_files(FILES / "bad_beyond_schema")
        said = reader(files)
        for path in files:
            with self.subTest(path.name):
                self.assertEqual(len(said[path]), 1, said[path])
                if path.stem not in ("syntax_error", "number_too_large"):  # Python reads 1e400 as infinity
                    self.assertTrue(self.schema_accepts(path), "the schema can see it: move it to bad")

    def test_schema_and_documentation_follow_the_table_of_keys(self):
        made = subprocess.run([sys.executable, ROOT / "studies/schema/generate.py", PROBE, "--check"],
                              capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)


unittest.main()

"""The program and its files, for tests from outside; the program is the first argument of the test script."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
HERE = pathlib.Path(__file__).resolve().parent
TINY = HERE / "tiny.json"
FILES = HERE.parent / "study/files"
STUDIES = HERE.parents[1] / "studies"
CACHE = tempfile.TemporaryDirectory(prefix="icebow_cache_")
os.environ["XDG_CACHE_HOME"] = CACHE.name
PATIENCE = float(os.environ.get("ICEBOW_TEST_PATIENCE", 1))  # more under sanitizers
INFEASIBLE = "/bow/bow_length_m=12"


def start(*words, cwd=None, ranks=0, env={}, **options):
    launcher = ["mpirun", "-n", str(ranks)] if ranks else []
    environment = {**os.environ, "NO_COLOR": "1", **env}
    return subprocess.Popen([*launcher, PROGRAM, *map(str, words)], cwd=cwd, env=environment, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)


def icebow(*words, timeout=100, **options):
    process = start(*words, **options)
    try:
        out, err = process.communicate(timeout=PATIENCE * timeout)
    except subprocess.TimeoutExpired:
        process.kill()
        raise
    return subprocess.CompletedProcess(words, process.returncode, out, err)


class ProgramTest(unittest.TestCase):
    def setUp(self):
        self.directory = pathlib.Path(tempfile.mkdtemp(prefix="icebow_cli_"))
        self.addCleanup(shutil.rmtree, self.directory)

    def expect(self, code, *words, **options):
        result = icebow(*words, **options)
        self.assertEqual(result.returncode, code, f"{words}\n{result.stdout}\n{result.stderr}")
        return result

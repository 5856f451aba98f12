"""studies/convergence/extrapolate.py finds the limit that made-up results were made from."""

import importlib.util
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[3] / "studies/convergence/extrapolate.py"
spec = importlib.util.spec_from_file_location("extrapolate", SCRIPT)
extrapolate = importlib.util.module_from_spec(spec)
spec.loader.exec_module(extrapolate)


def write_study(directory, load_of, layers=(2, 3, 4, 5), repeats=3, ci95=0.4, ice=None):
    (directory / "study.json").write_text(json.dumps({"ice": ice or {"critical_stretch": 0.005}, "solver": {"contact": "penalty"}}))
    for n in layers:
        for repeat in range(repeats):
            folder = directory / "designs" / f"d{n:03d}#{repeat + 1}"
            folder.mkdir(parents=True)
            (folder / "result.json").write_text(json.dumps({
                "status": "ok", "simulation": {"nz": n},
                "metrics": {"mean_load_N": load_of(n), "mean_load_ci95_N": ci95}}))


class Extrapolate(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.directory = pathlib.Path(self.folder.name)

    def test_the_interval_holds_the_limit_whichever_power_is_right(self):
        for power in (1, 2):
            points = [(1.0 / n, 10.0 + 12.0 / n**power, 0.2) for n in (2, 3, 4, 5)]
            limit, half = extrapolate.limit_of(points)
            self.assertLess(abs(limit - 10.0), half)
            self.assertAlmostEqual(extrapolate.fitted(points, power)[0], 10.0, places=9)

    def test_its_fit_covers_the_truth_in_95_of_100_cases(self):
        draw = random.Random(4)
        covered = 0
        for _ in range(400):
            points = [(1.0 / n, 10.0 + 12.0 / n + draw.gauss(0.0, 0.3), 0.3) for n in (2, 3, 4, 5)]
            limit, error = extrapolate.fitted(points, 1)
            covered += abs(limit - 10.0) < 1.96 * error
        self.assertGreater(covered, 365)
        self.assertLess(covered, 395)

    def test_the_table_is_written_and_added_to(self):
        write_study(self.directory, lambda n: 10.0 + 6.0 / n)
        table = self.directory / "bias.json"
        other = {"layers": 3, "strength": "toughness", "contact": "relocation", "load_over_limit": 1.5, "ci95": 0.1}
        table.write_text(json.dumps({"format": 1, "entries": [other]}))
        subprocess.run([sys.executable, SCRIPT, self.directory, "--write", "--table", table], check=True,
                       capture_output=True)
        entries = json.loads(table.read_text())["entries"]
        self.assertEqual(len(entries), 5)
        self.assertIn(other, entries)
        penalty = {e["layers"]: e["load_over_limit"] for e in entries if e["contact"] == "penalty"}
        self.assertGreater(penalty[2], penalty[5])
        self.assertGreater(penalty[5], 1.0)

    def test_ice_that_has_no_limit_is_refused(self):
        write_study(self.directory, lambda n: 10.0, ice={"fracture_toughness_MPa_sqrt_m": 7.5})
        run = subprocess.run([sys.executable, SCRIPT, self.directory], capture_output=True, text=True)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("no limit", run.stderr)

    def test_two_lattices_are_refused(self):
        write_study(self.directory, lambda n: 10.0, layers=(2, 3))
        run = subprocess.run([sys.executable, SCRIPT, self.directory], capture_output=True, text=True)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("a fit takes 3", run.stderr)


if __name__ == "__main__":
    unittest.main()

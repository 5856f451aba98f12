#!/usr/bin/env python3
"""The program from outside, where it computes: calibrate, simulate, run.

    cli_simulation_test.py PROGRAM [unittest options]
"""
import json
import os
import re
import signal
import time
import unittest

from program import INFEASIBLE, PATIENCE, ProgramTest, TINY, start


class Calibrate(ProgramTest):
    ICE = ("--set", '/ice={"scale": "model", "thickness_m": 0.08, "model": "calibrated", "elastic_modulus_MPa": 35, '
           '"flexural_strength_kPa": 35}')

    def test_json_has_what_was_requested_and_measured(self):
        said = json.loads(self.expect(0, "calibrate", TINY, *self.ICE, "--json").stdout)
        requested, measured = said["requested"], said["measured"]
        self.assertLessEqual(set(requested), set(measured))
        self.assertAlmostEqual(measured["held_beam_modulus_Pa"] / 35e6, 0.89, delta=0.04)  # 2 layers; its root yields
        length = (measured["elastic_modulus_Pa"] * 0.08 ** 3 / (12 * (1 - 0.33 ** 2) * 9806.65)) ** 0.25
        self.assertAlmostEqual(measured["characteristic_length_m"] / length, 1, delta=0.02)
        self.assertNotIn("in_situ_modulus_Pa", measured)
        self.assertEqual(said["scale"], "model")
        self.assertAlmostEqual(requested["elastic_modulus_Pa"], 35e6, delta=1)
        self.assertAlmostEqual(requested["flexural_strength_Pa"], 35e3, delta=1)
        self.assertAlmostEqual(requested["compressive_strength_Pa"], 105e3, delta=1)  # three times that
        for name in ("elastic_modulus_Pa", "flexural_strength_Pa"):
            self.assertAlmostEqual(measured[name] / requested[name], 1, delta=0.03)
        self.assertAlmostEqual(measured["compressive_strength_Pa"] / 105e3, 1, delta=0.1)

    def test_beams_in_the_floating_sheet_are_tested_where_asked_for(self):
        measured = json.loads(self.expect(0, "calibrate", TINY, *self.ICE, "--in-situ", "--json").stdout)["measured"]
        up, down = (measured[f"in_situ_flexural_strength_{way}_Pa"] for way in ("up", "down"))
        self.assertAlmostEqual(up / down, 1, delta=0.01)
        self.assertLess(up, measured["flexural_strength_Pa"])
        self.assertLess(measured["in_situ_modulus_Pa"], measured["elastic_modulus_Pa"])
        self.assertIn("strength in situ, down", self.expect(0, "calibrate", TINY, *self.ICE, "--in-situ").stdout)

    def test_full_scale_ice_is_compared_at_full_scale(self):
        words = ("calibrate", TINY, "--json", "--set", "/ice/model=calibrated", "--set",
                 "/ice/compressive_strength_MPa=2")
        said = json.loads(self.expect(0, *words).stdout)
        self.assertEqual(said["scale"], "full")
        self.assertAlmostEqual(said["requested"]["compressive_strength_Pa"], 2e6, delta=1)
        self.assertAlmostEqual(said["requested"]["flexural_strength_Pa"], 5e5, delta=1)
        self.assertAlmostEqual(said["measured"]["flexural_strength_Pa"] / 5e5, 1, delta=0.03)
        self.assertAlmostEqual(said["measured"]["compressive_strength_Pa"] / 2e6, 1, delta=0.1)

    def test_text_for_people(self):
        text = self.expect(0, "calibrate", TINY, *self.ICE).stdout
        for words in ("model scale", "flexural strength", "crushing pressure", "in water it would be stiffer"):
            self.assertIn(words, text)
        text = self.expect(0, "calibrate", TINY).stdout
        for words in ("critical stretch", "cannot be set"):
            self.assertIn(words, text)

    def test_ice_as_given_is_measured_too(self):
        said = json.loads(self.expect(0, "calibrate", TINY, "--json").stdout)
        self.assertEqual(said["model"], "paper")
        self.assertAlmostEqual(said["input"]["elastic_modulus_Pa"], 1.3e9, delta=10)
        self.assertLess(said["measured"]["elastic_modulus_Pa"], 1.3e9)  # few layers bend too easily

    def test_a_mistake_names_the_key_and_what_to_do(self):
        result = self.expect(2, "calibrate", TINY, *self.ICE, "--set", "/ice/critical_stretch=0.005")
        self.assertIn("/ice/critical_stretch", result.stderr)
        self.assertIn("Drop it", result.stderr)

    def test_a_run_simulates_what_was_found(self):
        found = json.loads(self.expect(0, "calibrate", TINY, *self.ICE, "--json").stdout)["input"]
        self.expect(0, "simulate", TINY, *self.ICE, "--out", self.directory, ranks=2)
        simulation = json.loads((self.directory / "result.json").read_text())["simulation"]
        self.assertAlmostEqual(simulation["elastic_modulus_Pa"] / found["elastic_modulus_Pa"], 1, places=12)
        for name in ("tensile_strength_Pa", "crushing_pressure_Pa"):
            self.assertAlmostEqual(simulation[name] / found[name], 1, places=12)
        self.assertIsNone(simulation["critical_stretch"])


class Simulate(ProgramTest):
    def test_pictures_become_an_animation(self):
        out = self.directory / "one"
        self.expect(0, "simulate", TINY, "--out", out, "--set", "/output/pictures=3")
        result = json.loads((out / "result.json").read_text())
        self.assertEqual(result["files"]["animation"], "breaking.png")
        written = (out / "breaking.png").read_bytes()
        self.assertEqual(written.count(b"fcTL"), 3)
        again = self.directory / "again.png"
        self.assertEqual(self.expect(0, "picture", out, "--out", again).stdout, f"{again}\n")
        self.assertEqual(again.read_bytes(), written)
        self.assertIn("output.pictures", self.expect(2, "picture", self.directory).stderr)

    def test_one_run(self):
        out = self.directory / "new/run"
        result = json.loads(self.expect(0, "simulate", TINY, "--out", out, "--json").stdout)
        self.assertEqual(result, json.loads((out / "result.json").read_text()))
        self.assertEqual((result["design"], result["status"]), ("baseline", "ok"))
        metrics = result["metrics"]
        self.assertGreater(metrics["mean_load_N"], 0)
        self.assertAlmostEqual(metrics["full_scale"]["mean_load_N"] / metrics["mean_load_N"], 25 ** 3, places=6)
        self.assertEqual(result["simulation"]["nz"], 2)
        for name in ("history.csv", "ice.pvd", "hull.vtp", "hull_pressure.pvd"):
            self.assertTrue((out / name).stat().st_size > 0, name)
        self.assertTrue(any(out.glob("ice_*.png")))
        rows = (out / "history.csv").read_text().splitlines()
        self.assertGreater(len(rows), 8)

    def test_where_the_time_went(self):
        result = self.expect(0, "simulate", TINY, "--out", self.directory, "--json", "--profile", ranks=2)
        profile = json.loads(result.stdout)["profile"]
        self.assertAlmostEqual(sum(phase["share"] for phase in profile), 1.0, places=6)
        for phase in profile:
            self.assertIn(phase["phase"], result.stderr)
            self.assertGreaterEqual(phase["max_ms_per_step"], 0.999 * phase["ms_per_step"])

    def test_the_same_on_two_ranks(self):
        one = json.loads(self.expect(0, "simulate", TINY, "--out", self.directory / "1", "--json").stdout)
        two = json.loads(self.expect(0, "simulate", TINY, "--out", self.directory / "2", "--json", ranks=2).stdout)
        self.assertEqual(two["provenance"]["ranks"], 2)
        self.assertEqual(one["metrics"]["mean_load_N"], two["metrics"]["mean_load_N"])

    def test_failures(self):
        result = self.expect(1, "simulate", TINY, "--out", self.directory / "bad", "--set", INFEASIBLE, "--json")
        self.assertEqual(json.loads(result.stdout)["status"], "infeasible")
        blocked = self.directory / "file"
        blocked.write_text("")
        self.assertIn("file", self.expect(1, "simulate", TINY, "--out", blocked / "x").stderr)

    def test_interrupted(self):
        process = start("simulate", TINY, "--out", self.directory, "--set", "/solver/layers=5")
        time.sleep(1.5)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=PATIENCE * 30)
        self.assertEqual(process.returncode, 130, err)
        self.assertIn("interrupted", err)

    def test_an_interrupted_run_continues(self):
        words = ("simulate", TINY, "--set", "/solver/time_step_fraction=0.2", "--out")
        out, checkpoint = self.directory / "run", self.directory / "run/checkpoint.h5"
        process = start(*words, out)
        while process.poll() is None and not any(out.glob("ice_0001*.vtp")):
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=PATIENCE * 30)
        self.assertEqual(process.returncode, 130, err)
        self.assertIn("continues", err)
        self.assertTrue(checkpoint.exists())
        other = self.expect(1, *words, out, "--set", "/ice/thickness_m=1.9").stderr
        self.assertIn(str(checkpoint), other)
        self.assertIn("--restart", other)
        resumed = self.expect(0, *words, out, ranks=2).stderr
        self.assertEqual(len(re.findall(r"continues at step \d+ from", resumed)), 1, resumed)
        self.assertFalse(checkpoint.exists())
        self.expect(0, *words, self.directory / "straight")
        for name in ("history.csv", "ice_000.png"):
            self.assertEqual((out / name).read_bytes(), (self.directory / "straight" / name).read_bytes())
        checkpoint.write_bytes(b"not HDF5")
        self.assertIn("not a whole checkpoint", self.expect(1, *words, out).stderr)
        short = ("--set", "/operation/advance_m=4")
        self.assertNotIn("continues", self.expect(0, *words, out, *short, "--restart").stderr)


class Run(ProgramTest):
    def test_a_study_from_start_to_report(self):
        out = self.directory / "study"
        first = self.expect(0, "run", TINY, "--out", out)
        self.assertIn("Steep stem", first.stdout)
        for name in ("report.html", "ranking.csv", "ranking.md", "results.sqlite", "study.json"):
            self.assertTrue((out / name).stat().st_size > 0, name)
        again = self.expect(0, "run", TINY, "--out", out, "--json")
        self.assertIn("2 of them stored before", again.stderr)
        ranking = json.loads(again.stdout)
        self.assertEqual(ranking, json.loads(self.expect(0, "rank", out, "--json").stdout))
        self.assertEqual([d["rank"] for d in ranking["designs"]], [1, 2])
        self.assertLessEqual(ranking["designs"][0]["mean_load_N"], ranking["designs"][1]["mean_load_N"])
        self.assertEqual(self.expect(0, "rank", out).stdout, first.stdout)
        html = self.directory / "r.html"
        self.assertEqual(self.expect(0, "report", out, "--out", html).stdout.strip(), str(html))
        self.assertIn("Steep stem", html.read_text())

    def test_infeasible_designs_are_results_and_failed_ones_exit_3(self):
        study = json.loads(TINY.read_text())
        study["evaluators"], study["ranking"] = ["lindqvist"], {"by": "lindqvist_breaking"}
        study["designs"] = [{"name": "Short", "set": {"bow": {"bow_length_m": 12}}}]
        path = self.directory / "s.json"
        path.write_text(json.dumps(study))
        result = self.expect(0, "run", path, "--out", self.directory / "a", "--json")
        self.assertEqual([d["status"] for d in json.loads(result.stdout)["designs"]], ["ok", "infeasible"])
        study.pop("evaluators")
        study["ranking"] = {"by": "mean_load"}
        study["designs"] = [{"name": "Unstable", "set": {"solver": {"time_step_s": 0.1}}}]
        path.write_text(json.dumps(study))
        result = self.expect(3, "run", path, "--out", self.directory / "b", "--json")
        self.assertEqual([d["status"] for d in json.loads(result.stdout)["designs"]], ["ok", "failed"])

    def test_interrupted_and_resumed(self):
        out = self.directory / "study"
        checkpoint = out / "designs/baseline/checkpoint.h5"
        words = ("run", TINY, "--out", out, "--jobs", "1", "--set", "/solver/time_step_fraction=0.2",
                 "--set", "/output/pictures=20")
        process = start(*words, start_new_session=True)
        deadline = time.time() + PATIENCE * 60
        while time.time() < deadline and not (out / "designs/baseline/ice_000.png").exists() and process.poll() is None:
            time.sleep(0.05)
        os.kill(process.pid, signal.SIGTERM)
        _, err = process.communicate(timeout=PATIENCE * 60)
        self.assertEqual(process.returncode, 130, err)
        self.assertIn("same command", err)
        self.assertTrue(checkpoint.exists())  # of the child, which the program ends
        self.expect(0, *words)
        self.assertFalse(checkpoint.exists())

    def test_in_one_job_of_two_ranks(self):
        out = self.directory / "study"
        result = self.expect(0, "run", TINY, "--out", out, "--json", ranks=2)
        self.assertEqual([d["status"] for d in json.loads(result.stdout)["designs"]], ["ok", "ok"])
        self.assertIn("2 of them stored before", self.expect(0, "run", TINY, "--out", out).stderr)

    def test_no_study(self):
        for command in ("rank", "report"):
            self.assertIn(str(self.directory), self.expect(2, command, self.directory).stderr)
        blocked = self.directory / "file"
        blocked.write_text("")
        self.assertIn(str(blocked), self.expect(1, "run", TINY, "--out", blocked).stderr)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""The program from outside, without a simulation: what it prints where, what it writes, its exit codes.

    cli_test.py PROGRAM [unittest options]
"""
import csv
import io
import json
import re
import shlex
import shutil
import subprocess
import sys
import unittest

from program import icebow, FILES, INFEASIBLE, PROGRAM, ProgramTest, STUDIES, TINY


class Usage(ProgramTest):
    def test_help_lists_every_command(self):
        text = self.expect(0, "--help").stdout
        for command in ("new", "check", "hull", "measure", "resistance", "cycle", "calibrate", "simulate", "run", "rank", "status", "watch", "show", "export", "diff",
                        "report"):
            self.assertIn(f"\n  {command} ", text)
            self.assertIn(f"usage: icebow {command} ", self.expect(0, "help", command).stdout)
            self.assertIn("\nexample: ", self.expect(0, "help", command).stdout)
            for line in self.expect(0, "help", command).stdout.splitlines():
                self.assertLessEqual(len(line), 100)
        self.assertEqual(text, self.expect(0).stdout)
        self.assertIn("--out DIR", self.expect(0, "run", "--help").stdout)

    def test_results_that_cannot_be_printed(self):
        with open("/dev/full", "w") as full:
            process = subprocess.run([PROGRAM, "hull", TINY, "--json"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.returncode, 1)
        self.assertIn("standard output", process.stderr)

    def test_version(self):
        lines = self.expect(0, "--version").stdout.splitlines()
        self.assertRegex(lines[0], r"^icebow \d+\.\d+\.\d+$")
        self.assertEqual([line.split()[0] for line in lines[1:]], ["commit", "compiler", "MPI", "vectors", "parts"])
        self.assertIn("baseline", icebow("--version", env={"ICEBOW_KERNEL": "baseline"}).stdout)

    def test_man_page_and_completions_name_every_command_and_option(self):
        man = self.expect(0, "help", "--man").stdout
        self.assertTrue(man.split("\n")[1].startswith(".TH ICEBOW 1"))
        for shell in ("bash", "zsh", "fish"):
            script = self.expect(0, "help", f"--completion={shell}").stdout
            for command in re.findall(r"\n  (\w+) [A-Z]+ ", self.expect(0, "help").stdout):
                self.assertIn(command, script)
                self.assertIn(f".SS icebow {command} ", man)
                for option in re.findall(r"\n  --([\w-]+)", self.expect(0, "help", command).stdout):
                    self.assertIn(option, script)
                    self.assertIn(option.replace("-", "\\-"), man)
        self.assertIn('"bash"', self.expect(2, "help", "--completion=bsh").stderr)
        completed = subprocess.run(
            ["bash", "-c", 'eval "$1"; COMP_WORDS=(icebow hull --o); COMP_CWORD=2; _icebow; echo "${COMPREPLY[@]}"', "-",
             self.expect(0, "help", "--completion=bash").stdout], capture_output=True, text=True)
        self.assertEqual(completed.stdout.split(), ["--out", "--overlay"])

    def test_a_first_study_by_questions_or_by_options(self):
        mine = self.directory / "mine.json"
        said = self.expect(0, "new", mine, "--length", "90", "--beam", "18", "--draft", "6", "--thickness", "0.7",
                           "--speed", "3", "--samples", "5").stdout
        self.assertIn(f"icebow run {mine}", said)
        self.assertIn("designs: 6\n", self.expect(0, "check", mine).stdout)
        self.assertIn("already", self.expect(2, "new", mine).stderr)
        asked = subprocess.run([PROGRAM, "new", self.directory / "asked.json"], input="90\n2\n18\n\n0.7\n3\n", text=True,
                               capture_output=True)
        self.assertEqual(asked.returncode, 0, asked.stderr)
        self.assertIn("from 4 to 80 m", asked.stderr)  # a beam of 2 m is asked for again
        study = json.loads((self.directory / "asked.json").read_text())
        self.assertEqual([study["bow"][key] for key in ("length_m", "beam_m", "draft_m")], [90.0, 18.0, 8.0])
        self.assertIn("--beam 2", self.expect(2, "new", self.directory / "no.json", "--beam", "2").stderr)
        self.assertIn("straight_parallel_buttocks", self.expect(2, "new", self.directory / "no.json", "--family", "x").stderr)

    def test_bad_words_are_answered_with_the_nearest_known(self):
        for words, hint in ((["chekc", TINY], '"check"'), (["check", TINY, "--sett", "/a=1"], '"--set"'),
                            (["hull", TINY, "--jsn"], '"--json"'), (["--versoin"], '"--version"'),
                            (["help", "rnu"], '"run"')):
            result = self.expect(2, *words)
            self.assertIn(hint, result.stderr)
            self.assertEqual(result.stdout, "")

    def test_missing_and_surplus_words(self):
        self.assertIn("STUDY is missing", self.expect(2, "check").stderr)
        self.assertIn("--out DIR is missing", self.expect(2, "run", TINY).stderr)
        self.assertIn("needs a value", self.expect(2, "hull", TINY, "--design").stderr)
        self.assertIn("second", self.expect(2, "check", TINY, TINY).stderr)
        self.assertIn("takes no value", self.expect(2, "hull", TINY, "--json=yes").stderr)
        self.assertIn("twice", self.expect(2, "hull", TINY, "--out", "a.obj", "--out", "b.obj").stderr)
        for jobs in ("0", "two", "-1"):
            self.assertIn("--jobs", self.expect(2, "run", TINY, "--out", self.directory, "--jobs", jobs).stderr)


class Check(ProgramTest):
    def test_a_good_study_is_summed_up(self):
        text = self.expect(0, "check", TINY).stdout
        self.assertIn("designs: 2\n", text)
        self.assertIn("2  Steep stem", text)
        nx, ny, nz, particles = map(int, re.search(r"(\d+) x (\d+) x (\d+) = (\d+) particles", text).groups())
        self.assertEqual((nx * ny * nz, nz), (particles, 2))
        self.assertRegex(text, r"\d+ steps of [\d.e-]+ s")

    def test_what_is_known_of_a_model_is_said(self):
        plain = self.expect(0, "check", TINY).stdout
        self.assertIn("the bow is still entering the ice", plain)
        self.assertEqual(plain.count("note:"), 1)
        notes = self.expect(0, "check", TINY, "--set", "/ice/model=calibrated", "--set", "/solver/floe_contact=false").stdout
        self.assertIn("solver.floe_contact", notes)
        self.assertIn("solver.layers 3 or more", notes)
        near = self.expect(0, "check", STUDIES / "calibrated_ice.json", "--set", "/sheet/window_ahead_m=8").stdout
        self.assertRegex(near, "note: sheet.window_ahead_m is 8 m, .* 10.5")
        whole = self.expect(0, "check", STUDIES / "calibrated_ice.json").stdout
        self.assertNotIn("note:", whole)

    def test_the_shipped_studies_have_no_mistakes(self):
        for study in sorted(STUDIES.glob("*.json")):
            with self.subTest(study.name):
                said = self.expect(0, "check", study).stdout
                designs = int(re.search(r"^designs: (\d+)", said, re.M).group(1))
                # Samples of a box of angles have points that are no hull; named designs all are one.
                samples = any(m in study.read_text() for m in ("latin_hypercube", "sobol", "halton"))
                allowed = 0.4 * designs if samples else 0
                self.assertLessEqual(said.count("(infeasible"), allowed)

    def test_every_mistake_is_listed_by_pointer(self):
        result = self.expect(2, "check", TINY, "--set", "/bow/stem_deg=95", "--set", "/ice/frction=0.1",
                             "--set", "/operation/speed_kn=fast")
        for pointer in ("/bow/stem_deg: is 95, allowed 5 to 85 deg", "/ice/frction", "/operation/speed_kn"):
            self.assertIn(pointer, result.stderr)
        self.assertIn("3 mistakes", result.stderr)
        self.assertEqual(result.stdout, "")

    def test_files_that_cannot_be_read(self):
        self.assertIn("nowhere.json", self.expect(2, "check", "nowhere.json").stderr)
        self.assertIn("line 21", self.expect(2, "check", FILES / "bad_beyond_schema/syntax_error.json").stderr)

    def test_cost_of_a_study(self):
        text = self.expect(0, "check", TINY, "--cost", "--set", '/evaluators=["lindqvist"]',
                           "--set", "/ranking/by=lindqvist_breaking").stdout
        self.assertRegex(text, r"(?m)^  \d+ designs: 0\.\d+ s of a core each, 0\.00 core hours, [0-9.]+ MB$")
        text = self.expect(0, "check", TINY, "--cost", "--set", "/execution/ranks_per_design=2").stdout
        self.assertRegex(text, r"(?m)^  \d+ designs: [0-9.]+ (s|min) of a core each \([0-9.]+ min by 2 ranks\), ")
        self.assertNotIn("cost", self.expect(0, "check", TINY).stdout)
        race = self.expect(0, "check", TINY, "--cost", "--set", '/decide={"budget_core_h": 2, "longest_m": 80}',
                           "--set", "/sheet/window_ahead_m=12", "--set", "/sheet/length_m=46").stdout
        self.assertRegex(race, r"(?m)^  2 first legs: ")
        self.assertRegex(race, r"as far as it may sail, 80 m, take [0-9.]+ core hours; none is sailed on once 2 are spent")

    def test_one_design_of_a_study(self):
        said = self.expect(0, "check", TINY, "--design", "Steep stem").stdout
        self.assertIn("design: Steep stem\n  feasible\n", said)
        self.assertRegex(said, r"one run: \d+ x \d+ x 2 ")
        self.assertNotIn("designs:", said)
        self.assertIn("design: Steep stem", self.expect(0, "check", TINY, "--design", "2").stdout)
        cost = self.expect(0, "check", TINY, "--design", "Steep stem", "--cost", "--set", '/evaluators=["lindqvist"]',
                           "--set", "/ranking/by=lindqvist_breaking").stdout
        self.assertRegex(cost, r"(?m)^  1 design: 0\.\d+ s of a core each")
        bad = self.expect(3, "check", TINY, "--design", "Steep stem", "--set", "/bow/bow_length_m=12")
        self.assertIn("the design Steep stem is infeasible: ", bad.stderr)
        self.assertIn("no such design", self.expect(2, "check", TINY, "--design", "Step stem").stderr)

    def test_words_of_a_design_are_listed(self):
        said = self.expect(0, "check", TINY, "--set", '/method={"type": "grid", "variables": {"/bow/family": '
                           '{"values": ["straight_parallel_buttocks", "concave"]}}}').stdout
        self.assertIn("d002  /bow/family concave", said)

    def test_a_program_that_is_not_here(self):
        study = self.directory / "yard.json"
        document = json.loads(TINY.read_text())
        document.update(evaluators=["lindqvist", {"name": "yard", "command": ["no_such_program"]}],
                        ranking={"by": "/programs/yard/resistance_N"})
        study.write_text(json.dumps(document))
        self.assertIn("no_such_program, which is not found", self.expect(0, "check", study).stdout)
        self.assertIn("no_such_program: cannot be started",
                      self.expect(1, "run", study, "--out", self.directory / "yard").stderr)
        document["evaluators"][1]["command"] = ["echo", '{"resistance_N": 1e300}']
        study.write_text(json.dumps(document))
        self.assertIn(" 1e+297", self.expect(0, "run", study, "--out", self.directory / "yard").stdout)
        document["evaluators"][1]["command"] = ["echo", '{"resistance_kN": 1}']
        study.write_text(json.dumps(document))
        self.assertIn("2 of the designs that are ok have no /programs/yard/resistance_N",
                      self.expect(3, "run", study, "--out", self.directory / "yard").stderr)

    def test_under_mpi_one_rank_speaks_and_nobody_hangs(self):
        self.assertEqual(self.expect(0, "check", TINY, ranks=2).stdout.count("no mistakes"), 1)
        result = self.expect(2, "check", TINY, "--set", "/bow/stem_deg=95", ranks=2)
        self.assertEqual(result.stderr.count("allowed 5 to 85 deg"), 1)
        self.assertEqual(self.expect(2, "check", TINY, "--jsn", ranks=2).stderr.count("unknown option"), 1)
        result = self.expect(2, "simulate", TINY, "--out", self.directory, "--set", "/bow/stem_deg=95", ranks=2)
        self.assertEqual(result.stderr.count("allowed 5 to 85 deg"), 1)


class HullAndResistance(ProgramTest):
    def test_hull_as_json(self):
        hull = json.loads(self.expect(0, "hull", TINY, "--json").stdout)
        self.assertEqual(hull["design"], "baseline")
        self.assertTrue(hull["feasible"])
        for angle, degrees in (("stem", 24.35), ("waterline", 22), ("buttock", 28), ("flare", 33)):
            self.assertAlmostEqual(hull["requested_deg"][angle], degrees, places=9)
            self.assertAlmostEqual(hull["measured_deg"][angle], degrees, delta=0.5)
        self.assertAlmostEqual(hull["margins"]["g1"], 8.73, delta=0.01)
        self.assertEqual(set(hull["margins"]), set(hull["margin_sentences"]))
        mesh = hull["mesh"]
        self.assertTrue(mesh["closed"] and mesh["outward"] and not mesh["self_intersecting"])
        self.assertTrue(0.5 < mesh["volume_m3"] / (147.2 * 23 * 13.5) < 1.0)

    def test_design_and_set(self):
        for design in ("Steep stem", "2"):
            hull = json.loads(self.expect(0, "hull", TINY, "--json", "--design", design).stdout)
            self.assertEqual((hull["design"], round(hull["requested_deg"]["stem"], 9)), ("Steep stem", 27.0))
        hull = json.loads(self.expect(0, "hull", TINY, "--json", "--design=2", "--set", "/bow/stem_deg=26").stdout)
        self.assertAlmostEqual(hull["requested_deg"]["stem"], 26)
        result = self.expect(2, "hull", TINY, "--design", "Steep sten")
        self.assertIn('"Steep stem"', result.stderr)
        self.expect(2, "hull", TINY, "--design", "3")

    def test_hydrostatics(self):
        hull = json.loads(self.expect(0, "hull", TINY, "--json", "--hydrostatics").stdout)
        water = hull["hydrostatics"]
        self.assertAlmostEqual(water["draft_m"], 8)
        self.assertAlmostEqual(water["length_m"], 147.2, delta=1e-6)
        self.assertAlmostEqual(water["TCB_m"], 0, delta=1e-9)
        self.assertLess(water["volume_m3"], hull["mesh"]["volume_m3"])
        deeper = json.loads(self.expect(0, "hull", TINY, "--json", "--hydrostatics", "--draft", "9", "--trim=0.5").stdout)
        self.assertAlmostEqual(deeper["hydrostatics"]["draft_m"], 9)
        self.assertGreater(deeper["hydrostatics"]["volume_m3"], water["volume_m3"])
        self.assertLess(deeper["hydrostatics"]["LCB_m"], water["LCB_m"])
        self.assertIn("KM_T", self.expect(0, "hull", TINY, "--hydrostatics").stdout)
        self.assertIn("13.5", self.expect(2, "hull", TINY, "--hydrostatics", "--draft", "20").stderr)
        self.assertIn("--hydrostatics", self.expect(2, "hull", TINY, "--draft", "7").stderr)

    def test_measure_our_own_hull(self):
        for ending in (".obj", ".stl", ".ply"):
            path = self.directory / f"hull{ending}"
            hull = json.loads(self.expect(0, "hull", TINY, "--json", "--hydrostatics", "--out", path).stdout)
            found = json.loads(self.expect(0, "measure", path, "--json", "--density", "1025").stdout)
            for angle in ("stem", "waterline", "buttock", "flare"):
                self.assertAlmostEqual(found["angles_deg"][angle], hull["requested_deg"][angle], delta=0.05)
            self.assertAlmostEqual(found["dimensions"]["draft_m"], 8, delta=1e-5)
            self.assertAlmostEqual(found["hydrostatics"]["volume_m3"] / hull["hydrostatics"]["volume_m3"], 1, delta=1e-6)
        self.assertIn("P1", self.expect(0, "measure", path).stdout)
        self.assertIn("mm", self.expect(2, "measure", path, "--unit", "yard").stderr)
        self.assertIn("-z,y", self.expect(2, "measure", path, "--axes", "x,x").stderr)
        self.assertIn("does not cut", self.expect(2, "measure", path, "--waterline", "100").stderr)
        lines = (self.directory / "hull.obj").read_text().splitlines()
        (self.directory / "open.obj").write_text("\n".join(lines[:-1]))
        self.assertIn("filled", self.expect(0, "measure", self.directory / "open.obj").stdout)

    def test_a_hull_of_the_users_own(self):
        study, mesh = STUDIES / "own_hull.json", STUDIES / "hulls/supply_vessel.obj"
        found = json.loads(self.expect(0, "measure", mesh, "--axes", "-x,z", "--waterline", "6.5", "--mirror", "--json").stdout)
        self.assertTrue(any("mirrored" in words for words in found["repairs"]))
        self.assertAlmostEqual(found["dimensions"]["waterline_beam_m"], 18, delta=1e-6)
        self.assertIn("--mirror", self.expect(2, "measure", mesh, "--axes", "-x,z", "--waterline", "6.5").stderr)
        self.assertIn("repaired", self.expect(0, "measure", mesh, "--axes", "-x,z", "--waterline", "6.5", "--mirror").stdout)
        hull = json.loads(self.expect(0, "hull", study, "--json", "--hydrostatics").stdout)
        for angle in ("stem", "waterline", "buttock", "flare"):
            self.assertIsNone(hull["requested_deg"][angle])
            self.assertAlmostEqual(hull["measured_deg"][angle], found["angles_deg"][angle], delta=1e-9)
        self.assertAlmostEqual(hull["hydrostatics"]["draft_m"], 6.5, delta=1e-9)
        lower = json.loads(self.expect(0, "hull", study, "--design", "Lower stem", "--json").stdout)
        self.assertAlmostEqual(lower["measured_deg"]["stem"], 24, delta=0.05)
        explained = json.loads(self.expect(0, "hull", study, "--explain", "--json").stdout)["explanation"]
        self.assertAlmostEqual(explained["fsicr_deg"]["phi_1"], found["angles_deg"]["stem"], delta=1e-9)
        self.assertFalse(any("family" in limit["whose"] for limit in explained["limits"]))  # it is of none
        self.assertEqual(hull["shell"], found["shell"])
        self.assertAlmostEqual(sum(hull["shell"][k] for k in ("flat_share", "single_curved_share",
                                                              "double_curved_share")), 1, delta=1e-9)
        self.assertIn("no mistakes", self.expect(0, "check", study).stdout)
        self.assertIn("/hull/file", self.expect(2, "check", study, "--set", "/hull/file=none.obj").stderr)

    def test_explanation(self):
        hull = json.loads(self.expect(0, "hull", TINY, "--json", "--explain").stdout)["explanation"]
        # By hand: atan(tan 24.35 / sin 22), and at P1 tan(waterline) = tan 33 tan 28.
        self.assertAlmostEqual(hull["lindqvist_psi_deg"]["P0"], 50.384, delta=0.001)
        self.assertAlmostEqual(hull["fsicr_deg"]["alpha"], 19.05, delta=0.01)
        self.assertAlmostEqual(hull["fsicr_deg"]["psi"], 58.46, delta=0.01)
        self.assertAlmostEqual(hull["ur_i2_deg"]["P1"]["beta"], 33, delta=1e-9)
        self.assertAlmostEqual(hull["ur_i2_deg"]["P1"]["beta_normal"], 31.54, delta=0.01)
        verdicts = {(limit["whose"], limit["angle"]): limit["verdict"] for limit in hull["limits"]}
        self.assertEqual(verdicts["usual for the family", "stem"], "inside")
        self.assertIn("below by 0.65", verdicts["FSICR engine power", "phi_1"])
        self.assertIn("normal frame angle", self.expect(0, "hull", TINY, "--explain").stdout)

    def test_hull_files(self):
        for ending, head in ((".obj", b""), (".stl", b""), (".ply", b"ply"), (".vtp", b"<"), (".svg", b"<")):
            path = self.directory / f"hull{ending}"
            self.expect(0, "hull", TINY, "--out", path)
            self.assertTrue(path.read_bytes().startswith(head) and path.stat().st_size > 1000, path)
        self.assertIn(".obj", self.expect(2, "hull", TINY, "--out", self.directory / "hull.dxf").stderr)
        missing = self.directory / "missing/hull.obj"
        self.assertIn(str(missing), self.expect(1, "hull", TINY, "--out", missing).stderr)

    def test_cad_files_or_why_there_are_none(self):
        for ending, head in ((".step", b"ISO-10303-21"), (".stp", b"ISO-10303-21"), (".igs", b" "), (".iges", b" ")):
            path = self.directory / f"hull{ending}"
            process = subprocess.run([PROGRAM, "hull", TINY, "--json", "--out", path], capture_output=True, text=True)
            if process.returncode == 2:
                self.assertIn("libocct-data-exchange-dev", process.stderr)
                continue
            self.assertEqual(process.returncode, 0, process.stderr)
            json.loads(process.stdout)  # the CAD library says nothing there
            self.assertTrue(path.read_bytes().startswith(head) and path.stat().st_size > 50000, path)

    def test_lines_plan_as_pdf(self):
        path = self.directory / "lines.pdf"
        process = subprocess.run([PROGRAM, "hull", TINY, "--out", path], capture_output=True, text=True)
        if process.returncode == 2:
            self.assertIn("librsvg2-dev", process.stderr)
            self.skipTest("built without PDF")
        self.assertEqual(process.returncode, 0, process.stderr)
        if not shutil.which("pdftotext") or not shutil.which("pdfimages"):
            self.skipTest("pdftotext and pdfimages (poppler-utils) are not installed: the page is not looked at")
        words = subprocess.run(["pdftotext", "-layout", path, "-"], capture_output=True, text=True, check=True).stdout
        for word in ("Half-breadth plan", "stem 24.35", "B/4, DWL"):
            self.assertIn(word, words)
        images = subprocess.run(["pdfimages", "-list", path], capture_output=True, text=True, check=True).stdout
        self.assertEqual(len(images.splitlines()), 2, images)  # its heading alone: vectors, no picture
        subprocess.run(["pdftoppm", "-r", "48", path, self.directory / "page"], check=True)
        page = next(self.directory.glob("page*.ppm")).read_bytes()
        colours = {page[k:k + 3] for k in range(len(page) % 3, len(page), 3)}
        self.assertGreater(len(colours), 50)  # lines and letters, smoothed

    def test_two_hulls_in_one_plan(self):
        path = self.directory / "both.svg"
        for other, name in (("Steep stem", "Steep stem"), ("high_flare", "preset of high_flare"), (TINY, "Tiny")):
            self.expect(0, "hull", TINY, "--overlay", other, "--out", path)
            self.assertIn(f"and {name}</title>", path.read_text())
        self.assertIn("lines plan", self.expect(2, "hull", TINY, "--overlay", "flat").stderr)
        stranger = self.expect(2, "hull", TINY, "--overlay", "flt", "--out", path).stderr
        self.assertIn("--overlay flt", stranger)
        self.assertIn("Steep stem", stranger)

    def test_an_infeasible_bow(self):
        path = self.directory / "no.obj"
        result = self.expect(1, "hull", TINY, "--json", "--set", INFEASIBLE, "--out", path)
        hull = json.loads(result.stdout)
        self.assertFalse(hull["feasible"])
        self.assertLess(hull["margins"]["g1"], 0)
        self.assertIsNone(hull["mesh"])
        self.assertTrue(hull["reason"])
        self.assertIn(hull["reason"], result.stderr)
        self.assertFalse(path.exists())
        self.assertIn("VIOLATED", self.expect(1, "hull", TINY, "--set", INFEASIBLE).stdout)

    def test_cycle(self):
        one = json.loads(self.expect(0, "cycle", STUDIES / "cycle_sweep.json", "--json", "--set",
                                     "/cycle/voyages=1", "--set", "/cycle/voyage_m=60").stdout)
        for key in ("mean_load_N", "mean_load_ci95_N", "crushing_N", "bending_N", "friction_N", "submersion_N",
                    "breaking_length_m", "channel_width_m"):
            self.assertGreater(one[key], 0.0, key)
        self.assertIn("pieces", self.expect(0, "cycle", STUDIES / "cycle_sweep.json").stdout)
        refused = self.expect(2, "cycle", TINY, "--set", "/cycle/breaking=guess").stderr
        self.assertIn("/cycle/breaking", refused)

    def test_resistance(self):
        text = self.expect(0, "resistance", TINY, "--json", "--set", "/ice/thickness_m=1",
                           "--set", "/operation={\"speed_m_s\": 2.058, \"advance_m\": 8}").stdout
        r = json.loads(text)["lindqvist"]
        speed = 1 + 1.4 * 2.058 / (9.81 * 1.0) ** 0.5
        self.assertAlmostEqual(r["breaking_N"] / ((r["crushing_N"] + r["bending_N"]) * speed), 1, places=12)
        self.assertTrue(r["valid"])
        self.assertEqual(r["inputs"]["L_m"], 147.2)
        self.assertAlmostEqual(r["inputs"]["stem_deg"], 24.35)
        # formulas.json of the theory: 1.2943 m2 x strength at friction 0.10 for the published case.
        paper = json.loads(self.expect(0, "resistance", STUDIES / "paper_conventional.json", "--json",
                                       "--set", "/operation={\"speed_m_s\": 2.058}").stdout)["lindqvist"]
        self.assertAlmostEqual(paper["breaking_N"] / paper["inputs"]["sigma_f_Pa"], 1.2943, delta=2e-4)
        self.assertAlmostEqual(paper["breaking_N"] / 1.1175e6, 1, delta=2e-3)
        self.assertIn("crushing", self.expect(0, "resistance", TINY).stdout)

    def test_the_channel_rule_sees_the_ships_own_waterline(self):
        said = json.loads(self.expect(0, "resistance", STUDIES / "paper_conventional.json", "--json").stdout)
        channel, bow = said["fsicr_channel"], said["lindqvist"]["inputs"]
        self.assertTrue(channel["valid"])
        # A waterline of 22 deg: more area than the triangle of its half beam, less than the whole rectangle.
        self.assertGreater(channel["foreship_waterline_area_m2"], 0.5 * channel["foreship_m"] * bow["B_m"])
        self.assertLess(channel["foreship_waterline_area_m2"], channel["foreship_m"] * bow["B_m"])
        load = [channel["classes"][name]["resistance_N"] for name in ("IA Super", "IA", "IB", "IC")]
        self.assertEqual(load, sorted(load, reverse=True))
        self.assertIn("stem angle, deg is 24.35, the rule was validated from 25 to 90", channel["caution"])
        self.assertIn("a channel of brash ice at 5 kn", self.expect(0, "resistance", STUDIES / "paper_conventional.json").stdout)

    def test_a_number_as_text_is_written_as_json_has_it(self):
        for wrong, right in ((".77", "0.77"), ("-.5", "-0.5"), ("1.", "1.0"), ("+3", "3"), ("0,8", "0.8"), ("1.e5", "1.0e5")):
            said = self.expect(2, "check", TINY, "--set", f"/ice/thickness_m={wrong}").stderr
            self.assertIn(f"(write {right})", said)
            json.loads(right)


class Stored(ProgramTest):
    """What a study directory says afterwards, of an optimiser's designs too."""

    def setUp(self):
        super().setUp()
        study = json.loads(TINY.read_text())
        study["evaluators"], study["ranking"] = ["lindqvist"], {"by": "lindqvist_breaking"}
        study["method"] = {"type": "optimise", "max_evaluations": 8,
                           "variables": {"/bow/stem_deg": {"min": 22, "max": 27}, "/bow/flare_deg": {"min": 30, "max": 35}}}
        self.study, self.out = self.directory / "study.json", self.directory / "out"
        self.study.write_text(json.dumps(study))
        self.expect(0, "run", self.study, "--out", self.out)

    def test_an_optimisers_design_is_taken_up_again(self):
        card = json.loads(self.expect(0, "show", self.out, "d003", "--json").stdout)
        self.assertEqual((card["status"], card["notes"]), ("ok", []))
        stem = card["parameters"]["/bow/stem_deg"]
        self.assertEqual(card["document"]["bow"]["stem_deg"], stem)
        self.assertIsNone(card["directory"])  # the formula alone has no files
        for command in ("hull", "resistance", "cycle"):
            said = json.loads(self.expect(0, command, self.out, "--design", "d003", "--json").stdout)
            self.assertEqual(said["design"], "d003")
        said = json.loads(self.expect(0, "resistance", self.out, "--design", "d003", "--json").stdout)
        self.assertEqual(said["lindqvist"]["breaking_N"], card["result"]["lindqvist"]["breaking_N"])
        self.assertEqual(card["value"], said["lindqvist"]["breaking_N"])
        self.assertEqual(card["commands"]["again"], f"icebow resistance {self.out} --design d003")
        again = json.loads(self.expect(0, *card["commands"]["again"].split()[1:], "--json").stdout)
        self.assertEqual((again["design"], again["lindqvist"]), ("d003", said["lindqvist"]))
        hull = json.loads(self.expect(0, "hull", self.out, "--design", "d003", "--json", "--set", "/bow/flare_deg=33").stdout)
        self.assertAlmostEqual(hull["requested_deg"]["stem"], stem)
        self.assertAlmostEqual(hull["requested_deg"]["flare"], 33)
        self.assertIn("no mistakes", self.expect(0, "check", self.out).stdout)
        self.assertIn(f"  /bow/stem_deg {stem:.6g}\n  feasible\n", self.expect(0, "check", self.out, "--design", "d003").stdout)
        self.assertIn("holds no study", self.expect(2, "hull", self.directory).stderr)
        self.assertIn("d003", self.expect(0, "show", self.out, "d003").stdout)
        self.assertIn("d003", self.expect(2, "show", self.out, "d03").stderr)
        self.assertIn("DESIGN is missing", self.expect(2, "show", self.out).stderr)
        self.assertIn("no such design", self.expect(2, "hull", self.out, "--design", "d099").stderr)

    def test_a_voyage_of_a_race_is_reproduced_as_far_as_it_was_sailed(self):
        study = json.loads(TINY.read_text())
        study.update(sheet={"length_m": 46, "width_m": 30, "window_ahead_m": 12}, designs=[],
                     operation={"speed_kn": 6, "advance_m": 8, "steady_from_m": 1}, include_baseline=False,
                     decide={"best_within": 0.001, "longest_m": 12},
                     method={"type": "grid", "variables": {"/bow/stem_deg": {"values": [24, 25]}}})
        self.study.write_text(json.dumps(study))
        race, again = self.directory / "race", self.directory / "again"
        self.expect(0, "run", self.study, "--out", race)
        self.assertEqual(json.loads((race / "designs/d001/result.json").read_text())["sailed_to_m"], 12)
        self.expect(0, "simulate", race, "--design", "d001", "--out", again)
        self.assertEqual((again / "history.csv").read_bytes(), (race / "designs/d001/history.csv").read_bytes())
        self.assertFalse((again / "checkpoint.h5").exists())
        self.assertIn("Not decided", self.expect(0, "rank", race).stdout)

    def test_a_design_by_a_program_or_over_scenarios_is_evaluated_again_as_it_was(self):
        study = json.loads(self.study.read_text())
        study.update(designs=[], ranking={"by": "/programs/yard/load_N"}, method={"type": "grid", "variables":
                     {"/bow/stem_deg": {"values": [23, 26]}}}, evaluators=["lindqvist", {"name": "yard", "command": ["sh", "-c",
                     "sed -n 's/.*\"stem_deg\":\\([0-9.]*\\).*/{\"load_N\": \\1}/p'"]}],
                     scenarios=[{"name": "thin", "set": {"ice": {"thickness_m": 1.5}}}, {"name": "thick", "set": {"ice": {"thickness_m": 2.5}}}])
        for by in ("/programs/yard/load_N", "lindqvist_breaking"):
            study["ranking"]["by"] = by
            self.study.write_text(json.dumps(study))
            out, again = self.directory / "several", self.directory / "again"
            self.expect(0, "run", self.study, "--out", out)
            card = json.loads(self.expect(0, "show", out, "d002", "--json").stdout)
            self.assertEqual(card["commands"]["again"], f"icebow run {out} --design d002 --out again")
            words = card["commands"]["again"].replace("--out again", f"--out {again}").split()[1:]
            alone = json.loads(self.expect(0, *words, "--json").stdout)["designs"]
            self.assertEqual(len(alone), 1)
            self.assertIn("another directory", self.expect(2, "run", out, "--design", "d002", "--out", out).stderr)
            self.assertEqual(alone[0]["lindqvist_breaking_N"], card["result"]["lindqvist"]["breaking_N"])
            self.assertEqual(json.loads(self.expect(0, "show", again, "baseline", "--json").stdout)["value"], card["value"])
            finer = shlex.split(card["commands"]["finer"].replace("--out finer", f"--out {self.directory / 'finer'}"))
            self.expect(0, *finer[1:])

    def test_a_design_of_another_study_file_is_said_to_be_that(self):
        study = json.loads(self.study.read_text())
        study["ice"]["thickness_m"] *= 1.25
        study["method"] = {"type": "list"}
        self.study.write_text(json.dumps(study))
        self.expect(0, "run", self.study, "--out", self.out)
        self.assertIn("no design", self.expect(2, "show", self.out, "d003").stderr)
        self.assertEqual(json.loads(self.expect(0, "status", self.out, "--json").stdout)["designs"], 2)

    def test_status(self):
        status = json.loads(self.expect(0, "status", self.out, "--json").stdout)
        self.assertEqual((status["state"], status["failed"], status["running"]), ("finished", 0, []))
        self.assertEqual(status["designs"], status["ok"] + status["infeasible"])
        self.assertIn(f"best so far by lindqvist_breaking: {status['best']}", self.expect(0, "status", self.out).stdout)
        subprocess.run([sys.executable, "-c", "import sqlite3, sys; sqlite3.connect(sys.argv[1]).executescript("
                        "\"UPDATE facts SET value = 'running', digest = NULL WHERE name = 'state'\")",
                        self.out / "results.sqlite"], check=True)
        self.assertIn("damaged", self.expect(1, "status", self.out).stderr)
        self.assertIn(str(self.directory), self.expect(2, "status", self.directory).stderr)

    def test_watch_says_what_status_says_and_ends_with_the_study(self):
        status = self.expect(0, "status", self.out).stdout
        self.assertEqual(self.expect(0, "watch", self.out).stdout, status)
        self.assertEqual(self.expect(0, "watch", self.out, "--once").stdout, status)
        self.assertIn("0.1 to 3600", self.expect(2, "watch", self.out, "--seconds", "0").stderr)
        self.assertIn(str(self.directory), self.expect(2, "watch", self.directory).stderr)

    def test_all_numbers_as_csv_and_json(self):
        table = json.loads(self.expect(0, "export", self.out, "--json").stdout)
        rows = list(csv.DictReader(io.StringIO(self.expect(0, "export", self.out, "--csv").stdout)))
        self.assertEqual([row["design"] for row in rows], [row["design"] for row in table])
        for row, whole in zip(rows, table):
            self.assertEqual(float(row["/bow/stem_deg"]), whole["parameters"]["/bow/stem_deg"])
            if whole["status"] == "ok":
                self.assertEqual(float(row["result:/lindqvist/total_N"]), whole["result"]["lindqvist"]["total_N"])
        self.assertIn("keep one", self.expect(2, "export", self.out, "--csv", "--json").stderr)
        whole = self.directory / "whole.h5"
        self.assertEqual(self.expect(0, "export", self.out, "--hdf5", whole).stdout, f"{whole}\n")
        self.assertEqual(whole.read_bytes()[:4], b"\x89HDF")
        self.assertIn("no/such.h5", self.expect(1, "export", self.out, "--hdf5", self.directory / "no/such.h5").stderr)
        choice = {"type": "grid", "variables": {"/bow/family": {"values": ["straight_parallel_buttocks", "concave"]}}}
        other = self.directory / "families"
        self.expect(0, "run", self.study, "--out", other, "--set", f"/method={json.dumps(choice)}")
        rows = list(csv.DictReader(io.StringIO(self.expect(0, "export", other).stdout)))
        self.assertEqual({row["design"]: row["choice:/bow/family"] for row in rows}["d002"], "concave")
        self.assertIn("/bow/family concave", self.expect(0, "show", other, "d002").stdout)
        choice["variables"]["/bow/stem_deg"] = {"values": [23, 26]}
        self.expect(0, "run", self.study, "--out", other, "--set", f"/method={json.dumps(choice)}")
        same = json.loads(self.expect(0, "diff", other, other, "--json").stdout)["designs"]
        self.assertEqual(len(same), 6)  # baseline, the named one, and four points, two of which share their numbers
        self.assertTrue(all(d["first"] == d["second"] for d in same))

    def test_what_two_studies_have_in_common(self):
        other = self.directory / "other"
        thicker = 1.25 * json.loads(TINY.read_text())["ice"]["thickness_m"]
        self.expect(0, "run", self.study, "--out", other, "--set", f"/ice/thickness_m={thicker}",
                    "--set", "/method={\"type\": \"list\"}")
        diff = json.loads(self.expect(0, "diff", self.out, other, "--json").stdout)
        changed = {d["at"]: d for d in diff["study"]}
        self.assertEqual(changed["/ice/thickness_m"]["second"], thicker)
        both = {d["first"]["design"]: d for d in diff["designs"]}
        self.assertEqual(set(both), {"baseline", "Steep stem"})
        self.assertGreater(both["baseline"]["ratio"], 1.0)  # thicker ice
        self.assertIn("d001", diff["only_first"])
        self.assertIn("only in", self.expect(0, "diff", self.out, other).stdout)
        self.expect(0, "run", self.study, "--out", other, "--set", '/evaluators=["lindqvist", "cycle"]', "--set", "/ranking/by=cycle_load",
                    "--set", "/method={\"type\": \"list\"}")
        unlike = json.loads(self.expect(0, "diff", self.out, other, "--json").stdout)
        self.assertEqual({d["ratio"] for d in unlike["designs"]}, {None})
        self.assertIn("unlike numbers", self.expect(0, "diff", self.out, other).stdout)
        same = json.loads(self.expect(0, "diff", self.out, self.out, "--json").stdout)
        self.assertEqual((same["study"], same["only_first"]), ([], []))
        self.assertEqual({d["ratio"] for d in same["designs"] if d["ratio"]}, {1.0})


if __name__ == "__main__":
    unittest.main()

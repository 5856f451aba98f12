"""What the campaigns share: a tiny study, the program, and what of a study must not change whatever befalls it."""
import argparse
import json
import os
import pathlib
import re
import shutil
import sqlite3
import subprocess
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
       "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1",
       "OMPI_MCA_btl_base_warn_component_unused": "0", "OPENTURNS_NUM_THREADS": "1", "NO_COLOR": "1"}
PATIENCE = float(os.environ.get("ICEBOW_TEST_PATIENCE", 1))  # more under sanitizers
# Measured, not computed: no two runs have the same.
TIMES = {"wall_s", "output_s", "ns_per_bond", "profile", "provenance", "notes", "core_hours"}


def options(description, **defaults):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", default=str(ROOT / "build/release/icebow"))
    parser.add_argument("--seed", type=int, default=1, help="of the random moments and places")
    parser.add_argument("--short", action="store_true", help="a handful of each, as the tests run it")
    for name, value in defaults.items():
        parser.add_argument("--" + name, type=int, default=value, help=f"default: {value}")
    chosen = parser.parse_args()
    chosen.program = str(pathlib.Path(chosen.program).resolve())
    if not os.access(chosen.program, os.X_OK):
        parser.error(f"{chosen.program} is no program: build it, or give --program")
    return chosen


SLOW = {"layers": 2, "time_step_fraction": 0.15}  # a run of some seconds, for what must be caught under way


def study(**patch):
    document = json.loads((ROOT / "tests/cli/tiny.json").read_text())
    document["output"] = {"pictures": 1, "snapshots": 1}
    document.update(patch)
    return document


class Place:
    """A directory of its own, with a cache of its own, gone at the end."""

    def __init__(self, program):
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="icebow_campaign_"))
        self.program = program

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.path, ignore_errors=True)

    def write(self, name, document):
        file = self.path / name
        file.write_text(json.dumps(document))
        return file

    def environment(self, **extra):
        return {**os.environ, **MPI, "XDG_CACHE_HOME": str(self.path / "cache"), **extra}

    def start(self, *words, ranks=0, extra=None, **popen):
        launcher = ["mpirun", "-n", str(ranks)] if ranks else []
        return subprocess.Popen([*launcher, self.program, *map(str, words)], env=self.environment(**(extra or {})),
                                text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
                                **popen)

    def run(self, *words, timeout=300, **start):
        process = self.start(*words, **start)
        try:
            out, err = process.communicate(timeout=PATIENCE * timeout)
        except subprocess.TimeoutExpired:
            process.terminate()  # mpirun ends its ranks, which are in groups of their own
            time.sleep(3)
            os.killpg(process.pid, 9)
            process.communicate()
            return subprocess.CompletedProcess(words, None, "", f"no answer in {timeout} s")
        return subprocess.CompletedProcess(words, process.returncode, out, err)


def end_at(process, seconds, number):
    """Sends the signal to a process of Place.start after so many seconds. Whether it fell while the process was under
    way, and the exit code: None where the process went on for a minute and was killed with its children."""
    try:
        process.communicate(timeout=seconds)
        return False, process.returncode
    except subprocess.TimeoutExpired:
        process.send_signal(number)
    try:
        process.communicate(timeout=PATIENCE * 60)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        process.communicate()
        return True, None
    return True, process.returncode


def lasting(value):
    """A result without what was measured in time."""
    if isinstance(value, dict):
        return {key: lasting(inner) for key, inner in value.items() if key not in TIMES}
    return [lasting(inner) for inner in value] if isinstance(value, list) else value


def rows_of(directory):
    """The store's rows in the study's order, without times; what a study must come to whatever befell it."""
    database = sqlite3.connect(f"file:{directory}/results.sqlite?mode=ro", uri=True)
    rows = database.execute("SELECT e.key, e.name, e.status, e.reason, e.parameters, e.result FROM evaluations e "
                            "JOIN study s ON s.key = e.key ORDER BY s.position").fetchall()
    database.close()
    return [(*row[:4], json.loads(row[4]), lasting(json.loads(row[5]))) for row in rows]


def histories_of(directory):
    return {str(file.relative_to(directory)): file.read_bytes()
            for file in sorted(pathlib.Path(directory).rglob("history.csv"))}


def outcome_of(place, directory):
    ranking = place.run("rank", directory, "--json")
    return rows_of(directory), histories_of(directory), lasting(json.loads(ranking.stdout)) if ranking.returncode == 0 else None


def without_words_of_mpirun(text):
    """What mpirun says of a program that ended with an error stands between two lines of hyphens."""
    return re.sub(r"^-{60,}\n.*?^-{60,}\n", "", text, flags=re.DOTALL | re.MULTILINE)


def is_one_sentence(text):
    """A message of a few lines, without a stack trace; how far the run was stands there too, often where it is slow."""
    text = without_words_of_mpirun(text)
    lines = [line for line in text.splitlines() if line.strip() and not re.search(r" \d+ % .* eta ", line)]
    banned = ("terminate called", "what():", "Segmentation", "AddressSanitizer", "runtime error", "json.exception", "std::bad_alloc",
              "*** An error occurred in MPI", "*** Process received signal")
    return 0 < len(lines) <= 6 and len(text) < 2500 and not any(word in text for word in banned)

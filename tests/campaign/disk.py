#!/usr/bin/env python3
"""Every file that the program writes, on a disk that is full (ENOSPC), over a quota (EDQUOT, EFBIG) or broken (EIO), at
the first, the second and the last byte. A study must stop with a sentence, no design may be called a failure, and the
same command must go on to the same result once the disk is well. Then places that do not suit: read-only, foreign,
removed and unlocked directories, no HOME, TMPDIR or cache, a clock set back, no mpirun, few files, little memory.
With --ranks the study alone, embedded in a job of so many ranks."""
import errno
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import time

import common

ERRORS = {"ENOSPC": errno.ENOSPC, "EDQUOT": errno.EDQUOT, "EIO": errno.EIO, "EFBIG": errno.EFBIG}
# What a study goes on without: words for a message, logs of a child, a cache.
OPTIONAL = ("results.sqlite.lock", "log.txt", "cache")
OF_A_STUDY = ("study.json", "results.sqlite", "results.sqlite-wal", "design.json", "hull.obj", "lines.svg",
              "history.csv", "ice_000.png", "ice_0000", "ice.pvd", "hull.vtp", "hull_pressure", "checkpoint.h5",
              "result.json", "evaluation.json", "ranking.csv", "ranking.md", "report.html", *OPTIONAL[:2])
OF_A_HULL = ("hull.obj", "hull.stl", "hull.ply", "hull.vtp", "hull.svg", "hull.pdf", "hull.step", "hull.igs")
OFTEN = {"ICEBOW_CHECKPOINT_SECONDS": "0.05"}


def shim(place):
    library = place.path / "fault.so"
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-o", library, common.HERE / "fault.c", "-ldl"], check=True)
    return str(library)


def sizes_of(directory):
    """The last byte of each file of a study that ended well."""
    sizes = {}
    for file in pathlib.Path(directory).rglob("*"):
        if file.is_file():
            sizes[file.name] = max(sizes.get(file.name, 0), file.stat().st_size)
    return sizes


def limited(kind, value):
    """For a process that is to have no more of a resource."""
    return lambda: resource.setrlimit(kind, (value, value))


def size_of(name, sizes):
    return max([size for file, size in sizes.items() if file.startswith(name)] or [4096])


class Campaign:
    def __init__(self, place, short):
        self.place, self.short, self.faults, self.tried = place, short, [], 0
        self.library = shim(place)

    def note(self, what, words):
        self.faults.append(f"{what}: {words}")
        print(f"fault: {self.faults[-1]}", flush=True)

    def failing(self, name, error, most):
        return {**OFTEN, "LD_PRELOAD": self.library, "ICEBOW_FAULT": f"{name} {error} {most}"}

    def positions(self, size):
        return (0,) if self.short else (0, 1, max(2, size - 1))

    def study(self, ranks):
        place = self.place
        path = place.write("study.json", common.study(output={"pictures": 1, "snapshots": 1}))
        whole = place.path / f"whole{ranks}"
        place.run("run", path, "--out", whole, ranks=ranks, extra=OFTEN)
        expected, sizes = common.outcome_of(place, whole), sizes_of(whole)
        stopped = went_on = 0
        for name in OF_A_STUDY[::3] if self.short else OF_A_STUDY:
            for label, error in list(ERRORS.items())[:1 if self.short else None]:
                for most in self.positions(size_of(name, sizes)):
                    fell = self.one_study(path, name, label, error, most, ranks, expected)
                    stopped, went_on = stopped + fell, went_on + (not fell)
        print(f"study, {ranks or 1} ranks: {stopped} stopped by the disk and resumed, {went_on} not touched by it; "
              f"{len(self.faults)} faults so far",
              flush=True)

    def one_study(self, path, name, label, error, most, ranks, expected):
        place, out, what = self.place, self.place.path / "out", f"{name}, {label} after {most} bytes, {ranks} ranks"
        shutil.rmtree(out, ignore_errors=True)
        result = place.run("run", path, "--out", out, ranks=ranks, extra=self.failing(name, error, most))
        fell = result.returncode != 0
        if fell and (result.returncode not in (1, 2) or not common.is_one_sentence(result.stderr)):
            self.note(what, f"exit {result.returncode}: {result.stderr[-400:]}")
        again = place.run("run", path, "--out", out, ranks=ranks)
        if again.returncode != 0:
            self.note(what, f"does not go on: exit {again.returncode}: {again.stderr[-400:]}")
        elif common.outcome_of(place, out) != expected:
            self.note(what, "goes on to another result")
        return fell

    def hulls(self):
        told = 0
        study = common.ROOT / "tests/cli/tiny.json"
        for name in OF_A_HULL[::3] if self.short else OF_A_HULL:
            file = self.place.path / name
            if self.place.run("hull", study, "--out", file).returncode == 2:
                continue  # built without that format
            size = file.stat().st_size
            for label, error in list(ERRORS.items())[:1 if self.short else None]:
                for most in (0, size - 1) if self.short else self.positions(size):
                    file.unlink(missing_ok=True)
                    result = self.place.run("hull", study, "--out", file, extra=self.failing(name, error, most))
                    whole = file.exists() and file.stat().st_size >= size - 200
                    if result.returncode == 1 and common.is_one_sentence(result.stderr) and not whole:
                        told += 1
                    elif not (result.returncode == 0 and whole):
                        self.note(f"{name}, {label} after {most}",
                                  f"exit {result.returncode}: {result.stderr[-300:]}")
        print(f"hull files: {told} failures told", flush=True)

    def two_runs(self, path):
        """Where flock(2) is not known, a second run is refused all the same."""
        out, without = self.place.path / "unlocked", {"LD_PRELOAD": self.library, "ICEBOW_FAULT": "flock 38 0"}
        process = self.place.start("run", path, "--out", out, extra=without)
        while process.poll() is None and not (out / "designs/baseline/log.txt").exists():
            time.sleep(0.01)
        self.expect("a second run where flock fails", (1,), self.place.run("run", path, "--out", out, extra=without),
                    "another icebow run")
        _, err = process.communicate(timeout=common.PATIENCE * 120)
        self.expect("a run where flock fails", (0,), subprocess.CompletedProcess((), process.returncode, "", err))

    def expect(self, what, codes, result, word=""):
        self.tried += 1
        if result.returncode not in codes or (word and word not in result.stderr + result.stdout) or (
                result.returncode and not common.is_one_sentence(result.stderr)):
            self.note(what, f"exit {result.returncode}: {result.stderr[-400:]}")

    def places(self):
        place = self.place
        path = place.write("p.json", common.study(evaluators=["lindqvist"], ranking={"by": "lindqvist_breaking"}))
        simulated = place.write("sim.json", common.study(designs=[], solver=common.SLOW))
        good = place.path / "good"
        place.run("run", path, "--out", good)
        expected = place.run("rank", good, "--json").stdout

        def run_in(directory, **more):
            return place.run("run", path, "--out", directory, **more)

        # Where root may write anywhere, what no one may write stands for a read-only directory.
        self.expect("a directory that cannot be written", (1,), run_in("/proc/1/icebow"), "/proc/1")
        self.expect("a file in the place of a directory", (1,), run_in(path))
        foreign = place.path / "foreign"
        foreign.mkdir()
        (foreign / "study.json").write_text("mine")
        self.expect("a directory of somebody else's", (2,), run_in(foreign), "study.json")
        (foreign / "results.sqlite").write_text("mine" * 1000)
        self.expect("a store of somebody else's", (1,), run_in(foreign), "results.sqlite")
        self.two_runs(simulated)
        for gone in ("HOME", "TMPDIR", "XDG_CACHE_HOME"):
            self.expect(f"{gone} is a place that is not there", (0,),
                        run_in(place.path / f"no_{gone}", extra={gone: "/no/such/place"}))
        self.expect("no mpirun", (1,), place.run(
            "run", place.write("two.json", common.study(designs=[], execution={"ranks_per_design": 2})), "--out",
            place.path / "no_mpirun", extra={"PATH": "/no/such/place"}), "mpirun")
        process = place.start("run", simulated, "--out", place.path / "removed")
        while process.poll() is None and not (place.path / "removed/designs/baseline/log.txt").exists():
            time.sleep(0.01)
        shutil.rmtree(place.path / "removed", ignore_errors=True)
        _, err = process.communicate(timeout=common.PATIENCE * 120)
        self.expect("a directory removed under way", (0, 1), subprocess.CompletedProcess((), process.returncode, "", err))

        self.expect("few file handles", (0, 1), run_in(place.path / "few", preexec_fn=limited(resource.RLIMIT_NOFILE, 12)))
        self.little_memory(simulated)
        for most in (0, 1, 100, 5000, 100000):
            out = place.path / f"limit{most}"
            result = run_in(out, preexec_fn=limited(resource.RLIMIT_FSIZE, most))
            self.expect(f"ulimit -f of {most} bytes", (0, 1, 2), result)
            again = run_in(out)
            self.expect(f"after a ulimit -f of {most} bytes", (0,), again)
            if place.run("rank", out, "--json").stdout != expected:
                self.note(f"after a ulimit -f of {most} bytes", "another ranking")
        for file in good.rglob("*"):
            os.utime(file, (2 ** 31 - 1, 2 ** 31 - 1))  # as after a clock that was set back
        self.expect("files from the future", (0,), run_in(good))
        if place.run("rank", good, "--json").stdout != expected:
            self.note("files from the future", "another ranking")
        backwards = {"LD_PRELOAD": self.library, "ICEBOW_FAULT": "clock 0 60"}
        out = place.path / "backwards"
        self.expect("a clock that runs backwards", (0,), run_in(out, extra=backwards))
        if place.run("rank", out, "--json").stdout != expected:
            self.note("a clock that runs backwards", "another ranking")
        self.read_only(path, good, expected)
        print(f"places and limits: {self.tried} tried", flush=True)

    def little_memory(self, simulated):
        place = self.place

        def within(megabytes, *words):
            return place.run(*words, preexec_fn=limited(resource.RLIMIT_AS, megabytes << 20))

        if "AddressSanitizer" in within(700, "--version").stderr:
            print("a sanitizer wants terabytes of addresses: limits of memory not tried")
            return
        self.expect("little memory", (0, 1), within(700, "simulate", simulated, "--out", place.path / "little"))
        for most in (60, 90, 120):  # MB: too few for the report, for the ice, for either
            words = ("run", simulated, "--out", place.path / f"memory{most}")
            self.expect(f"{most} MB of memory", (0, 1), within(most, *words))
            self.expect(f"after {most} MB of memory", (0,), place.run(*words))

    def read_only(self, path, good, expected):
        """Root may write anywhere, so nobody (65534) tries."""
        place, out = self.place, self.place.path / "read_only"
        shutil.copytree(good, out)
        for file in (place.path, out, *out.rglob("*")):
            file.chmod(0o755 if file.is_dir() else 0o644)
        if os.geteuid() != 0:
            out.chmod(0o555)

        def nobody():
            if os.geteuid() == 0:
                os.setgid(65534)
                os.setuid(65534)

        try:
            ranking = place.run("rank", out, "--json", preexec_fn=nobody)
        except PermissionError:
            print("nobody may run the program here: read-only directories not tried")
            return
        self.expect("a ranking of a directory that is read-only", (0,), ranking)
        if ranking.stdout != expected:
            self.note("a ranking of a directory that is read-only", "another ranking")
        for what, words in {"a study": ("run", path, "--out", out), "a report": ("report", out),
                            "a hull": ("hull", path, "--out", out / "h.obj"),
                            "a simulation": ("simulate", path, "--out", out / "new")}.items():
            self.expect(f"{what} in a directory that is read-only", (1,), place.run(*words, preexec_fn=nobody),
                        str(out))
        out.chmod(0o755)


def main():
    chosen = common.options(__doc__, ranks=0)
    with common.Place(chosen.program) as place:
        campaign = Campaign(place, chosen.short)
        if chosen.ranks:
            campaign.study(chosen.ranks)
        else:
            campaign.places()
            campaign.hulls()
            campaign.study(0)
    print(f"{len(campaign.faults)} faults")
    return 1 if campaign.faults else 0


if __name__ == "__main__":
    sys.exit(main())

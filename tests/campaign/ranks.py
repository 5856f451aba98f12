#!/usr/bin/env python3
"""Interrupts `mpirun -n A icebow simulate` (and `icebow run`, embedded) by a signal to mpirun at a random moment, and
gives the same command on B ranks. What it comes to must equal the run of one process that nobody disturbed: every row of
the history, every number of the result but times. mpirun hands SIGUSR1 on to its ranks, so that a checkpoint must be
there; after SIGINT, SIGTERM and SIGHUP it kills them within two seconds, so that those are counted; with more seconds
(odls_base_sigkill_timeout) it must be there as well."""
import random
import shutil
import signal
import sys
import time

import common

RANKS = (1, 2, 3, 4, 6, 8)
HURRIED = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
PATIENT = {"OMPI_MCA_odls_base_sigkill_timeout": "3"}  # seconds, before SIGTERM and again before SIGKILL


def outcome(place, command, out):
    if command == "run":
        return common.rows_of(out), common.histories_of(out)
    result = common.lasting(common.json.loads((out / "result.json").read_text()))
    return result, (out / "history.csv").read_bytes()


class Campaign:
    def __init__(self, place, dice):
        self.place, self.dice, self.faults = place, dice, []
        self.left = {}  # of each kind of signal: checkpoints left, signals that fell
        self.paths, self.expected = {}, {}
        for patient, fraction in {False: 0.15, True: 0.03}.items():  # a second or two; longer than mpirun waits
            self.paths[patient] = place.write(f"study_{patient}.json", common.study(
                designs=[], solver={"layers": 2, "time_step_fraction": fraction},
                output={"pictures": 1, "snapshots": 8}))
        for command, patient in (("simulate", False), ("run", False), ("simulate", True)):
            out = place.path / f"whole_{command}_{patient}"
            result = place.run(command, self.paths[patient], "--out", out)
            if result.returncode != 0:
                sys.exit(f"{command}: the undisturbed one failed: {result.stderr}")
            self.expected[command, patient] = outcome(place, command, out)

    def interrupted(self, command, out, ranks, number, patient):
        """Whether the signal ended the run; one that ends by itself while mpirun waits is none."""
        process = self.place.start(command, self.paths[patient], "--out", out, ranks=ranks, extra=PATIENT if patient else None)
        design = out / "designs/baseline" if command == "run" else out
        while process.poll() is None and not (design / "ice.pvd").exists():  # the simulation's first file
            time.sleep(0.02)
        fell, code = common.end_at(process, self.dice.uniform(0.0, 1.0), number)
        if fell and code is None:
            self.faults.append(f"{command} on {ranks} ranks: {number.name} did not end it in a minute")
        return fell and code != 0 and not (design / "result.json").exists()

    def pair(self, command, first, second, number, patient):
        what = f"{command}, {number.name}{' and time' if patient else ''} on {first} ranks, resumed on {second}"
        out = self.place.path / "out"
        shutil.rmtree(out, ignore_errors=True)
        if not self.interrupted(command, out, first, number, patient):
            return
        checkpoint = (out / "designs/baseline" if command == "run" else out) / "checkpoint.h5"
        kind = number.name + (" with more seconds" if patient else "")
        there = checkpoint.exists()
        left, fell = self.left.get(kind, (0, 0))
        self.left[kind] = left + there, fell + 1
        if not there and (patient or number == signal.SIGUSR1):
            self.faults.append(f"{what}: no checkpoint")
        again = self.place.run(command, self.paths[patient], "--out", out, ranks=second)
        if again.returncode != 0:
            self.faults.append(f"{what}: does not go on: exit {again.returncode}: {again.stderr[-400:]}")
        elif outcome(self.place, command, out) != self.expected[command, patient]:
            self.faults.append(f"{what}: another result")
        elif command == "simulate" and there != ("continues at step" in again.stderr):
            self.faults.append(f"{what}: starts anew beside its checkpoint")

    def told(self):
        for kind, (left, fell) in sorted(self.left.items()):
            print(f"{kind}: {fell} runs under mpirun ended by it, {left} left a checkpoint")
        print(f"{len(self.faults)} faults", *self.faults, sep="\n")


def main():
    chosen = common.options(__doc__, rounds=1)
    with common.Place(chosen.program) as place:
        campaign = Campaign(place, random.Random(chosen.seed))
        if chosen.short:
            campaign.pair("simulate", 2, 1, signal.SIGUSR1, False)
            campaign.pair("run", 1, 2, signal.SIGUSR1, False)
            campaign.pair("simulate", 2, 3, signal.SIGTERM, True)
        for _ in range(0 if chosen.short else chosen.rounds):
            for n, first in enumerate(RANKS):
                for m, second in enumerate(RANKS):
                    number = (*HURRIED, signal.SIGUSR1)[(n + m) % 4]
                    command = "run" if (n + 2 * m) % 3 == 0 else "simulate"
                    campaign.pair(command, first, second, number, False)
                campaign.pair("simulate", first, 2, HURRIED[n % 3], True)
                print(f"interrupted on {first} ranks, resumed on {', '.join(map(str, RANKS))}: "
                      f"{len(campaign.faults)} faults so far", flush=True)
        campaign.told()
    return 1 if campaign.faults else 0


if __name__ == "__main__":
    sys.exit(main())

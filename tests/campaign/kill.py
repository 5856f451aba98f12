#!/usr/bin/env python3
"""Ends studies at random moments, by SIGKILL, SIGINT, SIGTERM and SIGHUP, in both launchers, with an optimiser, with
repeats, with a race that sails voyages on, over scenarios, in groups of ranks, and with a checkpoint every few
milliseconds; then the same command again until it ends by itself. What it comes to must equal the undisturbed study bit for bit: every row but its times, every
history, the ranking."""
import random
import signal
import sys
import time

import common

GRID = {"method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [24, 26]}}}, "designs": [], "repeats": 2}
OPTIMISER = {"method": {"type": "optimise", "algorithm": "sbplx", "max_evaluations": 4,
                        "variables": {"/bow/stem_deg": {"min": 20, "max": 28}}}, "designs": []}
RACE = {"method": {"type": "grid", "variables": {"/bow/stem_deg": {"values": [24, 32]}}}, "designs": [],
        "sheet": {"length_m": 46, "width_m": 30, "window_ahead_m": 12},
        "operation": {"speed_kn": 6, "advance_m": 10, "steady_from_m": 1},
        "decide": {"best_within": 0.02, "longest_m": 20}}
SCENARIOS = {"designs": [], "scenarios": [{"name": "slow", "weight": 2, "set": {"operation": {"speed_kn": 5}}},
                                          {"name": "fast", "set": {"operation": {"speed_kn": 6}}}]}
# What is run, by how many ranks, and the words after it; three ranks and two jobs are two groups beside the driver.
GROUPS = ("--jobs", "2")
CASES = {"isolated, repeats": (GRID, 0), "isolated, optimiser": (OPTIMISER, 0), "isolated, race": (RACE, 0),
         "embedded, 2 ranks, repeats": (GRID, 2), "embedded, 2 ranks, optimiser": (OPTIMISER, 2),
         "embedded, 2 ranks, race": (RACE, 2),
         "isolated, scenarios": (SCENARIOS, 0), "embedded, 2 ranks, scenarios": (SCENARIOS, 2),
         "in groups, 3 ranks, repeats": (GRID, 3, *GROUPS), "in groups, 3 ranks, race": (RACE, 3, *GROUPS)}
OFTEN = {"ICEBOW_CHECKPOINT_SECONDS": "0.02"}  # so that many a blow falls while one is written


def reference(place, name, document, ranks, options):
    path, begin = place.write("study.json", document), time.time()
    result = place.run("run", path, "--out", place.path / "whole", *options, ranks=ranks, extra=OFTEN)
    if result.returncode != 0:
        sys.exit(f"{name}: the undisturbed study failed: {result.stderr}")
    return path, time.time() - begin, common.outcome_of(place, place.path / "whole")


def go_on(place, words, ranks):
    """The same command until it ends by itself. Ranks outlive an mpirun that was killed by a second: the lock tells."""
    for _ in range(20):
        last = place.run(*words, ranks=ranks, extra=OFTEN)
        if last.returncode == 0 or "another icebow run is working" not in last.stderr:
            break
        time.sleep(0.5)
    return last


def attack(program, name, document, ranks, options, wanted, signals, dice):
    """Runs studies until so many blows have fallen; blows and faults."""
    blows, faults, rounds = {number: 0 for number in signals}, [], 0
    with common.Place(program) as place:
        path, seconds, expected = reference(place, name, document, ranks, options)
        while sum(blows.values()) < wanted:
            out, rounds = place.path / f"cut{rounds}", rounds + 1
            words = ("run", path, "--out", out, *options)
            for _ in range(6):
                number = dice.choice(signals)
                process = place.start(*words, ranks=ranks, extra=OFTEN)
                fell, code = common.end_at(process, dice.uniform(0.05, seconds), number)
                if not fell:
                    break
                blows[number] += 1
                if code is None:
                    faults.append(f"{name}: {number} did not end it in a minute")
                if sum(blows.values()) >= wanted:
                    break
            last = go_on(place, words, ranks)
            if last.returncode != 0:
                faults.append(f"{name}: the command did not go on: exit {last.returncode}: {last.stderr[-1500:-450] or last.stderr}")
            elif common.outcome_of(place, out) != expected:
                faults.append(f"{name}: another result than undisturbed, round {rounds}")
    return blows, rounds, faults


def main():
    chosen = common.options(__doc__, count=100)
    dice = random.Random(chosen.seed)
    signals = [signal.SIGKILL] * 3 + [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]
    count = 8 if chosen.short else chosen.count
    cases = dict(list(CASES.items())[::2]) if chosen.short else CASES
    total, faults = 0, []
    for name, (patch, ranks, *options) in cases.items():
        blows, rounds, wrong = attack(chosen.program, name, common.study(**patch), ranks, options,
                                      -(-count // len(cases)), signals, dice)
        total += sum(blows.values())
        faults += wrong
        fell = ", ".join(f"{n} {signal.Signals(s).name}" for s, n in blows.items() if n)
        print(f"{name}: {fell} in {rounds} studies; {len(wrong)} faults", flush=True)
    print(f"{total} blows, {len(faults)} faults", *faults, sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

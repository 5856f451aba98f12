#!/usr/bin/env python3
"""Flips bits, zeroes blocks and cuts off the ends of checkpoints, stores and files of a study, at random places. Each
must be told, or change nothing: no other result with exit 0, no crash, no design lost for good."""
import random
import shutil
import signal
import subprocess
import sys
import time

import common

OFTEN = {"ICEBOW_CHECKPOINT_SECONDS": "0.02"}


def damaged(content, dice, kind):
    data = bytearray(content)
    at = dice.randrange(len(data))
    if kind == "bit":
        data[at] ^= 1 << dice.randrange(8)
    elif kind == "zeroed block":
        start = at // 512 * 512
        data[start:start + 512] = bytes(len(data[start:start + 512]))
    else:
        del data[at:]
    return bytes(data)


def interrupted(place, words, checkpoint):
    """A run that was ended in good order after its first checkpoint."""
    for _ in range(20):
        process = place.start(*words, extra=OFTEN)
        while process.poll() is None and not checkpoint.exists():
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=common.PATIENCE * 60)
        if checkpoint.exists():
            return
    sys.exit("no checkpoint could be caught")


def checkpoints(place, counts, dice):
    """Of `simulate`, whose word is final, and of `run`, which sets a damaged one aside."""
    path = place.write("study.json", common.study(designs=[], solver=common.SLOW))
    place.run("simulate", path, "--out", place.path / "whole")
    whole = (place.path / "whole/history.csv").read_bytes()
    good = place.path / "good"
    interrupted(place, ("simulate", path, "--out", good), good / "checkpoint.h5")
    content = (good / "checkpoint.h5").read_bytes()
    told = same = 0
    faults = []
    for kind, count in counts.items():
        for _ in range(count):
            out = place.path / "try"
            shutil.rmtree(out, ignore_errors=True)
            shutil.copytree(good, out)
            (out / "checkpoint.h5").write_bytes(damaged(content, dice, kind))
            result = place.run("simulate", path, "--out", out)
            if result.returncode == 0 and (out / "history.csv").read_bytes() == whole:
                same += 1
            elif result.returncode == 1 and "checkpoint" in result.stderr and common.is_one_sentence(result.stderr):
                told += 1
            else:
                faults.append(f"checkpoint, {kind}: exit {result.returncode}: {result.stderr[-300:]}")
    print(f"checkpoint: {told} told, {same} without effect, {len(faults)} faults", flush=True)
    return faults


def set_aside(place, count, dice):
    """A study under way is killed, its checkpoint damaged: the design starts anew, with a word."""
    path = place.write("study.json", common.study(designs=[], solver=common.SLOW))
    place.run("run", path, "--out", place.path / "r_whole")
    expected = common.rows_of(place.path / "r_whole")
    faults = words = 0
    messages = []
    for k in range(count):
        out = place.path / f"r{k}"
        checkpoint = out / "designs/baseline/checkpoint.h5"
        process = place.start("run", path, "--out", out, extra=OFTEN)
        while process.poll() is None and not checkpoint.exists():
            time.sleep(0.005)
        process.kill()
        process.communicate()
        time.sleep(0.3)
        if not checkpoint.exists():
            continue
        checkpoint.write_bytes(damaged(checkpoint.read_bytes(), dice, dice.choice(("zeroed block", "cut off"))))
        result = place.run("run", path, "--out", out)
        words += "set aside" in result.stderr or "checkpoint was damaged" in result.stderr
        if result.returncode != 0 or common.rows_of(out) != expected:
            messages.append(f"set aside: exit {result.returncode}: {result.stderr[-300:]}")
    print(f"studies with a damaged checkpoint: {count}, {words} with a word, {len(messages)} faults", flush=True)
    return messages


def stores(place, counts, dice):
    path = place.write("study.json", common.study(evaluators=["lindqvist"], ranking={"by": "lindqvist_breaking"},
                                                  method={"type": "grid", "variables": {
                                                      "/bow/stem_deg": {"values": [22, 23, 24, 25, 26, 28]}}}))
    out = place.path / "s"
    place.run("run", path, "--out", out)
    expected = place.run("rank", out, "--json").stdout
    content = (out / "results.sqlite").read_bytes()
    told = same = mended = 0
    faults = []
    for kind, count in counts.items():
        for _ in range(count):
            (out / "results.sqlite").write_bytes(damaged(content, dice, kind))
            result = place.run("rank", out, "--json")
            if result.returncode == 0 and result.stdout == expected:
                same += 1
                continue
            if result.returncode not in (1, 3) or not common.is_one_sentence(result.stderr):
                faults.append(f"store, {kind}: exit {result.returncode}: {result.stderr[-300:]}")
                continue
            told += 1
            again = place.run("run", path, "--out", out, "--retry-failed")
            if again.returncode == 0 and place.run("rank", out, "--json").stdout == expected:
                mended += 1
            elif again.returncode != 1 or "damaged" not in again.stderr and "not a result store" not in again.stderr:
                faults.append(f"store, {kind}, run again: exit {again.returncode}: {again.stderr[-300:]}")
    print(f"store: {told} told ({mended} of them mended by --retry-failed), {same} without effect, "
          f"{len(faults)} faults", flush=True)
    return faults


def files(place, count, dice):
    """What `report` reads besides the store."""
    path = place.write("study.json", common.study(designs=[], solver=common.SLOW))
    out = place.path / "f"
    place.run("run", path, "--out", out)
    design = out / "designs/baseline"
    faults, drawn = [], 0
    for name in ("lines.svg", "history.csv", "hull.obj", "result.json", "ice_000.png", "../../study.json"):
        content = (design / name).read_bytes()
        for _ in range(count):
            (design / name).write_bytes(damaged(content, dice, dice.choice(("bit", "zeroed block", "cut off"))))
            result = place.run("report", out)
            drawn += result.returncode == 0
            if result.returncode not in (0, 1, 2) or (result.returncode and not common.is_one_sentence(result.stderr)):
                faults.append(f"{name}: exit {result.returncode}: {result.stderr[-300:]}")
        (design / name).write_bytes(content)
    print(f"files of a design: {6 * count} damaged, {drawn} reports drawn all the same, {len(faults)} faults", flush=True)
    return faults


def main():
    chosen = common.options(__doc__, bits=200, blocks=60, files=20, studies=10)
    if chosen.short:
        chosen.bits, chosen.blocks, chosen.files, chosen.studies = 10, 6, 2, 1
    dice = random.Random(chosen.seed)
    counts = {"bit": chosen.bits, "zeroed block": chosen.blocks, "cut off": chosen.blocks}
    with common.Place(chosen.program) as place:
        faults = checkpoints(place, counts, dice) + set_aside(place, chosen.studies, dice)
        faults += stores(place, counts, dice) + files(place, chosen.files, dice)
    print(f"{len(faults)} faults", *faults, sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Icebow's bond work against LAMMPS peri/lps (Debian package `lammps`) on the same slab.

    bench/peers [--json] [--steps N] [--repeats N] [--ranks 1,2] [--lattice NX,NY,NZ]

Same lattice, horizon, directed bonds, elastic constants, critical stretch, held edges, initial velocity and time
step. The programs take turns, so that a busy machine slows both. Exit code 77 where LAMMPS is not installed.
"""
import argparse
import json
import pathlib
import re
import shutil
import sys
import tempfile

from launch import Failed, announce, kernel, machine, mpirun, positive, rank_counts, run_main, usable_cores

DX, RHO, E, NU, S0 = 0.013, 826.6, 52e6, 0.33, 0.0052
HELD = 3  # columns at port and starboard that do not move
TIMED_RUNS = 3  # in each start of either program

# peri/lps alone: peri/lps/omp of this version is silently wrong. What favours LAMMPS:
# - boundary f: no minimum-image search. The box is wider than the slab, so nothing is lost.
# - skin 0 and no rebuild: bonds are kept by atom number, the neighbour list serves only the short-range force, and
#   a slab that hardly moves needs no other list. A run with moving ice would need both.
# - map array: bonded partners are looked up by number in every step, an array is the fastest look-up.
# - newton on: each pair of the short-range force once, also across ranks. Off costs the same within the noise.
# - no thermo, dump or compute within the timed steps.
# Tried without gain: atoms in the order of creation or sorted by smaller or larger bins; pairs excluded from the
# short-range force after the bonds are made.
# The cutoff is a little more than 3 dx, so that bonds of exactly 3 dx count, as in Icebow.
INPUT = """units si
boundary f f f
newton on
atom_style peri
atom_modify map array
neighbor 0.0 bin
neigh_modify every 1000000 delay 1000000 check no
lattice sc {dx} origin 0.5 0.5 0.5
region box block -1 {x_box} -1 {y_box} -1 {z_box}
region slab block 0 {nx} 0 {ny} 0 {nz}
create_box 1 box
create_atoms 1 region slab
set group all density {rho}
set group all volume {volume}
pair_style peri/lps
pair_coeff * * {K} {G} {cutoff} {s0} 0.0
region free block INF INF {held} {free_end} INF INF
group mobile region free
velocity all set 0 0 0
fix motion mobile nve
timestep {dt}
thermo 1000000
# At rest: peri/lps knows its bonds' critical stretch only after a first step, and would break bonds in it.
run 1
variable vz atom 1e-3*sin(3*x)*cos(2*(y-{y_middle}))
velocity mobile set 0 0 v_vz units box
"""


def lammps_input(lattice, dt, steps):
    nx, ny, nz = lattice
    text = INPUT.format(dx=DX, nx=nx, ny=ny, nz=nz, x_box=nx + 1, y_box=ny + 1, z_box=nz + 1, rho=RHO, volume=DX**3,
                        K=E / (3 * (1 - 2 * NU)), G=E / (2 * (1 + NU)), cutoff=3.0001 * DX, s0=S0, held=HELD,
                        free_end=ny - HELD, y_middle=0.5 * ny * DX, dt=dt)
    return text + f"run {steps} pre no\n" * TIMED_RUNS  # the first run of one step warms up


def read_log(text, ranks, steps):
    """The best of the timed runs, by LAMMPS's own "Loop time", which leaves set-up out."""
    def find(pattern, what):
        found = re.findall(pattern, text, re.MULTILINE)
        if not found:
            raise Failed(f"LAMMPS's log does not state its {what}")
        return found

    particles = int(find(r"^Created (\d+) atoms", "particles")[0])
    bonds = int(find(r"total # of bonds = (\d+)", "bonds")[0])
    loops = find(r"^Loop time of (\S+) on \d+ procs for (\d+) steps", "loop time")[1:]
    seconds = min(float(time) / int(n) for time, n in loops if int(n) == steps)
    megabytes = float(find(r"memory allocation .* = \S+ \| (\S+) \|", "memory")[-1])
    return {"version": find(r"^LAMMPS \((.*)\)", "version")[0], "particles": particles, "bonds": bonds,
            "ms_per_step": 1e3 * seconds, "ns_per_bond": 1e9 * seconds / bonds,
            "bytes_per_particle": megabytes * 2**20 * ranks / particles}


def lammps(program, ranks, lattice, dt, steps):
    with tempfile.TemporaryDirectory(prefix="icebow_peers_") as directory:
        folder = pathlib.Path(directory)
        (folder / "in.slab").write_text(lammps_input(lattice, dt, steps))
        log = folder / "log.lammps"
        mpirun(ranks, program, "-in", "in.slab", "-log", log.name, "-screen", "none", "-nocite", cwd=folder, log=log)
        return read_log(log.read_text(), ranks, steps)


def best_runs(program, options):
    """Best run of each program by number of ranks: (lammps, icebow)."""
    kernel_options = [word for name, n in zip(("--nx", "--ny", "--nz"), options.lattice) for word in (name, n)]
    dt = kernel(1, *kernel_options, "--steps", 1)["dt_s"]
    best = ({}, {})
    for repeat in range(options.repeats):
        for ranks in options.ranks:
            announce(f"repeat {repeat + 1} of {options.repeats}, {ranks} rank(s)")
            runs = lammps(program, ranks, options.lattice, dt, options.steps), kernel(ranks, *kernel_options)
            for slot, run in zip(best, runs):
                if ranks not in slot or run["ms_per_step"] < slot[ranks]["ms_per_step"]:
                    slot[ranks] = run
    return best


def summary(runs, names):
    first = next(iter(runs.values()))
    return {**{name: first[name] for name in names},
            **{name: {str(ranks): run[name] for ranks, run in runs.items()}
               for name in ("ms_per_step", "ns_per_bond")}}


def print_table(result):
    for name in ("lammps", "icebow"):
        print(f"{name}: {result[name]['bonds']:,} directed bonds, {result[name]['particles']:,} particles")
    print(f"LAMMPS {result['lammps']['version']}; Icebow's kernel: {result['icebow']['kernel']}\n")
    print(f"{'ranks':>5} {'LAMMPS ms/step':>15} {'ns/bond':>8} {'Icebow ms/step':>15} {'ns/bond':>8} {'ratio':>7}")
    for ranks, ratio in result["ratio_to_lammps"].items():
        peer, own = ([result[name][key][ranks] for key in ("ms_per_step", "ns_per_bond")]
                     for name in ("lammps", "icebow"))
        print(f"{ranks:>5} {peer[0]:15.1f} {peer[1]:8.2f} {own[0]:15.3f} {own[1]:8.4f} {ratio:7.1f}")
    peer, own = (result[name]["bytes_per_particle"] for name in ("lammps", "icebow"))
    print(f"\nbytes a particle, by each program's own count: LAMMPS {peer:.0f}, Icebow {own:.0f}")


def lattice_size(text):
    lattice = [positive(word) for word in text.split(",")]
    if len(lattice) != 3:
        raise ValueError
    return lattice


def parse():
    parser = argparse.ArgumentParser(description="Icebow's kernel against LAMMPS peri/lps on the same slab")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--steps", type=positive, default=5, help="LAMMPS steps in each timed run (default 5)")
    parser.add_argument("--repeats", type=positive, default=2, help="starts of each program; the best counts (default 2)")
    parser.add_argument("--ranks", type=rank_counts, default=[1, 2], help="default 1,2")
    parser.add_argument("--lattice", type=lattice_size, default=[500, 250, 3], metavar="NX,NY,NZ")
    return parser.parse_args()


def main():
    options = parse()
    program = shutil.which("lmp") or shutil.which("lammps")
    if not program:
        print("peers: LAMMPS (`lmp` or `lammps`) is not installed; on Debian: apt-get install lammps", file=sys.stderr)
        sys.exit(77)
    before = machine()
    peer, own = best_runs(program, options)
    result = {
        "benchmark": "peers",
        "ratio_to_lammps": {str(n): peer[n]["ms_per_step"] / own[n]["ms_per_step"] for n in options.ranks},
        "same_bonds": all(peer[n]["bonds"] == own[n]["bonds"] for n in options.ranks),
        "lammps": summary(peer, ("version", "particles", "bonds", "bytes_per_particle")),
        "icebow": summary(own, ("kernel", "particles", "bonds", "bytes_per_particle", "dt_s")),
        "oversubscribed": max(options.ranks) > usable_cores(),
        "machine": before,
    }
    print(json.dumps(result, indent=2)) if options.json else print_table(result)
    if not result["same_bonds"]:
        raise Failed("the two programs did not compute the same number of bonds: the ratio means nothing")


if __name__ == "__main__":
    run_main(main)

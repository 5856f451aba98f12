#!/usr/bin/env python3
"""Icebow against LAMMPS peri/lps (Debian package `lammps`) on the same free block, without surface correction.

    peridynamics_peer_test.py FREE_BLOCK      the program that runs Icebow's side; exit code 77 without LAMMPS

Both programs get the same lattice, horizon, partial volumes, constants, displacements and time step. Their
materials are not the same:
- the state of LAMMPS (Silling et al. 2007) weighs dilatation and stretch of a bond with 1/L and divides by the
  particle's own weighted volume, so that an incomplete family is made up for;
- Icebow's (Madenci and Oterkus 2014, ch. 4) weighs the dilatation with 1/L^2 and the stretch with 1/L, and divides
  by the weighted volume of a whole ball.
So each is compared with its own formula, written out below once more, to rounding; then, away from the faces, Icebow with
LAMMPS to what the formulas differ by there.
"""
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

SMALL = (20, 10, 8)
LARGE = (22, 22, 22)
DX, RHO, E = 0.013, 826.6, 52e6  # as in tests/support/ice_block.h
DT, STEPS = 1e-5, 40  # a P wave runs 9 particles
INNER = 9  # particles away from the faces
# x, y, z: place from the corner of the block. A stretch along x, a bend and a shear, all smooth.
DISPLACEMENT = ("1e-5*sin(12*x)", "1e-5*cos(20*y)*cos(9*x)", "1e-5*sin(15*x)*cos(18*z)")

# The first step makes the bonds at rest and only then sets the critical stretch: displaced before it, all stretched bonds
# of this version break.
INPUT = """units si
boundary f f f
atom_style peri
atom_modify map array
neighbor 0.0 bin
neigh_modify every 1000000 delay 1000000 check no
lattice sc {dx} origin 0.5 0.5 0.5
region box block -1 {x_box} -1 {y_box} -1 {z_box}
region block block 0 {nx} 0 {ny} 0 {nz}
create_box 1 box
create_atoms 1 region block
set group all density {rho}
set group all volume {volume}
pair_style peri/lps
pair_coeff * * {K} {G} {cutoff} 1.0 0.0
velocity all set 0 0 0
fix start all store/state 0 x y z
run 1
reset_timestep 0
variable px atom f_start[1]+{ux}
variable py atom f_start[2]+{uy}
variable pz atom f_start[3]+{uz}
set group all x v_px y v_py z v_pz
variable dx atom x-f_start[1]
variable dy atom y-f_start[2]
variable dz atom z-f_start[3]
fix motion all nve
timestep {dt}
dump all all custom {steps} out f_start[1] f_start[2] f_start[3] fx fy fz v_dx v_dy v_dz
dump_modify all format float %.17g first yes
run {steps}
"""


def fail(text):
    sys.exit(f"peridynamics_peer_test: {text}")


def particles(size):
    """(i, j, k) in Icebow's order."""
    nx, ny, nz = size
    return [(i, j, k) for j in range(ny) for k in range(nz) for i in range(nx)]


def moduli(nu):
    return E / (3 * (1 - 2 * nu)), E / (2 * (1 + nu))


def displacements(size):
    names = {"sin": math.sin, "cos": math.cos}
    result = {}
    for p in particles(size):
        place = dict(zip("xyz", ((n + 0.5) * DX for n in p)))
        result[p] = [eval(formula, {**names, **place}) for formula in DISPLACEMENT]
    return result


def icebow(program, size, nu, correction):
    """(accelerations at the start, displacements at the end) by particle."""
    text = "\n".join(" ".join(map(repr, u)) for u in displacements(size).values())
    words = [program, *map(str, (*size, DX, nu, DT, STEPS, int(correction)))]
    run = subprocess.run(words, input=text, text=True, stdout=subprocess.PIPE, check=True)
    rows = [[float(word) for word in line.split()] for line in run.stdout.splitlines()]
    return ({p: row[:3] for p, row in zip(particles(size), rows)},
            {p: row[3:] for p, row in zip(particles(size), rows)})


def read_dump(text):
    """Likewise: forces are densities, the first step is the start."""
    steps = text.split("ITEM: TIMESTEP\n")[1:]

    def rows(step):
        for line in step.split("ITEM: ATOMS", 1)[1].splitlines()[1:]:
            values = [float(word) for word in line.split()]
            yield tuple(round(x / DX - 0.5) for x in values[:3]), values[3:]
    return ({p: [f / RHO for f in row[:3]] for p, row in rows(steps[0])}, {p: row[3:] for p, row in rows(steps[-1])})


def lammps(program, size, nu):
    K, G = moduli(nu)
    nx, ny, nz = size
    formulas = [formula.replace("x)", "f_start[1])").replace("y)", "f_start[2])").replace("z)", "f_start[3])")
                for formula in DISPLACEMENT]
    text = INPUT.format(dx=DX, nx=nx, ny=ny, nz=nz, x_box=nx + 1, y_box=ny + 1, z_box=nz + 1, rho=RHO, volume=DX**3,
                        K=K, G=G, cutoff=3.0000001 * DX, dt=DT, steps=STEPS,
                        **dict(zip(("ux", "uy", "uz"), formulas)))
    with tempfile.TemporaryDirectory(prefix="icebow_peer_") as directory:
        folder = pathlib.Path(directory)
        (folder / "in.block").write_text(text)
        run = subprocess.run([program, "-in", "in.block", "-log", "log", "-screen", "none", "-nocite"], cwd=folder,
                             text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if run.returncode:
            log = folder / "log"
            fail(f"LAMMPS failed: {run.stdout}\n{log.read_text()[-1000:] if log.exists() else ''}")
        return read_dump((folder / "out").read_text())


def families(size):
    """[(particle, neighbour, reference bond, length, neighbour's volume inside the horizon)]"""
    offsets = [(a, b, c) for a in range(-3, 4) for b in range(-3, 4) for c in range(-3, 4) if 0 < a*a + b*b + c*c <= 9]
    inside = set(particles(size))
    bonds = []
    for p in particles(size):
        for o in offsets:
            q = tuple(n + m for n, m in zip(p, o))
            if q not in inside:
                continue
            length = math.sqrt(sum(m * m for m in o))
            bonds.append((p, q, [m * DX for m in o], length * DX, DX**3 * min(1.0, 3.5 - length)))
    return bonds


def accelerations(size, nu, theta_weight, own_volume):
    """Both materials: a bond's part in the dilatation goes with theta_weight(L) L e, its stretch with e / L; divided
    by the sums of theirs over the particle's own family, or by the integrals over the whole ball."""
    u, bonds, delta = displacements(size), families(size), 3.0 * DX
    K, G = moduli(nu)
    stretched = []
    m_theta, m_stretch = dict.fromkeys(u, 0.0), dict.fromkeys(u, 0.0)
    for p, q, xi, L, V in bonds:
        y = [x + b - a for x, a, b in zip(xi, u[p], u[q])]
        length = math.sqrt(sum(c * c for c in y))
        stretched.append((y, length, length - L))
        m_theta[p] += theta_weight(L) * L * L * V
        m_stretch[p] += L * V
    if not own_volume:
        m_theta = dict.fromkeys(u, 4.0 / 3.0 * math.pi * delta**3 * theta_weight(delta) * delta**2)
        m_stretch = dict.fromkeys(u, math.pi * delta**4)
    theta = dict.fromkeys(u, 0.0)
    for (p, _, _, L, V), (_, _, e) in zip(bonds, stretched):
        theta[p] += 3.0 / m_theta[p] * theta_weight(L) * L * e * V
    a = {p: [0.0, 0.0, 0.0] for p in u}
    for (p, q, _, L, V), (y, length, e) in zip(bonds, stretched):
        force = (3 * K - 5 * G) * theta_weight(L) * L * (theta[p] / m_theta[p] + theta[q] / m_theta[q])
        force += 15 * G * e / L * (1 / m_stretch[p] + 1 / m_stretch[q])
        for c in range(3):
            a[p][c] += V * force * y[c] / (length * RHO)
    return a


def difference(one, other):
    """Root of mean square, over that of `other`."""
    square = sum((x - y)**2 for p in other for x, y in zip(one[p], other[p]))
    return math.sqrt(square / sum(y * y for vector in other.values() for y in vector))


def inner(field, size):
    return {p: vector for p, vector in field.items() if all(INNER <= n < end - INNER for n, end in zip(p, size))}


def check(what, found, limit):
    print(f"{what}: {found:.2e} (allowed {limit:g})")
    return found <= limit


def against_formulas(free_block, program, nu):
    own, peer = icebow(free_block, SMALL, nu, False)[0], lammps(program, SMALL, nu)[0]
    by_icebow = accelerations(SMALL, nu, lambda L: L**-2, own_volume=False)
    by_lammps = accelerations(SMALL, nu, lambda L: 1 / L, own_volume=True)
    print(f"nu {nu}, block of {SMALL}, accelerations")
    return [check("  Icebow against its formula", difference(own, by_icebow), 1e-10),
            check("  LAMMPS against its formula", difference(peer, by_lammps), 1e-7)]


def movement(end, size):
    return {p: [x - y for x, y in zip(end[p], start)] for p, start in displacements(size).items()}


def against_each_other(free_block, program, nu):
    peer = movement(lammps(program, LARGE, nu)[1], LARGE)
    print(f"nu {nu}, block of {LARGE}, movement in {STEPS} steps, Icebow against LAMMPS")
    results = []
    for correction, limit, limit_inner in ((False, 0.2, 0.1), (True, 0.05, 0.05)):
        own = movement(icebow(free_block, LARGE, nu, correction)[1], LARGE)
        name = f"{'with' if correction else 'without'} surface correction"
        results += [check(f"  {name}, all particles", difference(own, peer), limit),
                    check(f"  {name}, inner particles", difference(inner(own, LARGE), inner(peer, LARGE)), limit_inner)]
    return results


def main():
    program = shutil.which("lmp") or shutil.which("lammps")
    if not program:
        print("peridynamics_peer_test: LAMMPS (`lmp` or `lammps`) is not installed; on Debian: apt-get install lammps")
        sys.exit(77)
    free_block = sys.argv[1]
    results = against_formulas(free_block, program, 0.33) + against_each_other(free_block, program, 0.33)
    sys.exit(0 if all(results) else 1)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Every ParaView file of a run, opened with VTK's own readers and held against the run.

    vtk_reader_test.py PROGRAM        ends with 77 (skipped) where VTK's Python module is not installed
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

try:
    import vtkmodules.all as vtk
except ImportError as missing:
    print(f"skipped: {missing} (Debian: python3-vtk9, or python3-paraview)")
    sys.exit(77)

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
TINY = pathlib.Path(__file__).resolve().parent / "tiny.json"
COMPONENTS = {"displacement_m": 3, "velocity_m_per_s": 3, "damage": 1, "piece": 1, "crack": 1}


def read(path):
    reader = {".vtp": "vtkXMLPolyDataReader", ".pvtp": "vtkXMLPPolyDataReader", ".hdf": "vtkHDFReader"}[path.suffix]
    reader = getattr(vtk, reader)()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path))
    reader.SetFileName(str(path))
    reader.Update()
    if errors:
        raise RuntimeError(f"VTK cannot read {path}")
    return reader.GetOutput()


def values(array):
    return [array.GetTuple(n) for n in range(array.GetNumberOfTuples())]


def arrays(grid):
    data = grid.GetPointData()
    found = {data.GetArrayName(n): values(data.GetArray(n)) for n in range(data.GetNumberOfArrays())}
    return {"points": values(grid.GetPoints().GetData()), **found}


def in_order(fields):
    """The particles in the order of their reference position, whatever the order of the ranks."""
    def reference(n):
        return tuple(round(x - u, 3) for x, u in zip(fields["points"][n], fields["displacement_m"][n]))
    order = sorted(range(len(fields["points"])), key=reference)
    return {name: [column[n] for n in order] for name, column in fields.items()}


class Run:
    def __init__(self, directory, ranks, output):
        self.directory = pathlib.Path(directory) / f"{ranks}_{output}"
        launcher = ["mpirun", "-n", str(ranks)] if ranks > 1 else []
        subprocess.run([*launcher, PROGRAM, "simulate", str(TINY), "--out", str(self.directory), "--set",
                        "/operation/advance_m=14", "--set", "/sheet/length_m=60", "--set", f"/output/format={output}",
                        "--set", "/output/snapshots=3"], check=True, capture_output=True)
        self.result = json.loads((self.directory / "result.json").read_text())

    def collection(self, name):
        entries = xml.etree.ElementTree.parse(self.directory / name).getroot().iter("DataSet")
        return [(float(e.get("timestep")), self.directory / e.get("file")) for e in entries]


class ParaView(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="icebow_vtk_")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.one, cls.three = Run(cls.folder.name, 1, "vtp"), Run(cls.folder.name, 3, "vtp")
        cls.hdf, cls.hdf_three = Run(cls.folder.name, 1, "vtkhdf"), Run(cls.folder.name, 3, "vtkhdf")

    def steps(self, run):
        if run in (self.one, self.three):
            return run.collection("ice.pvd")
        series = json.loads((run.directory / "ice.hdf.series").read_text())
        return [(f["time"], run.directory / f["name"]) for f in series["files"]]

    def test_every_ice_file_opens_and_holds_the_sheet(self):
        for run in (self.one, self.three, self.hdf, self.hdf_three):
            simulation = run.result["simulation"]
            particles = simulation["nx"] * simulation["ny"] * simulation["nz"]
            steps = self.steps(run)
            self.assertEqual([n for n, (time, _) in enumerate(steps) if time == 0], [0])
            self.assertEqual(len(steps), 4)
            for number, (_, path) in enumerate(steps):
                grid = read(path)
                self.assertEqual(grid.GetNumberOfPoints(), particles, path)
                self.assertEqual(grid.GetNumberOfCells(), particles, path)
                self.assertEqual(grid.GetCellType(particles - 1), vtk.VTK_VERTEX)
                self.assertEqual(grid.GetCell(particles - 1).GetPointId(0), particles - 1)
                fields = arrays(grid)
                self.assertEqual(set(fields), {"points", *COMPONENTS}, path)
                for name, components in COMPONENTS.items():
                    self.assertEqual((len(fields[name]), len(fields[name][0])), (particles, components), name)
                self.assertLessEqual((0,), min(fields["damage"]))
                if number == 0:
                    self.assertEqual(max(fields["damage"]), (0,))
                    self.assertEqual(set(fields["displacement_m"]), {(0, 0, 0)})
                else:
                    self.assertTrue((0,) < max(fields["damage"]) <= (1,))
                    self.assertLessEqual(set(fields["crack"]), {(kind,) for kind in range(7)})

    def test_pieces_of_ranks_open_alone(self):
        parts = sorted(self.three.directory.glob("ice_0002_p*.vtp"))
        self.assertEqual(len(parts), 3)
        self.assertEqual(sum(read(part).GetNumberOfPoints() for part in parts),
                         read(self.three.directory / "ice_0002.pvtp").GetNumberOfPoints())

    def test_the_same_values_in_any_format_and_on_any_number_of_ranks(self):
        reference = [in_order(arrays(read(path))) for _, path in self.steps(self.one)]
        for run in (self.three, self.hdf, self.hdf_three):
            for (_, path), expected in zip(self.steps(run), reference):
                fields = in_order(arrays(read(path)))
                for name, column in expected.items():
                    self.assertTrue(fields[name] == column, f"{path}: {name}")

    def test_the_last_step_is_the_end_of_the_run(self):
        for run in (self.one, self.hdf_three):
            metrics, simulation = run.result["metrics"], run.result["simulation"]
            time, path = self.steps(run)[-1]
            self.assertAlmostEqual(time, simulation["steps"] * simulation["dt_s"], delta=0.02 * time)
            fields = arrays(read(path))
            volume = (2.0 / 25 / simulation["nz"]) ** 3
            self.assertAlmostEqual(fields["piece"].count((-1,)) * volume, metrics["crushed_volume_m3"], places=9)
            self.assertEqual(max(0, *(piece for piece, in fields["piece"])), metrics["floes"])
            self.assertGreater(max(abs(v) for vector in fields["velocity_m_per_s"] for v in vector), 0.05)

    def test_the_ice_comes_towards_the_hull(self):
        for run in (self.one, self.three, self.hdf):
            hull = read(run.directory / "hull.vtp")
            self.assertTrue(hull.GetCellData().HasArray("patch"))
            edges = [read(path).GetBounds()[1] for _, path in self.steps(run)]
            self.assertAlmostEqual(edges[0] - edges[-1], 14 / 25, delta=0.02)  # a sample's way and the ice's own
            # At time 0 the foremost point of the hull at the height of the ice is at the ice's edge.
            self.assertAlmostEqual(read(self.steps(run)[0][1]).GetBounds()[0], 0, delta=0.06)

    def test_the_hull_is_written_once_and_its_pressure_adds_up_to_the_load(self):
        """The ice's traction times the quads' areas, step by step, is the mean of the record's force."""
        rows = list(csv.DictReader((self.one.directory / "history.csv").read_text().splitlines()))
        for run in (self.one, self.three, self.hdf_three):
            self.assertEqual(sorted(f.name for f in run.directory.glob("hull*.vtp")),
                             ["hull.vtp", *(f"hull_pressure_000{n}.vtp" for n in range(4))])
            hull, since = read(run.directory / "hull.vtp"), 0
            for time, path in run.collection("hull_pressure.pvd"):
                pressed = read(path)
                self.assertEqual(pressed.GetNumberOfCells() > 0, time > 0)
                if time == 0 or time > float(rows[-1]["time_s"]) * (1 + 1e-9):  # the end, between two samples
                    continue
                force = [0, 0, 0]
                data = pressed.GetCellData()
                for n in range(pressed.GetNumberOfCells()):
                    area, normal = area_and_normal(pressed, n)
                    self.assertEqual(area_and_normal(hull, int(data.GetArray("quad").GetTuple1(n))), (area, normal))
                    traction = data.GetArray("ice_traction_Pa").GetTuple3(n)
                    pressure = data.GetArray("ice_pressure_Pa").GetTuple1(n)
                    self.assertAlmostEqual(-sum(t * c for t, c in zip(traction, normal)) / max(1, pressure),
                                           pressure / max(1, pressure), delta=1e-4)  # floats
                    force = [f + area * t for f, t in zip(force, traction)]
                record = [[float(row[c]) for c in ("Fx_N", "Fy_N", "Fz_N")] for row in rows
                          if since < float(row["time_s"]) <= time * (1 + 1e-9)]
                for part, column in zip(force, zip(*record)):
                    self.assertAlmostEqual(part, sum(column) / len(column), delta=1e-3 * abs(force[0]))  # floats
                since = time * (1 + 1e-9)


def area_and_normal(mesh, cell):
    """Of a quad or triangle: half the cross product of its diagonals."""
    at = [mesh.GetPoint(mesh.GetCell(cell).GetPointId(n)) for n in range(mesh.GetCell(cell).GetNumberOfPoints())]
    a, b = ([q - p for p, q in zip(at[m], at[n])] for m, n in ((0, 2), (1, -1)))
    cross = [0.5 * (a[1] * b[2] - a[2] * b[1]), 0.5 * (a[2] * b[0] - a[0] * b[2]), 0.5 * (a[0] * b[1] - a[1] * b[0])]
    area = sum(c * c for c in cross) ** 0.5
    return area, [c / area for c in cross]


if __name__ == "__main__":
    unittest.main()

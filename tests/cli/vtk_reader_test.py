#!/usr/bin/env python3
"""Every ParaView file of a run, opened with VTK's own readers and held against the run.

    vtk_reader_test.py PROGRAM        ends with 77 (skipped) where VTK's Python module is not installed
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

try:
    import vtk
except ImportError as missing:
    print(f"skipped: {missing} (Debian: python3-vtk9)")
    sys.exit(77)

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
TINY = pathlib.Path(__file__).resolve().parent / "tiny.json"
COMPONENTS = {"displacement": 3, "velocity": 3, "damage": 1, "piece": 1}



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
        return tuple(round(x - u, 4) for x, u in zip(fields["points"][n], fields["displacement"][n]))
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
            self.assertEqual(len(steps), 3)
            for _, path in steps:
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
                self.assertTrue((0,) < max(fields["damage"]) <= (1,))

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
            self.assertGreater(max(abs(v) for vector in fields["velocity"] for v in vector), 0.05)

    def test_the_hull_sails(self):
        for run in (self.one, self.three, self.hdf):
            ahead = []
            for time, path in run.collection("hull.pvd"):
                hull = read(path)
                self.assertEqual(hull.GetNumberOfCells(), read(run.directory / "hull_0000.vtp").GetNumberOfCells())
                self.assertTrue(hull.GetCellData().HasArray("patch"))
                ahead.append(hull.GetBounds()[1])
            self.assertEqual(sorted(ahead), ahead)
            self.assertAlmostEqual(ahead[2] - ahead[0], float(14 / 25) * 2 / 3, delta=0.02)


if __name__ == "__main__":
    unittest.main()

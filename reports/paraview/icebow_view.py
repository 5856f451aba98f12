"""A run in ParaView: the ice by its damage from above, the pressure of the ice on the hull from below.

In ParaView (5.10 or later): open the run's ice.pvd or ice.hdf.series, select it, start this file as a macro.
Without a window:   xvfb-run -a -s "-screen 0 1600x900x24 -noreset" pvpython icebow_view.py RUN [--picture FILE.png] [--time SECONDS]
RUN is the directory of the run; it must have ParaView files (output.snapshots). No time means the last one.
"""
import builtins  # a programmable filter puts others of these names into the main module
import pathlib
import sys

from paraview import simple as pv

# Of a hull, which is read once, and the quads that the ice pressed at this time: the hull with its pressure in kPa.
ON_THE_HULL = """
from vtkmodules.vtkCommonCore import vtkFloatArray
hull, pressed = self.GetInputDataObject(0, 0), self.GetInputDataObject(0, 1)
output = self.GetPolyDataOutput()
output.ShallowCopy(hull)
kilo = vtkFloatArray()
kilo.SetName("ice_pressure_kPa")
kilo.SetNumberOfTuples(hull.GetNumberOfCells())
kilo.Fill(0.0)
data = pressed.GetCellData()
for n in range(pressed.GetNumberOfCells()):
    kilo.SetValue(data.GetArray("quad").GetValue(n), 1e-3 * data.GetArray("ice_pressure_Pa").GetValue(n))
output.GetCellData().AddArray(kilo)
"""
DEEP_SEA, DAY = [0.086, 0.239, 0.361], [0.96, 0.97, 0.98]


def list_of_steps(run):
    for name in ("ice.pvd", "ice.hdf.series"):
        if (run / name).exists():
            return run / name
    raise SystemExit(f"{run} holds no ice.pvd or ice.hdf.series: set output.snapshots in the study, or simulate "
                     "the design with `icebow simulate`")


def spacing(ice):
    """Of the particles, from the undisturbed sheet [m]."""
    bounds = ice.GetDataInformation().GetBounds()
    sides = [bounds[2 * k + 1] - bounds[2 * k] for k in range(3)]
    number, dx = ice.GetDataInformation().GetNumberOfPoints(), 0.0
    for _ in range(50):  # (length + dx) (width + dx) (height + dx) = number dx^3
        dx = ((sides[0] + dx) * (sides[1] + dx) * (sides[2] + dx) / number) ** (1 / 3)
    return dx


def show_ice(ice, view, dx):
    shown = pv.Show(ice, view)
    shown.SetRepresentationType("Point Gaussian")
    shown.ShaderPreset = "Plain circle"
    shown.GaussianRadius = 0.75 * dx  # circles that leave no gap
    pv.ColorBy(shown, ("POINTS", "damage"))
    colors = pv.GetColorTransferFunction("damage")
    colors.RGBPoints = [0.0, 0.93, 0.96, 0.98, 0.15, 0.72, 0.85, 0.93, 0.4, 0.93, 0.55, 0.2, 1.0, 0.35, 0.05, 0.05]
    legend(colors, view, shown, "damage: broken / initial bonds")


def show_hull(hull, view):
    shown = pv.Show(hull, view)
    shown.SetRepresentationType("Surface")
    pv.ColorBy(shown, ("CELLS", "ice_pressure_kPa"))
    colors = pv.GetColorTransferFunction("ice_pressure_kPa")
    most = builtins.max(1.0, hull.GetCellDataInformation().GetArray("ice_pressure_kPa").GetRange()[1])
    colors.RGBPoints = [0.0, 0.72, 0.75, 0.78, 0.02 * most, 0.99, 0.87, 0.55, 0.4 * most, 0.9, 0.35, 0.15,
                        most, 0.4, 0.0, 0.1]
    legend(colors, view, shown, "ice pressure, kPa")


def legend(colors, view, shown, title):
    bar = pv.GetScalarBar(colors, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleFontSize = bar.LabelFontSize = 13
    bar.Orientation, bar.WindowLocation, bar.ScalarBarLength = "Vertical", "Lower Left Corner", 0.45
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.3g", "%.3g"
    bar.TitleColor = bar.LabelColor = [1.0, 1.0, 1.0] if list(view.Background) == DEEP_SEA else [0.1, 0.15, 0.2]
    shown.SetScalarBarVisibility(view, True)


def render_view(size, background):
    view = pv.CreateView("RenderView")
    view.ViewSize = size
    view.UseColorPaletteForBackground = 0
    view.Background = background
    view.OrientationAxesVisibility = 0
    return view


def look(view, at, towards, up, height):
    """A parallel view of the point `at`, so many metres high."""
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = at
    view.CameraPosition = [a - 100.0 * t for a, t in zip(at, towards)]
    view.CameraViewUp = up
    view.CameraParallelScale = 0.5 * height


def show_run(run, time=None, size=(1500, 560)):
    """Builds the two views; returns their layout."""
    ice = pv.OpenDataFile(str(list_of_steps(run)))
    hull = pv.XMLPolyDataReader(FileName=[str(run / "hull.vtp")])
    pressed = pv.PVDReader(FileName=str(run / "hull_pressure.pvd"))
    times = list(pv.GetTimeKeeper().TimestepValues)
    pv.UpdatePipeline(times[0], ice)
    dx = spacing(ice)
    both = pv.ProgrammableFilter(Input=[hull, pressed], Script=ON_THE_HULL, OutputDataSetType="vtkPolyData")
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = builtins.min(times, key=lambda t: abs(t - (times[-1] if time is None else time)))
    pv.UpdatePipeline(scene.AnimationTime, both)

    bounds = hull.GetDataInformation().GetBounds()
    beam, draft = bounds[3] - bounds[2], -bounds[4]
    half = [size[0] // 2, size[1]]
    pv._DisableFirstRenderCameraReset()
    above, below = render_view(half, DEEP_SEA), render_view(half, DAY)
    layout = pv.CreateLayout("Icebow")
    left = layout.SplitHorizontal(0, 0.5)
    layout.AssignView(left, above)
    layout.AssignView(left + 1, below)
    layout.SetSize(*size)

    show_ice(ice, above, dx)
    outline = pv.Show(both, above)
    outline.SetRepresentationType("Surface")
    outline.ColorArrayName = ["CELLS", ""]
    outline.DiffuseColor, outline.Opacity = [0.69, 0.24, 0.19], 0.45
    time_of = pv.Show(pv.AnnotateTimeFilter(ice, Format="t = {time:.2f} s"), above)
    time_of.WindowLocation, time_of.FontSize = "Upper Left Corner", 14
    look(above, [-0.35 * beam, 0.0, 0.0], [0, 0, -1], [0, 1, 0], 2.1 * beam)

    show_hull(both, below)
    look(below, [-0.75 * beam, 0.0, -0.3 * draft], [-0.72, -0.5, 0.48], [0, 0, 1], 1.35 * beam)
    for view in (above, below):
        pv.Render(view)
    return layout


def option(words, name):
    return words[words.index(name) + 1] if name in words else None


def of_selected_source():
    """In ParaView's window: the directory of the run that is open."""
    source = pv.GetActiveSource()
    name = getattr(source, "FileName", None) or getattr(source, "FileNames", None)
    if not name:
        raise SystemExit(f"{__doc__}\nNo run is selected.")
    return pathlib.Path(name if isinstance(name, str) else name[0]).resolve().parent


def main(words):
    if not words:
        return show_run(of_selected_source())
    time = option(words, "--time")
    layout = show_run(pathlib.Path(words[0]).resolve(), float(time) if time else None)
    picture = option(words, "--picture") or "paraview.png"
    pv.SaveScreenshot(picture, layout)
    print(picture)


if __name__ in ("__main__", "__vtkconsole__"):  # a macro of ParaView's window has the second name
    main(sys.argv[1:])

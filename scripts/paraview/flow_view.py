# SPDX-License-Identifier: GPL-3.0-or-later
"""Coupled run in ParaView: gas speed in the middle plane, particles with true radii by their speed.

    pvbatch flow_view.py CASE [-o PICTURE.png] [--time T] [--at Z] [--length L] [--state FILE.pvsm]
    pvpython flow_view.py CASE
As a macro (Macros > Import new macro): asks for nothing when particles.pvd and case.foam are open
already, else uses the folder in the environment variable FLOW_CASE.

CASE holds particles.pvd and case.foam, which `powderlink-render flow-series CASE` writes; both play
as one series, at physical times. Colours are those of analysis/render/palette.h.
"""

import argparse
import os
import sys

from paraview import simple as pv

GRAINS = ((0.969, 0.796, 0.271), (0.933, 0.510, 0.149), (0.796, 0.243, 0.114), (0.447, 0.098, 0.055))
GAS = ((0.969, 0.976, 0.988), (0.741, 0.824, 0.910), (0.267, 0.467, 0.667), (0.071, 0.157, 0.294))
INK = (0.1, 0.1, 0.1)
STRIP_OVER_HEIGHT = 8.0


class Refused(Exception):
    """A message for the user: what failed; what was given; what is allowed; what to do."""

    def __init__(self, failed, given, allowed, to_do):
        super().__init__(f"{failed}; given: {given}; allowed: {allowed}; to do: {to_do}")


def open_case(folder):
    """Readers of particles and gas, with the physical times."""
    files = [os.path.join(folder, name) for name in ("particles.pvd", "case.foam")]
    for file in files:
        if not os.path.isfile(file):
            raise Refused(f"opening {file}", "no such file", "the folder of a coupled run with its series",
                          f"powderlink-render flow-series {folder}")
    kind = "Decomposed Case" if os.path.isdir(os.path.join(folder, "processor0")) else "Reconstructed Case"
    gas = pv.OpenFOAMReader(registrationName="gas", FileName=files[1], CaseType=kind)
    gas.MeshRegions = ["internalMesh"]
    gas.Createcelltopointfiltereddata = 1
    return pv.PVDReader(registrationName="particles", FileName=files[0]), gas


def find_open_case():
    """Readers that the user opened already, or None."""
    particles = gas = None
    for source in pv.GetSources().values():
        name = os.path.basename(str(getattr(source, "FileName", "")))
        particles = source if name == "particles.pvd" else particles
        gas = source if name.endswith(".foam") else gas
    return (particles, gas) if particles is not None and gas is not None else None


def require(source, names, to_do):
    given = source.PointData.keys()
    missing = [name for name in names if name not in given]
    if missing:
        raise Refused("colouring", "arrays " + ", ".join(given), ", ".join(names), to_do)


def largest(source, name, component, times):
    """Over all times, so that a colour means the same in every frame."""
    most = 0.0
    for time in times:
        source.UpdatePipeline(time)
        array = source.PointData[name] if name in source.PointData.keys() else None
        if array is not None and source.GetDataInformation().GetNumberOfPoints() > 0:
            most = max(most, array.GetRange(component)[1])
    return most if most > 0.0 else 1.0


def colour(display, view, array, stops, most, title, place):
    pv.ColorBy(display, array)
    table = pv.GetColorTransferFunction(array[1])
    table.AutomaticRescaleRangeMode = "Never"
    table.ColorSpace = "RGB"
    table.VectorMode = "Magnitude"
    steps = len(stops) - 1
    table.RGBPoints = [x for i, c in enumerate(stops) for x in (most * i / steps, *c)]
    bar = pv.GetScalarBar(table, view)
    bar.Title = title
    bar.ComponentTitle = ""
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.Position = place
    bar.HorizontalTitle = 1
    bar.TitleColor = bar.LabelColor = INK
    bar.ScalarBarLength = 0.36
    bar.RangeLabelFormat = "%.3g"
    bar.LabelFormat = "%.3g"
    bar.TitleFontSize = bar.LabelFontSize = 14
    display.SetScalarBarVisibility(view, True)


def place_camera(view, bounds, at, length):
    """Along x: z to the right, y up; the viewer stands where x is negative."""
    height = bounds[3] - bounds[2]
    length = min(length or STRIP_OVER_HEIGHT * height, bounds[5] - bounds[4])
    z = 0.5 * (bounds[4] + bounds[5]) if at is None else at
    y = 0.5 * (bounds[2] + bounds[3])
    width_px, height_px = view.ViewSize
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.5 * max(length * height_px / width_px, 1.1 * height)
    view.CameraFocalPoint = [bounds[0], y, z]
    view.CameraPosition = [bounds[0] - 10.0 * max(height, length), y, z]
    view.CameraViewUp = [0.0, 1.0, 0.0]


def build(folder=None, at=None, length=None):
    """The whole pipeline in the active view; returns view and all times."""
    readers = find_open_case() if folder is None else open_case(folder)
    if readers is None:
        folder = os.environ.get("FLOW_CASE")
        if not folder:
            raise Refused("finding a coupled run", "no open particles.pvd and case.foam, FLOW_CASE not set",
                          "open readers, a folder as argument, or FLOW_CASE",
                          "open CASE/particles.pvd and CASE/case.foam first")
        readers = open_case(folder)
    particles, gas = readers
    times = list(particles.TimestepValues or [0.0])
    # Times of the gas that were written; 0 often holds nothing but the start.
    gas_times = list(gas.TimestepValues or [0.0])
    particles.UpdatePipeline(times[-1])
    require(particles, ("speed_m_s", "radius_m"), "write the series again with powderlink-render flow-series")
    gas.UpdatePipeline(gas_times[-1])
    require(gas, ("U",), "let the solver write U, and create point data from cell data in the reader")

    pv._DisableFirstRenderCameraReset()  # as in the traces that ParaView writes
    view = pv.GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    for reader in readers:
        pv.Hide(reader, view)

    bounds = gas.GetDataInformation().GetBounds()
    middle = pv.Slice(registrationName="middle plane", Input=gas)
    middle.SliceType.Origin = [0.5 * (bounds[0] + bounds[1]), 0.0, 0.0]
    middle.SliceType.Normal = [1.0, 0.0, 0.0]
    plane = pv.Show(middle, view)
    plane.Ambient = 1.0
    plane.Diffuse = 0.0
    colour(plane, view, ("POINTS", "U"), GAS, largest(gas, "U", -1, gas_times), "gas: speed (m/s)",
           [0.08, 0.02])

    glyph = pv.Glyph(registrationName="grains", Input=particles, GlyphType="Sphere")
    glyph.GlyphType.Radius = 1.0
    glyph.GlyphType.ThetaResolution = 24
    glyph.GlyphType.PhiResolution = 16
    glyph.ScaleArray = ["POINTS", "radius_m"]
    glyph.ScaleFactor = 1.0
    glyph.GlyphMode = "All Points"
    grains = pv.Show(glyph, view)
    grains.Specular = 0.2
    grains.Ambient = 0.3
    colour(grains, view, ("POINTS", "speed_m_s"), GRAINS, largest(particles, "speed_m_s", 0, times),
           "particles: speed (m/s)", [0.56, 0.02])

    clock = pv.AnnotateTimeFilter(registrationName="time", Input=particles, Format="t = {time:.4g} s")
    caption = pv.Show(clock, view)
    caption.Color = INK
    caption.FontSize = 16
    pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    place_camera(view, middle.GetDataInformation().GetBounds(), at, length)
    return view, times


def main(arguments):
    parser = argparse.ArgumentParser(prog="flow_view.py", description=__doc__.splitlines()[0])
    parser.add_argument("case", nargs="?", help="folder of a coupled run with particles.pvd and case.foam")
    parser.add_argument("-o", "--output", help="write a picture")
    parser.add_argument("--time", type=float, help="physical time of the picture [s]; default: the last")
    parser.add_argument("--at", type=float, help="middle of the view on z [m]; default: the middle")
    parser.add_argument("--length", type=float, help="length of the view [m]; default: 8 channel heights")
    parser.add_argument("--state", help="write a ParaView state file (.pvsm)")
    given = parser.parse_args(arguments)
    if given.output:
        pv.GetActiveViewOrCreate("RenderView").ViewSize = [1000, 300]
    view, times = build(given.case, given.at, given.length)
    pv.GetAnimationScene().AnimationTime = times[-1] if given.time is None else given.time
    pv.Render(view)
    if given.state:
        pv.SaveState(given.state)
    if given.output:
        pv.SaveScreenshot(given.output, view, ImageResolution=[2000, 600])


if __name__ in ("__main__", "__vtkconsole__"):
    try:
        main(sys.argv[1:] if __name__ == "__main__" else [])
    except Refused as refused:
        print(f"flow_view: {refused}", file=sys.stderr)
        if __name__ == "__main__":
            sys.exit(1)

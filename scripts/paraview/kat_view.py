# SPDX-License-Identifier: GPL-3.0-or-later
"""Drop test in ParaView: spheres with their true radii, attached ones blue, leaving ones by speed.

    pvbatch kat_view.py RUN_DIR [-o PICTURE.png] [--time T] [--state FILE.pvsm]
    pvpython kat_view.py RUN_DIR
As a macro (Macros > Import new macro): asks for nothing when particles.pvd is open already, else
uses the folder in the environment variable KAT_RUN.

RUN_DIR holds particles.pvd and plate.pvd, which `powderlink-render series RUN_DIR` writes.
Colours are those of analysis/render/palette.h.
"""

import argparse
import os
import sys

from paraview import simple as pv

ATTACHED = (0.267, 0.467, 0.667)
LEAVING = ((0.969, 0.796, 0.271), (0.933, 0.510, 0.149), (0.796, 0.243, 0.114), (0.447, 0.098, 0.055))
PLATE = (0.78, 0.79, 0.81)
INK = (0.1, 0.1, 0.1)


class Refused(Exception):
    """A message for the user: what failed; what was given; what is allowed; what to do."""

    def __init__(self, failed, given, allowed, to_do):
        super().__init__(f"{failed}; given: {given}; allowed: {allowed}; to do: {to_do}")


def open_series(run):
    """Readers of particles and plate, with the physical times."""
    files = [os.path.join(run, name) for name in ("particles.pvd", "plate.pvd")]
    for file in files:
        if not os.path.isfile(file):
            raise Refused(f"opening {file}", "no such file", "the folder of a drop test with its series",
                          f"powderlink-render series {run}")
    return [pv.OpenDataFile(file) for file in files]


def find_open_series():
    """Readers that the user opened already, or None."""
    particles = plate = None
    for source in pv.GetSources().values():
        name = os.path.basename(str(getattr(source, "FileName", "")))
        particles = source if name == "particles.pvd" else particles
        plate = source if name == "plate.pvd" else plate
    return (particles, plate) if particles is not None else None


def check_arrays(particles):
    needed = ("attached", "speed_m_s", "diameter_um", "radius_m")
    given = particles.PointData.keys()
    if not all(name in given for name in needed):
        raise Refused("colouring the particles", "arrays " + ", ".join(given), ", ".join(needed),
                      "write the series again with powderlink-render series")


def largest_speed(detached, times):
    """Over all dumped times, so that a colour means the same in every frame."""
    largest = 0.0
    for time in times:
        detached.UpdatePipeline(time)
        if detached.GetDataInformation().GetNumberOfPoints() > 0:
            largest = max(largest, detached.PointData["speed_m_s"].GetRange()[1])
    return largest if largest > 0.0 else 1.0


def select(particles, attached):
    """The attached or the detached particles."""
    some = pv.Threshold(registrationName="attached" if attached else "detached", Input=particles)
    some.Scalars = ["POINTS", "attached"]
    some.LowerThreshold = 1 if attached else 0
    some.UpperThreshold = 1 if attached else 0
    return some


def show_spheres(some, view, name):
    glyph = pv.Glyph(registrationName=name, Input=some, GlyphType="Sphere")
    glyph.GlyphType.Radius = 1.0
    glyph.GlyphType.ThetaResolution = 32
    glyph.GlyphType.PhiResolution = 24
    glyph.ScaleArray = ["POINTS", "radius_m"]
    glyph.ScaleFactor = 1.0
    glyph.GlyphMode = "All Points"
    display = pv.Show(glyph, view)
    display.Specular = 0.35
    display.SpecularPower = 28.0
    return display


def colour_by_speed(display, view, largest):
    pv.ColorBy(display, ("POINTS", "speed_m_s"))
    table = pv.GetColorTransferFunction("speed_m_s")
    table.AutomaticRescaleRangeMode = "Never"
    table.ColorSpace = "RGB"
    steps = len(LEAVING) - 1
    table.RGBPoints = [x for i, c in enumerate(LEAVING) for x in (largest * i / steps, *c)]
    bar = pv.GetScalarBar(table, view)
    bar.Title = "detached: speed away from the plate (m/s)"
    bar.ComponentTitle = ""
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Lower Center"
    bar.HorizontalTitle = 1
    bar.TitleColor = bar.LabelColor = INK
    bar.ScalarBarLength = 0.4
    bar.RangeLabelFormat = "%.2f"
    bar.TitleFontSize = bar.LabelFontSize = 14
    display.SetScalarBarVisibility(view, True)


def place_camera(particles, view):
    """Looks up at the carrying face from below, near the plate: far grains may leave the view."""
    times = particles.TimestepValues or [0.0]
    particles.UpdatePipeline(times[0])
    x0, x1, y0, y1, _, z1 = particles.GetDataInformation().GetBounds()
    width = max(x1 - x0, y1 - y0, 1e-6)
    centre = [0.5 * (x0 + x1), 0.5 * (y0 + y1), z1 - 0.08 * width]
    view.CameraFocalPoint = centre
    view.CameraPosition = [centre[0], centre[1] - 2.9 * width, centre[2] - 0.8 * width]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = 20.0


def build(run=None):
    """The whole pipeline in the active view; returns view, particles and all times."""
    readers = find_open_series() if run is None else open_series(run)
    if readers is None:
        folder = os.environ.get("KAT_RUN")
        if not folder:
            raise Refused("finding a drop test", "no open particles.pvd, KAT_RUN not set",
                          "an open series, a folder as argument, or KAT_RUN",
                          "open RUN_DIR/particles.pvd first")
        readers = open_series(folder)
    particles, plate = readers
    particles.UpdatePipeline((particles.TimestepValues or [0.0])[0])
    check_arrays(particles)

    pv._DisableFirstRenderCameraReset()  # as in the traces that ParaView writes
    view = pv.GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    pv.Hide(particles, view)

    detached = select(particles, attached=False)
    largest = largest_speed(detached, particles.TimestepValues or [0.0])
    staying = show_spheres(select(particles, attached=True), view, "attached grains")
    staying.ColorArrayName = [None, ""]
    staying.AmbientColor = staying.DiffuseColor = ATTACHED
    colour_by_speed(show_spheres(detached, view, "detached grains"), view, largest)
    if plate is not None:
        carrier = pv.Show(plate, view)
        carrier.ColorArrayName = [None, ""]
        carrier.AmbientColor = carrier.DiffuseColor = PLATE
        carrier.Ambient = 0.45
        carrier.Opacity = 0.7
    clock = pv.AnnotateTimeFilter(registrationName="time", Input=particles, Format="t = {time:.3g} s")
    caption = pv.Show(clock, view)
    caption.Color = INK
    caption.FontSize = 16
    pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    place_camera(particles, view)
    return view, particles


def main(arguments):
    parser = argparse.ArgumentParser(prog="kat_view.py", description=__doc__.splitlines()[0])
    parser.add_argument("run", nargs="?", help="folder of a drop test with particles.pvd")
    parser.add_argument("-o", "--output", help="write a picture")
    parser.add_argument("--time", type=float, help="physical time of the picture [s]; default: the last")
    parser.add_argument("--state", help="write a ParaView state file (.pvsm)")
    given = parser.parse_args(arguments)
    if given.output:
        pv.GetActiveViewOrCreate("RenderView").ViewSize = [1000, 625]
    view, particles = build(given.run)
    times = particles.TimestepValues or [0.0]
    scene = pv.GetAnimationScene()
    scene.AnimationTime = times[-1] if given.time is None else given.time
    pv.Render(view)
    if given.state:
        pv.SaveState(given.state)
    if given.output:
        pv.SaveScreenshot(given.output, view, ImageResolution=[2000, 1250])


if __name__ in ("__main__", "__vtkconsole__"):
    try:
        main(sys.argv[1:] if __name__ == "__main__" else [])
    except Refused as refused:
        print(f"kat_view: {refused}", file=sys.stderr)
        if __name__ == "__main__":
            sys.exit(1)

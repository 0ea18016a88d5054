#!/usr/bin/env python3
# Copyright (c) 2026 The Restricted_laplacian_3 developers
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws colored meshes side by side, with VTK.

Each panel is a PLY file with vertex colors, FILE, or the difference of the colors of two files with
the same vertices, FILE-FILE, in gray: black is 0, white 1 / GAIN and more. Without a display, run
it under xvfb-run. Debian packages: python3-vtk9, xvfb, xauth.

Example:
  xvfb-run -a draw_colored_meshes.py --output seams.png --direction 1,0.3,1 \\
    nearest.ply "nearest scan" stitched.ply "stitched" stitched.ply-truth.ply "error, times 5"
"""

import argparse
import math
import os
import sys

import vtk


def numbers(text):
    return [float(word) for word in text.split(",")]


def read_mesh(file):
    if not os.path.isfile(file):
        sys.exit("draw_colored_meshes: cannot open '%s'" % file)
    reader = vtk.vtkPLYReader()
    reader.SetFileName(file)
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetPointData().GetScalars() is None:
        sys.exit("draw_colored_meshes: '%s' has no vertex colors" % file)
    return mesh


def difference(mesh, other, gain):
    """The lengths of the differences of colors, as gray colors of `mesh`."""
    a, b = mesh.GetPointData().GetScalars(), other.GetPointData().GetScalars()
    if a.GetNumberOfTuples() != b.GetNumberOfTuples():
        sys.exit("draw_colored_meshes: the files have different numbers of vertices")
    gray = vtk.vtkUnsignedCharArray()
    gray.SetNumberOfComponents(3)
    gray.SetNumberOfTuples(a.GetNumberOfTuples())
    for i in range(a.GetNumberOfTuples()):
        x, y = a.GetTuple(i), b.GetTuple(i)
        length = math.sqrt(sum((x[k] - y[k]) ** 2 for k in range(3)) / 3)
        value = min(255, round(gain * length))
        gray.SetTuple3(i, value, value, value)
    mesh.GetPointData().SetScalars(gray)


def panel(spec, gain):
    """A mesh for the specification of a panel."""
    if os.path.isfile(spec) or "-" not in spec:
        return read_mesh(spec)
    for i, letter in enumerate(spec):
        if letter == "-" and os.path.isfile(spec[:i]) and os.path.isfile(spec[i + 1:]):
            mesh = read_mesh(spec[:i])
            difference(mesh, read_mesh(spec[i + 1:]), gain)
            return mesh
    sys.exit("draw_colored_meshes: '%s' is neither a file nor FILE-FILE" % spec)


def renderer_of(mesh, title, options, camera):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    normals.ConsistencyOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.SetInterpolateScalarsBeforeMapping(False)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    surface = actor.GetProperty()
    surface.SetInterpolationToPhong()
    surface.SetAmbient(1 - options.shading)
    surface.SetDiffuse(options.shading)
    surface.SetSpecular(0)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    if title:
        text = vtk.vtkTextActor()
        text.SetInput(title)
        text.GetTextProperty().SetFontSize(options.size // 24)
        text.GetTextProperty().SetColor(0, 0, 0)
        text.GetTextProperty().SetJustificationToCentered()
        text.SetPosition(options.size // 2, options.size // 50)
        renderer.AddActor2D(text)
    renderer.SetActiveCamera(camera)
    return renderer


def look_at(mesh, options):
    """A camera with parallel rays that sees the mesh, or the ball of --focus."""
    low, high = mesh.GetBounds()[0::2], mesh.GetBounds()[1::2]
    center = [(a + b) / 2 for a, b in zip(low, high)]
    radius = math.sqrt(sum((b - a) ** 2 for a, b in zip(low, high))) / 2
    scale = radius
    if options.focus:
        center, scale = options.focus[:3], options.focus[3]
    length = math.sqrt(sum(x * x for x in options.direction))
    camera = vtk.vtkCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(center)
    camera.SetPosition([c + 4 * radius * x / length for c, x in zip(center, options.direction)])
    camera.SetViewUp(options.up)
    camera.SetParallelScale(scale / options.zoom)
    camera.SetClippingRange(0.1 * radius, 10 * radius)
    return camera


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("panels", nargs="+", metavar="PANEL TITLE",
                        help="what to draw, and the line below it, which may be empty")
    parser.add_argument("--output", required=True, metavar="FILE", help="the PNG file")
    parser.add_argument("--direction", type=numbers, default=[0.3, 0.3, 1], metavar="X,Y,Z",
                        help="from the mesh to the eye (default 0.3,0.3,1)")
    parser.add_argument("--up", type=numbers, default=[0, 1, 0], metavar="X,Y,Z",
                        help="what points up (default 0,1,0)")
    parser.add_argument("--focus", type=numbers, metavar="X,Y,Z,R",
                        help="draw the ball with this center and radius; default: all")
    parser.add_argument("--zoom", type=float, default=1, metavar="Z", help="default 1")
    parser.add_argument("--size", type=int, default=480, metavar="N",
                        help="pixels along each side of a panel (default 480)")
    parser.add_argument("--columns", type=int, default=0, metavar="N",
                        help="panels in a row (default: all)")
    parser.add_argument("--shading", type=float, default=0.35, metavar="S",
                        help="part of the light that depends on the slope (default 0.35)")
    parser.add_argument("--gain", type=float, default=5, metavar="G",
                        help="of differences (default 5)")
    options = parser.parse_args()
    if len(options.panels) % 2:
        parser.error("every panel needs a title, which may be empty")

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    number = len(options.panels) // 2
    columns = options.columns or number
    rows = -(-number // columns)
    window.SetSize(columns * options.size, rows * options.size)
    camera = None
    for i in range(number):
        mesh = panel(options.panels[2 * i], options.gain)
        camera = camera or look_at(mesh, options)
        renderer = renderer_of(mesh, options.panels[2 * i + 1], options, camera)
        column, row = i % columns, rows - 1 - i // columns
        renderer.SetViewport(column / columns, row / rows, (column + 1) / columns,
                             (row + 1) / rows)
        window.AddRenderer(renderer)
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(options.output)
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()

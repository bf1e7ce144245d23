"""DrawIsosurface.py <DICOM folder, .inv3, .mha or .vti> <isovalue> [picture.png]: a scan from the front"""
import sys

import hasp
import vtkmodules.vtkInteractionStyle  # what dragging the mouse does
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import *

hasp.UseHeadlessWindows()  # before the first window; changes nothing where DISPLAY is set
reader = hasp.vtkHaspVolumeReader()  # whatever the file: patient LPS, millimetres
reader.SetFileName(sys.argv[1])
reader.Update()
if reader.GetErrorCode():  # what is wrong has been printed
    sys.exit(1)
mapper = hasp.vtkHaspClusteredCellMapper()  # in place of a contour filter and vtkPolyDataMapper
mapper.SetInputConnection(reader.GetOutputPort())
mapper.SetIsoValue(float(sys.argv[2]))
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.GetActiveCamera().SetPosition(0, -1, 0)  # from anterior,
renderer.GetActiveCamera().SetViewUp(0, 0, 1)     # superior up
renderer.ResetCamera()
window = vtkRenderWindow()
window.SetSize(600, 600)
window.AddRenderer(renderer)
if len(sys.argv) == 4:
    pixels = vtkWindowToImageFilter()
    pixels.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetInputConnection(pixels.GetOutputPort())
    writer.SetFileName(sys.argv[3])
    writer.Write()
else:  # a window to turn by hand
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    window.Render()
    interactor.Start()

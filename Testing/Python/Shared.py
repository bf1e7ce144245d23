"""What several cases need."""
import array
import math

from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData

RADIUS = 9.0  # mm


def ball():
    """Radius minus distance from the origin, 25^3 samples of 1 mm: inside is >= 0."""
    side = range(-12, 13)
    values = array.array("f", (RADIUS - math.sqrt(x * x + y * y + z * z)
                               for z in side for y in side for x in side))
    scalars = vtkFloatArray()
    scalars.SetNumberOfValues(len(values))
    for i, value in enumerate(values):
        scalars.SetValue(i, value)
    image = vtkImageData()
    image.SetExtent(0, 24, 0, 24, 0, 24)
    image.SetOrigin(-12, -12, -12)
    image.GetPointData().SetScalars(scalars)
    return image


def errors_of(algorithm):
    """What it reports from now on. The executive reports for a filter without input."""
    said = []

    def keep(_caller, _event, text):
        said.append(text)
    keep.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", keep)
    return said

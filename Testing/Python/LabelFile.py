"""A label map with names, and a reader of .seg.nrrd that is not ours: the standard library alone."""
import gzip
import math
import pathlib
import re
import struct

from vtkmodules.vtkCommonCore import vtkStringArray, vtkUnsignedCharArray, vtkUnsignedShortArray
from vtkmodules.vtkCommonDataModel import vtkImageData

NAME = 'Kiefer "l\u00e4nks": a:=b \\ c\nd'
LABELS = [0, 2, 65535, 0, 0, 0, 0, 0, 2, 0, 0, 9]


def label_image(labels):
    """3 x 2 x 2 samples, oblique, with two names."""
    image = vtkImageData()
    image.SetDimensions(3, 2, 2)
    image.SetOrigin(-10.5, 20.25, 3)
    image.SetSpacing(0.5, 0.75, 2)
    image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
    scalars = vtkUnsignedShortArray()
    for label in labels:
        scalars.InsertNextValue(label)
    image.GetPointData().SetScalars(scalars)
    values, names, colors = vtkUnsignedShortArray(), vtkStringArray(), vtkUnsignedCharArray()
    values.SetName("LabelValues")
    names.SetName("LabelNames")
    colors.SetName("LabelColors")
    colors.SetNumberOfComponents(3)
    for value, name, color in ((65535, NAME, (255, 128, 0)), (2, "two", (1, 2, 3))):
        values.InsertNextValue(value)
        names.InsertNextValue(name)
        colors.InsertNextTuple3(*color)
    for column in (values, names, colors):
        image.GetFieldData().AddArray(column)
    return image


def parse_segmentation(path):
    """Fields, pairs and samples, by the standard library alone."""
    header, data = pathlib.Path(path).read_bytes().split(b"\n\n", 1)
    fields, pairs = {}, {}
    for line in header.decode("utf-8").split("\n")[1:]:
        if ":=" in line:
            key, value = line.split(":=", 1)
            pairs[key] = re.sub(r"\\(.)", lambda m: "\n" if m[1] == "n" else m[1], value)
        else:
            key, value = line.split(": ", 1)
            fields[key] = value
    data = gzip.decompress(data) if fields["encoding"] == "gzip" else data
    count = math.prod(int(size) for size in fields["sizes"].split())
    return fields, pairs, list(struct.unpack(f"<{count}H", data))

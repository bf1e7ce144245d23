#ifndef vtkHaspLabelTable_h
#define vtkHaspLabelTable_h

#include "Grid/LabelTable.h"           // for LabelTable
#include "vtkHaspCommonVolumeModule.h" // for export macro

class vtkDataObject;

/// What the labels of an image are called, as field data that goes along with it: one tuple a label
/// in
///   "LabelValues"   unsigned short
///   "LabelNames"    string, UTF-8
///   "LabelColors"   unsigned char, 3 components: red, green, blue
///   "LabelsOfBone"  unsigned char, 1: a label of bone; may be absent, then nothing is said of it
/// VTK's filters hand field data on; what takes an image apart or makes another does not.
/// Any thread, as long as no other one uses the data object.
namespace hasp
{

/// In place of the table that the data object has. An empty table removes it.
VTKHASPCOMMONVOLUME_EXPORT void SetLabelTable(vtkDataObject* data, const LabelTable& table);

/// Empty if there are no such arrays. Throws std::invalid_argument if some are there and others
/// not, if they differ in length, type or components, and if a value is 0 or stands twice.
VTKHASPCOMMONVOLUME_EXPORT LabelTable GetLabelTable(vtkDataObject* data);

} // namespace hasp

#endif

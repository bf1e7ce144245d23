#ifndef vtkHaspResourceTable_h
#define vtkHaspResourceTable_h

#include "Grid/ResourceUse.h"          // for ResourceList
#include "vtkHaspCommonVolumeModule.h" // for export macro

class vtkTable;

namespace hasp
{

/// Resources as rows of a table, for what cannot take a ResourceList (Python). Columns: "resource"
/// (string), "bytes" (vtkIdType), "milliseconds" (double), "reason" (string). What the table held
/// goes. Any thread, as long as no other one uses the table.
VTKHASPCOMMONVOLUME_EXPORT void FillTable(const ResourceList& resources, vtkTable* table);

} // namespace hasp

#endif

#ifndef ClusteredCellAttributes_h
#define ClusteredCellAttributes_h
// Private to vtkHaspClusteredCellMapper.

#include "CellColoring.h"
#include "CellLabels.h"
#include "Grid/Stopwatch.h"
#include "Isosurface/CellAttributes.h"
#include "vtkHaspClusteredCellMapper.h"

#include "vtkAbstractArray.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <limits>
#include <string>

namespace hasp
{

/// "a, b, c", for a message.
std::string PointArrayNames(vtkPointData* data);

} // namespace hasp

/// What the mapper's cells have besides their places and samples, and from what it was made.
struct vtkHaspClusteredCellMapper::Attributes
{
  hasp::CellLabels Labels;
  vtkTimeStamp LabelsTime; ///< of what is said of labels
  double LabelsMilliseconds = 0.0;
  vtkMTimeType LabelledCells = 0; ///< time of the cells that were labelled last,
  std::string LabelArray;         ///< and by which array

  glm::ivec3 MarkedLow{ std::numeric_limits<int>::max() }; ///< samples whose labels are marked,
  glm::ivec3 MarkedHigh{ std::numeric_limits<int>::min() };
  bool Marked() const { return this->MarkedLow.x <= this->MarkedHigh.x; } ///< if any are
  vtkMTimeType EditedSince = 0, EditedTime = 0; ///< Time before and after the last edit of labels,
  hasp::CellRange EditedCells;                  ///< and what that was

  hasp::CellColoring Coloring;
  vtkWeakPointer<vtkAbstractArray> ColorArray; ///< null if it is the volume itself
  double ColorsMilliseconds = 0.0;
  vtkMTimeType ColoredCells = 0; ///< time of the cells that were coloured last,
  vtkMTimeType ColorsTime = 0;   ///< and of the mapper's settings then

  vtkTimeStamp Time; ///< of the last change of the cells' labels or colours
};

#endif

#ifndef vtkHaspLabelFile_h
#define vtkHaspLabelFile_h

#include "Grid/GridGeometry.h"      // for GridGeometry
#include "Grid/LabelTable.h"        // for LabelTable
#include "Grid/Progress.h"          // for ProgressFunction
#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkHaspOutputFile.h"      // for SegmentationWriteSettings
#include "vtkHaspVolumeFile.h"      // for Passport, OpenedVolume
#include "vtkSmartPointer.h"        // for return values

#include <optional> // for what may be left out
#include <string>   // for paths

class vtkImageData;

/// Label maps in and out of files without a pipeline: what vtkHaspSegmentationReader and
/// vtkHaspSegmentationWriter are skins of. Any thread; nothing is kept between calls.
namespace hasp
{

struct LoadedLabels
{
  Passport passport;                   ///< of the file; its geometry is the file's grid
  vtkSmartPointer<vtkImageData> image; ///< extent from 0; scalars unsigned short
  LabelTable table;                    ///< what the file names; empty where it names nothing
};

/// The labels of a file that OpenVolume took: .seg.nrrd, or .nrrd, .mha, .nii, .vti whose samples
/// are whole numbers in [0, 65535], which are taken as they are. Refused: floating point (even if
/// all numbers are whole), a rescaling, negative numbers, and formats that only hold scans (DICOM,
/// InVesalius). Overlapping segments are refused as OpenVolume does.
///
/// onto  the scan's grid: the labels are put on it, cropped or not, as PlaceLabels does, and
/// refused
///       where they are of another grid or outside of it. None: they stay on the file's grid.
///
/// Throws std::runtime_error with the file's label; Cancelled. Memory: the file's samples, and two
/// bytes for each sample of the file's grid and of the scan's, held to the limit of
/// VolumeReadSettings each.
VTKHASPIOMEDICAL_EXPORT LoadedLabels LoadLabels(const OpenedVolume& opened,
  const std::optional<GridGeometry>& onto = {}, const ProgressFunction& progress = {});

/// By the ending: .seg.nrrd with the table (WriteSegmentation; labels that it lacks are named by
/// UnnamedLabel, so that 3D Slicer shows all), or .nrrd, .mha, .nii, .nii.gz, .vti as WriteVolume
/// does, the samples bit by bit and without the table. Scalars are unsigned char or unsigned short.
/// The file appears whole or not at all. Throws std::invalid_argument (labels, table),
/// std::runtime_error (file); Cancelled (.seg.nrrd only).
VTKHASPIOMEDICAL_EXPORT void WriteLabels(vtkImageData* labels, const LabelTable& table,
  const std::string& path, const SegmentationWriteSettings& settings = {},
  const ProgressFunction& progress = {});

} // namespace hasp

#endif

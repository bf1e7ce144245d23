#pragma once
#include "Model/ScanShelf.h"
#include "Steps/SurfaceShelf.h"

#include "Evaluation/MeshCheck.h"
#include "Grid/LabelTable.h"
#include "vtkHaspSurfaceFile.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace hasp
{

/// What is asked for, as a WORKER takes it along.
struct ImportRequest
{
  std::string path; ///< UTF-8, of a file or a folder; never shown
  VolumeReadSettings settings;
  PlanId volume = 0;                    ///< that a label map would be of; 0: there is no scan
  std::optional<GridGeometry> scan;     ///< its grid
  std::filesystem::path keepIn;         ///< ScanShelf::Folder()
  std::filesystem::path keepSurfacesIn; ///< SurfaceShelf::Folder()
  std::filesystem::path blobs;          ///< PlanSession::Folder()
};

struct ImportedScan
{
  ShelfScan scan;
};

struct ImportedLabels
{
  PlanId volume = 0; ///< the request's
  Passport passport;
  std::string blob;   ///< the map on the scan's grid, stored beside the plan
  LabelTable present; ///< of the labels that occur
};

struct ImportedSurface
{
  SurfacePassport passport;
  MeshCheck check;
  SurfaceShelf::Mesh mesh; ///< as the file has it, LPS mm
  std::string hash;        ///< SurfaceHash
};

/// Faults that are known as data: what to do about them can be offered.
struct RefusedScan
{
  Passport passport;
};

/// What is wrong, and what to do; no name of the file.
struct RefusedFile
{
  std::string text;
};

using Imported =
  std::variant<ImportedScan, ImportedLabels, ImportedSurface, RefusedScan, RefusedFile>;

/// Reads whatever it is: a surface by its name; a segmentation of 3D Slicer, and where there is a
/// scan any image that looks like labels (whole numbers from 0 on, at most 64 different ones), as a
/// label map on its grid; else a scan. Scans and surfaces are kept. WORKER. Throws
/// Cancelled, and what is no fault of the file.
Imported ReadImport(const ImportRequest& request, const ProgressFunction& progress);

} // namespace hasp

#include "Window/Samples.h"

#include "Grid/Phantom.h"
#include "Studies/FractureCases.h"
#include "vtkHaspVolumeHash.h"
#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

/// Samples that were made here, with the passport that a file of them would have.
ShelfScan Generated(const GridGeometry& geometry, std::vector<std::int16_t> samples)
{
  ShelfScan scan;
  Passport& passport = scan.passport;
  passport.format = "generated phantom";
  passport.geometry = geometry;
  passport.modality = "CT";
  passport.hounsfield = true;
  passport.sampleType = "int16";
  const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
  passport.minimum = *least;
  passport.maximum = *most;
  passport.hash = VolumeHash(GridView<const std::int16_t>{ samples.data(), geometry });
  scan.image = MakeImage(geometry, std::move(samples));
  return scan;
}

ShelfScan Phantom(PhantomAnatomy anatomy, double spacingMm)
{
  PhantomSettings settings;
  settings.anatomy = anatomy;
  const GridGeometry grid = PhantomGrid(glm::dvec3(spacingMm), settings);
  return Generated(grid, SamplePhantom(grid, settings));
}
} // namespace

std::string SampleFile()
{
  const fs::path program = fs::u8path(QCoreApplication::applicationDirPath().toStdString());
  std::vector<fs::path> files{ "/usr/share/doc/invesalius-examples/examples/Cranium.inv3",
    program / "../../.cache/Cranium.inv3", program / "../share/hasp/Cranium.inv3" };
  if (const char* said = std::getenv("HASP_SAMPLE"); said && *said)
    files = { said };
  for (const fs::path& file : files)
    if (std::error_code ignored; fs::exists(file, ignored))
      return file.string();
  return {};
}

std::vector<ShelfScan> MakeSample(
  Sample sample, const std::string& file, const ProgressFunction& progress)
{
  switch (sample)
  {
    case Sample::Skull:
      if (!file.empty())
        return { ScanShelf::Read(file, {}, progress) };
      return { Phantom(PhantomAnatomy::Head, 0.8) };
    case Sample::Mandible:
    {
      const FractureCase jaw = BrokenMandible({ .spacingMm = 0.8, .moved = true });
      FracturedScan scan = BreakPhantom(jaw.geometry, jaw.settings, progress);
      return { Generated(scan.geometry, std::move(scan.samples)) };
    }
    case Sample::Fibula:
      return { Phantom(PhantomAnatomy::Head, 1.0), Phantom(PhantomAnatomy::Fibula, 1.0) };
  }
  return {};
}

} // namespace hasp

#include "ReportImport.h"

#include "ImportMethods.h"
#include "ImportSubject.h"
#include "Pairing.h"
#include "ReportRegistry.h"
#include "ScratchFolder.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace hasp
{
namespace
{

std::string InMm(double error)
{
  return std::isfinite(error) ? std::to_string(error) + " mm" : "not found";
}

std::string IdOf(const ImportFormat& format, const ImportRival& rival)
{
  return "import." + format.id + ".time." + rival.name.substr(0, rival.name.find(' '));
}

void Compare(ReportContext& context, const ImportSubject& subject, const ImportFormat& format,
  const ImportRival& rival, const std::string& file)
{
  const double ours = PlaceError(ReadOurs(file), subject);
  const double theirs = PlaceError(rival.read(file), subject);
  const PairedTimes times = ComparePairs([&] { return TimeOf([&] { ReadOurs(file); }); },
    [&] { return TimeOf([&] { rival.read(file); }); });
  ReportRow time;
  time.id = IdOf(format, rival) + "@" + subject.data;
  time.method = "import." + format.id;
  time.value = times.ratio.median;
  time.unit = "ratio";
  time.better = Better::Lower;
  time.rival = rival.name + ", which puts a marker " + InMm(theirs) + " off";
  time.error = ours;
  time.errorUnit = "mm";
  time.timeS = times.a.wallS;
  time.cpuS = times.a.cpuS;
  time.q1 = times.ratio.q1;
  time.q3 = times.ratio.q3;
  time.n = times.pairs;
  time.data = subject.data + ", oblique, file in the page cache";
  context.report.rows.push_back(time);
  const std::string curve = "import." + format.id + ".error_time@" + subject.data;
  if (rival.name == format.rivals.front().name) // ours once
    context.report.curves.push_back(
      { curve, "Hasp", "ms", "mm", { { 1e3 * times.a.wallS, ours } } });
  if (std::isfinite(theirs))
    context.report.curves.push_back(
      { curve, rival.name, "ms", "mm", { { 1e3 * times.b.wallS, theirs } } });
}

/// Geometry that is hard to keep: each format must give it back within 1e-4 mm.
void AddStability(ReportContext& context, const std::filesystem::path& folder)
{
  struct Extreme
  {
    const char* name;
    double spacing, origin;
  };
  int count = 0;
  for (const Extreme& extreme : { Extreme{ "spacing 0.01 mm", 0.01, 0.0 },
         Extreme{ "spacing 1000 mm", 1e3, 0.0 }, Extreme{ "origin 1000 mm away", 0.4, 1e3 } })
    for (const ImportFormat& format : ImportFormats())
    {
      ImportSubject subject = MakeImportSubject(12);
      subject.geometry.spacing = glm::dvec3(extreme.spacing);
      subject.geometry.origin = glm::dvec3(extreme.origin, -extreme.origin, extreme.origin);
      subject.image->SetSpacing(&subject.geometry.spacing.x);
      subject.image->SetOrigin(&subject.geometry.origin.x);
      const std::string file =
        WriteImport(subject.image, format, folder / (format.id + std::to_string(++count)));
      const double error = PlaceError(ReadOurs(file), subject);
      // float32 keeps 24 bits: of a kilometre's extent, that is the limit and not 1e-4 mm
      const double limit = std::max(1e-4, 12.0 * extreme.spacing * 0x1p-23);
      context.report.stability.push_back(
        { "import." + format.id + ".place", extreme.name, error <= limit, error, limit, "mm" });
    }
}

} // namespace

void ReportImport(ReportContext& context)
{
  const ScratchFolder scratch;
  AddStability(context, scratch.Path());
  const ImportSubject subject = MakeImportSubject(context.settings.quick ? 96 : 256);
  double done = 0.1;
  const std::vector<ImportFormat> formats = ImportFormats();
  for (const ImportFormat& format : formats)
  {
    context.progress(done += 0.9 / double(formats.size() + 1), "import: " + format.id);
    const std::string file = WriteImport(subject.image, format, scratch.Path() / format.id);
    for (const ImportRival& rival : format.rivals)
      Compare(context, subject, format, rival, file);
    if (format.ending.empty())
      ReportFaultyFolders(context, format, scratch.Path());
  }
}

} // namespace hasp

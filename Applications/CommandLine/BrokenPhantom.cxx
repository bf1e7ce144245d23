#include "BrokenPhantom.h"

#include "Session.h"
#include "VerbWork.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Studies/FractureCases.h"
#include "vtkImageData.h"

namespace hasp
{

void WriteBrokenPhantom(const BrokenPhantomChoices& choices, Session& session)
{
  const FractureCaseSettings settings{ .spacingMm = choices.spacingMm,
    .moved = choices.moved,
    .coneBeam = choices.coneBeam,
    .seed = choices.seed };
  const FractureCase broken =
    choices.which == "head" ? BrokenHead(settings) : BrokenMandible(settings);
  session.progress.Step("breaking the phantom");
  const auto start = std::chrono::steady_clock::now();
  const FracturedScan scan = BreakPhantom(broken.geometry, broken.settings,
    [&session](double share)
    {
      session.progress.Share(share);
      return true;
    });
  session.resources.push_back({ "samples and truth", 4 * scan.samples.size(),
    MillisecondsSince(start), "phantom, int16, and labels, uint16" });
  WriteVolume(MakeImage(scan.geometry, scan.samples), choices.output);
  session.result["output"] = FileLabel(choices.output);
  auto& fragments = session.result["fragments"] = nlohmann::ordered_json::array();
  LabelTable table;
  for (std::size_t n = 0; n < scan.names.size(); ++n)
  {
    LabelEntry entry = UnnamedLabel(static_cast<std::uint16_t>(n + 2));
    entry.name = scan.names[n];
    fragments.push_back({ { "label", entry.value }, { "name", entry.name } });
    table.push_back(std::move(entry));
  }
  if (choices.truth.empty())
    return;
  WriteLabels(MakeImage(scan.geometry, scan.truth), table, choices.truth);
  session.result["truth"] = FileLabel(choices.truth);
}

} // namespace hasp

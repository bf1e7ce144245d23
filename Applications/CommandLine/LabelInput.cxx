#include "LabelInput.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "VerbWork.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspLabelTable.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <type_traits>
#include <vector>

namespace hasp
{
namespace
{

constexpr std::size_t FewValues = 64; ///< fragments have fewer, a scan's grey values are more

/// How many different values there are; counts no further than to `most` + 1.
template <typename T>
std::size_t CountValues(const GridView<const T>& samples, std::size_t most)
{
  std::vector<bool> seen(65536);
  std::size_t count = 0;
  for (std::size_t n = 0; n < samples.geometry.Size() && count <= most; ++n)
  {
    const auto value = static_cast<std::uint16_t>(samples.data[n]);
    count += !seen[value];
    seen[value] = true;
  }
  return count;
}

bool LooksLikeScan(const GridView<const std::uint16_t>& labels)
{
  if (CountValues(labels, FewValues) <= FewValues)
    return false;
  std::size_t inside = 0, alike = 0; // of voxels that are not 0; rows' ends count little
  for (std::size_t n = 1; n < labels.geometry.Size(); ++n)
    if (labels.data[n] != 0)
    {
      ++inside;
      alike += labels.data[n] == labels.data[n - 1];
    }
  return 2 * alike < inside;
}

} // namespace

LoadedLabels ReadLabels(
  const std::string& path, const std::optional<GridGeometry>& onto, Session& session)
{
  RequireInput(path);
  session.progress.Step("reading " + FileLabel(path));
  const LoadedLabels labels =
    Try(ExitCode::BadInput, "", [&] { return LoadLabels(OpenVolume(path), onto); });
  if (LooksLikeScan(std::get<GridView<const std::uint16_t>>(ViewImage(labels.image))))
    throw Failure(ExitCode::BadInput,
      FileLabel(path) + ": is a scan by its values, which differ from voxel to voxel: a label map "
                        "is asked for, with a number for each fragment");
  SetLabelTable(labels.image, labels.table);
  return labels;
}

void RequireScan(const LoadedVolume& volume, const std::string& path, Session& session)
{
  const std::string remedy = "give the scan as IN, and labels to begin with by --labels, with a "
                             "--recipe of what is to be done to them";
  if (!volume.segments.empty())
    throw Failure(ExitCode::BadInput, FileLabel(path) + ": is a segmentation; " + remedy);
  const auto hasFewValues = []<typename T>(const GridView<const T>& samples)
  {
    if constexpr (std::is_integral_v<T>)
      return CountValues(samples, FewValues) <= FewValues;
    return false;
  };
  if (volume.passport.minimum >= 0.0 && std::visit(hasFewValues, ViewImage(volume.image)))
    SayWarning(session,
      FileLabel(path) + ": has at most " + std::to_string(FewValues) +
        " different values, whole numbers from 0 on, as a label map has; if it is one, " + remedy);
}

} // namespace hasp

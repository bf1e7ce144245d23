#include "CutFiles.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace hasp
{
namespace
{

std::string NameOf(const BoneFragment& fragment, char between)
{
  return (fragment.crumb ? "crumb" : "fragment") + (between + std::to_string(fragment.number));
}

} // namespace

std::string NameOfFile(const BoneFragment& fragment, const std::string& format)
{
  return NameOf(fragment, '-') + "." + format;
}

void WriteFragments(const std::filesystem::path& folder, const CutBone& cut,
  const std::string& format, const std::string& hash)
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  std::vector<NamedSurface> kept;
  for (const BoneFragment& fragment : cut.fragments)
  {
    surfaces.push_back(MakePolyData(fragment.mesh));
    const std::string name = NameOf(fragment, ' ');
    WriteSurface(surfaces.back(), (folder / NameOfFile(fragment, format)).string(),
      { .name = name, .hash = hash });
    if (!fragment.crumb && !fragment.resected)
      kept.push_back({ name, surfaces.back() });
  }
  if (format == "3mf" && !kept.empty())
    WriteSurfaces(kept, (folder / "fragments.3mf").string(), { .name = "bone", .hash = hash });
}

} // namespace hasp

#pragma once
#include "View/MeshProp.h"
#include "View/SceneEntries.h"

#include <map>
#include <memory>
#include <string>

namespace hasp
{

struct SurfaceEntry
{
  std::string hash;
  std::unique_ptr<MeshProp> shown;
};

/// Fragments that are surfaces, where the reduction has them. Plans do not hold triangles: whoever
/// has read them puts them here. Threads: RENDER.
class SurfaceProps : public SceneEntries<SurfaceEntry>
{
public:
  using SceneEntries::SceneEntries;

  /// The triangles of that SurfaceHash; nullptr: they are released.
  void Put(const std::string& hash, vtkPolyData* mesh);

  bool Sync() override;
  void ListResources(ResourceList& list) const override;

private:
  std::map<std::string, vtkSmartPointer<vtkPolyData>> Meshes;
};

} // namespace hasp

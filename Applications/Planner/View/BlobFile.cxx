#include "View/BlobFile.h"

#include "Planning/PlanFile.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspSurfaceFile.h"
#include "vtkHaspVolumeFile.h"

#include "vtkNew.h"
#include "vtkPolyDataNormals.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

constexpr double EdgeDegrees = 30.0;

/// A blob under a name with an ending, gone with this.
class NamedBlob
{
public:
  NamedBlob(const fs::path& folder, const std::string& blob, const char* name)
  {
    const std::string bytes = ReadBlob(folder, blob);
    std::string pattern = (folder / "shown-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
      Refuse();
    this->Folder = pattern;
    this->File = this->Folder / name;
    std::ofstream file(this->File, std::ios::binary);
    file.write(bytes.data(), std::streamsize(bytes.size()));
    file.close();
    if (file)
      return;
    std::error_code ignored;
    fs::remove_all(this->Folder, ignored);
    Refuse();
  }
  ~NamedBlob()
  {
    std::error_code ignored; // the folder is the planner's own, and goes as a whole
    fs::remove_all(this->Folder, ignored);
  }
  NamedBlob(const NamedBlob&) = delete;
  NamedBlob& operator=(const NamedBlob&) = delete;
  std::string Path() const { return this->File.string(); }

private:
  [[noreturn]] static void Refuse()
  {
    throw std::runtime_error("no file can be written in the planner's own folder; make room on the "
                             "disk");
  }
  fs::path Folder, File;
};

const char* NameFor(PartFormat format)
{
  switch (format)
  {
    case PartFormat::ThreeMf:
      return "part.3mf";
    case PartFormat::Ply:
      return "part.ply";
    case PartFormat::Obj:
      return "part.obj";
    default:
      return "part.stl";
  }
}

} // namespace

vtkSmartPointer<vtkImageData> ReadLabelBlob(
  const fs::path& folder, const std::string& blob, const ProgressFunction& progress)
{
  const NamedBlob file(folder, blob, "labels.nrrd");
  return LoadLabels(OpenVolume(file.Path()), std::nullopt, progress).image;
}

vtkSmartPointer<vtkPolyData> ReadMeshBlob(const fs::path& folder, const std::string& blob,
  PartFormat format, const ProgressFunction& progress)
{
  const NamedBlob file(folder, blob, NameFor(format));
  return WithNormals(LoadSurface(file.Path(), {}, progress).surface);
}

vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* mesh, bool whole)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SetFeatureAngle(EdgeDegrees);
  normals->SetSplitting(!whole);
  normals->ConsistencyOff(); // files' own windings are right
  normals->Update();
  return normals->GetOutput();
}

} // namespace hasp

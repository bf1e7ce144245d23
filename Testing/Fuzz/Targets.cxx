#include "Targets.h"

#include "SeedFiles.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspSurfaceFile.h"
#include "vtkHaspVolumeFile.h"
#include "vtkHaspVolumeSlabReader.h"

#include "vtk_zlib.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <new>
#include <stdexcept>

namespace hasp
{
namespace
{

struct RemovedAtEnd
{
  std::filesystem::path folder;
  ~RemovedAtEnd()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->folder, ignored);
  }
};

VolumeReadSettings SmallLimits()
{
  VolumeReadSettings settings;
  settings.memoryLimitBytes = std::size_t(256) << 20;
  return settings;
}

using Path = std::filesystem::path;

void ReadVolume(const Path& file, const Path&)
{
  LoadVolume(OpenVolume(file.string(), SmallLimits()));
}

void ReadSurface(const Path& file, const Path&)
{
  SurfaceReadSettings settings;
  settings.memoryLimitBytes = std::size_t(256) << 20;
  LoadSurface(file.string(), settings);
}

void ReadCells(const Path& file, const Path&)
{
  UseCells(*LoadCells(file.string(), { std::size_t(256) << 20 }));
}

void ReadSlabs(const Path& file, const Path&)
{
  VolumeSlabReader reader(file.string(), SmallLimits());
  const int depth = reader.GetPassport().geometry.dims.z;
  for (int first = 0; first < depth; first += 2)
    reader.Read(first, std::min(3, depth - first));
}

/// The third slice of a sound series is the file.
void ReadSeries(const Path& file, const Path& seeds)
{
  const Path series = file.parent_path() / "series";
  std::filesystem::copy(seeds / "plain", series);
  std::filesystem::copy_file(
    file, series / "slice-00003.dcm", std::filesystem::copy_options::overwrite_existing);
  const RemovedAtEnd removed{ series };
  LoadVolume(OpenVolume(series.string(), SmallLimits()));
}

Target SurfaceTarget(const std::string& name)
{
  const std::string fileName = "input." + name;
  return { name, fileName, [fileName](const Path& folder) { MakeSurfaceSeeds(folder, fileName); },
    ReadSurface };
}

Target VolumeTarget(const std::string& name, const std::string& fileName)
{
  return { name, fileName,
    [fileName](const std::filesystem::path& folder) { MakeVolumeSeeds(folder, fileName); },
    ReadVolume };
}

Target SlabTarget(const std::string& name, const std::string& fileName)
{
  Target target = VolumeTarget(name, fileName);
  target.read = ReadSlabs;
  return target;
}

std::string Gzipped(const std::string& bytes)
{
  std::string packed(bytes.size() + bytes.size() / 100 + 64, '\0');
  z_stream z{};
  if (deflateInit2(&z, Z_BEST_SPEED, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("gzip cannot be started");
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(packed.data());
  z.avail_out = static_cast<uInt>(packed.size());
  const int result = deflate(&z, Z_FINISH);
  packed.resize(z.total_out);
  deflateEnd(&z);
  if (result != Z_STREAM_END)
    throw std::runtime_error("gzip failed");
  return packed;
}

std::string BytesOf(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

} // namespace

std::vector<Target> Targets()
{
  std::vector<Target> targets{ VolumeTarget("mha", "input.mha"), VolumeTarget("vti", "input.vti"),
    VolumeTarget("nrrd", "input.nrrd"), VolumeTarget("nii", "input.nii"),
    VolumeTarget("nii.gz", "input.nii.gz"),
    { "in.nii.gz", "input.nii.gz", [](const Path& folder) { MakeVolumeSeeds(folder, "a.nii"); },
      ReadVolume, Gzipped },
    { "seg.nrrd", "input.seg.nrrd", MakeSegmentationSeeds, ReadVolume }, SurfaceTarget("stl"),
    SurfaceTarget("ply"), SurfaceTarget("obj"), SurfaceTarget("vtp"),
    SlabTarget("slabs.mha", "input.mha"), SlabTarget("slabs.nrrd", "input.nrrd"),
    SlabTarget("slabs.nii", "input.nii"), { "hcells", "input.hcells", MakeCellSeeds, ReadCells },
    { "in.hcells", "input.hcells", MakeCellSeeds, ReadCells, SealCells } };
#if HASP_WITH_LIB3MF
  targets.push_back(SurfaceTarget("3mf"));
#endif
#if HASP_WITH_LIBARCHIVE
  targets.push_back({ "inv3", "input.inv3", MakeInvesaliusSeeds, ReadVolume });
#endif
#if HASP_WITH_DICOM
  targets.push_back({ "dicom", "input.dcm", MakeDicomSeeds, ReadSeries });
#endif
  for (Target& target : DeviceTargets())
    targets.push_back(std::move(target));
  return targets;
}

std::vector<std::string> SeedsOf(const Target& target, const std::filesystem::path& emptyFolder)
{
  const pid_t child = fork();
  if (child == 0)
  {
    target.makeSeeds(emptyFolder); // an exception ends the process, and the parent sees that
    _exit(0);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0)
    throw std::runtime_error("the seeds of " + target.name + " cannot be made");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(emptyFolder))
    if (entry.is_regular_file())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds;
  for (const auto& file : files)
    seeds.push_back(BytesOf(file));
  return seeds;
}

Outcome Try(const Target& target, const std::string& bytes, const std::filesystem::path& folder,
  const std::filesystem::path& seeds)
{
  const auto file = folder / target.fileName;
  const std::string stored = target.pack ? target.pack(bytes) : bytes;
  std::ofstream(file, std::ios::binary).write(stored.data(), std::streamsize(stored.size()));
  Outcome outcome = Outcome::Opened;
  try
  {
    target.read(file, seeds);
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception&)
  {
    outcome = Outcome::Refused;
  }
  std::filesystem::remove(file);
  return outcome;
}

} // namespace hasp

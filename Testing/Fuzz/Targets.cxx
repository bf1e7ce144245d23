#include "Targets.h"

#include "SeedFiles.h"
#include "vtkHaspVolumeFile.h"

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

VolumeReadSettings SmallLimits()
{
  VolumeReadSettings settings;
  settings.memoryLimitBytes = std::size_t(256) << 20;
  return settings;
}

void ReadVolume(const std::filesystem::path& file)
{
  LoadVolume(OpenVolume(file.string(), SmallLimits()));
}

Target VolumeTarget(const std::string& name, const std::string& fileName)
{
  return { name, fileName,
    [fileName](const std::filesystem::path& folder) { MakeVolumeSeeds(folder, fileName); },
    ReadVolume };
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
    { "seg.nrrd", "input.seg.nrrd", MakeSegmentationSeeds, ReadVolume } };
#if HASP_WITH_LIBARCHIVE
  targets.push_back({ "inv3", "input.inv3", MakeInvesaliusSeeds, ReadVolume });
#endif
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
  for (const auto& entry : std::filesystem::recursive_directory_iterator(emptyFolder))
    if (entry.is_regular_file())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds;
  for (const auto& file : files)
    seeds.push_back(BytesOf(file));
  return seeds;
}

Outcome Try(const Target& target, const std::string& bytes, const std::filesystem::path& folder)
{
  const auto file = folder / target.fileName;
  std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
  Outcome outcome = Outcome::Opened;
  try
  {
    target.read(file);
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

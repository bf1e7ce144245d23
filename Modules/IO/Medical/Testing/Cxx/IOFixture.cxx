#include "IOFixture.h"

#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

IOFixture::IOFixture()
{
  hasp::ShowFileNames(true); // most tests hold that the right file is named
  std::string pattern = (std::filesystem::temp_directory_path() / "hasp-io-XXXXXX").string();
  if (!mkdtemp(pattern.data()))
    throw std::runtime_error("no temporary folder");
  this->Folder = pattern;
}

IOFixture::~IOFixture()
{
  std::error_code ignored;
  std::filesystem::remove_all(this->Folder, ignored);
}

hasp::GridGeometry IOFixture::Truth() const
{
  hasp::GridGeometry g;
  g.dims = { 12, 10, 8 };
  g.origin = { -31.5, 12.25, 100.5 };
  g.spacing = { 0.5, 0.75, 1.25 };
  const glm::dvec3 row = glm::normalize(glm::dvec3(0.9, 0.3, -0.2));
  const glm::dvec3 column = glm::normalize(glm::cross(glm::dvec3(0.1, 0.4, 1.0), row));
  g.direction = glm::dmat3(row, column, glm::cross(row, column));
  return g;
}

std::vector<std::int16_t> IOFixture::Samples(const hasp::GridGeometry& geometry)
{
  std::vector<std::int16_t> samples(geometry.Size());
  for (std::size_t n = 0; n < samples.size(); ++n)
    samples[n] = static_cast<std::int16_t>(static_cast<int>(n) - 400);
  return samples;
}

void IOFixture::ExpectSame(const hasp::LoadedVolume& volume, const hasp::GridGeometry& truth,
  const std::vector<std::int16_t>& samples)
{
  // DICOM writes positions in decimals of at most 16 characters: 1e-6 of an index step.
  const double smallest = std::min({ truth.spacing.x, truth.spacing.y, truth.spacing.z });
  ExpectPlaces(volume, truth, samples, 1e-6 * smallest);
}

void IOFixture::ExpectPlaces(const hasp::LoadedVolume& volume, const hasp::GridGeometry& truth,
  const std::vector<std::int16_t>& samples, double toleranceMm)
{
  const hasp::GridGeometry g = hasp::ImageGeometry(volume.image);
  ASSERT_EQ(g.Size(), samples.size());
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
      {
        const glm::dvec3 world = g.IndexToWorld({ i, j, k });
        const glm::ivec3 near(glm::round(truth.WorldToIndex(world)));
        ASSERT_LT(glm::length(world - truth.IndexToWorld(near)), toleranceMm)
          << i << " " << j << " " << k;
        const std::size_t n = (std::size_t(near.z) * truth.dims.y + near.y) * truth.dims.x + near.x;
        ASSERT_LT(n, samples.size());
        ASSERT_EQ(volume.image->GetScalarComponentAsDouble(i, j, k, 0), samples[n])
          << i << " " << j << " " << k;
      }
}

hasp::LoadedVolume IOFixture::Read(
  const std::filesystem::path& path, const hasp::VolumeReadSettings& settings)
{
  return hasp::LoadVolume(hasp::OpenVolume(path.string(), settings));
}

void IOFixture::ExpectRefused(const std::filesystem::path& path,
  const std::vector<std::string>& says, const hasp::VolumeReadSettings& settings) const
{
  try
  {
    Read(path, settings);
    ADD_FAILURE() << "was read";
  }
  catch (const std::runtime_error& error)
  {
    const std::string text = error.what();
    for (const std::string& piece : says)
      EXPECT_NE(text.find(piece), text.npos) << "no \"" << piece << "\" in: " << text;
    EXPECT_EQ(text.find(this->Folder.parent_path().string() + "/"), text.npos) << text;
  }
}

void IOFixture::WriteBytes(const std::filesystem::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string IOFixture::ReadBytes(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

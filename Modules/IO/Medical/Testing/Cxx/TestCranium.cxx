#include "vtkHaspDicomOutput.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// The real CT against what InVesalius itself stored with it, and against anatomy.
namespace
{

const hasp::LoadedVolume& Cranium()
{
  static const hasp::LoadedVolume volume = hasp::LoadVolume(hasp::OpenVolume(HASP_CRANIUM));
  return volume;
}

hasp::GridView<const std::int16_t> View()
{
  return std::get<hasp::GridView<const std::int16_t>>(hasp::ViewImage(Cranium().image));
}

std::vector<std::uint8_t> StoredMask()
{
  const std::unique_ptr<archive, int (*)(archive*)> from(archive_read_new(), &archive_read_free);
  archive_read_support_filter_gzip(from.get());
  archive_read_support_format_tar(from.get());
  archive_read_open_filename(from.get(), HASP_CRANIUM, 1 << 17);
  std::vector<std::uint8_t> mask;
  for (archive_entry* entry; archive_read_next_header(from.get(), &entry) == ARCHIVE_OK;)
    if (std::string(archive_entry_pathname(entry)).find("mask_0.dat") != std::string::npos)
    {
      mask.resize(static_cast<std::size_t>(archive_entry_size(entry)));
      EXPECT_EQ(archive_read_data(from.get(), mask.data(), mask.size()), la_ssize_t(mask.size()));
    }
  return mask;
}

TEST(Cranium, PassportIsThatOfTheFile)
{
  const hasp::Passport& p = Cranium().passport;
  EXPECT_EQ(p.geometry.dims, glm::ivec3(256, 256, 108));
  EXPECT_NEAR(p.geometry.spacing.x, 0.957, 1e-3);
  EXPECT_EQ(p.geometry.spacing.z, 1.5);
  EXPECT_EQ(p.geometry.direction, glm::dmat3(1.0));
  EXPECT_TRUE(p.hounsfield);
  EXPECT_EQ(p.minimum, -1024);
  EXPECT_EQ(p.maximum, 2986);
}

TEST(Cranium, SamplesAtLeast226AreExactlyItsOwnMask)
{
  const auto mask = StoredMask();
  ASSERT_EQ(mask.size(), std::size_t(109) * 257 * 257); // one border plane, row and column first
  const auto view = View();
  std::size_t different = 0, bone = 0;
  for (int k = 0; k < 108; ++k)
    for (int j = 0; j < 256; ++j)
      for (int i = 0; i < 256; ++i)
      {
        const int storedRow = 255 - j; // the file's rows are bottom-up
        const bool inMask = mask[(std::size_t(k + 1) * 257 + storedRow + 1) * 257 + i + 1] > 127;
        different += inMask != (view(i, j, k) >= 226);
        bone += inMask;
      }
  EXPECT_EQ(different, 0U);
  EXPECT_GT(bone, 400000U);
}

/// Whether a level ray from the middle of the head meets bone; degrees from anterior to the left.
bool BoneTowards(double degrees, double z)
{
  const auto view = View();
  const glm::dvec3 middle(122.5, 134.0, z);
  const double angle = glm::radians(degrees);
  for (double r = 30.0; r < 110.0; r += 0.25)
  {
    const glm::dvec3 at = middle + r * glm::dvec3(std::sin(angle), -std::cos(angle), 0.0);
    const glm::ivec3 n(glm::round(view.geometry.WorldToIndex(at)));
    if (view(n.x, n.y, n.z) >= 226)
      return true;
  }
  return false;
}

TEST(Cranium, DefectIsInTheRightFrontalBone)
{
  // Measured once with such rays: open from z = 82.5 to 127.5 mm, 15 to 29 degrees to the right.
  for (const double z : { 90.0, 97.5, 105.0, 112.5 })
  {
    EXPECT_FALSE(BoneTowards(-22.0, z)) << z;
    EXPECT_TRUE(BoneTowards(22.0, z)) << "the left side is whole, " << z;
    EXPECT_TRUE(BoneTowards(-40.0, z)) << z;
    EXPECT_TRUE(BoneTowards(158.0, z)) << "so is the back, " << z;
  }
}

TEST(Cranium, NoseIsAnteriorAndVaultSuperior)
{
  const auto view = View();
  int anterior = 0, posterior = 0; // air near the mid-plane: nasal cavity and pharynx
  for (int j = 0; j < 256; ++j)
    for (int i = 0; i < 256; ++i)
    {
      const glm::dvec3 from =
        view.geometry.IndexToWorld({ i, j, 15 }) - glm::dvec3(122.5, 134.0, 22.5);
      if (std::abs(from.x) < 25.0 && std::abs(from.y) < 70.0 && view(i, j, 15) < -300)
        ++(from.y < 0.0 ? anterior : posterior);
    }
  EXPECT_GT(anterior, 10 * posterior);
  EXPECT_TRUE(BoneTowards(0.0, 145.0));
  EXPECT_FALSE(BoneTowards(0.0, 155.0)) << "above the vault";
}

TEST(Cranium, HashIsOneInEachFormat)
{
  std::string folder = (std::filesystem::temp_directory_path() / "hasp-cranium-XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  hasp::VolumeReadSettings settings;
  settings.hash = true;
  const std::string hash = hasp::LoadVolume(hasp::OpenVolume(HASP_CRANIUM, settings)).passport.hash;
  EXPECT_EQ(hash.size(), HASP_WITH_OPENSSL ? 64U : 0U);
  for (const char* name : { "a.nrrd", "a.mha", "a.nii", "a.nii.gz", "a.vti" })
  {
    const std::string file = folder + "/" + name;
    hasp::WriteVolume(Cranium().image, file);
    EXPECT_EQ(hasp::LoadVolume(hasp::OpenVolume(file, settings)).passport.hash, hash) << name;
  }
#if HASP_WITH_DICOM // a folder of slices, through the decoder's process
  hasp::WriteDicomSeries(
    Cranium().image, folder + "/slices", { .modality = "CT", .hounsfield = true });
  const auto slices = hasp::LoadVolume(hasp::OpenVolume(folder + "/slices", settings));
  EXPECT_EQ(slices.passport.hash, hash);
  EXPECT_TRUE(slices.passport.hounsfield);
#endif
  std::filesystem::remove_all(folder);
}

} // namespace

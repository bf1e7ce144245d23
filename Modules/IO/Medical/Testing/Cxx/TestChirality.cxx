#include "IOFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeHash.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNIFTIImageWriter.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <limits>

/// Whatever way a volume takes through files, each sample stays at its place in the patient.
namespace
{

using hasp::GridGeometry;

struct Way
{
  const char* ending;
  bool compress = false;
};
constexpr Way Ways[] = { { ".mha" }, { ".nrrd" }, { ".nrrd", true }, { ".nii" }, { ".nii.gz" },
  { ".vti" } };

class Chirality : public IOFixture
{
protected:
  /// Identity, a quarter turn, oblique, flipped (two of determinant -1), sagittal and coronal.
  std::vector<GridGeometry> Geometries() const
  {
    std::vector<GridGeometry> all(7, this->Truth());
    all[0].direction = glm::dmat3(1.0);
    all[1].direction = glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1);
    all[3].direction = glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, 1);
    all[4].direction[1] *= -1.0; // oblique and flipped
    all[5].direction = glm::dmat3(0, 1, 0, 0, 0, -1, -1, 0, 0);
    all[6].direction = glm::dmat3(1, 0, 0, 0, 0, -1, 0, 1, 0);
    return all;
  }

  /// An L of three unequal arms, in the patient: 1 towards left, 2 posterior, 3 superior; no mirror
  /// image of it can be turned into it. Around it every sample is different.
  static std::vector<std::int16_t> Phantom(const GridGeometry& g)
  {
    auto samples = Samples(g);
    for (std::size_t n = 0; n < samples.size(); ++n)
      samples[n] += 1000;
    const glm::dvec3 corner = g.IndexToWorld(0.5 * glm::dvec3(g.dims - 1));
    for (int k = 0, n = 0; k < g.dims.z; ++k)
      for (int j = 0; j < g.dims.y; ++j)
        for (int i = 0; i < g.dims.x; ++i, ++n)
        {
          const glm::dvec3 at = g.IndexToWorld({ i, j, k }) - corner;
          for (int a = 0; a < 3; ++a)
            if (at[a] > 0.4 && at[a] < 2.0 + 0.5 * a && std::abs(at[(a + 1) % 3]) < 0.7 &&
                std::abs(at[(a + 2) % 3]) < 0.7)
              samples[n] = static_cast<std::int16_t>(a + 1);
        }
    return samples;
  }

  /// Mean place of an arm of the phantom, from the middle of the volume.
  static glm::dvec3 Arm(const hasp::LoadedVolume& volume, int arm)
  {
    const GridGeometry g = hasp::ImageGeometry(volume.image);
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (int k = 0; k < g.dims.z; ++k)
      for (int j = 0; j < g.dims.y; ++j)
        for (int i = 0; i < g.dims.x; ++i)
          if (volume.image->GetScalarComponentAsDouble(i, j, k, 0) == arm)
          {
            sum += g.IndexToWorld({ i, j, k });
            count += 1.0;
          }
    return sum / count - g.IndexToWorld(0.5 * glm::dvec3(g.dims - 1));
  }

  static void ExpectPhantom(const hasp::LoadedVolume& volume, const GridGeometry& truth,
    const std::vector<std::int16_t>& samples)
  {
    ExpectPlaces(volume, truth, samples, 1e-4);
    for (int a = 0; a < 3; ++a) // in words: left is left, and so on
    {
      const glm::dvec3 arm = Arm(volume, a + 1);
      EXPECT_GT(arm[a], 0.4);
      EXPECT_LT(std::abs(arm[(a + 1) % 3]) + std::abs(arm[(a + 2) % 3]), arm[a]);
    }
  }

  std::string Path(const Way& way, const char* name) const
  {
    return (this->Folder / (std::string(name) + way.ending)).string();
  }
};

TEST_F(Chirality, EverySampleStaysInItsPlaceThroughEachWriterAndReader)
{
  for (const GridGeometry& g : this->Geometries())
  {
    const auto samples = Phantom(g);
    const auto image = hasp::MakeImage(g, samples);
    const std::string hash = hasp::VolumeHash(hasp::ViewImage(image));
    for (const Way& way : Ways)
    {
      SCOPED_TRACE(way.ending);
      hasp::WriteVolume(image, this->Path(way, "a"), { way.compress });
      const auto volume = Read(this->Path(way, "a"));
      ExpectPhantom(volume, g, samples);
      EXPECT_TRUE(volume.passport.warnings.empty()) << volume.passport.warnings.front();
      EXPECT_EQ(hasp::VolumeHash(hasp::ViewImage(volume.image)), hash);
    }
  }
}

TEST_F(Chirality, EveryPairOfFormatsKeepsIt)
{
  for (const int n : { 4, 5 }) // oblique and flipped, sagittal
  {
    const GridGeometry g = this->Geometries()[n];
    const auto samples = Phantom(g);
    for (const Way& first : Ways)
    {
      hasp::WriteVolume(hasp::MakeImage(g, samples), this->Path(first, "a"), { first.compress });
      const auto one = Read(this->Path(first, "a"));
      for (const Way& second : Ways)
      {
        SCOPED_TRACE(std::string(first.ending) + " to " + second.ending);
        hasp::WriteVolume(one.image, this->Path(second, "b"), { second.compress });
        ExpectPhantom(Read(this->Path(second, "b")), g, samples);
      }
    }
  }
}

TEST_F(Chirality, VTKReadsOurNiftiWithTheSamePlaces)
{
  for (const GridGeometry& g : this->Geometries())
  {
    const auto samples = Phantom(g);
    const auto file = (this->Folder / "a.nii").string();
    hasp::WriteVolume(hasp::MakeImage(g, samples), file);
    vtkNew<vtkNIFTIImageReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    for (vtkMatrix4x4* form : { reader->GetSFormMatrix(), reader->GetQFormMatrix() })
    {
      ASSERT_NE(form, nullptr);
      // VTK scales by spacing elsewhere: its matrices are RAS of the image's own millimetres.
      vtkImageData* image = reader->GetOutput();
      for (int k = 0; k < g.dims.z; ++k)
        for (int j = 0; j < g.dims.y; ++j)
          for (int i = 0; i < g.dims.x; ++i)
          {
            const double* spacing = image->GetSpacing();
            const double in[] = { i * spacing[0], j * spacing[1], k * spacing[2], 1.0 };
            double ras[4];
            form->MultiplyPoint(in, ras);
            const glm::dvec3 index = g.WorldToIndex({ -ras[0], -ras[1], ras[2] });
            const glm::ivec3 near(glm::round(index));
            ASSERT_LT(glm::length(g.IndexToWorld(index) - g.IndexToWorld(near)), 1e-4);
            ASSERT_EQ(image->GetScalarComponentAsDouble(i, j, k, 0),
              samples[(std::size_t(near.z) * g.dims.y + near.y) * g.dims.x + near.x]);
          }
    }
  }
}

TEST_F(Chirality, WeReadVTKsNiftiWithTheSamePlaces)
{
  for (const GridGeometry& g : this->Geometries())
    for (const int version : { 1, 2 })
    {
      const auto samples = Phantom(g);
      const auto image = hasp::MakeImage(g, samples);
      image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1); // the writer wants matrices for it
      image->SetOrigin(0, 0, 0);
      vtkNew<vtkMatrix4x4> form;
      for (int row = 0; row < 3; ++row)
      {
        const double sign = row < 2 ? -1.0 : 1.0; // LPS to RAS
        for (int a = 0; a < 3; ++a)
          form->SetElement(row, a, sign * g.direction[a][row]);
        form->SetElement(row, 3, sign * g.origin[row]);
      }
      const auto file = (this->Folder / "a.nii").string();
      vtkNew<vtkNIFTIImageWriter> writer;
      writer->SetFileName(file.c_str());
      writer->SetNIFTIVersion(version);
      writer->SetQFac(glm::determinant(g.direction) < 0.0 ? -1.0 : 1.0);
      writer->SetSFormMatrix(form);
      writer->SetQFormMatrix(form);
      writer->SetInputData(image);
      writer->Write();
      const auto volume = Read(file);
      EXPECT_EQ(volume.passport.format, version == 1 ? "NIfTI-1" : "NIfTI-2");
      ExpectPhantom(volume, g, samples);
    }
}

TEST_F(Chirality, VTKReadsOurNrrd)
{
  const GridGeometry g = this->Geometries()[0];
  const auto samples = Phantom(g);
  for (const bool compress : { false, true })
  {
    const auto file = (this->Folder / "a.nrrd").string();
    hasp::WriteVolume(hasp::MakeImage(g, samples), file, { compress });
    vtkNew<vtkNrrdReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(std::size_t(image->GetNumberOfPoints()), samples.size());
    EXPECT_EQ(std::memcmp(image->GetScalarPointer(), samples.data(), samples.size() * 2), 0);
    for (int a = 0; a < 3; ++a)
      EXPECT_EQ(image->GetSpacing()[a], g.spacing[a]);
  }
}

TEST_F(Chirality, ExtremeNumbersKeepTheirPlaces)
{
  std::vector<GridGeometry> all(5, this->Truth());
  all[0].spacing = { 1e-3, 1e-3, 1e-3 };
  all[1].spacing = { 1e3, 1e-3, 1e3 };
  all[2].origin = { 1e6 + 0.1, -1e6, 1e6 };
  all[3].origin = { -0.0, 0.0, -0.0 };
  all[3].direction = glm::dmat3(1, -0.0, 0, 0, 1, -0.0, -0.0, 0, 1);
  all[4].dims = { 960, 1, 1 };
  for (const GridGeometry& g : all)
    for (const Way& way : Ways)
    {
      SCOPED_TRACE(way.ending);
      hasp::WriteVolume(hasp::MakeImage(g, Samples(g)), this->Path(way, "a"), { way.compress });
      const double smallest = std::min({ g.spacing.x, g.spacing.y, g.spacing.z });
      const auto volume = Read(this->Path(way, "a"));
      // Where a step is a micrometre, 1e-4 mm of the whole would be a tenth of it; float32 keeps
      // less there, because the volume is small.
      ExpectPlaces(volume, g, Samples(g), std::min(1e-4, 0.3 * smallest));
      // NIfTI-2, of double precision, where float32 would not do.
      const bool isNifti = volume.passport.format.rfind("NIfTI", 0) == 0;
      const bool wide = g.origin.x > 1e5 || g.spacing.x > 100.0;
      EXPECT_EQ(volume.passport.format == "NIfTI-2", isNifti && wide);
    }
}

TEST_F(Chirality, FloatsAreKeptBitByBit)
{
  const GridGeometry g{ { 2, 2, 2 }, { 1, 2, 3 }, { 1, 1, 1 } };
  const std::vector<float> samples{ 0.1F, -0.0F, std::numeric_limits<float>::denorm_min(),
    -std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(),
    std::numeric_limits<float>::lowest(), std::numeric_limits<float>::min(), 1e-40F };
  for (const Way& way : Ways)
  {
    SCOPED_TRACE(way.ending);
    hasp::WriteVolume(hasp::MakeImage(g, samples), this->Path(way, "a"), { way.compress });
    const auto volume = Read(this->Path(way, "a"));
    for (int n = 0; n < 8; ++n)
    {
      // NIfTI may turn x and y: found by place.
      const glm::dvec3 at = hasp::ImageGeometry(volume.image)
                              .WorldToIndex(g.IndexToWorld({ n & 1, (n >> 1) & 1, n >> 2 }));
      const glm::ivec3 i(glm::round(at));
      const auto* sample = static_cast<const float*>(volume.image->GetScalarPointer(i.x, i.y, i.z));
      EXPECT_EQ(std::memcmp(sample, &samples[n], sizeof(float)), 0) << n;
    }
  }
}

} // namespace

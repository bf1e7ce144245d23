#include "IOFixture.h"
#include "Zip.h"

#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{

/// A NIfTI-1 file of 2 x 3 x 4 samples, byte by byte from the specification (nifti1.h).
struct ByHand
{
  std::string bytes = std::string(352, '\0');
  bool big = false;

  template <typename T>
  ByHand& Put(std::size_t at, T value)
  {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (this->big)
      std::reverse(raw, raw + sizeof(T));
    if (this->bytes.size() < at + sizeof(T))
      this->bytes.resize(at + sizeof(T));
    this->bytes.replace(at, sizeof(T), raw, sizeof(T));
    return *this;
  }
  ByHand& Floats(std::size_t at, const std::vector<double>& values)
  {
    for (const double value : values)
    {
      this->Put(at, static_cast<float>(value));
      at += 4;
    }
    return *this;
  }

  /// x runs to the patient's right, y to anterior, z to superior: RAS as the format has it.
  explicit ByHand(bool bigEndian = false) : big(bigEndian)
  {
    this->Put<std::int32_t>(0, 348);
    const std::int16_t dim[] = { 3, 2, 3, 4, 1, 1, 1, 1 };
    for (int n = 0; n < 8; ++n)
      this->Put(40 + 2 * n, dim[n]);
    this->Put<std::int16_t>(70, 4).Put<std::int16_t>(72, 16); // DT_INT16
    this->Floats(76, { 1, 0.5, 0.75, 2, 0, 0, 0, 0 });        // pixdim, qfac first
    this->Floats(108, { 352, 1, 0 });                         // vox_offset, scl_slope, scl_inter
    this->Put<std::uint8_t>(123, 2);                          // mm
    this->Put<std::int16_t>(252, 1).Put<std::int16_t>(254, 1);
    this->Floats(268, { 10, 20, 30 });
    this->Floats(280, { 0.5, 0, 0, 10, 0, 0.75, 0, 20, 0, 0, 2, 30 });
    this->bytes.replace(344, 4, std::string("n+1\0", 4));
    for (std::int16_t n = 0; n < 24; ++n)
      this->Put<std::int16_t>(352 + 2 * n, static_cast<std::int16_t>(n - 5));
  }
};

class Nifti : public IOFixture
{
protected:
  std::filesystem::path Write(const std::string& bytes, const char* name = "a.nii") const
  {
    WriteBytes(this->Folder / name, bytes);
    return this->Folder / name;
  }
  hasp::LoadedVolume ReadBytes(const std::string& bytes) { return Read(this->Write(bytes)); }
  void Refused(const ByHand& file, const char* says) const
  {
    this->ExpectRefused(this->Write(file.bytes), { "a.nii: ", says });
  }
  static hasp::GridGeometry Meant()
  {
    // Patient LPS: right is -x, anterior is -y.
    return { { 2, 3, 4 }, { -10, -20, 30 }, { 0.5, 0.75, 2 },
      glm::dmat3(-1, 0, 0, 0, -1, 0, 0, 0, 1) };
  }
  static std::vector<std::int16_t> Values()
  {
    std::vector<std::int16_t> values(24);
    for (int n = 0; n < 24; ++n)
      values[n] = static_cast<std::int16_t>(n - 5);
    return values;
  }
};

TEST_F(Nifti, BadHeadersAreRefused)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  this->Refused(ByHand().Put<std::int32_t>(0, 347), "neither 348 nor 540");
  this->Refused(ByHand().Put<char>(345, 'i'), "pair");
  this->Refused(ByHand().Put<char>(344, '\0'), "pair");
  for (const std::int16_t n : { -1, 0, 1, 2, 8, 32767 })
    this->Refused(ByHand().Put<std::int16_t>(40, n), "dim[0]");
  for (const std::int16_t n : { -3, 0 })
    this->Refused(ByHand().Put<std::int16_t>(42, n), "each number must be");
  this->Refused(ByHand().Put<std::int16_t>(46, 5), "cut off");
  this->Refused(ByHand().Put<std::int16_t>(46, 3), "more than the header");
  this->Refused(ByHand().Put<std::int16_t>(42, 32767).Put<std::int16_t>(44, 32767), "memory limit");
  this->Refused(ByHand().Put<std::int16_t>(40, 4).Put<std::int16_t>(48, 2), "volumes");
  this->Refused(ByHand().Put<std::int16_t>(40, 5).Put<std::int16_t>(50, 3), "components");
  for (const std::int16_t type : { 0, 1, 32, 128, 1536, 1792, 2304, -4 })
    this->Refused(ByHand().Put<std::int16_t>(70, type), "datatype");
  this->Refused(ByHand().Put<std::int16_t>(72, 8), "bitpix");
  for (const float offset : { 0.0F, 347.0F, 352.5F, -1.0F, 1e30F, nan })
    this->Refused(ByHand().Put(108, offset), "vox_offset");
  this->Refused(ByHand().Put(108, 354.0F), "cut off");
  this->Refused(ByHand().Put(112, std::numeric_limits<float>::infinity()), "scl_slope");
  this->Refused(ByHand().Put(116, nan), "scl_slope");
  this->Refused(ByHand().Put<std::uint8_t>(123, 5), "unit");
  // sform alone: a gantry tilt of atan(0.2), no axis, no number
  const auto sformOnly = [] { return ByHand().Put<std::int16_t>(252, 0); };
  this->Refused(sformOnly().Put(304, 0.4F), "11.3099 degrees");
  this->Refused(sformOnly().Floats(312, { 0, 0, 0, 30 }), "spacing");
  this->Refused(sformOnly().Put(280, nan), "spacing");
  this->Refused(sformOnly().Put(292, nan), "origin");
  // qform alone
  const auto qformOnly = [] { return ByHand().Put<std::int16_t>(254, 0); };
  for (const float spacing : { 0.0F, -0.5F, nan })
    this->Refused(qformOnly().Put(80, spacing), "never guessed");
  this->Refused(qformOnly().Put(256, nan), "spacing");
}

TEST_F(Nifti, CutOffAndZippedFilesAreHeldToTheirHeader)
{
  const std::string whole = ByHand().bytes;
  for (const std::size_t size : { 0, 3, 4, 100, 347 })
    this->ExpectRefused(this->Write(whole.substr(0, size)), { "a.nii: " });
  for (const std::size_t size : { 348, 352, 399 })
    this->ExpectRefused(this->Write(whole.substr(0, size)), { "cut off" });
  this->ExpectRefused(this->Write(whole + "x"), { "more than the header" });
  const auto zipped = [&](const std::string& bytes, const char* says) {
    this->ExpectRefused(this->Write(bytes, "a.nii.gz"), { "a.nii.gz: ", says });
  };
  zipped(Gzip(whole + "x"), "more than the header");
  zipped(Gzip(whole.substr(0, 390)), "fewer than the header");
  zipped(Gzip(whole.substr(0, 300)), "fewer than the header");
  zipped(Gzip(whole).substr(0, 60), "cut off");
  zipped(Gzip(whole) + "x", "followed by");
  zipped(Gzip(whole + std::string(1 << 22, '\0')), "more than the header");
  zipped(Gzip(ByHand().Put<std::int16_t>(42, 20000).Put<std::int16_t>(44, 20000).bytes),
    "cannot hold them");
  this->ExpectRefused(this->Write(whole, "a.hdr"), { "single .nii" });
  this->ExpectRefused(this->Write(whole, "a.img"), { "single .nii" });
}

TEST_F(Nifti, RASBecomesLPSInBothByteOrdersPlainAndZipped)
{
  for (const bool big : { false, true })
  {
    const auto volume = this->ReadBytes(ByHand(big).bytes);
    EXPECT_EQ(volume.passport.format, "NIfTI-1");
    EXPECT_EQ(volume.passport.geometry.origin, Meant().origin);
    EXPECT_EQ(volume.passport.geometry.direction, Meant().direction);
    EXPECT_EQ(volume.passport.geometry.spacing, Meant().spacing);
    EXPECT_TRUE(volume.passport.warnings.empty());
    ExpectSame(volume, Meant(), Values());
    ExpectSame(Read(this->Write(Gzip(ByHand(big).bytes), "a.nii.gz")), Meant(), Values());
    ExpectSame(this->ReadBytes(Gzip(ByHand(big).bytes)), Meant(), Values()); // misnamed
  }
}

TEST_F(Nifti, ExtensionsBeforeTheSamplesAreSkipped)
{
  ByHand file;
  file.Put(108, 368.0F).Put<char>(348, 1);
  file.bytes.insert(352, std::string("\x10\0\0\0\x06\0\0\0Mil.Ann", 16));
  ExpectSame(this->ReadBytes(file.bytes), Meant(), Values());
}

TEST_F(Nifti, TheQuaternionIsThatOfTheSpecification)
{
  // A quarter turn about z: index x runs to anterior, y to the left; (a,b,c,d) = (r,0,0,r).
  ByHand file;
  file.Put<std::int16_t>(254, 0).Put(264, static_cast<float>(std::sqrt(0.5)));
  auto meant = Meant();
  meant.direction = glm::dmat3(0, -1, 0, 1, 0, 0, 0, 0, 1);
  ExpectPlaces(this->ReadBytes(file.bytes), meant, Values(), 1e-5); // float32 of sqrt(1/2)
  file.Put(76, -1.0F); // qfac: the third axis is turned
  meant.direction[2] *= -1.0;
  ExpectPlaces(this->ReadBytes(file.bytes), meant, Values(), 1e-5);
  // A half turn about x, whose real part float32 must not make complex.
  file.Put(76, 1.0F).Put(264, 0.0F).Put(256, 1.0000001F);
  meant.direction = glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, -1);
  ExpectPlaces(this->ReadBytes(file.bytes), meant, Values(), 1e-5);
}

TEST_F(Nifti, TheSformWinsAndDisagreementIsSaid)
{
  ByHand file;
  file.Put(268, 10.1F);
  auto volume = this->ReadBytes(file.bytes);
  ExpectSame(volume, Meant(), Values());
  ASSERT_EQ(volume.passport.warnings.size(), 1U);
  EXPECT_NE(volume.passport.warnings[0].find("0.1 mm apart"), std::string::npos);
  file.Put(268, 10.0005F); // below a micrometre nobody is told
  EXPECT_TRUE(this->ReadBytes(file.bytes).passport.warnings.empty());
  // A sheared sform and a sound qform: that is taken.
  file.Put(268, 10.0F).Put(304, 0.4F);
  volume = this->ReadBytes(file.bytes);
  ExpectSame(volume, Meant(), Values());
  ASSERT_EQ(volume.passport.warnings.size(), 1U);
  EXPECT_NE(volume.passport.warnings[0].find("11.3099 degrees"), std::string::npos);
  // Neither: axes as they come, at the origin.
  volume = this->ReadBytes(ByHand().Put<std::int16_t>(252, 0).Put<std::int16_t>(254, 0).bytes);
  auto meant = Meant();
  meant.origin = { 0, 0, 0 };
  ExpectSame(volume, meant, Values());
  ASSERT_EQ(volume.passport.warnings.size(), 1U);
  EXPECT_NE(volume.passport.warnings[0].find("Check left and right"), std::string::npos);
}

TEST_F(Nifti, UnitsBecomeMillimetres)
{
  for (const auto& [code, scale, warnings] : std::vector<std::tuple<int, double, std::size_t>>{
         { 1, 1000.0, 0 }, { 2, 1.0, 0 }, { 3, 0.001, 0 }, { 0, 1.0, 1 }, { 2 | 8, 1.0, 0 } })
  {
    const auto volume =
      this->ReadBytes(ByHand().Put(123, static_cast<std::uint8_t>(code)).bytes).passport;
    EXPECT_EQ(volume.geometry.spacing, Meant().spacing * scale);
    EXPECT_EQ(volume.geometry.origin, Meant().origin * scale);
    EXPECT_EQ(volume.warnings.size(), warnings);
  }
}

TEST_F(Nifti, SlopeAndInterceptMakeValues)
{
  const auto read = [&](float slope, float intercept)
  { return this->ReadBytes(ByHand().Put(112, slope).Put(116, intercept).bytes).passport; };
  for (const float none : { 0.0F, std::numeric_limits<float>::quiet_NaN() })
  {
    EXPECT_EQ(read(none, 7.0F).sampleType, "int16"); // unscaled by the specification
    EXPECT_EQ(read(none, 7.0F).maximum, 18);
  }
  EXPECT_EQ(read(2.0F, -1000.0F).sampleType, "int16");
  EXPECT_EQ(read(2.0F, -1000.0F).minimum, -1010);
  EXPECT_EQ(read(2.0F, -1000.0F).warnings.size(), 1U);
  EXPECT_EQ(read(2000.0F, 10000.0F).sampleType, "uint16"); // 0 to 46000
  EXPECT_EQ(read(0.5F, 0.0F).sampleType, "float32");
  EXPECT_EQ(read(0.5F, 0.0F).minimum, -2.5);
}

} // namespace

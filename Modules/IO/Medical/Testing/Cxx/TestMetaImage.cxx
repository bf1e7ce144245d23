#include "IOFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <limits>

namespace
{

class MetaImage : public IOFixture
{
protected:
  /// A header of the 12 x 10 x 8 truth, with one key replaced, or left out where the value is "".
  static std::string Header(const std::string& key = "none", const std::string& value = "x")
  {
    std::string header;
    for (const auto& [name, usual] :
      std::vector<std::pair<std::string, std::string>>{ { "ObjectType", "Image" }, { "NDims", "3" },
        { "BinaryDataByteOrderMSB", "False" }, { "CompressedData", "False" },
        { "TransformMatrix", "0 1 0 0 0 -1 -1 0 0" }, { "Offset", "-3 4 5.5" },
        { "ElementSpacing", "0.5 0.75 1.25" }, { "DimSize", "12 10 8" },
        { "ElementType", "MET_SHORT" }, { "ElementDataFile", "LOCAL" } })
    {
      const std::string& text = name == key ? value : usual;
      if (!text.empty())
        header += name + " = " + text + "\n";
    }
    return header;
  }
  /// The geometry that header means: index x runs to P, y to I, z to R.
  static hasp::GridGeometry Meant()
  {
    return { { 12, 10, 8 }, { -3, 4, 5.5 }, { 0.5, 0.75, 1.25 },
      glm::dmat3(0, 1, 0, 0, 0, -1, -1, 0, 0) };
  }
  static std::string Raw()
  {
    const auto samples = Samples(Meant());
    std::string bytes;
    AppendBytes(bytes, samples.data(), samples.size());
    return bytes;
  }
  void ExpectHeaderRefused(
    const std::string& key, const std::string& value, const std::string& says) const
  {
    SCOPED_TRACE(key + " = " + value);
    WriteBytes(this->Folder / "a.mha", Header(key, value) + Raw());
    this->ExpectRefused(this->Folder / "a.mha", { "a.mha: ", says });
  }
};

TEST_F(MetaImage, BadHeadersAreRefused)
{
  this->ExpectHeaderRefused("DimSize", "12 10 9", "cut off");
  this->ExpectHeaderRefused("DimSize", "65535 65535 65535", "memory limit");
  this->ExpectHeaderRefused("DimSize", "999999999 999999999 999999999", "memory limit");
  this->ExpectHeaderRefused("DimSize", "12 10 0", "whole numbers");
  this->ExpectHeaderRefused("DimSize", "12 -10 8", "whole numbers");
  this->ExpectHeaderRefused("DimSize", "12 10", "3 finite numbers");
  this->ExpectHeaderRefused("DimSize", "1e99 10 8", "whole numbers");
  this->ExpectHeaderRefused("DimSize", "", "lacks DimSize");
  this->ExpectHeaderRefused("ElementSpacing", "", "never guessed");
  this->ExpectHeaderRefused("ElementSpacing", "0.5 0 1.25", "spacing");
  this->ExpectHeaderRefused("ElementSpacing", "nan 1 1", "finite");
  this->ExpectHeaderRefused("Offset", "1 2 here", "finite");
  this->ExpectHeaderRefused("TransformMatrix", "1 0 0 1 0 0 0 0 1", "direction");
  this->ExpectHeaderRefused("NDims", "2", "must be 3");
  this->ExpectHeaderRefused("ElementType", "MET_STRING", "MET_SHORT");
  this->ExpectHeaderRefused("DimSize", "12 10 7", "more than the header");
  this->ExpectHeaderRefused("ElementDataFile", "../../etc/passwd", "beside it");
  this->ExpectHeaderRefused("ElementDataFile", "LIST", "beside it");
  this->ExpectHeaderRefused("ElementDataFile", "gone.raw", "is not there");
  this->ExpectHeaderRefused("ElementDataFile", "", "no MetaImage");
  this->ExpectHeaderRefused("CompressedData", "True", "damaged");
  this->ExpectHeaderRefused("CompressedData", "TRUE", "damaged");
  this->ExpectHeaderRefused("ElementSpacing", "1e999 1 1", "finite");
  this->ExpectHeaderRefused("CompressedData", "perhaps", "True or False");
  this->ExpectHeaderRefused("BinaryDataByteOrderMSB", "2", "True or False");
  for (const char* no : { "False", "FALSE", "0" })
    this->ExpectHeaderRefused("CompressedData", std::string("False\nBinaryData = ") + no, "text");
  this->ExpectHeaderRefused("Offset", "1 2 3\nOffset = 1 2 3", "twice");
  WriteBytes(this->Folder / "b.mha", std::string(200000, 'x'));
  this->ExpectRefused(this->Folder / "b.mha", { "no MetaImage" });
}

TEST_F(MetaImage, LocalExternalAndSwappedSamplesAreExact)
{
  WriteBytes(this->Folder / "local.mha", Header() + Raw());
  ExpectSame(Read(this->Folder / "local.mha"), Meant(), Samples(Meant()));
  WriteBytes(this->Folder / "r\xC3\xB6h.raw", Raw());
  WriteBytes(this->Folder / "far.mhd", Header("ElementDataFile", "r\xC3\xB6h.raw"));
  ExpectSame(Read(this->Folder / "far.mhd"), Meant(), Samples(Meant()));
  std::string swapped = Raw();
  for (std::size_t n = 0; n < swapped.size(); n += 2)
    std::swap(swapped[n], swapped[n + 1]);
  for (const char* yes : { "True", "true", "TRUE", "T", "1" })
  {
    WriteBytes(this->Folder / "big.mha", Header("BinaryDataByteOrderMSB", yes) + swapped);
    ExpectSame(Read(this->Folder / "big.mha"), Meant(), Samples(Meant()));
  }
}

TEST_F(MetaImage, CompressedSamplesMustBeExactlyAsManyAsDeclared)
{
  const auto pack = [](const std::string& bytes)
  {
    uLongf size = compressBound(bytes.size());
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
      reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    packed.resize(size);
    return packed;
  };
  const std::string header = Header("CompressedData", "True");
  WriteBytes(this->Folder / "a.mha", header + pack(Raw()));
  ExpectSame(Read(this->Folder / "a.mha"), Meant(), Samples(Meant()));
  WriteBytes(this->Folder / "a.mha", header + pack(Raw() + "x"));
  this->ExpectRefused(this->Folder / "a.mha", { "more than the header" });
  WriteBytes(this->Folder / "a.mha", header + pack(Raw().substr(2)));
  this->ExpectRefused(this->Folder / "a.mha", { "fewer than the header" });
  const std::string whole = pack(Raw());
  WriteBytes(this->Folder / "a.mha", header + whole.substr(0, whole.size() - 20));
  this->ExpectRefused(this->Folder / "a.mha", { "cut off" });
}

TEST_F(MetaImage, TheModalityIsOneOfAListAndNoOtherText)
{
  for (const auto& [text, expected] :
    std::vector<std::pair<std::string, std::string>>{ { "MET_MOD_CT", "CT" },
      { "MET_MOD_MR", "MR" }, { "MET_MOD_UNKNOWN", "" }, { "MET_MOD_Miller^Ann", "" } })
  {
    WriteBytes(this->Folder / "a.mha", "Modality = " + text + "\n" + Header() + Raw());
    EXPECT_EQ(Read(this->Folder / "a.mha").passport.modality, expected);
  }
}

TEST_F(MetaImage, OtherNumberTypesBecomeTheFirstThatHoldsThemAll)
{
  const auto read = [&](const std::string& type, const auto& values)
  {
    std::string bytes = Header("ElementType", type);
    AppendBytes(bytes, values.data(), values.size());
    WriteBytes(this->Folder / "a.mha", bytes);
    return Read(this->Folder / "a.mha").passport;
  };
  std::vector<std::int32_t> whole(960, -1000);
  EXPECT_EQ(read("MET_INT", whole).sampleType, "int16");
  EXPECT_EQ(read("MET_INT", whole).warnings.size(), 1U);
  std::vector<std::uint32_t> large(960, 65535);
  EXPECT_EQ(read("MET_UINT", large).sampleType, "uint16");
  whole[959] = 1 << 24;
  EXPECT_EQ(read("MET_INT", whole).sampleType, "float32");
  EXPECT_EQ(read("MET_INT", whole).maximum, 1 << 24);
  std::vector<double> real(960, 0.1);
  EXPECT_EQ(read("MET_DOUBLE", real).maximum, double(0.1F));
  real.assign(960, 7.0);
  EXPECT_EQ(read("MET_DOUBLE", real).sampleType, "int16");
  EXPECT_EQ(read("MET_CHAR", std::vector<std::int8_t>(960, -7)).minimum, -7);
  whole[5] = (1 << 24) + 1;
  EXPECT_THROW(read("MET_INT", whole), std::runtime_error);
  std::vector<std::int64_t> wide(960, (std::int64_t(1) << 62) + 1); // == its double, wrongly
  EXPECT_THROW(read("MET_LONG_LONG", wide), std::runtime_error);
  real[3] = 1e300; // infinite in float32
  EXPECT_THROW(read("MET_DOUBLE", real), std::runtime_error);
}

TEST_F(MetaImage, NotFiniteSamplesAreCountedAndPlaced)
{
  std::vector<float> samples(12 * 10 * 8, 1.0F);
  samples[2 * 120 + 3 * 12 + 4] = std::numeric_limits<float>::quiet_NaN();
  samples[7 * 120] = std::numeric_limits<float>::infinity();
  std::string bytes = Header("ElementType", "MET_FLOAT");
  AppendBytes(bytes, samples.data(), samples.size());
  WriteBytes(this->Folder / "a.mha", bytes);
  this->ExpectRefused(this->Folder / "a.mha", { "2 samples", "(4, 3, 2)" });
}

TEST_F(MetaImage, WhatIsWrittenReadsBackBitByBit)
{
  const auto g = this->Truth();
  const auto image = hasp::MakeImage(g, Samples(g));
  hasp::WriteVolume(image, (this->Folder / "a.mha").string());
  const auto volume = Read(this->Folder / "a.mha");
  ExpectSame(volume, g, Samples(g));
  EXPECT_EQ(volume.passport.geometry.origin, g.origin);
  EXPECT_EQ(volume.passport.geometry.spacing, g.spacing);
  EXPECT_EQ(volume.passport.geometry.direction, g.direction);
}

} // namespace

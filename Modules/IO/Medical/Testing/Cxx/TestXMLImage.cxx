#include "IOFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <limits>

namespace
{

class XMLImage : public IOFixture
{
protected:
  /// A .vti of 2 x 2 x 2 samples in text, with one piece of it replaced.
  std::filesystem::path Write(const std::string& find = "", const std::string& replace = "") const
  {
    std::string text = R"(<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1">
<Piece Extent="0 1 0 1 0 1"><PointData Scalars="s">
<DataArray type="Float32" Name="s" format="ascii">1 2 3 4 5 6 7 8</DataArray>
</PointData></Piece></ImageData></VTKFile>)";
    for (std::size_t at = 0; !find.empty() && (at = text.find(find, at)) != text.npos;
         at += replace.size())
      text.replace(at, find.size(), replace);
    WriteBytes(this->Folder / "a.vti", text);
    return this->Folder / "a.vti";
  }
};

TEST_F(XMLImage, BadFilesAreRefused)
{
  EXPECT_NO_THROW(Read(this->Write()));
  this->ExpectRefused(this->Write("0 1 0 1 0 1", "0 99999 0 99999 0 99999"), { "memory limit" });
  this->ExpectRefused(this->Write("0 1 0 1 0 1", "-2147483648 2147483647 0 1 0 1"), { "a.vti: " });
  this->ExpectRefused(this->Write("0 1 0 1 0 1", "0 -1 0 1 0 1"), { "a.vti: " });
  this->ExpectRefused(this->Write(" 7 8<", "<"), { "a.vti: " });
  this->ExpectRefused(this->Write("Float32", "Float64"), { "double", "is read" });
  this->ExpectRefused(this->Write("Scalars=\"s\"", ""), { "scalars" });
  this->ExpectRefused(this->Write("1 1 1\"", "1 0 1\""), { "spacing" });
  this->ExpectRefused(this->Write("</Piece>", ""), { "damaged" });
  this->ExpectRefused(this->Write("ImageData", "PolyData"), { "damaged" });
  this->ExpectRefused(this->Write("3 4", "nan 4"), { "a.vti: ", "1 samples", "(0, 1, 0)" });
  WriteBytes(this->Folder / "a.vti", "");
  this->ExpectRefused(this->Folder / "a.vti", { "damaged" });
}

TEST_F(XMLImage, OnlyTheSamplesAreTaken)
{
  const auto volume = Read(this->Write("</PointData></Piece>",
    R"(<DataArray type="Float32" Name="more" format="ascii">1 2 3 4 5 6 7 8</DataArray></PointData>
<CellData><DataArray type="Float32" Name="cell" format="ascii">1</DataArray></CellData></Piece>
<FieldData><Array type="String" Name="PatientName" NumberOfTuples="1" format="ascii">69 0</Array>
</FieldData>)"));
  EXPECT_EQ(volume.image->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(volume.image->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(volume.image->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(volume.passport.maximum, 8.0);
}

TEST_F(XMLImage, WhatIsWrittenReadsBackWithItsDirection)
{
  const auto g = this->Truth();
  hasp::WriteVolume(hasp::MakeImage(g, Samples(g)), (this->Folder / "\xD0\xB0 b.vti").string());
  const auto volume = Read(this->Folder / "\xD0\xB0 b.vti");
  ExpectSame(volume, g, Samples(g));
  EXPECT_EQ(volume.passport.format, "VTI");
  EXPECT_EQ(volume.passport.minimum, -400);
}

TEST_F(XMLImage, ExtentThatStartsElsewhereKeepsItsPlace)
{
  const auto g = this->Truth();
  const auto image = hasp::MakeImage(g, Samples(g));
  image->SetExtent(5, 16, -3, 6, 2, 9);
  const glm::dvec3 origin = g.IndexToWorld({ -5, 3, -2 }); // so that sample (5,-3,2) stays
  image->SetOrigin(origin.x, origin.y, origin.z);
  for (const char* name : { "a.vti", "a.mha" })
  {
    hasp::WriteVolume(image, (this->Folder / name).string());
    const auto volume = Read(this->Folder / name);
    ExpectSame(volume, g, Samples(g));
    EXPECT_EQ(volume.image->GetExtent()[0], 0);
  }
}

} // namespace

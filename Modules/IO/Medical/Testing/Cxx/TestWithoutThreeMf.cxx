#include "SurfaceFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

namespace
{

using WithoutThreeMf = SurfaceFixture;

TEST_F(WithoutThreeMf, ErrorsNameTheSwitch)
{
  const std::string file = (this->Folder / "a.3mf").string();
  const auto expect = [](const auto& work)
  {
    try
    {
      work();
      ADD_FAILURE() << "no error";
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_NE(std::string(error.what()).find("HASP_ENABLE_LIB3MF=ON"), std::string::npos);
    }
  };
  expect([&] { hasp::WriteSurface(hasp::MakePolyData(Truth()), file); });
  EXPECT_FALSE(std::filesystem::exists(file));
  WriteBytes(file, "PK");
  expect([&] { hasp::LoadSurface(file); });
}

} // namespace

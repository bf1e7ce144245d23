#include "ExampleRun.h"
#include "PictureFiles.h"

namespace
{

class DrawIsosurface : public ExampleTest
{
protected:
  /// With the arguments of the example in C++ or Python.
  int Draw(const std::string& arguments) { return this->Run("DrawIsosurface " + arguments); }
#ifdef HASP_PYTHON // with HASP_ENABLE_PYTHON only
  int DrawInPython(const std::string& arguments)
  {
    return this->Shell(HASP_PYTHON " '" HASP_SOURCE
                                   "/Modules/Rendering/Isosurface/Examples/DrawIsosurface.py' " +
                       arguments);
  }
#endif
};

TEST_F(DrawIsosurface, WrongUseAndUnreadableFilesAreFailures)
{
  EXPECT_EQ(this->Draw(""), 1) << this->said;
  EXPECT_EQ(this->Draw("no.mha 0 picture.png"), 1) << this->said;
  EXPECT_NE(this->said.find("the .mha file"), std::string::npos) << this->said;
  this->WriteBall();
  EXPECT_EQ(this->Draw("ball.mha 0 no/such/folder.png"), 1) << this->said;
}

TEST_F(DrawIsosurface, ABallIsADisc)
{
  this->WriteBall();
  ASSERT_EQ(this->Draw("ball.mha 0 picture.png"), 0) << this->said;
  EXPECT_EQ(this->said, "");
  const hasp::RGBPicture picture = hasp::ReadPNG(this->Path("picture.png"));
  ExpectDisc(picture, 0, picture.width);
}

#ifdef HASP_PYTHON
TEST_F(DrawIsosurface, PythonDrawsTheSame)
{
  EXPECT_NE(this->DrawInPython("no.mha 0 picture.png"), 0) << this->said;
  EXPECT_NE(this->said.find("the .mha file"), std::string::npos) << this->said;
  this->WriteBall();
  ASSERT_EQ(this->DrawInPython("ball.mha 0 picture.png"), 0) << this->said;
  EXPECT_EQ(this->said, "");
  const hasp::RGBPicture picture = hasp::ReadPNG(this->Path("picture.png"));
  ExpectDisc(picture, 0, picture.width);
}
#endif

} // namespace

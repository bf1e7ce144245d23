#include "ExampleRun.h"
#include "PictureFiles.h"

#include "vtkNew.h"
#include "vtkSTLWriter.h"
#include "vtkSphereSource.h"

namespace
{

class DrawPointShell : public ExampleTest
{
protected:
  int Draw(const std::string& arguments) { return this->Run("DrawPointShell " + arguments); }
};

TEST_F(DrawPointShell, WrongUseAndUnreadableFilesAreFailures)
{
  EXPECT_EQ(this->Draw(""), 1) << this->said;
  EXPECT_EQ(this->Draw("no.stl picture.png"), 1) << this->said;
}

TEST_F(DrawPointShell, ABallIsADisc)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(30);
  ball->SetThetaResolution(60);
  ball->SetPhiResolution(60);
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputConnection(ball->GetOutputPort());
  writer->SetFileName(this->Path("ball.stl").c_str());
  ASSERT_EQ(writer->Write(), 1);
  ASSERT_EQ(this->Draw("ball.stl picture.png"), 0) << this->said;
  EXPECT_EQ(this->said, "");
  const hasp::RGBPicture picture = hasp::ReadPNG(this->Path("picture.png"));
  ExpectDisc(picture, 0, picture.width);
}

} // namespace

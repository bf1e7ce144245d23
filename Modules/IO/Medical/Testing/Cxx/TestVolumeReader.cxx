#include "IOFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeReader.h"
#include "vtkHaspVolumeView.h"
#include "vtkHaspVolumeWriter.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"

namespace
{

class VolumeReader : public IOFixture
{
protected:
  VolumeReader()
  {
    this->Note->SetClientData(&this->Errors);
    this->Note->SetCallback(
      [](vtkObject*, unsigned long, void* n, void*) { ++*static_cast<int*>(n); });
    this->Reader->AddObserver(vtkCommand::ErrorEvent, this->Note);
    this->Silent->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Silent);
  }
  std::string Sound() const
  {
    const auto file = (this->Folder / "a.mha").string();
    hasp::WriteVolume(hasp::MakeImage(this->Truth(), Samples(this->Truth())), file);
    return file;
  }
  int Errors = 0;
  vtkNew<vtkCallbackCommand> Note, Silent; ///< the pipeline repeats each error; ours is counted
  vtkNew<vtkHaspVolumeReader> Reader;
};

TEST_F(VolumeReader, NoFileNameIsAnError)
{
  this->Reader->Update();
  EXPECT_EQ(this->Errors, 1);
  EXPECT_NE(this->Reader->GetErrorCode(), 0u);
}

TEST_F(VolumeReader, ARefusalIsSaidInItsOwnWordsOnly)
{
  std::string said;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&said);
  listen->SetCallback([](vtkObject*, unsigned long, void* to, void* text)
    { *static_cast<std::string*>(to) += static_cast<const char*>(text); });
  this->Reader->AddObserver(vtkCommand::ErrorEvent, listen);
  this->Reader->SetFileName((this->Folder / "gone.mha").c_str());
  this->Reader->Update();
  vtkNew<vtkHaspVolumeWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, this->Silent);
  writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Silent);
  writer->SetInputConnection(this->Reader->GetOutputPort());
  writer->SetFileName((this->Folder / "b.mha").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(said.find("bad_function_call"), said.npos) << said;
  EXPECT_NE(this->Reader->GetErrorCode(), 0u);
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "b.mha"));
}

TEST_F(VolumeReader, PassportIsThereBeforeSamplesAndCompleteAfter)
{
  this->Reader->SetFileName(this->Sound().c_str());
  this->Reader->UpdateInformation();
  EXPECT_EQ(this->Reader->GetPassport().format, "MetaImage");
  EXPECT_EQ(this->Reader->GetPassport().geometry.dims, glm::ivec3(12, 10, 8));
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 0);
  this->Reader->Update();
  EXPECT_EQ(this->Reader->GetPassport().maximum, 559);
  ExpectSame({ this->Reader->GetPassport(), this->Reader->GetOutput() }, this->Truth(),
    Samples(this->Truth()));
  EXPECT_EQ(this->Errors, 0);
  EXPECT_EQ(this->Reader->GetErrorCode(), 0u);
}

TEST_F(VolumeReader, FailureLeavesNothingOfAnEarlierFile)
{
  this->Reader->SetFileName(this->Sound().c_str());
  this->Reader->Update();
  ASSERT_GT(this->Reader->GetOutput()->GetNumberOfPoints(), 0);
  WriteBytes(this->Folder / "b.mha", "no image");
  this->Reader->SetFileName((this->Folder / "b.mha").c_str());
  this->Reader->Update();
  EXPECT_GE(this->Errors, 1);
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(this->Reader->GetPassport().format.empty());
  EXPECT_NE(this->Reader->GetErrorCode(), 0u);
}

TEST_F(VolumeReader, AbortLeavesNothingAndIsNotForEver)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* reader, unsigned long, void*, void*)
    { static_cast<vtkHaspVolumeReader*>(reader)->SetAbortExecute(1); });
  const auto tag = this->Reader->AddObserver(vtkCommand::ProgressEvent, abort);
  this->Reader->SetFileName(this->Sound().c_str());
  this->Reader->Update();
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 0);
  this->Reader->RemoveObserver(tag);
  this->Reader->Modified();
  this->Reader->Update();
  EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 960);
}

TEST_F(VolumeReader, BadSettingsAreRefused)
{
  const std::string file = this->Sound();
  hasp::VolumeReadSettings settings;
  settings.series = -1;
  EXPECT_THROW(hasp::OpenVolume(file, settings), std::invalid_argument);
  settings.series = 2; // the file has one
  this->ExpectRefused(file, { "a.mha: series 2" }, settings);
  settings = {};
  settings.decoderSilenceSeconds = 0.0;
  EXPECT_THROW(hasp::OpenVolume(file, settings), std::invalid_argument);
  settings.decoderSilenceSeconds = 30.0;
  settings.decoderTotalSeconds = 1e300; // no processor limit holds so many
  EXPECT_THROW(hasp::OpenVolume(file, settings), std::invalid_argument);
  settings = {};
  settings.memoryLimitBytes = 100;
  this->ExpectRefused(file, { "memory limit" }, settings);
}

TEST_F(VolumeReader, UnknownKindsAreNamed)
{
  WriteBytes(this->Folder / "scan.pdf", "%PDF");
  this->ExpectRefused(this->Folder / "scan.pdf", { "scan.pdf", ".mha" });
  WriteBytes(this->Folder / "slice", std::string(128, '\0') + "DICM");
  this->ExpectRefused(this->Folder / "slice", { "single DICOM file", "folder" });
}

#if !HASP_WITH_DCMTK
TEST_F(VolumeReader, BuildWithoutDicomSaysSo)
{
  this->ExpectRefused(this->Folder, { "HASP_ENABLE_DCMTK" });
}
#endif

#if !HASP_WITH_LIBARCHIVE
TEST_F(VolumeReader, BuildWithoutInvesaliusSaysSo)
{
  WriteBytes(this->Folder / "a.inv3", "x");
  this->ExpectRefused(this->Folder / "a.inv3", { "HASP_ENABLE_LIBARCHIVE" });
}
#endif

} // namespace

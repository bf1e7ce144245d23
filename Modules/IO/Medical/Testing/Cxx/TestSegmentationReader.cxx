#include "IOFixture.h"
#include "SegmentationText.h"

#include "vtkHaspLabelTable.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspSegmentationReader.h"
#include "vtkHaspSegmentationWriter.h"
#include "vtkHaspVolumeReader.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTrivialProducer.h"

#include <cstring>
#include <sstream>

namespace
{

const hasp::LabelTable Table{ { 1, "Bone", { 227, 218, 201 } },
  { 300, "left: \"condyle\"", { 10, 20, 30 } } };

class SegmentationSkin : public IOFixture
{
protected:
  std::string File() const { return (this->Folder / "a.seg.nrrd").string(); }

  vtkSmartPointer<vtkImageData> Labels() const
  {
    const auto g = this->Truth();
    std::vector<std::uint16_t> labels(g.Size());
    labels[100] = 1;
    labels[500] = 300;
    const auto image = hasp::MakeImage(g, labels);
    hasp::SetLabelTable(image, Table);
    return image;
  }
  int Write(vtkImageData* image, const std::string& file) const
  {
    vtkNew<vtkHaspSegmentationWriter> writer;
    this->Listen(writer);
    writer->SetInputData(image);
    writer->SetFileName(file.c_str());
    return writer->Write();
  }
  /// Errors are kept instead of printed.
  void Listen(vtkAlgorithm* algorithm) const
  {
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(&this->Said);
    note->SetCallback([](vtkObject*, unsigned long, void* said, void* text)
      { *static_cast<std::string*>(said) += static_cast<const char*>(text); });
    algorithm->AddObserver(vtkCommand::ErrorEvent, note);
    vtkNew<vtkCallbackCommand> silence; // of the executive, which says that it failed
    silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  }
  static bool SameSamples(vtkImageData* a, vtkImageData* b)
  {
    return a->GetNumberOfPoints() == b->GetNumberOfPoints() &&
           std::memcmp(a->GetScalarPointer(), b->GetScalarPointer(), 2 * a->GetNumberOfPoints()) ==
             0;
  }

  mutable std::string Said;
};

TEST_F(SegmentationSkin, ErrorsAreReportedAndLeaveNothing)
{
  vtkNew<vtkHaspSegmentationReader> reader;
  this->Listen(reader);
  reader->Update();
  EXPECT_NE(this->Said.find("no file or folder is named"), std::string::npos) << this->Said;
  EXPECT_NE(reader->GetErrorCode(), vtkErrorCode::NoError);
  this->Write(this->Labels(), this->File());
  reader->SetFileName(this->File().c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 960);
  std::filesystem::resize_file(this->File(), 100);
  reader->Modified();
  reader->Update();
  EXPECT_NE(reader->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(hasp::GetLabelTable(reader->GetOutput()).empty());
}

TEST_F(SegmentationSkin, WhatCannotBeWrittenLeavesTheEarlierFile)
{
  WriteBytes(this->File(), "earlier");
  const auto image = this->Labels();
  hasp::SetLabelTable(image, { { 1, "a\tb" } });
  EXPECT_EQ(this->Write(image, this->File()), 0);
  EXPECT_NE(this->Said.find("control character"), std::string::npos) << this->Said;
  image->GetFieldData()->RemoveArray("LabelNames");
  EXPECT_EQ(this->Write(image, this->File()), 0);
  EXPECT_NE(this->Said.find("LabelNames"), std::string::npos) << this->Said;
  const auto g = this->Truth();
  EXPECT_EQ(this->Write(hasp::MakeImage(g, std::vector<float>(g.Size())), this->File()), 0);
  EXPECT_NE(this->Said.find("float32, must be uint8 or uint16"), std::string::npos) << this->Said;
  EXPECT_EQ(this->Write(image, (this->Folder / "a.txt").string()), 0);
  EXPECT_EQ(ReadBytes(this->File()), "earlier");
  const auto files = std::filesystem::directory_iterator(this->Folder);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(SegmentationSkin, LabelsAndTableComeBack)
{
  const auto image = this->Labels();
  ASSERT_EQ(this->Write(image, this->File()), 1) << this->Said;
  vtkNew<vtkHaspSegmentationReader> reader;
  reader->SetFileName(this->File().c_str());
  reader->Update();
  EXPECT_TRUE(SameSamples(reader->GetOutput(), image));
  EXPECT_EQ(hasp::GetLabelTable(reader->GetOutput()), Table);
  EXPECT_EQ(hasp::ImageGeometry(reader->GetOutput()).origin, this->Truth().origin);
  EXPECT_EQ(reader->GetPassport().segments, 2);
  std::ostringstream text;
  reader->Print(text);
  EXPECT_EQ(text.str().find("condyle"), std::string::npos) << "names stay out of logs";

  const std::string plain = (this->Folder / "a.mha").string();
  ASSERT_EQ(this->Write(image, plain), 1) << this->Said;
  reader->SetFileName(plain.c_str());
  reader->Update();
  EXPECT_TRUE(SameSamples(reader->GetOutput(), image));
  EXPECT_TRUE(hasp::GetLabelTable(reader->GetOutput()).empty()) << "nothing of the file before";
}

TEST_F(SegmentationSkin, AScanAsInputGivesTheGrid)
{
  // The file holds the first half of the scan's slices.
  const auto scan = this->Truth();
  hasp::GridGeometry half = scan;
  half.dims.z = 4;
  std::vector<std::uint16_t> labels(half.Size());
  labels[101] = 9;
  ASSERT_EQ(this->Write(hasp::MakeImage(half, labels), this->File()), 1);
  const std::string grey = (this->Folder / "scan.mha").string();
  hasp::WriteVolume(hasp::MakeImage(scan, Samples(scan)), grey);
  vtkNew<vtkHaspVolumeReader> source;
  source->SetFileName(grey.c_str());
  vtkNew<vtkHaspSegmentationReader> reader;
  this->Listen(reader);
  reader->SetFileName(this->File().c_str());
  reader->SetInputConnection(source->GetOutputPort());
  reader->Update();
  EXPECT_EQ(this->Said, "");
  labels.resize(scan.Size());
  EXPECT_TRUE(SameSamples(reader->GetOutput(), hasp::MakeImage(scan, labels)));
  EXPECT_EQ(hasp::ImageGeometry(reader->GetOutput()).dims, scan.dims);
  EXPECT_EQ(hasp::GetLabelTable(reader->GetOutput()).at(0).name, "Fragment 9");

  // An extent that starts elsewhere: the same place.
  vtkNew<vtkImageData> shifted;
  shifted->ShallowCopy(source->GetOutput());
  shifted->SetExtent(5, 16, 0, 9, 0, 7);
  const glm::dvec3 origin = scan.IndexToWorld({ -5, 0, 0 });
  shifted->SetOrigin(origin.x, origin.y, origin.z);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(shifted);
  reader->SetInputConnection(producer->GetOutputPort());
  reader->Update();
  EXPECT_EQ(this->Said, "");
  EXPECT_TRUE(SameSamples(reader->GetOutput(), hasp::MakeImage(scan, labels)));

  shifted->SetOrigin(0, 0, 0);
  shifted->Modified();
  producer->Modified();
  reader->Update();
  EXPECT_NE(this->Said.find("another grid"), std::string::npos) << this->Said;
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
}

} // namespace

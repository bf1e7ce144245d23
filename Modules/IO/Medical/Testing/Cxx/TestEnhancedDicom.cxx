#include "DicomFixture.h"

#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dcxfer.h>

#include <cstdio>

namespace
{

/// Enhanced CT: one file of many frames, whose places stand in functional groups.
class EnhancedDicom : public DicomFixture
{
protected:
  static std::string Decimals(std::initializer_list<double> numbers)
  {
    std::string text;
    for (const double number : numbers)
    {
      char one[32];
      std::snprintf(one, sizeof(one), "%s%.12g", text.empty() ? "" : "\\", number);
      text += one;
    }
    return text;
  }
  static DcmItem& Macro(DcmItem& group, const DcmTagKey& tag)
  {
    DcmItem* macro = nullptr;
    EXPECT_TRUE(group.findOrCreateSequenceItem(tag, macro).good());
    return *macro;
  }
  static DcmItem& Group(DcmDataset& data, const DcmTagKey& tag, int frame)
  {
    DcmItem* group = nullptr;
    EXPECT_TRUE(data.findOrCreateSequenceItem(tag, group, frame).good());
    return *group;
  }
  /// Frames in another order than they lie in, so that places and not numbers must count.
  static int SliceOf(int frame, int count) { return (frame * 5 + 3) % count; }

  /// `edit` changes the whole data set before it is compressed and saved.
  std::filesystem::path Enhanced(E_TransferSyntax syntax = EXS_LittleEndianExplicit,
    const std::function<void(DcmDataset&)>& edit = {}) const
  {
    const auto g = this->Truth();
    const auto samples = Samples(g);
    const auto folder = this->Folder / "enhanced";
    std::filesystem::remove_all(folder);
    this->WriteSeries(folder, g, samples); // its first slice has all that is not of a frame
    DcmFileFormat file;
    EXPECT_TRUE(file.loadFile(OFFilename(this->FileOf(folder, 0).c_str())).good());
    file.loadAllDataIntoMemory();
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    DcmDataset& data = *file.getDataset();
    for (const DcmTagKey& tag : { DCM_PixelSpacing, DCM_ImagePositionPatient,
           DCM_ImageOrientationPatient, DCM_RescaleSlope, DCM_RescaleIntercept, DCM_RescaleType })
      data.findAndDeleteElement(tag);
    data.putAndInsertString(DCM_SOPClassUID, UID_EnhancedCTImageStorage);
    data.putAndInsertString(DCM_NumberOfFrames, std::to_string(g.dims.z).c_str());
    DcmItem& shared = Group(data, DCM_SharedFunctionalGroupsSequence, 0);
    DcmItem& measures = Macro(shared, DCM_PixelMeasuresSequence);
    measures.putAndInsertString(DCM_PixelSpacing, Decimals({ g.spacing.y, g.spacing.x }).c_str());
    measures.putAndInsertString(DCM_SliceThickness, "1.25");
    const glm::dvec3 x = g.direction[0], y = g.direction[1];
    Macro(shared, DCM_PlaneOrientationSequence)
      .putAndInsertString(
        DCM_ImageOrientationPatient, Decimals({ x.x, x.y, x.z, y.x, y.y, y.z }).c_str());
    std::vector<Uint16> pixels;
    const std::size_t inSlice = std::size_t(g.dims.x) * g.dims.y;
    for (int frame = 0; frame < g.dims.z; ++frame)
    {
      const int k = SliceOf(frame, g.dims.z);
      DcmItem& group = Group(data, DCM_PerFrameFunctionalGroupsSequence, frame);
      const glm::dvec3 p = g.IndexToWorld({ 0, 0, k });
      Macro(group, DCM_PlanePositionSequence)
        .putAndInsertString(DCM_ImagePositionPatient, Decimals({ p.x, p.y, p.z }).c_str());
      // Each frame its own rescaling, as PET and MR have it.
      DcmItem& values = Macro(group, DCM_PixelValueTransformationSequence);
      values.putAndInsertString(DCM_RescaleSlope, "1");
      values.putAndInsertString(DCM_RescaleIntercept, std::to_string(-1024 - frame).c_str());
      values.putAndInsertString(DCM_RescaleType, "HU");
      for (std::size_t n = 0; n < inSlice; ++n)
        pixels.push_back(static_cast<Uint16>(samples[k * inSlice + n] + 1024 + frame));
    }
    data.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
    if (edit)
      edit(data);
    if (syntax == EXS_RLELossless)
    {
      DcmRLEEncoderRegistration::registerCodecs();
      EXPECT_TRUE(data.chooseRepresentation(syntax, nullptr).good());
    }
    EXPECT_TRUE(file.saveFile(OFFilename((folder / "all.dcm").c_str()), syntax).good());
    return folder;
  }
};

TEST_F(EnhancedDicom, WithoutGroupsForEachFrameItIsRefused)
{
  this->ExpectRefused(this->Enhanced(EXS_LittleEndianExplicit, [](DcmDataset& data)
                        { data.findAndDeleteElement(DCM_PerFrameFunctionalGroupsSequence); }),
    { "all.dcm", "8 frames" });
  this->ExpectRefused(this->Enhanced(EXS_LittleEndianExplicit,
                        [](DcmDataset& data) { data.putAndInsertString(DCM_NumberOfFrames, "9"); }),
    { "all.dcm", "9 frames" });
}

TEST_F(EnhancedDicom, FaultsOfAFrameAreNamedByItsNumber)
{
  const auto frame5 = [](const std::function<void(DcmItem&)>& edit)
  { return [=](DcmDataset& data) { edit(Group(data, DCM_PerFrameFunctionalGroupsSequence, 4)); }; };
  this->ExpectRefused(
    this->Enhanced(EXS_LittleEndianExplicit,
      frame5([](DcmItem& group) { group.findAndDeleteElement(DCM_PlanePositionSequence); })),
    { "all.dcm (frame 5)", "no position" });
  this->ExpectRefused(
    this->Enhanced(EXS_LittleEndianExplicit, frame5(
                                               [](DcmItem& group) {
                                                 Macro(group, DCM_PixelValueTransformationSequence)
                                                   .putAndInsertString(DCM_RescaleSlope, "0");
                                               })),
    { "all.dcm (frame 5)", "slope" });
}

TEST_F(EnhancedDicom, CutOffPixelsAreAnError)
{
  const auto folder = this->Enhanced();
  const auto file = folder / "all.dcm";
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 300);
  this->ExpectRefused(folder, { "all.dcm (frame", "cut off" });
}

TEST_F(EnhancedDicom, FramesAreReadWhereTheyLie)
{
  const auto g = this->Truth();
  for (const E_TransferSyntax syntax : { EXS_LittleEndianExplicit, EXS_LittleEndianImplicit,
         EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit, EXS_RLELossless })
  {
    SCOPED_TRACE(DcmXfer(syntax).getXferName());
    const auto volume = Read(this->Enhanced(syntax));
    ExpectSame(volume, g, Samples(g));
    EXPECT_TRUE(volume.passport.hounsfield);
  }
}

TEST_F(EnhancedDicom, FramesOfTwoFilesMakeOneVolume)
{
  // The frames of each are every other slice.
  const auto g = this->Truth();
  const auto folder = this->Enhanced();
  DcmFileFormat file;
  ASSERT_TRUE(file.loadFile(OFFilename((folder / "all.dcm").c_str())).good());
  file.loadAllDataIntoMemory();
  const std::size_t inSlice = std::size_t(g.dims.x) * g.dims.y;
  const Uint16* all = nullptr;
  ASSERT_TRUE(file.getDataset()->findAndGetUint16Array(DCM_PixelData, all).good());
  const std::vector<Uint16> pixels(all, all + g.Size());
  for (const int half : { 0, 1 })
  {
    DcmFileFormat part(file);
    DcmDataset& data = *part.getDataset();
    std::vector<Uint16> own;
    DcmSequenceOfItems* groups = nullptr;
    ASSERT_TRUE(data.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, groups).good());
    for (int frame = g.dims.z - 1; frame >= 0; --frame)
      if (frame % 2 != half)
        delete groups->remove(static_cast<unsigned long>(frame));
    for (int frame = half; frame < g.dims.z; frame += 2)
      own.insert(
        own.end(), pixels.begin() + frame * inSlice, pixels.begin() + (frame + 1) * inSlice);
    data.putAndInsertUint16Array(DCM_PixelData, own.data(), own.size());
    data.putAndInsertString(DCM_NumberOfFrames, std::to_string(g.dims.z / 2).c_str());
    const auto name = folder / ("half" + std::to_string(half));
    ASSERT_TRUE(part.saveFile(OFFilename(name.c_str()), EXS_LittleEndianExplicit).good());
  }
  std::filesystem::remove(folder / "all.dcm");
  ExpectSame(Read(folder), g, Samples(g));
}

} // namespace

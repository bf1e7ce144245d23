#include "DecoderRun.h"
#include "IOFixture.h"

#include <chrono>
#include <map>

namespace
{

const std::filesystem::path Files = HASP_PYDICOM_FILES;

/// Files of many makers and faults, each alone in a folder. What they are was looked up with
/// pydicom itself: modality, size, frames, samples, bits, transfer syntax, position, pixels.
class PydicomFiles : public IOFixture
{
protected:
  /// The error of opening it, "" if it opens.
  static std::string Outcome(const std::filesystem::path& folder)
  {
    const auto start = std::chrono::steady_clock::now();
    std::string says;
    try
    {
      Read(folder);
    }
    catch (const std::runtime_error& error)
    {
      says = error.what();
    }
    // Neither a hang (named as such) nor anything near one.
    EXPECT_EQ(says.find("hangs"), says.npos) << says;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << folder;
    return says;
  }
  std::string Alone(const std::filesystem::path& file) const
  {
    const auto folder = this->Folder / "alone";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::filesystem::copy_file(file, folder / file.filename());
    const std::string says = Outcome(folder);
    const auto after = std::filesystem::directory_iterator(folder);
    EXPECT_EQ(std::distance(begin(after), end(after)), 1) << "a file was written beside " << file;
    return says;
  }
};

constexpr const char *Single = "needs at least two", *Foreign = "is a DICOM image",
                     *Colour = "is a colour picture", *Frames = "frames;",
                     *Bits32 = "32 bits stored in 32", *Bits1 = "1 bits stored in 1",
                     *J2K = "compressed as \"JPEG 2000\"",
                     *J2KLossless = "compressed as \"JPEG 2000 (lossless only)\"",
                     *Damaged = "damaged or cut off", *NoSpacing = "no pixel spacing",
                     *NoPosition = "no position";

const std::map<std::string, const char*> Expected = {
  // Sound slices of a scan, but only one each.
  { "CT_small.dcm", Single },
  { "MR_small.dcm", Single },
  { "MR_small_RLE.dcm", Single },
  { "MR_small_bigendian.dcm", Single },
  { "MR_small_expb.dcm", Single },
  { "MR_small_implicit.dcm", Single },
  { "MR_small_jpeg_ls_lossless.dcm", Single },
  { "MR_small_padded.dcm", Single },
  // Monochrome, and not of a volume.
  { "image_dfl.dcm", NoSpacing },
  { "JPEG-lossy.dcm", NoPosition },
  { "JPGExtended.dcm", NoPosition },
  // Not decoded.
  { "693_J2KI.dcm", J2K },
  { "JPEG2000.dcm", J2K },
  { "JPEG2000-embedded-sequence-delimiter.dcm", J2K },
  { "SC_rgb_gdcm_KY.dcm", J2K },
  { "GDCMJ2K_TextGBR.dcm", J2KLossless },
  { "J2K_pixelrep_mismatch.dcm", J2KLossless },
  { "MR_small_jp2klossless.dcm", J2KLossless },
  // Doses and segments: other bits, or many frames.
  { "rtdose.dcm", Frames },
  { "rtdose_expb.dcm", Frames },
  { "rtdose_rle.dcm", Frames },
  { "rtdose_1frame.dcm", Bits32 },
  { "rtdose_expb_1frame.dcm", Bits32 },
  { "rtdose_rle_1frame.dcm", Bits32 },
  { "badVR.dcm", Bits32 }, // 15 frames, but says "1A"
  { "liver_1frame.dcm", Bits1 },
  { "liver_expb_1frame.dcm", Bits1 },
  // Colour.
  { "ExplVR_BigEnd.dcm", Colour },
  { "SC_jpeg_no_color_transform.dcm", Colour },
  { "SC_rgb_dcmtk_+eb+cr.dcm", Colour },
  { "SC_rgb_dcmtk_+eb+cy+np.dcm", Colour },
  { "SC_rgb_jpeg_dcmd.dcm", Colour },
  { "SC_rgb_jpeg_gdcm.dcm", Colour },
  { "SC_rgb_rle.dcm", Colour },
  { "SC_rgb_rle_16bit.dcm", Colour },
  { "SC_rgb_rle_32bit.dcm", Colour },
  { "SC_rgb_small_odd.dcm", Colour },
  { "SC_rgb_small_odd_jpeg.dcm", Colour },
  { "SC_ybr_full_422_uncompressed.dcm", Colour },
  { "SC_rgb_rle_2frame.dcm", Frames },
  { "SC_rgb_rle_16bit_2frame.dcm", Frames },
  { "SC_rgb_rle_32bit_2frame.dcm", Frames },
  // Cut off, or with lengths that lead nowhere.
  { "rtplan_truncated.dcm", Damaged },
  { "SC_rgb_jpeg.dcm", Damaged },
  // DICOM, but no image; with and without a preamble.
  { "rtplan.dcm", Foreign },
  { "rtstruct.dcm", Foreign },
  { "ExplVR_LitEndNoMeta.dcm", Foreign },
  { "ExplVR_BigEndNoMeta.dcm", Foreign },
  { "no_meta.dcm", Foreign },
  { "no_meta_group_length.dcm", Foreign },
  { "meta_missing_tsyntax.dcm", Foreign },
  { "nested_priv_SQ.dcm", Foreign },
  { "priv_SQ.dcm", Foreign },
  { "UN_sequence.dcm", Foreign },
  { "empty_charset_LEI.dcm", Foreign },
  { "reportsi.dcm", Foreign },
  { "test-SR.dcm", Foreign },
  { "waveform_ecg.dcm", Foreign },
  { "dicomdirtests/DICOMDIR", Foreign },
  { "dicomdirtests/DICOMDIR-bigEnd", Foreign },
  { "dicomdirtests/DICOMDIR-implicit", Foreign },
  // No DICOM.
  { "zipMR.gz", Foreign },
  { "test1.json", Foreign },
  { "rtplan.dump", Foreign },
};

TEST_F(PydicomFiles, EachAloneIsRefusedForWhatItIs)
{
  int known = 0, found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(Files))
  {
    if (!entry.is_regular_file())
      continue;
    ++found;
    const std::string says = this->Alone(entry.path());
    EXPECT_FALSE(says.empty()) << entry.path() << " is no volume, and opened";
    EXPECT_EQ(says.find("the DICOM decoder"), says.npos) << says; // it never gives up or crashes
    const auto expected = Expected.find(entry.path().lexically_relative(Files).string());
    if (expected == Expected.end())
      continue;
    ++known;
    EXPECT_NE(says.find(expected->second), says.npos) << entry.path() << ": " << says;
  }
  EXPECT_GE(known, 40) << "of " << found; // another version of pydicom may lack some
}

TEST_F(PydicomFiles, FoldersAreOpenedOrRefusedForWhatTheyHold)
{
  const std::map<std::string, std::string> folders = {
    { "98892001/CT5N", "" }, // five slices, 2.5 mm apart
    { "98892001/CT2N", "turned against" },
    { "98892001", "2 series" },
    { "98892003", "7 series" },
    { "98892003/MR700", "turned against" }, // a fan around one axis
    { "77654033", "4 series" },
    { "77654033/CT2", "161 slices are missing" },
    { "77654033/CR1", NoSpacing },
    { "TINY_ALPHA", "none of its 52 files" },
    { "", "13 series" },
  };
  for (const auto& [name, expected] : folders)
  {
    const std::string says = Outcome(Files / "dicomdirtests" / name);
    EXPECT_NE(says.find(expected), says.npos) << name << ": " << says;
    EXPECT_EQ(says.empty(), expected.empty()) << name << ": " << says;
  }
  // From feet to head, although instance numbers run the other way.
  const auto volume = Read(Files / "dicomdirtests" / "98892001" / "CT5N");
  EXPECT_EQ(volume.passport.geometry.dims, glm::ivec3(16, 16, 5));
  EXPECT_NEAR(volume.passport.geometry.spacing.z, 2.5, 1e-6);
  EXPECT_NEAR(volume.passport.geometry.origin.z, -1.2375, 1e-6);
  EXPECT_TRUE(volume.passport.hounsfield);
}

TEST_F(PydicomFiles, OnePictureIsTheSameInEachTransferSyntax)
{
  const std::string pixels = RunDecoder("decode", Files / "MR_small.dcm", this->Folder).pixels;
  EXPECT_EQ(pixels.size(), 64U * 64 * 2);
  for (const char* other : { "MR_small_implicit.dcm", "MR_small_bigendian.dcm", "MR_small_expb.dcm",
         "MR_small_RLE.dcm", "MR_small_jpeg_ls_lossless.dcm", "MR_small_padded.dcm" })
    EXPECT_EQ(RunDecoder("decode", Files / other, this->Folder).pixels, pixels) << other;
  // And it is what stands in the file, byte for byte.
  EXPECT_NE(ReadBytes(Files / "MR_small.dcm").find(pixels), std::string::npos);
  const std::string ct = RunDecoder("decode", Files / "CT_small.dcm", this->Folder).pixels;
  EXPECT_NE(ReadBytes(Files / "CT_small.dcm").find(ct), std::string::npos);
}

TEST_F(PydicomFiles, AttributesOfUnknownTypeAreReadAsTheDictionaryHasThem)
{
  // Its maker wrote Modality as UN, as converters do that do not know an attribute.
  EXPECT_STREQ(
    RunDecoder("scan", Files / "rtdose_rle.dcm", this->Folder).record.modality, "RTDOSE");
}

} // namespace

#include "DicomFixture.h"

#include <chrono>
#include <cstdlib>
#include <fstream>

namespace
{

constexpr double MiB = 1 << 20;

/// What the child held at most, read from its own resource usage (MeasuredDecoder.cxx).
class DecoderMemory : public DicomFixture
{
protected:
  DecoderMemory()
  {
    setenv("HASP_DICOM_DECODER", HASP_MEASURED_DECODER, 1);
    setenv("HASP_PEAK_FILE", (this->Folder / "peak").c_str(), 1);
  }
  ~DecoderMemory() override
  {
    unsetenv("HASP_DICOM_DECODER");
    unsetenv("HASP_PEAK_FILE");
  }
  void SetUp() override
  {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "AddressSanitizer takes memory of its own, without limit";
#endif
  }
  /// The peak of the latest child in that mode, MiB.
  double Peak(const std::string& mode) const
  {
    std::ifstream file(this->Folder / "peak");
    std::string word;
    double kib = 0.0, last = 0.0;
    while (file >> word >> kib)
      if (word == mode)
        last = kib;
    EXPECT_GT(last, 0.0) << "no child ran in mode " << mode;
    return last / 1024.0;
  }
  /// What it holds to read the least series there is.
  double Base()
  {
    Read(this->Faulty({}));
    return std::max(this->Peak("scan"), this->Peak("decode"));
  }
  /// Two slices of n x n, noise in 12 bits so that nothing packs well; or all one value.
  std::filesystem::path Large(
    int n, E_TransferSyntax syntax, const Edit& edit = {}, bool noise = true) const
  {
    auto g = this->Truth();
    g.dims = { n, n, 1 };
    std::vector<std::int16_t> samples(g.Size());
    std::uint32_t state = 1;
    for (std::int16_t& sample : samples)
      sample = static_cast<std::int16_t>((state = state * 1664525U + 1013904223U) >> 20) - 1024;
    if (!noise)
      std::fill(samples.begin(), samples.end(), std::int16_t{ 0 });
    const auto folder = this->Folder / "large";
    std::filesystem::remove_all(folder);
    this->WriteSeries(folder, g, samples, edit, syntax);
    this->Change(this->FileOf(folder, 0), this->FileOf(folder, 1), syntax,
      [&](DcmDataset& slice)
      {
        const glm::dvec3 p = g.IndexToWorld({ 0, 0, 1 });
        slice.putAndInsertString(DCM_ImagePositionPatient,
          (std::to_string(p.x) + "\\" + std::to_string(p.y) + "\\" + std::to_string(p.z)).c_str());
      });
    return folder;
  }
  /// A copy with another header over the same compressed pixels.
  static void Change(const std::filesystem::path& from, const std::filesystem::path& to,
    E_TransferSyntax syntax, const std::function<void(DcmDataset&)>& edit)
  {
    DcmFileFormat file;
    ASSERT_TRUE(file.loadFile(OFFilename(from.c_str())).good());
    file.loadAllDataIntoMemory();
    edit(*file.getDataset());
    ASSERT_TRUE(file.saveFile(OFFilename(to.c_str()), syntax).good());
  }
};

TEST_F(DecoderMemory, StaysWithinFourTimesTheSliceForEachCompression)
{
  const double base = this->Base(), declared = 1024 * 1024 * 2 / MiB;
  RecordProperty("base_MiB", std::to_string(base));
  for (const E_TransferSyntax syntax :
    { EXS_LittleEndianExplicit, EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit,
      EXS_RLELossless, EXS_JPEGProcess14SV1, EXS_JPEGLSLossless, EXS_JPEGProcess2_4 })
  {
    SCOPED_TRACE(DcmXfer(syntax).getXferName());
    Read(this->Large(1024, syntax));
    RecordProperty(DcmXfer(syntax).getXferName(),
      std::to_string((this->Peak("decode") - base) / declared) + " x declared");
    EXPECT_LE(this->Peak("decode"), base + 4.0 * declared);
    EXPECT_LE(this->Peak("scan"), base + 4.0); // no pixels are touched
  }
}

TEST_F(DecoderMemory, LargeSlicesPassWithTheDefaultLimits)
{
  // The slowest codec there is, at the size of the largest detectors' pictures.
  const auto folder = this->Large(4096, EXS_JPEGProcess14SV1);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(Read(folder).passport.geometry.dims, glm::ivec3(4096, 4096, 2));
  RecordProperty("ms",
    std::to_string(
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count()));
}

/// Bombs: small files that would become large. All end in a sentence, within the child's limits.
class DecoderBombs : public DecoderMemory
{
protected:
  /// 64 MiB it may take to parse, and four times each file of `folder` at most besides; 4 MiB are
  /// for what was mapped before and is only touched now (code, stack).
  void ExpectContained(const std::filesystem::path& folder, double base, double largestMiB) const
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
    EXPECT_FALSE(says.empty()) << "it was read";
    RecordProperty("says", says);
    std::ifstream file(this->Folder / "peak");
    std::string mode;
    for (double kib = 0.0; file >> mode >> kib;)
      EXPECT_LE(kib / 1024.0, base + 64.0 + 4.0 + 4.0 * largestMiB) << mode << ": " << says;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10)) << says;
  }
};

TEST_F(DecoderBombs, DeflatedZerosAreContained)
{
  const double base = this->Base();
  const auto folder = this->Large(16, EXS_DeflatedLittleEndianExplicit,
    [](int, DcmDataset& slice)
    {
      const std::vector<Uint8> zeros(100 << 20); // 100 KiB once deflated
      slice.putAndInsertUint8Array(DcmTag(0x0029, 0x1010, EVR_OB), zeros.data(), zeros.size());
    });
  this->ExpectContained(folder, base, 0.25);
}

TEST_F(DecoderBombs, PictureLargerThanDeclaredIsContained)
{
  const double base = this->Base();
  for (const E_TransferSyntax syntax :
    { EXS_JPEGLSLossless, EXS_JPEGProcess14SV1, EXS_JPEGProcess2_4 })
  {
    SCOPED_TRACE(DcmXfer(syntax).getXferName());
    const auto folder = this->Large(6000, syntax, {}, false); // 72 MB a slice; says 16 x 16
    for (int k = 0; k < 2; ++k)
      Change(this->FileOf(folder, k), this->FileOf(folder, k), syntax,
        [](DcmDataset& slice)
        {
          slice.putAndInsertUint16(DCM_Rows, 16);
          slice.putAndInsertUint16(DCM_Columns, 16);
        });
    const auto bytes = double(std::filesystem::file_size(this->FileOf(folder, 0)));
    this->ExpectContained(folder, base, bytes / MiB);
  }
}

TEST_F(DecoderBombs, LengthsBeyondTheFileTakeNoMemory)
{
  const double base = this->Base();
  const std::string sound = ReadBytes(this->FileOf(this->Faulty({}), 0));
  const std::string pixels("\xE0\x7F\x10\x00OW\0\0", 8);
  const std::size_t at = sound.find(pixels);
  ASSERT_NE(at, sound.npos);
  for (const char* length : { "\xFE\xFF\xFF\x7F", "\xFE\xFF\xFF\xFF", "\0\0\0\x80" })
    for (const char* tag : { "\xE0\x7F\x10\x00OW", "\x28\x00\x10\x50OB", "\x28\x00\x10\x51UT" })
    {
      const auto folder = this->Folder / "long";
      std::filesystem::create_directories(folder);
      WriteBytes(folder / "a.dcm", sound.substr(0, at) + std::string(tag, 6) +
                                     std::string("\0\0", 2) + std::string(length, 4) + "end");
      this->ExpectContained(folder, base, 0.0);
    }
}

TEST_F(DecoderBombs, ManyOrDeeplyNestedItemsAreContained)
{
  const double base = this->Base();
  const std::string sound = ReadBytes(this->FileOf(this->Faulty({}), 0));
  const std::size_t at = sound.find(std::string("\x28\x00\x02\x00US", 6)); // before Samples
  ASSERT_NE(at, sound.npos);
  const std::string sequence("\x21\x00\x10\x10SQ\0\0\xFF\xFF\xFF\xFF", 12),
    item("\xFE\xFF\x00\xE0\xFF\xFF\xFF\xFF", 8), empty("\xFE\xFF\x00\xE0\0\0\0\0", 8);
  std::string many = sequence, deep;
  for (int n = 0; n < 3000000; ++n) // 24 MB of empty items
    many += empty;
  for (int n = 0; n < 200000; ++n)
    deep += sequence + item;
  for (const std::string* bomb : { &many, &deep })
  {
    const auto folder = this->Folder / "items";
    std::filesystem::create_directories(folder);
    WriteBytes(folder / "a.dcm", sound.substr(0, at) + *bomb + sound.substr(at));
    this->ExpectContained(folder, base, 0.0);
  }
}

} // namespace

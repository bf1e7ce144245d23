#include "DicomFixture.h"
#include "vtkHaspFileNames.h"

namespace
{

using hasp::FaultKind;
using hasp::Passport;

/// Series whose headers or names are made to harm, or say what few do.
class DicomHostile : public DicomFixture
{
protected:
  static Passport Inspect(const std::filesystem::path& path)
  {
    return hasp::InspectVolume(path.string());
  }
  static std::vector<FaultKind> Kinds(const Passport& passport)
  {
    std::vector<FaultKind> kinds;
    for (const hasp::ImportFault& fault : passport.faults)
      kinds.push_back(fault.kind);
    return kinds;
  }
};

TEST_F(DicomHostile, HeadersOfHostileSizeAndSyntax)
{
  using enum FaultKind;
  const auto huge = [](DcmDataset& slice)
  {
    slice.putAndInsertUint16(DCM_Rows, 65535);
    slice.putAndInsertUint16(DCM_Columns, 65535);
  };
  Passport p = Inspect(this->Faulty(
    [&](int k, DcmDataset& s)
    {
      if (k == 3)
        huge(s);
    }));
  EXPECT_EQ(Kinds(p), (std::vector<FaultKind>{ Damaged, MixedSizes }));
  EXPECT_EQ(p.faults[0].files.size(), 1U);
  EXPECT_NE(p.faults[0].text.find("declares 65535 x 65535 pixels"), std::string::npos);
  p = Inspect(this->Faulty([&](int, DcmDataset& s) { huge(s); }));
  EXPECT_EQ(Kinds(p), (std::vector<FaultKind>{ Damaged, TooLarge }));
  EXPECT_EQ(p.faults[0].files.size(), 8U);
  // Their meta header names another transfer syntax than the one they are in.
  const auto named = [&](const std::string& uid)
  {
    const auto folder = this->Faulty({});
    for (int k = 0; k < 8; ++k)
    {
      std::string bytes = ReadBytes(this->FileOf(folder, k));
      const std::string is("1.2.840.10008.1.2.1\0", 20);
      const auto at = bytes.find(is);
      EXPECT_NE(at, bytes.npos);
      WriteBytes(this->FileOf(folder, k), bytes.replace(at, uid.size(), uid));
    }
    return Inspect(folder);
  };
  p = named("1.2.840.10008.1.2.2"); // big endian
  EXPECT_EQ(Kinds(p), std::vector<FaultKind>{ Damaged });
  EXPECT_EQ(p.faults[0].files.size(), 8U);
  p = named("1.2.840.10008.1.2.9"); // none
  EXPECT_EQ(Kinds(p), std::vector<FaultKind>{ Unsupported });
  EXPECT_NE(p.faults[0].text.find("\"unknown\""), std::string::npos) << p.faults[0].text;
}

TEST_F(DicomHostile, Monochrome1IsTakenWithANote)
{
  const auto folder = this->Faulty(
    [](int, DcmDataset& s) { s.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME1"); });
  const Passport p = Inspect(folder);
  EXPECT_TRUE(p.faults.empty());
  EXPECT_EQ(p.photometric, "MONOCHROME1");
  ASSERT_EQ(p.warnings.size(), 1U);
  EXPECT_NE(p.warnings[0].find("MONOCHROME1, to be shown inverted"), std::string::npos);
  ExpectSame(Read(folder), this->Truth(), Samples(this->Truth()));
}

TEST_F(DicomHostile, HostileNamesAreReadAndNeverSaidRaw)
{
  const auto folder = this->Faulty(
    [](int k, DcmDataset& s)
    {
      if (k == 2)
        s.putAndInsertString(DCM_RescaleSlope, "0");
    });
  const std::vector<std::string> names{ "a\nb", "q\"'`$(x)", "\x1b[31m\x1b]0;t\x07", "\xff\xfe\x80",
    "\xe2\x80\xae"
    "gnp",
    "\xc2\x9b"
    "31m",
    "%s%n", std::string(250, 'L') };
  for (int k = 0; k < 8; ++k)
    std::filesystem::rename(this->FileOf(folder, k), folder / names[k]);
  for (const bool shown : { false, true })
  {
    hasp::ShowFileNames(shown);
    const Passport p = Inspect(folder);
    ASSERT_EQ(Kinds(p), std::vector<FaultKind>{ FaultKind::BadRescale });
    EXPECT_EQ(p.faults[0].text.find("?[31m?]0;t? ") == 0, shown) << p.faults[0].text;
  }
  const auto label = [](const std::string& name) { return hasp::FileLabel("/x/" + name); };
  EXPECT_EQ(label(names[0]), "a?b");
  EXPECT_EQ(label(names[1]), names[1]);
  EXPECT_EQ(label(names[3]), "???");
  EXPECT_EQ(label(names[4]), "?gnp");
  EXPECT_EQ(label(names[5]), "?31m");
  EXPECT_EQ(label("Sch\xc3\xa4"
                  "del \xe9\xa0\xad \xf0\x9f\x92\x80"),
    "Sch\xc3\xa4"
    "del \xe9\xa0\xad \xf0\x9f\x92\x80");
  // Longer than need be, a surrogate, beyond the last character, cut off.
  for (const std::string bad :
    { "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf0\x9f\x92" })
    EXPECT_EQ(label(bad), std::string(bad.size(), '?'));
}

} // namespace

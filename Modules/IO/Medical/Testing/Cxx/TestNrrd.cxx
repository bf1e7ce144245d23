#include "IOFixture.h"
#include "Zip.h"

#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>

namespace
{

class Nrrd : public IOFixture
{
protected:
  using Field = std::pair<std::string, std::string>;

  /// A header as 3D Slicer writes it, with one field replaced, or left out where the value is "".
  static std::string Header(const std::vector<Field>& changes = {})
  {
    std::string header = "NRRD0005\n# Complete NRRD file format specification at:\n";
    std::vector<Field> fields{ { "type", "short" }, { "dimension", "3" },
      { "space", "left-posterior-superior" }, { "sizes", "12 10 8" },
      { "space directions", "(0,0.5,0) (0,0,-0.75) (-1.25,0,0)" },
      { "kinds", "domain domain domain" }, { "endian", "little" }, { "encoding", "raw" },
      { "space origin", "(-3,4,5.5)" } };
    for (const auto& [name, value] : changes)
    {
      const std::string& key = name;
      const auto found = std::find_if(
        fields.begin(), fields.end(), [&](const Field& field) { return field.first == key; });
      if (found == fields.end())
        fields.emplace_back(name, value);
      else
        found->second = value;
    }
    for (const auto& [name, value] : fields)
      if (!value.empty())
        header += name + ": " + value + "\n";
    return header + "\n";
  }
  static hasp::GridGeometry Meant()
  {
    return { { 12, 10, 8 }, { -3, 4, 5.5 }, { 0.5, 0.75, 1.25 },
      glm::dmat3(0, 1, 0, 0, 0, -1, -1, 0, 0) };
  }
  static std::string Raw()
  {
    const auto samples = Samples(Meant());
    std::string bytes;
    AppendBytes(bytes, samples.data(), samples.size());
    return bytes;
  }
  std::filesystem::path Write(const std::string& bytes, const char* name = "a.nrrd") const
  {
    WriteBytes(this->Folder / name, bytes);
    return this->Folder / name;
  }
  void ExpectHeaderRefused(const std::vector<Field>& changes, const std::string& says) const
  {
    SCOPED_TRACE(changes.front().first + ": " + changes.front().second);
    this->ExpectRefused(this->Write(Header(changes) + Raw()), { "a.nrrd: ", says });
  }
  hasp::LoadedVolume ReadChanged(const std::vector<Field>& changes, const std::string& raw = Raw())
  {
    return Read(this->Write(Header(changes) + raw));
  }
};

TEST_F(Nrrd, BadHeadersAreRefused)
{
  this->ExpectHeaderRefused({ { "sizes", "12 10 9" } }, "cut off");
  this->ExpectHeaderRefused({ { "sizes", "12 10 7" } }, "more than the header");
  this->ExpectHeaderRefused({ { "sizes", "65535 65535 65535" } }, "memory limit");
  this->ExpectHeaderRefused({ { "sizes", "999999999 999999999 999999999" } }, "memory limit");
  this->ExpectHeaderRefused({ { "sizes", "2147483648 1 1" } }, "2147483647");
  this->ExpectHeaderRefused({ { "sizes", "1e15 1e15 1e15" } }, "2147483647");
  this->ExpectHeaderRefused({ { "sizes", "1e16 1 1" } }, "whole numbers");
  for (const char* sizes : { "12 10 0", "12 -10 8", "12 10.5 8" })
    this->ExpectHeaderRefused({ { "sizes", sizes } }, "whole numbers");
  for (const char* sizes : { "12 10", "12 10 8 1", "12 10 x", "12 10 nan", "" })
    this->ExpectHeaderRefused({ { "sizes", sizes } }, "sizes must be");
  for (const char* dimension : { "", "2", "5", "-3", "3.5", "three" })
    this->ExpectHeaderRefused({ { "dimension", dimension } }, "dimension");
  this->ExpectHeaderRefused({ { "type", "block" } }, "type is none");
  this->ExpectHeaderRefused({ { "type", "" } }, "type is none");
  for (const char* encoding : { "", "ascii", "hex", "bzip2" })
    this->ExpectHeaderRefused({ { "encoding", encoding } }, "encoding must be raw or gzip");
  this->ExpectHeaderRefused({ { "encoding", "gzip" } }, "damaged");
  for (const char* endian : { "", "middle" })
    this->ExpectHeaderRefused({ { "endian", endian } }, "endian must be");
  for (const char* space : { "right-anterior-inferior", "RASX", "left-posterior-superior-time" })
    this->ExpectHeaderRefused({ { "space", space } }, "space is none");
  this->ExpectHeaderRefused({ { "space", "3D-left-handed" } }, "left-handed");
  for (const char* vectors : { "(1,0,0) (0,1,0)", "(1,0) (0,1) (0,0)", "(1,0,0) (0,1,0) (0,0,nan)",
         "(1,0,0) (0,1,0) 0,0,1", "(1,0,0) (0,1,0) (0,0,1" })
    this->ExpectHeaderRefused({ { "space directions", vectors } }, "space directions");
  this->ExpectHeaderRefused({ { "space directions", "(1,0,0) (0,1,0) (0,0,0)" } }, "spacing");
  this->ExpectHeaderRefused(
    { { "space directions", "(1,0,0) (0,1,0) (0,0,1e300)" }, { "space origin", "(1e999,0,0)" } },
    "space origin");
  this->ExpectHeaderRefused( // a gantry tilt of atan(0.2)
    { { "space directions", "(1,0,0) (0,1,0) (0,0.2,1)" } }, "11.3099 degrees");
  this->ExpectHeaderRefused({ { "space directions", "" } }, "never guessed");
  for (const char* spacings : { "1 1", "1 1 nan", "1 1 0", "1 1 -1", "-1 -1 1" })
    this->ExpectHeaderRefused({ { "space directions", "" }, { "spacings", spacings } }, "spacing");
  this->ExpectHeaderRefused({ { "space origin", "(1,2,3) (1,2,3)" } }, "space origin");
  this->ExpectHeaderRefused({ { "space units", "\"m\" \"m\" \"m\"" } }, "space units");
  this->ExpectHeaderRefused({ { "kinds", "RGB-color domain domain" } }, "none of space");
  this->ExpectHeaderRefused({ { "kinds", "domain domain" } }, "kinds");
  this->ExpectHeaderRefused({ { "data file", "../../etc/passwd" } }, "beside it");
  this->ExpectHeaderRefused({ { "data file", "LIST" } }, "beside it");
  this->ExpectHeaderRefused({ { "data file", "slice%03d.raw 1 8 1" } }, "beside it");
  this->ExpectHeaderRefused({ { "data file", ".." } }, "is not there");
  this->ExpectHeaderRefused({ { "byte skip", "-2" } }, "byte skip");
  this->ExpectHeaderRefused({ { "line skip", "1000" } }, "fewer lines");
  this->ExpectHeaderRefused({ { "endian ", "little" } }, "twice");
  this->ExpectHeaderRefused(
    { { "dimension", "4" }, { "sizes", "3 4 10 8" }, { "kinds", "vector domain domain domain" },
      { "space directions", "none (1,0,0) (0,1,0) (0,0,1)" } },
    "components");
}

TEST_F(Nrrd, WhatIsNoNrrdIsRefused)
{
  for (const char* start : { "", "NRRD", "NRRD0006\n", "NRRD00010\n", "nrrd0001\n" })
    this->ExpectRefused(this->Write(start + Header().substr(9)), { "no NRRD file" });
  this->ExpectRefused(this->Write("NRRD0005\nno colon here\n\n"), { "no NRRD file" });
  this->ExpectRefused(this->Write("NRRD0005\ntype:short\n\n"), { "damaged" });
  this->ExpectRefused(this->Write("NRRD0005\n" + std::string(5 << 20, 'x')), { "no NRRD file" });
  this->ExpectRefused(this->Write(Header() + Raw() + "x"), { "more than the header" });
}

TEST_F(Nrrd, NothingOfTheHeaderIsRepeated)
{
  hasp::ShowFileNames(false);
  for (const char* name : { "type", "dimension", "space", "sizes", "space directions", "kinds",
         "endian", "encoding", "space origin", "data file", "byte skip", "line skip", "spacings" })
    try
    {
      this->ReadChanged({ { name, "Miller^Ann" } });
      EXPECT_STREQ(name, "spacings"); // not looked at where there are directions
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(std::string(error.what()).find("Miller"), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find("the .nrrd file: "), 0U) << error.what();
    }
  hasp::ShowFileNames(true);
}

TEST_F(Nrrd, EachWayOfStoringIsExact)
{
  ExpectSame(this->ReadChanged({}), Meant(), Samples(Meant()));
  EXPECT_EQ(this->ReadChanged({}).passport.format, "NRRD");
  std::string swapped = Raw();
  for (std::size_t n = 0; n < swapped.size(); n += 2)
    std::swap(swapped[n], swapped[n + 1]);
  ExpectSame(this->ReadChanged({ { "endian", "big" } }, swapped), Meant(), Samples(Meant()));
  ExpectSame(this->ReadChanged({ { "encoding", "gz" } }, Gzip(Raw())), Meant(), Samples(Meant()));
  const std::string half = Raw().substr(0, 1000), rest = Raw().substr(1000);
  ExpectSame(this->ReadChanged({ { "encoding", "gzip" } }, Gzip(half) + Gzip(rest)), Meant(),
    Samples(Meant())); // two members
  ExpectSame(
    this->ReadChanged({ { "encoding", "gzip" }, { "byteskip", "5" } }, Gzip("12345" + Raw())),
    Meant(), Samples(Meant()));
  ExpectSame(this->ReadChanged({ { "lineskip", "2" }, { "byte skip", "3" } }, "a\nbc\nxyz" + Raw()),
    Meant(), Samples(Meant()));
  ExpectSame(
    this->ReadChanged({ { "byte skip", "-1" } }, "anything" + Raw()), Meant(), Samples(Meant()));
  std::string carriageReturns;
  for (const char c : Header())
    carriageReturns += c == '\n' ? "\r\n" : std::string(1, c);
  ExpectSame(Read(this->Write(carriageReturns + Raw())), Meant(), Samples(Meant()));
}

TEST_F(Nrrd, DetachedSamplesLieBesideTheHeader)
{
  this->Write(Raw(), "r\xC3\xB6h data.raw");
  const std::string header = Header({ { "data file", "r\xC3\xB6h data.raw" } });
  ExpectSame(Read(this->Write(header, "a.nhdr")), Meant(), Samples(Meant()));
  ExpectSame( // no blank line is needed
    Read(this->Write(header.substr(0, header.size() - 1), "a.nhdr")), Meant(), Samples(Meant()));
  this->Write(Raw(), "b.raw"); // as programs before Teem 1.9 had to name it
  ExpectSame(
    Read(this->Write(Header({ { "data file", "./b.raw" } }), "b.nhdr")), Meant(), Samples(Meant()));
  this->ExpectRefused(this->Write(Header(), "b.nhdr"), { "no data file line" });
}

TEST_F(Nrrd, CompressedSamplesMustBeExactlyAsManyAsDeclared)
{
  const auto refused = [&](const std::string& bytes, const char* says) {
    this->ExpectRefused(this->Write(Header({ { "encoding", "gzip" } }) + bytes), { says });
  };
  refused(Gzip(Raw() + "x"), "more than the header");
  refused(Gzip(Raw().substr(2)), "fewer than the header");
  refused(Gzip(Raw()).substr(0, 600), "cut off");
  refused(Gzip(Raw()) + "trailing", "followed by");
  refused(Gzip(Raw()) + Gzip("x"), "more than the header");
  // Bombs: 4 MiB of zeros in 4 KiB, and a header that would have 2 GB unpacked from 64 bytes.
  refused(Gzip(std::string(1 << 22, '\0')), "more than the header");
  this->ExpectRefused(
    this->Write(Header({ { "encoding", "gzip" }, { "sizes", "1000 1000 1000" } }) +
                Gzip(std::string(1 << 16, '\0'))),
    { "cannot hold them" });
}

TEST_F(Nrrd, SpacesAreTurnedToLPS)
{
  const auto place = [&](const char* space) { return this->ReadChanged({ { "space", space } }); };
  const auto geometry = [&](const char* space) { return place(space).passport.geometry; };
  for (const char* name : { "left-posterior-superior", "LPS", "lps" })
    EXPECT_EQ(geometry(name).origin, glm::dvec3(-3, 4, 5.5));
  for (const char* name : { "right-anterior-superior", "RAS" })
  {
    EXPECT_EQ(geometry(name).origin, glm::dvec3(3, -4, 5.5));
    EXPECT_EQ(geometry(name).direction, glm::dmat3(0, -1, 0, 0, 0, -1, 1, 0, 0));
  }
  for (const char* name : { "left-anterior-superior", "LAS" })
  {
    EXPECT_EQ(geometry(name).origin, glm::dvec3(-3, -4, 5.5));
    EXPECT_EQ(geometry(name).direction, glm::dmat3(0, -1, 0, 0, 0, -1, -1, 0, 0));
  }
  for (const char* name : { "3D-right-handed", "scanner-xyz", "" })
  {
    EXPECT_EQ(geometry(name).origin, glm::dvec3(-3, 4, 5.5));
    ASSERT_EQ(place(name).passport.warnings.size(), 1U);
    EXPECT_NE(place(name).passport.warnings[0].find("Check left and right"), std::string::npos);
  }
}

TEST_F(Nrrd, SpacingsAloneAreTakenWithTwoWarnings)
{
  const auto volume = this->ReadChanged({ { "space", "" }, { "space directions", "" },
    { "space origin", "" }, { "spacings", "0.5 0.75 1.25" } });
  EXPECT_EQ(volume.passport.geometry.spacing, glm::dvec3(0.5, 0.75, 1.25));
  EXPECT_EQ(volume.passport.geometry.direction, glm::dmat3(1.0));
  EXPECT_EQ(volume.passport.warnings.size(), 2U);
}

TEST_F(Nrrd, AFourthAxisOfOneComponentIsLeftOut)
{
  ExpectSame(this->ReadChanged({ { "dimension", "4" }, { "sizes", "1 12 10 8" },
               { "kinds", "vector domain domain domain" },
               { "space directions", "none (0,0.5,0) (0,0,-0.75) (-1.25,0,0)" } }),
    Meant(), Samples(Meant()));
  ExpectSame(this->ReadChanged({ { "dimension", "4" }, { "sizes", "12 10 8 1" }, { "kinds", "" },
               { "space directions", "(0,0.5,0) (0,0,-0.75) ( -1.25, 0, 0 ) none" },
               { "measurement frame", "(1,0,0) (0,1,0) (0,0,1)" } }),
    Meant(), Samples(Meant()));
}

TEST_F(Nrrd, AllNamesOfTypesAreKnown)
{
  const auto type = [&](const char* name, std::size_t bytes) {
    return this->ReadChanged({ { "type", name } }, std::string(960 * bytes, '\0')).passport;
  };
  for (const char* name :
    { "short", "short int", "signed short", "signed short int", "int16", "int16_t" })
    EXPECT_EQ(type(name, 2).sampleType, "int16") << name;
  for (const char* name :
    { "ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t" })
    EXPECT_EQ(type(name, 2).sampleType, "uint16") << name;
  for (const char* name : { "uchar", "unsigned char", "uint8", "uint8_t" })
    EXPECT_EQ(type(name, 1).sampleType, "uint8") << name;
  EXPECT_EQ(type("float", 4).sampleType, "float32");
  for (const char* name : { "signed char", "int8", "int8_t" })
    EXPECT_EQ(type(name, 1).warnings.size(), 1U) << name;
  for (const char* name :
    { "int", "signed int", "int32", "int32_t", "uint", "unsigned int", "uint32", "uint32_t" })
    EXPECT_EQ(type(name, 4).warnings.size(), 1U) << name;
  for (const char* name : { "longlong", "long long", "long long int", "signed long long",
         "signed long long int", "int64", "int64_t", "ulonglong", "unsigned long long",
         "unsigned long long int", "uint64", "uint64_t", "double" })
    EXPECT_EQ(type(name, 8).warnings.size(), 1U) << name;
}

} // namespace

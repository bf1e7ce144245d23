#include "IOFixture.h"

#include "vtkHaspFileNames.h"

#include <archive.h>
#include <archive_entry.h>

#include <cstdio>
#include <limits>

namespace
{

class Invesalius : public IOFixture
{
protected:
  struct Entry
  {
    std::string name, bytes;
    std::string link = {}; ///< a symbolic link's target, if any
  };

  /// Writes the entries as a gzipped tar and gives its path.
  std::filesystem::path Pack(const std::vector<Entry>& entries) const
  {
    const auto file = this->Folder / "a.inv3";
    archive* to = archive_write_new();
    archive_write_add_filter_gzip(to);
    archive_write_set_format_gnutar(to);
    archive_write_open_filename(to, file.c_str());
    for (const Entry& entry : entries)
    {
      archive_entry* header = archive_entry_new();
      archive_entry_set_pathname(header, entry.name.c_str());
      archive_entry_set_filetype(header, entry.link.empty() ? AE_IFREG : AE_IFLNK);
      if (!entry.link.empty())
        archive_entry_set_symlink(header, entry.link.c_str());
      archive_entry_set_perm(header, 0644);
      archive_entry_set_size(header, static_cast<la_int64_t>(entry.bytes.size()));
      EXPECT_EQ(archive_write_header(to, header), ARCHIVE_OK);
      archive_write_data(to, entry.bytes.data(), entry.bytes.size());
      archive_entry_free(header);
    }
    archive_write_close(to);
    archive_write_free(to);
    return file;
  }
  static std::string List(const std::string& find = "", const std::string& replace = "")
  {
    std::string text = R"(<?xml version="1.0" encoding="UTF-8"?>
<plist version="1.0"><dict>
  <key>matrix</key><dict>
    <key>dtype</key><string>int16</string>
    <key>filename</key><string>matrix.dat</string>
    <key>shape</key><array><integer>8</integer><integer>10</integer><integer>12</integer></array>
  </dict>
  <key>modality</key><string>CT</string>
  <key>orientation</key><integer>1</integer>
  <key>spacing</key><array><real>0.5</real><real>0.75</real><real>1.25</real></array>
</dict></plist>)";
    if (!find.empty())
      text.replace(text.find(find), find.size(), replace);
    return text;
  }
  /// What such a project means: x runs left, y to ANTERIOR, z superior; after turning the rows, the
  /// first sample is the world's origin.
  static hasp::GridGeometry Meant()
  {
    return { { 12, 10, 8 }, { 0, 9 * 0.75, 0 }, { 0.5, 0.75, 1.25 },
      glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, 1) };
  }
  static std::string Raw()
  {
    const auto samples = Samples(Meant());
    std::string bytes;
    AppendBytes(bytes, samples.data(), samples.size());
    return bytes;
  }
  void ExpectListRefused(
    const std::string& find, const std::string& replace, const std::string& says) const
  {
    SCOPED_TRACE(replace);
    this->ExpectRefused(
      this->Pack({ { "t/main.plist", List(find, replace) }, { "t/matrix.dat", Raw() } }),
      { "a.inv3: ", says });
  }
};

TEST_F(Invesalius, UntrustworthyArchivesAreRefused)
{
  const Entry list{ "t/main.plist", List() }, data{ "t/matrix.dat", Raw() };
  this->ExpectRefused(this->Pack({ list, data, { "t/../../evil", "x" } }), { "\"..\"" });
  this->ExpectRefused(this->Pack({ list, data, { "/etc/evil", "x" } }), { "absolute" });
  this->ExpectRefused(this->Pack({ list, data, { "t/link", "", "/etc/passwd" } }), { "link" });
  this->ExpectRefused(this->Pack({ list, data, data }), { "two entries" });
  this->ExpectRefused(this->Pack({ list, data, { "u/other", "x" } }), { "top folder" });
  this->ExpectRefused(this->Pack({ { "t/notes", "x" } }), { "no main.plist" });
  this->ExpectRefused(this->Pack({ list }), { "lacks the file of samples" });
  this->ExpectRefused(
    this->Pack({ { "t/main.plist", std::string(2 << 20, ' ') }, data }), { "property list" });
  std::vector<Entry> many{ list, data };
  for (int n = 0; n < 5000; ++n)
    many.push_back({ "t/" + std::to_string(n), "" });
  this->ExpectRefused(this->Pack(many), { "4096" });
}

/// A tar entry by hand, so that it may declare what it does not hold.
std::string TarEntry(
  const std::string& name, std::uint64_t size, const std::string& bytes, char type = '0')
{
  std::string header(512, '\0');
  header.replace(0, name.size(), name);
  header.replace(100, 7, "0000644");
  char octal[13];
  std::snprintf(octal, sizeof(octal), "%011lo", static_cast<unsigned long>(size));
  header.replace(124, 11, octal);
  header.replace(148, 8, "        ");
  header[156] = type;
  header.replace(257, 8, std::string("ustar\00000", 8));
  unsigned sum = 0;
  for (const char c : header)
    sum += static_cast<unsigned char>(c);
  std::snprintf(octal, sizeof(octal), "%06o", sum);
  header.replace(148, 7, std::string(octal, 7));
  return header + bytes + std::string((512 - bytes.size() % 512) % 512, '\0');
}

TEST_F(Invesalius, SizeBombIsRefusedUnread)
{
  const auto file = this->Folder / "a.inv3";
  const std::string good =
    TarEntry("t/main.plist", List().size(), List()) + TarEntry("t/matrix.dat", Raw().size(), Raw());
  WriteBytes(file, good + std::string(1024, '\0'));
  ExpectSame(Read(file), Meant(), Samples(Meant()));
  hasp::VolumeReadSettings noLimit;
  // So large that what is allowed beside the samples must not be added to it.
  noLimit.memoryLimitBytes = std::numeric_limits<std::size_t>::max() - (std::size_t(512) << 20) + 1;
  ExpectSame(Read(file, noLimit), Meant(), Samples(Meant()));
  WriteBytes(file, good + TarEntry("t/bomb", std::uint64_t(6) << 30, ""));
  this->ExpectRefused(file, { "memory limit" });
  WriteBytes(file, TarEntry("t/bomb", std::uint64_t(6) << 30, "") + good);
  this->ExpectRefused(file, { "memory limit" });
}

/// As Python's tarfile writes a name that is not ASCII: a pax record in UTF-8 goes before.
std::string PaxEntry(const std::string& name, const std::string& bytes)
{
  const std::string record = " path=" + name + "\n";
  const std::string pax = std::to_string(record.size() + 2) + record;
  return TarEntry("././@PaxHeader", pax.size(), pax, 'x') + TarEntry("t/?", bytes.size(), bytes);
}

TEST_F(Invesalius, NamesOfTheWorldAreRead)
{
  for (const std::string folder : { "Cr\xC3\xA2nio", "\xD0\xA7\xD0\xB5\xD1\x80\xD0\xB5\xD0\xBF" })
  {
    const auto file = this->Folder / (folder + ".inv3");
    WriteBytes(file, PaxEntry(folder + "/main.plist", List()) +
                       PaxEntry(folder + "/matrix.dat", Raw()) + std::string(1024, '\0'));
    ExpectSame(Read(file), Meant(), Samples(Meant()));
  }
}

TEST_F(Invesalius, CutOffAndForeignFilesAreRefused)
{
  const auto file = this->Pack({ { "t/main.plist", List() }, { "t/matrix.dat", Raw() } });
  const auto size = std::filesystem::file_size(file);
  for (const double share : { 0.9, 0.5, 0.01 })
  {
    std::filesystem::resize_file(file, static_cast<std::uintmax_t>(share * double(size)));
    this->ExpectRefused(file, { "a.inv3: " });
  }
  WriteBytes(file, "this is no archive");
  this->ExpectRefused(file, { "a.inv3: " });
  WriteBytes(file, "");
  this->ExpectRefused(file, { "a.inv3: " });
}

TEST_F(Invesalius, ReadErrorsDoNotNameTheFile)
{
  hasp::ShowFileNames(false);
  const auto file = this->Folder / "Miller^Ann.inv3";
  std::filesystem::create_symlink("/proc/self/mem", file); // a regular file whose start is an error
  try
  {
    Read(file);
    ADD_FAILURE() << "was read";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()).find("Miller"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find("the .inv3 file: "), 0U) << error.what();
  }
}

TEST_F(Invesalius, BadPropertyListsAreRefused)
{
  this->ExpectListRefused("</plist>", "", "no property list");
  this->ExpectListRefused("<key>matrix</key>", "<key>m</key>", "no property list");
  this->ExpectListRefused("int16", "float64", "only int16");
  this->ExpectListRefused("<integer>1</integer>", "<integer>3</integer>", "axial");
  this->ExpectListRefused("<integer>8</integer>", "<integer>9</integer>", "bytes");
  this->ExpectListRefused("<integer>8</integer>", "<integer>0</integer>", "shape");
  this->ExpectListRefused("<integer>8</integer>", "<integer>99999</integer>", "bytes");
  this->ExpectListRefused("<integer>8</integer>", "<integer>1e30</integer>", "shape");
  this->ExpectListRefused("<integer>8</integer>", "<integer>8.5</integer>", "whole");
  this->ExpectListRefused("<integer>8</integer>", "", "three numbers");
  this->ExpectListRefused("<real>0.5</real>", "<real>0</real>", "spacing");
  this->ExpectListRefused("<real>0.5</real>", "<real>nan</real>", "no number");
  this->ExpectListRefused("matrix.dat", "../matrix.dat", "lacks the file of samples");
  // As deep as a megabyte goes: what walks it in a function that calls itself has no stack left.
  std::string deep;
  for (int n = 0; n < 140000; ++n)
    deep += "<a>";
  for (int n = 0; n < 140000; ++n)
    deep += "</a>";
  this->ExpectListRefused("<key>modality</key>", deep + "<key>modality</key>", "no property list");
}

TEST_F(Invesalius, ProjectIsExactAndRightHandedInLPS)
{
  const auto volume = Read(this->Pack(
    { { "t/mask_0.dat", "before" }, { "t/main.plist", List() }, { "t/matrix.dat", Raw() } }));
  ExpectSame(volume, Meant(), Samples(Meant()));
  EXPECT_EQ(volume.passport.geometry.origin, glm::dvec3(0.0));
  EXPECT_EQ(volume.passport.geometry.direction, glm::dmat3(1.0));
  EXPECT_EQ(volume.passport.format, "InVesalius");
  EXPECT_TRUE(volume.passport.hounsfield);
  EXPECT_EQ(volume.passport.minimum, -400);
}

} // namespace

#include "Cells/CellFile.h"
#include "IOFixture.h"
#include "Isosurface/Testing/CellFixture.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspClusteredCellReader.h"
#include "vtkHaspClusteredCellWriter.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspFileNames.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtk_zlib.h"

#include <csignal>
#include <sys/resource.h>

#include <cstring>

namespace
{

using hasp::CellFileHead;
using hasp::CellPrecision;
using hasp::ClusteredCells;
using hasp::testing::CellsOf;
using hasp::testing::Noise;
using hasp::testing::SameCells;

const hasp::GridGeometry Geometry{ { 30, 21, 17 }, { -5, 6, 7 }, { 0.5, 0.7, 1.3 },
  glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1) };

template <typename T>
ClusteredCells Cells(CellPrecision precision = CellPrecision::Exact)
{
  const auto samples = Noise<T>(Geometry);
  return CellsOf(hasp::GridView<const T>{ samples.data(), Geometry }, 100.5, precision);
}

class CellFile : public IOFixture
{
protected:
  std::string Path(const std::string& name = "a.hcells") const
  {
    return (this->Folder / name).string();
  }
  std::size_t FilesThere() const
  {
    return std::distance(std::filesystem::directory_iterator(this->Folder), {});
  }
  static std::uint32_t Crc(std::string_view bytes)
  {
    return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
  }
  /// As if a hand that knows the format had written them.
  static std::string Sealed(std::string bytes)
  {
    CellFileHead head;
    std::memcpy(&head, bytes.data(), sizeof head);
    head.bodyChecksum = Crc(std::string_view(bytes).substr(sizeof head));
    std::memcpy(bytes.data(), &head, sizeof head);
    head.headChecksum =
      Crc(std::string_view(bytes).substr(0, offsetof(CellFileHead, headChecksum)));
    std::memcpy(bytes.data(), &head, sizeof head);
    return bytes;
  }
  /// Sealed bytes whose head was changed.
  template <typename F>
  std::string WithHead(const F& change) const
  {
    std::string bytes = ReadBytes(this->Path());
    CellFileHead head;
    std::memcpy(&head, bytes.data(), sizeof head);
    change(head);
    std::memcpy(bytes.data(), &head, sizeof head);
    return Sealed(bytes);
  }
  std::string Refusal(const std::string& bytes, const hasp::CellReadSettings& settings = {}) const
  {
    WriteBytes(this->Path("b.hcells"), bytes);
    try
    {
      hasp::LoadCells(this->Path("b.hcells"), settings);
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(std::string(error.what()).find(this->Folder.string()), std::string::npos);
      return error.what();
    }
    return {};
  }
  void ExpectRefusal(const std::string& bytes, const std::string& says,
    const hasp::CellReadSettings& settings = {}) const
  {
    const std::string text = this->Refusal(bytes, settings);
    EXPECT_NE(text.find(says), std::string::npos) << "no \"" << says << "\" in: " << text;
  }
};

TEST_F(CellFile, IsReadBackByteForByte)
{
  ClusteredCells colored = Cells<std::int16_t>();
  colored.labels.assign(colored.count, 9);
  for (const hasp::CellCluster& cluster : colored.clusters)
  {
    colored.firstColors.push_back(static_cast<std::uint32_t>(colored.colors.size()));
    colored.colors.resize(colored.colors.size() + cluster.CornerCount(), 0xFF204060U);
  }
  const std::vector<std::uint8_t> flat(Geometry.Size(), 1);
  const ClusteredCells none =
    CellsOf(hasp::GridView<const std::uint8_t>{ flat.data(), Geometry }, 5.0);
  for (const ClusteredCells& cells : { Cells<std::int16_t>(), Cells<std::uint16_t>(),
         Cells<std::uint8_t>(), Cells<float>(), Cells<std::int16_t>(CellPrecision::Compact),
         Cells<float>(CellPrecision::Compact), colored, none })
  {
    hasp::WriteCells(cells, this->Path());
    EXPECT_EQ(std::filesystem::file_size(this->Path()), sizeof(CellFileHead) + cells.Bytes());
    EXPECT_TRUE(SameCells(*hasp::LoadCells(this->Path()), cells));
    const std::string bytes = ReadBytes(this->Path());
    hasp::WriteCells(*hasp::LoadCells(this->Path()), this->Path());
    EXPECT_EQ(ReadBytes(this->Path()), bytes);
  }
}

TEST_F(CellFile, IsTheBytesThatItsPageSays)
{
  hasp::WriteCells(Cells<std::int16_t>(), this->Path());
  const std::string bytes = ReadBytes(this->Path());
  const auto word = [&](std::size_t at)
  {
    std::uint32_t value = 0;
    for (int n = 3; n >= 0; --n)
      value = value << 8 | static_cast<unsigned char>(bytes[at + n]);
    return value;
  };
  EXPECT_EQ(bytes.substr(0, 8), "\x89"
                                "HCELL\r\n");
  EXPECT_EQ(word(8), 1U);
  EXPECT_EQ(word(12), 224U);
  EXPECT_EQ(word(16), 30U);
  EXPECT_EQ(word(220), Crc(std::string_view(bytes).substr(0, 220)));
  EXPECT_EQ(word(216), Crc(std::string_view(bytes).substr(224)));
}

TEST_F(CellFile, CutOffOrLengthenedAnywhereIsRefused)
{
  hasp::WriteCells(Cells<std::int16_t>(), this->Path());
  const std::string bytes = ReadBytes(this->Path());
  this->ExpectRefusal("", "does not begin");
  for (std::size_t size = 1; size < bytes.size(); size += size < 300 ? 1 : 4999)
    EXPECT_NE(this->Refusal(bytes.substr(0, size)), "") << size;
  this->ExpectRefusal(bytes.substr(0, 100), "224 bytes from byte 0");
  this->ExpectRefusal(bytes.substr(0, bytes.size() - 1), "declares more cells");
  this->ExpectRefusal(bytes + 'x', "1 bytes more than it declares");
}

TEST_F(CellFile, EachTurnedBitIsRefused)
{
  hasp::WriteCells(Cells<std::uint8_t>(CellPrecision::Compact), this->Path());
  std::string bytes = ReadBytes(this->Path());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += bit < 8 * 300 ? 1 : 5003)
  {
    bytes[bit / 8] ^= static_cast<char>(1 << bit % 8);
    const std::string text = this->Refusal(bytes);
    EXPECT_NE(text, "") << bit;
    if (bit >= 8 * sizeof(CellFileHead))
    {
      EXPECT_NE(text.find("its cells are damaged"), std::string::npos) << text;
    }
    bytes[bit / 8] ^= static_cast<char>(1 << bit % 8);
  }
  EXPECT_EQ(this->Refusal(bytes), "");
}

TEST_F(CellFile, LiesWithGoodChecksumsAreRefused)
{
  hasp::WriteCells(Cells<float>(), this->Path());
  EXPECT_EQ(this->Refusal(this->WithHead([](CellFileHead&) {})), "");
  const auto expect = [&](const auto& lie, const char* says)
  { this->ExpectRefusal(this->WithHead(lie), says); };
  expect([](CellFileHead& h) { h.version = 2; }, "version 2");
  expect([](CellFileHead& h) { h.bytes = 0xFFFFFFFF; }, "head is damaged");
  expect([](CellFileHead& h) { h.clusters = ~std::uint64_t(0) / 96; }, "declares more");
  expect([](CellFileHead& h) { h.corners = ~std::uint64_t(0); }, "declares more");
  expect([](CellFileHead& h) { h.firstColors = std::uint64_t(1) << 62; }, "declares more");
  expect([](CellFileHead& h) { --h.clusters; }, "bytes more than it declares");
  expect([](CellFileHead& h) { h.cells = 1; }, "active cells");
  expect([](CellFileHead& h) { h.cells = ~std::uint64_t(0); }, "32 bits");
  expect([](CellFileHead& h) { h.dims[2] = 0; }, "dims[2] is 0");
  expect([](CellFileHead& h) { h.dims[0] = -5; }, "dims[0] is -5");
  expect([](CellFileHead& h) { h.dims[0] = 9; }, "outside the grid");
  expect([](CellFileHead& h) { h.spacing[1] = 0.0; }, "spacing[1]");
  expect([](CellFileHead& h) { h.direction[0] = 0.5; }, "orthonormal");
  expect([](CellFileHead& h) { h.isovalue = -100; }, "one side");
  expect([](CellFileHead& h) { h.cornerType = 7; }, "sample type");
  expect([](CellFileHead& h) { h.precision = 7; }, "precision");
  expect([](CellFileHead& h) { h.precision = 1; }, "levels");
  expect([](CellFileHead& h) { std::swap(h.levels, h.corners); }, "");
  std::string bytes = ReadBytes(this->Path());
  bytes[sizeof(CellFileHead) + 96 + 3] ^= 1; // a cell of the second cluster
  this->ExpectRefusal(Sealed(bytes), "no sound active cells: cluster");
}

TEST_F(CellFile, TheMemoryLimitIsAskedFirst)
{
  const ClusteredCells cells = Cells<std::int16_t>();
  hasp::WriteCells(cells, this->Path());
  EXPECT_NO_THROW(hasp::LoadCells(this->Path(), { cells.Bytes() }));
  this->ExpectRefusal(ReadBytes(this->Path()), "the limit is", { cells.Bytes() - 1 });
}

TEST_F(CellFile, UnsoundCellsAndOtherNamesAreNotWritten)
{
  ClusteredCells cells = Cells<std::int16_t>();
  EXPECT_THROW(hasp::WriteCells(cells, this->Path("a.mha")), std::runtime_error);
  EXPECT_THROW(hasp::WriteCells(cells, this->Path("absent/a.hcells")), std::runtime_error);
  cells.clusters[3].firstCell = 1;
  EXPECT_THROW(hasp::WriteCells(cells, this->Path()), std::invalid_argument);
  EXPECT_THROW(hasp::WriteCells({}, this->Path()), std::invalid_argument);
  EXPECT_EQ(this->FilesThere(), 0U);
}

TEST_F(CellFile, FullDiskAndCancelLeaveTheOldFileAndNothingElse)
{
  const ClusteredCells cells = Cells<std::int16_t>();
  WriteBytes(this->Path(), "the old file");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit now{ 1000, before.rlim_max };
  const auto handler = std::signal(SIGXFSZ, SIG_IGN); // writes fail as on a full disk
  setrlimit(RLIMIT_FSIZE, &now);
  EXPECT_THROW(hasp::WriteCells(cells, this->Path()), std::runtime_error);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  for (const double until : { 0.0, 0.3, 0.5, 0.6 })
    EXPECT_THROW(hasp::WriteCells(cells, this->Path(), [&](double share) { return share < until; }),
      hasp::Cancelled);
  EXPECT_EQ(ReadBytes(this->Path()), "the old file");
  EXPECT_EQ(this->FilesThere(), 1U);
  hasp::WriteCells(cells, this->Path());
  for (const double until : { 0.0, 0.5 })
    EXPECT_THROW(hasp::LoadCells(this->Path(), {}, [&](double share) { return share < until; }),
      hasp::Cancelled);
}

TEST_F(CellFile, ErrorsCallItByItsEndingAlone)
{
  hasp::ShowFileNames(false);
  this->ExpectRefusal("x", "the .hcells file: ");
}

/// Errors of an algorithm, kept in place of printed.
void Silence(vtkObject* object, std::string& text)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&text);
  command->SetCallback([](vtkObject*, unsigned long, void* to, void* words)
    { *static_cast<std::string*>(to) += static_cast<const char*>(words); });
  object->AddObserver(vtkCommand::ErrorEvent, command);
}

TEST_F(CellFile, GoesThroughVtksPipeline)
{
  vtkNew<vtkHaspClusteredCells> cells;
  cells->SetCells(std::make_shared<ClusteredCells>(Cells<std::uint16_t>()));
  vtkNew<vtkHaspClusteredCellWriter> writer;
  writer->SetInputDataObject(cells);
  writer->SetFileName(this->Path().c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkHaspClusteredCellReader> reader;
  reader->SetFileName(this->Path().c_str());
  reader->Update();
  EXPECT_TRUE(SameCells(*reader->GetOutput()->GetCells(), *cells->GetCells()));
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(this->Path("b.hcells").c_str());
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_EQ(ReadBytes(this->Path("b.hcells")), ReadBytes(this->Path()));

  std::string said;
  Silence(reader, said);
  Silence(reader->GetExecutive(), said);
  Silence(writer, said);
  Silence(writer->GetExecutive(), said);
  reader->SetMemoryLimit(1000);
  reader->Update();
  EXPECT_NE(said.find("the limit is 1000"), std::string::npos) << said;
  EXPECT_NE(reader->GetErrorCode(), 0UL);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(writer->GetErrorCode(), 0UL);
}

} // namespace

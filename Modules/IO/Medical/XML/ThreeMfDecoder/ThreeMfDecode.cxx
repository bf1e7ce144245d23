// hasp-3mf-decode: reads 3MF files for Hasp in a process of its own, so that a bad file can harm
// nothing. See XMLWire.h for what goes in and out. It limits its own memory and time before it
// opens the file, and opens no other file.
#include "Sandbox/Confinement.h"
#include "ThreeMfModel.h"
#include "XMLOutput.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>

/// In libuuid's place, which asks the system for what the sandbox forbids: lib3mf names what has no
/// identifier in the file, and nobody reads that here. All are different.
extern "C" void uuid_generate_random(unsigned char* out)
{
  static std::uint64_t count = 0;
  std::memset(out, 0, 16);
  ++count;
  std::memcpy(out, &count, sizeof count);
}

using hasp::Check3mf;
using hasp::Lib3mfObject;
using namespace NMR;

namespace
{

std::vector<char> AllBytes(BeatingFile& file)
{
  std::vector<char> bytes;
  constexpr std::size_t piece = 1 << 20;
  for (std::streamsize got = piece; got == piece;)
  {
    const std::size_t done = bytes.size();
    bytes.resize(done + piece);
    got = file.sgetn(bytes.data() + done, piece);
    bytes.resize(done + (got > 0 ? std::size_t(got) : 0));
  }
  return bytes;
}

/// lib3mf calls it as it works.
bool Beat(int, ProgressIdentifier, void* last)
{
  auto& then = *static_cast<std::chrono::steady_clock::time_point*>(last);
  const auto now = std::chrono::steady_clock::now();
  if (now - then > std::chrono::milliseconds(100))
  {
    then = now;
    WriteFrame(hasp::XMLFrame::Busy, 0.5);
  }
  return true;
}

void TakeDescription(hasp::Lib3mfHandle model, hasp::ThreeMfRecord& record)
{
  DWORD count = 0;
  Check3mf(lib3mf_model_getmetadatacount(model, &count));
  for (DWORD n = 0; n < count; ++n)
  {
    ULONG length = 0;
    char key[32] = {};
    if (lib3mf_model_getmetadatakeyutf8(model, n, key, sizeof key, &length) != LIB3MF_OK ||
        std::strcmp(key, "Description") != 0)
      continue; // one that is longer than that is none of ours
    if (lib3mf_model_getmetadatavalueutf8(
          model, n, record.description, sizeof record.description, &length) != LIB3MF_OK)
      std::memset(record.description, 0, sizeof record.description);
    record.description[sizeof record.description - 1] = '\0';
  }
}

double Determinant(const Transform& t)
{
  return t[0][0] * (t[1][1] * t[2][2] - t[1][2] * t[2][1]) -
         t[0][1] * (t[1][0] * t[2][2] - t[1][2] * t[2][0]) +
         t[0][2] * (t[1][0] * t[2][1] - t[1][1] * t[2][0]);
}

void WriteMesh(hasp::Lib3mfHandle model, const BuiltMesh& built)
{
  Lib3mfObject mesh;
  Check3mf(lib3mf_model_getmeshobjectbyid(model, built.mesh, mesh.Out()));
  Write(&built.record, sizeof(built.record));
  for (DWORD n = 0; n < built.record.points; ++n)
  {
    MODELMESHVERTEX vertex{};
    Check3mf(lib3mf_meshobject_getvertex(mesh, n, &vertex));
    const float* p = vertex.m_fPosition;
    double placed[3];
    for (int r = 0; r < 3; ++r)
      placed[r] = built.place[r][0] * p[0] + built.place[r][1] * p[1] + built.place[r][2] * p[2] +
                  built.place[r][3];
    Write(placed, sizeof placed);
  }
  const bool mirrored = Determinant(built.place) < 0.0; // the outside must stay outside
  for (DWORD n = 0; n < built.record.triangles; ++n)
  {
    MODELMESHTRIANGLE triangle{};
    Check3mf(lib3mf_meshobject_gettriangle(mesh, n, &triangle));
    const std::uint32_t corners[3] = { triangle.m_nIndices[0],
      triangle.m_nIndices[mirrored ? 2 : 1], triangle.m_nIndices[mirrored ? 1 : 2] };
    Write(corners, sizeof corners);
  }
}

void Decode(BeatingFile& file)
{
  std::vector<char> bytes = AllBytes(file);
  Lib3mfObject model, reader;
  hasp::ThreeMfRecord record{};
  std::vector<BuiltMesh> meshes;
  hasp::XMLStatus status = hasp::XMLStatus::Good;
  auto last = std::chrono::steady_clock::now();
  try
  {
    Check3mf(lib3mf_createmodel(model.Out()));
    Check3mf(lib3mf_model_queryreader(model, "3mf", reader.Out()));
    Check3mf(lib3mf_reader_setprogresscallback(
      reader, reinterpret_cast<Lib3MFProgressCallback>(Beat), &last));
    Check3mf(
      lib3mf_reader_readfrombuffer(reader, reinterpret_cast<BYTE*>(bytes.data()), bytes.size()));
    DWORD unit = 0;
    Check3mf(lib3mf_model_getunit(model, &unit));
    record.unit = unit;
    TakeDescription(model, record);
    meshes = BuiltMeshes(model);
  }
  catch (const TooManyObjects&)
  {
    status = hasp::XMLStatus::TooMany;
  }
  catch (const std::runtime_error&)
  {
    status = hasp::XMLStatus::Damaged;
  }
  if (status != hasp::XMLStatus::Good)
    record = {}, meshes.clear();
  record.status = static_cast<std::uint32_t>(status);
  record.objects = static_cast<std::uint32_t>(meshes.size());
  for (const BuiltMesh& built : meshes)
  {
    record.points += built.record.points;
    record.triangles += built.record.triangles;
  }
  WriteFrame(hasp::XMLFrame::Answer, 1.0);
  Write(&record, sizeof(record));
  for (const BuiltMesh& built : meshes)
    WriteMesh(model, built);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 4 || std::strcmp(argv[1], "surface") != 0)
  {
    std::fputs("usage: hasp-3mf-decode surface MEMORY_BYTES SECONDS < path, NUL-ended\n"
               "Hasp starts this program itself to read .3mf files.\n",
      stderr);
    return 2;
  }
  if (hasp::EnterSandbox(std::strtoull(argv[2], nullptr, 10),
        std::strtoull(argv[3], nullptr, 10)) == hasp::Confinement::None)
    return 4;
  try
  {
    std::string path;
    std::getline(std::cin, path, '\0');
    BeatingFile file(path);
    Decode(file);
    std::fflush(stdout);
    std::_Exit(0); // nothing is left to do; lib3mf's clean-up would walk what the file made
  }
  catch (const std::bad_alloc&)
  {
    return 3;
  }
  catch (const std::exception&)
  {
    return 6;
  }
}

#include "SurfaceFixture.h"

#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeView.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <charconv>

namespace
{

std::string Decimal(double number)
{
  char text[32];
  return { text, std::to_chars(text, text + sizeof(text), number).ptr };
}

std::string Three(const glm::dvec3& v)
{
  return Decimal(v.x) + " " + Decimal(v.y) + " " + Decimal(v.z);
}

template <typename T>
void Append(std::string& to, T value, bool bigEndian = false)
{
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof(T));
  if (bigEndian)
    std::reverse(bytes.begin(), bytes.end());
  to += bytes;
}

std::string StlText(const hasp::TriangleMesh& mesh, const std::string& space)
{
  std::string text = "solid head " + space + "\n";
  for (const glm::uvec3& t : mesh.triangles)
  {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (int c = 0; c < 3; ++c)
      text += "   vertex " + Three(mesh.points[t[c]]) + "\n";
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid head\n";
}

std::string StlBinary(const hasp::TriangleMesh& mesh, const std::string& space)
{
  std::string bytes = "solid as many programs begin " + space; // binary all the same
  bytes.resize(80, ' ');
  Append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const glm::uvec3& t : mesh.triangles)
  {
    bytes.append(12, '\0');
    for (int c = 0; c < 3; ++c)
      for (int a = 0; a < 3; ++a)
        Append(bytes, static_cast<float>(mesh.points[t[c]][a]));
    bytes.append(2, '\0');
  }
  return bytes;
}

/// With a colour at each point, flags at each face, and elements that are not asked for.
std::string Ply(const hasp::TriangleMesh& mesh, const std::string& space, const char* format)
{
  const bool text = format == std::string("ascii"), big = !text && format[7] == 'b';
  std::string bytes = std::string("ply\nformat ") + format + " 1.0\ncomment " + space +
                      "\nelement camera 1\nproperty double focus\nproperty list uint short knobs\n"
                      "element vertex " +
                      std::to_string(mesh.points.size()) +
                      "\nproperty float x\nproperty float y\nproperty uchar red\nproperty float z\n"
                      "element face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty short flags\nproperty list uchar int vertex_indices\n"
                      "property list ushort float texcoord\nelement nothing 5\nend_header\n";
  if (text)
    bytes += "2.5 3 7 -8 9\n";
  else
  {
    Append(bytes, 2.5, big);
    Append(bytes, std::uint32_t(3), big);
    for (const short knob : { 7, -8, 9 })
      Append(bytes, knob, big);
  }
  for (const glm::dvec3& p : mesh.points)
    if (text)
      bytes += Decimal(p.x) + " " + Decimal(p.y) + " 255 " + Decimal(p.z) + "\n";
    else
    {
      Append(bytes, static_cast<float>(p.x), big);
      Append(bytes, static_cast<float>(p.y), big);
      bytes += '\xFF';
      Append(bytes, static_cast<float>(p.z), big);
    }
  for (const glm::uvec3& t : mesh.triangles)
    if (text)
      bytes += "-1 3 " + std::to_string(t.x) + " " + std::to_string(t.y) + " " +
               std::to_string(t.z) + " 2 0.5 -1\n";
    else
    {
      Append(bytes, short(-1), big);
      bytes += '\3';
      for (int c = 0; c < 3; ++c)
        Append(bytes, static_cast<std::int32_t>(t[c]), big);
      Append(bytes, std::uint16_t(2), big);
      Append(bytes, 0.5F, big);
      Append(bytes, -1.0F, big);
    }
  return bytes;
}

std::string Obj(const hasp::TriangleMesh& mesh, const std::string& space)
{
  std::string text = "# " + space + "\nmtllib none.mtl\no head\nvt 0 0\nvn 0 0 1\n";
  for (const glm::dvec3& p : mesh.points)
    text += "v " + Three(p) + "\n";
  text += "usemtl bone\ns off\n";
  for (const glm::uvec3& t : mesh.triangles)
    text += "f " + std::to_string(t.x + 1) + "/1/1 " + std::to_string(t.y + 1) + "//1 " +
            std::to_string(t.z + 1) + "/1\n";
  return text;
}

std::string Vtp(const hasp::TriangleMesh& mesh, const std::string& space)
{
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(hasp::MakePolyData(mesh));
  if (!space.empty())
  {
    vtkNew<vtkStringArray> said;
    said->SetName("SPACE");
    said->InsertNextValue(space.substr(space.find('=') + 1));
    surface->GetFieldData()->AddArray(said);
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->WriteToOutputStringOn();
  writer->SetCompressorTypeToNone();
  writer->SetDataModeToAscii();
  writer->Write();
  return writer->GetOutputString();
}

} // namespace

hasp::TriangleMesh SurfaceFixture::Truth()
{
  return { { { 5, -7, 11.5 }, { 15, -7, 11.5 }, { 5, 13, 11.5 }, { 5, -7, 41.625 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } };
}

std::string SurfaceFixture::Bytes(
  Form form, const hasp::TriangleMesh& mesh, const std::string& space)
{
  switch (form)
  {
    case Form::StlText:
      return StlText(mesh, space);
    case Form::StlBinary:
      return StlBinary(mesh, space);
    case Form::PlyText:
      return Ply(mesh, space, "ascii");
    case Form::PlyLittle:
      return Ply(mesh, space, "binary_little_endian");
    case Form::PlyBig:
      return Ply(mesh, space, "binary_big_endian");
    case Form::Obj:
      return Obj(mesh, space);
    default:
      return Vtp(mesh, space);
  }
}

std::string SurfaceFixture::Name(Form form)
{
  return form == Form::Obj                                  ? "Mustermann.obj"
         : form == Form::Vtp                                ? "Mustermann.vtp"
         : form == Form::StlText || form == Form::StlBinary ? "Mustermann.stl"
                                                            : "Mustermann.ply";
}

hasp::LoadedSurface SurfaceFixture::Read(
  Form form, const std::string& bytes, const hasp::SurfaceReadSettings& settings) const
{
  const auto file = this->Folder / Name(form);
  std::filesystem::remove(file); // ext4 flushes a file that is written over: milliseconds each
  WriteBytes(file, bytes);
  return hasp::LoadSurface(file.string(), settings);
}

void SurfaceFixture::ExpectRefused(Form form, const std::string& bytes,
  const std::vector<std::string>& says, const hasp::SurfaceReadSettings& settings) const
{
  hasp::ShowFileNames(false);
  try
  {
    this->Read(form, bytes, settings);
    ADD_FAILURE() << "was read: " << bytes.substr(0, 2000);
  }
  catch (const std::runtime_error& error)
  {
    const std::string text = error.what();
    for (const std::string& piece : says)
      EXPECT_NE(text.find(piece), text.npos) << "no \"" << piece << "\" in: " << text;
    EXPECT_EQ(text.find("Mustermann"), text.npos) << text;
    EXPECT_EQ(text.find(this->Folder.string()), text.npos) << text;
  }
}

void SurfaceFixture::ExpectSame(const hasp::LoadedSurface& loaded, const hasp::TriangleMesh& truth)
{
  const hasp::TriangleMesh mesh = hasp::MakeTriangleMesh(loaded.surface);
  ASSERT_EQ(mesh.triangles.size(), truth.triangles.size());
  EXPECT_EQ(loaded.passport.triangles, truth.triangles.size());
  EXPECT_EQ(loaded.passport.points, mesh.points.size());
  for (std::size_t t = 0; t < truth.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(mesh.points[mesh.triangles[t][c]], truth.points[truth.triangles[t][c]])
        << "triangle " << t << " corner " << c;
}

std::string SurfaceFixture::Replaced(
  std::string text, const std::string& find, const std::string& replacement)
{
  const std::size_t at = text.find(find);
  EXPECT_NE(at, text.npos) << find;
  return at == text.npos ? text : text.replace(at, find.size(), replacement);
}

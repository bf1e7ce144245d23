#include "Surfaces/Lib3mf.h"
#include "Surfaces/PartText.h"
#include "Surfaces/SurfaceOutput.h"

#include <cstdint>
#include <cstdio>
#include <limits>
#include <string_view>

namespace hasp
{
namespace
{

/// FNV-1a, 64 bits.
class Digest
{
public:
  explicit Digest(std::uint64_t seed) : Value(seed) {}
  void Add(const void* bytes, std::size_t size)
  {
    for (std::size_t n = 0; n < size; ++n)
      this->Value = (this->Value ^ static_cast<const unsigned char*>(bytes)[n]) * 0x100000001b3ULL;
  }
  std::uint64_t value() const { return this->Value; }

private:
  std::uint64_t Value;
};

/// The identifiers that 3MF wants, which lib3mf would make at random: of what is written, so that
/// the same parts give the same bytes. Version 8 of RFC 9562: the maker's own.
class Identifiers
{
public:
  explicit Identifiers(const std::vector<NamedMesh>& meshes, const PartLabel& label)
  {
    for (Digest* digest : { &this->High, &this->Low })
    {
      const std::string text = PartText(label);
      digest->Add(text.data(), text.size());
      for (const NamedMesh& named : meshes)
      {
        digest->Add(named.mesh.points.data(), named.mesh.points.size() * sizeof(glm::dvec3));
        digest->Add(named.mesh.triangles.data(), named.mesh.triangles.size() * sizeof(glm::uvec3));
      }
    }
  }
  std::string Next()
  {
    ++this->Count;
    this->High.Add(&this->Count, sizeof(this->Count));
    this->Low.Add(&this->Count, sizeof(this->Count));
    const std::uint64_t high = this->High.value(), low = this->Low.value();
    char text[40];
    std::snprintf(text, sizeof text, "%08x-%04x-8%03x-%04x-%012llx", unsigned(high >> 32),
      unsigned(high >> 16 & 0xFFFF), unsigned(high & 0xFFF),
      unsigned(0x8000 | (low >> 48 & 0x3FFF)),
      static_cast<unsigned long long>(low & 0xFFFFFFFFFFFFULL));
    return text;
  }

private:
  Digest High{ 0xcbf29ce484222325ULL }, Low{ 0x9ae16a3b2f90404fULL };
  std::uint32_t Count = 0;
};

void AddMesh(Lib3mfHandle model, const NamedMesh& named, Identifiers& identifiers)
{
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (named.mesh.points.size() > most || named.mesh.triangles.size() > most)
    throw std::invalid_argument("surface: .3mf holds 2147483647 points and triangles; split it");
  std::vector<NMR::MODELMESHVERTEX> points;
  points.reserve(named.mesh.points.size());
  for (const glm::dvec3& p : named.mesh.points)
    points.push_back({ { float(p.x), float(p.y), float(p.z) } });
  std::vector<NMR::MODELMESHTRIANGLE> triangles;
  triangles.reserve(named.mesh.triangles.size());
  for (const glm::uvec3& t : named.mesh.triangles)
  {
    if (t.x == t.y || t.y == t.z || t.z == t.x)
      throw std::invalid_argument(
        "surface: a triangle names a point twice; .3mf is for closed surfaces of sound triangles");
    triangles.push_back({ { t.x, t.y, t.z } });
  }
  Lib3mfObject object, item;
  Check3mf(NMR::lib3mf_model_addmeshobject(model, object.Out()));
  Check3mf(NMR::lib3mf_meshobject_setgeometry(
    object, points.data(), DWORD(points.size()), triangles.data(), DWORD(triangles.size())));
  BOOL sound = 0;
  Check3mf(NMR::lib3mf_meshobject_ismanifoldandoriented(object, &sound));
  if (!sound)
    throw std::invalid_argument(
      "surface: is not closed, not 2-manifold or not wound one way; .3mf is for printable bodies. "
      "Mend it, or write .stl, .ply or .obj");
  if (!named.name.empty())
    Check3mf(NMR::lib3mf_object_setnameutf8(object, named.name.c_str()));
  Check3mf(NMR::lib3mf_object_setuuidutf8(object, identifiers.Next().c_str()));
  Check3mf(NMR::lib3mf_model_addbuilditem(model, object, nullptr, item.Out()));
  Check3mf(NMR::lib3mf_builditem_setuuidutf8(item, identifiers.Next().c_str()));
}

void AddText(Lib3mfHandle model, const char* key, const std::string& value)
{
  if (!value.empty())
    Check3mf(NMR::lib3mf_model_addmetadatautf8(model, key, value.c_str()));
}

} // namespace

std::vector<char> EncodeThreeMf(const std::vector<NamedMesh>& meshes, const PartLabel& label)
{
  Identifiers identifiers(meshes, label);
  Lib3mfObject model, writer;
  Check3mf(NMR::lib3mf_createmodel(model.Out()));
  Check3mf(NMR::lib3mf_model_setunit(model, NMR::MODELUNIT_MILLIMETER));
  AddText(model, "Title", label.name + (label.doesNotHold ? " DOES NOT HOLD" : ""));
  AddText(model, "Application", "Hasp " HASP_VERSION);
  AddText(model, "Description", PartText(label));
  for (const NamedMesh& mesh : meshes)
    AddMesh(model, mesh, identifiers);
  Check3mf(NMR::lib3mf_model_setbuilduuidutf8(model, identifiers.Next().c_str()));
  Check3mf(NMR::lib3mf_model_querywriter(model, "3mf", writer.Out()));
  ULONG64 size = 0;
  Check3mf(NMR::lib3mf_writer_getstreamsize(writer, &size));
  std::vector<char> bytes(size);
  Check3mf(
    NMR::lib3mf_writer_writetobuffer(writer, reinterpret_cast<BYTE*>(bytes.data()), bytes.size()));
  return bytes;
}

} // namespace hasp

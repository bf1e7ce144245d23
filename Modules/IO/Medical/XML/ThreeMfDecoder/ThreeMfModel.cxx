#include "ThreeMfModel.h"

#include <algorithm>
#include <cstring>

using hasp::Check3mf;
using hasp::Lib3mfObject;
using namespace NMR;

namespace
{

constexpr int MostDepth = 64;

constexpr Transform Identity = { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } } };

/// `inner` first.
Transform Join(const Transform& outer, const Transform& inner)
{
  Transform both{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
    {
      both[r][c] = c == 3 ? outer[r][3] : 0.0;
      for (int k = 0; k < 3; ++k)
        both[r][c] += outer[r][k] * inner[k][c];
    }
  return both;
}

Transform From(const MODELTRANSFORM& given)
{
  Transform transform{};
  for (int r = 0; r < 3; ++r)
    std::copy_n(given.m_fFields[r], 4, transform[r].begin());
  return transform;
}

/// Visits what a model builds, by the resources' numbers: they say what is one object, and its
/// kind.
class Visitor
{
public:
  explicit Visitor(hasp::Lib3mfHandle model) : Model(model) {}

  void Build(hasp::Lib3mfHandle item)
  {
    DWORD id = 0;
    BOOL moved = 0;
    MODELTRANSFORM given{};
    Check3mf(lib3mf_builditem_getobjectresourceid(item, &id));
    Check3mf(lib3mf_builditem_hasobjecttransform(item, &moved));
    if (moved)
      Check3mf(lib3mf_builditem_getobjecttransform(item, &given));
    Lib3mfObject object;
    Check3mf(lib3mf_builditem_getobjectresource(item, object.Out()));
    std::memset(this->Name, 0, sizeof this->Name);
    ULONG length = 0;
    char name[256] = {};
    if (lib3mf_object_getnameutf8(object, name, sizeof name, &length) == LIB3MF_OK)
      std::memcpy(this->Name, name, sizeof this->Name - 1);
    this->Visit(object, id, moved ? From(given) : Identity, 0);
  }
  std::vector<BuiltMesh> Meshes;

private:
  void Visit(hasp::Lib3mfHandle object, DWORD id, const Transform& place, int depth)
  {
    if (depth > MostDepth || ++this->Visits > hasp::ThreeMfRecord::MostObjects)
      throw TooManyObjects();
    BOOL mesh = 0, components = 0;
    Check3mf(lib3mf_object_ismeshobject(object, &mesh));
    if (mesh)
      return this->Add(id, place);
    Check3mf(lib3mf_object_iscomponentsobject(object, &components));
    DWORD count = 0;
    if (components)
      Check3mf(lib3mf_componentsobject_getcomponentcount(object, &count));
    for (DWORD n = 0; n < count; ++n)
    {
      Lib3mfObject component, inner;
      BOOL moved = 0;
      DWORD innerId = 0;
      MODELTRANSFORM given{};
      Check3mf(lib3mf_componentsobject_getcomponent(object, n, component.Out()));
      Check3mf(lib3mf_component_hastransform(component, &moved));
      if (moved)
        Check3mf(lib3mf_component_gettransform(component, &given));
      Check3mf(lib3mf_component_getobjectresourceid(component, &innerId));
      Check3mf(lib3mf_component_getobjectresource(component, inner.Out()));
      this->Visit(inner, innerId, moved ? Join(place, From(given)) : place, depth + 1);
    }
  }

  void Add(DWORD id, const Transform& place)
  {
    BuiltMesh built{ id, place, {} };
    std::memcpy(built.record.name, this->Name, sizeof this->Name);
    Lib3mfObject mesh;
    DWORD points = 0, triangles = 0;
    Check3mf(lib3mf_model_getmeshobjectbyid(this->Model, id, mesh.Out()));
    Check3mf(lib3mf_meshobject_getvertexcount(mesh, &points));
    Check3mf(lib3mf_meshobject_gettrianglecount(mesh, &triangles));
    built.record.points = points;
    built.record.triangles = triangles;
    this->Meshes.push_back(built);
  }

  hasp::Lib3mfHandle Model;
  std::size_t Visits = 0;
  char Name[sizeof(hasp::ThreeMfObject::name)] = {};
};

} // namespace

std::vector<BuiltMesh> BuiltMeshes(hasp::Lib3mfHandle model)
{
  Visitor visitor(model);
  Lib3mfObject items;
  Check3mf(lib3mf_model_getbuilditems(model, items.Out()));
  BOOL more = 0;
  for (Check3mf(lib3mf_builditemiterator_movenext(items, &more)); more;
       Check3mf(lib3mf_builditemiterator_movenext(items, &more)))
  {
    Lib3mfObject item;
    Check3mf(lib3mf_builditemiterator_getcurrent(items, item.Out()));
    visitor.Build(item);
  }
  return std::move(visitor.Meshes);
}

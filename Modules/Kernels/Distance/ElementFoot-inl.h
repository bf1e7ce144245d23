// No include guard: compiled once an instruction set, after ElementFit-inl.h.

constexpr int FootSteps = 2; // from the nearest voxel to the foot point: a third finds nothing new

/// From the centre of one voxel to that of another.
HWY_INLINE Vector Steps(const Field& field, Ints x, Ints y, Ints z, Ints i, Ints j, Ints k)
{
  return Scale({ hn::ConvertTo(floats, hn::Sub(x, i)), hn::ConvertTo(floats, hn::Sub(y, j)),
                 hn::ConvertTo(floats, hn::Sub(z, k)) },
    field.sides);
}

/// A voxel with an element.
struct Nearest
{
  Ints x, y, z, voxel;
};

/// A place seen from an element.
struct Seen
{
  Vector from, normal; ///< from the element's point
  Floats curvature;

  HWY_INLINE Seen(const Field& field, const SurfaceElements::Element* elements,
    const Nearest& nearest, Ints x, Ints y, Ints z)
  {
    const Ints e = hn::ShiftLeft<3>(hn::GatherIndex(ints, field.surface.at.data(), nearest.voxel));
    const Vector p = { field.Component(elements, e, 0), field.Component(elements, e, 1),
      field.Component(elements, e, 2) };
    this->from = Steps(field, x, y, z, nearest.x, nearest.y, nearest.z) - p;
    this->normal = { field.Component(elements, e, 4), field.Component(elements, e, 5),
      field.Component(elements, e, 6) };
    this->curvature = field.Component(elements, e, 3);
  }
};

/// A sphere with the element's normal and curvature, through its point: the distance of a place,
/// and where it is nearest. Exact on planes and spheres.
struct Osculating
{
  Floats distance;
  Vector foot; ///< from the place

  HWY_INLINE explicit Osculating(const Seen& seen)
  {
    // From the sphere's middle, times the curvature.
    const Vector w = AddTimes(seen.normal, seen.curvature, seen.from);
    const Floats length = hn::Max(hn::Sqrt(Dot(w, w)), Splat(1e-6F));
    const Floats twice = hn::Mul(Splat(2.0F), Dot(seen.from, seen.normal));
    this->distance = hn::Div(
      hn::MulAdd(seen.curvature, Dot(seen.from, seen.from), twice), hn::Add(length, Splat(1.0F)));
    this->foot = hn::Neg(hn::Div(this->distance, length)) * w;
  }
};

/// What is nearest by the centres of voxels may lie a few voxels aside: moves to the voxel of the
/// foot point, if that has an element.
HWY_INLINE Nearest MoveToFoot(
  const Field& field, const Nearest& nearest, const Osculating& sphere, Ints px, Ints py, Ints pz)
{
  const glm::ivec3& dims = field.surface.dims;
  const Vector steps = Scale(sphere.foot, field.perSide);
  const auto move = [](Ints from, Floats step, int count)
  {
    const Ints to = hn::Add(from, hn::NearestInt(step));
    return hn::Min(hn::Max(to, Splat(0)), Splat(count - 1));
  };
  const Ints i = move(px, steps.x, dims.x), j = move(py, steps.y, dims.y),
             k = move(pz, steps.z, dims.z);
  const Ints to =
    hn::Add(i, hn::Add(hn::Mul(j, Splat(dims.x)), hn::Mul(k, Splat(dims.x * dims.y))));
  const IntMask there = hn::Gt(hn::GatherIndex(ints, field.surface.at.data(), to), Splat(-1));
  return { hn::IfThenElse(there, i, nearest.x), hn::IfThenElse(there, j, nearest.y),
    hn::IfThenElse(there, k, nearest.z), hn::IfThenElse(there, to, nearest.voxel) };
}

void Near(const SurfaceElements& surface, const float* coverage, const glm::ivec3& origin,
  const std::int32_t* list, int count, float* distances)
{
  const Field field(surface, coverage);
  const Ints low = Splat(15), reach = Splat(ElementLanes::Reach);
  const Ints row = Splat(surface.dims.x), slice = Splat(surface.dims.x * surface.dims.y);
  for (int n = 0; n < count; n += Lanes)
  {
    const Ints packed = hn::LoadU(ints, list + n);
    const Ints x = hn::Add(hn::And(packed, low), Splat(origin.x));
    const Ints y = hn::Add(hn::And(hn::ShiftRight<4>(packed), low), Splat(origin.y));
    const Ints z = hn::Add(hn::And(hn::ShiftRight<8>(packed), low), Splat(origin.z));
    const Ints dx = hn::Sub(hn::And(hn::ShiftRight<12>(packed), low), reach);
    const Ints dy = hn::Sub(hn::And(hn::ShiftRight<16>(packed), low), reach);
    const Ints dz = hn::Sub(hn::And(hn::ShiftRight<20>(packed), low), reach);
    const auto number = [&](Ints i, Ints j, Ints k)
    { return hn::Add(i, hn::Add(hn::Mul(j, row), hn::Mul(k, slice))); };
    Nearest nearest = { hn::Add(x, dx), hn::Add(y, dy), hn::Add(z, dz), number(x, y, z) };
    nearest.voxel = number(nearest.x, nearest.y, nearest.z);
    const Seen seen(field, surface.elements.data(), nearest, x, y, z);
    nearest = MoveToFoot(field, nearest, Osculating(seen), x, y, z);
    const Voxels at(field, nearest.x, nearest.y, nearest.z, nearest.voxel);
    const Vector r = Steps(field, x, y, z, nearest.x, nearest.y, nearest.z);
    const Floats a = hn::GatherIndex(floats, coverage, number(x, y, z));
    const Fit fit = FitAt(field, at, r, hn::Ge(a, Splat(0.5F)));
    hn::StoreU(fit.distance, floats, distances + n);
  }
}

/// Distance to a refined element: to its sphere where that is nearest within a voxel of its point,
/// else to its disc's rim.
HWY_INLINE Floats FarDistance(const Field& field, const Seen& seen, const Osculating& sphere)
{
  const Floats facing = Dot(seen.from, seen.normal);
  const Vector moved = Scale(seen.from + sphere.foot, field.perSide);
  const Vector lateral = AddTimes(seen.from, hn::Neg(facing), seen.normal);
  const Vector aside = Scale(lateral, field.perSide);
  const Mask plane = hn::Gt(Dot(seen.normal, seen.normal), Splat(0.5F));
  const Floats voxels = hn::Max(hn::Sqrt(Dot(aside, aside)), Splat(1e-6F));
  const Floats beyond = hn::Max(Splat(0.0F),
    hn::Sub(Splat(1.0F), hn::Div(hn::IfThenElseZero(plane, Splat(DiscVoxels)), voxels)));
  const Floats disc =
    hn::Sqrt(hn::MulAdd(hn::Mul(beyond, beyond), Dot(lateral, lateral), hn::Mul(facing, facing)));
  const Mask under = hn::And(hn::Lt(Dot(moved, moved), Splat(1.5F)), plane);
  return hn::IfThenElse(under, hn::Abs(sphere.distance), disc);
}

void FarRow(const SurfaceElements& surface, const ElementLanes::Element* refined, int y, int z,
  const std::uint32_t* seeds, float from, float* distances)
{
  const Field field(surface, nullptr);
  const std::int32_t* place = &surface.places.data()->x;
  const Ints j = Splat(y), k = Splat(z);
  for (int first = 0; first < surface.dims.x; first += Lanes)
  {
    const int count = surface.dims.x - first < Lanes ? surface.dims.x - first : Lanes;
    float was[Lanes], now[Lanes];
    std::int32_t seed[Lanes];
    bool any = false;
    for (int n = 0; n < Lanes; ++n)
    {
      was[n] = distances[first + (n < count ? n : count - 1)];
      seed[n] = static_cast<std::int32_t>(seeds[first + (n < count ? n : count - 1)]);
      any = any || !(was[n] > -from && was[n] < from);
    }
    if (!any)
      continue;
    const Ints voxel = hn::LoadU(ints, seed), i = hn::Iota(ints, first);
    const Ints at = hn::ShiftLeft<2>(hn::GatherIndex(ints, surface.at.data(), voxel));
    Nearest nearest = { hn::GatherIndex(ints, place, at), hn::GatherIndex(ints, place + 1, at),
      hn::GatherIndex(ints, place + 2, at), voxel };
    Floats least = Splat(std::numeric_limits<float>::max());
    for (int step = 0; step < FootSteps; ++step)
    {
      const Seen seen(field, refined, nearest, i, j, k);
      const Osculating sphere(seen);
      least = hn::Min(least, FarDistance(field, seen, sphere));
      nearest = MoveToFoot(field, nearest, sphere, i, j, k);
    }
    const Floats mm = hn::Mul(Splat(float(surface.unit)), least);
    const Floats before = hn::LoadU(floats, was);
    const Mask near = hn::Lt(hn::Abs(before), Splat(from));
    hn::StoreU(hn::IfThenElse(near, before, hn::CopySign(mm, before)), floats, now);
    for (int lane = 0; lane < count; ++lane)
      distances[first + lane] = now[lane];
  }
}

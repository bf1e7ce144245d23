// No include guard: compiled once an instruction set. The including file says what hn, floats,
// ints, Floats, Ints, Mask, Lanes and BitsOf are.

HWY_INLINE Floats Splat(float v)
{
  return hn::Set(floats, v);
}
HWY_INLINE Ints Splat(std::int32_t v)
{
  return hn::Set(ints, v);
}
HWY_INLINE Mask OfFloats(IntMask m)
{
  return hn::RebindMask(floats, m);
}

struct Vector
{
  Floats x, y, z;
};
HWY_INLINE Vector operator+(const Vector& a, const Vector& b)
{
  return { hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z) };
}
HWY_INLINE Vector operator-(const Vector& a, const Vector& b)
{
  return { hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z) };
}
HWY_INLINE Vector operator*(Floats s, const Vector& a)
{
  return { hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z) };
}
HWY_INLINE Vector AddTimes(const Vector& sum, Floats s, const Vector& a)
{
  return { hn::MulAdd(s, a.x, sum.x), hn::MulAdd(s, a.y, sum.y), hn::MulAdd(s, a.z, sum.z) };
}
HWY_INLINE Floats Dot(const Vector& a, const Vector& b)
{
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Vector Choose(Mask m, const Vector& a, const Vector& b)
{
  return { hn::IfThenElse(m, a.x, b.x), hn::IfThenElse(m, a.y, b.y), hn::IfThenElse(m, a.z, b.z) };
}
HWY_INLINE Vector None()
{
  return { Splat(0.0F), Splat(0.0F), Splat(0.0F) };
}
/// By axis: a length in voxels becomes one in units, or the other way round.
HWY_INLINE Vector Scale(const Vector& a, const Vector& b)
{
  return { hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z) };
}

/// A grid and its elements, as lanes ask for them.
struct Field
{
  const SurfaceElements& surface;
  const float* coverage;
  Vector sides, perSide;

  HWY_INLINE Field(const SurfaceElements& s, const float* c)
    : surface(s),
      coverage(c),
      sides{ Splat(s.sides.x), Splat(s.sides.y), Splat(s.sides.z) },
      perSide{ Splat(1.0F / s.sides.x), Splat(1.0F / s.sides.y), Splat(1.0F / s.sides.z) }
  {
  }
  /// A component of elements; n is 8 times their number.
  HWY_INLINE Floats Component(const SurfaceElements::Element* elements, Ints n, int which) const
  {
    static_assert(sizeof(SurfaceElements::Element) == 8 * sizeof(float));
    return hn::GatherIndex(floats, elements->point + which, n);
  }
  HWY_INLINE Vector Point(Ints n) const
  {
    const auto* e = this->surface.elements.data();
    return { Component(e, n, 0), Component(e, n, 1), Component(e, n, 2) };
  }
  HWY_INLINE Vector Normal(Ints n) const
  {
    const auto* e = this->surface.elements.data();
    return { Component(e, n, 4), Component(e, n, 5), Component(e, n, 6) };
  }
};

/// Voxels and their 26 neighbours.
struct Voxels
{
  Ints x, y, z, voxel;
  Ints step[3][3];     ///< by axis and -1, 0, 1: to the neighbour's number, 0 where there is none
  IntMask there[3][3]; ///< is there one?

  HWY_INLINE Voxels(const Field& field, Ints px, Ints py, Ints pz, Ints v)
    : x(px),
      y(py),
      z(pz),
      voxel(v)
  {
    const glm::ivec3& dims = field.surface.dims;
    const std::int32_t stride[3] = { 1, dims.x, dims.x * dims.y };
    const Ints at[3] = { px, py, pz };
    for (int a = 0; a < 3; ++a)
    {
      this->there[a][0] = hn::Gt(at[a], Splat(0));
      this->there[a][1] = hn::Eq(at[a], at[a]);
      this->there[a][2] = hn::Lt(at[a], Splat(dims[a] - 1));
      for (int s = 0; s < 3; ++s)
        this->step[a][s] = hn::IfThenElseZero(this->there[a][s], Splat(stride[a] * (s - 1)));
    }
  }
  /// The neighbour's number; at the grid's end the last voxel once more.
  HWY_INLINE Ints Neighbour(int i, int j, int k) const
  {
    return hn::Add(
      hn::Add(this->voxel, this->step[0][i]), hn::Add(this->step[1][j], this->step[2][k]));
  }
  HWY_INLINE IntMask There(int i, int j, int k) const
  {
    return hn::And(this->there[0][i], hn::And(this->there[1][j], this->there[2][k]));
  }
};

HWY_INLINE Voxels VoxelsOf(const Field& field, Ints element)
{
  const std::int32_t* place = &field.surface.places.data()->x;
  const Ints n = hn::ShiftLeft<2>(element);
  return { field, hn::GatherIndex(ints, place, n), hn::GatherIndex(ints, place + 1, n),
    hn::GatherIndex(ints, place + 2, n), hn::GatherIndex(ints, place + 3, n) };
}

/// Elements from n on, the last one more than once at the end.
HWY_INLINE Ints ElementsFrom(std::size_t n, std::size_t last)
{
  return hn::Min(hn::Iota(ints, static_cast<std::int32_t>(n)), Splat(std::int32_t(last - 1)));
}

HWY_INLINE void StoreElements(const Vector& point, Floats curvature, const Vector& normal,
  Floats weight, int count, ElementLanes::Element* to)
{
  float lane[8][Lanes];
  const Floats all[8] = { point.x, point.y, point.z, curvature, normal.x, normal.y, normal.z,
    weight };
  for (int c = 0; c < 8; ++c)
    hn::StoreU(all[c], floats, lane[c]);
  for (int n = 0; n < count; ++n)
    to[n] = { { lane[0][n], lane[1][n], lane[2][n] }, lane[3][n],
      { lane[4][n], lane[5][n], lane[6][n] }, lane[7][n] };
}

HWY_INLINE int CountFrom(std::size_t n, std::size_t last)
{
  return static_cast<int>(last - n < std::size_t(Lanes) ? last - n : std::size_t(Lanes));
}

bool ScanRow(
  const ElementLanes::Row& row, bool coverage, std::uint32_t* bits, float* sides, float beyond)
{
  const Floats least = Splat(ElementLanes::Least), most = Splat(ElementLanes::Most);
  const Floats zero = Splat(0.0F), one = Splat(1.0F), half = Splat(0.5F);
  IntMask sound = hn::Eq(Splat(0), Splat(0));
  Mask good = OfFloats(sound);
  for (int x = 0; x < row.length; x += Lanes)
  {
    const bool whole = x + Lanes <= row.length;
    const int count = whole ? Lanes : row.length - x;
    float last[4][Lanes]; // what of other rows may not be read past the end
    const Floats here = hn::LoadU(floats, row.here + x);
    const Mask inside = hn::Ge(here, half);
    const Floats above = hn::Abs(hn::Sub(here, half));
    Floats lowest = one;
    Mask crossed = hn::Lt(one, zero); // by a grid line's half, from here on
    const auto look = [&](Floats other)
    {
      lowest = hn::Min(lowest, other);
      const Mask differs = hn::Lt(hn::CopySign(one, hn::Sub(other, half)), zero);
      const Mask across = hn::Or(hn::And(inside, differs), hn::Not(hn::Or(inside, differs)));
      crossed = hn::Or(crossed, hn::And(across, hn::Le(above, hn::Abs(hn::Sub(other, half)))));
    };
    look(hn::LoadU(floats, row.here + x - 1));
    look(hn::LoadU(floats, row.here + x + 1));
    for (int f = 0; f < 4; ++f)
    {
      for (int n = 0; n < Lanes && !whole; ++n)
        last[f][n] = row.faces[f][x + (n < count ? n : count - 1)];
      look(hn::LoadU(floats, whole ? row.faces[f] + x : last[f]));
    }
    const Mask unit = hn::And(hn::Ge(here, zero), hn::Le(here, one));
    good = hn::And(good, coverage ? unit : hn::Eq(here, here)); // NaN is neither
    const Mask partial = hn::And(hn::Gt(here, least), hn::Lt(here, most));
    const Mask face = hn::And(hn::Ge(here, most), hn::Le(lowest, least));
    std::uint64_t found = BitsOf(coverage ? hn::Or(partial, face) : crossed);
    if (!whole)
      found &= (1U << count) - 1;
    bits[x >> 5] |= static_cast<std::uint32_t>(found << (x & 31));
    if (!sides)
      continue;
    const Floats side = hn::IfThenElse(inside, Splat(-beyond), Splat(beyond));
    if (whole)
      hn::StoreU(side, floats, sides + x);
    else
    {
      hn::StoreU(side, floats, last[0]);
      for (int n = 0; n < count; ++n)
        sides[x + n] = last[0][n];
    }
  }
  return BitsOf(good) == (Lanes < 64 ? (std::uint64_t(1) << Lanes) - 1 : 0);
}

struct Pair
{
  Ints ahead, behind;
};

/// The neighbours nearest to the way of the gradient: of a voxel that a plane cuts, one of them is
/// clear of the plane.
HWY_INLINE Pair AlongGradient(const Voxels& at, const Vector& g)
{
  const Floats x = hn::Abs(g.x), y = hn::Abs(g.y), z = hn::Abs(g.z);
  const Floats half = hn::Mul(Splat(0.5F), hn::Max(x, hn::Max(y, z))), none = Splat(0.0F);
  const auto step = [&](Floats size, Floats along, int axis)
  {
    const IntMask up = hn::RebindMask(ints, hn::Gt(along, none));
    const IntMask use = hn::RebindMask(ints, hn::Gt(size, half));
    return Pair{ hn::IfThenElseZero(use, hn::IfThenElse(up, at.step[axis][2], at.step[axis][0])),
      hn::IfThenElseZero(use, hn::IfThenElse(up, at.step[axis][0], at.step[axis][2])) };
  };
  const Pair i = step(x, g.x, 0), j = step(y, g.y, 1), k = step(z, g.z, 2);
  return { hn::Add(at.voxel, hn::Add(i.ahead, hn::Add(j.ahead, k.ahead))),
    hn::Add(at.voxel, hn::Add(i.behind, hn::Add(j.behind, k.behind))) };
}

EdgeFacts Gradients(const SurfaceElements& surface, const float* coverage, std::size_t first,
  std::size_t last, ElementLanes::Element* to)
{
  const Field field(surface, coverage);
  const Floats least = Splat(ElementLanes::Least), most = Splat(ElementLanes::Most);
  const Ints end = Splat(int(surface.at.size()) - 1);
  EdgeFacts sum;
  for (std::size_t n = first; n < last; n += Lanes)
  {
    const Voxels at = VoxelsOf(field, ElementsFrom(n, last));
    Vector g = None();
    Floats low = Splat(1.0F), high = Splat(0.0F);
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
        {
          const Floats a = hn::GatherIndex(floats, coverage, at.Neighbour(i, j, k));
          low = hn::Min(low, a);
          high = hn::Max(high, a);
          const auto smooth = [](int s) { return s == 1 ? 2.0F : 1.0F; };
          if (i != 1)
            g.x = hn::MulAdd(Splat(float(i - 1) * smooth(j) * smooth(k)), a, g.x);
          if (j != 1)
            g.y = hn::MulAdd(Splat(float(j - 1) * smooth(i) * smooth(k)), a, g.y);
          if (k != 1)
            g.z = hn::MulAdd(Splat(float(k - 1) * smooth(i) * smooth(j)), a, g.z);
        }
    const auto [ahead, behind] = AlongGradient(at, g);
    g = Scale(g, field.perSide);
    const Floats length = hn::Sqrt(Dot(g, g));
    const Mask known = hn::Gt(length, Splat(1e-5F));
    const Floats per = hn::IfThenElseZero(known, hn::Div(Splat(1.0F), length));
    const int count = CountFrom(n, last);
    StoreElements(None(), Splat(0.0F), per * g, Splat(0.0F), count, to + n);
    const Floats here = hn::GatherIndex(floats, coverage, at.voxel);
    const auto between = [&](Floats a) { return hn::And(hn::Gt(a, least), hn::Lt(a, most)); };
    // Where it turns back one step on, that is the other side of a thin wall, or of a gap.
    const Floats inner = hn::GatherIndex(floats, coverage, ahead),
                 outer = hn::GatherIndex(floats, coverage, behind);
    const auto beyond = [&](Ints next)
    {
      const Ints on = hn::Sub(hn::Add(next, next), at.voxel);
      return hn::GatherIndex(floats, coverage, hn::Min(hn::Max(on, Splat(0)), end));
    };
    const Mask onwards = hn::And(hn::Ge(beyond(ahead), inner), hn::Le(beyond(behind), outer));
    const Mask blurred = hn::And(hn::And(known, onwards), hn::And(between(inner), between(outer)));
    const Mask stray = hn::Or(hn::Lt(high, Splat(0.25F)), hn::Ge(low, Splat(0.75F)));
    const std::uint64_t some = BitsOf(between(here)) & ((std::uint64_t(1) << count) - 1);
    sum.partial += __builtin_popcountll(some);
    sum.blurred += __builtin_popcountll(BitsOf(blurred) & some);
    sum.stray += __builtin_popcountll(BitsOf(stray) & some);
  }
  return sum;
}

/// Distance from the centre of a box to the plane that leaves the share `covered` on the inner side
/// of its outward unit normal; PlaneDistanceFromCoverage says more. From the middle on, where the
/// volume below the plane is convex in its depth, Newton's steps come down to the root.
HWY_INLINE Floats PlaneDistance(const Field& field, const Vector& normal, Floats covered)
{
  const Vector reach =
    Scale({ hn::Abs(normal.x), hn::Abs(normal.y), hn::Abs(normal.z) }, field.sides);
  const Floats whole = hn::Add(reach.x, hn::Add(reach.y, reach.z));
  const Floats floor = hn::Mul(Splat(0.01F), whole);
  const Floats m[3] = { hn::Max(reach.x, floor), hn::Max(reach.y, floor), hn::Max(reach.z, floor) };
  const Floats total = hn::Add(m[0], hn::Add(m[1], m[2]));
  const Floats part = hn::Min(covered, hn::Sub(Splat(1.0F), covered));
  const Floats six = hn::Mul(Splat(6.0F), hn::Mul(m[0], hn::Mul(m[1], m[2])));
  const Floats wanted = hn::Mul(part, six);
  Floats depth = hn::Mul(Splat(0.5F), total);
  for (int step = 0; step < 8; ++step)
  {
    Floats volume = hn::Mul(depth, hn::Mul(depth, depth)), slope = hn::Mul(depth, depth);
    for (int a = 0; a < 3; ++a)
    {
      const Floats one = hn::Max(hn::Sub(depth, m[a]), Splat(0.0F));
      const Floats two = hn::Max(hn::Sub(hn::Sub(depth, m[a]), m[(a + 1) % 3]), Splat(0.0F));
      const Floats oneSquared = hn::Mul(one, one), twoSquared = hn::Mul(two, two);
      slope = hn::Sub(hn::Add(slope, twoSquared), oneSquared);
      volume = hn::Sub(hn::Add(volume, hn::Mul(two, twoSquared)), hn::Mul(one, oneSquared));
    }
    depth = hn::Sub(
      depth, hn::Div(hn::Sub(volume, wanted), hn::Mul(Splat(3.0F), hn::Max(slope, Splat(1e-12F)))));
  }
  const Floats fromCentre = hn::Sub(hn::Mul(Splat(0.5F), total), depth);
  return hn::IfThenElse(hn::Le(covered, Splat(0.5F)), fromCentre, hn::Neg(fromCentre));
}

/// Of saturated voxels that meet the other kind: the surface is where what both are short of fills
/// up, along the axis to the first that does.
HWY_INLINE void FaceElement(
  const Field& field, const Voxels& at, Floats alpha, Mask who, Vector& point, Vector& normal)
{
  const Mask known = hn::Gt(Dot(normal, normal), Splat(0.5F));
  const Floats none = Splat(0.0F);
  for (int n = 0; n < 6; ++n)
  {
    const int axis = n / 2, s = n % 2 ? 2 : 0;
    const Ints neighbour = at.Neighbour(axis == 0 ? s : 1, axis == 1 ? s : 1, axis == 2 ? s : 1);
    const Floats a = hn::GatherIndex(floats, field.coverage, neighbour), way = Splat(float(s - 1));
    const Mask here = hn::And(who, hn::Le(a, Splat(ElementLanes::Least)));
    const Vector unit = { axis == 0 ? way : none, axis == 1 ? way : none, axis == 2 ? way : none };
    const Floats along = hn::Sub(hn::Add(alpha, a), Splat(0.5F));
    point = Choose(here, along * Scale(unit, field.sides), point);
    normal = Choose(hn::And(here, hn::Not(known)), unit, normal);
    who = hn::And(who, hn::Not(here));
  }
}

constexpr float FaceWeight = 0.25F; // of a plane between saturated voxels, known to be near only

/// Outward unit normals: elements' gradients, smoothed over those whose value is below `below`.
/// Where they cancel (sheets and specks thinner than a voxel): 0.
HWY_INLINE Vector SmoothNormal(const Field& field, const Voxels& at, Ints element, Floats below)
{
  const float gaussian[4] = { 1.0F, 0.60653066F, 0.36787944F, 0.22313016F }; // sigma: one voxel
  Vector sum = None();
  Floats weights = Splat(0.0F);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
      {
        const Ints voxel = at.Neighbour(i, j, k);
        const Ints other = hn::GatherIndex(ints, field.surface.at.data(), voxel);
        const Floats a = hn::GatherIndex(floats, field.coverage, voxel);
        const Mask use = hn::And(OfFloats(hn::Gt(other, Splat(-1))), hn::Lt(a, below));
        const Vector g = field.Normal(hn::ShiftLeft<3>(hn::Max(other, Splat(0))));
        const Mask known = hn::And(use, hn::Gt(Dot(g, g), Splat(0.5F)));
        const Floats w = hn::IfThenElseZero(known, Splat(gaussian[(i != 1) + (j != 1) + (k != 1)]));
        sum = AddTimes(sum, w, g);
        weights = hn::Add(weights, w);
      }
  // No partial voxel near: a face between saturated ones has its own gradient.
  const Mask alone = hn::Eq(weights, Splat(0.0F));
  sum = Choose(alone, field.Normal(hn::ShiftLeft<3>(element)), sum);
  weights = hn::IfThenElse(alone, Splat(1.0F), weights);
  const Floats length = hn::Sqrt(Dot(sum, sum));
  const Mask known = hn::Gt(length, hn::Mul(Splat(0.1F), weights));
  return hn::IfThenElseZero(known, hn::Div(Splat(-1.0F), length)) * sum;
}

void Planes(const SurfaceElements& surface, const float* coverage, std::size_t first,
  std::size_t last, ElementLanes::Element* to)
{
  const Field field(surface, coverage);
  const Floats least = Splat(ElementLanes::Least), most = Splat(ElementLanes::Most);
  for (std::size_t n = first; n < last; n += Lanes)
  {
    const Ints element = ElementsFrom(n, last);
    const Voxels at = VoxelsOf(field, element);
    Vector normal = SmoothNormal(field, at, element, most);
    const Mask known = hn::Gt(Dot(normal, normal), Splat(0.5F));
    const Floats alpha = hn::GatherIndex(floats, coverage, at.voxel);
    const Floats d = hn::IfThenElseZero(known, PlaneDistance(field, normal, alpha));
    Vector point = hn::Neg(d) * normal;
    const Mask face = hn::Or(hn::Ge(alpha, most), hn::Le(alpha, least));
    if (BitsOf(face))
      FaceElement(field, at, alpha, face, point, normal);
    const Floats weight = hn::IfThenElse(
      face, Splat(FaceWeight), hn::Mul(Splat(4.0F), hn::Mul(alpha, hn::Sub(Splat(1.0F), alpha))));
    StoreElements(point, Splat(0.0F), normal, weight, CountFrom(n, last), to + n);
  }
}

/// Trilinear values less than a voxel from the centre on each axis.
HWY_INLINE Floats ValueAt(const Field& field, const Voxels& at, const Vector& offset)
{
  const Floats way[3] = { offset.x, offset.y, offset.z }, one = Splat(1.0F), none = Splat(0.0F);
  Ints low[3], high[3];
  Floats t[3];
  for (int a = 0; a < 3; ++a)
  {
    const Mask back = hn::Lt(way[a], none);
    const IntMask down = hn::RebindMask(ints, back);
    low[a] = hn::IfThenElseZero(down, at.step[a][0]);
    high[a] = hn::IfThenElse(down, Splat(0), at.step[a][2]);
    t[a] = hn::IfThenElse(back, hn::Add(way[a], one), way[a]);
  }
  const auto mix = [](Floats a, Floats b, Floats s) { return hn::MulAdd(s, hn::Sub(b, a), a); };
  const auto value = [&](Ints i, Ints j, Ints k)
  { return hn::GatherIndex(floats, field.coverage, hn::Add(hn::Add(at.voxel, i), hn::Add(j, k))); };
  const auto row = [&](Ints j, Ints k)
  { return mix(value(low[0], j, k), value(high[0], j, k), t[0]); };
  return mix(mix(row(low[1], low[2]), row(high[1], low[2]), t[1]),
    mix(row(low[1], high[2]), row(high[1], high[2]), t[1]), t[2]);
}

void IsoPlanes(const SurfaceElements& surface, const float* values, std::size_t first,
  std::size_t last, ElementLanes::Element* to)
{
  const Field field(surface, values);
  for (std::size_t n = first; n < last; n += Lanes)
  {
    const Floats half = Splat(0.5F);
    const Ints element = ElementsFrom(n, last);
    const Voxels at = VoxelsOf(field, element);
    const Vector normal = SmoothNormal(field, at, element, Splat(3e38F));
    const Vector step = Scale(normal, field.perSide); // voxels a unit
    const auto beyond = [&](Floats s) { return hn::Sub(ValueAt(field, at, s * step), half); };
    // Secants along the normal, less than a voxel on each axis.
    const Floats xy = hn::Max(hn::Abs(step.x), hn::Abs(step.y)), least = Splat(1e-6F);
    const Floats most = hn::Div(Splat(0.95F), hn::Max(hn::Max(xy, hn::Abs(step.z)), least));
    const auto within = [&](Floats s) { return hn::Min(hn::Max(s, hn::Neg(most)), most); };
    Floats s0 = Splat(0.0F), f0 = beyond(s0);
    Floats s1 = hn::CopySign(hn::Mul(half, most), f0), f1 = beyond(s1);
    for (int round = 0; round < 4; ++round)
    {
      const Floats rise = hn::Sub(f1, f0);
      const Mask steep = hn::Gt(hn::Abs(rise), Splat(1e-12F));
      const Floats by = hn::Div(hn::Mul(f1, hn::Sub(s1, s0)), hn::IfThenElse(steep, rise, half));
      const Floats next = within(hn::IfThenElse(steep, hn::Sub(s1, by), s1));
      s0 = std::exchange(s1, next);
      f0 = std::exchange(f1, beyond(next));
    }
    StoreElements(s1 * normal, Splat(0.0F), normal, Splat(1.0F), CountFrom(n, last), to + n);
  }
}

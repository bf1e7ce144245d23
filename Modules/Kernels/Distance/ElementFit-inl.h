// No include guard: compiled once an instruction set, after ElementLanes-inl.h.

/// What elements span around places, given from the centres of their elements' voxels.
struct Fit
{
  Vector foot, normal;
  Floats curvature; ///< mean; 0 where the fit is not used
  Floats distance;  ///< along the normal
};

/// The elements of 3^3 voxels, read once for what asks them several times.
struct Neighbours
{
  float point[27][3][Lanes], normal[27][3][Lanes], there[27][Lanes];
  int used[27], count = 0; ///< places where any lane has an element

  HWY_INLINE Neighbours(const Field& field, const Voxels& at)
  {
    for (int n = 0; n < 27; ++n)
    {
      const int i = n % 3, j = n / 3 % 3, k = n / 9;
      const Ints e = hn::GatherIndex(ints, field.surface.at.data(), at.Neighbour(i, j, k));
      const Mask some = OfFloats(hn::And(at.There(i, j, k), hn::Gt(e, Splat(-1))));
      if (!BitsOf(some))
        continue;
      const Ints from = hn::ShiftLeft<3>(hn::Max(e, Splat(0)));
      const Vector centre = { Splat(float(i - 1)), Splat(float(j - 1)), Splat(float(k - 1)) };
      const Vector p = field.Point(from) + Scale(centre, field.sides), m = field.Normal(from);
      const Floats points[3] = { p.x, p.y, p.z }, normals[3] = { m.x, m.y, m.z };
      for (int a = 0; a < 3; ++a)
      {
        hn::StoreU(points[a], floats, this->point[this->count][a]);
        hn::StoreU(normals[a], floats, this->normal[this->count][a]);
      }
      hn::StoreU(hn::IfThenElseZero(some, Splat(1.0F)), floats, this->there[this->count]);
      ++this->count;
    }
  }
  HWY_INLINE Vector Point(int n) const { return Read(this->point[n]); }
  HWY_INLINE Vector Normal(int n) const { return Read(this->normal[n]); }
  HWY_INLINE Floats There(int n) const { return hn::LoadU(floats, this->there[n]); }

private:
  static HWY_INLINE Vector Read(const float (&from)[3][Lanes])
  {
    return { hn::LoadU(floats, from[0]), hn::LoadU(floats, from[1]), hn::LoadU(floats, from[2]) };
  }
};

constexpr float DiscVoxels = 0.75F;  // elements lie less than a voxel apart: discs overlap
constexpr float KernelVoxels = 1.7F; // where a neighbour's weight falls to zero
constexpr float DoubtUnits = 0.25F;  // farther apart than this, both answers straddle an edge
constexpr float MostCurved = 0.3F;   // per unit: rounder is an edge

/// Moving least squares around the foot point f. The mean of an element's normal n_q and the local
/// one m, (n_q + m)/2 . (f - p_q), vanishes on all quadrics, so that averaging adds no curvature
/// bias; 1/12 of the curvature does: planes that cut off as much of a voxel as a curved surface lie
/// that much deeper, by the mean of its parabola over a cross-section of the voxel.
HWY_INLINE Fit Span(const Field& field, const Neighbours& near, const Vector& r, const Vector& start,
  Floats facing)
{
  Vector m = start, f = AddTimes(r, hn::Neg(facing), m);
  Floats distance = facing, curvature = Splat(0.0F);
  Mask fits = hn::Eq(facing, facing);
  const Vector shrink = Splat(1.0F / KernelVoxels) * field.perSide;
  for (int iteration = 0; iteration < 2; ++iteration)
  {
    Floats sum = Splat(0.0F), across = sum, squares = sum;
    Vector mean = None(), away = None();
    for (int n = 0; n < near.count; ++n)
    {
      const Vector v = f - near.Point(n), nq = near.Normal(n), scaled = Scale(v, shrink);
      const Floats u = hn::Max(Splat(0.0F), hn::Sub(Splat(1.0F), Dot(scaled, scaled)));
      const Floats w = hn::Mul(near.There(n), hn::Mul(u, hn::Mul(u, u)));
      sum = hn::Add(sum, w);
      mean = AddTimes(mean, w, nq);
      away = AddTimes(away, w, v);
      across = hn::MulAdd(w, Dot(nq, v), across);
      squares = hn::MulAdd(w, Dot(v, v), squares);
    }
    const Floats length = hn::Sqrt(Dot(mean, mean));
    fits = hn::And(fits, hn::Gt(length, hn::Mul(Splat(0.1F), sum)));
    m = Choose(fits, hn::Div(Splat(1.0F), hn::Max(length, Splat(1e-20F))) * mean, m);
    const Floats per = hn::Div(Splat(1.0F), hn::Max(sum, Splat(1e-20F)));
    const Floats along = Dot(m, away);
    const Floats residual = hn::Mul(Splat(0.5F), hn::Mul(per, hn::Add(across, along)));
    const Floats fitted = hn::Add(Dot(m, r - f), residual);
    distance = hn::IfThenElse(fits, fitted, facing);
    curvature = hn::Div(hn::Sub(along, across), hn::Max(squares, Splat(1e-20F)));
    f = AddTimes(r, hn::Neg(distance), m);
  }
  curvature = hn::IfThenElseZero(
    fits, hn::Min(hn::Max(curvature, Splat(-MostCurved)), Splat(MostCurved)));
  const Vector tangential = field.sides - Scale(field.sides, Scale(m, m));
  const Floats section = hn::Mul(Splat(1.0F / 24.0F), Dot(field.sides, tangential));
  distance = hn::Sub(distance, hn::Mul(curvature, section));
  return { AddTimes(r, hn::Neg(distance), m), m, curvature, distance };
}

/// The fit where it can be trusted, and the nearest element's disc elsewhere. r: from the centre of
/// the elements' voxel; `inside` decides the sign away from the surface.
HWY_INLINE Fit FitAt(const Field& field, const Voxels& at, const Vector& r, Mask inside)
{
  const Neighbours near(field, at);
  Vector v = None(), m = None();
  Floats least = Splat(1e30F);
  for (int n = 0; n < near.count; ++n)
  {
    const Vector to = r - near.Point(n);
    const Floats squared =
      hn::IfThenElse(hn::Gt(near.There(n), Splat(0.5F)), Dot(to, to), Splat(1e30F));
    const Mask nearer = hn::Lt(squared, least);
    least = hn::Min(squared, least);
    v = Choose(nearer, to, v);
    m = Choose(nearer, near.Normal(n), m);
  }
  const Floats facing = Dot(v, m);
  const Vector lateral = AddTimes(v, hn::Neg(facing), m), scaled = Scale(lateral, field.perSide);
  const Mask plane = hn::Gt(Dot(m, m), Splat(0.5F));
  const Floats voxels = hn::Sqrt(Dot(scaled, scaled));
  const Floats beyond = hn::Max(Splat(0.0F),
    hn::Sub(Splat(1.0F), hn::Div(hn::IfThenElseZero(plane, Splat(DiscVoxels)),
                           hn::Max(voxels, Splat(1e-6F)))));
  const Floats disc = hn::Sqrt(
    hn::MulAdd(hn::Mul(beyond, beyond), Dot(lateral, lateral), hn::Mul(facing, facing)));
  const Floats outward = hn::IfThenElse(inside, Splat(-1.0F), Splat(1.0F));
  const Floats sign =
    hn::IfThenElse(hn::And(plane, hn::Lt(disc, Splat(1.0F))), facing, outward);
  const Floats signedDisc = hn::CopySign(disc, sign);
  Fit fit = Span(field, near, r, m, facing);
  const Mask trusted = hn::And(
    plane, hn::Lt(hn::Abs(hn::Sub(fit.distance, signedDisc)), Splat(DoubtUnits)));
  fit.distance = hn::IfThenElse(trusted, fit.distance, signedDisc);
  fit.foot = Choose(trusted, fit.foot, r - v);
  fit.normal = Choose(trusted, fit.normal, m);
  fit.curvature = hn::IfThenElseZero(trusted, fit.curvature);
  return fit;
}

void Refine(const SurfaceElements& surface, const float* coverage, std::size_t first,
  std::size_t last, ElementLanes::Element* to)
{
  const Field field(surface, coverage);
  for (std::size_t n = first; n < last; n += Lanes)
  {
    const Ints element = ElementsFrom(n, last);
    const Voxels at = VoxelsOf(field, element);
    const Mask inside = hn::Ge(hn::GatherIndex(floats, coverage, at.voxel), Splat(0.5F));
    const Fit fit = FitAt(field, at, None(), inside);
    StoreElements(fit.foot, fit.curvature, fit.normal, CountFrom(n, last), to + n);
  }
}

/// Steps to the nearest set bit of eleven, from 0 to 10 with 5 in the middle; 15: there is none.
constexpr std::array<std::int32_t, 2048> NearestBits = []
{
  std::array<std::int32_t, 2048> nearest{};
  for (int bits = 0; bits < 2048; ++bits)
  {
    nearest[bits] = 15;
    for (int d = 0; d <= 5 && nearest[bits] == 15; ++d)
      if (bits >> (5 + d) & 1)
        nearest[bits] = 5 + d;
      else if (bits >> (5 - d) & 1)
        nearest[bits] = 5 - d;
  }
  return nearest;
}();

/// Exact nearest elements' voxels within Reach, one axis after the other. Rows without any are left
/// out of the next axis.
int ListNear(
  const SurfaceElements& surface, const ElementLanes::Bits& bits, float most, std::int32_t* list)
{
  constexpr int S = ElementLanes::Side, R = ElementLanes::Reach, N = S + 2 * R;
  float alongX[N][N][S], alongY[N][S][S];
  std::int32_t stepX[N][N][S], stepY[N][S][S];
  const Floats far = Splat(1e30F);
  const float sides[3] = { surface.sides.x * surface.sides.x, surface.sides.y * surface.sides.y,
    surface.sides.z * surface.sides.z };
  bool slice[N] = {};
  int count = 0;
  for (int z = 0; z < N; ++z)
  {
    for (int y = 0; y < N; ++y)
      slice[z] = slice[z] || bits.row[z][y];
    if (!slice[z])
      continue;
    for (int y = 0; y < N; ++y)
      for (int x = 0; x < S && bits.row[z][y]; x += Lanes)
      {
        const Ints window = hn::And(
          hn::Shr(Splat(std::int32_t(bits.row[z][y])), hn::Iota(ints, x)), Splat(2047));
        const Ints step = hn::GatherIndex(ints, NearestBits.data(), window);
        const Floats d = hn::ConvertTo(floats, hn::Sub(step, Splat(R)));
        const Floats squared = hn::Mul(Splat(sides[0]), hn::Mul(d, d));
        hn::StoreU(hn::IfThenElse(OfFloats(hn::Eq(step, Splat(15))), far, squared), floats,
          &alongX[z][y][x]);
        hn::StoreU(step, ints, &stepX[z][y][x]);
      }
    for (int y = 0; y < S; ++y)
      for (int x = 0; x < S; x += Lanes)
      {
        Floats least = far;
        Ints step = Splat(0);
        for (int d = 0; d <= 2 * R; ++d)
        {
          if (!bits.row[z][y + d])
            continue;
          const float away = sides[1] * float((d - R) * (d - R));
          const Floats squared = hn::Add(hn::LoadU(floats, &alongX[z][y + d][x]), Splat(away));
          const Ints to = hn::Or(hn::LoadU(ints, &stepX[z][y + d][x]), Splat(d << 4));
          const Mask nearer = hn::Lt(squared, least);
          least = hn::Min(least, squared);
          step = hn::IfThenElse(hn::RebindMask(ints, nearer), to, step);
        }
        hn::StoreU(least, floats, &alongY[z][y][x]);
        hn::StoreU(step, ints, &stepY[z][y][x]);
      }
  }
  for (int z = 0; z < S; ++z)
    for (int y = 0; y < S; ++y)
      for (int x = 0; x < S; x += Lanes)
      {
        Floats least = far;
        Ints step = Splat(0);
        for (int d = 0; d <= 2 * R; ++d)
        {
          if (!slice[z + d])
            continue;
          const float away = sides[2] * float((d - R) * (d - R));
          const Floats squared = hn::Add(hn::LoadU(floats, &alongY[z + d][y][x]), Splat(away));
          const Ints to = hn::Or(hn::LoadU(ints, &stepY[z + d][y][x]), Splat(d << 8));
          const Mask nearer = hn::Lt(squared, least);
          least = hn::Min(least, squared);
          step = hn::IfThenElse(hn::RebindMask(ints, nearer), to, step);
        }
        const Ints place = hn::Add(hn::Iota(ints, x), Splat(y << 4 | z << 8));
        const Ints packed = hn::Or(place, hn::ShiftLeft<12>(step));
        const Mask within = hn::Le(least, Splat(most * most));
        count += static_cast<int>(
          hn::CompressStore(packed, hn::RebindMask(ints, within), ints, list + count));
      }
  for (int n = 0; n < ElementLanes::Padding && count; ++n)
    list[count + n] = list[count - 1];
  return count;
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
    const Ints sx = hn::Add(x, dx), sy = hn::Add(y, dy), sz = hn::Add(z, dz);
    const Voxels at(field, sx, sy, sz, number(sx, sy, sz));
    const Vector steps = { hn::ConvertTo(floats, hn::Sub(x, sx)),
      hn::ConvertTo(floats, hn::Sub(y, sy)), hn::ConvertTo(floats, hn::Sub(z, sz)) };
    const Floats a = hn::GatherIndex(floats, coverage, number(x, y, z));
    const Fit fit = FitAt(field, at, Scale(steps, field.sides), hn::Ge(a, Splat(0.5F)));
    hn::StoreU(fit.distance, floats, distances + n);
  }
}

void FarRow(const SurfaceElements& surface, const ElementLanes::Element* refined, int y, int z,
  const std::uint32_t* seeds, float from, float* distances)
{
  const Field field(surface, nullptr);
  const Floats unit = Splat(float(surface.unit)), one = Splat(1.0F);
  const std::int32_t* place = &surface.places.data()->x;
  for (int x = 0; x < surface.dims.x; x += Lanes)
  {
    const int count = surface.dims.x - x < Lanes ? surface.dims.x - x : Lanes;
    float was[Lanes], now[Lanes];
    std::int32_t seed[Lanes];
    bool any = false;
    for (int n = 0; n < Lanes; ++n)
    {
      was[n] = distances[x + (n < count ? n : count - 1)];
      seed[n] = static_cast<std::int32_t>(seeds[x + (n < count ? n : count - 1)]);
      any = any || !(was[n] > -from && was[n] < from);
    }
    if (!any)
      continue;
    const Floats before = hn::LoadU(floats, was);
    const Ints e = hn::GatherIndex(ints, surface.at.data(), hn::LoadU(ints, seed));
    const Ints at = hn::ShiftLeft<2>(e), n = hn::ShiftLeft<3>(e);
    const Vector steps = {
      hn::ConvertTo(floats, hn::Sub(hn::Iota(ints, x), hn::GatherIndex(ints, place, at))),
      hn::ConvertTo(floats, hn::Sub(Splat(y), hn::GatherIndex(ints, place + 1, at))),
      hn::ConvertTo(floats, hn::Sub(Splat(z), hn::GatherIndex(ints, place + 2, at)))
    };
    const Vector p = { field.Component(refined, n, 0), field.Component(refined, n, 1),
      field.Component(refined, n, 2) };
    const Vector m = { field.Component(refined, n, 4), field.Component(refined, n, 5),
      field.Component(refined, n, 6) };
    const Floats curvature = field.Component(refined, n, 3);
    const Vector v = Scale(steps, field.sides) - p;
    const Floats facing = Dot(v, m);
    const Vector lateral = AddTimes(v, hn::Neg(facing), m), scaled = Scale(lateral, field.perSide);
    const Floats aside = Dot(lateral, lateral), voxels = Dot(scaled, scaled);
    // Within a voxel the parabola, seen from here; farther aside the way to the disc's rim.
    const Floats bent = hn::Max(hn::MulAdd(curvature, facing, one), Splat(0.25F));
    const Floats parabola = hn::Abs(hn::Add(
      facing, hn::Div(hn::Mul(Splat(0.5F), hn::Mul(curvature, aside)), bent)));
    const Floats rim = hn::IfThenElseZero(hn::Gt(Dot(m, m), Splat(0.5F)), Splat(DiscVoxels));
    const Floats beyond = hn::Max(Splat(0.0F),
      hn::Sub(one, hn::Div(rim, hn::Max(hn::Sqrt(voxels), Splat(1e-6F)))));
    const Floats disc = hn::Sqrt(
      hn::MulAdd(hn::Mul(beyond, beyond), aside, hn::Mul(facing, facing)));
    const Mask under = hn::And(hn::Lt(voxels, one), hn::Gt(rim, Splat(0.0F)));
    const Floats mm = hn::Mul(unit, hn::IfThenElse(under, parabola, disc));
    const Mask near = hn::Lt(hn::Abs(before), Splat(from));
    hn::StoreU(hn::IfThenElse(near, before, hn::CopySign(mm, before)), floats, now);
    for (int lane = 0; lane < count; ++lane)
      distances[x + lane] = now[lane];
  }
}

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
  float point[27][3][Lanes], normal[27][3][Lanes];
  float weight[27][Lanes]; ///< 0 where there is none
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
      const Floats weight = field.Component(field.surface.elements.data(), from, 7);
      hn::StoreU(hn::IfThenElseZero(some, weight), floats, this->weight[this->count]);
      ++this->count;
    }
  }
  HWY_INLINE Vector Point(int n) const { return Read(this->point[n]); }
  HWY_INLINE Vector Normal(int n) const { return Read(this->normal[n]); }
  HWY_INLINE Floats Weight(int n) const { return hn::LoadU(floats, this->weight[n]); }

private:
  static HWY_INLINE Vector Read(const float (&from)[3][Lanes])
  {
    return { hn::LoadU(floats, from[0]), hn::LoadU(floats, from[1]), hn::LoadU(floats, from[2]) };
  }
};

constexpr float DiscVoxels = 0.75F;  // elements lie less than a voxel apart: discs overlap
constexpr float KernelVoxels = 1.7F; // where a neighbour's weight falls to zero
constexpr float DoubtUnits = 0.25F;  // farther apart than this, both answers straddle an edge
constexpr float SmoothShare = 0.98F; // of normals added up: less, and they stand around an edge
constexpr float MostTilt = 0.2F;     // normals are not so wrong: steeper is an edge
constexpr float MostCurved = 0.3F;   // per unit: rounder is an edge

/// Moving least squares around the foot point f. The mean of an element's normal n_q and the local
/// one m, (n_q + m)/2 . (f - p_q), vanishes on all quadrics, so that averaging adds no curvature
/// bias; 1/12 of the curvature does: planes that cut off as much of a voxel as a curved surface lie
/// that much deeper, by the mean of its parabola over a cross-section of the voxel.
HWY_INLINE Fit Span(
  const Field& field, const Neighbours& near, const Vector& r, const Vector& start, Floats facing)
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
      const Floats w = hn::Mul(near.Weight(n), hn::Mul(u, hn::Mul(u, u)));
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
  curvature =
    hn::IfThenElseZero(fits, hn::Min(hn::Max(curvature, Splat(-MostCurved)), Splat(MostCurved)));
  const Vector tangential = field.sides - Scale(field.sides, Scale(m, m));
  const Floats section = hn::Mul(Splat(field.surface.section), Dot(field.sides, tangential));
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
      hn::IfThenElse(hn::Gt(near.Weight(n), Splat(0.0F)), Dot(to, to), Splat(1e30F));
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
    hn::Sub(Splat(1.0F),
      hn::Div(hn::IfThenElseZero(plane, Splat(DiscVoxels)), hn::Max(voxels, Splat(1e-6F)))));
  const Floats disc =
    hn::Sqrt(hn::MulAdd(hn::Mul(beyond, beyond), Dot(lateral, lateral), hn::Mul(facing, facing)));
  const Floats outward = hn::IfThenElse(inside, Splat(-1.0F), Splat(1.0F));
  const Floats signedDisc = hn::CopySign(disc, outward);
  Fit fit = Span(field, near, r, m, facing);
  const Mask trusted =
    hn::And(plane, hn::Lt(hn::Abs(hn::Sub(fit.distance, signedDisc)), Splat(DoubtUnits)));
  fit.distance = hn::IfThenElse(trusted, fit.distance, signedDisc);
  fit.foot = Choose(trusted, fit.foot, r - v);
  fit.normal = Choose(trusted, fit.normal, m);
  fit.curvature = hn::IfThenElseZero(trusted, fit.curvature);
  return fit;
}

/// Do normals around the normal m agree? Not around an edge. Those of a thin wall's other side do
/// not count.
HWY_INLINE Mask Agree(const Neighbours& near, const Vector& m)
{
  Vector sum = None();
  Floats count = Splat(0.0F);
  for (int n = 0; n < near.count; ++n)
  {
    const Vector nq = near.Normal(n);
    const Mask same =
      hn::And(hn::Gt(Dot(nq, m), Splat(-0.3F)), hn::Gt(near.Weight(n), Splat(0.0F)));
    const Floats one = hn::IfThenElseZero(same, Splat(1.0F));
    sum = AddTimes(sum, one, nq);
    count = hn::Add(count, one);
  }
  const Floats least = hn::Mul(Splat(SmoothShare), count);
  return hn::Gt(Dot(sum, sum), hn::Mul(least, least));
}

/// The slope of the elements' points against the normal m at f, by least squares, seen along the
/// mean of both normals: no quadric has any, but normals that are all wrong alike do.
HWY_INLINE Vector SlopeOf(
  const Field& field, const Neighbours& near, const Vector& f, const Vector& m)
{
  const Vector shrink = Splat(1.0F / KernelVoxels) * field.perSide;
  Floats sum = Splat(1e-20F), heights = Splat(0.0F), xx = heights, xy = heights, xz = heights,
         yy = heights, yz = heights, zz = heights;
  Vector away = None(), product = None();
  for (int n = 0; n < near.count; ++n)
  {
    const Vector v = near.Point(n) - f, scaled = Scale(v, shrink);
    const Floats u = hn::Max(Splat(0.0F), hn::Sub(Splat(1.0F), Dot(scaled, scaled)));
    const Floats w = hn::Mul(near.Weight(n), hn::Mul(u, u));
    const Floats up = Dot(v, m);
    const Floats height = hn::Mul(Splat(0.5F), hn::Add(up, Dot(v, near.Normal(n))));
    const Vector t = AddTimes(v, hn::Neg(up), m), wt = w * t;
    sum = hn::Add(sum, w);
    heights = hn::MulAdd(w, height, heights);
    away = away + wt;
    product = AddTimes(product, height, wt);
    xx = hn::MulAdd(wt.x, t.x, xx);
    xy = hn::MulAdd(wt.x, t.y, xy);
    xz = hn::MulAdd(wt.x, t.z, xz);
    yy = hn::MulAdd(wt.y, t.y, yy);
    yz = hn::MulAdd(wt.y, t.z, yz);
    zz = hn::MulAdd(wt.z, t.z, zz);
  }
  const Vector centre = hn::Div(Splat(1.0F), sum) * away;
  const Vector b = AddTimes(product, hn::Neg(heights), centre);
  // Across the normal the matrix has nothing: unit there. A little everywhere: lines of elements.
  const Floats trace = hn::Add(xx, hn::Add(yy, zz)), little = hn::Mul(Splat(0.02F), trace);
  const auto covariance = [&](Floats tt, Floats t, Floats c, Floats one, Floats other)
  { return hn::MulAdd(trace, hn::Mul(one, other), hn::Sub(tt, hn::Mul(t, c))); };
  xx = hn::Add(little, covariance(xx, away.x, centre.x, m.x, m.x));
  yy = hn::Add(little, covariance(yy, away.y, centre.y, m.y, m.y));
  zz = hn::Add(little, covariance(zz, away.z, centre.z, m.z, m.z));
  xy = covariance(xy, away.x, centre.y, m.x, m.y);
  xz = covariance(xz, away.x, centre.z, m.x, m.z);
  yz = covariance(yz, away.y, centre.z, m.y, m.z);
  const auto minor = [](Floats a, Floats d, Floats p, Floats q)
  { return hn::Sub(hn::Mul(a, d), hn::Mul(p, q)); };
  const Vector first = { minor(yy, zz, yz, yz), minor(xz, yz, xy, zz), minor(xy, yz, xz, yy) };
  const Vector second = { first.y, minor(xx, zz, xz, xz), minor(xy, xz, xx, yz) };
  const Vector third = { first.z, second.z, minor(xx, yy, xy, xy) };
  const Floats determinant = Dot({ xx, xy, xz }, first);
  const Mask solved = hn::Gt(determinant, Splat(1e-20F));
  const Floats per =
    hn::IfThenElseZero(solved, hn::Div(Splat(1.0F), hn::Max(determinant, Splat(1e-20F))));
  return per * Vector{ Dot(first, b), Dot(second, b), Dot(third, b) };
}

void Polish(const SurfaceElements& surface, const float* coverage, std::size_t first,
  std::size_t last, ElementLanes::Element* to)
{
  const Field field(surface, coverage);
  for (std::size_t n = first; n < last; n += Lanes)
  {
    const Ints element = ElementsFrom(n, last), from = hn::ShiftLeft<3>(element);
    const Voxels at = VoxelsOf(field, element);
    const Floats alpha = hn::GatherIndex(floats, coverage, at.voxel);
    const Vector was = field.Point(from), m = field.Normal(from);
    const Neighbours near(field, at);
    const Vector slope = SlopeOf(field, near, was, m);
    const Vector tilted = m - slope;
    const Mask better = hn::And(hn::And(Agree(near, m), hn::Gt(Dot(m, m), Splat(0.5F))),
      hn::And(hn::Lt(Dot(slope, slope), Splat(MostTilt * MostTilt)),
        hn::And(
          hn::Gt(alpha, Splat(ElementLanes::Least)), hn::Lt(alpha, Splat(ElementLanes::Most)))));
    const Vector normal =
      Choose(better, hn::Div(Splat(1.0F), hn::Sqrt(Dot(tilted, tilted))) * tilted, m);
    const Vector point = Choose(better, hn::Neg(PlaneDistance(field, normal, alpha)) * normal, was);
    StoreElements(point, Splat(0.0F), normal, field.Component(surface.elements.data(), from, 7),
      CountFrom(n, last), to + n);
  }
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
    StoreElements(fit.foot, fit.curvature, fit.normal, Splat(1.0F), CountFrom(n, last), to + n);
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
        const Ints window =
          hn::And(hn::Shr(Splat(std::int32_t(bits.row[z][y])), hn::Iota(ints, x)), Splat(2047));
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

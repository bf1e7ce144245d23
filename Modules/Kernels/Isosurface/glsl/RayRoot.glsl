// Where a ray meets the trilinear isosurface inside one cell. GLSL and C++ compile this same text
// (C++ through RayRoot.h), so what is drawn is what is tested.
//
// low, high  the 8 corner values minus the isovalue, x fastest: low = z 0, high = z 1. Inside is >= 0.
// a, b       entry and exit point of the ray, in cell coordinates [0,1]^3
// s          in [0,1]: the hit is at mix(a, b, s)
//
// Along a segment the trilinear polynomial is a cubic. Its Bernstein coefficients are the blossom of a
// and b: 8 trilinear values. All of one sign: no root, by convexity, without an epsilon. Else the cubic
// is split where its derivative vanishes, and safeguarded Newton runs in the first monotone piece whose
// ends differ in sign. Cost: 8 trilinear values, one square root, a few cubics. Any thread.

HASP_FUNCTION float HaspTrilinear(vec4 low, vec4 high, float x, float y, float z)
{
  // (1-t)a + tb, not a + t(b-a): neighbour cells then agree bit for bit on the face they share.
  vec4 c = low * (1.0f - z) + high * z;
  return ((1.0f - x) * c.x + x * c.y) * (1.0f - y) + ((1.0f - x) * c.z + x * c.w) * y;
}

HASP_FUNCTION vec3 HaspTrilinearGradient(vec4 low, vec4 high, vec3 t)
{
  vec4 c = low * (1.0f - t.z) + high * t.z;
  vec4 d = high - low;
  return vec3((1.0f - t.y) * (c.y - c.x) + t.y * (c.w - c.z),
    (1.0f - t.x) * (c.z - c.x) + t.x * (c.w - c.y),
    ((1.0f - t.x) * d.x + t.x * d.y) * (1.0f - t.y) + ((1.0f - t.x) * d.z + t.x * d.w) * t.y);
}

HASP_FUNCTION vec4 HaspRayBernstein(vec4 low, vec4 high, vec3 a, vec3 b)
{
  float b0 = HaspTrilinear(low, high, a.x, a.y, a.z);
  float b1 = HaspTrilinear(low, high, b.x, a.y, a.z) + HaspTrilinear(low, high, a.x, b.y, a.z) +
    HaspTrilinear(low, high, a.x, a.y, b.z);
  float b2 = HaspTrilinear(low, high, a.x, b.y, b.z) + HaspTrilinear(low, high, b.x, a.y, b.z) +
    HaspTrilinear(low, high, b.x, b.y, a.z);
  float b3 = HaspTrilinear(low, high, b.x, b.y, b.z);
  return vec4(b0, b1 * (1.0f / 3.0f), b2 * (1.0f / 3.0f), b3);
}

HASP_FUNCTION float HaspBernsteinValue(vec4 c, float s)
{
  float r = 1.0f - s;
  return r * r * (r * c.x + 3.0f * s * c.y) + s * s * (3.0f * r * c.z + s * c.w);
}

HASP_FUNCTION float HaspBernsteinSlope(vec4 c, float s)
{
  float r = 1.0f - s;
  return 3.0f * (r * r * (c.y - c.x) + 2.0f * r * s * (c.z - c.y) + s * s * (c.w - c.z));
}

// Root of a monotone piece [from, to] with the values there, which differ in sign. Newton from the secant's
// root, kept inside the shrinking bracket; a step below 1e-4 is the last, for the next would be its square.
HASP_FUNCTION float HaspMonotoneRoot(vec4 c, float from, float to, float valueFrom, float valueTo)
{
  bool insideAtFrom = valueFrom >= 0.0f;
  float s = from + (to - from) * (valueFrom / (valueFrom - valueTo));
  for (int i = 0; i < 24; ++i)
  {
    float value = HaspBernsteinValue(c, s);
    bool sameAsFrom = (value >= 0.0f) == insideAtFrom;
    from = sameAsFrom ? s : from;
    to = sameAsFrom ? to : s;
    float next = s - value / HaspBernsteinSlope(c, s);
    if (!(next >= from && next <= to)) // also when the slope is 0 or the step is not a number
      next = 0.5f * (from + to);
    float change = abs(next - s);
    s = next;
    if (change < 1e-4f)
      break;
  }
  return s;
}

// The smallest root of the cubic with Bernstein coefficients c in [0,1]; false if there is none, or if
// the coefficients are not finite.
HASP_FUNCTION bool HaspFirstRoot(vec4 c, HASP_OUT(float) s)
{
  s = 0.0f;
  bool inside = c.x >= 0.0f;
  if ((c.y >= 0.0f) == inside && (c.z >= 0.0f) == inside && (c.w >= 0.0f) == inside)
    return false;
  float largest = max(max(abs(c.x), abs(c.y)), max(abs(c.z), abs(c.w)));
  if (!(largest <= 3.4e38f)) // infinite corners: no polynomial
    return false;
  c = c * (1.0f / largest); // no square may over- or underflow

  // Roots of the derivative: quadratic A s^2 + B s + C, by the form that does not cancel.
  float d0 = c.y - c.x, d1 = c.z - c.y, d2 = c.w - c.z;
  float A = d0 - 2.0f * d1 + d2, B = d1 - d0, C = d0; // B is half the linear coefficient
  float discriminant = B * B - A * C;
  float first = 0.0f, second = 0.0f; // 0: no split there
  if (discriminant > 0.0f)
  {
    float q = -(B + (B < 0.0f ? -1.0f : 1.0f) * sqrt(discriminant));
    float s1 = q != 0.0f ? C / q : -1.0f;
    float s2 = A != 0.0f ? q / A : -1.0f;
    s1 = s1 > 0.0f && s1 < 1.0f ? s1 : 0.0f;
    s2 = s2 > 0.0f && s2 < 1.0f ? s2 : 0.0f;
    first = min(s1, s2);
    second = max(s1, s2);
  }

  // The first monotone piece whose ends differ in sign. No split: first, second are 0, their value c.x.
  float valueFirst = HaspBernsteinValue(c, first), valueSecond = HaspBernsteinValue(c, second);
  float from = 0.0f, to = 1.0f, valueFrom = c.x, valueTo = c.w;
  if (first > 0.0f && (valueFirst >= 0.0f) != inside)
  {
    to = first;
    valueTo = valueFirst;
  }
  else if (second > 0.0f && (valueSecond >= 0.0f) != inside)
  {
    from = first;
    valueFrom = valueFirst;
    to = second;
    valueTo = valueSecond;
  }
  else if ((c.w >= 0.0f) != inside)
  {
    from = second;
    valueFrom = valueSecond;
  }
  else
    return false;
  s = HaspMonotoneRoot(c, from, to, valueFrom, valueTo);
  return true;
}

// The roots of that cubic in (s,1], where s is a root, ascending: 0 to 2 of them. The linear factor is
// divided out, so s itself is not found again; what stays is a quadratic.
HASP_FUNCTION int HaspLaterRoots(vec4 c, float s, HASP_OUT(vec2) later)
{
  later = vec2(0.0f);
  // The cubic from s to 1 by de Casteljau; its first coefficient is 0, the others over u are these.
  float r = 1.0f - s;
  float yz = r * c.y + s * c.z, q1 = r * c.z + s * c.w;
  float q0 = 3.0f * (r * yz + s * q1), q2 = c.w;
  q1 = 1.5f * q1;
  bool inside = q0 >= 0.0f;
  if ((q1 >= 0.0f) == inside && (q2 >= 0.0f) == inside)
    return 0;
  float largest = max(max(abs(q0), abs(q1)), abs(q2));
  q0 /= largest;
  q1 /= largest;
  q2 /= largest;
  float A = q0 - 2.0f * q1 + q2, B = q1 - q0; // A u^2 + 2 B u + q0
  float discriminant = B * B - A * q0;
  if (!(discriminant >= 0.0f))
    return 0;
  float q = -(B + (B < 0.0f ? -1.0f : 1.0f) * sqrt(discriminant));
  float u1 = q != 0.0f ? q0 / q : -1.0f, u2 = A != 0.0f ? q / A : -1.0f;
  if ((q2 >= 0.0f) != inside) // one, which rounding may have put outside
  {
    bool first = abs(u1 - 0.5f) < abs(u2 - 0.5f);
    later.x = s + r * min(max(first ? u1 : u2, 0.0f), 1.0f);
    return 1;
  }
  if (!(min(u1, u2) > 0.0f && max(u1, u2) < 1.0f))
    return 0;
  later = vec2(s + r * min(u1, u2), s + r * max(u1, u2));
  return 2;
}

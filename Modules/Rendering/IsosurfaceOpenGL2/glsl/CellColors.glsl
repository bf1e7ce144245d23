// The colour of a cell at a point of it: of the scalars at its corners, or of its label.
#ifdef HASP_COLORS
flat in uvec4 colorLow; // RGBA of the corners, or places in the table as float bits
flat in uvec4 colorHigh;
#ifdef HASP_COLOR_TABLE
layout(std430, binding = 3) readonly buffer ColorTable
{
  uint colorTable[]; // the last is the colour of NaN
};
#endif

vec4 ScalarColor(vec3 t)
{
#ifdef HASP_COLOR_TABLE
  float place = HaspTrilinear(uintBitsToFloat(colorLow), uintBitsToFloat(colorHigh), t.x, t.y, t.z);
  int last = colorTable.length() - 1;
  int at = isnan(place) ? last : clamp(int(place * float(last)), 0, last - 1);
  return unpackUnorm4x8(colorTable[at]);
#else
  mat4 low = mat4(unpackUnorm4x8(colorLow.x), unpackUnorm4x8(colorLow.y),
    unpackUnorm4x8(colorLow.z), unpackUnorm4x8(colorLow.w));
  mat4 high = mat4(unpackUnorm4x8(colorHigh.x), unpackUnorm4x8(colorHigh.y),
    unpackUnorm4x8(colorHigh.z), unpackUnorm4x8(colorHigh.w));
  vec4 share = vec4((1.0 - t.x) * (1.0 - t.y), t.x * (1.0 - t.y), (1.0 - t.x) * t.y, t.x * t.y);
  return low * (share * (1.0 - t.z)) + high * (share * t.z);
#endif
}
#endif

#ifdef HASP_LABELS
flat in uvec2 label;
#endif

Material CellMaterial(vec3 t)
{
#ifdef HASP_LABELS
  if ((label.x & LabelColored) != 0u)
    return ColoredMaterial(unpackUnorm4x8(label.y));
#endif
#ifdef HASP_COLORS
  return ColoredMaterial(ScalarColor(t));
#else
  return PropertyMaterial();
#endif
}

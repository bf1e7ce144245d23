// What hardware selection asks for.
#ifdef HASP_SELECTION
uniform vec3 selectionColor;
uniform int selectionShift; // bits to drop from the cell id; -1: selectionColor

vec4 SelectionColor(uint id) // whether there is one says the actor pass
{
  id >>= uint(max(selectionShift, 0));
  return selectionShift < 0
    ? vec4(selectionColor, 1.0)
    : vec4(vec3(id & 255u, (id >> 8u) & 255u, (id >> 16u) & 255u) / 255.0, 1.0);
}
#endif

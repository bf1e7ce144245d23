#version 430 core
// Meets the pixel's ray with the trilinear polynomial of one cell; discards where they do not meet.
// Writes the depth of the hit. Shading is VTK's: ambient, diffuse, specular of the property, all lights.
//
// in   see vtkHaspClusteredCellVS.glsl
// in   indexToClip, indexToView, normalToView   columns in voxels; view coordinates in mm
// in   planes        clipping planes in index coordinates, kept where plane . (p, 1) >= 0; plane 0 is near
// out  fragOutput0   colour, or what hardware selection asks for
//Hasp::Defines
#define HASP_FUNCTION
#define HASP_OUT(T) out T
//Hasp::RayRoot

const int MaxLights = 8;
const int MaxPlanes = 7;

uniform mat4 indexToClip;
uniform mat4 indexToView;
uniform mat3 normalToView;
uniform vec4 eyeIndex;
uniform bool parallelProjection;
uniform int planeCount;
uniform vec4 planes[MaxPlanes];
uniform int lightCount;
uniform vec3 lightColor[MaxLights];
uniform vec3 lightPosition[MaxLights];    // view coordinates, mm
uniform vec3 lightDirection[MaxLights];   // unit, from the light to what it lights
uniform vec3 lightAttenuation[MaxLights]; // constant, linear, quadratic
uniform vec3 lightCone[MaxLights];        // least cosine, exponent of the fall-off, 1 if positional
uniform vec3 ambientColor;
uniform vec3 diffuseColor;
uniform vec3 specularColor;
uniform float specularPower;
uniform float opacity;
#ifdef HASP_SELECTION
uniform vec3 selectionColor;
uniform int selectionShift; // bits to drop from the cell id; -1: selectionColor
#endif

flat in vec4 low;
flat in vec4 high;
flat in vec4 cellClip;
flat in vec3 cellIndex;
flat in vec3 eyeInCell;
flat in int cellId;
in vec3 onRay;
out vec4 fragOutput0;

// Cells reach this far into their neighbours, so that no ray slips between two of them. In voxels.
const float Overlap = 1e-4;

// The part of the ray inside the cell and the clipping planes, as two points in cell coordinates.
bool ClipRay(out vec3 a, out vec3 b)
{
  vec3 direction = onRay * eyeIndex.w - eyeInCell;
  direction /= max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
  vec3 safe = mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12)));
  vec3 wall0 = (vec3(-Overlap) - onRay) / safe, wall1 = (vec3(1.0 + Overlap) - onRay) / safe;
  vec3 enter = min(wall0, wall1), leave = max(wall0, wall1);
  float t0 = max(max(enter.x, enter.y), enter.z), t1 = min(min(leave.x, leave.y), leave.z);
  for (int p = 0; p < planeCount; ++p)
  {
    float atRay = dot(planes[p], vec4(cellIndex + onRay, 1.0));
    float slope = dot(planes[p].xyz, direction);
    if (slope > 0.0)
      t0 = max(t0, -atRay / slope);
    else if (slope < 0.0)
      t1 = min(t1, -atRay / slope);
    else if (atRay < 0.0)
      return false;
  }
  a = onRay + t0 * direction;
  b = onRay + t1 * direction;
  return t0 <= t1;
}

vec3 Shade(vec3 position, vec3 normal)
{
  vec3 toEye = parallelProjection ? vec3(0.0, 0.0, 1.0) : normalize(-position);
  vec3 diffuse = vec3(0.0), specular = vec3(0.0);
  for (int n = 0; n < lightCount; ++n)
  {
    vec3 direction = lightDirection[n];
    float strength = 1.0;
    if (lightCone[n].z > 0.5)
    {
      vec3 way = position - lightPosition[n];
      float distance = length(way);
      direction = way / distance;
      strength = 1.0 / dot(lightAttenuation[n], vec3(1.0, distance, distance * distance));
      float cosine = dot(direction, lightDirection[n]);
      strength *= cosine < lightCone[n].x ? 0.0 : pow(max(cosine, 1e-6), lightCone[n].y);
    }
    float facing = max(0.0, dot(normal, -direction));
    diffuse += strength * facing * lightColor[n];
    if (facing > 0.0)
      specular += strength * lightColor[n] *
        pow(max(1e-6, dot(reflect(direction, normal), toEye)), specularPower);
  }
  return ambientColor + diffuse * diffuseColor + specular * specularColor;
}

void main()
{
  vec3 a, b;
  float s;
  if (!ClipRay(a, b) || !HaspFirstRoot(HaspRayBernstein(low, high, a, b), s))
    discard;
  vec3 hit = mix(a, b, s);
  vec2 clip = cellClip.zw + hit.x * indexToClip[0].zw + hit.y * indexToClip[1].zw +
    hit.z * indexToClip[2].zw;
  gl_FragDepth = 0.5 * (gl_DepthRange.diff * clip.x / clip.y + gl_DepthRange.near + gl_DepthRange.far);

#ifdef HASP_SELECTION
  uint id = uint(cellId + 1) >> uint(max(selectionShift, 0)); // VTK keeps 0 for "nothing here"
  fragOutput0 = selectionShift < 0
    ? vec4(selectionColor, 1.0)
    : vec4(vec3(id & 255u, (id >> 8u) & 255u, (id >> 16u) & 255u) / 255.0, 1.0);
#else
  vec3 position = (indexToView * vec4(cellIndex + hit, 1.0)).xyz;
  vec3 normal = normalize(normalToView * -HaspTrilinearGradient(low, high, hit));
  if (dot(normal, parallelProjection ? vec3(0.0, 0.0, 1.0) : -position) < 0.0)
    normal = -normal; // seen from inside
  fragOutput0 = vec4(Shade(position, normal), opacity);
#endif
}

// VTK's shading: ambient, diffuse, specular of the property, all lights.
//
// position, normal   view coordinates, mm; the normal is unit and faces the eye
#ifndef HASP_LIGHTS
#define HASP_LIGHTS 1
#endif

uniform bool parallelProjection;
#if HASP_LIGHTS > 0
uniform vec3 lightColor[HASP_LIGHTS];
uniform vec3 lightDirection[HASP_LIGHTS];   // unit, from the light to what it lights
#ifdef HASP_POSITIONAL_LIGHTS
uniform vec3 lightPosition[HASP_LIGHTS];    // view coordinates, mm
uniform vec3 lightAttenuation[HASP_LIGHTS]; // constant, linear, quadratic
uniform vec3 lightCone[HASP_LIGHTS];        // least cosine, exponent of the fall-off, 1 if positional
#endif
#endif
uniform vec3 ambientColor;
uniform vec3 diffuseColor;
uniform vec3 specularColor;
uniform float specularPower;
uniform float opacity;
uniform vec2 colorShares; // ambient and diffuse of a colour that takes the place of the property's

#ifdef HASP_TRACED_LIGHT
float firstLightShare = 1.0; // of the first light; less where something stands before it
#endif

struct Material
{
  vec3 ambient;
  vec3 diffuse;
  float opacity;
};

Material PropertyMaterial()
{
  return Material(ambientColor, diffuseColor, opacity);
}

Material ColoredMaterial(vec4 color)
{
  return Material(colorShares.x * color.rgb, colorShares.y * color.rgb, opacity * color.a);
}

// Unit and towards the eye: a surface seen from inside is lit from there.
vec3 FaceEye(vec3 position, vec3 normal)
{
  return dot(normal, parallelProjection ? vec3(0.0, 0.0, 1.0) : -position) < 0.0 ? -normal : normal;
}

vec4 Shade(vec3 position, vec3 normal, Material material)
{
  vec3 color = material.ambient;
#ifdef HASP_SPECULAR
  vec3 toEye = parallelProjection ? vec3(0.0, 0.0, 1.0) : normalize(-position);
#endif
#if HASP_LIGHTS > 0
  for (int n = 0; n < HASP_LIGHTS; ++n)
  {
    vec3 direction = lightDirection[n];
    vec3 light = lightColor[n];
#ifdef HASP_TRACED_LIGHT
    if (n == 0)
      light *= firstLightShare;
#endif
#ifdef HASP_POSITIONAL_LIGHTS
    if (lightCone[n].z > 0.5)
    {
      vec3 way = position - lightPosition[n];
      float distance = length(way);
      direction = way / distance;
      light /= dot(lightAttenuation[n], vec3(1.0, distance, distance * distance));
      float cosine = dot(direction, lightDirection[n]);
      light *= cosine < lightCone[n].x ? 0.0 : pow(max(cosine, 1e-6), lightCone[n].y);
    }
#endif
    float facing = max(0.0, dot(normal, -direction));
    color += facing * light * material.diffuse;
#ifdef HASP_SPECULAR
    float mirrored = max(1e-6, dot(reflect(direction, normal), toEye));
    color += facing > 0.0 ? light * specularColor * pow(mirrored, specularPower) : vec3(0.0);
#endif
  }
#endif
  return vec4(color, material.opacity);
}

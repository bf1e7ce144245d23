#version 430 core
// The box around a cluster's active cells, as the three faces that the eye may see: 18 vertices, in triangles.
// It is grown by a pixel and by what float arithmetic may be off, and moved towards the eye by some units of
// depth, so that all fragments of the cluster's cells, at all samples of a pixel, lie behind its faces.
// A box that reaches the near plane becomes a small rectangle on it, which shows whatever the depth buffer says.
//
// in   clusters, order, states   see vtkHaspClusterCommandsCS.glsl; a vertex's number is that of its entry,
//                                times 18, plus that of its place in the box
// out  cluster                   its number in states
#define HASP_FUNCTION
//Hasp::CellLayout
//Hasp::ClusterState

layout(std430, binding = 0) readonly buffer Clusters
{
  uint clusters[];
};
layout(std430, binding = 2) buffer States
{
  uint states[];
};
layout(std430, binding = 3) readonly buffer Order
{
  uint order[];
};
uniform mat4 indexToClip;
uniform vec4 eyeIndex;       // (eye, 1), or (minus the view direction, 0) if parallel
uniform vec3 voxelsPerPixel; // at clip w 1, a parallel projection's only w
uniform float roundingVoxels;
uniform vec2 viewport;       // pixels
uniform int firstCluster; // of the part, in states
uniform int viewer;

flat out uint cluster;

void main()
{
  uint inPart = order[uint(gl_VertexID) / 18u], vertex = uint(gl_VertexID) % 18u;
  uint header = inPart * HaspClusterWords;
  cluster = uint(firstCluster) + inPart;
  uint state = states[cluster];
  if ((HaspViewerBits(state, uint(viewer)) & HaspSeen) != 0u) // it is known
  {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside
    return;
  }
  vec3 origin = vec3(HaspClusterOrigin(uvec2(clusters[header + 22u], clusters[header + 23u])));
  vec3 first = origin + vec3(HaspFirstActive(state));
  vec3 last = origin + vec3(HaspLastActive(state)) + 1.0;
  vec3 middle = 0.5 * (first + last), size = 0.5 * (last - first);

  mat4 rows = transpose(indexToClip);
  float mostW = dot(rows[3], vec4(middle, 1.0)) + dot(abs(rows[3].xyz), size);
  size += voxelsPerPixel * max(mostW, 0.0) + roundingVoxels;
  vec4 nearPlane = rows[2] + rows[3];
  float nearest = dot(nearPlane, vec4(middle, 1.0)) - dot(abs(nearPlane.xyz), size);

  uint corner = vertex % 6u; // triangles 0 1 2 and 2 1 3
  corner = corner < 3u ? corner : (corner == 3u ? 2u : (corner == 4u ? 1u : 3u));
  vec2 onFace = vec2((corner & 1u) != 0u ? 1.0 : -1.0, (corner & 2u) != 0u ? 1.0 : -1.0);
  if (nearest < 1e-5 * max(mostW, 0.0)) // 3 pixels are sure to hold the middle of one
  {
    gl_Position = vec4(vertex < 6u ? onFace * 3.0 / viewport : vec2(2.0), -1.0, 1.0);
    return;
  }
  vec3 facing = eyeIndex.xyz - eyeIndex.w * middle;
  vec3 side = mix(vec3(-1.0), vec3(1.0), greaterThanEqual(facing, vec3(0.0)));
  uint axis = vertex / 6u;
  if (axis == 0u)
    side.yz = onFace;
  else if (axis == 1u)
    side.xz = onFace;
  else
    side.xy = onFace;
  gl_Position = indexToClip * vec4(middle + side * size, 1.0);
  gl_Position.z -= 2e-6 * gl_Position.w; // 16 units of a 24-bit depth buffer
}

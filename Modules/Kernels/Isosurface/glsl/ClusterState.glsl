// What occlusion culling knows of a cluster, in one word. GLSL and C++ compile this same text (C++ through
// ClusterCulling.h).
//
//   bits 0..8    first active cell in the cluster, x, y, z, 3 bits each
//   bits 9..17   last active cell, likewise
//   bits 18..31  two bits for each of HaspViewers viewers: its box was seen; its cells were drawn this frame

const uint HaspViewers = 7u;
const uint HaspSeen = 1u;
const uint HaspDrawn = 2u;

HASP_FUNCTION uint HaspPackBox(uvec3 first, uvec3 last)
{
  return first.x | (first.y << 3u) | (first.z << 6u) | (last.x << 9u) | (last.y << 12u) | (last.z << 15u);
}

HASP_FUNCTION uvec3 HaspFirstActive(uint state)
{
  return uvec3(state, state >> 3u, state >> 6u) & 7u;
}

HASP_FUNCTION uvec3 HaspLastActive(uint state)
{
  return uvec3(state >> 9u, state >> 12u, state >> 15u) & 7u;
}

HASP_FUNCTION uint HaspViewerBits(uint state, uint viewer)
{
  return (state >> (18u + 2u * viewer)) & 3u;
}

HASP_FUNCTION uint HaspWithViewerBits(uint state, uint viewer, uint bits)
{
  uint shift = 18u + 2u * viewer;
  return (state & ~(3u << shift)) | (bits << shift);
}

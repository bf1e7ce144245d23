#version 430 core
// Writes the draw command of each cluster of a range: no cells for those that are not to be drawn.
//
// in   clusters     packed as CellLayout.glsl says, of one part
// in   order        entries of the range, and some before: clusters, counted from the first one of their part
// both states       of the part's clusters, and some before, as ClusterState.glsl says
// out  commands     DrawArraysIndirectCommand of each entry in order: count, instances, first, base
// early: those seen in the last frame, and the frame begins. late: those seen and not drawn yet.
#define HASP_FUNCTION
//Hasp::CellLayout
//Hasp::ClusterState

layout(local_size_x = 128) in;
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
layout(std430, binding = 4) writeonly buffer Commands
{
  uvec4 commands[];
};
uniform int firstEntry;
uniform int entryCount;
uniform int firstCluster; // of the part, in states
uniform int verticesPerCell;
uniform int viewer;
uniform bool late;
uniform bool keep; // early: what was seen stays so, and its boxes are not tested again

void main()
{
  if (gl_GlobalInvocationID.x >= uint(entryCount))
    return;
  uint entry = uint(firstEntry) + gl_GlobalInvocationID.x;
  uint inPart = order[entry], cluster = uint(firstCluster) + inPart;
  uint state = states[cluster], bits = HaspViewerBits(state, uint(viewer));
  bool drawn = late ? bits == HaspSeen : (bits & HaspSeen) != 0u;
  if (!late)
    states[cluster] = HaspWithViewerBits(state, uint(viewer), drawn ? HaspDrawn | (keep ? HaspSeen : 0u) : 0u);
  uint cells = 0u;
  if (drawn)
    for (uint word = 0u; word < 16u; word += 2u)
    {
      uint at = inPart * HaspClusterWords + word;
      cells += HaspCountBits(uvec2(clusters[at], clusters[at + 1u]));
    }
  uint vertices = uint(verticesPerCell);
  commands[entry] = uvec4(cells * vertices, drawn ? 1u : 0u, inPart * 512u * vertices, 0u);
}

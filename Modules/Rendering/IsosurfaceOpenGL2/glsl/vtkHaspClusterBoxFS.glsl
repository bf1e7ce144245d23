#version 430 core
// Notes that a cluster's box is not hidden. Depth is tested before and nothing else is written.
//
// in   cluster   its number in states
// both states    see ClusterState.glsl; all fragments of a cluster write the same
#define HASP_FUNCTION
//Hasp::ClusterState

layout(early_fragment_tests) in;
layout(std430, binding = 2) buffer States
{
  uint states[];
};
uniform int viewer;

flat in uint cluster;

void main()
{
  uint state = states[cluster], bits = HaspViewerBits(state, uint(viewer));
  if ((bits & HaspSeen) == 0u)
    states[cluster] = HaspWithViewerBits(state, uint(viewer), bits | HaspSeen);
}

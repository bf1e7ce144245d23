// From index coordinates to the screen. One frame for all cells, as uniforms; with labels, each cell has the
// frame of its label's pose, from a buffer, and EnterFrame makes it the current one.
//
// indexToClip, indexToView, normalToView   columns in voxels; view coordinates in mm
// eyeIndex   (eye, 1), or (minus the view direction, 0) if parallel
// planes     near plane, then clipping planes, in index coordinates: plane . (p, 1) >= 0 is kept
#ifndef HASP_PLANES
#define HASP_PLANES 1 // with the near plane
#endif

#ifdef HASP_LABELS
struct CellFrame
{
  mat4 indexToClip;
  mat4 clipToIndex;
  mat4 indexToView;
  mat4 normalToView;
  vec4 eyeIndex;
  vec4 planes[HASP_PLANES];
};
layout(std430, binding = 6) readonly buffer CellFrames
{
  CellFrame cellFrames[];
};
mat4 indexToClip;
mat4 clipToIndex;
mat4 indexToView;
mat3 normalToView;
vec4 eyeIndex;
vec4 planes[HASP_PLANES];

// What is said of a label: the number of its frame in the low bits, 65536 at most, and these two; RGBA.
const uint LabelHidden = 0x80000000u, LabelColored = 0x40000000u, LabelFrame = 0x1FFFFu;

void EnterFrame(uvec2 label)
{
  uint frame = label.x & LabelFrame;
  indexToClip = cellFrames[frame].indexToClip;
  clipToIndex = cellFrames[frame].clipToIndex;
  indexToView = cellFrames[frame].indexToView;
  normalToView = mat3(cellFrames[frame].normalToView);
  eyeIndex = cellFrames[frame].eyeIndex;
  planes = cellFrames[frame].planes;
}
#else
uniform mat4 indexToClip;
uniform mat4 clipToIndex;
uniform mat4 indexToView;
uniform mat3 normalToView;
uniform vec4 eyeIndex;
uniform vec4 planes[HASP_PLANES];
#endif

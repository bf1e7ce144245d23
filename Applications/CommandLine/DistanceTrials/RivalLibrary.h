#pragma once
#include "RivalTransform.h"

/// What is in libHaspDistanceRivals.so, which is loaded when the first rival is asked for: ITK and
/// OpenVDB have half of all symbols that a program which links them looks up when it starts, and
/// one report needs them. It is never unloaded.
namespace hasp
{

RivalTransform MakeMaurerRival();
RivalTransform MakeFogRival();
RivalTransform MakeMeshRival(int bandVoxels);

/// The names under which it is asked for them; both sides hold to these types.
constexpr const char* MaurerRivalSymbol = "HaspMaurerRival";
constexpr const char* FogRivalSymbol = "HaspFogRival";
constexpr const char* MeshRivalSymbol = "HaspMeshRival";
using FillRival = void(RivalTransform& rival, int bandVoxels); ///< that is for meshes alone

} // namespace hasp

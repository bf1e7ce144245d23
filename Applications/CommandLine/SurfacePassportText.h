#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hasp
{

struct MeshCheck;
struct SurfacePassport;

/// What is known of a surface and what was found of its mesh, a line a fact. No text of the file is
/// in a passport.
std::string SurfacePassportText(const SurfacePassport& passport, const MeshCheck& mesh);
nlohmann::ordered_json SurfacePassportJson(const SurfacePassport& passport, const MeshCheck& mesh);

} // namespace hasp

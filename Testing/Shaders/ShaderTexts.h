#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

/// The project's shaders as they are compiled, found and put together without OpenGL. Any thread.
namespace hasp
{

/// Slot name to text: //Hasp::RayRoot is filled with the .glsl file of the stem RayRoot.
using ShaderSlots = std::map<std::string, std::string>;

/// Names to values; a switch has none.
using ShaderDefines = std::map<std::string, std::string>;

/// The stages of one program: the files whose names differ in the last two letters alone.
struct ShaderProgram
{
  std::string name{};                          ///< vtkHaspClusteredCell
  std::map<std::string, std::string> stages{}; ///< "VS", "FS", "GS", "CS" to text, slots filled
  /// What some stage asks #ifdef HASP_… for.
  std::set<std::string> switches{};
  /// What some stage gives a default (#ifndef HASP_…, #define HASP_… 1), and other values to try:
  /// 8, and 0 where it asks whether the count is > 0.
  std::map<std::string, std::vector<std::string>> counts{};
};

struct ShaderTexts
{
  std::vector<ShaderProgram> programs{};
  ShaderSlots parts{}; ///< files that are no stage: what fills slots
};

/// Every .glsl file under `root`. //Hasp::Defines is a slot that stays empty.
/// Throws std::runtime_error if `root` is no folder, if two parts have one name, if a slot names no
/// part, or if a stage does not begin with #version.
ShaderTexts ReadShaderTexts(const std::filesystem::path& root);

/// `text` with a #define for each of `defines` after its #version line.
std::string WithDefines(const std::string& text, const ShaderDefines& defines);

/// Every subset of up to six switches; of more: none, each alone, and all. Then each other value of
/// each count, with no switch and with all.
std::vector<ShaderDefines> ListVariants(const ShaderProgram& program);

} // namespace hasp

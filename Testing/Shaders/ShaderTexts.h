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

/// The stages of one program: the files whose names differ in the last two letters alone.
struct ShaderProgram
{
  std::string name{};                          ///< vtkHaspClusteredCell
  std::map<std::string, std::string> stages{}; ///< "VS", "FS", "GS", "CS" to text, slots filled
  std::set<std::string> defines{};             ///< every HASP_… that some stage asks #ifdef for
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

/// `text` with "#define X" for each of `defines` after its #version line.
std::string WithDefines(const std::string& text, const std::set<std::string>& defines);

/// All subsets of up to four defines; of more: none, each alone, and all.
std::vector<std::set<std::string>> ListVariants(const std::set<std::string>& defines);

} // namespace hasp

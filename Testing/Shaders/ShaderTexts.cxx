#include "ShaderTexts.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

std::string ReadText(const fs::path& file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::string StageOf(const std::string& stem)
{
  const std::string end = stem.size() > 2 ? stem.substr(stem.size() - 2) : "";
  return end == "VS" || end == "FS" || end == "GS" || end == "CS" ? end : "";
}

std::string FillSlots(const std::string& name, const std::string& text, const ShaderSlots& parts)
{
  static const std::regex slot("^//Hasp::(\\w+)\\s*$");
  std::istringstream lines(text);
  std::string filled, line;
  while (std::getline(lines, line))
  {
    std::smatch match;
    if (!std::regex_match(line, match, slot))
      filled += line + "\n";
    else if (const auto part = parts.find(match[1]); part != parts.end())
      filled += FillSlots(part->first, part->second, parts);
    else if (match[1] != "Defines")
      throw std::runtime_error(name + ": no file is called " + match[1].str() + ".glsl");
  }
  return filled;
}

void FindDefines(const std::string& text, ShaderProgram& program)
{
  static const std::regex asked(
    "#\\s*(?:ifdef|ifndef)\\s+(HASP_\\w+)|defined\\s*\\(?\\s*(HASP_\\w+)");
  for (std::sregex_iterator m(text.begin(), text.end(), asked), end; m != end; ++m)
  {
    const std::string name = (*m)[1].matched ? (*m)[1] : (*m)[2];
    if (!std::regex_search(text, std::regex("#ifndef " + name + "\\s+#define " + name + " \\d")))
      program.switches.insert(name);
    else if (std::regex_search(text, std::regex("#if " + name + " > 0")))
      program.counts[name] = { "0", "8" };
    else
      program.counts[name] = { "8" };
  }
}

} // namespace

ShaderTexts ReadShaderTexts(const fs::path& root)
{
  if (!fs::is_directory(root))
    throw std::runtime_error("no such folder: " + root.string());
  ShaderTexts result;
  std::map<std::string, std::string> stages; // stem to text
  for (const auto& entry : fs::recursive_directory_iterator(root))
  {
    if (entry.path().extension() != ".glsl")
      continue;
    const std::string stem = entry.path().stem().string();
    auto& kind = StageOf(stem).empty() ? result.parts : stages;
    if (!kind.emplace(stem, ReadText(entry.path())).second)
      throw std::runtime_error("two shader files are called " + stem + ".glsl");
  }
  std::map<std::string, ShaderProgram> programs;
  for (const auto& [stem, text] : stages)
  {
    if (!text.starts_with("#version"))
      throw std::runtime_error(stem + ": the first line is not #version");
    const std::string name = stem.substr(0, stem.size() - 2);
    ShaderProgram& program = programs[name];
    program.name = name;
    const std::string filled = FillSlots(stem, text, result.parts);
    program.stages[StageOf(stem)] = filled;
    FindDefines(filled, program);
  }
  for (auto& [name, program] : programs)
    result.programs.push_back(std::move(program));
  return result;
}

std::string WithDefines(const std::string& text, const ShaderDefines& defines)
{
  std::string lines;
  for (const auto& [name, value] : defines)
    lines += "#define " + name + " " + value + "\n";
  const std::size_t at = text.find('\n') + 1;
  return text.substr(0, at) + lines + text.substr(at);
}

std::vector<ShaderDefines> ListVariants(const ShaderProgram& program)
{
  const std::vector<std::string> names(program.switches.begin(), program.switches.end());
  ShaderDefines all;
  for (const std::string& name : names)
    all[name] = "";
  std::vector<ShaderDefines> variants;
  if (names.size() <= 6)
  {
    for (unsigned bits = 0; bits < 1u << names.size(); ++bits)
    {
      ShaderDefines& variant = variants.emplace_back();
      for (std::size_t n = 0; n < names.size(); ++n)
        if (bits >> n & 1u)
          variant[names[n]] = "";
    }
  }
  else
  {
    variants = { {}, all };
    for (const std::string& name : names)
      variants.push_back({ { name, "" } });
  }
  for (const auto& [name, values] : program.counts)
    for (const std::string& value : values)
      for (ShaderDefines variant : { ShaderDefines(), all })
      {
        variant[name] = value;
        variants.push_back(variant);
      }
  return variants;
}

} // namespace hasp

#include "ShaderTexts.h"

#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>

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
  constexpr std::string_view slot = "//Hasp::";
  std::istringstream lines(text);
  std::string filled, line;
  while (std::getline(lines, line))
  {
    if (!line.starts_with(slot))
    {
      filled += line + "\n";
      continue;
    }
    std::string part;
    std::istringstream(line.substr(slot.size())) >> part;
    if (const auto found = parts.find(part); found != parts.end())
      filled += FillSlots(found->first, found->second, parts);
    else if (part != "Defines")
      throw std::runtime_error(name + ": no file is called " + part + ".glsl");
  }
  return filled;
}

/// The words of a text, with every sign that cannot stand in a name as a space, but for #.
std::vector<std::string> SplitWords(std::string text)
{
  for (char& c : text)
    if (c != '#' && c != '_' && !std::isalnum(static_cast<unsigned char>(c)))
      c = ' ';
  std::istringstream in(text);
  return { std::istream_iterator<std::string>(in), {} };
}

void FindDefines(const std::string& text, ShaderProgram& program)
{
  const std::vector<std::string> words = SplitWords(text);
  for (std::size_t w = 1; w < words.size(); ++w)
  {
    const std::string& ask = words[w - 1];
    const std::string& name = words[w];
    if (!name.starts_with("HASP_") || (ask != "#ifdef" && ask != "#ifndef" && ask != "defined"))
      continue;
    const bool hasDefault = ask == "#ifndef" && w + 3 < words.size() && words[w + 1] == "#define" &&
                            words[w + 2] == name && std::isdigit(words[w + 3][0]);
    if (!hasDefault)
      program.switches.insert(name);
    else if (text.find("#if " + name + " > 0") != std::string::npos)
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
  {
    for (const auto& [count, values] : program.counts)
      program.switches.erase(count); // another stage asks for it without a default
    result.programs.push_back(std::move(program));
  }
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
